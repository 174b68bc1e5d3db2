// SPDX-License-Identifier: BSD-3-Clause
// Supports and prescribed motions along axes that are not the global ones, against the same model in global
// axes and against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "math/rotation.hpp"
#include "math/to_vec3.hpp"
#include "support/imbalance.hpp"
#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/rigid.hpp"
#include "support/verified.hpp"

namespace crumple::local_axes_test {
namespace {

using math::Vec3;

/// A rotation about (1, 2, 3) by no particular angle.
math::Matrix3 tilt() {
  return math::matrix_of(math::cayley_rotation({0.11, 0.22, 0.33}));
}

std::array<double, 3> components(const Vec3& a) {
  return {a.x, a.y, a.z};
}

/// A block on three planes of symmetry, pulled at its end, all of it turned.
model::Model block(const math::Matrix3& axes, bool by_local_axes) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  test::add_box(model, 0, 6, 2, 2, [&](double u, double v, double w) {
    return components(axes * Vec3{30 * u, 10 * v, 10 * w});
  });
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const bool on[3] = {node % 7 == 0, node / 7 % 3 == 0, node / 21 == 0};
    const std::array<bool, 3> held = {on[0], on[1], on[2]};
    const model::LocalSupport support{
        .node = node,
        .axes = {components(axes.column[0]), components(axes.column[1]), components(axes.column[2])},
        .translation = held,
        .rotation = {}};
    if (!on[0] && !on[1] && !on[2]) continue;
    if (by_local_axes)
      model.local_supports.push_back(support);
    else
      model.fixed_nodes.push_back({.node = node, .translation = held, .rotation = {}});
  }
  for (Index node = 6; node < model.nodes.count(); node += 7)
    model.nodal_loads.push_back({.node = node, .force = components(axes * Vec3{2, 0.3, -0.2})});
  model.output.of(model::HistoryFile::Spcforc).asked = true;
  model.control.end_time = 0.02;
  return model;
}

TEST(LocalSupports, ATurnedBlockMovesAsTheOneInGlobalAxes) {
  const math::Matrix3 axes = tilt();
  const model::Model straight = block(math::unit_matrix(), false);
  const model::Model turned = block(axes, true);
  timeloop::Simulation first(straight, test::execution());
  timeloop::Simulation second(turned, test::execution());
  test::run(first);
  test::run(second);
  double largest = 0;
  double error = 0;
  for (Index node = 0; node < straight.nodes.count(); ++node) {
    const Vec3 expected = test::displacement(first.domain(), node);
    const Vec3 found = math::transposed_product(axes, test::displacement(second.domain(), node));
    largest = test::larger_of(largest, norm(expected));
    error = test::larger_of(error, norm(found - expected));
  }
  test::verified("block on turned supports: displacement, error over the largest", "the block in global axes")
      .below(error / largest, 1e-11);
  const domain::EnergyLedger& energy = first.domain().energy;
  const double external = second.domain().energy.external_work - energy.external_work;
  const double unbalanced = second.domain().energy.imbalance() - energy.imbalance();
  test::verified("block on turned supports: external work, error over itself", "the block in global axes")
      .below(std::fabs(external) / energy.external_work, 1e-11);
  test::verified("block on turned supports: imbalance beside that of the block in global axes, over the work",
                 "conservation")
      .below(std::fabs(unbalanced) / energy.external_work, 1e-11);
  ASSERT_EQ(first.domain().supports.size(), second.domain().supports.size());
  Vec3 reaction;
  Vec3 turned_reaction;
  for (const domain::SupportReport& support : first.domain().supports) reaction += support.force;
  for (const domain::SupportReport& support : second.domain().supports) turned_reaction += support.force;
  test::verified("block on turned supports: reaction, error over the reaction", "the block in global axes")
      .below(norm(math::transposed_product(axes, turned_reaction) - reaction) / norm(reaction), 1e-9);
}

