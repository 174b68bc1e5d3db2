// SPDX-License-Identifier: BSD-3-Clause
// The loop of MotionTracker in every instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "cellsearch/instruction_set.hpp"
#include "production/kernels.hpp"
#include "scenes.hpp"

namespace cellsearch::motion_range_test {
namespace {

std::vector<double> random_points(int count, std::uint64_t seed) {
  scenes::Random random(seed);
  std::vector<double> points(3 * static_cast<std::size_t>(count));
  for (double& x : points) x = random.uniform(-5.0, 5.0);
  return points;
}

/// What every instruction set has to find.
production::ValueRange plain_range(const std::vector<double>& now, const double* then) {
  production::ValueRange range;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const double value = then == nullptr ? now[i] : now[i] - then[i];
    range.lo[i % 3] = std::min(range.lo[i % 3], value);
    range.hi[i % 3] = std::max(range.hi[i % 3], value);
  }
  return range;
}

TEST(MotionRange, IsTheSameWithEveryInstructionSet) {
  for (const InstructionSet set : instruction_sets()) {
    const production::Kernels& kernels = production::kernels(set);
    for (int nodes = 0; nodes < 30; ++nodes) {
      const std::vector<double> now = random_points(nodes, 7);
      const std::vector<double> then = random_points(nodes, 8);
      for (const double* start : {static_cast<const double*>(nullptr), then.data()}) {
        const production::ValueRange expected = plain_range(now, start);
        production::ValueRange found;
        kernels.include(now.data(), start, static_cast<std::size_t>(nodes), found);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_EQ(found.lo[axis], expected.lo[axis]) << name_of(set) << ", " << nodes << " nodes";
          EXPECT_EQ(found.hi[axis], expected.hi[axis]) << name_of(set) << ", " << nodes << " nodes";
        }
        EXPECT_FALSE(found.bad);
      }
    }
  }
}

TEST(MotionRange, NoticesEveryNumberThatIsNotFinite) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const InstructionSet set : instruction_sets()) {
    for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
      for (std::size_t place = 0; place < 3 * 11; ++place) {
        std::vector<double> now = random_points(11, 9);
        now[place] = wrong;
        production::ValueRange found;
        production::kernels(set).include(now.data(), nullptr, 11, found);
        EXPECT_TRUE(found.bad) << name_of(set) << ", " << wrong << " at " << place;
      }
    }
  }
}

}  // namespace
}  // namespace cellsearch::motion_range_test
