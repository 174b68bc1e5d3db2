// SPDX-License-Identifier: BSD-3-Clause
//
// Runs that begin with a stress.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::initial_stress_test {
namespace {

using model::ShellFormulation;

struct Form {
  ShellFormulation formulation;
  const char* name;
};

// A strip of membrane with the tension s between two supports swings as a string: w = pi / L sqrt(s / rho),
// with masses at n nodes 2 n / L sqrt(s / rho) sin(pi / (2 n)).
TEST(InitialStress, AStripInTensionSwingsAsAString) {
  constexpr double length = 100;
  constexpr double density = 7.85e-6;
  constexpr double stress = 0.2;
  constexpr Index columns = 20;
  for (const Form& form : {Form{ShellFormulation::Membrane, "ELFORM 5"},
                           Form{ShellFormulation::FullyIntegratedMembrane, "ELFORM 9"}}) {
    model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.5, 1, form.formulation));
    test::add_grid(model, 0, columns, 1, [](double u, double v) {
      return test::Point{length * u, 5 * v, 0};
    });
    const double omega =
        2.0 * columns / length * std::sqrt(stress / density) * std::sin(0.5 * std::numbers::pi / columns);
    for (Index node = 0; node < model.nodes.count(); ++node) {
      const double x = model.nodes.position[static_cast<std::size_t>(node)][0];
      if (x < 1e-9 || x > length - 1e-9)
        model.fixed_nodes.push_back({.node = node, .translation = {true, true, true}, .rotation = {}});
      // So small that the strain by the deflection is nothing beside that of the tension.
      model.initial_velocities.push_back(
          {.node = node,
           .velocity = {0, 0, 1e-3 * omega * std::sin(std::numbers::pi * x / length)},
           .angular_velocity = {}});
    }
    for (std::size_t i = 0; i < model.shells.size(); ++i) {
      model::InitialPointStress point;
      point.stress[0] = stress;
      model.shell_stresses.push_back({.element = static_cast<Index>(i), .planes = 1, .points = {point}});
    }
    model.control.end_time = 2.2 * 2 * std::numbers::pi / omega;
    timeloop::Simulation simulation(model, test::execution());
    double before = 0;
    double time_before = 0;
    double crossing = 0;
    int crossings = 0;
    double imbalance = 0;
    test::run(simulation, [&](const domain::Domain& now) {
      const double z = test::displacement(now, columns / 2).z;
      if (before < 0 && z >= 0 && now.clock.cycle > 2) {
        crossing = time_before + (now.clock.time - time_before) * before / (before - z);
        ++crossings;
      }
      before = z;
      time_before = now.clock.time;
      imbalance = test::larger_of(imbalance, std::fabs(now.energy.imbalance()) / now.energy.initial_total);
    });
    EXPECT_EQ(crossings, 2);
    test::verified(std::string("strip in tension, ") + form.name + ": period of two swings",
                   "string of 20 masses")
        .within(0.5 * crossing, 2 * std::numbers::pi / omega, 1e-3);
    test::verified(std::string("strip in tension, ") + form.name + ": energy balance, error", "none")
        .below(imbalance, 1e-3);
  }
}

}  // namespace
}  // namespace crumple::initial_stress_test
