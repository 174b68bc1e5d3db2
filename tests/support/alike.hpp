// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/isa.hpp"

namespace crumple::test {

/// Instruction sets that round alike must give the same bits: scalar and baseline, AVX2 and AVX-512. `found`:
/// the result of each of available_isas(); `same`: whether two of them are equal. Pairs of which the build or
/// the processor lacks one are left out.
template <class Found, class Same>
void expect_alike(const std::vector<Found>& found, const Same& same) {
  const std::vector<Isa> isas = available_isas();
  ASSERT_EQ(found.size(), isas.size());
  constexpr std::array<std::pair<Isa, Isa>, 2> pairs{
      {{Isa::Scalar, Isa::Baseline}, {Isa::Avx2, Isa::Avx512}}};
  for (const auto& [first, second] : pairs) {
    const auto a = std::ranges::find(isas, first);
    const auto b = std::ranges::find(isas, second);
    if (a == isas.end() || b == isas.end()) continue;
    EXPECT_TRUE(same(found[a - isas.begin()], found[b - isas.begin()]))
        << isa_name(first) << " and " << isa_name(second);
  }
}

}  // namespace crumple::test
