// SPDX-License-Identifier: BSD-3-Clause
// Tied contact with a gap (*CONTACT_TIED_..._OFFSET): nodes follow their segments on levers, stiff as one
// mesh, and springs hold those that something else holds.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include "constraints/tie_lever.hpp"
#include "support/larger.hpp"
#include "support/rigid.hpp"
#include "support/tied_runs.hpp"
#include "support/verified.hpp"

namespace crumple::tied_offset_test {
namespace {

using math::Vec3;

model::Model offset_blocks(Index coarse, Index fine, double gap) {
  model::Model model = test::two_blocks(coarse, fine, 4, model::TieMethod::Offset, gap);
  model.tied_contacts[0].tolerance = 2 * gap;
  return model;
}

/// Numbers with no order in them.
double scattered(int seed) {
  return std::sin(37.0 * seed + 11);
}

/// A large step: the velocity must take the end of the lever to where it belongs.
TEST(TieLever, VelocityTakesItsEndToItsPlace) {
  std::array<Vec3, 4> corner{Vec3{0, 0, 0}, Vec3{4, 0.3, 0.1}, Vec3{4.2, 3.8, -0.2}, Vec3{0.1, 4, 0.2}};
  std::array<Vec3, 4> velocity;
  for (int k = 0; k < 4; ++k) velocity[k] = {scattered(3 * k), scattered(3 * k + 1), scattered(3 * k + 2)};
  const constraints::TieLever before(corner, 0.7);
  const double step = 0.8;
  const Vec3 moved = before.height * before.normal + step * before.velocity(velocity, step);
  for (int k = 0; k < 4; ++k) corner[k] += step * velocity[k];
  const constraints::TieLever after(corner, 0.7);
  EXPECT_GT(norm(after.normal - before.normal), 0.1);
  EXPECT_LT(norm(moved - after.height * after.normal), 1e-14);
}

/// Power of the couple on the corners is that of the force at the lever's end; it has no resultant and the
/// moment of the force about the foot.
TEST(TieLever, CoupleHasTheMomentAndThePowerOfTheForce) {
  const std::array<Vec3, 4> corner{Vec3{0, 0, 0}, Vec3{4, 0.3, 0.1}, Vec3{4.2, 3.8, -0.2}, Vec3{0.1, 4, 0.2}};
  const constraints::TieLever lever(corner, -0.7);
  const Vec3 force{0.3, -0.8, 0.5};
  const std::array<Vec3, 4> couple = lever.couple(force);
  std::array<Vec3, 4> velocity;
  Vec3 sum;
  Vec3 moment;
  double power = 0;
  for (int k = 0; k < 4; ++k) {
    velocity[k] = {scattered(3 * k), scattered(3 * k + 1), scattered(3 * k + 2)};
    sum += couple[k];
    moment += cross(corner[k], couple[k]);
    power += dot(couple[k], velocity[k]);
  }
  EXPECT_LT(norm(sum), 1e-15);
  EXPECT_LT(norm(moment - cross(lever.height * lever.normal, force)), 1e-14);
  EXPECT_NEAR(power, dot(force, lever.velocity(velocity, 0)), 1e-15);
}

/// The spin is that of a rigid rotation, and the couple has the moment and the power at any motion.
TEST(TieLever, TurnsWithItsSegment) {
  const std::array<Vec3, 4> corner{Vec3{0, 0, 0}, Vec3{4, 0.3, 0.1}, Vec3{4.2, 3.8, -0.2}, Vec3{0.1, 4, 0.2}};
  const constraints::TieLever lever(corner, 0);
  const Vec3 spin{0.4, -0.7, 1.1};
  const Vec3 moment{0.3, 0.9, -0.6};
  const std::array<Vec3, 4> couple = lever.couple_of_moment(moment);
  std::array<Vec3, 4> turning;
  std::array<Vec3, 4> any;
  Vec3 sum;
  Vec3 of_couple;
  double power = 0;
  for (int k = 0; k < 4; ++k) {
    turning[k] = cross(spin, corner[k]);
    any[k] = {scattered(3 * k), scattered(3 * k + 1), scattered(3 * k + 2)};
    sum += couple[k];
    of_couple += cross(corner[k], couple[k]);
    power += dot(couple[k], any[k]);
  }
  EXPECT_LT(norm(lever.spin(turning, 0) - spin), 1e-14);
  EXPECT_LT(norm(sum), 1e-15);
  EXPECT_LT(norm(of_couple - moment), 1e-14);
  EXPECT_NEAR(power, dot(moment, lever.spin(any, 0)), 1e-15);
}

TEST(TiedOffset, WavesPassTheJoint) {
  for (const double gap : {0.0, 0.4}) {
    model::Model model = test::two_bars(2, 3, model::TieMethod::Offset, gap);
    model.tied_contacts[0].tolerance = 0.5;
    const test::Reflection found = test::reflection(model);
    std::printf("gap %.1f: reflected amplitude %.4f, energy error %.1e\n", gap, found.amplitude,
                found.energy_error);
    test::verified("pulse through two bars tied with an offset, 2 to 3: reflected amplitude", "none")
        .below(found.amplitude, 0.01);
    EXPECT_LT(found.energy_error, 1e-3);
  }
}

TEST(TiedOffset, MomentaAndEnergyAreKept) {
  test::expect_kept_when_shaken(offset_blocks(2, 3, 0.5));
}

/// The gap turns with the blocks, for four radians.
TEST(TiedOffset, TurningMakesNoForceAndKeepsTheGap) {
  model::Model model = offset_blocks(2, 3, 0.5);
  const double spin = 2.0;  // rad/ms
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    model.initial_velocities.push_back(
        {.node = i, .velocity = {-spin * (x[1] - 2), spin * (x[0] - 10), 0.3}, .angular_velocity = {}});
  }
  model.control.end_time = 2.0;
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  ASSERT_EQ(domain.ties[0].springs(), 0);
  double strayed = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    for (const domain::TiedNode& tied : now.ties[0].nodes) {
      std::array<Vec3, 4> corner;
      Vec3 away = now.nodes.position[tied.node];
      for (std::size_t k = 0; k < 4; ++k) {
        corner[k] = now.nodes.position[tied.corner[k]];
        away -= tied.weight[k] * corner[k];
      }
      strayed = test::larger_of(strayed, norm(away - tied.height * constraints::TieLever(corner, 1).normal));
    }
  });
  const domain::EnergyLedger& energy = domain.energy;
  std::printf("strayed %.1e, kinetic %.8g of %.8g, imbalance %.1e\n", strayed, energy.kinetic,
              energy.initial_total, energy.imbalance() / energy.initial_total);
  EXPECT_LT(strayed, 1e-12);
  EXPECT_NEAR(energy.kinetic, energy.initial_total, 1e-4 * energy.initial_total) << "it turns freely";
  EXPECT_LT(std::fabs(energy.imbalance()), 1e-6 * energy.initial_total);
}

