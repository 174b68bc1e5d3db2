// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "cellsearch/box.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch::production {

/// A node as the query reads it: its place in the fine lattice and among the sorted nodes.
struct alignas(16) NodeRecord {
  std::array<std::int32_t, 3> fine;
  std::uint32_t place;  ///< while the grid is built: its cell; no_place if it takes no part
};

inline constexpr std::uint32_t no_place = 0xffffffffU;

/// Cells in rows, and within them a fine lattice to which coordinates are rounded.
///
/// A coordinate x becomes trunc(x * scale + offset), cut to +-2^29. This never decreases with x, also in
/// floating point, and therefore loses nothing: lo <= x <= hi implies the same of the rounded numbers. What
/// lies strictly inside in the lattice is inside, what lies outside is outside, and only what is next to a
/// face must be looked at again in double precision.
///
/// Cells along the run axis are numbered one after another (a row), rows along the second axis make layers.
/// Each row and layer has one more empty cell at its end, so that a look beyond the last one finds nothing.
/// The arrays have four entries so that they load as vectors; the fourth is 0.
struct alignas(32) Grid {
  std::array<double, 4> scale{};         ///< lattice units per length [1/length]
  std::array<double, 4> offset{};        ///< [lattice units]
  std::array<std::int32_t, 4> top{};     ///< largest lattice number of a node
  std::array<std::int32_t, 4> shift{};   ///< cell = lattice number >> shift
  std::array<std::int32_t, 4> step{};    ///< from a cell to the next along each axis, in cell numbers
  std::array<std::int32_t, 4> margin{};  ///< lattice units by which rounding may be off, at most
  std::array<Index, 3> cells{1, 1, 1};   ///< without the empty ones
  std::array<int, 3> axis{0, 1, 2};      ///< run axis, second, third
  Offset first_cell = 0;                 ///< where its cells begin in the array of starts
  Offset cell_count = 1;                 ///< with the empty ones
};

/// Bits of the lattice number below the eight that the vector test compares.
inline constexpr int fine_bits = 10;
/// Bits within a cell, along the run axis and across it.
inline constexpr int run_bits = 5;
inline constexpr int cross_bits = 6;
/// Largest lattice number that a coordinate is cut to.
inline constexpr std::int32_t lattice_limit = 1 << 29;
/// A cell with no more nodes is never divided. One with more is if the territories in it are much smaller
/// than it, and one with far more in any case, if its nodes can be told apart.
inline constexpr std::uint32_t most_in_cell = 64;
inline constexpr std::uint32_t most_in_any_cell = 512;
/// Territories are much smaller than a cell if they are smaller than this part of its edge.
inline constexpr double much_smaller = 0.015;
/// Entries that may be read beyond the last sorted node.
inline constexpr std::size_t padding = 128;

/// Cell edges of a grid.
struct CellEdges {
  int run_axis = 0;
  double run = 0.0;                 ///< along the run axis [length]
  double cross = 0.0;               ///< across it [length]
  double smallest_territory = 0.0;  ///< by its largest extent, in a sample; 0: not known [length]
};

/// Numbers of cells that `make_grid` would use for a box, with the empty ones; never overflows.
double cells_for(const Box& nodes, const CellEdges& edges);

/// A grid over `nodes` (finite, not empty; may be flat). Edges are made larger where the lattice would
/// overflow.
Grid make_grid(const Box& nodes, const CellEdges& edges);

}  // namespace cellsearch::production
