// SPDX-License-Identifier: BSD-3-Clause
// *INTEGRATION_BEAM.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "deck/keywords/families.hpp"
#include "deck/keywords/section_cards.hpp"
#include "model/beam_section.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field beam_rule_card[] = {
    id("IRID", IdKind::Other),
    integer("NIP", 0, not_negative),
    real("RA", 0, not_negative),
    integer("ICST", 0, not_negative),
    integer("K", 0, within(0, 20, "a refinement from 0 to 20")),
};

constexpr Field rule_shape_card[] = {
    real("W", 0, above_zero),
    real("TF", 0, not_negative),
    real("D", 0, not_negative),
    real("TW", 0, not_negative),
    real("SREF", 0, within(-1, 1, "a place from -1 to 1, 0 at the centre")),
    real("TREF", 0, within(-1, 1, "a place from -1 to 1, 0 at the centre")),
    unused("D5"),  // of shapes that are not supported
    unused("D6"),
};

constexpr Field rule_point_card[] = {
    real("S", 0, within(-1, 1, "a place from -1 to 1")),
    real("T", 0, within(-1, 1, "a place from -1 to 1")),
    real("WF", 0, above_zero),
    only("PID", {0}, "all points of a beam have the material of its part"),
};

/// A standard shape of *INTEGRATION_BEAM.
enum class SectionShape {
  I = 1,
  Channel = 2,
  Angle = 3,
  Tee = 4,
  Box = 5,
  Circle = 8,
  Tube = 9,
  Rectangle = 11
};

bool is_made_of_plates(std::int64_t shape) {
  return shape >= static_cast<std::int64_t>(SectionShape::I) &&
         shape <= static_cast<std::int64_t>(SectionShape::Box);
}

std::vector<model::SectionPlate> plates_of(std::int64_t shape, const Card& size) {
  const double width = size.real("W");
  const double flange = size.real("TF");
  const double depth = size.real("D");
  const double web = size.real("TW");
  switch (static_cast<SectionShape>(shape)) {
    case SectionShape::I:
      return model::i_plates(width, flange, depth, web);
    case SectionShape::Channel:
      return model::channel_plates(width, flange, depth, web);
    case SectionShape::Angle:
      return model::angle_plates(width, flange, depth, web);
    case SectionShape::Tee:
      return model::tee_plates(width, flange, depth, web);
    default:
      return model::box_plates(width, flange, depth, web);
  }
}

/// Flanges and webs must be there and leave something of width and depth.
bool plates_fit(std::int64_t shape, const Card& size, Report& report) {
  bool fit = true;
  for (const std::string_view name : {"TF", "D", "TW"})
    fit = check_dimension(size, name, "the shape needs its width, depth, and thickness of flange and web",
                          report) &&
          fit;
  if (!fit) return false;
  const bool two_flanges = shape != static_cast<std::int64_t>(SectionShape::Angle) &&
                           shape != static_cast<std::int64_t>(SectionShape::Tee);
  const double webs = shape == static_cast<std::int64_t>(SectionShape::Box) ? 2 : 1;
  if ((two_flanges ? 2 : 1) * size.real("TF") < size.real("D") && webs * size.real("TW") < size.real("W"))
    return true;
  report.field_error(
      size.where(),
      {"TF", std::string(size.text("TF")), "flanges thinner than the depth, webs thinner than the width",
       "TF is the thickness of a flange along t, TW that of a web along s", "plate"});
  return false;
}

/// Bounds of the plates about the centre of their area.
void take_bounds(const std::vector<model::SectionPlate>& plates, RawBeamRule& raw) {
  for (const model::SectionPlate& plate : plates) {
    raw.least[0] = std::min(raw.least[0], plate.s - 0.5 * plate.width_s);
    raw.least[1] = std::min(raw.least[1], plate.t - 0.5 * plate.width_t);
    raw.most[0] = std::max(raw.most[0], plate.s + 0.5 * plate.width_s);
    raw.most[1] = std::max(raw.most[1], plate.t + 0.5 * plate.width_t);
  }
}

/// Points of a standard shape about the centre of its area.
void take_standard_shape(const Card& rule, const Card& size, RawBeamRule& raw, Report& report) {
  const std::int64_t shape = rule.integer("ICST");
  const auto refinement = static_cast<int>(rule.integer("K"));
  if (!size.good("W")) return;
  const double width = size.real("W");
  raw.reference = {size.real("SREF"), size.real("TREF")};
  if (is_made_of_plates(shape)) {
    if (!plates_fit(shape, size, report)) return;
    const std::vector<model::SectionPlate> plates = plates_of(shape, size);
    take_bounds(plates, raw);
    raw.shape = model::plate_points(plates, refinement);
  } else if (shape == static_cast<std::int64_t>(SectionShape::Rectangle)) {
    if (!check_dimension(size, "TF", "it is the width along t of a rectangle", report)) return;
    take_bounds({{0, 0, width, size.real("TF")}}, raw);
    raw.shape = model::rectangle_points(width, size.real("TF"), model::SectionRule::Gauss4);
  } else {
    const bool is_tube = shape == static_cast<std::int64_t>(SectionShape::Tube);
    if (is_tube && !check_dimension(size, "TF", "W and TF are both radii of a tube", report)) return;
    const double other = is_tube ? size.real("TF") : 0;
    const double inner = std::min(width, other);
    const double outer = std::max(width, other);
    if (inner == outer) {
      report.field_error(size.where(), {"TF", std::string(size.text("TF")), "another radius than W",
                                        "the wall of the tube has no thickness", "tube"});
      return;
    }
    take_bounds({{0, 0, 2 * outer, 2 * outer}}, raw);
    raw.shape = model::tube_points(2 * outer, 2 * inner, model::SectionRule::Gauss4);
  }
}

/// Points that the deck gives itself.
void take_rule_points(Cards& cards, const Card& rule, RawBeamRule& raw) {
  raw.relative_area = rule.real("RA");
  double sum = 0;
  for (std::int64_t i = 0; i < rule.integer("NIP"); ++i) {
    const Card point = cards.next(rule_point_card);
    raw.points.push_back({point.real("S"), point.real("T"), point.real("WF")});
    sum += point.real("WF");
  }
  constexpr double tolerance = 0.01;
  if (!raw.points.empty() && std::fabs(sum - 1) > tolerance)
    cards.report().warning(raw.where, "weights",
                           fmt::format("the weights WF of rule {} sum to {:.4g}, not to 1: its area is that "
                                       "share of RA TS TT",
                                       raw.id, sum));
}

}  // namespace

void read_integration_beam(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    RawBeamRule raw;
    const Card card = cards.next(beam_rule_card);
    raw.id = card.integer("IRID");
    raw.where = card.where();
    const std::int64_t shape = card.integer("ICST");
    if (shape == 0) {
      if (!check_dimension(card, "NIP", "a rule without a standard shape needs points", cards.report()) ||
          !check_dimension(card, "RA", "it is the area over the product of both thicknesses", cards.report()))
        cards.skip_rest();
      else
        take_rule_points(cards, card, raw);
    } else if (is_made_of_plates(shape) || shape == 8 || shape == 9 || shape == 11) {
      take_standard_shape(card, cards.next(rule_shape_card), raw, cards.report());
    } else {
      cards.report().field_unsupported(
          card.where(),
          {"ICST", std::string(card.text("ICST")),
           "1 (I), 2 (channel), 3 (angle), 4 (T), 5 (box), 8 (circle), 9 (tube) or 11 (rectangle)",
           "give the points of the shape with ICST = 0", "shape"});
      cards.skip_rest();
    }
    if (card.good("IRID")) deck.beam_rules.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
