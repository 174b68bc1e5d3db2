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
  static NodeRange measure(const Positions& positions, Index begin, Index end) {
    __m256d lo = _mm256_set1_pd(std::numeric_limits<double>::infinity());
    __m256d hi = _mm256_set1_pd(-std::numeric_limits<double>::infinity());
    __m256d zero = _mm256_setzero_pd();
    for (Index node = begin; node < end; ++node) {
      const __m256d xyz = load_position(positions[node]);
      lo = _mm256_min_pd(lo, xyz);
      hi = _mm256_max_pd(hi, xyz);
      // Stays zero as long as all numbers are finite.
      zero = _mm256_fmadd_pd(xyz, _mm256_setzero_pd(), zero);
    }
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

  static void classify(const SortInput& input, Index begin, Index end, std::uint32_t* counts) {
    const GridLanes<set> grid(input.grid);
    const __m256d scale = _mm256_load_pd(input.grid.scale.data());
    const __m256d offset = _mm256_load_pd(input.grid.offset.data());
    const __m256d limit = _mm256_set1_pd(lattice_limit);
    const __m256d low_limit = _mm256_set1_pd(-lattice_limit);
    for (Index node = begin; node < end; ++node) {
      const __m256d place = _mm256_fmadd_pd(load_position(input.positions[node]), scale, offset);
      const __m128i fine = _mm256_cvttpd_epi32(_mm256_max_pd(_mm256_min_pd(place, limit), low_limit));
      const __m128i number = grid.number(grid.cells(grid.clamp(fine)));
      store4(input.records + node, _mm_blend_epi32(fine, number, 8));
      if (counts != nullptr) ++counts[static_cast<std::uint32_t>(_mm_cvtsi128_si32(number))];
    }
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
      const __m128i fine = grid.clamp(load4(records + node));
      x[at] = static_cast<std::uint8_t>(_mm_extract_epi8(fine, 1));
      y[at] = static_cast<std::uint8_t>(_mm_extract_epi8(fine, 5));
      z[at] = static_cast<std::uint8_t>(_mm_extract_epi8(fine, 9));
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
  static void territories(const QueryInput& input, Index begin, Index count, Batch& batch) {
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
      box.grid = 0;
      prefetch_rows(input.table.starts + box.row, second, third);
    }
  }

  /// Loop 1 where cells may have grids of their own: each territory goes down to the grid in which it covers
  /// more than one cell, or one that is not divided. There all nodes that it covers are in one lattice.
  static void nested_territories(const QueryInput& input, Index begin, Index count, Batch& batch) {
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
  static void find_runs(const QueryInput& input, Index begin, Index count, Batch& batch) {
    GridLanes<set> grid(input.grids[0]);
    RunLanes lanes(input.grids[0]);
    std::int64_t lanes_of = 0;
    const __m128i bytes = _mm_setr_epi32(0x01010101, 0x05050505, 0x09090909, -1);
    const __m128i sixteen = _mm_set1_epi32(run_nodes);
    const __m128i bit_numbers = _mm_setr_epi32(0, 16, 32, 48);
    __m128i visited = _mm_setzero_si128();
    Offset cells_visited = 0;
    int entries = 0;
    for (Index j = 0; j < count; ++j) {
      const LatticeBox& box = batch.boxes[static_cast<std::size_t>(j)];
      Entry& entry = batch.entries[static_cast<std::size_t>(entries++)];
      if (box.grid != lanes_of) [[unlikely]] {
        lanes_of = box.grid;
        grid = GridLanes<set>(input.grids[lanes_of]);
        lanes = RunLanes(input.grids[lanes_of]);
      }
      const __m128i lo = grid.clamp(load4(box.lo.data()));
      const __m128i hi = grid.clamp(load4(box.hi.data()));
      const __m128i more = _mm_sub_epi32(grid.cells(hi), grid.cells(lo));
      const __m128i low_bytes = _mm_shuffle_epi8(lo, bytes);
      store4(entry.lo.data(), _mm_insert_epi32(low_bytes, j, 3));
      store4(entry.width.data(), _mm_sub_epi8(_mm_shuffle_epi8(hi, bytes), low_bytes));
      store4(entry.own.data(), load4(box.own.data()));
      const std::uint32_t* const row = input.table.starts + box.row;
      const std::uint32_t along =
          static_cast<std::uint32_t>(_mm_cvtsi128_si32(_mm_shuffle_epi8(more, lanes.to_run))) + 1;
      const __m128i first = gather4(row, lanes.second, lanes.third);
      const __m128i last = gather4(row + along, lanes.second, lanes.third);
      const __m128i same = _mm_cmpeq_epi32(more, _mm_setzero_si128());
      const __m128i unneeded =
          _mm_or_si128(_mm_shuffle_epi8(same, lanes.needs_second), _mm_shuffle_epi8(same, lanes.needs_third));
      const __m128i length = _mm_andnot_si128(unneeded, _mm_sub_epi32(last, first));
      store4(entry.first.data(), first);
      store4(entry.length.data(), length);
      store4(entry.base.data(), _mm_sub_epi32(first, bit_numbers));
      // Compared as signed numbers: a length below 0 cannot be.
      const __m128i unusual =
          _mm_or_si128(_mm_cmpgt_epi32(more, lanes.usual), _mm_cmpgt_epi32(length, sixteen));
      const bool idle = input.active != nullptr && input.active[begin + j] == 0;
      if (_mm_movemask_epi8(unusual) != 0 || idle) [[unlikely]] {
        --entries;
        if (idle) {
          entries += idle_entry(entry);
        } else {
          entries += spread(input, lanes, j, entries, batch);
        }
        continue;
      }
      visited = _mm_add_epi32(visited, length);
      const int rows =
          runs - _mm_popcnt_u32(static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(unneeded))));
      cells_visited += static_cast<Offset>(along) * rows;
    }
    batch.entry_count = entries;
    batch.raw_visits += _mm_cvtsi128_si32(sum4(visited));
    batch.cell_visits += cells_visited;
  }

  static int idle_entry(Entry& entry) {
    entry.length = {0, 0, 0, 0};
    return 1;
  }

  /// The entries of a segment that needs more than one; the first has been begun. Returns how many there are.
  static int spread(const QueryInput& input, const RunLanes& lanes, Index j, int at, Batch& batch) {
    const LatticeBox& box = batch.boxes[static_cast<std::size_t>(j)];
    const Grid& of_box = input.grids[box.grid];
    const GridLanes<set> grid(of_box);
    const Entry begun = batch.entries[static_cast<std::size_t>(at)];
    const std::array<int, 3>& axis = of_box.axis;
    alignas(16) std::array<std::int32_t, 4> lo;
    alignas(16) std::array<std::int32_t, 4> hi;
    store4(lo.data(), grid.clamp(load4(box.lo.data())));
    store4(hi.data(), grid.clamp(load4(box.hi.data())));
    const auto cells_along = [&](int k) {
      const std::size_t a = static_cast<std::size_t>(axis[static_cast<std::size_t>(k)]);
      return (hi[a] >> of_box.shift[a]) - (lo[a] >> of_box.shift[a]) + 1;
    };
    const auto bytes_along = [&](int k) {
      const std::size_t a = static_cast<std::size_t>(axis[static_cast<std::size_t>(k)]);
      return (hi[a] >> fine_bits) - (lo[a] >> fine_bits);
    };
    // Modulo 256, nodes before and behind the territory must differ from those inside.
    constexpr int widest = 255 - (1 << cross_bits);
    bool fits = cells_along(0) <= longest_run && bytes_along(1) <= widest && bytes_along(2) <= widest;
    int entries = 0;
    int used = runs;
    Offset visits = 0;
    for (int third = 0; fits && third < cells_along(2); ++third) {
      for (int second = 0; fits && second < cells_along(1); ++second) {
        const Offset cell = box.row + static_cast<std::size_t>(third) * lanes.third +
                            static_cast<Offset>(second) * static_cast<Offset>(lanes.second);
        const std::uint32_t* const row = input.table.starts + cell;
        const std::uint32_t last = row[cells_along(0)];
        visits += last - row[0];
        for (Index k = 0; input.child != nullptr && k < cells_along(0); ++k)
          fits = fits && input.child[cell + k] < 0;
        for (std::uint32_t first = row[0]; fits && first < last; first += run_nodes) {
          if (used == runs) {
            fits = entries < segment_entries && at + entries < batch_entries - (batch_segments - j);
            if (!fits) break;
            Entry& next = batch.entries[static_cast<std::size_t>(at + entries++)];
            next = begun;
            next.length = {0, 0, 0, 0};
            used = 0;
          }
          Entry& entry = batch.entries[static_cast<std::size_t>(at + entries - 1)];
          const std::size_t run = static_cast<std::size_t>(used++);
          entry.first[run] = first;
          entry.length[run] = last - first < run_nodes ? last - first : run_nodes;
          entry.base[run] = first - static_cast<std::uint32_t>(run_nodes) * static_cast<std::uint32_t>(run);
        }
      }
    }
    if (!fits || entries == 0) {
      Entry& entry = batch.entries[static_cast<std::size_t>(at)];
      entry = begun;
      entry.length = {0, 0, 0, 0};
      entry.owner = fits ? j : j | needs_help;
      return 1;
    }
    batch.raw_visits += visits;
    batch.cell_visits += Offset{cells_along(0)} * cells_along(1) * cells_along(2);
    return entries;
  }

  /// 16 sorted coordinates of each of two runs.
  static __m256i two_runs(const std::uint8_t* from, std::uint32_t first, std::uint32_t second) {
    const auto at = [&](std::uint32_t place) {
      return _mm_loadu_si128(static_cast<const __m128i*>(static_cast<const void*>(from + place)));
    };
    return _mm256_inserti128_si256(_mm256_castsi128_si256(at(first)), at(second), 1);
  }

  /// Bit for each of the 32 nodes of two runs that is inside in all three coordinates.
  static std::uint32_t inside(const NodeTable& table, const Entry& entry, std::size_t run,
                              const __m256i (&lo)[3], const __m256i (&width)[3], __m256i valid) {
    const std::uint32_t first = entry.first[run];
    const std::uint32_t second = entry.first[run + 1];
    // One subtraction modulo 256 and one comparison serve both faces.
    const __m256i x = _mm256_sub_epi8(two_runs(table.x, first, second), lo[0]);
    const __m256i y = _mm256_sub_epi8(two_runs(table.y, first, second), lo[1]);
    const __m256i z = _mm256_sub_epi8(two_runs(table.z, first, second), lo[2]);
#ifdef __AVX512BW__
    if constexpr (set == InstructionSet::Avx512) {
      const __mmask32 in_x = _mm256_mask_cmple_epu8_mask(_mm256_movepi8_mask(valid), x, width[0]);
      const __mmask32 in_y = _mm256_cmple_epu8_mask(y, width[1]);
      return _kand_mask32(in_x, _mm256_mask_cmple_epu8_mask(in_y, z, width[2]));
    }
#endif
    const __m256i beyond =
        _mm256_or_si256(_mm256_or_si256(_mm256_subs_epu8(x, width[0]), _mm256_subs_epu8(y, width[1])),
                        _mm256_subs_epu8(z, width[2]));
    const __m256i in = _mm256_and_si256(valid, _mm256_cmpeq_epi8(beyond, _mm256_setzero_si256()));
    return static_cast<std::uint32_t>(_mm256_movemask_epi8(in));
  }

  /// Loop 3: which of the 64 nodes of each entry are inside, without the segment's own.
  static void test(const NodeTable& table, Batch& batch) {
    const __m256i number = _mm256_setr_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3,
                                            4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const __m256i front = _mm256_setr_epi32(0, 0, 0, 0, 0x04040404, 0x04040404, 0x04040404, 0x04040404);
    const __m256i back = _mm256_add_epi8(front, _mm256_set1_epi8(8));
    const __m128i low_halves = _mm_setr_epi8(0, 1, 4, 5, 8, 9, 12, 13, -1, -1, -1, -1, -1, -1, -1, -1);
    const __m128i one = _mm_set1_epi32(1);
    for (int e = 0; e < batch.entry_count; ++e) {
      const Entry& entry = batch.entries[static_cast<std::size_t>(e)];
      const auto lane = [](std::uint32_t value) { return _mm256_set1_epi32(static_cast<int>(value)); };
      const __m256i lo[3] = {lane(entry.lo[0]), lane(entry.lo[1]), lane(entry.lo[2])};
      const __m256i width[3] = {lane(entry.width[0]), lane(entry.width[1]), lane(entry.width[2])};
      const __m256i length = _mm256_broadcastsi128_si256(load4(entry.length.data()));
      const __m256i valid_front = _mm256_cmpgt_epi8(_mm256_shuffle_epi8(length, front), number);
      const __m256i valid_back = _mm256_cmpgt_epi8(_mm256_shuffle_epi8(length, back), number);
      const std::uint64_t mask = inside(table, entry, 0, lo, width, valid_front) |
                                 std::uint64_t{inside(table, entry, 2, lo, width, valid_back)} << 32;
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
    }
  }

  /// The hits of a batch: nodes, and the segment of each.
  struct Hits {
    std::array<Index, batch_entries * entry_nodes + entry_nodes> node;
    std::array<std::uint8_t, batch_entries * entry_nodes + entry_nodes> owner;
  };

  /// Adds the hits of segment `begin + j`, which is left to QueryHelp, unless they would leave no room for
  /// the entries after entry `e`: then its row is put in at the end.
  static std::uint32_t add_helped(const QueryInput& input, Index segment, std::uint32_t count,
                                  FoundRows& rows, int e, Batch& batch, Hits& hits) {
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

  /// Loop 4: from bits to node numbers. Most entries have few, so four are written in any case.
  static std::uint32_t list_hits(const QueryInput& input, Index begin, FoundRows& rows, Batch& batch,
                                 Hits& hits) {
    const Index* const nodes = input.table.nodes;
    const NodeRecord* const records = input.table.records;
    std::uint32_t count = 0;
    for (int e = 0; e < batch.entry_count; ++e) {
      const Entry& entry = batch.entries[static_cast<std::size_t>(e)];
      const std::size_t j = static_cast<std::size_t>(entry.owner & (needs_help - 1));
      if ((entry.owner & needs_help) != 0) [[unlikely]] {
        count = add_helped(input, begin + static_cast<Index>(j), count, rows, e, batch, hits);
        batch.ends[j] = count;
        batch.refused[j] = 0;
        continue;
      }
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
      write(0);
      write(1);
      write(2);
      write(3);
      if (found > 4) [[unlikely]] {
        for (std::uint32_t at = 4; at < found; ++at) write(at);
      }
      count += found;
      batch.ends[j] = count;
      batch.refused[j] = 0;
    }
    return count;
  }

  /// Loop 5: hits next to a face are looked at again, with more bits and, if need be, in double precision.
  static void check_faces(const QueryInput& input, Index begin, std::uint32_t count, Batch& batch,
                          Hits& hits) {
    const NodeRecord* const records = input.table.records;
    const auto any = [](__m128i lanes) { return _mm_movemask_ps(_mm_castsi128_ps(lanes)) & 7; };
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::size_t j = hits.owner[i] & (is_exact - 1);
      const LatticeBox& box = batch.boxes[j];
      const __m128i fine = load4(records + hits.node[i]);
      const __m128i above = _mm_sub_epi32(fine, load4(box.lo.data()));
      const __m128i below = _mm_sub_epi32(load4(box.hi.data()), fine);
      const __m128i nearest = _mm_min_epi32(above, below);
      const __m128i safe = _mm_slli_epi32(load4(input.grids[box.grid].margin.data()), 2);
      if (any(_mm_cmpgt_epi32(nearest, safe)) == 7 && input.plain) [[likely]]
        continue;
      if (hits.owner[i] != j) continue;
      if (any(nearest) != 0 || !input.help->accepts(begin + static_cast<Index>(j), hits.node[i])) {
        hits.node[i] = no_node;
        ++batch.refused[j];
      }
    }
  }

  /// Sorts the first eight numbers, of which the first four alone if `few`.
  static __m256i sort8(__m256i v, bool few) {
    const auto exchange = [&](__m256i other, auto upper) {
      v = _mm256_blend_epi32(_mm256_min_epi32(v, other), _mm256_max_epi32(v, other), decltype(upper)::value);
    };
    using Odd = std::integral_constant<int, 0b10101010>;
    using Pairs = std::integral_constant<int, 0b11001100>;
    using Half = std::integral_constant<int, 0b11110000>;
    exchange(_mm256_shuffle_epi32(v, 0xb1), Odd{});
    exchange(_mm256_shuffle_epi32(v, 0x1b), Pairs{});
    exchange(_mm256_shuffle_epi32(v, 0xb1), Odd{});
    if (few) return v;
    exchange(_mm256_permutevar8x32_epi32(v, _mm256_setr_epi32(7, 6, 5, 4, 3, 2, 1, 0)), Half{});
    exchange(_mm256_shuffle_epi32(v, 0x4e), Pairs{});
    exchange(_mm256_shuffle_epi32(v, 0xb1), Odd{});
    return v;
  }

  /// Loop 6: the rows, ascending. Refused hits are the largest numbers and end behind the row.
  static Index* write_rows(Index count, const Batch& batch, const Hits& hits, Index* to, Offset before,
                           Offset* ends) {
    const Index* const start = to;
    const __m256i number = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256i none = _mm256_set1_epi32(no_node);
    std::uint32_t at = 0;
    for (Index j = 0; j < count; ++j) {
      const std::uint32_t end = batch.ends[static_cast<std::size_t>(j)];
      const std::uint32_t found = end - at;
      const Index* const from = hits.node.data() + at;
      if (found > 8) [[unlikely]] {
        for (std::uint32_t i = 0; i < found; ++i) to[i] = from[i];
        sort_row(to, to + found);
      } else {
        const __m256i loaded =
            _mm256_loadu_si256(static_cast<const __m256i*>(static_cast<const void*>(from)));
        const __m256i valid = _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int>(found)), number);
        const __m256i sorted = sort8(_mm256_blendv_epi8(none, loaded, valid), found <= 4);
        _mm256_storeu_si256(static_cast<__m256i*>(static_cast<void*>(to)), sorted);
      }
      to += found - batch.refused[static_cast<std::size_t>(j)];
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
    for (Entry& entry : batch.entries) entry.base = {};
    Offset used = 0;
    for (Index at = begin; at < end; at += batch_segments) {
      const Index count = end - at < batch_segments ? end - at : batch_segments;
      if (input.child == nullptr) {
        territories(input, at, count, batch);
      } else {
        nested_territories(input, at, count, batch);
      }
      find_runs(input, at, count, batch);
      test(input.table, batch);
      const std::uint32_t found = list_hits(input, at, rows, batch, hits);
      check_faces(input, at, found, batch, hits);
      Index* const to = reserve(*rows.nodes, static_cast<std::size_t>(used), found + 8);
      Offset* const ends = rows.ends + (at - begin);
      const Offset before = used;
      used += write_rows(count, batch, hits, to, before, ends) - to;
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
