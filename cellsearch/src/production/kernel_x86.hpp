// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <immintrin.h>

#include "production/batch.hpp"
#include "production/kernels.hpp"

// The loops for x86, compiled once per instruction set. Everything here is a template on it, so that no two
// compilations share a function: the linker would keep one of them for both.
//
// A query takes 64 segments at a time through six loops, each short enough to keep the processor's window
// full: territories, runs, test, hits, faces, rows. docs/production.md explains them.
namespace cellsearch::production {
namespace {

inline __m128i load4(const void* from) {
  return _mm_load_si128(static_cast<const __m128i*>(from));
}

inline void store4(void* to, __m128i value) {
  _mm_store_si128(static_cast<__m128i*>(to), value);
}

/// Sum of the four numbers, in the first.
inline __m128i sum4(__m128i value) {
  value = _mm_add_epi32(value, _mm_shuffle_epi32(value, 0x4e));
  return _mm_add_epi32(value, _mm_shuffle_epi32(value, 0xb1));
}

inline __m256d load_position(const double* xyz) {
  return _mm256_maskload_pd(xyz, _mm256_setr_epi64x(-1, -1, -1, 0));
}

/// The four bytes of a control for _mm_shuffle_epi8 that move number `lane` (zero if negative).
inline int lane_bytes(int lane) {
  return lane < 0 ? -1 : 0x03020100 + 0x04040404 * lane;
}

/// A grid in registers.
template <InstructionSet set>
struct GridLanes {
  __m128i top;
  __m128i shift;
  __m128i step;

  explicit GridLanes(const Grid& grid)
      : top(load4(grid.top.data())), shift(load4(grid.shift.data())), step(load4(grid.step.data())) {}

  __m128i clamp(__m128i fine) const { return _mm_max_epi32(_mm_min_epi32(fine, top), _mm_setzero_si128()); }
  __m128i cells(__m128i clamped) const { return _mm_srlv_epi32(clamped, shift); }
  __m128i number(__m128i cells_of_axes) const { return sum4(_mm_mullo_epi32(cells_of_axes, step)); }
};

template <InstructionSet set>
struct X86Kernels {
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
    const GridLanes<set> grid(input.grid);
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
    const GridLanes<set> grid(input.grid);
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
    const GridLanes<set> grid(root);
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
        const GridLanes<set> lanes(grid);
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

  /// Loop 2: for each territory the runs of sorted nodes in the two rows of two layers that it covers. One
  /// entry, if the runs are short and there are no more of them.
  /// What loop 2 does with runs of more than 16 nodes: where they are rare it branches, where they are not, a
  /// branch would be mispredicted too often, and each entry gets a second one for the next 16 nodes, kept if
  /// needed.
  enum class LongRuns { Rare, Frequent };

