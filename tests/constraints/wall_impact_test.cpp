// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/wall_impact.hpp"
#include "support/larger.hpp"
#include "support/verified.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace crumple::constraints::wall_impact_test {
namespace {

/// A mass that takes no push from a wall slower than its limit.
struct Mass {
  double mass = 0;
  double limit = 0;
};

std::function<double(double)> impulse_of(const std::vector<Mass>& masses) {
  return [&masses](double velocity) {
    double sum = 0;
    for (const Mass& m : masses) sum += m.mass * std::max(0.0, velocity - m.limit);
    return sum;
  };
}

/// The same by looking again and again which masses are pushed.
double by_sets(double mass, double velocity, const std::vector<Mass>& masses) {
  double common = velocity;
  for (std::size_t round = 0; round <= masses.size(); ++round) {
    double sum = mass;
    double momentum = mass * velocity;
    for (const Mass& m : masses)
      if (m.limit < common) {
        sum += m.mass;
        momentum += m.mass * m.limit;
      }
    common = momentum / sum;
  }
  return common;
}

TEST(CommonVelocity, IsThatOfTheCommonMomentum) {
  const std::vector<Mass> masses = {{2, 0}, {1, -3}};
  EXPECT_DOUBLE_EQ(common_velocity({5, 4}, impulse_of(masses)), (5 * 4 - 3) / 8.0);
}

TEST(CommonVelocity, StaysWithoutAnythingToPush) {
  EXPECT_EQ(common_velocity({5, 4}, [](double) { return 0.0; }), 4);
  const std::vector<Mass> masses = {{2, 4.5}};
  EXPECT_EQ(common_velocity({5, 4}, impulse_of(masses)), 4);
}

TEST(CommonVelocity, DoesNotPullWhatIsFasterAtTheEnd) {
  // Both are slower than the wall, but the heavy one stops it below the light one.
  const std::vector<Mass> masses = {{100, 0}, {1, 3}};
  EXPECT_DOUBLE_EQ(common_velocity({1, 4}, impulse_of(masses)), 4 / 101.0);
}

TEST(CommonVelocity, IsNotAboveWhatAnObstacleAllows) {
  const std::vector<Mass> masses = {{2, 0}};
  EXPECT_EQ(common_velocity({2, 4, -1, 0.5}, impulse_of(masses)), 0.5);
  EXPECT_DOUBLE_EQ(common_velocity({2, 4, -1, 3}, impulse_of(masses)), 2);
}

TEST(CommonVelocity, AHugeMassKeepsItsOwn) {
  const std::vector<Mass> masses = {{2, 0}, {3, -7}};
  EXPECT_EQ(common_velocity({1e30, 4}, impulse_of(masses)), 4);
}

TEST(CommonVelocity, OfAMoteIsThatOfWhatItHits) {
  const std::vector<Mass> masses = {{0.007, -1}, {3, 2}};
  for (const double mass : {1e-12, 1e-9, 1e-6}) {
    const double exact = (mass * 15 - 0.007) / (mass + 0.007);
    std::array<char, 8> size{};
    std::snprintf(size.data(), size.size(), "%.0e", mass);
    test::verified(std::string("wall of mass ") + size.data() + " meets two masses: common velocity",
                   "conservation of momentum")
        .near(common_velocity({mass, 15}, impulse_of(masses)), exact, 1e-14);
    EXPECT_NEAR(common_velocity({mass, 15, -1}, impulse_of(masses)), exact, 1e-14);
  }
}

TEST(CommonVelocity, OfManyMassesIsThatOfTheSetThatIsPushed) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst = 0;
  for (int sample = 0; sample < 500; ++sample) {
    std::vector<Mass> masses(1 + static_cast<std::size_t>(200 * unit(random)));
    for (Mass& m : masses) m = {unit(random), 2 * unit(random) - 1};
    const double mass = std::pow(10, 8 * unit(random) - 4);
    const double velocity = 2 * unit(random) - 0.5;
    const double found = common_velocity({mass, velocity}, impulse_of(masses));
    worst = test::larger_of(worst, std::fabs(found - by_sets(mass, velocity, masses)));
  }
  test::verified("wall meets up to 200 masses, 500 samples: common velocity, error",
                 "the set that is pushed, by trial")
      .below(worst, 1e-14);
}

}  // namespace
}  // namespace crumple::constraints::wall_impact_test
