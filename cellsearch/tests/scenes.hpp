// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "cellsearch/cell_grid.hpp"
#include "cellsearch/scene.hpp"

namespace cellsearch::scenes {

/// Random numbers that are the same on every platform (the standard's distributions are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [lo, hi).
  double uniform(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

  /// Uniform in 0..count-1, count > 0.
  Index below(std::size_t count) { return static_cast<Index>(engine_() % count); }

 private:
  std::mt19937_64 engine_;
};

/// A mesh with the memory that a Scene views.
struct Mesh {
  std::string name{};
  std::size_t stride = 3;
  std::vector<double> positions{};          ///< stride numbers per node [length]
  std::vector<Index> segments{};            ///< 4 per segment
  double expansion = 0.0;                   ///< c [length]
  std::vector<double> segment_expansion{};  ///< empty or one per segment [length]
  std::optional<std::vector<Index>> nodes{};
  std::optional<CellDomain> domain{};

  /// Views of this mesh; it must outlive them.
  Scene scene() const;

  std::size_t node_count() const { return positions.size() / stride; }
  std::size_t segment_count() const { return segments.size() / 4; }

  Index add_node(double x, double y, double z);
  void add_segment(Index a, Index b, Index c, Index d) { segments.insert(segments.end(), {a, b, c, d}); }

  /// Mean edge of the segments [length].
  double mean_edge() const;

  /// Rotates about z by `about_z`, then about x by `about_x` [rad], so that nothing is parallel to the cells.
  void rotate(double about_z, double about_x);
};

/// Two sheets, half an edge apart and folded into meanders whose folds nearly touch: about `nodes` nodes,
/// edges of about 1 [length].
Mesh folded_sheets(int nodes, std::uint64_t seed);

/// An axially crushed square tube, its wall in concertina folds: about `nodes` nodes, edges of about 1.
Mesh crushed_tube(int nodes, std::uint64_t seed);

/// Segments of random nodes; neither sizes nor neighbours mean anything.
Mesh random_soup(int nodes, int segments, std::uint64_t seed);

/// A flat plate with edges of 1 and beside it small patches with edges of 1/`ratio`.
Mesh mixed_sizes(int nodes, double ratio, std::uint64_t seed);

/// Small patches of segments, scattered over a space `spread` times their size.
Mesh sparse_patches(int patches, double spread, std::uint64_t seed);

/// Number of kinds of meshes that make_mesh() draws from.
int kinds();

/// One mesh of up to some hundred nodes for tests against brute force, of kind seed % kinds(): all scenes
/// above and degenerate ones (coincident, collinear, coplanar nodes, one cell, one segment, no segment,
/// territories outside, partial domains, huge coordinates, padded records, lists of nodes ...).
Mesh make_mesh(std::uint64_t seed);

}  // namespace cellsearch::scenes
