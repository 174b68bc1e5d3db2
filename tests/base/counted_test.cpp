// SPDX-License-Identifier: BSD-3-Clause
#include "base/counted.hpp"

#include <gtest/gtest.h>

namespace crumple::counted_test {
namespace {

TEST(Counted, OnlyOneIsSingular) {
  EXPECT_EQ(counted(0, "error"), "0 errors");
  EXPECT_EQ(counted(1, "error"), "1 error");
  EXPECT_EQ(counted(std::size_t{1}, "pair"), "1 pair");
  EXPECT_EQ(counted(21, "pair"), "21 pairs");
}

}  // namespace
}  // namespace crumple::counted_test
