// SPDX-License-Identifier: BSD-3-Clause
#include "app/measurement/shell_benchmark.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "elements/registry.hpp"
#include "materials/common/shell_material.hpp"

namespace crumple::app {

namespace {

constexpr double edge = 5.0;
constexpr double yielding_share = 0.2;
constexpr double strain_per_cycle = 2e-5;
constexpr double elastic_strain_per_cycle = 2e-8;
constexpr double yield_strain = 250.0 / 210000;
static_assert(cycles_to_yield * strain_per_cycle > 1.5 * yield_strain);

/// A sheet of n^2 shells: four-node ones in as many rows as columns, or pairs of triangles in half the rows.
model::Model sheet(const ShellBenchmark& benchmark) {
  const Index n = benchmark.side;
  const bool triangles = model::is_triangular(benchmark.formulation);
  const Index rows = triangles ? n / 2 : n;
  model::Model model;
  const auto add = [&](std::array<Index, 4> node) {
    model.shells.push_back({.id = static_cast<UserId>(model.shells.size()) + 1, .part = 0, .node = node});
  };
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= n; ++i) {
      model.nodes.id.push_back(model.nodes.count() + 1);
      model.nodes.position.push_back({edge * i, edge * j, 2 * std::sin(0.25 * i) + std::cos(0.2 * j)});
    }
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index first = j * (n + 1) + i;
      const std::array<Index, 4> corner{first, first + 1, first + n + 2, first + n + 1};
      if (!triangles) {
        add(corner);
        continue;
      }
      add({corner[0], corner[1], corner[2], corner[2]});
      add({corner[0], corner[2], corner[3], corner[3]});
    }
  model::ShellSection section;
  section.formulation = benchmark.formulation;
  section.thickness_points = benchmark.thickness_points;
  section.thickness = {1.5, 1.5, 1.5, 1.5};
  model.shell_sections.push_back(section);
  model.materials.push_back({.id = 1, .title = "", .density = 7.85e-9, .law = benchmark.law});
  model.parts.push_back({.id = 1, .title = "", .section = 0, .material = 0});
  model.control.end_time = 1;
  model.control.step_scale = 1e-4;
  return model;
}

/// Stretches the fifth with the smallest x.
void set_in_motion(model::Model& model, Index side) {
  constexpr double wave_speed = 5.4e6;
  const double per_cycle = wave_speed / (edge * model.control.step_scale);
  const double border = yielding_share * edge * side;
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const std::array<double, 3>& x = model.nodes.position[i];
    const double stretched =
        strain_per_cycle * std::min(x[0], border) + elastic_strain_per_cycle * std::max(x[0] - border, 0.0);
    const double bend = 1e-4 * per_cycle * strain_per_cycle;
    model.initial_velocities.push_back({.node = i,
                                        .velocity = {per_cycle * stretched, 0, bend * std::sin(x[0])},
                                        .angular_velocity = {0, bend * std::cos(x[1]), 0}});
  }
}

/// Constants of steel for whichever of these a law has.
template <class Law>
Law steel() {
  Law law;
  if constexpr (requires { law.youngs_modulus; }) law.youngs_modulus = 210000;
  if constexpr (requires { law.poissons_ratio; }) law.poissons_ratio = 0.3;
  if constexpr (requires { law.yield_stress = 250.0; }) law.yield_stress = 250;
  if constexpr (requires { law.tangent_modulus; }) law.tangent_modulus = 2100;
  if constexpr (requires { law.isotropic_fraction; }) law.isotropic_fraction = 1;
  if constexpr (requires { law.hardening = 300.0; }) law.hardening = 300;
  if constexpr (requires { law.exponent = 0.2; }) law.exponent = 0.2;
  if constexpr (requires { law.strength = law.yield_strain; }) {
    law.strength = 960;  // 250 at the yield strain
    law.yield_strain = yield_strain;
  }
  if constexpr (requires { law.plastic_strain.size(); }) {
    law.plastic_strain = {0, 0.002, 0.01, 0.03, 0.1};
    law.yield_stress = {250, 260, 280, 300, 320};
  }
  if constexpr (requires { law.tension_strain.size(); }) {
    law.compression_strain = law.tension_strain = {0, 0.01, 0.1};
    law.compression_stress = {280, 310, 350};
    law.tension_stress = {250, 280, 320};
    law.tension_pressure = law.compression_pressure = 50;
  }
  return law;
}

template <class... Laws>
std::vector<NamedLaw> all_laws(const std::variant<Laws...>& /*any*/) {
  std::vector<NamedLaw> laws;
  for (const model::ConstitutiveLaw& law : {model::ConstitutiveLaw(steel<Laws>())...})
    if (materials::shell_material_kind(law) >= 0) laws.push_back({materials::shell_material_name(law), law});
  return laws;
}

std::string option_name(std::string name) {
  for (char& c : name) c = c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

}  // namespace

std::vector<NamedLaw> benchmark_laws() {
  std::vector<NamedLaw> laws = all_laws(model::ConstitutiveLaw());
  for (NamedLaw& law : laws) law.name = option_name(law.name);
  return laws;
}

std::vector<NamedFormulation> benchmark_formulations() {
  using model::ShellFormulation;
  std::vector<NamedFormulation> found;
  for (const ShellFormulation formulation :
       {ShellFormulation::BelytschkoTsay, ShellFormulation::BelytschkoWongChiang, ShellFormulation::HughesLiu,
        ShellFormulation::HughesLiuSelectiveReduced, ShellFormulation::FullyIntegrated,
        ShellFormulation::Triangle, ShellFormulation::Membrane, ShellFormulation::FullyIntegratedMembrane,
        ShellFormulation::MembraneTriangle}) {
    const elements::ShellKind kind = elements::shell_kind(formulation);
    if (kind.kind >= 0) found.push_back({option_name(kind.name), formulation});
  }
  return found;
}

model::Model shell_benchmark_model(const ShellBenchmark& benchmark) {
  model::Model model = sheet(benchmark);
  set_in_motion(model, benchmark.side);
  return model;
}

CycleTimes measure_shells(const ShellBenchmark& benchmark, double seconds) {
  return measure_cycles(shell_benchmark_model(benchmark), benchmark.execution, seconds);
}

}  // namespace crumple::app
