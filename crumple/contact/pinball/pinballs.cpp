// SPDX-License-Identifier: BSD-3-Clause
#include "contact/pinball/pinballs.hpp"

#include <algorithm>
#include <cmath>

#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

/// A square of the lattice of a segment: of 2^level squares along an edge, that in this row and column.
struct Cell {
  int level = 0;
  int row = 0;
  int column = 0;
};

std::array<double, 4> bilinear(double u, double v) {
  return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
}

Vec3 point_at(const SegmentShape& shape, const std::array<double, 4>& weight) {
  return weight[0] * shape.corner[0] + weight[1] * shape.corner[1] + weight[2] * shape.corner[2] +
         weight[3] * shape.corner[3];
}

std::array<double, 4> centre_of(const Cell& cell) {
  const double size = 1.0 / (1 << cell.level);
  return bilinear((cell.column + 0.5) * size, (cell.row + 0.5) * size);
}

/// The ball around all the smallest ones in a cell.
struct Around {
  Vec3 centre;
  double radius = 0;
};

Around around(const PinballShape& shape, const Cell& cell) {
  Around ball;
  ball.centre = point_at(shape.segment, centre_of(cell)) + shape.sunk;
  ball.radius = shape.radius;
  if (cell.level < shape.level) ball.radius += shape.half_diagonal / (1 << cell.level);
  return ball;
}

/// Goes down both trees, the larger ball first.
class Descent {
 public:
  Descent(const PinballShape& first, const PinballShape& second, double least)
      : first_(first), second_(second), deepest_(least) {}

  void visit(const Cell& a, const Cell& b) {
    const Around ball_a = around(first_, a);
    const Around ball_b = around(second_, b);
    const Vec3 away = ball_a.centre - ball_b.centre;
    const double depth = ball_a.radius + ball_b.radius - norm(away);
    if (depth <= deepest_) return;
    const bool split_a =
        a.level < first_.level && (b.level == second_.level || ball_a.radius >= ball_b.radius);
    if (!split_a && b.level == second_.level) {
      deepest_ = depth;
      found_ = PinballOverlap{centre_of(a), centre_of(b), away, depth};
      return;
    }
    const Cell& whole = split_a ? a : b;
    for (const int down : {0, 1})
      for (const int right : {0, 1}) {
        const Cell part{whole.level + 1, 2 * whole.row + down, 2 * whole.column + right};
        split_a ? visit(part, b) : visit(a, part);
      }
  }

  const std::optional<PinballOverlap>& found() const { return found_; }

 private:
  const PinballShape& first_;
  const PinballShape& second_;
  double deepest_;
  std::optional<PinballOverlap> found_;
};

double longest_edge(const SegmentShape& shape) {
  double longest = 0;
  for (int k = 0; k < 4; ++k) longest = std::max(longest, norm(shape.corner[(k + 1) % 4] - shape.corner[k]));
  return longest;
}

}  // namespace

Pinballs embed_pinballs(const Surface& surface, const Configuration& x) {
  Pinballs made;
  const auto count = static_cast<std::size_t>(surface.segments());
  made.radius.resize(count);
  made.level.resize(count);
  for (Index s = 0; s < surface.segments(); ++s) {
    const double edge = longest_edge(shape_of(surface, x, s));
    int level = tolerances::face_levels;
    if (!surface.is_face(s))
      for (level = 0;
           level < tolerances::most_shell_levels &&
           edge > tolerances::spacing_over_half_thickness * surface.half_thickness[s] * (1 << level);)
        ++level;
    made.level[s] = level;
    const double dense = tolerances::radius_over_spacing * edge / (1 << level);
    made.radius[s] = surface.is_face(s) ? dense : std::max(surface.half_thickness[s], dense);
  }
  return made;
}

double ball_height(const Surface& surface, const Pinballs& pinballs, Index segment) {
  return surface.is_face(segment) ? surface.half_thickness[segment] - pinballs.radius[segment] : 0;
}

PinballShape pinball_shape(const Surface& surface, const Pinballs& pinballs, const Configuration& x,
                           Index segment) {
  PinballShape shape;
  shape.segment = shape_of(surface, x, segment);
  shape.radius = pinballs.radius[segment];
  shape.level = pinballs.level[segment];
  measure_diagonal(shape);
  if (surface.is_face(segment))
    shape.sunk = ball_height(surface, pinballs, segment) * normalised(area_normal(shape.segment));
  return shape;
}

void measure_diagonal(PinballShape& shape) {
  const auto& x = shape.segment.corner;
  // A diagonal of a part is the sum of a mean of two opposite edges and one of the two others.
  double longest = 0;
  for (const Vec3& u : {x[1] - x[0], x[2] - x[3]})
    for (const Vec3& v : {x[3] - x[0], x[2] - x[1]}) longest = std::max({longest, norm(u + v), norm(u - v)});
  shape.half_diagonal = 0.5 * longest;
}

std::optional<PinballOverlap> deepest_overlap(const PinballShape& first, const PinballShape& second,
                                              double least) {
  Descent descent(first, second, least);
  descent.visit({}, {});
  return descent.found();
}

double distance_at_least(const PinballShape& first, const PinballShape& second) {
  const Around a = around(first, {});
  const Around b = around(second, {});
  return std::max(0.0, norm(a.centre - b.centre) - a.radius - b.radius);
}

}  // namespace crumple::contact
