// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <span>
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

  /// Mean edge of the segments, the fourth edge of a triangle counted as 0 [length].
  double mean_edge() const;

  /// Mean edge of one segment [length].
  double mean_edge_of(std::size_t segment) const;

  /// Rotates about z by `about_z`, then about x by `about_x` [turns], so that nothing is parallel to the
  /// cells.
  void rotate(double about_z, double about_x);

  /// Numbers nodes and segments at random. Not for a mesh with a list of nodes.
  void shuffle(std::uint64_t seed);
};

/// \name The scenes of the benchmarks, as families over the number of nodes
/// What a segment sees around it (edges, spacings, folds, sizes of parts) does not depend on the number of
/// nodes, so that counts per segment stay flat as far as a method is linear. The number of nodes comes out
/// within some percent of what is asked for, or, below some thousand, as the smallest scene of the family.
/// Edges are about 1 [length] where nothing else is said, expansions 0.1 mean edges; all coordinates use the
/// full precision of double, and nothing is parallel to the axes. The same numbers on every platform.
/// @{

/// Two sheets half an edge apart, crumpled and folded to and fro into a block, 3 edges from leg to leg.
Mesh folded_sheets(int nodes, std::uint64_t seed);

/// Square tubes of 10 edges a side, crushed along their axis: concertina folds of 3 edges a leg, 0.35 edges
/// apart. One tube up to some 20 000 nodes, then a bundle: a tube that grew would turn from long to wide.
Mesh crushed_tube(int nodes, std::uint64_t seed);

/// Two folded sheets 0.3 edges apart, 10% of whose area is refined 8 times.
Mesh refined_sheets(int nodes, std::uint64_t seed);

/// Two folded sheets with spots refined in five steps of 4, from edges of 1 to edges of 1/1024; of 115
/// segments 39 are coarse and 15, 15, 15, 15 and 16 of the finer sizes. The spots of one sheet face coarse
/// segments of the other. Each segment is expanded by 0.1 of its own edge.
Mesh steeply_refined_sheets(int nodes, std::uint64_t seed);

/// Plates, profiles, tubes and boxes with edges of 0.5 to 3, in the shape of a vehicle and mostly empty
/// space.
Mesh vehicle_parts(int nodes, std::uint64_t seed);

/// Small quadrilaterals and triangles at random places, four nodes for each of its own.
Mesh small_soup(int nodes, std::uint64_t seed);

/// The parts of vehicle_parts() scattered over a space a million times their size.
Mesh sparse_parts(int nodes, std::uint64_t seed);

/// One of the above.
struct Family {
  int number;               ///< as in `cellsearch-bench --scenes`
  const char* name;         ///< without blanks
  const char* description;  ///< one line
  Mesh (*make)(int nodes, std::uint64_t seed);
};

/// All of the above, by number from 1.
std::span<const Family> families();

/// @}

/// \name Small meshes for tests
/// @{

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
/// territories outside, partial domains, huge coordinates, padded records, lists of nodes ...). All kinds
/// have names of their own, but for the two of "mixed sizes".
Mesh make_mesh(std::uint64_t seed);
/// @}

}  // namespace cellsearch::scenes
