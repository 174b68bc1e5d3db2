// SPDX-License-Identifier: BSD-3-Clause
#include "app/measurement/solid_benchmark.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace crumple::app {

namespace {

constexpr double edge = 5.0;  // mm; with N and s
constexpr double step_scale = 1e-4;
constexpr double wave_speed = 6.0e6;
constexpr double yielding_share = 0.2;
constexpr double strain_per_cycle = 2e-5;
constexpr double elastic_strain_per_cycle = 2e-8;

void add_solids(model::Model& model, const std::array<Index, 8>& node, bool tetrahedra) {
  const auto add = [&](const std::array<Index, 8>& corners) {
    model.solids.push_back({.id = static_cast<UserId>(model.solids.size()) + 1, .part = 0, .node = corners});
  };
  if (!tetrahedra) {
    add(node);
    return;
  }
  // Around the diagonal, as seen from its first end.
  constexpr std::array<std::size_t, 7> ring{1, 2, 3, 7, 4, 5, 1};
  for (std::size_t k = 0; k < 6; ++k) {
    const Index third = node[ring[k + 1]];
    add({node[0], node[ring[k]], third, third, node[6], node[6], node[6], node[6]});
  }
}

void add_mesh(model::Model& model, Index n, bool tetrahedra) {
  for (Index k = 0; k <= n; ++k)
    for (Index j = 0; j <= n; ++j)
      for (Index i = 0; i <= n; ++i) {
        model.nodes.id.push_back(model.nodes.count() + 1);
        model.nodes.position.push_back(
            {edge * i + 0.5 * std::sin(j), edge * j + 0.5 * std::sin(k), edge * k + 0.5 * std::sin(i)});
      }
  const Index row = n + 1;
  const Index layer = row * row;
  for (Index k = 0; k < n; ++k)
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i) {
        const Index low = k * layer + j * row + i;
        const Index high = low + layer;
        add_solids(model,
                   {low, low + 1, low + row + 1, low + row, high, high + 1, high + row + 1, high + row},
                   tetrahedra);
      }
}

}  // namespace

std::vector<NamedSolid> benchmark_solids() {
  using enum model::SolidFormulation;
  using enum model::SolidHourglassForm;
  return {{"one-point-hexahedron-ihq-2", OnePointHexahedron, FlanaganBelytschkoViscous},
          {"one-point-hexahedron-ihq-5", OnePointHexahedron, ExactVolumeStiffness},
          {"one-point-hexahedron-ihq-6", OnePointHexahedron, AssumedStrain},
          {"selective-hexahedron", SelectiveHexahedron},
          {"assumed-strain-hexahedron", AssumedStrainHexahedron},
          {"tetrahedron", Tetrahedron},
          {"nodal-pressure-tetrahedron", NodalPressureTetrahedron}};
}

model::Model solid_benchmark_model(const SolidBenchmark& benchmark) {
  model::Model model;
  add_mesh(model, benchmark.side, model::is_tetrahedral(benchmark.solid.formulation));
  model::SolidSection section;
  section.formulation = benchmark.solid.formulation;
  model.solid_sections.push_back(section);
  model.control.hourglass.solid_form = benchmark.solid.form;
  model.materials.push_back({.id = 1,
                             .title = "",
                             .density = 7.85e-9,
                             .law = model::PlasticKinematic{210000, 0.3, 250, 2100, 1, 0, 0, 0}});
  model.parts.push_back({.id = 1, .title = "", .solid_section = 0, .material = 0});
  model.control.end_time = 1;
  model.control.step_scale = step_scale;
  const double per_cycle = wave_speed / (edge * step_scale);
  const double border = yielding_share * edge * benchmark.side;
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const double x = model.nodes.position[i][0];
    const double stretched =
        strain_per_cycle * std::min(x, border) + elastic_strain_per_cycle * std::max(x - border, 0.0);
    model.initial_velocities.push_back(
        {.node = i,
         .velocity = {per_cycle * stretched, 0, 1e-4 * per_cycle * strain_per_cycle * std::sin(x)}});
  }
  return model;
}

CycleTimes measure_solids(const SolidBenchmark& benchmark, double seconds) {
  return measure_cycles(solid_benchmark_model(benchmark), benchmark.execution, seconds);
}

}  // namespace crumple::app
