// SPDX-License-Identifier: BSD-3-Clause
#include "compare/readers/csv_reader.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "compare/readers/curve_collector.hpp"
#include "compare/readers/number_scanner.hpp"

namespace crumple::compare {

namespace {

/// Columns of our histories that are no quantity but say what a row belongs to.
constexpr std::array<std::string_view, 12> item_columns = {"part",    "wall",    "interface", "side",
                                                           "node",    "body",    "weld",      "kind",
                                                           "element", "section", "plane",     "point"};

using Pair = std::pair<std::string_view, std::string_view>;

/// What th_to_csv calls the global variables of OpenRadioss. Translational and rotational kinetic energy are
/// one with us.
constexpr std::array radioss_names = {
    Pair{"INTERNAL ENERGY", "internal"},
    Pair{"KINETIC ENERGY", "translational_kinetic"},
    Pair{"ROTATION ENERGY", "rotational_kinetic"},
    Pair{"X-MOMENTUM", "x_momentum"},
    Pair{"Y-MOMENTUM", "y_momentum"},
    Pair{"Z-MOMENTUM", "z_momentum"},
    Pair{"MASS", "mass"},
    Pair{"TIME STEP", "dt"},
    Pair{"EXTERNAL WORK", "external_work"},
    Pair{"SPRING ENERGY", "spring_and_damper"},
    Pair{"CONTACT ENERGY", "sliding_interface"},
    Pair{"HOURGLASS ENERGY", "hourglass"},
    Pair{"ELASTIC CONTACT ENERGY", "contact"},
    Pair{"FRICTIONAL CONTACT ENERGY", "friction"},
    Pair{"DAMPING CONTACT ENERGY", "contact_damping"},
};

/// Cells of a line; quotes may hold commas. Inner runs of spaces become one, th_to_csv pads its names.
std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char letter : line) {
    if (letter == '"') {
      quoted = !quoted;
    } else if (letter == ',' && !quoted) {
      cells.emplace_back();
    } else if (letter != ' ' || (!cells.back().empty() && cells.back().back() != ' ')) {
      cells.back() += letter;
    }
  }
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

/// What printf writes of numbers that are none.
bool is_not_finite(const std::string& cell) {
  const std::string text = lower_case(cell);
  const std::string_view unsigned_text =
      std::string_view(text).substr(text.starts_with('-') || text.starts_with('+') ? 1 : 0);
  return unsigned_text == "nan" || unsigned_text == "inf";
}

bool is_item(const std::string& name) {
  return std::find(item_columns.begin(), item_columns.end(), name) != item_columns.end();
}

/// Reads the rows of a table whose columns are known.
class Table {
 public:
  Table(std::vector<std::string> names, std::string_view group)
      : names_(std::move(names)), collector_(std::string(group)) {}

  void add_row(std::string_view line) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() < names_.size()) return;
    const std::optional<double> time = only_number(cells[0]);
    if (!time) return;
    std::string item;
    for (std::size_t column = 1; column < names_.size(); ++column)
      if (is_item(names_[column])) item.append(item.empty() ? "" : " ").append(cells[column]);
    for (std::size_t column = 1; column < names_.size(); ++column) {
      if (is_item(names_[column])) continue;
      if (const std::optional<double> value = only_number(cells[column]))
        collector_.add(names_[column], item, *time, *value);
      else if (is_not_finite(cells[column]))
        collector_.add(names_[column], item, *time, std::numeric_limits<double>::quiet_NaN());
    }
  }

  std::vector<Curve> take() { return collector_.take(); }

 private:
  std::vector<std::string> names_;
  CurveCollector collector_;
};

bool is_radioss(const std::vector<std::string>& names) {
  return names.size() > 12 && names[1] == "INTERNAL ENERGY" && names[2] == "KINETIC ENERGY";
}

/// The sum of translational and rotational kinetic energy, which is what we call kinetic.
void add_kinetic(std::vector<Curve>& curves) {
  const Curve* moving = nullptr;
  const Curve* turning = nullptr;
  for (const Curve& curve : curves) {
    if (curve.quantity == "translational_kinetic") moving = &curve;
    if (curve.quantity == "rotational_kinetic") turning = &curve;
  }
  if (moving == nullptr || turning == nullptr || moving->times != turning->times) return;
  Curve sum = *moving;
  sum.quantity = "kinetic";
  for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += turning->values[i];
  curves.push_back(std::move(sum));
}

std::vector<Curve> with_radioss_names(std::vector<Curve> curves) {
  for (Curve& curve : curves)
    for (const auto& [theirs, ours] : radioss_names)
      if (curve.quantity == theirs) {
        curve.group = "glstat";
        curve.quantity = ours;
      }
  add_kinetic(curves);
  return curves;
}

}  // namespace

std::vector<Curve> read_csv(std::string_view text, std::string_view group) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<std::string> names = cells_of(take_line(text));
  if (names.size() < 2 || lower_case(names[0]) != "time")
    throw Error("the first line does not name columns, of which the first is the time.");
  const bool radioss = is_radioss(names);
  while (names.size() > 2 && names.back().empty()) names.pop_back();
  Table table(std::move(names), radioss ? "th" : group);
  while (!text.empty()) table.add_row(take_line(text));
  return radioss ? with_radioss_names(table.take()) : table.take();
}

}  // namespace crumple::compare
