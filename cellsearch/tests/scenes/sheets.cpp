// SPDX-License-Identifier: BSD-3-Clause
// Sheets, folded to and fro and crumpled, with spots that may be refined again and again.
#include <algorithm>
#include <cmath>
#include <vector>

#include "shapes.hpp"

namespace cellsearch::scenes {
namespace {

/// The shape of a folded sheet. Along u straight legs and half circles take turns, v runs across. What is
/// done to a leg is done to its neighbours, so that the waves never make them touch.
struct FoldedSurface {
  double leg = 0.0;     ///< length of a leg
  double offset = 0.0;  ///< of this sheet from the middle one, to the left of the direction of u

  Point operator()(double u, double v) const {
    const double half_circle = 5.0;
    const double radius = half_circle / 3.141592653589793;
    const double period = leg + half_circle;
    const double fold = std::floor(u / period);
    const double along = u - fold * period;
    const double way = std::fmod(fold, 2.0) == 0.0 ? 1.0 : -1.0;
    double height = along;
    double level = 2.0 * radius * fold;
    double up = 1.0;  // direction of u within the fold: `up` along the leg, `on` to the next one
    double on = 0.0;
    if (along > leg) {
      const double turns = 0.5 * (along - leg) / half_circle;
      up = cosine(turns);
      on = sine(turns);
      height = leg + radius * on;
      level += radius * (1.0 - up);
    }
    height -= offset * on;
    level += way * offset * up;
    if (way < 0.0) height = leg - height;
    const double wave = 1.4 * sine(v / 16.0 + 0.1) + 0.9 * sine(height / 10.0 + 0.2);
    return {height + 0.4 * sine(v / 16.0), v + 0.4 * sine(height / 10.0), level + wave};
  }
};

/// Where a lattice of elements has blocks that are refined: block x block elements in every period.
struct Spots {
  int period_rows = 1;
  int period_columns = 1;
  int first_row = 0;
  int first_column = 0;
  int block = 0;  ///< 0: nowhere

  int place_in_row(int row) const { return (row - first_row + period_rows) % period_rows; }
  int place_in_column(int column) const { return (column - first_column + period_columns) % period_columns; }

  bool has_element(int row, int column) const {
    return place_in_row(row) < block && place_in_column(column) < block;
  }
  bool has_inside(int row, int column) const {
    const int r = place_in_row(row);
    const int c = place_in_column(column);
    return r > 0 && r < block && c > 0 && c < block;
  }
  bool touches(int row, int column) const {
    return block > 0 && place_in_row(row) <= block && place_in_column(column) <= block;
  }
};

/// How elements are refined.
struct Refinement {
  Spots spots{};   ///< of the coarse lattice
  int ratio = 1;   ///< edges per coarser edge
  int levels = 0;  ///< the middle of each spot is refined again, until there are so many levels
};

/// A lattice of rows x columns elements with its first corner at u, v.
struct Lattice {
  double u = 0.0;
  double v = 0.0;
  double edge = 1.0;
  int rows = 0;
  int columns = 0;
};

/// Node numbers at the corners of the elements of a lattice; -1 where there is none.
class Corners {
 public:
  Corners(int rows, int columns)
      : width_(columns + 1),
        nodes_(static_cast<std::size_t>(rows + 1) * static_cast<std::size_t>(width_), -1) {}

  Index& at(int row, int column) { return nodes_[place(row, column)]; }
  Index at(int row, int column) const { return nodes_[place(row, column)]; }

 private:
  std::size_t place(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }

  int width_;
  std::vector<Index> nodes_;
};

class SheetMaker {
 public:
  SheetMaker(Mesh& mesh, Random& random, const FoldedSurface& surface, const Refinement& refinement)
      : mesh_(mesh), random_(random), surface_(surface), refinement_(refinement) {}

  /// Adds the coarse lattice and all that refines it.
  void add(const Lattice& lattice) { add(lattice, 0, Corners(lattice.rows, lattice.columns)); }

 private:
  /// Adds the lattice of `level`; `corners` has the nodes that the coarser lattice has made already.
  void add(const Lattice& lattice, int level, Corners corners) {
    const Spots spots = spots_of(lattice, level);
    for (int row = 0; row <= lattice.rows; ++row) {
      for (int column = 0; column <= lattice.columns; ++column) {
        Index& node = corners.at(row, column);
        if (node >= 0 || spots.has_inside(row, column)) continue;
        // Nodes that finer elements share move as little as theirs, or those would turn inside out.
        const double edge = spots.touches(row, column) ? lattice.edge / refinement_.ratio : lattice.edge;
        const Point place = surface_(lattice.u + row * lattice.edge, lattice.v + column * lattice.edge);
        const Point p = jittered(place, 0.12 * edge, random_);
        node = mesh_.add_node(p[0], p[1], p[2]);
      }
    }
    for (int row = 0; row < lattice.rows; ++row) {
      for (int column = 0; column < lattice.columns; ++column) {
        if (spots.has_element(row, column)) continue;
        mesh_.add_segment(corners.at(row, column), corners.at(row, column + 1),
                          corners.at(row + 1, column + 1), corners.at(row + 1, column));
      }
    }
    if (spots.block > 0) refine(lattice, level, spots, corners);
  }

