// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "production/batch.hpp"
#include "production/kernels.hpp"
#include "production/x86/lanes.hpp"

namespace cellsearch::production {
namespace {

/// Loops 1 and 2 of a query: the territories of a batch in the lattice, and the runs of sorted nodes to be
/// tested.
template <InstructionSet Set>
struct RunLoops {
  /// Lattice units of an expansion, rounded outwards by what the lattice may be off.
  static __m128i lattice_expansion(double expansion, const Grid& grid) {
    const __m256d exact = _mm256_mul_pd(_mm256_set1_pd(expansion), _mm256_load_pd(grid.scale.data()));
    const __m256d cut = _mm256_min_pd(exact, _mm256_set1_pd(lattice_limit));
    return _mm_add_epi32(_mm256_cvttpd_epi32(cut), load4(grid.margin.data()));
  }

  static void prefetch_rows(const std::uint32_t* row, std::size_t second, std::size_t third) {
    _mm_prefetch(row, _MM_HINT_T0);
    _mm_prefetch(row + second, _MM_HINT_T0);
    _mm_prefetch(row + third, _MM_HINT_T0);
    _mm_prefetch(row + third + second, _MM_HINT_T0);
  }

  static __m128i places(__m128i a, __m128i b, __m128i c, __m128i d) {
    return _mm_unpackhi_epi64(_mm_unpackhi_epi32(a, b), _mm_unpackhi_epi32(c, d));
  }

  /// Loop 1: the territories in the lattice, from the rounded nodes.
  [[gnu::noinline]] static void territories(const QueryInput& input, Index begin, Index count, Batch& batch) {
    const Grid& root = input.grids[0];
    const GridLanes<Set> grid(root);
    const NodeRecord* const records = input.table.records;
    const Index* own = input.connectivity + 4 * static_cast<std::size_t>(begin);
    __m128i expansion = lattice_expansion(input.expansion, root);
    const std::size_t second = static_cast<std::size_t>(root.step[static_cast<std::size_t>(root.axis[1])]);
    const std::size_t third = static_cast<std::size_t>(root.step[static_cast<std::size_t>(root.axis[2])]);
    for (Index j = 0; j < count; ++j, own += 4) {
      if (input.segment_expansion != nullptr) {
        expansion = lattice_expansion(input.expansion + input.segment_expansion[begin + j], root);
      }
      const __m128i a = load4(records + own[0]);
      const __m128i b = load4(records + own[1]);
      const __m128i c = load4(records + own[2]);
      const __m128i d = load4(records + own[3]);
      const __m128i lo = _mm_sub_epi32(_mm_min_epi32(_mm_min_epi32(a, b), _mm_min_epi32(c, d)), expansion);
      const __m128i hi = _mm_add_epi32(_mm_max_epi32(_mm_max_epi32(a, b), _mm_max_epi32(c, d)), expansion);
      LatticeBox& box = batch.boxes[static_cast<std::size_t>(j)];
      store4(box.lo.data(), lo);
      store4(box.hi.data(), hi);
      store4(box.own.data(), places(a, b, c, d));
      const __m128i number = grid.number(grid.cells(grid.clamp(lo)));
      box.row = static_cast<std::uint32_t>(_mm_cvtsi128_si32(number));
      prefetch_rows(input.table.starts + box.row, second, third);
    }
  }