/// A heavy block on a thin plate, its mass at the far end of the levers: stable at the usual step.
TEST(TiedOffset, HeavyNodesOnLeversAreStable) {
  model::Model model =
      test::one_solid_part({.id = 1, .title = "steel", .density = 7.85e-6, .law = model::Elastic{210, 0.3}});
  model.parts.push_back({.id = 2, .title = "heavy", .solid_section = 0, .material = 0});
  test::add_box(model, 0, 4, 4, 1, [](double u, double v, double w) {
    return test::Point{20 * u, 20 * v, 1.0 * w};
  });
  test::add_box(model, 1, 4, 4, 4, [](double u, double v, double w) {
    return test::Point{20 * u, 20 * v, 2.7 + 20 * w};
  });
  test::add_tie(model, model::TieMethod::Offset).tolerance = 2;
  test::shake(model);
  model.control.end_cycle = 20000;
  model.control.end_time = 1e6;
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  ASSERT_EQ(domain.ties[0].springs(), 0);
  double most = 0;
  test::run(simulation, [&](const domain::Domain& now) { most = test::larger_of(most, now.energy.total()); });
  std::printf("energy %.6g, largest %.6g\n", domain.energy.initial_total, most);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 2e-3 * domain.energy.initial_total);
}

/// The strip on edge of the shell joint, as by constraint without a gap.
TEST(TiedOffset, EdgeOfShellCarriesItsMoment) {
  model::Model model = test::shell_joint(true, 6);
  const test::Deflection exact = test::deflection(model);
  model.tied_contacts[0].method = model::TieMethod::Offset;
  const test::Deflection found = test::deflection(model);
  EXPECT_NEAR(found.largest, exact.largest, 1e-6 * exact.largest);
}

