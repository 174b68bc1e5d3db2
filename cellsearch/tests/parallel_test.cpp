// SPDX-License-Identifier: BSD-3-Clause
#include "parallel.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace cellsearch::parallel_test {
namespace {

TEST(ForBlocks, CallsEachBlockOnce) {
  for (const int threads : {1, 2, 4, 7}) {
    for (const int blocks : {0, 1, 3, 64}) {
      std::vector<int> calls(static_cast<std::size_t>(blocks), 0);
      for_blocks(threads, blocks, [&](int block) { ++calls[static_cast<std::size_t>(block)]; });
      EXPECT_EQ(calls, std::vector<int>(static_cast<std::size_t>(blocks), 1));
    }
  }
}

TEST(ForBlocks, PassesOnWhatTheLowestBlockThrows) {
  for (const int threads : {1, 4}) {
    try {
      for_blocks(threads, 32, [](int block) {
        if (block % 10 == 7) throw std::runtime_error(std::to_string(block));
      });
      FAIL() << "no error";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "7");
    }
  }
}

TEST(BlockRange, CoversEverythingOnce) {
  for (const Index count : {0, 1, 5, 64, 1000, std::numeric_limits<Index>::max()}) {
    Index next = 0;
    for (int block = 0; block < 64; ++block) {
      const BlockRange range(count, block, 64);
      EXPECT_EQ(range.begin, next);
      EXPECT_LE(range.begin, range.end);
      next = range.end;
    }
    EXPECT_EQ(next, count);
  }
}

}  // namespace
}  // namespace cellsearch::parallel_test