  /// Loop 1 where cells may have grids of their own: each territory goes down to the grid in which it covers
  /// more than one cell, or one that is not divided. There all nodes that it covers are in one lattice.
  [[gnu::noinline]] static void nested_territories(const QueryInput& input, Index begin, Index count,
                                                   Batch& batch) {
    const NodeRecord* const records = input.table.records;
    const Index* own = input.connectivity + 4 * static_cast<std::size_t>(begin);
    const __m256d limit = _mm256_set1_pd(lattice_limit);
    const __m256d low_limit = _mm256_set1_pd(-lattice_limit);
    double expansion = input.expansion;
    for (Index j = 0; j < count; ++j, own += 4) {
      if (input.segment_expansion != nullptr)
        expansion = input.expansion + input.segment_expansion[begin + j];
      const __m256d a = load_position(input.positions[own[0]]);
      const __m256d b = load_position(input.positions[own[1]]);
      const __m256d c = load_position(input.positions[own[2]]);
      const __m256d d = load_position(input.positions[own[3]]);
      const __m256d out = _mm256_set1_pd(expansion);
      const __m256d low = _mm256_sub_pd(_mm256_min_pd(_mm256_min_pd(a, b), _mm256_min_pd(c, d)), out);
      const __m256d high = _mm256_add_pd(_mm256_max_pd(_mm256_max_pd(a, b), _mm256_max_pd(c, d)), out);
      LatticeBox& box = batch.boxes[static_cast<std::size_t>(j)];
      store4(box.own.data(), places(load4(records + own[0]), load4(records + own[1]), load4(records + own[2]),
                                    load4(records + own[3])));
      std::int64_t at = 0;
      while (true) {
        const Grid& grid = input.grids[at];
        const GridLanes<Set> lanes(grid);
        const auto round = [&](__m256d xyz) {
          const __m256d place =
              _mm256_fmadd_pd(xyz, _mm256_load_pd(grid.scale.data()), _mm256_load_pd(grid.offset.data()));
          return _mm256_cvttpd_epi32(_mm256_max_pd(_mm256_min_pd(place, limit), low_limit));
        };
        const __m128i margin = load4(grid.margin.data());
        const __m128i lo = _mm_sub_epi32(round(low), margin);
        const __m128i hi = _mm_add_epi32(round(high), margin);
        const __m128i first = lanes.cells(lanes.clamp(lo));
        const __m128i apart = _mm_xor_si128(first, lanes.cells(lanes.clamp(hi)));
        store4(box.lo.data(), lo);
        store4(box.hi.data(), hi);
        box.row = grid.first_cell + static_cast<std::uint32_t>(_mm_cvtsi128_si32(lanes.number(first)));
        box.grid = at;
        if (_mm_testz_si128(apart, apart) == 0 || input.child[box.row] < 0) break;
        at = input.child[box.row];
      }
    }
  }

  /// What loop 2 needs of a grid besides GridLanes.
  struct RunLanes {
    std::size_t second;
    std::size_t third;
    __m128i usual;   ///< most cells beyond the first along each axis: two rows of two layers
    __m128i to_run;  ///< moves the run axis to the front
    __m128i needs_second;
    __m128i needs_third;

    explicit RunLanes(const Grid& grid)
        : second(static_cast<std::size_t>(grid.step[static_cast<std::size_t>(grid.axis[1])])),
          third(static_cast<std::size_t>(grid.step[static_cast<std::size_t>(grid.axis[2])])) {
      alignas(16) std::array<std::int32_t, 4> most{1, 1, 1, 0};
      most[static_cast<std::size_t>(grid.axis[0])] = longest_run - 1;
      usual = load4(most.data());
      to_run = _mm_setr_epi32(lane_bytes(grid.axis[0]), -1, -1, -1);
      const int y = lane_bytes(grid.axis[1]);
      const int z = lane_bytes(grid.axis[2]);
      needs_second = _mm_setr_epi32(-1, y, -1, y);
      needs_third = _mm_setr_epi32(-1, -1, z, z);
    }
  };

  /// Cells along the run axis that a run may have: their lattice numbers stay distinct modulo 256.
  static constexpr int longest_run = 6;

  static __m128i gather4(const std::uint32_t* from, std::size_t second, std::size_t third) {
    const auto at = [&](std::size_t i) { return static_cast<int>(from[i]); };
    const __m128i front = _mm_insert_epi32(_mm_cvtsi32_si128(at(0)), at(second), 1);
    const __m128i back = _mm_insert_epi32(_mm_cvtsi32_si128(at(third)), at(third + second), 1);
    return _mm_unpacklo_epi64(front, back);
  }

  /// What loop 2 does with runs of more than 16 nodes: where they are rare it branches, where they are not, a
  /// branch would be mispredicted too often, and each entry gets a second one for the next 16 nodes, kept if
  /// needed.
  enum class LongRuns { Rare, Frequent };

