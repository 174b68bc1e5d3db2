// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/linear_equations.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "support/verified.hpp"

namespace crumple::constraints::linear_equations_test {
namespace {

using math::Vec3;

/// Four nodes of masses 1 to 4 and rotary inertias of half of it.
class LinearEquationsTest : public ::testing::Test {
 protected:
  LinearEquationsTest() {
    domain::NodeFields& nodes = domain_.nodes;
    nodes.position.assign(4, Vec3{});
    nodes.velocity.assign(4, Vec3{});
    nodes.angular_velocity.assign(4, Vec3{});
    nodes.mass.assign(4, 1.0);
    nodes.inertia.assign(4, 0.5);
    nodes.fixed.assign(4, 0);
    for (Index i = 0; i < 4; ++i) {
      nodes.mass[i] = 1.0 + i;
      nodes.inertia[i] = 0.5 * nodes.mass[i];
      nodes.domain_node.push_back(i);
    }
  }
  double momentum_x() const {
    double sum = 0;
    for (Index i = 0; i < 4; ++i) sum += domain_.nodes.mass[i] * domain_.nodes.velocity[i].x;
    return sum;
  }
  void add(std::vector<model::LinearEquation::Term> terms) {
    model_.linear_equations.push_back({7, std::move(terms)});
  }

  model::Model model_;
  domain::Domain domain_;
};

TEST_F(LinearEquationsTest, OneEquationPushesInProportionToFactorsOverMasses) {
  // 2 v0 - 3 v1 = 0 along x from v0 = 1 and v1 = 0: l = 2 / (4 / 1 + 9 / 2), v = (1 - 2 l, 3/2 l).
  add({{0, 0, 2}, {1, 0, -3}});
  domain_.nodes.velocity[0] = {1, 5, 0};
  const LinearEquations equations(model_, domain_);
  const double l = 2 / 8.5;
  test::verified("linear equation of two masses: velocity of the first", "by hand")
      .near(domain_.nodes.velocity[0].x, 1 - 2 * l, 1e-15);
  test::verified("linear equation of two masses: velocity of the second", "by hand")
      .near(domain_.nodes.velocity[1].x, 1.5 * l, 1e-15);
  EXPECT_EQ(domain_.nodes.velocity[0].y, 5);
}

TEST_F(LinearEquationsTest, ANodeInTheMiddleKeepsTheMomentumAndItsChainIsSolvedAtOnce) {
  // 2 is in the middle of 0 and 1, and 3 in the middle of 1 and 2.
  add({{2, 0, 1}, {0, 0, -0.5}, {1, 0, -0.5}});
  add({{3, 0, 1}, {1, 0, -0.5}, {2, 0, -0.5}});
  for (Index i = 0; i < 4; ++i) domain_.nodes.velocity[i] = {std::sin(7.0 * i + 1), 0, 0};
  const double before = momentum_x();
  LinearEquations equations(model_, domain_);
  const auto v = [&](Index i) { return domain_.nodes.velocity[i].x; };
  EXPECT_NEAR(v(2), 0.5 * (v(0) + v(1)), 1e-15);
  EXPECT_NEAR(v(3), 0.5 * (v(1) + v(2)), 1e-15);
  test::verified("chain of two nodes in the middle of others: momentum, change", "conservation")
      .below(std::fabs(momentum_x() - before), 1e-14);
  const Vec3 again = domain_.nodes.velocity[3];
  equations.constrain(domain_);
  EXPECT_NEAR(domain_.nodes.velocity[3].x, again.x, 1e-15) << "what fits is left as it is";
}

TEST_F(LinearEquationsTest, FixedDirectionsDoNotMoveAndWhatCannotMoveNeedsNoEquation) {
  add({{0, 0, 1}, {1, 0, 1}});
  add({{2, 1, 1}, {3, 1, -1}});
  domain_.nodes.fixed[0] = domain::fixed_translation(0);
  domain_.nodes.fixed[2] = domain_.nodes.fixed[3] = domain::fixed_translation(1);
  domain_.nodes.velocity[1] = {4, 0, 0};
  const LinearEquations equations(model_, domain_);
  EXPECT_EQ(domain_.nodes.velocity[0].x, 0);
  EXPECT_NEAR(domain_.nodes.velocity[1].x, 0, 1e-15);
}

TEST_F(LinearEquationsTest, RotationsAndTheirEnergy) {
  // Node 0 moves along x with the turn of node 1 about z on an arm of 2.
  add({{0, 0, 1}, {1, 5, 2}});
  LinearEquations equations(model_, domain_);
  domain_.nodes.angular_velocity[1] = {0, 0, 0.25};
  domain_.nodes.velocity[0] = {-0.5, 0, 0};
  equations.remember(domain_);
  domain_.nodes.velocity[0] = {1, 0, 0};
  const double before = 0.5 * domain_.nodes.inertia[1] * 0.25 * domain_.nodes.angular_velocity[1].z;
  const KineticChange change = equations.constrain(domain_);
  const double spin = domain_.nodes.angular_velocity[1].z;
  EXPECT_NEAR(domain_.nodes.velocity[0].x, -2 * spin, 1e-15);
  EXPECT_NEAR(change.rotational, 0.5 * domain_.nodes.inertia[1] * 0.25 * spin - before, 1e-16);
}

TEST_F(LinearEquationsTest, ThatDependOnEachOtherAreAnError) {
  add({{0, 0, 1}, {1, 0, 1}});
  add({{0, 0, 2}, {1, 0, 2}});
  EXPECT_THROW(LinearEquations(model_, domain_), Error);
}

}  // namespace
}  // namespace crumple::constraints::linear_equations_test
