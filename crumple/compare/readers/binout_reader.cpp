// SPDX-License-Identifier: BSD-3-Clause
#include "compare/readers/binout_reader.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>

#include "compare/curves/quantity_names.hpp"
#include "compare/readers/curve_collector.hpp"

namespace crumple::compare {

namespace {

/// A variable and the file that it lies in.
struct Place {
  const LsdaFile* file = nullptr;
  const LsdaFile::Variable* variable = nullptr;
  std::vector<double> numbers() const { return file->numbers(*variable); }
};

using Variables = std::map<std::string, Place, std::less<>>;

/// What lies under a folder such as `/rwforc/forces`.
struct Base {
  Variables metadata;
  std::map<unsigned long, Variables> states;  ///< by their number
};

/// 12 for `d000012`.
std::optional<unsigned long> state_number(std::string_view name) {
  if (name.size() < 2 || name.size() > 12 || name[0] != 'd') return std::nullopt;
  unsigned long number = 0;
  for (const char letter : name.substr(1)) {
    if (letter < '0' || letter > '9') return std::nullopt;
    number = 10 * number + static_cast<unsigned long>(letter - '0');
  }
  return number;
}

std::map<std::string, Base, std::less<>> bases_of(const std::vector<LsdaFile>& files) {
  std::map<std::string, Base, std::less<>> bases;
  for (const LsdaFile& file : files)
    for (const auto& [path, variable] : file.variables()) {
      const std::size_t name_at = path.rfind('/');
      const std::string_view folder = std::string_view(path).substr(0, name_at);
      const std::size_t last_at = folder.rfind('/');
      if (last_at == std::string_view::npos || last_at == 0) continue;
      const std::string_view last = folder.substr(last_at + 1);
      const std::string base(folder.substr(0, last_at));
      const std::string name = path.substr(name_at + 1);
      if (last == "metadata")
        bases[base].metadata[name] = {&file, &variable};
      else if (const auto number = state_number(last))
        bases[base].states[*number][name] = {&file, &variable};
    }
  return bases;
}

std::vector<double> find_numbers(const Variables& variables, std::string_view name) {
  const auto found = variables.find(name);
  return found == variables.end() ? std::vector<double>() : found->second.numbers();
}

std::string id_text(double id) {
  return std::isfinite(id) && std::abs(id) < 9e15 ? std::to_string(std::llround(id)) : "?";
}

/// What the numbers of a variable belong to.
class Items {
 public:
  Items(std::string_view group, const Base& base) {
    ids_ = texts(find_numbers(base.metadata, "ids"));
    // Walls have a running number and the user's.
    if (group == "rwforc")
      if (std::vector<std::string> walls = texts(find_numbers(base.metadata, "setid"));
          walls.size() == ids_.size())
        ids_ = std::move(walls);
    if (group == "rcforc") add_sides(find_numbers(base.metadata, "side"));
  }

  /// Of a state; elements, some of which may have gone, are listed there.
  std::vector<std::string> of_state(const Variables& state) const {
    std::vector<std::string> own = texts(find_numbers(state, "ids"));
    return own.empty() ? ids_ : own;
  }

 private:
  static std::vector<std::string> texts(const std::vector<double>& numbers) {
    std::vector<std::string> ids;
    ids.reserve(numbers.size());
    for (const double number : numbers) ids.push_back(id_text(number));
    return ids;
  }

  void add_sides(const std::vector<double>& sides) {
    for (std::size_t i = 0; i < ids_.size() && i < sides.size(); ++i)
      ids_[i] += sides[i] == 0 ? " first" : " second";
  }

  std::vector<std::string> ids_;
};

void read_state(const Variables& state, const std::vector<std::string>& items, std::string_view group,
                CurveCollector& collector) {
  const std::vector<double> time = find_numbers(state, "time");
  if (time.size() != 1) return;
  for (const auto& [name, place] : state) {
    const std::string quantity = from_ls_dyna(group, name);
    // Text is stored as integers of one byte.
    if (quantity.empty() || place.variable->type == 1) continue;
    if (group == "glstat") {
      // One for each rigid wall.
      const std::vector<double> values = place.numbers();
      double sum = 0;
      for (const double value : values) sum += value;
      if (!values.empty() && (values.size() == 1 || quantity == "rigidwall"))
        collector.add(quantity, "", time[0], sum);
    } else if (place.variable->count == items.size()) {
      const std::vector<double> values = place.numbers();
      for (std::size_t i = 0; i < values.size(); ++i) collector.add(quantity, items[i], time[0], values[i]);
    } else if (place.variable->count == 1) {
      collector.add(quantity, "", time[0], place.numbers()[0]);
    }
  }
}

}  // namespace

std::vector<Curve> read_binout(const std::vector<LsdaFile>& files) {
  std::vector<Curve> curves;
  for (const auto& [path, base] : bases_of(files)) {
    // `/rwforc/forces` belongs to rwforc; of others, as `/elout/shell`, both names are told.
    std::string group = path.substr(1);
    if (group == "rwforc/forces") group = "rwforc";
    std::replace(group.begin(), group.end(), '/', '_');
    // One row for each beam there as in our table; of shells and solids ours has the single points.
    if (group == "elout_beam") group = "elout_beams";
    const Items items(group, base);
    CurveCollector collector(group);
    for (const auto& [number, state] : base.states)
      read_state(state, items.of_state(state), group, collector);
    for (Curve& curve : collector.take()) curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace crumple::compare
