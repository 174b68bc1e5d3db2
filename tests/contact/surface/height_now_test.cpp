// SPDX-License-Identifier: BSD-3-Clause
// Heights of solids behind their faces as they are deformed.
#include "contact/surface/height_now.hpp"

#include <gtest/gtest.h>

#include "domain/build.hpp"
#include "support/meshes.hpp"
#include "support/shapes.hpp"

namespace crumple::contact::height_now_test {
namespace {

/// A block of 2 x 3 x 4 in one hexahedron, or six tetrahedra, sheared and crushed to a tenth of its height
/// and stretched to the double of its length.
void expect_heights(bool tetrahedra) {
  model::Model model =
      test::one_solid_part({.id = 1, .title = "steel", .density = 1, .law = model::Elastic{1, 0}});
  test::add_box(model, 0, 1, 1, 1, [](double u, double v, double w) {
    return test::Point{2 * u, 3 * v, 4 * w};
  });
  if (tetrahedra) test::split_into_tetrahedra(model);
  test::touch_all(model);
  domain::Domain domain = domain::build(model, {Precision::Double, Isa::Scalar, 1});
  const Surface surface = build_surface(model, domain, model.contacts[0]);
  for (Vec3& x : domain.nodes.position) x = {2 * x.x + 0.3 * x.z, x.y, 0.1 * x.z};
  int level = 0;
  for (Index s = 0; s < surface.segments(); ++s) {
    const Index* nodes = surface.segment(s);
    const double z = domain.nodes.reference[nodes[0]].z;
    const bool is_level = domain.nodes.reference[nodes[1]].z == z && domain.nodes.reference[nodes[2]].z == z;
    if (!is_level) continue;
    ++level;
    EXPECT_NEAR(height_now(surface, domain.nodes, s), 0.1 * surface.height[s], 1e-12) << s;
  }
  EXPECT_EQ(level, tetrahedra ? 4 : 2);
}

TEST(HeightNow, FollowsHexahedra) {
  expect_heights(false);
}

TEST(HeightNow, FollowsTetrahedra) {
  expect_heights(true);
}

}  // namespace
}  // namespace crumple::contact::height_now_test
