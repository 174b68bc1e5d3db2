// SPDX-License-Identifier: BSD-3-Clause
//
// What ends a run before its end time (*TERMINATION).

#include <gtest/gtest.h>

#include <cmath>

#include "support/lines.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::terminations_test {
namespace {

using Kind = model::Termination::Kind;

/// A rigid and an elastic cube of side 10, the second one 5 above the first and moving down with a speed
/// of 1.
model::Model falling_cube() {
  model::Model model = test::one_solid_part(test::elastic_steel());
  model.parts.push_back(model.parts[0]);
  model.parts[1].id = 2;
  for (const Index part : {0, 1})
    test::add_box(model, part, 2, 2, 2, [&](double u, double v, double w) {
      return test::Point{10 * u, 10 * v, 10 * w + 10.5 * part};
    });
  test::make_rigid(model, 0);
  model.rigid_bodies[0].fixed_translation = model.rigid_bodies[0].fixed_rotation = {true, true, true};
  for (const Index node : test::nodes_of_part(model, 1))
    model.initial_velocities.push_back({.node = node, .velocity = {0, 0, -1}});
  model::Contact contact;
  contact.id = 7;
  contact.kind = model::ContactKind::SurfaceToSurface;
  contact.side[0].parts = {1};
  contact.side[1].parts = {0};
  model.contacts.push_back(contact);
  model.control.end_time = 3;
  return model;
}

/// When a run with this termination ends, and its last step.
struct End {
  double time = 0;
  double step = 0;
};

End end_of(model::Model model, const model::Termination& termination) {
  model.terminations.push_back(termination);
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  EXPECT_TRUE(simulation.ended_by().has_value());
  return {simulation.domain().clock.time, simulation.domain().clock.step};
}

/// The run ends in the step that passes `time`, or `steps` later at most.
void expect_end(const End& end, double time, int steps = 1) {
  EXPECT_GT(end.time, time - 1e-9);
  EXPECT_LT(end.time, time + steps * end.step * (1 + 1e-6));
}

TEST(Terminations, NodeThatPassesItsBoundEndsTheRunInThatStep) {
  // A node of the lower face, from z = 10.5 on.
  const Index node = 27;
  const End lower = end_of(falling_cube(), {.kind = Kind::Place, .item = node, .axis = 2, .least = 10.2});
  test::verified("node with a lower bound: end of the run less the time of passage, in steps", "exact")
      .near((lower.time - 0.3) / lower.step, 0.5, 0.5 + 1e-6);
  model::Model model = falling_cube();
  for (model::InitialVelocity& given : model.initial_velocities) given.velocity = {0, 2, 0};
  expect_end(end_of(model, {.kind = Kind::Place, .item = node, .axis = 1, .most = 1}), 0.5);
}

TEST(Terminations, ContactOnANodeEndsTheRun) {
  expect_end(end_of(falling_cube(), {.kind = Kind::Touch, .item = 27}), 0.5, 2);
}

TEST(Terminations, ContactWithoutForceEndsTheRunAfterItsTime) {
  const model::Model model = falling_cube();
  // The time of contact of the same run without a termination.
  timeloop::Simulation simulation(model, test::execution());
  double last = 0;
  simulation.start();
  while (!simulation.finished()) {
    simulation.step();
    if (norm(simulation.domain().contacts[0].force) > 0) last = simulation.domain().clock.time;
  }
  ASSERT_GT(last, 0.5);
  ASSERT_LT(last, 0.7);
  model::Termination termination{.kind = Kind::NoContact, .item = 0, .axis = -1, .activation = 0.1};
  // Active while the cubes have not met yet: at once.
  expect_end(end_of(model, termination), 0.1);
  // With a duration longer than the way to contact: from the end of the contact on.
  termination.duration = 0.45;
  expect_end(end_of(model, termination), last + 0.45, 3);
  termination.axis = 2;
  expect_end(end_of(model, termination), last + 0.45, 3);
  // There never is more than this.
  termination.threshold = 1e9;
  expect_end(end_of(model, termination), 0.1 + 0.45, 3);
}

TEST(Terminations, BodyThatHasMovedFarEnoughEndsTheRun) {
  model::Model model = falling_cube();
  model.contacts.clear();
  model.rigid_bodies[0].fixed_translation = model.rigid_bodies[0].fixed_rotation = {false, false, false};
  for (const Index node : test::nodes_of_part(model, 0))
    model.initial_velocities.push_back({.node = node, .velocity = {3, -4, 0}});
  expect_end(end_of(model, {.kind = Kind::Displacement, .item = 0, .axis = 0, .most = 0.6}), 0.2);
  expect_end(end_of(model, {.kind = Kind::Displacement, .item = 0, .axis = 1, .least = -0.6}), 0.15);
  expect_end(end_of(model, {.kind = Kind::Distance, .item = 0, .most = 0.5}), 0.1);
}

TEST(Terminations, DeletedElementsEndTheRun) {
  model::Model model = falling_cube();
  model.materials[0] = test::mild_steel();
  std::get<model::PlasticKinematic>(model.materials[0].law).failure_strain = 1e-3;
  for (model::InitialVelocity& given : model.initial_velocities) given.velocity = {0, 0, -100};
  model.control.end_time = 1;
  const double one = end_of(model, {.kind = Kind::Deleted, .count = 1, .parts = {1}}).time;
  const double four = end_of(model, {.kind = Kind::Deleted, .count = 4, .parts = {1}}).time;
  EXPECT_GT(one, 0.005);
  EXPECT_GE(four, one);
  EXPECT_LT(four, 0.2);
}

}  // namespace
}  // namespace crumple::terminations_test