  /// Loop 2: for each territory the runs of sorted nodes in the two rows of two layers that it covers. One
  /// entry, if the runs are short and there are no more of them.
  template <bool Nested, LongRuns LongRunsAre>
  [[gnu::noinline]] static void find_runs(const QueryInput& input, Index begin, Index count, Batch& batch) {
    GridLanes<Set> grid(input.grids[0]);
    RunLanes lanes(input.grids[0]);
    [[maybe_unused]] std::int64_t lanes_of = 0;
    const std::uint32_t* const starts = input.table.starts;
    const std::uint8_t* const active = input.active == nullptr ? nullptr : input.active + begin;
    const __m128i bytes = _mm_setr_epi32(0x00000000, 0x04040404, 0x08080808, -1);
    const __m128i sixteen = _mm_set1_epi32(run_nodes);
    const __m128i longest = LongRunsAre == LongRuns::Rare ? sixteen : _mm_set1_epi32(2 * run_nodes);
    const __m128i bit_numbers = _mm_setr_epi32(0, 16, 32, 48);
    __m128i visited = _mm_setzero_si128();
    Offset cells_visited = 0;
    int entries = 0;
    int long_count = 0;
    for (Index j = 0; j < count; ++j) {
      const LatticeBox& box = batch.boxes[static_cast<std::size_t>(j)];
      Entry& entry = batch.entries[static_cast<std::size_t>(entries++)];
      if constexpr (Nested) {
        if (box.grid != lanes_of) [[unlikely]] {
          lanes_of = box.grid;
          grid = GridLanes<Set>(input.grids[lanes_of]);
          lanes = RunLanes(input.grids[lanes_of]);
        }
      }
      const __m128i lo = grid.clamp(load4(box.lo.data()));
      const __m128i hi = grid.clamp(load4(box.hi.data()));
      const __m128i more = _mm_sub_epi32(grid.cells(hi), grid.cells(lo));
      const __m128i low_bytes =
          _mm_insert_epi32(_mm_shuffle_epi8(_mm_srli_epi32(lo, fine_bits), bytes), j, 3);
      const __m128i width = _mm_sub_epi8(_mm_shuffle_epi8(_mm_srli_epi32(hi, fine_bits), bytes), low_bytes);
      const __m128i own = load4(box.own.data());
      store4(entry.lo.data(), low_bytes);
      store4(entry.width.data(), width);
      store4(entry.own.data(), own);
      const std::uint32_t* const row = starts + box.row;
      const int along = _mm_cvtsi128_si32(_mm_shuffle_epi8(more, lanes.to_run)) + 1;
      const __m128i first = gather4(row, lanes.second, lanes.third);
      const __m128i last = gather4(row + along, lanes.second, lanes.third);
      const __m128i same = _mm_cmpeq_epi32(more, _mm_setzero_si128());
      const __m128i unneeded =
          _mm_or_si128(_mm_shuffle_epi8(same, lanes.needs_second), _mm_shuffle_epi8(same, lanes.needs_third));
      const __m128i length = _mm_andnot_si128(unneeded, _mm_sub_epi32(last, first));
      const __m128i base = _mm_sub_epi32(first, bit_numbers);
      store4(entry.first.data(), first);
      store4(entry.length.data(), _mm_min_epi32(length, sixteen));
      store4(entry.base.data(), base);
      const __m128i unusual =
          _mm_or_si128(_mm_cmpgt_epi32(more, lanes.usual), _mm_cmpgt_epi32(length, longest));
      const bool idle = active != nullptr && active[j] == 0;
      if (_mm_movemask_epi8(unusual) != 0 || idle) [[unlikely]] {
        ++long_count;
        if (idle) {
          entry.length = {0, 0, 0, 0};
        } else {
          entries += spread<Nested>(input, lanes, j, entries - 1, batch) - 1;
        }
        continue;
      }
      visited = _mm_add_epi32(visited, length);
      const int rows =
          runs - _mm_popcnt_u32(static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(unneeded))));
      cells_visited += static_cast<Offset>(along) * rows;
      if constexpr (LongRunsAre == LongRuns::Frequent) {
        Entry& second = batch.entries[static_cast<std::size_t>(entries)];
        const __m128i left = _mm_subs_epu16(length, sixteen);
        store4(second.lo.data(), low_bytes);
        store4(second.width.data(), width);
        store4(second.own.data(), own);
        store4(second.first.data(), _mm_add_epi32(first, sixteen));
        store4(second.length.data(), left);
        store4(second.base.data(), _mm_add_epi32(base, sixteen));
        const int needed = _mm_testz_si128(left, left) == 0 ? 1 : 0;
        entries += needed;
        long_count += needed;
      }
    }
    batch.entry_count = entries;
    batch.long_count = long_count;
    batch.raw_visits += _mm_cvtsi128_si32(sum4(visited));
    batch.cell_visits += cells_visited;
  }

