// SPDX-License-Identifier: BSD-3-Clause
#include "model/beam_section.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace crumple::model {
namespace {

/// A rule on [-1, 1] whose weights sum to 1.
struct LineRule {
  std::vector<double> place;
  std::vector<double> weight;
};

/// Gauss and Lobatto points (M. Abramowitz & I.A. Stegun, Handbook of Mathematical Functions, 1964, tables
/// 25.4 and 25.6).
LineRule line_rule(SectionRule rule) {
  switch (rule) {
    case SectionRule::OnePoint:
      return {{0}, {1}};
    case SectionRule::Gauss2: {
      const double x = 1 / std::sqrt(3.0);
      return {{-x, x}, {0.5, 0.5}};
    }
    case SectionRule::Gauss3: {
      const double x = std::sqrt(0.6);
      return {{-x, 0, x}, {5.0 / 18, 8.0 / 18, 5.0 / 18}};
    }
    case SectionRule::Lobatto3:
      return {{-1, 0, 1}, {1.0 / 6, 4.0 / 6, 1.0 / 6}};
    default: {
      const double root = 2.0 / 7 * std::sqrt(1.2);
      const double inner = std::sqrt(3.0 / 7 - root);
      const double outer = std::sqrt(3.0 / 7 + root);
      const double share = std::sqrt(30.0) / 72;
      return {{-outer, -inner, inner, outer}, {0.25 - share, 0.25 + share, 0.25 + share, 0.25 - share}};
    }
  }
}

/// `intervals` of two Gauss points each.
LineRule composite_rule(int intervals) {
  const LineRule gauss = line_rule(SectionRule::Gauss2);
  LineRule rule;
  for (int i = 0; i < intervals; ++i)
    for (const double x : gauss.place) {
      rule.place.push_back((2 * i + 1 + x) / intervals - 1);
      rule.weight.push_back(0.5 / intervals);
    }
  return rule;
}

/// Products of two rules over a rectangle.
void add_product(const SectionPlate& plate, const LineRule& along_s, const LineRule& along_t,
                 std::vector<SectionPoint>& points) {
  for (std::size_t i = 0; i < along_s.place.size(); ++i)
    for (std::size_t j = 0; j < along_t.place.size(); ++j)
      points.push_back({plate.s + 0.5 * plate.width_s * along_s.place[i],
                        plate.t + 0.5 * plate.width_t * along_t.place[j],
                        plate.width_s * plate.width_t * along_s.weight[i] * along_t.weight[j]});
}

/// `count` points at equal angles on the circle of radius 1, the first half a step from the axis s; a power
/// of two from four on. By roots alone: sines of the library differ between processors.
std::vector<SectionPoint> circle_points(int count) {
  double cosine = std::sqrt(0.5);  // of pi / count
  for (int n = 4; n < count; n *= 2) cosine = std::sqrt(0.5 * (1 + cosine));
  const double sine = std::sqrt(1 - cosine * cosine);
  const double step_cosine = cosine * cosine - sine * sine;
  const double step_sine = 2 * cosine * sine;
  std::vector<SectionPoint> points{{cosine, sine, 0}};
  for (int i = 1; i < count; ++i) {
    const SectionPoint last = points.back();
    points.push_back(
        {step_cosine * last.s - step_sine * last.t, step_sine * last.s + step_cosine * last.t, 0});
  }
  return points;
}

/// Moves the plates so that the origin is the centre of their area.
std::vector<SectionPlate> centred(std::vector<SectionPlate> plates) {
  double area = 0;
  double first_s = 0;
  double first_t = 0;
  for (const SectionPlate& plate : plates) {
    const double own = plate.width_s * plate.width_t;
    area += own;
    first_s += own * plate.s;
    first_t += own * plate.t;
  }
  for (SectionPlate& plate : plates) {
    plate.s -= first_s / area;
    plate.t -= first_t / area;
  }
  return plates;
}

}  // namespace

std::vector<SectionPoint> rectangle_points(double s, double t, SectionRule rule) {
  std::vector<SectionPoint> points;
  const LineRule line = line_rule(rule);
  add_product({0, 0, s, t}, line, line, points);
  return points;
}

