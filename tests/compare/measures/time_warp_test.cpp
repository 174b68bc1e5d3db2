// SPDX-License-Identifier: BSD-3-Clause
#include "compare/measures/time_warp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace crumple::compare::time_warp_test {
namespace {

using Path = std::vector<std::pair<std::size_t, std::size_t>>;

double cost(const Path& path, const std::vector<double>& first, const std::vector<double>& second) {
  double sum = 0;
  for (const auto& [i, j] : path) sum += std::pow(first[i] - second[j], 2);
  return sum;
}

TEST(WarpingPath, OfIdenticalCurvesIsStraight) {
  const std::vector<double> curve = {0, 1, 3, 2, 5};
  EXPECT_EQ(warping_path(curve, curve, 3), (Path{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}}));
}

TEST(WarpingPath, StretchesAndSqueezes) {
  // The peak of the second comes a sample later: it is matched by waiting before and hurrying after.
  const std::vector<double> first = {0, 0, 4, 0, 0};
  const std::vector<double> second = {0, 0, 0, 4, 0};
  const Path path = warping_path(first, second, 2);
  EXPECT_EQ(cost(path, first, second), 0);
  EXPECT_NE(std::find(path.begin(), path.end(), std::pair<std::size_t, std::size_t>(2, 3)), path.end());
}

TEST(WarpingPath, TheBandLimitsIt) {
  const std::vector<double> first = {0, 4, 0, 0, 0, 0};
  const std::vector<double> second = {0, 0, 0, 0, 4, 0};
  for (const auto& [i, j] : warping_path(first, second, 2)) EXPECT_LT(std::max(i, j) - std::min(i, j), 2U);
  EXPECT_GT(cost(warping_path(first, second, 2), first, second), 0);
  EXPECT_EQ(cost(warping_path(first, second, 4), first, second), 0);
}

/// The cheapest cost by trying all ways.
double cheapest(const std::vector<double>& first, const std::vector<double>& second, std::size_t band) {
  const std::function<double(std::size_t, std::size_t)> from = [&](std::size_t i, std::size_t j) {
    if (std::max(i, j) - std::min(i, j) >= band) return std::numeric_limits<double>::infinity();
    double rest = std::numeric_limits<double>::infinity();
    if (i == 0 && j == 0) rest = 0;
    if (i > 0) rest = std::min(rest, from(i - 1, j));
    if (j > 0) rest = std::min(rest, from(i, j - 1));
    if (i > 0 && j > 0) rest = std::min(rest, from(i - 1, j - 1));
    return rest + std::pow(first[i] - second[j], 2);
  };
  return from(first.size() - 1, second.size() - 1);
}

TEST(WarpingPath, IsTheCheapestOfAll) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> values(-1, 1);
  for (int round = 0; round < 20; ++round) {
    std::vector<double> first(7);
    std::vector<double> second(7);
    for (double& value : first) value = values(random);
    for (double& value : second) value = values(random);
    for (const std::size_t band : {1U, 2U, 4U, 7U}) {
      const Path path = warping_path(first, second, band);
      EXPECT_NEAR(cost(path, first, second), cheapest(first, second, band), 1e-12);
      for (std::size_t step = 1; step < path.size(); ++step) {
        EXPECT_LE(path[step].first - path[step - 1].first, 1U);
        EXPECT_LE(path[step].second - path[step - 1].second, 1U);
      }
    }
  }
}

TEST(WarpingPath, OneSample) {
  EXPECT_EQ(warping_path(std::vector<double>{1}, std::vector<double>{5}, 0), (Path{{0, 0}}));
}

}  // namespace
}  // namespace crumple::compare::time_warp_test
