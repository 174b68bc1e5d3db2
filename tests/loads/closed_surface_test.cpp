// SPDX-License-Identifier: BSD-3-Clause
#include "loads/closed_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "domain/build.hpp"
#include "support/bags.hpp"
#include "support/verified.hpp"

namespace crumple::closed_surface_test {
namespace {

using math::Vec3;

/// A box pushed out of shape so that no segment is flat, with a triangle pair on it.
model::Model warped_box(int n) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.1, 2));
  test::add_closed_box(model, 0, n, [](double x, double y, double z) {
    return test::Point{x + 0.1 * y * z, y + 0.2 * x * x * z, z - 0.1 * x * y + 0.15 * x};
  });
  const auto [a, b, c, d] = model.shells.back().node;
  model.shells.back().node = {a, b, c, c};
  model::ShellElement other = model.shells.back();
  other.id += 1;
  other.node = {a, c, d, d};
  model.shells.push_back(other);
  return model;
}

std::vector<std::array<Index, 4>> segments_of(const model::Model& model) {
  return test::bag_of_shells(model, model::AdiabaticGas{}).segments;
}

loads::ClosedSurface surface_in(const model::Model& model, const domain::Domain& domain) {
  std::vector<std::array<Index, 4>> segments = segments_of(model);
  for (auto& segment : segments)
    for (Index& node : segment) node = domain.nodes.domain_node[node];
  return loads::ClosedSurface(segments);
}

// Two points a direction integrate a bilinear segment's flux exactly.
TEST(CornerAreas, AreTheIntegralsOfTheShapeFunctionsTimesTheNormal) {
  const std::array<Vec3, 4> x{Vec3{0, 0, 0.3}, Vec3{2, 0.2, -0.4}, Vec3{2.5, 1.5, 0.6},
                              Vec3{-0.3, 1.1, -0.2}};
  const std::array<Vec3, 4> areas = loads::corner_areas(x, false);
  std::array<Vec3, 4> expected{};
  const double g = 1 / std::sqrt(3.0);
  for (const double xi : {-g, g})
    for (const double eta : {-g, g}) {
      const std::array<double, 4> shape{0.25 * (1 - xi) * (1 - eta), 0.25 * (1 + xi) * (1 - eta),
                                        0.25 * (1 + xi) * (1 + eta), 0.25 * (1 - xi) * (1 + eta)};
      const Vec3 by_xi = 0.25 * ((1 - eta) * (x[1] - x[0]) + (1 + eta) * (x[2] - x[3]));
      const Vec3 by_eta = 0.25 * ((1 - xi) * (x[3] - x[0]) + (1 + xi) * (x[2] - x[1]));
      for (std::size_t k = 0; k < 4; ++k) expected[k] += shape[k] * cross(by_xi, by_eta);
    }
  for (std::size_t k = 0; k < 4; ++k)
    test::verified("corner area of a warped segment, error", "Gauss quadrature of the bilinear surface")
        .below(norm(areas[k] - expected[k]), 1e-15);
}

TEST(ClosedSurface, HasTheVolumeOfBothWaysToCutItsSegments) {
  const model::Model model = warped_box(3);
  const domain::Domain domain = domain::build(model, {});
  loads::ClosedSurface surface = surface_in(model, domain);
  surface.measure(domain.nodes, 1);
  const double expected = model::enclosed_volume(model.nodes.position, segments_of(model));
  EXPECT_NEAR(expected, 8, 0.5);
  test::verified("volume in a closed warped surface", "tetrahedra over both diagonals of each segment")
      .within(surface.volume(), expected, 1e-14);
}

// The gradient is that of the volume, by central differences of a cubic: the error is of the third order of
// the shift and of round-off over it.
TEST(ClosedSurface, GivesTheGradientOfItsVolume) {
  const model::Model model = warped_box(3);
  domain::Domain domain = domain::build(model, {});
  loads::ClosedSurface surface = surface_in(model, domain);
  surface.measure(domain.nodes, 1);
  const std::vector<Vec3> gradients = surface.gradients();
  const double shift = 1e-4;
  double worst = 0;
  for (std::size_t i = 0; i < surface.nodes().size(); ++i) {
    Vec3& x = domain.nodes.position[surface.nodes()[i]];
    const Vec3 before = x;
    Vec3 slope;
    for (int axis = 0; axis < 3; ++axis) {
      double volume[2] = {};
      for (const int side : {0, 1}) {
        x[axis] = before[axis] + (side == 0 ? -shift : shift);
        surface.measure(domain.nodes, 1);
        volume[side] = surface.volume();
        x = before;
      }
      slope[axis] = (volume[1] - volume[0]) / (2 * shift);
    }
    worst = std::fmax(worst, norm(slope - gradients[i]));
  }
  test::verified("gradient of the volume in a closed warped surface, error", "central differences")
      .below(worst, 1e-10);
}

// A pressure inside has neither resultant nor moment, wherever the surface is.
TEST(ClosedSurface, HasNoResultantAndNoMoment) {
  const model::Model model = warped_box(4);
  domain::Domain domain = domain::build(model, {});
  loads::ClosedSurface surface = surface_in(model, domain);
  surface.measure(domain.nodes, 1);
  const double volume = surface.volume();
  for (Vec3& x : domain.nodes.position) x = Vec3{x.y, -x.x, x.z} + Vec3{1000, -2000, 500};
  surface.measure(domain.nodes, 1);
  Vec3 force;
  Vec3 moment;
  for (std::size_t i = 0; i < surface.nodes().size(); ++i) {
    force += surface.gradients()[i];
    moment +=
        cross(domain.nodes.position[surface.nodes()[i]] - Vec3{1000, -2000, 500}, surface.gradients()[i]);
  }
  // Positions have lost three digits of 16 to the shift.
  test::verified("closed warped surface: resultant of a unit pressure", "none").below(norm(force), 1e-13);
  test::verified("closed warped surface: moment of a unit pressure", "none").below(norm(moment), 1e-11);
  test::verified("closed warped surface: volume after turn and shift", "unchanged")
      .within(surface.volume(), volume, 1e-12);
}

TEST(ClosedSurface, IsTheSameForAnyThreads) {
  const model::Model model = warped_box(20);  // more than one piece of segments and of nodes
  const domain::Domain domain = domain::build(model, {});
  loads::ClosedSurface one = surface_in(model, domain);
  loads::ClosedSurface three = surface_in(model, domain);
  one.measure(domain.nodes, 1);
  three.measure(domain.nodes, 3);
  EXPECT_EQ(one.volume(), three.volume());
  EXPECT_EQ(one.area(), three.area());
  for (std::size_t i = 0; i < one.nodes().size(); ++i)
    EXPECT_EQ(norm(one.gradients()[i] - three.gradients()[i]), 0);
}

}  // namespace
}  // namespace crumple::closed_surface_test
