// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "production/batch.hpp"
#include "production/kernels.hpp"
#include "production/x86/lanes.hpp"

namespace cellsearch::production {
namespace {

/// Loops 3, 4 and 5 of a query: which nodes of the runs are inside.
template <InstructionSet Set>
struct HitLoops {
  /// 16 sorted coordinates of each of two runs.
  static __m256i two_runs(const std::uint8_t* from, std::uint32_t first, std::uint32_t second) {
    const auto at = [&](std::uint32_t place) {
      return _mm_loadu_si128(static_cast<const __m128i*>(static_cast<const void*>(from + place)));
    };
    return _mm256_inserti128_si256(_mm256_castsi128_si256(at(first)), at(second), 1);
  }

  /// Bit for each of the 32 nodes of two runs that is inside in all three coordinates. `lengths`: of the run
  /// that each byte belongs to.
  static std::uint32_t inside(const NodeTable& table, const Entry& entry, std::size_t run,
                              const __m256i (&lo)[3], const __m256i (&width)[3], __m256i lengths) {
    const __m256i number = _mm256_setr_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3,
                                            4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const std::uint32_t first = entry.first[run];
    const std::uint32_t second = entry.first[run + 1];
    // One subtraction modulo 256 and one comparison serve both faces.
    const __m256i x = _mm256_sub_epi8(two_runs(table.x, first, second), lo[0]);
    const __m256i y = _mm256_sub_epi8(two_runs(table.y, first, second), lo[1]);
    const __m256i z = _mm256_sub_epi8(two_runs(table.z, first, second), lo[2]);
#ifdef __AVX512BW__
    if constexpr (Set == InstructionSet::Avx512) {
      const __mmask32 in_x =
          _mm256_mask_cmple_epu8_mask(_mm256_cmpgt_epi8_mask(lengths, number), x, width[0]);
      const __mmask32 in_y = _mm256_cmple_epu8_mask(y, width[1]);
      return _kand_mask32(in_x, _mm256_mask_cmple_epu8_mask(in_y, z, width[2]));
    }
#endif
    const __m256i beyond =
        _mm256_or_si256(_mm256_or_si256(_mm256_subs_epu8(x, width[0]), _mm256_subs_epu8(y, width[1])),
                        _mm256_subs_epu8(z, width[2]));
    const __m256i in = _mm256_cmpeq_epi8(beyond, _mm256_setzero_si256());
    return static_cast<std::uint32_t>(
        _mm256_movemask_epi8(_mm256_and_si256(in, _mm256_cmpgt_epi8(lengths, number))));
  }

  /// Loop 3: which of the 64 nodes of each entry are inside, without the segment's own.
  [[gnu::noinline]] static void test(const NodeTable& table, Batch& batch) {
    const __m256i front = _mm256_setr_epi32(0, 0, 0, 0, 0x04040404, 0x04040404, 0x04040404, 0x04040404);
    const __m256i back = _mm256_add_epi8(front, _mm256_set1_epi8(8));
    const __m128i low_halves = _mm_setr_epi8(0, 1, 4, 5, 8, 9, 12, 13, -1, -1, -1, -1, -1, -1, -1, -1);
    const __m128i one = _mm_set1_epi32(1);
    int many = 0;
    for (int e = 0; e < batch.entry_count; ++e) {
      const Entry& entry = batch.entries[static_cast<std::size_t>(e)];
      const auto lane = [](std::uint32_t value) { return _mm256_set1_epi32(static_cast<int>(value)); };
      const __m256i lo[3] = {lane(entry.lo[0]), lane(entry.lo[1]), lane(entry.lo[2])};
      const __m256i width[3] = {lane(entry.width[0]), lane(entry.width[1]), lane(entry.width[2])};
      const __m256i length = _mm256_broadcastsi128_si256(load4(entry.length.data()));
      const std::uint64_t mask =
          inside(table, entry, 0, lo, width, _mm256_shuffle_epi8(length, front)) |
          std::uint64_t{inside(table, entry, 2, lo, width, _mm256_shuffle_epi8(length, back))} << 32;
      // A shift by 32 or more, as for a node before or far behind the run, gives 0.
      const __m128i first = load4(entry.first.data());
      const auto own_bit = [&](std::uint32_t place) {
        return _mm_sllv_epi32(one, _mm_sub_epi32(_mm_set1_epi32(static_cast<int>(place)), first));
      };
      const __m128i own = _mm_or_si128(_mm_or_si128(own_bit(entry.own[0]), own_bit(entry.own[1])),
                                       _mm_or_si128(own_bit(entry.own[2]), own_bit(entry.own[3])));
      const std::uint64_t own_bits =
          static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_shuffle_epi8(own, low_halves)));
      batch.masks[static_cast<std::size_t>(e)] = mask & ~own_bits;
      many += _mm_popcnt_u64(mask & ~own_bits) > 4 ? 1 : 0;
    }
    batch.many_count = many;
  }