  /// Loop 2: for each territory the runs of sorted nodes in the two rows of two layers that it covers. One
  /// entry, if the runs are short and there are no more of them.
  template <bool nested, LongRuns long_runs>
  [[gnu::noinline]] static void find_runs(const QueryInput& input, Index begin, Index count, Batch& batch) {
    GridLanes<set> grid(input.grids[0]);
    RunLanes lanes(input.grids[0]);
    [[maybe_unused]] std::int64_t lanes_of = 0;
    const std::uint32_t* const starts = input.table.starts;
    const std::uint8_t* const active = input.active == nullptr ? nullptr : input.active + begin;
    const __m128i bytes = _mm_setr_epi32(0x00000000, 0x04040404, 0x08080808, -1);
    const __m128i sixteen = _mm_set1_epi32(run_nodes);
    const __m128i longest = long_runs == LongRuns::Rare ? sixteen : _mm_set1_epi32(2 * run_nodes);
    const __m128i bit_numbers = _mm_setr_epi32(0, 16, 32, 48);
    __m128i visited = _mm_setzero_si128();
    Offset cells_visited = 0;
    int entries = 0;
    int long_count = 0;
    for (Index j = 0; j < count; ++j) {
      const LatticeBox& box = batch.boxes[static_cast<std::size_t>(j)];
      Entry& entry = batch.entries[static_cast<std::size_t>(entries++)];
      if constexpr (nested) {
        if (box.grid != lanes_of) [[unlikely]] {
          lanes_of = box.grid;
          grid = GridLanes<set>(input.grids[lanes_of]);
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
          entries += spread<nested>(input, lanes, j, entries - 1, batch) - 1;
        }
        continue;
      }
      visited = _mm_add_epi32(visited, length);
      const int rows =
          runs - _mm_popcnt_u32(static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(unneeded))));
      cells_visited += static_cast<Offset>(along) * rows;
      if constexpr (long_runs == LongRuns::Frequent) {
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
  template <bool nested>
  [[gnu::noinline]] static int spread(const QueryInput& input, const RunLanes& lanes, Index j, int at,
                                      Batch& batch) {
    const LatticeBox& box = batch.boxes[static_cast<std::size_t>(j)];
    const Grid& of_box = input.grids[nested ? box.grid : 0];
    const GridLanes<set> grid(of_box);
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
        if constexpr (nested) {
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
    if constexpr (set == InstructionSet::Avx512) {
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

  /// Adds the hits of segment `begin + j`, which is left to QueryHelp, unless they would leave no room for
  /// the entries after entry `e`: then its row is put in at the end.
  [[gnu::noinline]] static std::uint32_t add_helped(const QueryInput& input, Index segment,
                                                    std::uint32_t count, FoundRows& rows, int e, Batch& batch,
                                                    Hits& hits) {
    input.help->collect(segment, rows);
    const Index* const found = rows.spare->data();
    const std::size_t size = rows.spare->size();
    const std::size_t j =
        static_cast<std::size_t>(batch.entries[static_cast<std::size_t>(e)].owner & (needs_help - 1));
    const std::size_t kept = static_cast<std::size_t>(batch.entry_count - e) * entry_nodes;
    if (count + size + kept > hits.node.size()) {
      batch.too_many[j] = true;
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
  template <std::uint32_t direct>
  [[gnu::noinline]] static std::uint32_t list_hits(const QueryInput& input, Index begin, FoundRows& rows,
                                                   Batch& batch, Hits& hits) {
    const Index* const nodes = input.table.nodes;
    const NodeRecord* const records = input.table.records;
    std::uint32_t count = 0;
    for (int e = 0; e < batch.entry_count; ++e) {
      const Entry& entry = batch.entries[static_cast<std::size_t>(e)];
      const std::size_t j = static_cast<std::size_t>(entry.owner & (needs_help - 1));
      if ((entry.owner & needs_help) != 0) [[unlikely]] {
        count = add_helped(input, begin + static_cast<Index>(j), count, rows, e, batch, hits);
        batch.ends[j] = count;
        continue;
      }
#ifdef __AVX512F__
      if constexpr (set == InstructionSet::Avx512 && direct > 4) {
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
      for (std::uint32_t at = 0; at < direct; ++at) write(at);
      if (found > direct) [[unlikely]] {
        for (std::uint32_t at = direct; at < found; ++at) write(at);
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
  template <bool nested>
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
      if constexpr (nested) safe = twice(both(safe_of(one.grid), safe_of(other.grid)));
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

  template <int upper>
  static __m256i exchange(__m256i v, __m256i other) {
    return _mm256_blend_epi32(_mm256_min_epi32(v, other), _mm256_max_epi32(v, other), upper);
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
  template <bool few>
  [[gnu::noinline]] static Index* write_rows(Index count, const Batch& batch, const Hits& hits, Index* to,
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
        if (!few || found > 4) {
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

  static void query(const QueryInput& input, Index begin, Index end, FoundRows& rows) {
    Batch batch;
    Hits hits;
    batch.raw_visits = 0;
    batch.cell_visits = 0;
    batch.too_many = {};
    batch.any_too_many = false;
    batch.long_count = 0;
    for (Entry& entry : batch.entries) entry.base = {};
    for (LatticeBox& box : batch.boxes) box.grid = 0;
    Offset used = 0;
    for (Index at = begin; at < end; at += batch_segments) {
      const Index count = end - at < batch_segments ? end - at : batch_segments;
      const bool long_runs = batch.long_count > batch_segments / 12;
      if (input.child == nullptr) {
        territories(input, at, count, batch);
        long_runs ? find_runs<false, LongRuns::Frequent>(input, at, count, batch)
                  : find_runs<false, LongRuns::Rare>(input, at, count, batch);
      } else {
        nested_territories(input, at, count, batch);
        find_runs<true, LongRuns::Rare>(input, at, count, batch);
      }
      test(input.table, batch);
      const bool many = batch.many_count > batch_segments / 12;
      const std::uint32_t found =
          many ? list_hits<8>(input, at, rows, batch, hits) : list_hits<4>(input, at, rows, batch, hits);
      input.child == nullptr ? check_faces<false>(input, at, found, batch, hits)
                             : check_faces<true>(input, at, found, batch, hits);
      Index* const to = reserve(*rows.nodes, static_cast<std::size_t>(used), found + 16);
      Offset* const ends = rows.ends + (at - begin);
      const Offset before = used;
      used += (many ? write_rows<false>(count, batch, hits, to, before, ends)
                    : write_rows<true>(count, batch, hits, to, before, ends)) -
              to;
      if (batch.any_too_many) [[unlikely]] {
        used = collect_rows(input, at, {batch.too_many.data(), static_cast<std::size_t>(count)}, rows, before,
                            ends);
        batch.too_many = {};
        batch.any_too_many = false;
      }
    }
    rows.raw_visits += batch.raw_visits;
    rows.cell_visits += batch.cell_visits;
    trim(*rows.nodes, static_cast<std::size_t>(used));
  }
};

template <InstructionSet set>
constexpr Kernels x86_kernels{X86Kernels<set>::measure, X86Kernels<set>::largest, X86Kernels<set>::classify,
                              X86Kernels<set>::place, X86Kernels<set>::query};

}  // namespace
}  // namespace cellsearch::production
