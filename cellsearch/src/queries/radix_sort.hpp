// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace cellsearch {

/// Sorts things by key_of(thing), a 64-bit number, ascending; equal ones keep their order. 11 bits at a time
/// from the lowest; digits that all keys have in common are skipped. O(things). `scratch` has the same length
/// and is overwritten.
template <class Thing, class KeyOf>
void radix_sort(std::span<Thing> things, std::span<Thing> scratch, const KeyOf& key_of) {
  constexpr int bits = 11;
  constexpr std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  if (things.empty()) return;
  std::uint64_t differing = 0;
  const std::uint64_t first = key_of(things[0]);
  for (const Thing& thing : things) differing |= key_of(thing) ^ first;
  std::span<Thing> from = things;
  std::span<Thing> to = scratch;
  for (int shift = 0; shift < 64; shift += bits) {
    if (((differing >> shift) & mask) == 0) continue;
    std::array<std::size_t, mask + 1> begins{};
    for (const Thing& thing : from) ++begins[(key_of(thing) >> shift) & mask];
    std::size_t place = 0;
    for (std::size_t& begin : begins) place += std::exchange(begin, place);
    for (const Thing& thing : from) to[begins[(key_of(thing) >> shift) & mask]++] = thing;
    std::swap(from, to);
  }
  if (from.data() != things.data()) std::copy(from.begin(), from.end(), things.begin());
}

}  // namespace cellsearch
