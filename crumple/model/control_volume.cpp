// SPDX-License-Identifier: BSD-3-Clause
#include "model/control_volume.hpp"

namespace crumple::model {
namespace {

using Point = std::array<double, 3>;

double determinant(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

}  // namespace

double enclosed_volume(const std::vector<Point>& positions,
                       const std::vector<std::array<Index, 4>>& segments) {
  if (segments.empty()) return 0;
  const auto place = [&](Index node) { return positions[static_cast<std::size_t>(node)]; };
  // Seen from a node of the surface: far away from the origin digits would be lost.
  const Point origin = place(segments.front()[0]);
  double sum = 0;
  for (const std::array<Index, 4>& segment : segments) {
    std::array<Point, 4> x{};
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) x[k][axis] = place(segment[k])[axis] - origin[axis];
    sum += determinant(x[0], x[1], x[2]) + determinant(x[0], x[2], x[3]) + determinant(x[0], x[1], x[3]) +
           determinant(x[1], x[2], x[3]);
  }
  return sum / 12;
}

}  // namespace crumple::model
