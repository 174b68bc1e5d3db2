// SPDX-License-Identifier: BSD-3-Clause
// What the transformation of a file does to the values of its cards.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "deck/format/cards.hpp"

namespace crumple::deck {

namespace {

/// Three fields one behind the other that say where something is or where it goes.
bool is_vector(Geometry geometry) {
  return geometry == Geometry::Point || geometry == Geometry::Direction || geometry == Geometry::Velocity ||
         geometry == Geometry::Spin;
}

Vector placed(const Affine& map, Geometry geometry, const Vector& x) {
  Vector result = geometry == Geometry::Point ? map.of_point(x) : map.of_direction(x);
  // The vector of a rotation is none of space: mirrored, it turns the other way.
  if (geometry == Geometry::Spin && map.mirrors())
    for (double& component : result) component = -component;
  return result;
}

/// DOF 4 and 8 are along and about a vector or the normal of nodes, which turn with the file.
bool is_along_vector(const Field& field, std::int64_t value) {
  return field.name == "DOF" && (std::abs(value) == 4 || std::abs(value) == 8);
}

/// A code or three fields that hold a point, or its rotations, along all axes: that is the same for any axes.
bool holds_all(const Card& card, const Field& field, std::int64_t value) {
  constexpr std::string_view codes[] = {"TC", "RC"};
  if (std::ranges::find(codes, field.name) != std::end(codes)) return value == 7;
  constexpr std::array<std::string_view, 3> moves = {"DOFX", "DOFY", "DOFZ"};
  constexpr std::array<std::string_view, 3> turns = {"DOFRX", "DOFRY", "DOFRZ"};
  for (const auto& three : {moves, turns})
    if (std::ranges::find(three, field.name) != three.end())
      return std::ranges::all_of(three, [&](std::string_view name) { return card.integer(name) != 0; });
  return false;
}

}  // namespace

void Cards::place(Card& card) {
  bool has_system = false;
  for (std::size_t i = 0; i < card.layout_.size(); ++i) {
    const std::string_view name = card.layout_[i].name;
    has_system = has_system || ((name == "CID" || name == "ICID") && card.values_[i].integer != 0);
  }
  for (std::size_t i = 0; i < card.layout_.size(); ++i) {
    const Field& field = card.layout_[i];
    if (field.geometry == Geometry::None || (field.is_local && has_system)) continue;
    if (!is_vector(field.geometry)) {
      if (!is_along_vector(field, card.values_[i].integer)) check_placed(card, i);
    } else if (i + 2 < card.layout_.size()) {
      place_vector(card, i);
      i += 2;
    }
  }
}

void Cards::place_vector(Card& card, std::size_t first) {
  const Geometry geometry = card.layout_[first].geometry;
  const Affine& map = placement().map;
  Vector x{};
  for (std::size_t i = 0; i < 3; ++i) x[i] = card.values_[first + i].real;
  const bool is_motion = geometry == Geometry::Velocity || geometry == Geometry::Spin;
  if (is_motion && !map.is_shift() && length_of(x) > 0) {
    const std::string_view name = card.layout_[first].name;
    const std::string text(card.values_[first].text);
    if (map.keeps_lengths())
      report_->field_warning(card.where_,
                             {name, text, "a velocity in the axes of its file",
                              "it turns with the transformation of *INCLUDE_TRANSFORM", "placed"});
    else
      report_->field_error(card.where_,
                           {name, text, "a transformation of the file that keeps lengths",
                            "whether velocities are scaled is not defined; give them outside of the "
                            "file",
                            "placed"});
  }
  x = placed(map, geometry, x);
  if (!is_finite(x)) {
    report_->error(card.where_, "placed",
                   "the transformation of *INCLUDE_TRANSFORM moves it out of the range of numbers");
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) card.values_[first + i].real = x[i];
}

void Cards::check_placed(const Card& card, std::size_t index) {
  const Field& field = card.layout_[index];
  const Card::Value& value = card.values_[index];
  const Affine& map = placement().map;
  const bool is_zero = field.type == FieldType::Integer ? value.integer == 0 : value.real == 0;
  if (is_zero || map.is_shift()) return;
  const std::string text(value.text);
  if (field.geometry == Geometry::Axes && holds_all(card, field, value.integer)) return;
  if (field.geometry == Geometry::Axes)
    report_->field_warning(card.where_,
                           {field.name, text, "axes that turn with the file",
                            "the global axes are taken, though *INCLUDE_TRANSFORM turns or scales "
                            "the file",
                            "placed"});
  else if (field.geometry == Geometry::Fixed)
    report_->field_error(card.where_,
                         {field.name, text, "a transformation of the file that only moves",
                          "*INCLUDE_TRANSFORM cannot turn or scale this value; give it outside of the "
                          "file",
                          "placed"});
  else if (!map.keeps_lengths())
    report_->field_error(
        card.where_,
        {field.name, text, "a transformation of the file that keeps lengths",
         "*INCLUDE_TRANSFORM does not scale this length; give it outside of the file", "placed"});
}

}  // namespace crumple::deck
