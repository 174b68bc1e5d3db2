// SPDX-License-Identifier: BSD-3-Clause
// *DEFINE_CURVE, *DEFINE_CURVE_SMOOTH, *DEFINE_CURVE_FUNCTION, *DEFINE_TABLE.
#include <fmt/core.h>

#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "base/counted.hpp"
#include "deck/format/numbers.hpp"
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field curve_card[] = {
    id("LCID"),
    only("SIDR", {0, 1, 2}, "0 acts in the run, 1 in a dynamic relaxation before it, 2 in both"),
    real_or_default("SFA", 1.0),
    real_or_default("SFO", 1.0),
    real("OFFA"),
    real("OFFO"),
    harmless("DATTYP", {0, 1, 6}, "curves are functions, given by points"),
    unused("LCINT"),  // the points are used as they are, not resampled
};

constexpr Field function_card[] = {
    id("LCID"),
    only("SIDR", {0, 1, 2}, "0 acts in the run, 1 in a dynamic relaxation before it, 2 in both"),
};

constexpr Field table_card[] = {id("TBID"), real_or_default("SFA", 1.0), real("OFFA")};

// Without LCID the curves follow in the order of the values.
constexpr Field value_card[] = {sized(20, real("VALUE")), sized(20, reference("LCID", IdKind::Function))};

constexpr Field value_curve_card[] = {sized(20, real("VALUE")), sized(20, id("CURVEID"))};

constexpr Field point_card[] = {sized(20, real("A")), sized(20, real("O"))};

constexpr Field smooth_card[] = {
    id("LCID"),
    only("SIDR", {0, 1, 2}, "0 acts in the run, 1 in a dynamic relaxation before it, 2 in both"),
    real("DIST"),
    real("TSTART", 0, not_negative),
    real("TEND", 0, not_negative),
    real("TRISE", 0, above_zero),
    real("VMAX"),
};

RawCurve::Phase phase_of(const Card& card) {
  if (card.real("SIDR") == 1) return RawCurve::Phase::Relaxation;
  return card.real("SIDR") == 2 ? RawCurve::Phase::Both : RawCurve::Phase::Run;
}

}  // namespace

void read_define_curve(Cards& cards, RawDeck& deck) {
  cards.heading();
  const Card card = cards.next(curve_card);
  RawCurve raw;
  raw.curve.id = card.integer("LCID");
  raw.where = card.where();
  raw.delay = card.real("SFA") * card.real("OFFA");
  raw.phase = phase_of(card);
  while (cards.more()) {
    const Card point = cards.next_filled(point_card);
    if (!point.good("A") || !point.good("O")) continue;
    const double abscissa = card.real("SFA") * (point.real("A") + card.real("OFFA"));
    const double ordinate = card.real("SFO") * (point.real("O") + card.real("OFFO"));
    if (!std::isfinite(abscissa) || !std::isfinite(ordinate))
      cards.report().error(point.where(), "range", "the point is out of the range of numbers once scaled");
    if (!raw.curve.abscissa.empty() && abscissa <= raw.curve.abscissa.back())
      cards.report().field_error(
          point.where(), {"A", std::string(point.text("A")), "a value above that of the point before it",
                          "the points of a curve ascend", "order"});
    raw.curve.abscissa.push_back(abscissa);
    raw.curve.ordinate.push_back(ordinate);
  }
  if (raw.curve.abscissa.size() < 2)
    cards.report().error(
        card.where(), "points",
        fmt::format("the curve has {}, expected at least two", counted(raw.curve.abscissa.size(), "point")));
  if (card.good("LCID")) deck.curves.push_back(std::move(raw));
}

namespace {

/// From zero to `top` and back in ramps of half a cosine, `rise` long; the area is (end - start - rise) top.
model::Curve smooth_curve(double start, double end, double rise, double top) {
  constexpr int pieces = 64;
  model::Curve curve;
  const auto add = [&](double time, double value) {
    curve.abscissa.push_back(time);
    curve.ordinate.push_back(value);
  };
  const auto height = [&](int i) { return 0.5 * top * (1 - std::cos(std::numbers::pi * i / pieces)); };
  if (start > 0) add(0, 0);
  for (int i = 0; i <= pieces; ++i) add(start + rise * i / pieces, height(i));
  const bool stays = end - rise > start + rise;
  for (int i = stays ? pieces : pieces - 1; i >= 0; --i) add(end - rise * i / pieces, height(i));
  return curve;
}

/// TEND of VMAX or VMAX of TEND, so that the area is DIST. False, with a message, if that cannot be.
bool complete_smooth(const Card& card, double& end, double& top, Report& report) {
  const double start = card.real("TSTART");
  const double rise = card.real("TRISE");
  const double distance = card.real("DIST");
  if (end > 0 && top == 0) top = distance / (end - start - rise);
  if (top != 0 && end == 0) end = start + rise + distance / top;
  // Round-off of a curve without a straight piece.
  constexpr double enough = 1 - 1e-9;
  if (top == 0)
    report.error(card.where(), "smooth curve",
                 "two of DIST, TEND and VMAX must be given, the third follows: the curve would be zero");
  else if (!(end - start >= 2 * rise * enough))
    report.error(
        card.where(), "smooth curve",
        fmt::format("from TSTART {} to {} there is no time for two ramps of TRISE {}", start, end, rise));
  else if (std::fabs((end - start - rise) * top - distance) > 1e-3 * std::fabs(distance) && distance != 0)
    report.error(
        card.where(), "smooth curve",
        fmt::format("the area by TEND and VMAX is {:.6g}, DIST is {}; give one of the two, the other follows",
                    (end - start - rise) * top, distance));
  else
    return true;
  return false;
}

}  // namespace

