// SPDX-License-Identifier: BSD-3-Clause
// The packs of this program's own instruction set against plain numbers, lane by lane. The kernels' variants
// are compared with each other in tests/materials and tests/elements.
#include "base/pack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace crumple::pack_test {
namespace {

template <class Pack>
class Packs : public ::testing::Test {
 protected:
  using Real = RealOf<Pack>;
  static constexpr int width = width_of<Pack>;

  struct Numbers {
    alignas(64) Real at[width];
  };
  Numbers random() {
    Numbers n;
    for (Real& x : n.at) x = static_cast<Real>(uniform_(generator_));
    return n;
  }
  static Numbers stored(const Pack& pack) {
    Numbers n;
    store(n.at, pack);
    return n;
  }

 private:
  std::mt19937 generator_{17};
  std::uniform_real_distribution<double> uniform_{-3, 3};
};

using AllPacks = ::testing::Types<float, double, simd::native_simd<float>, simd::native_simd<double>>;
TYPED_TEST_SUITE(Packs, AllPacks);

TYPED_TEST(Packs, ComputeEveryLaneAsANumber) {
  for (int run = 0; run < 100; ++run) {
    const auto a = this->random();
    const auto b = this->random();
    const auto c = this->random();
    const auto pa = load<TypeParam>(a.at);
    const auto pb = load<TypeParam>(b.at);
    const auto pc = load<TypeParam>(c.at);
    const auto fused = this->stored(multiply_add(pa, pb, pc));
    const auto root = this->stored(square_root(absolute(pa)));
    const auto large = this->stored(larger(pa, pb));
    const auto small = this->stored(smaller(pa, pb));
    const auto chosen = this->stored(select<TypeParam>(pa > pb, pb, pc));
    bool some = false;
    for (int i = 0; i < this->width; ++i) {
      EXPECT_EQ(fused.at[i], multiply_add<RealOf<TypeParam>>(a.at[i], b.at[i], c.at[i]));
      EXPECT_EQ(root.at[i], std::sqrt(std::fabs(a.at[i])));
      EXPECT_EQ(large.at[i], std::max(a.at[i], b.at[i]));
      EXPECT_EQ(small.at[i], std::min(a.at[i], b.at[i]));
      EXPECT_EQ(chosen.at[i], a.at[i] > b.at[i] ? b.at[i] : c.at[i]);
      some = some || a.at[i] > b.at[i];
    }
    EXPECT_EQ(any<TypeParam>(pa > pb), some);
  }
}

}  // namespace
}  // namespace crumple::pack_test