/// A mass on a spring far softer than what happens here, for the step.
model::Model lone_mass() {
  model::Model model = test::one_spring_part(model::LinearSpring{1e-12});
  const Index node = test::add_mass(model, {0, 0, 0}, 2.0);
  model.discretes.push_back({.id = 1, .part = 0, .node = {node, node}, .grounded = true, .axis = {1, 0, 0}});
  model.initial_velocities.push_back({.node = node, .velocity = {3, -1, 2}});
  model.curves.push_back({1, {0, 1e6}, {0.01, 0.01}});
  model.control.step_curve = 0;
  model.control.end_time = 1;
  return model;
}

const Vec3 along = normalised(Vec3{1, 2, 2});

TEST(LocalMotions, AlongAVectorLeavesTheRestFreeUnlessHeld) {
  for (const bool holds_plane : {false, true}) {
    model::Model model = lone_mass();
    const Index curve = test::add_constant_curve(model, 5);
    model::PrescribedMotion motion{.node = 0, .curve = curve, .scale = 0.5};
    motion.direction = components(along);
    motion.holds_plane = holds_plane;
    model.prescribed_motions.push_back(motion);
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    const domain::Domain& domain = simulation.domain();
    const Vec3 start{3, -1, 2};
    const Vec3 across = holds_plane ? Vec3{} : start - dot(start, along) * along;
    EXPECT_LT(norm(domain.nodes.velocity[0] - (2.5 * along + across)), 1e-10);
    // The work of the jump is the change of the kinetic energy, half of it when the step after shows it.
    const double change = 0.5 * 2.0 * (dot(across, across) + 2.5 * 2.5 - dot(start, start));
    EXPECT_NEAR(domain.energy.external_work, change, 1e-10);
    EXPECT_NEAR(domain.energy.imbalance(), 0, 1e-10);
  }
}

TEST(LocalMotions, ObliqueDirectionsAreMetTogether) {
  model::Model model = lone_mass();
  // Along x, along a direction at 60 degrees to it, and held along the global z.
  const Vec3 oblique{0.5, std::sqrt(0.75), 0};
  for (const Vec3& direction : {Vec3{1, 0, 0}, oblique}) {
    model::PrescribedMotion motion{.node = 0, .curve = test::add_constant_curve(model, 1)};
    motion.direction = components(direction);
    model.prescribed_motions.push_back(motion);
  }
  model.fixed_nodes.push_back({.node = 0, .translation = {false, false, true}, .rotation = {}});
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const Vec3 v = simulation.domain().nodes.velocity[0];
  EXPECT_NEAR(v.x, 1, 1e-12);
  EXPECT_NEAR(dot(v, oblique), 1, 1e-12);
  EXPECT_NEAR(v.z, 0, 1e-15);
}

/// Adds the curve c(t) = t.
Index add_line(model::Model& model) {
  model.curves.push_back({static_cast<UserId>(model.curves.size() + 1), {0, 1e6}, {0, 1e6}});
  return static_cast<Index>(model.curves.size() - 1);
}

/// A mass at the origin that goes round the axis along y through (0.5, 0, -0.5).
model::PrescribedMotion round_motion(model::Model& model, model::PrescribedMotion::Kind kind) {
  using Kind = model::PrescribedMotion::Kind;
  model::PrescribedMotion motion{.node = 0, .axis = 1, .kind = kind};
  motion.curve = kind == Kind::Displacement ? add_line(model) : test::add_constant_curve(model, 1);
  motion.goes_round = true;
  motion.centre = {0.5, 7, -0.5};
  return motion;
}

