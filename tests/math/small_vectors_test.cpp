// SPDX-License-Identifier: BSD-3-Clause
#include "math/small_vectors.hpp"

#include <gtest/gtest.h>

namespace crumple::math::small_vectors_test {
namespace {

TEST(SmallVectors, TransposeIsATranspose) {
  const auto f =
      transposed(Float4{0, 1, 2, 3}, Float4{10, 11, 12, 13}, Float4{20, 21, 22, 23}, Float4{30, 31, 32, 33});
  const auto d = transposed(Double4{0, 1, 2, 3}, Double4{10, 11, 12, 13}, Double4{20, 21, 22, 23},
                            Double4{30, 31, 32, 33});
  const auto f8 = transposed(Float8{0, 1, 2, 3, 4, 5, 6, 7}, Float8{10, 11, 12, 13, 14, 15, 16, 17},
                             Float8{20, 21, 22, 23, 24, 25, 26, 27}, Float8{30, 31, 32, 33, 34, 35, 36, 37});
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      EXPECT_EQ(f.row[row][column], 10.0F * static_cast<float>(column) + static_cast<float>(row));
      EXPECT_EQ(d.row[row][column], 10.0 * column + row);
      EXPECT_EQ(f8.row[row][column], f.row[row][column]);
      EXPECT_EQ(f8.row[row][4 + column], f.row[row][column] + 4);
    }
}

}  // namespace
}  // namespace crumple::math::small_vectors_test
