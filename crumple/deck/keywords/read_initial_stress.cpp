// SPDX-License-Identifier: BSD-3-Clause
// *INITIAL_STRESS_SHELL, *INITIAL_STRESS_SOLID and their sets.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field stress_planes_field = integer_or_default("NPLANE", 1, within(1, 4, "points in plane"));
constexpr Field layers_field =
    integer_or_default("NTHICK", 1, within(1, 100, "points through the thickness"));
constexpr Field points_field = integer_or_default("NINT", 1, within(1, 64, "integration points"));
constexpr Field histories_field = integer("NHISV", 0, within(0, 1000, "history variables of each point"));
constexpr Field tensors_field = only("NTENSR", {0}, "tensors of history are not read");
constexpr Field large_field = only("LARGE", {0, 1}, "1 has fields of 16 columns");
constexpr Field volume_field =
    only("IVEFLG", {0, 1}, "1: the last history variable is the volume of the mass");
constexpr Field group_field = only("IALEGP", {0}, "there are no ALE groups");
constexpr Field thermal_field = harmless("NTHINT", {0}, "there is no thermal solution");

constexpr Field shell_stress_card[] = {id("EID"),     stress_planes_field, layers_field,  histories_field,
                                       tensors_field, large_field,         thermal_field, unused("NTHHSV")};
constexpr Field shell_set_stress_card[] = {id("SID"),       stress_planes_field, layers_field,
                                           histories_field, tensors_field,       large_field,
                                           thermal_field,   unused("NTHHSV")};
constexpr Field solid_stress_card[] = {id("EID"),    points_field, histories_field, large_field,
                                       volume_field, group_field,  thermal_field,   unused("NTHHSV")};
constexpr Field solid_set_stress_card[] = {id("SID"),    points_field, histories_field, large_field,
                                           volume_field, group_field,  thermal_field,   unused("NTHHSV")};

// A rotation of the file would turn the tensor.
constexpr Field shell_point[] = {
    real("T", 0, within(-1, 1, "a place between the surfaces, -1 and 1")),
    fixed(real("SIGXX")),
    fixed(real("SIGYY")),
    fixed(real("SIGZZ")),
    fixed(real("SIGXY")),
    fixed(real("SIGYZ")),
    fixed(real("SIGZX")),
    real("EPS"),
};
constexpr Field solid_point[] = {
    fixed(real("SIGXX")), fixed(real("SIGYY")), fixed(real("SIGZZ")), fixed(real("SIGXY")),
    fixed(real("SIGYZ")), fixed(real("SIGZX")), real("EPS"),
};
constexpr Field large_shell_point[] = {
    sized(16, real("T", 0, within(-1, 1, "a place between the surfaces, -1 and 1"))),
    sized(16, fixed(real("SIGXX"))),
    sized(16, fixed(real("SIGYY"))),
    sized(16, fixed(real("SIGZZ"))),
    sized(16, fixed(real("SIGXY"))),
};
constexpr Field large_shell_rest[] = {
    sized(16, fixed(real("SIGYZ"))), sized(16, fixed(real("SIGZX"))), sized(16, real("EPS")),
    sized(16, fixed(real("HISV1"))), sized(16, fixed(real("HISV2"))),
};
constexpr Field large_solid_point[] = {
    sized(16, fixed(real("SIGXX"))), sized(16, fixed(real("SIGYY"))), sized(16, fixed(real("SIGZZ"))),
    sized(16, fixed(real("SIGXY"))), sized(16, fixed(real("SIGYZ"))),
};
constexpr Field large_solid_rest[] = {
    sized(16, fixed(real("SIGZX"))), sized(16, real("EPS")),          sized(16, fixed(real("HISV1"))),
    sized(16, fixed(real("HISV2"))), sized(16, fixed(real("HISV3"))),
};
constexpr std::string_view history_names[] = {"HISV1", "HISV2", "HISV3", "HISV4",
                                              "HISV5", "HISV6", "HISV7", "HISV8"};
