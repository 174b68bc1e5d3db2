// SPDX-License-Identifier: BSD-3-Clause
#include "compare/readers/ascii_reader.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "compare/curves/quantity_names.hpp"
#include "compare/readers/curve_collector.hpp"
#include "compare/readers/number_scanner.hpp"

namespace crumple::compare {

namespace {

constexpr std::array<std::string_view, 5> names = {"glstat", "matsum", "rwforc", "rcforc", "nodout"};

/// A time that is not known: points without one are not kept.
constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string id_text(double id) {
  return std::to_string(std::llround(id));
}

bool is_id(double value) {
  return value >= 0 && value < 9e15 && value == std::floor(value);
}

/// The number behind a word, as in `( at time 1.0E-03 )`.
std::optional<double> number_after(std::string_view line, std::string_view word) {
  const std::size_t place = line.find(word);
  if (place == std::string_view::npos) return std::nullopt;
  std::string_view rest = line.substr(place + word.size());
  return take_number(rest);
}

struct LabelledNumber {
  std::string_view label;
  std::optional<double> value;
};

/// The words before dots that blanks and a number follow, as in ` time
/// step......................   1.00000E-06`.
LabelledNumber labelled_number(std::string_view line) {
  for (std::size_t dot = line.find('.'); dot != std::string_view::npos;) {
    const std::size_t end = line.find_first_not_of('.', dot);
    if (end == std::string_view::npos) break;
    if (line[end] == ' ') {
      std::string_view rest = line.substr(end);
      return {trimmed(line.substr(0, dot)), take_number(rest)};
    }
    dot = line.find('.', end);
  }
  return {};
}

/// Blocks of one quantity a line, ` kinetic energy.................   1.00000E+00`; a block starts with its
/// time.
std::vector<Curve> read_glstat(std::string_view text) {
  CurveCollector collector("glstat");
  double time = none;
  std::map<std::string, double> block;
  const auto finish_block = [&] {
    for (const auto& [quantity, value] : block) collector.add(quantity, "", time, value);
    block.clear();
    time = none;
  };
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    if (line.find("dt of cycle") != std::string_view::npos) finish_block();
    const auto [label, value] = labelled_number(line);
    if (!value) continue;
    const std::string name = binout_spelling(label);
    if (name == "time") {
      finish_block();
      time = *value;
      continue;
    }
    const std::string quantity = from_ls_dyna("glstat", name);
    // Each wall has a line of its own.
    if (quantity == "rigidwall")
      block[quantity] += *value;
    else if (!quantity.empty())
      block[quantity] = *value;
  }
  finish_block();
  return collector.take();
}

/// The pairs of a line ` mat.#=    1             inten=   0.0000E+00     kinen=   0.0000E+00`.
void for_each_pair(std::string_view line, const std::function<void(std::string_view, double)>& use) {
  for (std::size_t equals = line.find('='); equals != std::string_view::npos;
       equals = line.find('=', equals + 1)) {
    std::string_view rest = line.substr(equals + 1);
    const std::string_view before = trimmed(line.substr(0, equals));
    const std::size_t blank = before.find_last_of(" \t");
    const std::string_view key = blank == std::string_view::npos ? before : before.substr(blank + 1);
    if (const std::optional<double> value = take_number(rest)) use(key, *value);
  }
}

std::vector<Curve> read_matsum(std::string_view text) {
  CurveCollector collector("matsum");
  double time = none;
  std::string part;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    for_each_pair(line, [&](std::string_view key, double value) {
      if (key == "time") {
        time = value;
        part.clear();
      } else if (key == "mat.#") {
        part = is_id(value) ? id_text(value) : "";
      } else if (!part.empty() && key != "ID" && key != "elements") {
        collector.add(from_ls_dyna("matsum", key), part, time, value);
      }
    });
    // What follows the parts speaks of single elements.
    if (line.find("Maximum mass increase") != std::string_view::npos) part.clear();
  }
  return collector.take();
}

