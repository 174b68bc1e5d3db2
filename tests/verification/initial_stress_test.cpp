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

using math::Vec3;
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

/// A model that begins where a run is: places, velocities, thicknesses and stresses in global axes.
model::Model begun_from(const model::Model& first, const domain::Domain& now) {
  model::Model model = first;
  model.initial_velocities.clear();
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const Index at = now.nodes.domain_node[static_cast<std::size_t>(node)];
    const Vec3& x = now.nodes.position[at];
    const Vec3& v = now.nodes.velocity[at];
    const Vec3& w = now.nodes.angular_velocity[at];
    model.nodes.position[static_cast<std::size_t>(node)] = {x.x, x.y, x.z};
    model.initial_velocities.push_back(
        {.node = node, .velocity = {v.x, v.y, v.z}, .angular_velocity = {w.x, w.y, w.z}});
  }
  return model;
}

/// A block of hexahedra that is squeezed and sheared, and yields.
model::Model squeezed_block(double end_time) {
  model::Model model = test::one_solid_part(test::mild_steel());
  test::add_box(model, 0, 3, 2, 2, [](double u, double v, double w) {
    return test::Point{30 * u, 20 * v + 2 * u * w, 20 * w};
  });
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const auto& x = model.nodes.position[static_cast<std::size_t>(node)];
    model.initial_velocities.push_back(
        {.node = node, .velocity = {-2 * x[0], 0.5 * x[1], 10 * x[0] * x[2] / 600}, .angular_velocity = {}});
  }
  model.control.end_time = end_time;
  return model;
}

/// Stresses and plastic strain of each solid, in the order of the model.
std::vector<model::InitialPointStress> points_of(const domain::SolidBlock& block) {
  std::vector<model::InitialPointStress> points(static_cast<std::size_t>(block.elements));
  for (Index e = 0; e < block.elements; ++e) {
    model::InitialPointStress& point = points[static_cast<std::size_t>(block.element[e])];
    for (Index k = 0; k < 6; ++k) point.stress[static_cast<std::size_t>(k)] = block.state(e, k);
    point.plastic_strain = block.state(e, block.find("plastic_strain")->first);
  }
  return points;
}

struct Difference {
  double stress = 0;   ///< largest over the largest stress
  double plastic = 0;  ///< likewise of the plastic strains
};
Difference difference(const std::vector<model::InitialPointStress>& a,
                      const std::vector<model::InitialPointStress>& b) {
  double largest = 0;
  double strain = 0;
  Difference most;
  for (std::size_t e = 0; e < a.size(); ++e) {
    for (std::size_t k = 0; k < 6; ++k) {
      largest = test::larger_of(largest, std::fabs(a[e].stress[k]));
      most.stress = test::larger_of(most.stress, std::fabs(a[e].stress[k] - b[e].stress[k]));
    }
    strain = test::larger_of(strain, a[e].plastic_strain);
    most.plastic = test::larger_of(most.plastic, std::fabs(a[e].plastic_strain - b[e].plastic_strain));
  }
  return {most.stress / largest, most.plastic / strain};
}

// A block that yields, taken up from its places, velocities and stresses, begins with the same stresses.
TEST(InitialStress, ABlockThatYieldsBeginsWithItsStresses) {
  const model::Model first = squeezed_block(0.006);
  timeloop::Simulation half(first, test::execution());
  test::run(half);
  const auto stopped = points_of(half.domain().solids[0]);
  model::Model second = begun_from(first, half.domain());
  for (std::size_t e = 0; e < stopped.size(); ++e)
    second.solid_stresses.push_back({.element = static_cast<Index>(e), .planes = 1, .points = {stopped[e]}});
  timeloop::Simulation again(second, test::execution());
  again.start();
  const Difference begun = difference(stopped, points_of(again.domain().solids[0]));
  test::verified("block that yields, begun again: stresses over the largest, difference", "stopped run")
      .below(begun.stress, 1e-14);
  test::verified("block that yields, begun again: plastic strains over the largest, difference",
                 "stopped run")
      .below(begun.plastic, 1e-14);
}

}  // namespace
}  // namespace crumple::initial_stress_test
