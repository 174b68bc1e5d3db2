// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "scenes.hpp"

namespace cellsearch::scenes {

/// sin(2 pi turns) to about 1e-15: the standard's sine differs between platforms in the last bit, and with it
/// who is whose candidate.
inline double sine(double turns) {
  double t = turns - std::floor(turns + 0.5);
  if (t > 0.25) t = 0.5 - t;
  if (t < -0.25) t = -0.5 - t;
  const double x = 6.283185307179586 * t;
  const double x2 = x * x;
  double sum = 1.0;
  // Taylor's series from the smallest term.
  for (int k = 10; k >= 1; --k) sum = 1.0 - sum * x2 / ((2.0 * k) * (2.0 * k + 1.0));
  return x * sum;
}

inline double cosine(double turns) {
  return sine(turns + 0.25);
}

/// The largest whole number whose cube is at most `value`, at least 1.
inline int cube_root(double value) {
  int root = 1;
  while ((root + 1.0) * (root + 1.0) * (root + 1.0) <= value) ++root;
  return root;
}

/// Adds rows x columns nodes at shape(row, column) and the quadrilaterals between them. If `closed`, the last
/// column is joined to the first. Returns the number of the first node.
template <class Shape>
Index add_patch(Mesh& mesh, int rows, int columns, bool closed, const Shape& shape) {
  const Index base = static_cast<Index>(mesh.node_count());
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Point p = shape(row, column);
      mesh.add_node(p[0], p[1], p[2]);
    }
  }
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns + (closed ? 1 : 0); ++column) {
      const Index right = (column + 1) % columns;
      mesh.add_segment(base + row * columns + column, base + row * columns + right,
                       base + (row + 1) * columns + right, base + (row + 1) * columns + column);
    }
  }
  return base;
}

/// A random point in the cube [0, size]^3.
inline Point random_point(Random& random, double size) {
  const double x = random.uniform(0.0, size);
  const double y = random.uniform(0.0, size);
  return {x, y, random.uniform(0.0, size)};
}

/// `p` moved by up to `distance` along each axis.
inline Point jittered(Point p, double distance, Random& random) {
  for (double& coordinate : p) coordinate += random.uniform(-distance, distance);
  return p;
}

/// Expands each segment by `factor` of its own mean edge.
inline void expand_by_own_edges(Mesh& mesh, double factor) {
  mesh.expansion = 0.0;
  mesh.segment_expansion.resize(mesh.segment_count());
  for (std::size_t segment = 0; segment < mesh.segment_count(); ++segment) {
    mesh.segment_expansion[segment] = factor * mesh.mean_edge_of(segment);
  }
}

/// A place and an orientation: maps local coordinates to those of the scene.
struct Frame {
  Point origin{};
  std::array<Point, 3> axes{};

  /// Turned about z, then about x, then about z again, each in turns.
  static Frame turned(const Point& origin, const Point& turns);

  Point operator()(const Point& local) const {
    Point result = origin;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < 3; ++k) result[k] += local[axis] * axes[axis][k];
    }
    return result;
  }
};

}  // namespace cellsearch::scenes