std::vector<SectionPoint> tube_points(double outer_diameter, double inner_diameter, SectionRule rule) {
  const double outer = 0.25 * outer_diameter * outer_diameter;
  const double inner = 0.25 * inner_diameter * inner_diameter;
  const double area = std::numbers::pi * (outer - inner);
  if (rule == SectionRule::OnePoint) return {{0, 0, area}};
  const LineRule rings = rule == SectionRule::Gauss2     ? line_rule(SectionRule::OnePoint)
                         : rule == SectionRule::Lobatto3 ? LineRule{{-1, 1}, {0.5, 0.5}}
                                                         : line_rule(SectionRule::Gauss2);
  const int around = rule == SectionRule::Gauss2 ? 4 : rule == SectionRule::Gauss4 ? 16 : 8;
  const std::vector<SectionPoint> circle = circle_points(around);
  std::vector<SectionPoint> points;
  for (std::size_t ring = 0; ring < rings.place.size(); ++ring) {
    const double radius = std::sqrt(0.5 * (outer + inner) + 0.5 * (outer - inner) * rings.place[ring]);
    for (const SectionPoint& one : circle)
      points.push_back({radius * one.s, radius * one.t, area * rings.weight[ring] / around});
  }
  return points;
}

std::vector<SectionPoint> plate_points(const std::vector<SectionPlate>& plates, int refinement) {
  const LineRule across = line_rule(SectionRule::Gauss2);
  const LineRule along = composite_rule(2 + refinement);
  std::vector<SectionPoint> points;
  for (const SectionPlate& plate : plates) {
    const bool lies_along_s = plate.width_s > plate.width_t;
    add_product(plate, lies_along_s ? along : across, lies_along_s ? across : along, points);
  }
  return points;
}

std::vector<SectionPlate> i_plates(double width, double flange, double depth, double web) {
  const double middle = 0.5 * (depth - flange);
  return {{0, middle, width, flange}, {0, -middle, width, flange}, {0, 0, web, depth - 2 * flange}};
}

std::vector<SectionPlate> channel_plates(double width, double flange, double depth, double web) {
  const double middle = 0.5 * (depth - flange);
  return centred({{0.5 * width, middle, width, flange},
                  {0.5 * width, -middle, width, flange},
                  {0.5 * web, 0, web, depth - 2 * flange}});
}

std::vector<SectionPlate> angle_plates(double width, double flange, double depth, double web) {
  return centred(
      {{0.5 * width, 0.5 * flange, width, flange}, {0.5 * web, 0.5 * (depth + flange), web, depth - flange}});
}

std::vector<SectionPlate> tee_plates(double width, double flange, double depth, double web) {
  return centred(
      {{0, depth - 0.5 * flange, width, flange}, {0, 0.5 * (depth - flange), web, depth - flange}});
}

std::vector<SectionPlate> box_plates(double width, double flange, double depth, double web) {
  const double middle_t = 0.5 * (depth - flange);
  const double middle_s = 0.5 * (width - web);
  const double height = depth - 2 * flange;
  return {{0, middle_t, width, flange},
          {0, -middle_t, width, flange},
          {middle_s, 0, web, height},
          {-middle_s, 0, web, height}};
}

void move_nodes(std::vector<SectionPoint>& points, double s, double t) {
  for (SectionPoint& point : points) {
    point.s -= s;
    point.t -= t;
  }
}

void set_points(BeamSection& section, std::vector<SectionPoint> points) {
  section.formulation = BeamFormulation::Integrated;
  section.area = section.inertia_s = section.inertia_t = 0;
  for (const SectionPoint& point : points) {
    section.area += point.area;
    section.inertia_s += point.area * point.t * point.t;
    section.inertia_t += point.area * point.s * point.s;
  }
  section.torsion = section.inertia_s + section.inertia_t;
  section.points = std::move(points);
}

bool is_round(const BeamSection& section) {
  double product = 0;
  for (const SectionPoint& point : section.points) product += point.area * point.s * point.t;
  constexpr double rounding = 1e-9;
  const double small = rounding * (section.inertia_s + section.inertia_t);
  return std::fabs(section.inertia_s - section.inertia_t) <= small && std::fabs(product) <= small;
}

}  // namespace crumple::model
