// SPDX-License-Identifier: BSD-3-Clause
// Tied contact with a gap (*CONTACT_TIED_..._OFFSET): nodes follow their segments on levers, stiff as one
// mesh, and springs hold those that something else holds.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "constraints/tie_lever.hpp"
#include "support/larger.hpp"
#include "support/rigid.hpp"
#include "support/tied_runs.hpp"
#include "support/verified.hpp"

namespace crumple::tied_offset_test {
namespace {

using math::Vec3;

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
  test::expect_kept_when_shaken(test::offset_blocks(model::TieMethod::Offset, 2, 3, 0.5));
}

/// The gap turns with the blocks, for four radians.
TEST(TiedOffset, TurningMakesNoForceAndKeepsTheGap) {
  model::Model model = test::offset_blocks(model::TieMethod::Offset, 2, 3, 0.5);
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

/// The same free in space.
model::Model free_strip_on_block() {
  model::Model model = cantilever(true);
  model.fixed_nodes.clear();
  model.nodal_loads.clear();
  return model;
}

TEST(TiedOffset, ShellEdgeOnSolidsKeepsMomentaAndEnergy) {
  test::expect_kept_when_shaken(free_strip_on_block());
}

/// Bent and twisted for a hundred periods of the strip: the moment of its edge must not get lost.
TEST(TiedOffset, ShellEdgeOnSolidsVibratesFreely) {
  for (const bool twists : {false, true}) {
    model::Model model = free_strip_on_block();
    for (Index i = 0; i < model.nodes.count(); ++i) {
      const auto& x = model.nodes.position[i];
      const double along = std::max(0.0, x[0]) / 40;
      model.initial_velocities.push_back(
          {.node = i, .velocity = {0, 0, along * (twists ? 0.1 * (x[1] - 10) : 1)}, .angular_velocity = {}});
    }
    model.control.end_time = 20;
    const test::Conservation kept = test::watched_run(model);
    test::verified(std::string("strip of shells tied to a block by its edge, free, ") +
                       (twists ? "twisted" : "bent") + ": error of energy over the energy",
                   "none")
        .below(kept.worst_imbalance, 3e-3);
    EXPECT_LT(kept.turning_drift, 1e-12);
  }
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
  model::Model model = test::offset_blocks(model::TieMethod::Offset, 2, 3, 0.5);
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
  model::Model far = test::offset_blocks(model::TieMethod::Offset, 2, 3, 1.5);
  EXPECT_EQ(springs_of(far), 16) << "levers too long";
}

}  // namespace
}  // namespace crumple::tied_offset_test
