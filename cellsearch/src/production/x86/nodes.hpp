// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "production/kernels.hpp"
#include "production/x86/lanes.hpp"

namespace cellsearch::production {
namespace {

/// Loops over nodes: their range, their cells, their places.
template <InstructionSet Set>
struct NodeLoops {
  /// Bounding box of positions, and whether all are finite.
  struct Range {
    __m256d lo = _mm256_set1_pd(std::numeric_limits<double>::infinity());
    __m256d hi = _mm256_set1_pd(-std::numeric_limits<double>::infinity());
    __m256d zero = _mm256_setzero_pd();  ///< as long as all numbers are finite

    void include(__m256d xyz) {
      lo = _mm256_min_pd(lo, xyz);
      hi = _mm256_max_pd(hi, xyz);
      zero = _mm256_fmadd_pd(xyz, _mm256_setzero_pd(), zero);
    }

    NodeRange result() const {
      alignas(32) double low[4];
      alignas(32) double high[4];
      _mm256_store_pd(low, lo);
      _mm256_store_pd(high, hi);
      NodeRange range;
      range.box.lo = {low[0], low[1], low[2]};
      range.box.hi = {high[0], high[1], high[2]};
      range.finite = _mm256_movemask_pd(_mm256_cmp_pd(zero, zero, _CMP_UNORD_Q)) == 0;
      return range;
    }
  };

  static NodeRange measure(const Positions& positions, Index begin, Index end) {
    Range range;
    for (Index node = begin; node < end; ++node) range.include(load_position(positions[node]));
    return range.result();
  }

  static std::uint32_t largest(std::span<const Index> numbers) {
    __m256i most = _mm256_setzero_si256();
    std::size_t i = 0;
    for (; i + 8 <= numbers.size(); i += 8) {
      const void* at = numbers.data() + i;
      most = _mm256_max_epu32(most, _mm256_loadu_si256(static_cast<const __m256i*>(at)));
    }
    alignas(32) std::uint32_t lanes[8];
    _mm256_store_si256(static_cast<__m256i*>(static_cast<void*>(lanes)), most);
    std::uint32_t result = 0;
    for (const std::uint32_t lane : lanes) result = lane > result ? lane : result;
    for (; i < numbers.size(); ++i) {
      const std::uint32_t number = static_cast<std::uint32_t>(numbers[i]);
      result = number > result ? number : result;
    }
    return result;
  }

  static NodeRange classify(const SortInput& input, Index begin, Index end, std::uint32_t* counts) {
    Range range;
    const GridLanes<Set> grid(input.grid);
    const __m256d scale = _mm256_load_pd(input.grid.scale.data());
    const __m256d offset = _mm256_load_pd(input.grid.offset.data());
    const __m256d limit = _mm256_set1_pd(lattice_limit);
    const __m256d low_limit = _mm256_set1_pd(-lattice_limit);
    for (Index node = begin; node < end; ++node) {
      const __m256d xyz = load_position(input.positions[node]);
      range.include(xyz);
      const __m256d place = _mm256_fmadd_pd(xyz, scale, offset);
      const __m128i fine = _mm256_cvttpd_epi32(_mm256_max_pd(_mm256_min_pd(place, limit), low_limit));
      const __m128i number = grid.number(grid.cells(grid.clamp(fine)));
      store4(input.records + node, _mm_blend_epi32(fine, number, 8));
      if (counts != nullptr) ++counts[static_cast<std::uint32_t>(_mm_cvtsi128_si32(number))];
    }
    return range.result();
  }

  static void place(const SortInput& input, const SortOutput& output, Index begin, Index end,
                    std::uint32_t* next) {
    const GridLanes<Set> grid(input.grid);
    std::uint8_t* const x = output.x;
    std::uint8_t* const y = output.y;
    std::uint8_t* const z = output.z;
    Index* const nodes = output.nodes;
    NodeRecord* const records = input.records;
    for (Index node = begin; node < end; ++node) {
      const std::uint32_t cell = records[node].place;
      if (cell == no_place) continue;
      const std::uint32_t at = next[cell]++;
      const __m128i fine = _mm_srli_epi32(grid.clamp(load4(records + node)), fine_bits);
      x[at] = static_cast<std::uint8_t>(_mm_extract_epi8(fine, 0));
      y[at] = static_cast<std::uint8_t>(_mm_extract_epi8(fine, 4));
      z[at] = static_cast<std::uint8_t>(_mm_extract_epi8(fine, 8));
      nodes[at] = node;
      records[node].place = at;
    }
  }
};

}  // namespace
}  // namespace cellsearch::production
