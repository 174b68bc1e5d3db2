// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numeric>
#include <utility>

#include "scenes.hpp"
#include "shapes.hpp"

namespace cellsearch::scenes {

Scene Mesh::scene() const {
  Scene scene;
  scene.positions = Positions(positions, stride);
  scene.segments = Segments(segments);
  scene.expansion = expansion;
  scene.segment_expansion = segment_expansion;
  if (nodes) scene.nodes = *nodes;
  return scene;
}

Index Mesh::add_node(double x, double y, double z) {
  const Index node = static_cast<Index>(node_count());
  positions.insert(positions.end(), {x, y, z});
  if (stride > 3) positions.resize(positions.size() + stride - 3, -77.0);
  return node;
}

double Mesh::mean_edge_of(std::size_t segment) const {
  double sum = 0.0;
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const double* from = &positions[static_cast<std::size_t>(segments[4 * segment + corner]) * stride];
    const double* to =
        &positions[static_cast<std::size_t>(segments[4 * segment + (corner + 1) % 4]) * stride];
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis) square += (to[axis] - from[axis]) * (to[axis] - from[axis]);
    sum += std::sqrt(square);
  }
  return 0.25 * sum;
}

double Mesh::mean_edge() const {
  double sum = 0.0;
  for (std::size_t segment = 0; segment < segment_count(); ++segment) sum += mean_edge_of(segment);
  return segments.empty() ? 0.0 : sum / static_cast<double>(segment_count());
}

void Mesh::rotate(double about_z, double about_x) {
  const double cz = cosine(about_z);
  const double sz = sine(about_z);
  const double cx = cosine(about_x);
  const double sx = sine(about_x);
  for (std::size_t node = 0; node < node_count(); ++node) {
    double* p = &positions[node * stride];
    const double x = cz * p[0] - sz * p[1];
    const double y = sz * p[0] + cz * p[1];
    const double z = p[2];
    p[0] = x;
    p[1] = cx * y - sx * z;
    p[2] = sx * y + cx * z;
  }
}

void Mesh::shuffle(std::uint64_t seed) {
  Random random(seed);
  std::vector<Index> place(node_count());
  std::iota(place.begin(), place.end(), 0);
  for (std::size_t k = place.size(); k > 1; --k) {
    std::swap(place[k - 1], place[static_cast<std::size_t>(random.below(k))]);
  }
  std::vector<double> moved(positions.size());
  for (std::size_t node = 0; node < place.size(); ++node) {
    const std::size_t to = static_cast<std::size_t>(place[node]) * stride;
    for (std::size_t k = 0; k < stride; ++k) moved[to + k] = positions[node * stride + k];
  }
  positions = std::move(moved);
  for (Index& node : segments) node = place[static_cast<std::size_t>(node)];
  for (std::size_t k = segment_count(); k > 1; --k) {
    const std::size_t other = static_cast<std::size_t>(random.below(k));
    for (std::size_t corner = 0; corner < 4; ++corner) {
      std::swap(segments[4 * (k - 1) + corner], segments[4 * other + corner]);
    }
    if (!segment_expansion.empty()) std::swap(segment_expansion[k - 1], segment_expansion[other]);
  }
}

Frame Frame::turned(const Point& origin, const Point& turns) {
  Frame frame{origin, {}};
  const double ca = cosine(turns[0]);
  const double sa = sine(turns[0]);
  const double cb = cosine(turns[1]);
  const double sb = sine(turns[1]);
  const double cc = cosine(turns[2]);
  const double sc = sine(turns[2]);
  // Euler angles z-x-z; axes[k] is where the local axis k points to.
  frame.axes[0] = {cc * ca - sc * cb * sa, sc * ca + cc * cb * sa, sb * sa};
  frame.axes[1] = {-cc * sa - sc * cb * ca, -sc * sa + cc * cb * ca, sb * ca};
  frame.axes[2] = {sc * sb, -cc * sb, cb};
  return frame;
}

std::span<const Family> families() {
  static constexpr Family all[] = {
      {1, "folded-sheets", "two crumpled sheets half an edge apart, folded to and fro", folded_sheets},
      {2, "crushed-tube", "square tubes, axially crushed into concertina folds", crushed_tube},
      {3, "refined-8", "folded sheets, 10% of the area refined 8 times", refined_sheets},
      {4, "refined-1000", "folded sheets with spots refined 1000 times", steeply_refined_sheets},
      {5, "vehicle-parts", "parts of different sizes in a large, mostly empty domain", vehicle_parts},
      {6, "soup", "small random segments at a fixed density", small_soup},
      {7, "sparse-parts", "parts scattered over a million times their size", sparse_parts},
  };
  return all;
}

}  // namespace cellsearch::scenes
