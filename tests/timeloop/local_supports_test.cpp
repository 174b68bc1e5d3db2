// SPDX-License-Identifier: BSD-3-Clause
// Blocks on supports with axes or times of their own that meet a rigid wall, against the same blocks on
// fixed degrees of freedom.
#include <gtest/gtest.h>

#include <cmath>

#include "math/rotation.hpp"
#include "math/to_vec3.hpp"
#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::local_supports_test {
namespace {

using math::Vec3;

enum class Held { Fixed, ForATime, AlongAxes };

std::array<double, 3> components(const Vec3& a) {
  return {a.x, a.y, a.z};
}

/// All nodes are held along x and y of the axes; the block flies along z onto a wall that is oblique to them.
model::Model block_onto_wall(const math::Matrix3& axes, Held held) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  test::add_box(model, 0, 2, 2, 2, [&](double u, double v, double w) {
    return components(axes * Vec3{10 * u, 10 * v, 10 * w});
  });
  model::RigidWall wall{.id = 1, .title = "", .nodes = {}, .point = {}, .normal = {}};
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const std::array<bool, 3> across{true, true, false};
    if (held == Held::Fixed) {
      model.fixed_nodes.push_back({.node = node, .translation = across, .rotation = {}});
    } else {
      model::LocalSupport support{.node = node, .translation = across, .rotation = {}};
      support.axes = {components(axes.column[0]), components(axes.column[1]), components(axes.column[2])};
      if (held == Held::ForATime) support.death = 1;
      model.local_supports.push_back(support);
    }
    model.initial_velocities.push_back({.node = node, .velocity = components(axes * Vec3{0, 0, -10})});
    wall.nodes.push_back(node);
  }
  wall.point = components(axes * Vec3{0, 0, -0.01});
  wall.normal = components(axes * normalised(Vec3{0.02, 0, 1}));
  model.rigid_walls.push_back(wall);
  model.control.end_time = 0.02;
  return model;
}

/// Runs the one with the supports beside that with fixed degrees of freedom.
void compare(const math::Matrix3& axes, Held held, const std::string& name) {
  const model::Model straight = block_onto_wall(math::unit_matrix(), Held::Fixed);
  const model::Model other = block_onto_wall(axes, held);
  timeloop::Simulation first(straight, test::execution());
  timeloop::Simulation second(other, test::execution());
  test::run(first);
  test::run(second);
  double largest = 0;
  double error = 0;
  double across = 0;
  for (Index node = 0; node < straight.nodes.count(); ++node) {
    const Vec3 expected = test::displacement(first.domain(), node);
    const Vec3 found = math::transposed_product(axes, test::displacement(second.domain(), node));
    largest = test::larger_of(largest, norm(expected));
    error = test::larger_of(error, norm(found - expected));
    across = test::larger_of(across, std::hypot(found.x, found.y));
  }
  ASSERT_LT(first.domain().walls[0].impulse.z, 0) << "the block has met the wall";
  test::verified(name + ": displacement along what is held, over the largest", "none")
      .below(across / largest, 1e-12);  // coordinates are 100 times as large
  test::verified(name + ": displacement, error over the largest", "the block on fixed degrees of freedom")
      .below(error / largest, 1e-10);
  const Vec3 impulse = math::transposed_product(axes, second.domain().walls[0].impulse);
  test::verified(name + ": impulse of the wall, error over itself", "the block on fixed degrees of freedom")
      .below(norm(impulse - first.domain().walls[0].impulse) / norm(impulse), 1e-10);
  EXPECT_NEAR(second.domain().energy.ratio(), first.domain().energy.ratio(), 1e-10);
  EXPECT_NEAR(first.domain().energy.ratio(), 1, 2e-3);
}

TEST(LocalSupports, OfATimeHoldWhatAWallPushes) {
  compare(math::unit_matrix(), Held::ForATime, "block on supports with a death onto a wall");
}

TEST(LocalSupports, AlongObliqueAxesHoldWhatAWallPushes) {
  compare(math::matrix_of(math::cayley_rotation({0.11, 0.22, 0.33})), Held::AlongAxes,
          "block on turned supports onto a wall");
}

}  // namespace
}  // namespace crumple::local_supports_test
