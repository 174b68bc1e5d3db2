// SPDX-License-Identifier: BSD-3-Clause
#include "base/aligned_array.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

namespace crumple::aligned_array_test {
namespace {

std::uintptr_t address(const void* of) {
  return reinterpret_cast<std::uintptr_t>(of);
}

TEST(AlignedArray, BeginsACacheLineAndIfLargeAHugePage) {
  const AlignedArray<float> small(17);
  EXPECT_EQ(address(small.data()) % cache_line, 0U);
  const AlignedArray<float> large(huge_page / sizeof(float));
  EXPECT_EQ(address(large.data()) % huge_page, 0U);
}

TEST(AlignedArray, KeepsItsNumbersWhenItGrowsIntoHugePages) {
  AlignedArray<double> array(huge_page / sizeof(double) / 4);
  std::iota(array.begin(), array.end(), 0.0);
  const std::size_t before = array.size();
  array.resize(8 * before, -1.0);
  for (std::size_t i = 0; i < before; ++i) ASSERT_EQ(array[i], static_cast<double>(i));
  EXPECT_EQ(array.back(), -1.0);
  array.resize(3);
  array.shrink_to_fit();
  EXPECT_EQ(array[2], 2.0);
}

}  // namespace
}  // namespace crumple::aligned_array_test