  /// The hits of a batch: nodes, and the segment of each.
  struct Hits {
    std::array<Index, batch_entries * entry_nodes + entry_nodes> node;
    std::array<std::uint8_t, batch_entries * entry_nodes + entry_nodes> owner;
  };

  /// What a batch and its hits are written to.
  struct Work {
    Batch& batch;
    Hits& hits;
    FoundRows& rows;
  };

  /// Adds the hits of segment `begin + j`, which is left to QueryHelp, unless they would leave no room for
  /// the entries after entry `e`: then its row is put in at the end.
  [[gnu::noinline]] static std::uint32_t add_helped(const QueryInput& input, Index begin, std::uint32_t count,
                                                    int e, Work work) {
    auto& [batch, hits, rows] = work;
    const std::size_t j =
        static_cast<std::size_t>(batch.entries[static_cast<std::size_t>(e)].owner & (needs_help - 1));
    const Offset raw_visits = rows.raw_visits;
    const Offset cell_visits = rows.cell_visits;
    input.help->collect(begin + static_cast<Index>(j), rows);
    const Index* const found = rows.spare->data();
    const std::size_t size = rows.spare->size();
    const std::size_t kept = static_cast<std::size_t>(batch.entry_count - e) * entry_nodes;
    if (count + size + kept > hits.node.size()) {
      batch.too_many[j] = true;
      // It will be collected, and counted, again.
      rows.raw_visits = raw_visits;
      rows.cell_visits = cell_visits;
      batch.any_too_many = true;
      return count;
    }
    for (std::size_t i = 0; i < size; ++i) {
      hits.node[count + i] = found[i];
      hits.owner[count + i] = static_cast<std::uint8_t>(j | is_exact);
    }
    return count + static_cast<std::uint32_t>(size);
  }

#ifdef __AVX512F__
  /// The hits of an entry with many: run by run.
  static std::uint32_t list_runs(const Index* nodes, const Entry& entry, std::uint64_t mask, std::size_t j,
                                 std::uint32_t count, Hits& hits) {
    const __m128i owner = _mm_set1_epi8(static_cast<char>(j));
    for (std::size_t run = 0; run < runs; ++run) {
      const __mmask16 inside = static_cast<__mmask16>(mask >> (run_nodes * run));
      const __m512i found = _mm512_maskz_compress_epi32(inside, _mm512_loadu_si512(nodes + entry.first[run]));
      _mm512_storeu_si512(hits.node.data() + count, found);
      _mm_storeu_si128(static_cast<__m128i*>(static_cast<void*>(hits.owner.data() + count)), owner);
      count += static_cast<std::uint32_t>(_mm_popcnt_u32(inside));
    }
    return count;
  }
#endif

  /// Loop 4: from bits to node numbers. The first `direct` of each entry are written in any case, without a
  /// branch.
  template <std::uint32_t Direct>
  [[gnu::noinline]] static std::uint32_t list_hits(const QueryInput& input, Index begin, FoundRows& rows,
                                                   Batch& batch, Hits& hits) {
    const Index* const nodes = input.table.nodes;
    const NodeRecord* const records = input.table.records;
    std::uint32_t count = 0;
    for (int e = 0; e < batch.entry_count; ++e) {
      const Entry& entry = batch.entries[static_cast<std::size_t>(e)];
      const std::size_t j = static_cast<std::size_t>(entry.owner & (needs_help - 1));
      if ((entry.owner & needs_help) != 0) [[unlikely]] {
        count = add_helped(input, begin, count, e, {batch, hits, rows});
        batch.ends[j] = count;
        continue;
      }
#ifdef __AVX512F__
      if constexpr (Set == InstructionSet::Avx512 && Direct > 4) {
        count = list_runs(nodes, entry, batch.masks[static_cast<std::size_t>(e)], j, count, hits);
        batch.ends[j] = count;
        continue;
      }
#endif
      std::uint64_t mask = batch.masks[static_cast<std::size_t>(e)];
      const std::uint32_t found = static_cast<std::uint32_t>(_mm_popcnt_u64(mask));
      const auto write = [&](std::uint32_t at) {
        const std::uint32_t bit = static_cast<std::uint32_t>(_tzcnt_u64(mask));
        const Index node = nodes[entry.base[bit >> 4] + bit];
        hits.node[count + at] = node;
        hits.owner[count + at] = static_cast<std::uint8_t>(j);
        _mm_prefetch(records + node, _MM_HINT_T0);
        mask = _blsr_u64(mask);
      };
      for (std::uint32_t at = 0; at < Direct; ++at) write(at);
      if (found > Direct) [[unlikely]] {
        for (std::uint32_t at = Direct; at < found; ++at) write(at);
      }
      count += found;
      batch.ends[j] = count;
    }
    return count;
  }

