// SPDX-License-Identifier: BSD-3-Clause
// *DEFINE_TRANSFORMATION, *NODE_TRANSFORM.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "deck/format/numbers.hpp"
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field transformation_card[] = {id("TRANID")};

constexpr Field step_card[] = {text("OPTION", 10), real("A1"), real("A2"), real("A3"),
                               real("A4"),         real("A5"), real("A6"), real("A7")};

constexpr Field node_transform_card[] = {
    id("TRSID", IdKind::Definition), id("NSID"),
    unused("IMMED"),  // when in the reading the nodes are moved
};

/// A point that lines of a transformation refer to, with the coordinates that its line has. Codes differ in
/// what the lines before make of it, so that it can only be used where none has moved anything.
struct NamedPoint {
  double id = 0;
  Vector x{};
};

/// The lines of one transformation: each acts on what the lines before it have made of the points.
/// OpenRadioss reads these decks in the same way.
class TransformationLines {
 public:
  explicit TransformationLines(Report& report) : report_(&report) {}

  void take(const Card& card);
  const Affine& map() const { return map_; }

 private:
  Vector values(const Card& card, std::size_t first) const;
  void apply(const Affine& step) {
    map_ = then(map_, step);
    has_moved_ = true;
  }
  void scale(const Card& card);
  void rotate(const Card& card);
  void mirror(const Card& card);
  void place_by_points(const Card& card);
  std::optional<Vector> point_of(const Card& card, std::string_view field);

  Report* report_;
  Affine map_;
  bool has_moved_ = false;
  std::vector<NamedPoint> points_;
};

constexpr std::string_view value_names[] = {"A1", "A2", "A3", "A4", "A5", "A6", "A7"};

Vector TransformationLines::values(const Card& card, std::size_t first) const {
  return {card.real(value_names[first]), card.real(value_names[first + 1]),
          card.real(value_names[first + 2])};
}

void TransformationLines::take(const Card& card) {
  const std::string option = upper_case(card.text("OPTION"));
  if (option == "TRANSL")
    apply(shift_by(values(card, 0)));
  else if (option == "SCALE")
    scale(card);
  else if (option == "ROTATE")
    rotate(card);
  else if (option == "MIRROR")
    mirror(card);
  else if (option == "POINT")
    points_.push_back({card.real("A1"), values(card, 1)});
  else if (option == "POS6P")
    place_by_points(card);
  else
    report_->code_unsupported(
        card.where(),
        {"OPTION", std::string(card.text("OPTION")), "TRANSL, ROTATE, SCALE, MIRROR, POINT or POS6P",
         "others are not supported; two POINTs and ROTATE, or six and POS6P, "
         "do what those by nodes do",
         "option"});
}

void TransformationLines::scale(const Card& card) {
  Vector factor = values(card, 0);
  for (double& one : factor)
    if (one == 0) one = 1;
  apply(scaling(factor));
}

void TransformationLines::rotate(const Card& card) {
  // By points A1 and A2 are ids and A3 is the angle; an angle A7 of zero leaves the same fields blank.
  const bool by_points = card.real("A1") != 0 && card.real("A2") != 0 && card.real("A4") == 0 &&
                         card.real("A5") == 0 && card.real("A6") == 0 && card.real("A7") == 0;
  Vector axis = values(card, 0);
  Vector point = values(card, 3);
  double degrees = card.real("A7");
  if (by_points) {
    const std::optional<Vector> from = point_of(card, "A1");
    const std::optional<Vector> to = point_of(card, "A2");
    if (!from || !to) return;
    point = *from;
    axis = difference(*to, *from);
    degrees = card.real("A3");
  }
  if (length_of(axis) > 0)
    apply(rotation(axis, point, degrees * std::numbers::pi / 180));
  else
    report_->field_error(card.where(), {"A1", std::string(card.text("A1")), "an axis that is not zero",
                                        by_points ? "the two points are at the same place"
                                                  : "A1, A2, A3 are the direction of the axis",
                                        "axis"});
}

void TransformationLines::mirror(const Card& card) {
  const Vector point = values(card, 0);
  const Vector normal = difference(values(card, 3), point);
  if (card.real("A7") != 0)
    report_->field_unsupported(card.where(), {"A7", std::string(card.text("A7")), "0",
                                              "left-handed coordinate systems are not supported", "handed"});
  if (length_of(normal) > 0)
    apply(mirroring(point, normal));
  else
    report_->field_error(card.where(),
                         {"A4", std::string(card.text("A4")), "a second point",
                          "the normal of the plane goes from A1, A2, A3 to A4, A5, A6", "normal"});
}

/// Moves the first three points to the other three, as far as a rigid motion can: the first one to the
/// fourth, the line to the second and the plane to the third one.
void TransformationLines::place_by_points(const Card& card) {
  std::array<Vector, 6> x{};
  for (std::size_t i = 0; i < 6; ++i) {
    const std::optional<Vector> point = point_of(card, value_names[i]);
    if (!point) return;
    x[i] = *point;
  }
  const auto from = local_axes(difference(x[1], x[0]), difference(x[2], x[0]));
  const auto to = local_axes(difference(x[4], x[3]), difference(x[5], x[3]));
  if (!from || !to) {
    const std::string_view field = from ? "A4" : "A1";
    report_->field_error(card.where(), {field, std::string(card.text(field)),
                                        "three points that span a plane", "they lie on one line", "plane"});
    return;
  }
  Affine step;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      step.linear[i][j] = 0;
      for (std::size_t k = 0; k < 3; ++k) step.linear[i][j] += (*to)[k][i] * (*from)[k][j];
    }
  step.shift = difference(x[3], step.of_direction(x[0]));
  apply(step);
}

std::optional<Vector> TransformationLines::point_of(const Card& card, std::string_view field) {
  const double id = card.real(field);
  const auto found =
      std::find_if(points_.begin(), points_.end(), [&](const NamedPoint& point) { return point.id == id; });
  if (found != points_.end()) {
    if (has_moved_)
      report_->field_unsupported(
          card.where(), {field, std::string(card.text(field)), "a point before all lines that move",
                         "whether such a line moves the point as well differs from code to code; put lines "
                         "with points first, or give the axis by its direction",
                         "moved point"});
    return found->x;
  }
  if (card.good(field))
    report_->field_error(card.where(), {field, std::string(card.text(field)), "the id of a point",
                                        "define it with a line POINT before this one", "point"});
  return std::nullopt;
}

}  // namespace

void read_define_transformation(Cards& cards, RawDeck& deck) {
  cards.heading();
  const Card card = cards.next(transformation_card);
  TransformationLines lines(cards.report());
  while (cards.more()) lines.take(cards.next_filled(step_card));
  if (card.good("TRANID"))
    deck.transformations.push_back({card.integer("TRANID"), lines.map(), card.where()});
}

void read_node_transform(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(node_transform_card);
    if (card.good("TRSID") && card.good("NSID"))
      deck.node_transforms.push_back({card.integer("TRSID"), card.integer("NSID"), card.where()});
  }
}

}  // namespace crumple::deck