  /// The entries of a segment that needs more than one; the first, at `at`, has been begun. Returns how many
  /// there are.
  template <bool Nested>
  [[gnu::noinline]] static int spread(const QueryInput& input, const RunLanes& lanes, Index j, int at,
                                      Batch& batch) {
    const LatticeBox& box = batch.boxes[static_cast<std::size_t>(j)];
    const Grid& of_box = input.grids[Nested ? box.grid : 0];
    const GridLanes<Set> grid(of_box);
    const __m128i lo = grid.clamp(load4(box.lo.data()));
    const __m128i hi = grid.clamp(load4(box.hi.data()));
    alignas(16) std::array<std::int32_t, 4> cells;
    alignas(16) std::array<std::int32_t, 4> bytes;
    store4(cells.data(), _mm_sub_epi32(grid.cells(hi), grid.cells(lo)));
    store4(bytes.data(), _mm_sub_epi32(_mm_srli_epi32(hi, fine_bits), _mm_srli_epi32(lo, fine_bits)));
    const auto [run, second, third] = of_box.axis;
    const auto along = [](const auto& numbers, int axis) { return numbers[static_cast<std::size_t>(axis)]; };
    const int in_run = along(cells, run) + 1;
    const int rows = along(cells, second) + 1;
    const int layers = along(cells, third) + 1;
    // Modulo 256, nodes before and behind the territory must differ from those inside.
    constexpr int widest = 255 - (1 << cross_bits);
    bool fits = in_run <= longest_run && along(bytes, second) <= widest && along(bytes, third) <= widest;
    const int room = batch_entries - 2 * (batch_segments - j) - at;
    const int most_tests = runs * (room < segment_entries ? room : segment_entries);
    Entry* const entries = batch.entries.data() + at;
    int tests = 0;
    Offset visits = 0;
    for (int layer = 0; layer < layers && fits; ++layer) {
      Offset cell = box.row + layer * static_cast<Offset>(lanes.third);
      for (int row = 0; row < rows; ++row, cell += static_cast<Offset>(lanes.second)) {
        const std::uint32_t* const starts = input.table.starts + cell;
        std::uint32_t first = starts[0];
        const std::uint32_t last = starts[in_run];
        visits += last - first;
        if constexpr (Nested) {
          for (int k = 0; k < in_run; ++k) fits = fits && input.child[cell + k] < 0;
        }
        const int needed = static_cast<int>((last - first + run_nodes - 1) / run_nodes);
        fits = fits && tests + needed < most_tests;
        if (!fits) break;
        // One test in any case: most rows need one, and the next row overwrites an empty one.
        do {
          Entry& entry = entries[tests / runs];
          const std::size_t lane = static_cast<std::size_t>(tests % runs);
          entry.first[lane] = first;
          entry.length[lane] = last - first < run_nodes ? last - first : run_nodes;
          entry.base[lane] = first - static_cast<std::uint32_t>(run_nodes * static_cast<int>(lane));
          tests += last > first ? 1 : 0;
          first += run_nodes;
        } while (first < last);
      }
    }
    Entry& begun = entries[0];
    if (!fits || tests == 0) {
      begun.length = {0, 0, 0, 0};
      begun.owner = fits ? j : j | needs_help;
      return 1;
    }
    batch.raw_visits += visits;
    batch.cell_visits += Offset{in_run} * rows * layers;
    return finish_entries(begun, tests);
  }

  /// Fills in what all entries of a segment share, and empties the lanes of the last that are not used.
  static int finish_entries(Entry& begun, int tests) {
    const int count = (tests + runs - 1) / runs;
    for (int e = 1; e < count; ++e) {
      Entry& entry = (&begun)[e];
      store4(entry.lo.data(), load4(begun.lo.data()));
      store4(entry.width.data(), load4(begun.width.data()));
      store4(entry.own.data(), load4(begun.own.data()));
    }
    Entry& last = (&begun)[count - 1];
    for (int lane = tests - runs * (count - 1); lane < runs; ++lane) {
      last.first[static_cast<std::size_t>(lane)] = 0;
      last.length[static_cast<std::size_t>(lane)] = 0;
    }
    return count;
  }
};

}  // namespace
}  // namespace cellsearch::production
