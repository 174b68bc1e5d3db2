// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "production/batch.hpp"
#include "production/kernels.hpp"
#include "production/x86/hits.hpp"
#include "production/x86/lanes.hpp"

namespace cellsearch::production {
namespace {

/// Loop 6 of a query: the rows of the result, ascending.
template <InstructionSet Set>
struct RowLoop {
  template <int Upper>
  static __m256i exchange(__m256i v, __m256i other) {
    return _mm256_blend_epi32(_mm256_min_epi32(v, other), _mm256_max_epi32(v, other), Upper);
  }

  /// Sorts two numbers that ascend and then descend ..., step by step: the last three steps of a network for
  /// eight.
  static __m256i merge8(__m256i v) {
    v = exchange<0b11110000>(v, _mm256_permute2x128_si256(v, v, 1));
    v = exchange<0b11001100>(v, _mm256_shuffle_epi32(v, 0x4e));
    return exchange<0b10101010>(v, _mm256_shuffle_epi32(v, 0xb1));
  }

  static __m256i reversed(__m256i v) {
    return _mm256_permutevar8x32_epi32(v, _mm256_setr_epi32(7, 6, 5, 4, 3, 2, 1, 0));
  }

  /// Sorts the first four of eight numbers, and the second four.
  static __m256i sort4(__m256i v) {
    v = exchange<0b10101010>(v, _mm256_shuffle_epi32(v, 0xb1));
    v = exchange<0b11001100>(v, _mm256_shuffle_epi32(v, 0x1b));
    return exchange<0b10101010>(v, _mm256_shuffle_epi32(v, 0xb1));
  }

  static __m256i sort8(__m256i v) {
    v = sort4(v);
    v = exchange<0b11110000>(v, reversed(v));
    v = exchange<0b11001100>(v, _mm256_shuffle_epi32(v, 0x4e));
    return exchange<0b10101010>(v, _mm256_shuffle_epi32(v, 0xb1));
  }

  static __m256i load8(const Index* from) {
    return _mm256_loadu_si256(static_cast<const __m256i*>(static_cast<const void*>(from)));
  }

  static void store8(Index* to, __m256i v) {
    _mm256_storeu_si256(static_cast<__m256i*>(static_cast<void*>(to)), v);
  }

  /// Nodes among eight numbers, the rest being no_node.
  static int nodes_of(__m256i v) {
    const __m256i is_node = _mm256_cmpgt_epi32(_mm256_set1_epi32(no_node), v);
    return _mm_popcnt_u32(static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(is_node))));
  }

  /// Writes a row of more than eight hits; returns its length.
  [[gnu::noinline]] static int write_long_row(const Index* from, std::uint32_t found, Index* to) {
    if (found > 16) {
      int kept = 0;
      for (std::uint32_t i = 0; i < found; ++i) {
        to[kept] = from[i];
        kept += from[i] != no_node ? 1 : 0;
      }
      sort_row(to, to + kept);
      return kept;
    }
    const __m256i number = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256i valid = _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int>(found) - 8), number);
    const __m256i second = _mm256_blendv_epi8(_mm256_set1_epi32(no_node), load8(from + 8), valid);
    const __m256i one = sort8(load8(from));
    const __m256i other = reversed(sort8(second));
    const __m256i low = merge8(_mm256_min_epi32(one, other));
    const __m256i high = merge8(_mm256_max_epi32(one, other));
    store8(to, low);
    store8(to + 8, high);
    return nodes_of(low) + nodes_of(high);
  }

  /// Loop 6: the rows, ascending. Refused hits are the largest numbers and end behind the row. `few`: nearly
  /// all rows have at most four.
  template <bool Few>
  [[gnu::noinline]] static Index* write_rows(Index count, const Batch& batch,
                                             const typename HitLoops<Set>::Hits& hits, Index* to,
                                             Offset before, Offset* ends) {
    const Index* const start = to;
    const __m256i number = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256i none = _mm256_set1_epi32(no_node);
    std::uint32_t at = 0;
    for (Index j = 0; j < count; ++j) {
      const std::uint32_t end = batch.ends[static_cast<std::size_t>(j)];
      const std::uint32_t found = end - at;
      const Index* const from = hits.node.data() + at;
      if (found > 8) [[unlikely]] {
        to += write_long_row(from, found, to);
      } else {
        const __m256i valid = _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int>(found)), number);
        const __m256i loaded = _mm256_blendv_epi8(none, load8(from), valid);
        __m256i sorted = sort4(loaded);
        if (!Few || found > 4) {
          sorted = exchange<0b11110000>(sorted, reversed(sorted));
          sorted = exchange<0b11001100>(sorted, _mm256_shuffle_epi32(sorted, 0x4e));
          sorted = exchange<0b10101010>(sorted, _mm256_shuffle_epi32(sorted, 0xb1));
        }
        store8(to, sorted);
        to += nodes_of(sorted);
      }
      ends[j] = before + (to - start);
      at = end;
    }
    return to;
  }
};

}  // namespace
}  // namespace cellsearch::production