  Spots spots_of(const Lattice& lattice, int level) const {
    if (level == refinement_.levels) return {};
    if (level == 0) return refinement_.spots;
    const int block = refinement_.spots.block;
    const int first = (lattice.rows - block) / 2;
    return {lattice.rows + block + 1, lattice.columns + block + 1, first, first, block};
  }

  void refine(const Lattice& lattice, int level, const Spots& spots, const Corners& corners) {
    const int ratio = refinement_.ratio;
    const int size = spots.block * ratio;
    for (int row = spots.first_row; row + spots.block <= lattice.rows; row += spots.period_rows) {
      for (int column = spots.first_column; column + spots.block <= lattice.columns;
           column += spots.period_columns) {
        Corners finer(size, size);
        for (int i = 0; i <= spots.block; ++i) {
          for (int j = 0; j <= spots.block; ++j) {
            finer.at(i * ratio, j * ratio) = corners.at(row + i, column + j);
          }
        }
        const double edge = lattice.edge;
        add({lattice.u + row * edge, lattice.v + column * edge, edge / ratio, size, size}, level + 1, finer);
      }
    }
  }

  Mesh& mesh_;
  Random& random_;
  FoldedSurface surface_;
  Refinement refinement_;
};

/// A sheet's lattice and the length of its legs, such that the folded block is about a cube: with columns C,
/// legs of C and 3.2 edges from leg to leg there are C^3 / 3.2 elements. Legs and columns are whole waves, so
/// that small scenes have the same orientations in the same proportions as large ones.
struct Block {
  Lattice lattice{};
  double leg = 0.0;
};

Block block_of(double elements, const Spots& spots) {
  const int cube = cube_root(3.2 * elements);
  const int across = 16 * std::max(1, (cube + 8) / 16);
  const double along = elements / across / spots.period_rows;
  const int rows = std::max(1, static_cast<int>(std::lround(along))) * spots.period_rows;
  return {{0.0, 0.0, 1.0, rows, across}, 10.0 * std::max(2, (cube + 5) / 10)};
}

void finish(Mesh& mesh) {
  mesh.rotate(0.1, 0.081);
  mesh.expansion = 0.1 * mesh.mean_edge();
}

}  // namespace

Mesh folded_sheets(int nodes, std::uint64_t seed) {
  Mesh mesh{.name = "folded sheets"};
  Random random(seed);
  Block block = block_of(0.5 * nodes, {});
  block.lattice.rows =
      std::max(1, static_cast<int>(std::lround(0.5 * nodes / (block.lattice.columns + 1))) - 1);
  for (const double offset : {-0.25, 0.25}) {
    SheetMaker maker(mesh, random, {block.leg, offset}, {});
    maker.add(block.lattice);
  }
  finish(mesh);
  return mesh;
}

Mesh refined_sheets(int nodes, std::uint64_t seed) {
  Mesh mesh{.name = "refined sheets"};
  Random random(seed);
  // 4 elements of 40 are refined: 36 of them and 256 small ones to a tile.
  const Refinement refinement{{5, 8, 1, 3, 2}, 8, 1};
  const Block block = block_of(0.5 * nodes * 40.0 / 300.0, refinement.spots);
  for (const double offset : {-0.15, 0.15}) {
    SheetMaker maker(mesh, random, {block.leg, offset}, refinement);
    maker.add(block.lattice);
  }
  finish(mesh);
  return mesh;
}

Mesh steeply_refined_sheets(int nodes, std::uint64_t seed) {
  Mesh mesh{.name = "steeply refined sheets"};
  Random random(seed);
  Refinement refinement{{5, 8, 1, 2, 1}, 4, 5};
  const Block block = block_of(0.5 * nodes * 40.0 / 140.0, refinement.spots);
  for (const double offset : {-0.25, 0.25}) {
    SheetMaker maker(mesh, random, {block.leg, offset}, refinement);
    maker.add(block.lattice);
    refinement.spots.first_row = 3;
    refinement.spots.first_column = 6;
  }
  mesh.rotate(0.1, 0.081);
  // One expansion for all would reach a hundred edges beyond the smallest.
  expand_by_own_edges(mesh, 0.1);
  return mesh;
}

}  // namespace cellsearch::scenes