TEST(LocalMotions, RoundAnAxisKeepTheCircle) {
  using Kind = model::PrescribedMotion::Kind;
  for (const Kind kind : {Kind::Displacement, Kind::Velocity, Kind::Acceleration}) {
    model::Model model = lone_mass();
    model::PrescribedMotion motion = round_motion(model, kind);
    motion.scale = 2;
    model.prescribed_motions.push_back(motion);
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    const domain::Domain& domain = simulation.domain();
    const double time = domain.clock.time;
    // Of the velocity (3, -1, 2) the arm (-0.5, 0, 0.5) makes the angular velocity 5.
    const double angle = kind == Kind::Acceleration ? 5 * time + time * time : 2 * time;
    const Vec3 expected{0.5 - 0.5 * std::cos(angle) + 0.5 * std::sin(angle), -time,
                        -0.5 + 0.5 * std::cos(angle) + 0.5 * std::sin(angle)};
    test::verified("mass that is led round an axis, " + std::to_string(static_cast<int>(kind)) +
                       ": error of its place over the radius",
                   "exact")
        .below(norm(domain.nodes.position[0] - expected) / std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(domain.energy.imbalance(), 0, 1e-10 * domain.energy.initial_total);
  }
}

/// Where the radius is free the mass moves along the turning ray as in a tube: r'' = w^2 r.
TEST(LocalMotions, RoundAnAxisMayLeaveTheRadiusFree) {
  model::Model model = lone_mass();
  model.initial_velocities.clear();
  model::PrescribedMotion motion = round_motion(model, model::PrescribedMotion::Kind::Velocity);
  motion.keeps_radius = false;
  model.prescribed_motions.push_back(motion);
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const Vec3 arm = domain.nodes.position[0] - Vec3{0.5, 0, -0.5};
  const double time = domain.clock.time;
  test::verified("mass in a tube that turns: error of its distance from the axis", "r cosh(w t)")
      .below(std::fabs(norm(arm) / (std::sqrt(0.5) * std::cosh(time)) - 1), 0.01 * 0.01);
  EXPECT_NEAR(std::atan2(arm.x + arm.z, arm.z - arm.x), time, 1e-10);
  EXPECT_NEAR(domain.energy.imbalance(), 0, 1e-10 * domain.energy.external_work);
}

TEST(LocalSupports, HoldFromBirthToDeath) {
  model::Model model = lone_mass();
  model.local_supports.push_back(
      {.node = 0, .translation = {true, false, false}, .rotation = {}, .birth = 0.3, .death = 0.6});
  const Index curve = test::add_constant_curve(model, 1);
  model.nodal_loads.push_back({.node = 0, .force = {8, 0, 0}, .curve = curve});
  timeloop::Simulation simulation(model, test::execution());
  double held_at = 0;
  test::ImbalanceAfterStart imbalance;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double time = domain.clock.time;
    const double x = domain.nodes.position[0].x;
    if (time > 0.3 + 0.02 && time < 0.6) {
      if (held_at == 0) held_at = x;
      EXPECT_EQ(x, held_at) << time;
    }
    imbalance.observe(domain);
  });
  test::verified("support with birth and death: imbalance over the energy of the start", "conservation")
      .below(imbalance.largest() / simulation.domain().energy.initial_total, 1e-13);
  // 3 t + 2 t^2 until it is held, to the step; then from rest with the acceleration 4.
  const double step = 0.01;
  EXPECT_NEAR(held_at, 3 * 0.3 + 2 * 0.09, 5 * step);
  const double free_for = simulation.domain().clock.time - 0.6;
  EXPECT_NEAR(simulation.domain().nodes.position[0].x - held_at, 2 * free_for * free_for, 5 * step);
  EXPECT_NEAR(simulation.domain().nodes.velocity[0].y, -1, 1e-12);
}

TEST(LocalSupports, StopRotationAboutTheirAxes) {
  model::Model model = lone_mass();
  model.lumped_masses[0].inertia = 0.7;
  const math::Matrix3 axes = tilt();
  model.local_supports.push_back(
      {.node = 0,
       .axes = {components(axes.column[0]), components(axes.column[1]), components(axes.column[2])},
       .translation = {},
       .rotation = {true, false, true}});
  model.nodal_loads.push_back({.node = 0, .moment = components(axes * Vec3{0.5, 0.7, -0.4})});
  model.output.of(model::HistoryFile::Spcforc).asked = true;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double time = domain.clock.time + 0.5 * simulation.next_step();
  const Vec3 spin = math::transposed_product(axes, domain.nodes.angular_velocity[0]);
  EXPECT_NEAR(spin.x, 0, 1e-12);
  EXPECT_NEAR(spin.y, time, 1e-10);
  EXPECT_NEAR(spin.z, 0, 1e-12);
  const Vec3 moment = math::transposed_product(axes, domain.supports.at(0).moment);
  EXPECT_NEAR(moment.x, -0.5, 1e-12);
  EXPECT_NEAR(moment.y, 0, 1e-12);
  EXPECT_NEAR(moment.z, 0.4, 1e-12);
}

}  // namespace
}  // namespace crumple::local_axes_test
