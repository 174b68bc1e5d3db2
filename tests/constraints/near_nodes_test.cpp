// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/near_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace crumple::constraints::near_nodes_test {
namespace {

/// Nodes above a surface, which come and go at speeds that change all the time.
class NearNodesTest : public ::testing::Test {
 protected:
  static constexpr Index count = 200;

  NearNodesTest() : nodes_(count), height_(count), velocity_(count) {
    std::iota(nodes_.begin(), nodes_.end(), 0);
    std::uniform_real_distribution<double> anywhere(0, 50);
    for (double& height : height_) height = anywhere(random_);
  }

  /// One step; returns how many nodes were looked at.
  std::size_t step(double speed) {
    std::uniform_real_distribution<double> either_way(-speed, speed);
    for (double& velocity : velocity_) velocity = either_way(random_);
    double fastest = 0;
    for (const double velocity : velocity_) fastest = std::max(fastest, std::fabs(velocity));
    const auto near = near_.find(nodes_, fastest, [&](Index node) { return height_[node]; });
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
    for (Index node = 0; node < count; ++node) {
      height_[node] += velocity_[node];
      if (height_[node] >= 0) continue;
      EXPECT_TRUE(std::binary_search(near.begin(), near.end(), node)) << node;
      ++arrivals_;
      height_[node] = 0;
    }
    return near.size();
  }

  std::mt19937 random_{7};
  std::vector<Index> nodes_;
  std::vector<double> height_;
  std::vector<double> velocity_;
  NearNodes near_;
  int arrivals_ = 0;
};

TEST_F(NearNodesTest, MissesNoArrival) {
  for (int cycle = 0; cycle < 3000; ++cycle) step(cycle % 500 < 250 ? 0.01 : 0.4);
  EXPECT_GT(arrivals_, 1000);
}

TEST_F(NearNodesTest, LooksAtFewWhereMostAreFar) {
  std::size_t looks = 0;
  for (int cycle = 0; cycle < 500; ++cycle) looks += step(0.01);
  EXPECT_LT(looks, 500 * count / 20);
}

TEST_F(NearNodesTest, LooksAtAllWhereNothingIsKnownOfTheMotion) {
  const auto height = [&](Index node) { return height_[node]; };
  EXPECT_EQ(near_.find(nodes_, std::numeric_limits<double>::infinity(), height).size(), nodes_.size());
  EXPECT_EQ(near_.find(nodes_, std::numeric_limits<double>::quiet_NaN(), height).size(), nodes_.size());
  EXPECT_LT(near_.find(nodes_, 0.001, height).size(), nodes_.size());
}

TEST_F(NearNodesTest, ForgetsWhereNodesWere) {
  const auto height = [&](Index node) { return height_[node]; };
  std::fill(height_.begin(), height_.end(), 10.0);
  EXPECT_EQ(near_.find(nodes_, 0.001, height).size(), 0U);
  height_[5] = 0;
  near_.forget();
  const auto near = near_.find(nodes_, 0.001, height);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0], 5);
}

}  // namespace
}  // namespace crumple::constraints::near_nodes_test
