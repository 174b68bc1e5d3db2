// SPDX-License-Identifier: BSD-3-Clause
// Faces on planes of symmetry, which nothing touches.
#include <gtest/gtest.h>

#include <algorithm>

#include "contact/surface/surface.hpp"
#include "domain/build.hpp"
#include "math/rotation.hpp"
#include "support/meshes.hpp"

namespace crumple::symmetry_planes_test {
namespace {

using math::Vec3;

std::array<double, 3> components(const Vec3& a) {
  return {a.x, a.y, a.z};
}

/// A box of 3 x 2 x 2 solids whose first side is held along its normal, by supports along these axes.
model::Model box(const math::Matrix3& axes, const std::array<bool, 3>& held, double death) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  test::add_box(model, 0, 3, 2, 2, [&](double u, double v, double w) {
    return components(axes * Vec3{30 * u, 20 * v, 20 * w});
  });
  for (Index node = 0; node < model.nodes.count(); node += 4) {
    model::LocalSupport support{.node = node, .translation = held, .rotation = {}};
    support.axes = {components(axes.column[0]), components(axes.column[1]), components(axes.column[2])};
    support.death = death;
    model.local_supports.push_back(support);
  }
  model.contacts.push_back(model::self_contact(1, "", {0}));
  model.contacts[0].symmetry_planes = true;
  return model;
}

/// Faces that nothing touches.
Index left_alone(const model::Model& model) {
  const domain::Domain domain = domain::build(model, {});
  const contact::Surface surface = contact::build_surface(model, domain, model.contacts[0]);
  return static_cast<Index>(std::count(surface.touched_by.begin(), surface.touched_by.end(), 0));
}

TEST(SymmetryPlanes, AreFoundWhateverAxesHoldThem) {
  const math::Matrix3 turned = math::matrix_of(math::cayley_rotation({0.11, 0.22, 0.33}));
  constexpr double never = 1e28;
  EXPECT_EQ(left_alone(box(turned, {true, false, false}, never)), 4);
  EXPECT_EQ(left_alone(box(turned, {false, true, true}, never)), 0) << "held along the face";
  EXPECT_EQ(left_alone(box(turned, {true, true, true}, never)), 0) << "clamped";
  EXPECT_EQ(left_alone(box(turned, {true, false, false}, 0.5)), 0) << "free later on";
}

}  // namespace
}  // namespace crumple::symmetry_planes_test
