// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "cellsearch/array.hpp"

namespace cellsearch {

/// Sorts numbers ascending, 11 bits at a time from the lowest; digits that all numbers have in common are
/// skipped. O(numbers). `scratch` is overwritten.
inline void radix_sort(Array<std::uint64_t>& numbers, Array<std::uint64_t>& scratch) {
  constexpr int bits = 11;
  constexpr std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  if (numbers.empty()) return;
  std::uint64_t differing = 0;
  for (const std::uint64_t number : numbers) differing |= number ^ numbers[0];
  scratch.resize(numbers.size());
  for (int shift = 0; shift < 64; shift += bits) {
    if (((differing >> shift) & mask) == 0) continue;
    std::array<std::size_t, mask + 1> begins{};
    for (const std::uint64_t number : numbers) ++begins[(number >> shift) & mask];
    std::size_t place = 0;
    for (std::size_t& begin : begins) place += std::exchange(begin, place);
    for (const std::uint64_t number : numbers) scratch[begins[(number >> shift) & mask]++] = number;
    std::swap(numbers, scratch);
  }
}

}  // namespace cellsearch