  /// A hit that is next to a face, or has more to pass than the territory.
  [[gnu::noinline]] static void look_closer(const QueryInput& input, Index begin, Hits& hits, std::uint32_t i,
                                            Index node) {
    if ((hits.owner[i] & is_exact) != 0) {
      hits.node[i] = node;
    } else if (hits.node[i] != no_node && !input.help->accepts(begin + Index{hits.owner[i]}, node)) {
      hits.node[i] = no_node;
    }
  }

  /// Loop 5: hits next to a face are looked at again, with more bits and, if need be, in double precision.
  template <bool Nested>
  [[gnu::noinline]] static void check_faces(const QueryInput& input, Index begin, std::uint32_t count,
                                            Batch& batch, Hits& hits) {
    const NodeRecord* const records = input.table.records;
    const auto both = [](const void* low, const void* high) {
      return _mm256_inserti128_si256(_mm256_castsi128_si256(load4(low)), load4(high), 1);
    };
    const auto safe_of = [&](std::int64_t grid) { return input.grids[grid].margin.data(); };
    // Once for the territory, which has been rounded outwards, and once for the node.
    const auto twice = [](__m256i margin) {
      return _mm256_add_epi32(_mm256_slli_epi32(margin, 1), _mm256_set1_epi32(2));
    };
    __m256i safe = twice(both(safe_of(0), safe_of(0)));
    const bool filtered = !input.plain;
    // One more hit than there are may be looked at: it is overwritten later or never read.
    hits.node[count] = 0;
    hits.owner[count] = 0;
    for (std::uint32_t i = 0; i < count; i += 2) {
      const std::array<Index, 2> node{hits.node[i], hits.node[i + 1]};
      const LatticeBox& one = batch.boxes[hits.owner[i] & (is_exact - 1)];
      const LatticeBox& other = batch.boxes[hits.owner[i + 1] & (is_exact - 1)];
      const __m256i fine = both(records + node[0], records + node[1]);
      const __m256i above = _mm256_sub_epi32(fine, both(one.lo.data(), other.lo.data()));
      const __m256i below = _mm256_sub_epi32(both(one.hi.data(), other.hi.data()), fine);
      const __m256i nearest = _mm256_min_epi32(above, below);
      if constexpr (Nested) safe = twice(both(safe_of(one.grid), safe_of(other.grid)));
      const auto signs = [](__m256i lanes) {
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(lanes)));
      };
      // Nodes that only the eight bits took for inside are frequent enough to make a branch costly.
      const unsigned outside = signs(nearest);
      const unsigned inside = signs(_mm256_cmpgt_epi32(nearest, safe));
      const unsigned exact = static_cast<unsigned>(hits.owner[i] | hits.owner[i + 1]) & is_exact;
      hits.node[i] = (outside & 0x07) != 0 ? no_node : node[0];
      hits.node[i + 1] = (outside & 0x70) != 0 ? no_node : node[1];
      const bool sure_one = (outside & 0x07) != 0 || (inside & 0x07) == 0x07;
      const bool sure_other = (outside & 0x70) != 0 || (inside & 0x70) == 0x70;
      if (!(sure_one & sure_other) | (exact != 0) | filtered) [[unlikely]] {
        look_closer(input, begin, hits, i, node[0]);
        look_closer(input, begin, hits, i + 1, node[1]);
      }
    }
  }
};

}  // namespace
}  // namespace cellsearch::production
