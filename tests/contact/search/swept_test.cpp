// SPDX-License-Identifier: BSD-3-Clause
//
// Nodes that cross all that a territory covers within one step: they are found and brought back.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "contact/bodies.hpp"
#include "contact/search/motion_limit.hpp"

namespace crumple::swept_test {
namespace {

using test::Bodies;
using test::Vec3;

constexpr double thickness = 0.06;

/// Two flat sheets with edges of 0.25, the second `height` above the first and a little aside.
Bodies two_sheets(double height) {
  Bodies bodies(thickness);
  bodies.sheet(8, 8, [](double u, double v) { return Vec3{2 * u, 2 * v, 0}; });
  bodies.sheet(4, 4, [&](double u, double v) { return Vec3{0.53 + u, 0.57 + v, height}; });
  return bodies;
}

/// The positions with everything above z = 0 lowered by `distance`.
std::vector<Vec3> lowered(const domain::Domain& made, double distance) {
  std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
  for (Vec3& p : x)
    if (p.z > 0) p.z -= distance;
  return x;
}

TEST(Swept, ANodeThatCrossesTheWholeTerritoryInAStepIsFound) {
  for (const double expansion : {0.0, 0.07, 0.5})
    for (const double way : {0.4, 1.0, 5.0}) {
      Bodies bodies = two_sheets(0.2);
      bodies.model.search.expansion = expansion;
      domain::Domain made = bodies.build();
      contact::Interface touching = bodies.attach(made);
      touching.verify_search_every(1);
      test::add_forces(touching, made);
      ASSERT_NO_THROW(test::move_to(touching, made, lowered(made, way), 1e-3))
          << "expansion " << expansion << ", way " << way;
      // Each of the 25 nodes is behind a segment of the larger sheet.
      EXPECT_GE(touching.statistics().nodes_astray, 25) << "expansion " << expansion << ", way " << way;
      double push = 0;
      for (Index i = 0; i < made.nodes.count(); ++i)
        if (made.nodes.reference[i].z > 0.1) push += made.contact_force[i].z;
      EXPECT_GT(push, 0) << "the sheet is pushed back to where it came from";
    }
}

TEST(Swept, CrossedEdgesToo) {
  Bodies bodies(thickness);
  bodies.contact.edges = model::ContactEdges::Free;
  bodies.sheet(4, 2, [](double u, double v) { return Vec3{2 * u - 0.93, 0.03, -0.1 - v}; });
  bodies.sheet(4, 2, [](double u, double v) { return Vec3{0.07, 2 * u - 0.81, 0.1 + v}; });
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  touching.verify_search_every(1);
  test::add_forces(touching, made);
  ASSERT_NO_THROW(test::move_to(touching, made, lowered(made, 0.45), 1e-3));
  EXPECT_GE(touching.statistics().edges_astray, 1);
}

// The step is bounded by how fast the surfaces meet, and only then.
TEST(Swept, StepIsBoundedByTheRelativeMotion) {
  Bodies bodies = two_sheets(0.2);
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  const double edge = touching.surface().mean_edge;
  const double speed = 40;
  for (Index i = 0; i < made.nodes.count(); ++i)
    made.nodes.velocity[i] = {7, 0, made.nodes.reference[i].z > 0.1 ? -speed : 0};
  made.clock.way = made.clock.step = 0;
  EXPECT_NEAR(contact::longest_step_for_motion(touching.surface(), made, 1e-2), 0.2 * edge / speed, 1e-15);
  // A way that cannot be that long at the allowed step asks for nothing.
  made.clock.step = 1e-3;
  made.clock.way = 1e-3 * speed;
  EXPECT_GT(contact::longest_step_for_motion(touching.surface(), made, 1e-3), 1e300);
  EXPECT_LT(contact::longest_step_for_motion(touching.surface(), made, 2e-3), 2e-3);
}

}  // namespace
}  // namespace crumple::swept_test