void read_define_curve_smooth(Cards& cards, RawDeck& deck) {
  cards.heading();
  const Card card = cards.next(smooth_card);
  RawCurve raw;
  raw.where = card.where();
  raw.phase = phase_of(card);
  double end = card.real("TEND");
  double top = card.real("VMAX");
  const bool good = card.good("TSTART") && card.good("TEND") && card.good("TRISE") && card.good("VMAX") &&
                    card.good("DIST");
  if (good && complete_smooth(card, end, top, cards.report()))
    raw.curve = smooth_curve(card.real("TSTART"), end, card.real("TRISE"), top);
  raw.curve.id = card.integer("LCID");
  if (card.good("LCID")) deck.curves.push_back(std::move(raw));
}

namespace {

/// The text with the values of parameters in the places of their names. False, with a message, if one is
/// missing.
bool replace_parameters(std::string& text, const Where& where, const Cards& cards) {
  for (std::size_t at = text.find('&'); at != std::string::npos; at = text.find('&', at)) {
    std::size_t end = at + 1;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
      ++end;
    const std::string name = text.substr(at, end - at);
    const std::optional<std::string> value = cards.parameters().substitute(name);
    if (!value) {
      cards.report().error(
          where, "parameter",
          fmt::format("the function has \"{}\", expected a parameter that is defined; define it "
                      "with *PARAMETER before this line",
                      name));
      return false;
    }
    // As a number: "1.5+3" is 1500 in a field, and would be a sum in an expression.
    const std::optional<double> number = parse_real(*value);
    if (!number) {
      cards.report().error(where, "parameter",
                           fmt::format("the parameter {} is \"{}\", expected a number", name, *value));
      return false;
    }
    text.replace(at, end - at, fmt::format("({})", *number));
  }
  return true;
}

}  // namespace

void read_define_curve_function(Cards& cards, RawDeck& deck) {
  cards.heading();
  const Card card = cards.next(function_card);
  RawCurve raw;
  raw.curve.id = card.integer("LCID");
  raw.where = card.where();
  raw.phase = phase_of(card);
  constexpr std::size_t last_column = 80;
  do raw.function += cards.text_line("a function of TIME").substr(0, last_column);
  while (cards.more());
  if (replace_parameters(raw.function, raw.where, cards) && card.good("LCID"))
    deck.curves.push_back(std::move(raw));
}

namespace {

/// The first card of a table.
RawTable table_of(Cards& cards, const RawDeck& deck, Card& card) {
  cards.heading();
  card = cards.next(table_card);
  RawTable raw;
  raw.id = card.integer("TBID");
  raw.where = card.where();
  raw.first_curve = deck.curves.size();
  return raw;
}

void add_value(const Card& card, const Card& point, RawTable& raw, Report& report) {
  const double value = card.real("SFA") * (point.real("VALUE") + card.real("OFFA"));
  if (!raw.value.empty() && value <= raw.value.back())
    report.field_error(point.where(),
                       {"VALUE", std::string(point.text("VALUE")), "a value above the one before it",
                        "the values of a table ascend", "order"});
  raw.value.push_back(value);
}

}  // namespace

void read_define_table(Cards& cards, RawDeck& deck) {
  Card card;
  RawTable raw = table_of(cards, deck, card);
  while (cards.more()) {
    const Card point = cards.next_filled(value_card);
    add_value(card, point, raw, cards.report());
    raw.curve.push_back(point.integer("LCID"));
    if (point.good("LCID") && (raw.curve.front() == 0) != (raw.curve.back() == 0))
      cards.report().field_error(
          point.where(),
          {"LCID", std::string(point.text("LCID")),
           raw.curve.front() == 0 ? "a blank field" : "the id of a curve",
           "all values of a table name their curves, or none does and the curves follow in the "
           "same order; use *DEFINE_TABLE_2D for the former",
           "curve"});
  }
  if (!raw.curve.empty() && raw.curve.front() == 0) raw.curve.clear();
  if (card.good("TBID")) deck.tables.push_back(std::move(raw));
}

void read_define_table_2d(Cards& cards, RawDeck& deck) {
  Card card;
  RawTable raw = table_of(cards, deck, card);
  while (cards.more()) {
    const Card point = cards.next_filled(value_curve_card);
    add_value(card, point, raw, cards.report());
    raw.curve.push_back(point.integer("CURVEID"));
  }
  if (card.good("TBID")) deck.tables.push_back(std::move(raw));
}

}  // namespace crumple::deck