/// A cantilever of shells whose edge is tied to the face of a block of solids that is held, against one that
/// is clamped: its vibration under a sudden load at the tip.
model::Model cantilever(bool on_block) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(2.0, 3));
  const Index strip = test::add_grid(model, 0, 4, 8, [](double u, double v) {
    return test::Point{40 * v, 20 * u, 0};
  });
  test::add_constant_curve(model, 1.0);
  for (Index i = 0; i <= 4; ++i) {
    model.nodal_loads.push_back({.node = strip + 8 * 5 + i, .force = {0, 0, 1e-3}, .moment = {}, .curve = 0});
    if (!on_block)
      model.fixed_nodes.push_back(
          {.node = strip + i, .translation = {true, true, true}, .rotation = {true, true, true}});
  }
  model.control.end_time = 1.0;
  if (!on_block) return model;
  model.solid_sections.emplace_back();
  model.parts.push_back({.id = 2, .title = "block", .solid_section = 0, .material = 0});
  const Index block = model.nodes.count();
  test::add_box(model, 1, 4, 4, 4, [](double u, double v, double w) {
    return test::Point{-20 + 20 * u, 20 * v, 20 * w - 10};
  });
  for (Index i = block; i < model.nodes.count(); ++i)
    if (model.nodes.position[i][0] < -1e-9)
      model.fixed_nodes.push_back({.node = i, .translation = {true, true, true}});
  model::TiedContact& tied = test::add_tie(model, model::TieMethod::Constraint);
  std::swap(tied.side[0], tied.side[1]);
  tied.ties_rotations = true;
  tied.turns_on_faces = true;
  return model;
}

TEST(TiedOffset, ShellEdgePassesItsMomentToTheFacesOfSolids) {
  const test::Deflection clamped = test::tip_deflection(cantilever(false));
  model::Model model = cantilever(true);
  const test::Deflection tied = test::tip_deflection(model);
  model.tied_contacts[0].turns_on_faces = false;
  const test::Deflection hinged = test::tip_deflection(model);
  std::printf("largest deflection: clamped %.5f, tied %.5f, hinged %.5f; energy error %.1e\n",
              clamped.largest, tied.largest, hinged.largest, tied.energy_error);
  test::verified("shell edge tied to the face of a solid: deflection over that of a clamped one", "clamped")
      .near(tied.largest / clamped.largest, 1, 0.05);
  EXPECT_GT(hinged.largest, 5 * clamped.largest);
  EXPECT_LT(tied.energy_error, 1e-3);
}

TEST(TiedOffset, SpringsHoldWhatSomethingElseHolds) {
  model::Model model = offset_blocks(2, 3, 0.5);
  const auto springs_of = [](const model::Model& given) {
    return timeloop::Simulation(given, test::execution()).domain().ties[0].springs();
  };
  EXPECT_EQ(springs_of(model), 0);
  const timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  const Index tied = domain.nodes.model_node[domain.ties[0].nodes[5].node];
  model::Model held = model;
  test::add_constant_curve(held, 0.0);
  held.prescribed_motions.push_back({.node = tied, .axis = 1, .curve = 0, .scale = 1});
  EXPECT_EQ(springs_of(held), 1) << "a prescribed motion";
  model::Model stopped = model;
  model::RigidWall wall;
  wall.normal = {0, 0, 1};
  wall.point = {0, 0, -1};
  wall.nodes = {tied};
  stopped.rigid_walls.push_back(wall);
  EXPECT_EQ(springs_of(stopped), 1) << "a wall that does not stop the segment";
  model::Model rigid = model;
  test::make_rigid(rigid, 0);
  EXPECT_EQ(springs_of(rigid), 16) << "segments of a rigid body";
  model::Model far = offset_blocks(2, 3, 1.5);
  EXPECT_EQ(springs_of(far), 16) << "levers too long";
}

}  // namespace
}  // namespace crumple::tied_offset_test