constexpr Field stress_history_line[] = {
    fixed(real("HISV1")), fixed(real("HISV2")), fixed(real("HISV3")), fixed(real("HISV4")),
    fixed(real("HISV5")), fixed(real("HISV6")), fixed(real("HISV7")), fixed(real("HISV8")),
};
constexpr Field large_history_line[] = {
    sized(16, fixed(real("HISV1"))), sized(16, fixed(real("HISV2"))), sized(16, fixed(real("HISV3"))),
    sized(16, fixed(real("HISV4"))), sized(16, fixed(real("HISV5"))),
};

/// How many history variables follow the stresses, on which lines.
struct Layouts {
  Layout first, rest;      ///< rest is empty where all is on one line
  std::size_t beside = 0;  ///< history variables beside the stresses
  Layout history;
};
constexpr Layouts shell_layouts{shell_point, {}, 0, stress_history_line};
constexpr Layouts large_shell_layouts{large_shell_point, large_shell_rest, 2, large_history_line};
constexpr Layouts solid_layouts{solid_point, {}, 0, stress_history_line};
constexpr Layouts large_solid_layouts{large_solid_point, large_solid_rest, 3, large_history_line};

void add_histories(const Card& card, std::size_t there, std::size_t wanted, std::vector<double>& histories) {
  for (std::size_t i = 0; i < there && histories.size() < wanted; ++i)
    histories.push_back(card.real(history_names[i]));
}

struct ReadPoint {
  model::InitialPointStress point;
  std::vector<double> histories;
};

ReadPoint read_point(Cards& cards, const Layouts& layouts, std::size_t histories) {
  const bool shell = layouts.first.front().name == "T";
  const Card first = cards.next(layouts.first);
  const bool two = !layouts.rest.empty();
  const Card rest = two ? cards.next(layouts.rest) : first;
  ReadPoint read;
  if (two) add_histories(rest, layouts.beside, histories, read.histories);
  while (read.histories.size() < histories)
    add_histories(cards.next(layouts.history), layouts.history.size(), histories, read.histories);
  const bool yz_on_first = !two || !shell;
  if (shell) read.point.place = first.real("T");
  read.point.stress = {first.real("SIGXX"),
                       first.real("SIGYY"),
                       first.real("SIGZZ"),
                       first.real("SIGXY"),
                       (yz_on_first ? first : rest).real("SIGYZ"),
                       rest.real("SIGZX")};
  read.point.plastic_strain = rest.real("EPS");
  return read;
}

/// The first five may be a back stress, see build_initial_stress.cpp.
void take_histories(const std::vector<double>& histories, std::size_t count, ReadPoint& read,
                    RawInitialStress& raw) {
  for (std::size_t i = 0; i < count; ++i) {
    if (i < read.point.back_stress.size())
      read.point.back_stress[i] = histories[i];
    else
      raw.more_histories = raw.more_histories || histories[i] != 0;
    raw.has_histories = raw.has_histories || histories[i] != 0;
  }
  raw.stress.has_back_stress = count >= read.point.back_stress.size();
}

