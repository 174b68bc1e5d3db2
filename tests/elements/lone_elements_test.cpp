// SPDX-License-Identifier: BSD-3-Clause
// The largest frequencies of elements alone, against closed forms, and their steps.
#include "elements/lone_elements.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "shell_harness.hpp"
#include "support/verified.hpp"

namespace crumple::elements::testing::lone_elements_test {
namespace {

using math::Vec3;

constexpr double nu = 0.3;

/// Constant gradients of a square of side 1: it breathes with the strain 2 a in both directions.
TEST(LargestEigenvalue, OfASquareIsThatOfBreathing) {
  const std::array<Vec3, 4> gradient{{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}}};
  test::verified("square alone: largest eigenvalue", "1 + nu")
      .near(largest_eigenvalue(gradient, nu, 1 - nu), 1 + nu, 1e-12);
}

/// Gradients of the length 1 / height, 2/3 of a unit matrix over height^2 in sum.
TEST(LargestEigenvalue, OfARegularTriangleIsThatOfBreathing) {
  std::array<Vec3, 3> gradient;
  for (std::size_t n = 0; n < 3; ++n)
    gradient[n] = {std::cos(2.0943951023931953 * static_cast<double>(n)),
                   std::sin(2.0943951023931953 * static_cast<double>(n)), 0};
  test::verified("regular triangle of height 1 alone: largest eigenvalue", "3 (1 + nu) / 2")
      .near(largest_eigenvalue(gradient, nu, 1 - nu), 1.5 * (1 + nu), 1e-12);
}

/// K / (lambda + 2 mu) = 1 - 2 s / 3 with s = 2 mu / (lambda + 2 mu).
TEST(LargestEigenvalue, OfARegularTetrahedronIsThatOfItsVolume) {
  const double root = std::sqrt(1.0 / 3.0);
  const std::array<Vec3, 4> gradient{
      {{root, root, root}, {root, -root, -root}, {-root, root, -root}, {-root, -root, root}}};
  const double shear = (1 - 2 * nu) / (1 - nu);
  test::verified("regular tetrahedron of height 1 alone: largest eigenvalue", "4 K / (lambda + 2 mu)")
      .near(largest_eigenvalue(gradient, 1 - shear, shear), 4 * (1 - 2 * shear / 3), 1e-9);
}

/// Squares of a mesh keep their step, at its corners too; the one alone and those of a strip do not.
TEST(LoneElements, AreToldFromThoseOfAMesh) {
  const auto shortest = [](Index cells) {
    const model::Model model = plate(belytschko_tsay.formulation, cells, 0);
    const Driven body(model, {});
    const LoneElements lone(model, body.domain);
    double least = 1;
    for (const domain::ShellBlock& block : body.domain.shells)
      for (Index place = 0; place < block.elements; ++place)
        least = std::fmin(least, lone.factor(body.domain, block, place));
    return least;
  };
  EXPECT_NEAR(shortest(1), 1 / std::sqrt(1 + poissons_ratio), 1e-12);
  EXPECT_EQ(shortest(2), 1);
  EXPECT_EQ(shortest(4), 1);
}

/// A skin of null shells holds nothing back: the square under it is as alone as without.
TEST(LoneElements, NullSkinsAreNoNeighbours) {
  model::Model model = plate(belytschko_tsay.formulation, 1, 0);
  const double bare = LoneElements(model, Driven(model, {}).domain)
                          .factor(Driven(model, {}).domain, Driven(model, {}).block(), 0);
  model::Material null;
  null.id = 77;
  null.density = model.materials[0].density;
  null.law = model::NullMaterial{};
  model.materials.push_back(null);
  model::Part skin = model.parts[0];
  skin.id = 77;
  skin.material = static_cast<Index>(model.materials.size()) - 1;
  model.parts.push_back(skin);
  model::ShellElement shell = model.shells[0];
  shell.id = 77;
  shell.part = static_cast<Index>(model.parts.size()) - 1;
  model.shells.push_back(shell);
  const Driven body(model, {});
  EXPECT_EQ(LoneElements(model, body.domain).factor(body.domain, body.domain.shells[0], 0), bare);
}

}  // namespace
}  // namespace crumple::elements::testing::lone_elements_test