/// A table `time wall# normal-force x-force y-force z-force`, between which lines of segments and sums of
/// node sets may stand.
std::vector<Curve> read_rwforc(std::string_view text) {
  CurveCollector collector("rwforc");
  bool in_table = false;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    if (line.find("normal-force") != std::string_view::npos) in_table = true;
    if (line.find("r i g i d   w a l l") != std::string_view::npos) in_table = false;
    if (!in_table) continue;
    const std::vector<double> row = take_numbers(line);
    if (row.size() != 6 || !is_id(row[1])) continue;
    const std::string wall = id_text(row[1]);
    collector.add("normal", wall, row[0], row[2]);
    collector.add("fx", wall, row[0], row[3]);
    collector.add("fy", wall, row[0], row[4]);
    collector.add("fz", wall, row[0], row[5]);
  }
  return collector.take();
}

/// Lines `  slave           1 time 0.0000E+00  x  0.0  y  0.0  z  0.0 mass  0.0`, or `SURFA` and `SURFB` in
/// newer ones.
class RcforcLine {
 public:
  /// False for any other line.
  bool read(std::string_view line) {
    rest_ = trimmed(line);
    if (take_word("slave") || take_word("SURFA"))
      side = "first";
    else if (take_word("master") || take_word("SURFB"))
      side = "second";
    else
      return false;
    const std::optional<double> number = take_number(rest_);
    if (!number || !is_id(*number)) return false;
    id = id_text(*number);
    return take_value("time", time) && take_value("x", force[0]) && take_value("y", force[1]) &&
           take_value("z", force[2]);
  }
  std::optional<double> mass() {
    double value = 0;
    if (!take_value("mass", value)) return std::nullopt;
    return value;
  }

  std::string_view side;
  std::string id;
  double time = 0;
  std::array<double, 3> force{};

 private:
  bool take_word(std::string_view word) {
    rest_ = trimmed(rest_);
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  bool take_value(std::string_view word, double& value) {
    if (!take_word(word)) return false;
    const std::optional<double> number = take_number(rest_);
    if (number) value = *number;
    return number.has_value();
  }

  std::string_view rest_;
};

std::vector<Curve> read_rcforc(std::string_view text) {
  CurveCollector collector("rcforc");
  std::set<std::string> single;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    if (line.find("is single surface") != std::string_view::npos)
      if (const std::optional<double> id = number_after(line, "number,")) single.insert(id_text(*id));
    RcforcLine row;
    if (!row.read(line)) continue;
    const std::string item = row.id + " " + (single.contains(row.id) ? "single" : std::string(row.side));
    collector.add("fx", item, row.time, row.force[0]);
    collector.add("fy", item, row.time, row.force[1]);
    collector.add("fz", item, row.time, row.force[2]);
    if (const std::optional<double> mass = row.mass()) collector.add("mass", item, row.time, *mass);
  }
  return collector.take();
}

/// For each time a table of displacements, velocities, accelerations and coordinates, and maybe one of
/// rotations.
std::vector<Curve> read_nodout(std::string_view text) {
  constexpr std::array<std::string_view, 12> moving = {"ux", "uy", "uz", "vx", "vy", "vz",
                                                       "ax", "ay", "az", "x",  "y",  "z"};
  constexpr std::array<std::string_view, 9> turning = {
      "rx_displacement", "ry_displacement", "rz_displacement", "rx_velocity",    "ry_velocity",
      "rz_velocity",     "rx_acceleration", "ry_acceleration", "rz_acceleration"};
  CurveCollector collector("nodout");
  double time = none;
  std::span<const std::string_view> columns;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    if (line.find("n o d a l") != std::string_view::npos) {
      time = number_after(line, "at time").value_or(none);
      columns = {};
    } else if (line.find("nodal point") != std::string_view::npos) {
      columns = line.find("x-rot") != std::string_view::npos ? std::span<const std::string_view>(turning)
                                                             : std::span<const std::string_view>(moving);
    } else if (!columns.empty()) {
      const std::vector<double> row = take_numbers(line);
      if (row.size() != columns.size() + 1 || !is_id(row[0])) continue;
      for (std::size_t column = 0; column < columns.size(); ++column)
        collector.add(columns[column], id_text(row[0]), time, row[column + 1]);
    }
  }
  return collector.take();
}

}  // namespace

std::span<const std::string_view> ascii_files() {
  return names;
}

std::vector<Curve> read_ascii(std::string_view text, std::string_view name) {
  if (name == "glstat") return read_glstat(text);
  if (name == "matsum") return read_matsum(text);
  if (name == "rwforc") return read_rwforc(text);
  if (name == "rcforc") return read_rcforc(text);
  if (name == "nodout") return read_nodout(text);
  return {};
}

}  // namespace crumple::compare
