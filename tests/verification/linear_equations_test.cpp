// SPDX-License-Identifier: BSD-3-Clause
//
// A coarse and a fine mesh of shells whose common edge is joined by linear equations: coinciding nodes are
// equal, nodes in the middle of an edge follow it (*CONSTRAINED_LINEAR_GLOBAL, *CONSTRAINED_ADAPTIVITY).

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/conservation.hpp"
#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::linear_equations_test {
namespace {

using test::Point;

/// 10 x 20 with two elements beside 10 x 20 with twice as many along both edges.
model::Model joined_meshes() {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1, 2));
  std::get<model::Elastic>(model.materials[0].law).poissons_ratio = 0;
  const Index coarse = test::add_grid(model, 0, 1, 2, [](double u, double v) {
    return Point{10 * u, 20 * v, 0};
  });
  const Index fine = test::add_grid(model, 0, 2, 4, [](double u, double v) {
    return Point{10 + 10 * u, 20 * v, 0};
  });
  for (Index row = 0; row <= 4; ++row)
    for (int component = 0; component < 6; ++component) {
      model::LinearEquation equation{row + 1, {{fine + 3 * row, component, 1}}};
      const Index below = coarse + 2 * (row / 2) + 1;
      if (row % 2 == 0) {
        equation.terms.push_back({below, component, -1});
      } else {
        equation.terms.push_back({below, component, -0.5});
        equation.terms.push_back({below + 2, component, -0.5});
      }
      model.linear_equations.push_back(equation);
    }
  return model;
}

TEST(LinearEquations, StressIsConstantAcrossAnEdgeWithHangingNodes) {
  model::Model model = joined_meshes();
  const double rate = 1e-2;
  model.curves.push_back({1, {0, 1e9}, {1, 1}});
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    model.initial_velocities.push_back({.node = i, .velocity = {rate * x[0], 0, 0}, .angular_velocity = {}});
    if (x[0] < 1e-9) model.fixed_nodes.push_back({.node = i, .translation = {true, true, true}});
    if (x[0] > 20 - 1e-9)
      model.prescribed_motions.push_back({.node = i, .axis = 0, .curve = 0, .scale = rate * x[0]});
  }
  model.control.end_time = 0.05;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double exact = 210 * std::log1p(rate * domain.clock.time);
  double error = 0;
  for (const domain::ShellBlock& block : domain.shells) {
    const domain::StateItem& stress = *block.find("stress");
    for (Index e = 0; e < block.elements; ++e)
      error = test::larger_of(error, std::fabs(block.state(e, stress.first) / exact - 1));
  }
  test::verified("coarse and fine shells joined by equations, stretched: error of the stress", "exact")
      .below(error, 1e-10);
}

TEST(LinearEquations, MomentaAndEnergyAreKept) {
  model::Model model = joined_meshes();
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back(
        {.node = i,
         .velocity = {0.1 * std::sin(7.0 * i), 0.1 * std::cos(5.0 * i), 0.1 * std::sin(3.0 * i)},
         .angular_velocity = {0.01 * std::cos(2.0 * i), 0.01 * std::sin(4.0 * i), 0}});
  model.control.end_time = 0.1;
  const test::Conservation kept = test::watched_run(model);
  test::verified("coarse and fine shells joined by equations, shaken: momentum, change", "conservation")
      .below(kept.momentum_drift, 1e-12);
  EXPECT_LT(kept.turning_drift, 1e-12);
  test::verified("coarse and fine shells joined by equations, shaken: energy error", "conservation")
      .below(kept.worst_imbalance, 1e-2);
}

}  // namespace
}  // namespace crumple::linear_equations_test
