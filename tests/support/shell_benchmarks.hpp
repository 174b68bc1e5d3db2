// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Two curved shells of R.H. MacNeal & R.L. Harder, A proposed standard set of problems to test finite element
// accuracy, Finite Elements in Analysis and Design 1 (1985) 3-20; units as there. Parts by symmetry; the
// first load of the model is the one along which the displacement is asked for.

#include <cmath>
#include <numbers>

#include "support/meshes.hpp"

namespace crumple::test {

struct ShellBenchmark {
  model::Model model;
  double accepted = 0;  ///< displacement of the first loaded node along its load [length]
};

/// Holds a node in a plane of symmetry across `axis` (0, 1, 2).
inline void add_symmetry(model::Model& model, Index node, std::size_t axis) {
  model::FixedNode fixed;
  fixed.node = node;
  for (std::size_t k = 0; k < 3; ++k) (k == axis ? fixed.translation : fixed.rotation)[k] = true;
  model.fixed_nodes.push_back(fixed);
}

/// Pinched cylinder: R = 300, length 600, t = 3, rigid diaphragms at the ends, two opposite forces of 1 at
/// the middle. An eighth, n x n elements. Deflection under the load 1.8248e-5.
inline ShellBenchmark pinched_cylinder(model::ShellFormulation formulation, Index n) {
  ShellBenchmark benchmark;
  benchmark.accepted = 1.8248e-5;
  model::Model& model = benchmark.model;
  model = one_part({.id = 1, .title = "cylinder", .density = 1e-3, .law = model::Elastic{3e6, 0.3}},
                   shell_section(3, 2, formulation));
  add_grid(model, 0, n, n, [](double u, double v) {
    const double angle = 0.5 * std::numbers::pi * u;
    return Point{300 * std::sin(angle), 300 * v, 300 * std::cos(angle)};
  });
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) {
      const Index node = j * (n + 1) + i;
      if (i == 0) add_symmetry(model, node, 0);
      if (j == 0) add_symmetry(model, node, 1);
      if (i == n) add_symmetry(model, node, 2);
      if (j == n)
        model.fixed_nodes.push_back(
            {.node = node, .translation = {true, false, true}, .rotation = {false, true, false}});
    }
  model.nodal_loads.push_back({.node = 0, .force = {0, 0, -0.25}});
  return benchmark;
}

/// Hemisphere with a hole of 18 degrees: R = 10, t = 0.04, pulled and pushed at the equator by four
/// alternating forces of 2. A quarter, n x n elements. Displacement at the loads 0.094; `load` scales the
/// forces, and the displacement with them as long as that is small.
inline ShellBenchmark hemisphere(model::ShellFormulation formulation, Index n, double load = 1) {
  ShellBenchmark benchmark;
  benchmark.accepted = 0.094 * load;
  model::Model& model = benchmark.model;
  model = one_part({.id = 1, .title = "hemisphere", .density = 1, .law = model::Elastic{6.825e7, 0.3}},
                   shell_section(0.04, 2, formulation));
  add_grid(model, 0, n, n, [](double u, double v) {
    const double east = 0.5 * std::numbers::pi * u;
    const double north = 0.4 * std::numbers::pi * v;
    return Point{10 * std::cos(north) * std::cos(east), 10 * std::cos(north) * std::sin(east),
                 10 * std::sin(north)};
  });
  for (Index j = 0; j <= n; ++j) {
    add_symmetry(model, j * (n + 1), 1);
    add_symmetry(model, j * (n + 1) + n, 0);
  }
  model.fixed_nodes.push_back({.node = 0, .translation = {false, false, true}, .rotation = {}});
  model.nodal_loads.push_back({.node = 0, .force = {load, 0, 0}});
  model.nodal_loads.push_back({.node = n, .force = {0, -load, 0}});
  return benchmark;
}

}  // namespace crumple::test
