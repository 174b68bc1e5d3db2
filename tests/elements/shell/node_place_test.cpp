// SPDX-License-Identifier: BSD-3-Clause
// Shells whose nodes do not lie in the mid-surface, and rules with many points.
#include <gtest/gtest.h>

#include "elements/shell_harness.hpp"
#include "math/quadrature.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::elements::testing::node_place_test {
namespace {

model::Model flat_plate(const Kind& kind, double node_place) {
  model::Model model = plate(kind.formulation, 2, 0.15);
  model.control.hourglass = no_hourglass_control();
  model.shell_sections[0].node_place = node_place;
  return model;
}

/// A flat shell whose nodes lie off its mid-surface is one with nodes in it that are tied to these by rigid
/// arms: u_mid = u + turn x arm, and its moments are those about the arm's end.
TEST(NodePlace, IsARigidArmToTheMidSurface) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1e-5, 1e-5);
  for (const Kind& kind : kinds) {
    const std::string arms =
        std::string(kind.name) + ", nodes off the mid-surface, over motion and round-off: ";
    test::Largest forces(arms + "forces over the largest, difference", "rigid arms to the mid-surface", 1);
    test::Largest moments(arms + "moments over the largest force, difference",
                          "rigid arms to the mid-surface", 5);
    for (const double node_place : {1.0, -1.0, 0.4})
      for (const auto& execution : all_executions()) {
        Driven offset(flat_plate(kind, node_place), execution);
        Driven middle(flat_plate(kind, 0), execution);
        const Vec3 arm{0, 0, -0.5 * node_place * thickness};
        const auto nodes = static_cast<std::size_t>(offset.domain.nodes.count());
        std::vector<Vec3> u(nodes);
        std::vector<Vec3> turn(nodes);
        std::vector<Vec3> u_middle(nodes);
        for (std::size_t i = 0; i < nodes; ++i) {
          u[i] = {uniform(generator), uniform(generator), uniform(generator)};
          turn[i] = {uniform(generator), uniform(generator), 0};
          u_middle[i] = u[i] + cross(turn[i], arm);
        }
        offset.step(1, u, turn);
        middle.step(1, u_middle, turn);
        double largest = 0;
        for (Index i = 0; i < offset.domain.nodes.count(); ++i)
          largest = test::larger_of(largest, norm(middle.force(i)));
        ASSERT_GT(largest, 0);
        // The geometry at mid-step differs by the motion, 1e-5 of an element's 5, beside round-off.
        const double bound = (1e-5 + 100 * round_off(execution)) * largest;
        for (Index i = 0; i < offset.domain.nodes.count(); ++i) {
          forces.add(norm(offset.force(i) - middle.force(i)) / bound, name_of(execution));
          moments.add(norm(offset.moment(i) - middle.moment(i) - cross(arm, middle.force(i))) / bound);
        }
      }
  }
}

TEST(NodePlace, AddsToTheRotaryInertiaOfThickShells) {
  for (const Kind& kind : kinds) {
    model::Model model = flat_plate(kind, 1);
    model.shell_sections[0].thickness = {15, 15, 15, 15};  // three times the side: A/8 does not govern
    const Driven body(model, {});
    for (Index i = 0; i < body.domain.nodes.count(); ++i) {
      const double of_fibres = body.domain.nodes.mass[i] * 15.0 * 15.0 / 3;
      EXPECT_GE(body.domain.nodes.inertia[i], of_fibres);
      EXPECT_LT(body.domain.nodes.inertia[i],
                of_fibres + 0.01 * body.domain.nodes.mass[i] * 25);  // for the skew
    }
  }
}

/// The moment of a section bent far beyond yield approaches sigma t^2 / 4 with the points of the trapezoidal
/// rule, at the rate of the sum of weight times place.
TEST(TrapezoidalRule, FindsTheFullyPlasticMoment) {
  for (const Kind& kind : kinds)
    for (const int points : {5, 11, 20}) {
      model::Model model = plate(kind.formulation, 1, 0, points, plastic(1, 0));
      model.shell_sections[0].thickness_rule = model::ThicknessRule::Trapezoid;
      Driven body(model, {});
      constexpr double curvature = 0.01;
      for (int step = 0; step < 100; ++step)
        body.step(
            1e-3, [](const Vec3& x) { return x; },
            [](const Vec3& x) {
              return Vec3{0, curvature / 100 * (x.x - 2.5), 0};
            });
      // The mean rotation is zero, and with it the shear. Plane strain across: the stress along is 2/sqrt(3)
      // of the yield stress.
      double moment = 0;
      for (Index i = 0; i < 4; ++i)
        if (body.domain.nodes.position[i].x > 2) moment += body.moment(i).y;
      const math::Quadrature rule = math::trapezoid_rule(points);
      double factor = 0;
      for (int p = 0; p < points; ++p) factor += rule.weight[p] * std::fabs(rule.point[p]);
      const double expected = 2 / std::sqrt(3.0) * 250 * 5 * thickness * thickness / 2 * factor;
      test::verified(std::string(kind.name) + ", trapezoidal rule of " + std::to_string(points) +
                         " points: plastic moment over exact",
                     "sum of weight times place")
          .near(std::fabs(moment) / expected, 1, 0.02);
      EXPECT_NEAR(factor, 0.5, 0.6 / (points - 1));
    }
}

}  // namespace
}  // namespace crumple::elements::testing::node_place_test
