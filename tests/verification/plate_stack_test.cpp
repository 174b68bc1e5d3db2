// SPDX-License-Identifier: BSD-3-Clause
//
// Ten free plates of shells fall on a fixed one, all turned against each other, so that no meshes match.
// Exact: the energy is kept, no mid-surface goes through another, each plate stays above the one below it,
// and at rest the fixed plate bears the weight of all.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "support/conservation.hpp"
#include "support/shapes.hpp"
#include "support/verified.hpp"

namespace crumple::plate_stack_test {
namespace {

constexpr Index plates = 10;
constexpr double thickness = 1.5;
constexpr double side = 60;
constexpr double gap = 1.0;
constexpr Index cells = 6;
constexpr Index nodes_of_plate = (cells + 1) * (cells + 1);

/// mm, ms, kg. The fixed plate comes first, then the others from below.
model::Model stack(double speed, double gravity, double damping) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(thickness, 3));
  for (Index plate = 0; plate <= plates; ++plate) {
    const Index part = plate == 0 ? 0 : test::add_shell_part(model);
    const double angle = 0.3 * plate;
    const double size = plate == 0 ? 1.5 * side : side;
    test::add_grid(model, part, cells, cells, [&](double u, double v) {
      const double x = size * (u - 0.5);
      const double y = size * (v - 0.5);
      return test::Point{x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle),
                         (thickness + gap) * plate};
    });
    if (plate == 0) test::hold(model, 0, model.nodes.count());
  }
  test::set_moving(model, nodes_of_plate, {0, 0, -speed});
  if (gravity > 0) {
    model.curves.push_back({1, {0, 1e6}, {gravity, gravity}});
    model.body_loads.push_back({.axis = 2, .curve = 0});
  }
  test::touch_all(model).viscous_damping = damping;
  return model;
}

/// Heights of the middles of all plates, from below.
std::array<double, plates + 1> heights(const domain::Domain& domain) {
  std::array<double, plates + 1> found{};
  for (Index plate = 0; plate <= plates; ++plate)
    found[plate] =
        domain.nodes.position[domain.nodes.domain_node[nodes_of_plate * plate + nodes_of_plate / 2]].z;
  return found;
}

double closest(const domain::Domain& domain) {
  const auto z = heights(domain);
  double least = z[1] - z[0];
  for (std::size_t plate = 1; plate < plates; ++plate) least = std::min(least, z[plate + 1] - z[plate]);
  return least;
}

double force_on_fixed(const domain::Domain& domain) {
  double force = 0;
  for (Index i = 0; i < nodes_of_plate; ++i) force -= domain.contact_force[domain.nodes.domain_node[i]].z;
  return force;
}

TEST(PlateStack, FallsAndReboundsWithoutLossOfEnergy) {
  model::Model model = stack(3, 0, 0);
  model.control.end_time = 8;
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  Index cuts = 0;
  double least = 1e9;
  double left = -1e9;  // energy of contact when last no plates touched
  test::Conservation kept;
  test::run(simulation, [&](const domain::Domain& now) {
    kept.watch(now);
    least = std::min(least, closest(now));
    const domain::ContactReport& contact = now.contacts[0];
    if (contact.active_pairs == 0 && contact.worst_penetration > 0) left = contact.energy;
    if (now.clock.cycle % 50 != 0) return;
    simulation.inspect_contacts();
    cuts += now.contacts[0].inspection.intersections + now.contacts[0].inspection.nodes_beyond;
  });
  std::printf(
      "closest middles / thickness %.3f, deepest / thickness %.3f, imbalance of energy %.1e of the initial "
      "one, "
      "%.1e of the absorbed one, contact energy left %.3f\n",
      least / thickness, domain.contacts[0].worst_penetration / thickness, kept.worst_imbalance,
      domain.energy.error(), left / domain.energy.initial_total);
  EXPECT_EQ(cuts, 0);
  EXPECT_GT(least, 0.97 * thickness);
  EXPECT_GT(domain.contacts[0].worst_penetration, 0) << "they must have met";
  test::verified("ten plates fall: energy error", "conservation").below(domain.energy.error(), 1e-5);
  EXPECT_GT(test::momentum(domain).z, 0) << "they have rebounded";
  // Without damping the contact gives all back but for what begins and ends within steps of what the springs
  // of many plates do together, 0.1 % with a ninth of the step.
  EXPECT_GT(left, -0.01 * domain.energy.initial_total);
  EXPECT_LT(left, 0.03 * domain.energy.initial_total);
}

TEST(PlateStackSlow, ComesToRestUnderItsWeight) {
  constexpr double gravity = 1;
  model::Model model = stack(1, gravity, 0.3);
  model.control.end_time = 20;
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  double impulse = 0;
  double time = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    if (now.clock.time < 0.8 * model.control.end_time) return;
    impulse += force_on_fixed(now) * now.clock.step;
    time += now.clock.step;
  });
  simulation.inspect_contacts();
  const double weight = plates * side * side * thickness * 7.85e-6 * gravity;
  const double top = heights(domain)[plates];
  std::printf(
      "force / weight %.4f, height / 10 thicknesses %.4f, closest / thickness %.4f, kinetic energy %.1e, "
      "energy %.1e\n",
      impulse / time / weight, top / (plates * thickness), closest(domain) / thickness,
      domain.energy.kinetic / domain.energy.initial_total, domain.energy.error());
  test::verified("ten plates at rest: force on the lowest over the weight", "equilibrium")
      .near(impulse / (weight * time), 1, 0.01);
  test::verified("ten plates at rest: height over ten thicknesses", "exact")
      .near(top / (plates * thickness), 1, 1e-3);
  EXPECT_GT(closest(domain), 0.999 * thickness);
  EXPECT_EQ(domain.contacts[0].inspection.intersections, 0);
  EXPECT_LT(domain.energy.kinetic, 1e-3 * domain.energy.initial_total);
  EXPECT_LT(domain.energy.error(), 1e-5);
}

}  // namespace
}  // namespace crumple::plate_stack_test
