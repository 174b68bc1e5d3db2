// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "cellsearch/types.hpp"

namespace cellsearch::production {

/// Segments that a query works on at a time: few enough that all of a batch stays in the first-level cache.
inline constexpr Index batch_segments = 64;
/// Rows that are tested at once, and nodes that are tested of each.
inline constexpr int runs = 4;
inline constexpr int run_nodes = 16;
inline constexpr int entry_nodes = runs * run_nodes;
/// Most entries of a batch, and of one segment; a segment that needs more is left to QueryHelp.
inline constexpr int batch_entries = 256;
inline constexpr int segment_entries = 16;
/// Takes the place of a node that has turned out to be none; the largest, so that it sorts to the end.
inline constexpr Index no_node = 0x7fffffff;
/// Owner of a hit that needs no further look.
inline constexpr std::uint8_t is_exact = 128;
/// Owner of an entry that stands for a segment left to QueryHelp.
inline constexpr std::int32_t needs_help = std::int32_t{1} << 30;

/// The territory of a segment in the lattice.
struct alignas(16) LatticeBox {
  std::array<std::int32_t, 4> lo;
  std::array<std::int32_t, 4> hi;
  std::array<std::uint32_t, 4> own;  ///< places of the segment's nodes
  std::int64_t row;                  ///< first cell, in the array of starts
  std::int64_t grid;                 ///< 0 unless some cells have grids of their own
};

/// Up to four runs of up to 16 sorted nodes, to be tested against one territory.
struct alignas(64) Entry {
  std::array<std::uint32_t, 3> lo;  ///< eight bits of the lattice numbers, four times each
  std::int32_t owner;               ///< segment within the batch, maybe with needs_help
  std::array<std::uint32_t, 4> width;
  std::array<std::uint32_t, 4> first;   ///< place of the first node of each run
  std::array<std::uint32_t, 4> length;  ///< 0 to 16
  std::array<std::uint32_t, 4> own;
  std::array<std::uint32_t, 8> base;  ///< first - 16 * run: bit b of the mask stands for place base[b / 16] +
                                      ///< b. base[4] is 0, for "bit 64" of an empty mask
};

/// What is kept of a batch from one loop to the next.
struct Batch {
  std::array<LatticeBox, batch_segments> boxes;
  std::array<Entry, batch_entries> entries;
  std::array<std::uint64_t, batch_entries> masks;
  std::array<std::uint32_t, batch_segments> ends;  ///< of the hits of each segment
  std::array<bool, batch_segments> too_many;       ///< the row of this segment is not among the hits
  bool any_too_many;
  int many_count;  ///< entries with more than four hits
  int long_count;  ///< segments with more than one entry
  int entry_count;
  Offset raw_visits;
  Offset cell_visits;
};

}  // namespace cellsearch::production