/// Points in an order of their own: plane after plane, upwards through the thickness. Of points at the same
/// place the first is in the first plane, and so on, whichever comes first in the deck, plane or layer. False
/// if there are not as many at each place as planes.
bool sort_points(std::size_t planes, model::InitialStress& stress) {
  std::vector<model::InitialPointStress>& points = stress.points;
  constexpr double same = 1e-4;
  std::vector<std::size_t> plane(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(points[i].place - points[j].place) < same) ++plane[i];
  std::vector<model::InitialPointStress> sorted;
  for (std::size_t k = 0; k < planes; ++k) {
    const auto first = static_cast<std::ptrdiff_t>(sorted.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      if (plane[i] == k) sorted.push_back(points[i]);
    if (sorted.size() != (k + 1) * (points.size() / planes)) return false;
    std::stable_sort(sorted.begin() + first, sorted.end(),
                     [](const auto& a, const auto& b) { return a.place < b.place; });
  }
  stress.planes = static_cast<int>(planes);
  points = std::move(sorted);
  return true;
}

/// Whether all points were there that the card asks for by `fields`; reports it if not.
bool has_points(std::size_t count, std::string_view fields, const RawInitialStress& raw, Report& report) {
  if (raw.stress.points.size() == count) return true;
  report.error(raw.where, "points",
               fmt::format("expected {} points ({}), found {}", count, fields, raw.stress.points.size()));
  return false;
}

void read_shell_stresses(Cards& cards, Layout layout, bool is_set, RawDeck& deck) {
  const std::string_view name = is_set ? "SID" : "EID";
  while (cards.more()) {
    const Card card = cards.next_filled(layout);
    RawInitialStress raw{.element = card.integer(name), .is_set = is_set, .where = card.where()};
    const Layouts& layouts = card.real("LARGE") == 1 ? large_shell_layouts : shell_layouts;
    const auto histories = static_cast<std::size_t>(card.integer("NHISV"));
    const auto planes = static_cast<std::size_t>(card.integer("NPLANE"));
    const std::size_t count = planes * static_cast<std::size_t>(card.integer("NTHICK"));
    for (std::size_t i = 0; i < count && cards.has_line(); ++i) {
      ReadPoint read = read_point(cards, layouts, histories);
      take_histories(read.histories, histories, read, raw);
      raw.stress.points.push_back(read.point);
    }
    if (!has_points(count, "NPLANE times NTHICK", raw, cards.report())) continue;
    if (!sort_points(planes, raw.stress)) {
      cards.report().field_error(card.where(), {"NPLANE", std::string(card.text("NPLANE")),
                                                "as many points at each T as there are in plane",
                                                "T is the place through the thickness, -1 to 1", "planes"});
      continue;
    }
    if (card.good(name)) deck.shell_stresses.push_back(std::move(raw));
  }
}

void read_solid_stresses(Cards& cards, Layout layout, bool is_set, RawDeck& deck) {
  const std::string_view name = is_set ? "SID" : "EID";
  while (cards.more()) {
    const Card card = cards.next_filled(layout);
    RawInitialStress raw{.element = card.integer(name), .is_set = is_set, .where = card.where()};
    const bool large = card.real("LARGE") == 1;
    auto histories = static_cast<std::size_t>(card.integer("NHISV"));
    const bool volume = card.real("IVEFLG") == 1;
    if ((!large && histories > 0) || (volume && histories == 0)) {
      cards.report().field_error(
          card.where(),
          {"NHISV", std::string(card.text("NHISV")), large ? "1 or more with IVEFLG = 1" : "0 with LARGE = 0",
           large ? "the volume is the last history variable" : "LARGE = 1 has history variables",
           "histories"});
      if (!large) histories = 0;
    }
    const auto count = static_cast<std::size_t>(card.integer("NINT"));
    for (std::size_t i = 0; i < count && cards.has_line(); ++i) {
      ReadPoint read = read_point(cards, large ? large_solid_layouts : solid_layouts, histories);
      const bool has_volume = volume && histories > 0;
      if (has_volume) raw.stress.volume += read.histories.back();
      take_histories(read.histories, histories - (has_volume ? 1 : 0), read, raw);
      raw.stress.points.push_back(read.point);
    }
    if (!has_points(count, "NINT", raw, cards.report())) continue;
    raw.stress.volume /= static_cast<double>(count);
    if (card.good(name)) deck.solid_stresses.push_back(std::move(raw));
  }
}

}  // namespace

void read_initial_stress_shell(Cards& cards, RawDeck& deck) {
  read_shell_stresses(cards, shell_stress_card, false, deck);
}

void read_initial_stress_shell_set(Cards& cards, RawDeck& deck) {
  read_shell_stresses(cards, shell_set_stress_card, true, deck);
}

void read_initial_stress_solid(Cards& cards, RawDeck& deck) {
  read_solid_stresses(cards, solid_stress_card, false, deck);
}

void read_initial_stress_solid_set(Cards& cards, RawDeck& deck) {
  read_solid_stresses(cards, solid_set_stress_card, true, deck);
}

}  // namespace crumple::deck
