// SPDX-License-Identifier: BSD-3-Clause
// *PART_COMPOSITE, *ELEMENT_SHELL_COMPOSITE, *INTEGRATION_SHELL.
#include <numbers>

#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field composite_card[] = {
    id("PID"),
    only("ELFORM", {0, 1, 2, 4, 6, 10, 16},
         "1 is Hughes-Liu, 2 Belytschko-Tsay, 4 the C0 triangle, 6 Hughes-Liu selectively reduced, 10 "
         "Belytschko-Wong-Chiang, 16 fully integrated, 0 what *CONTROL_SHELL says"),
    real_or_default("SHRF", 1.0, above_zero),
    real("NLOC", 0, within(-1, 1, "1 is the upper surface, 0 the mid-surface, -1 the lower one")),
    only("MAREA", {0}, "use *ELEMENT_MASS for mass that is not structural"),
    reference("HGID"),
    only("ADPOPT", {0}, "adaptive meshes are not supported"),
    unused("THSHEL"),  // there is no thermal solution
};

constexpr std::string_view no_heat = "there is no thermal solution";

constexpr Field layer_card[] = {
    reference("MID1", IdKind::Material),
    real("THICK1", 0, not_negative),
    real("B1"),
    harmless("TMID1", {0}, no_heat),
    reference("MID2", IdKind::Material),
    real("THICK2", 0, not_negative),
    real("B2"),
    harmless("TMID2", {0}, no_heat),
};

constexpr Field long_layer_card[] = {
    reference("MID1", IdKind::Material),
    real("THICK1", 0, not_negative),
    real("B1"),
    harmless("TMID1", {0}, no_heat),
    unused("PLYID1"),  // a label
    only("SHRFAC1", {0, 1}, "the shear factor SHRF of the part holds for all layers"),
};

constexpr Field element_layer_card[] = {
    reference("MID1", IdKind::Material), real("THICK1", 0, not_negative), real("B1"), unused("PLYID1"),
    reference("MID2", IdKind::Material), real("THICK2", 0, not_negative), real("B2"), unused("PLYID2"),
};

constexpr Field shell_rule_card[] = {
    id("IRID", IdKind::Other),
    integer("NIP", 0, within(1, 20, "points through the thickness")),
    only("ESOP", {0, 1}, "0 lists the points, 1 makes NIP layers of the same thickness"),
    only("FAILOPT", {0, 1},
         "0: a shell goes when all layers have failed that can fail, 1: not if there are others"),
};

constexpr Field layup_point_card[] = {
    real("S", 0, within(-1, 1, "-1 is the lower surface, 1 the upper one")),
    real("WF", 0, above_zero),
    reference("PID"),
};

/// Adds the layer in the fields of that ending, if there is one.
void take_layer(const Card& card, bool second, const Affine& map, Report& report,
                std::vector<RawLayer>& layers) {
  const std::string_view material = second ? "MID2" : "MID1";
  const std::string_view thickness = second ? "THICK2" : "THICK1";
  const std::string_view angle = second ? "B2" : "B1";
  if (!card.good(material) || !card.good(thickness)) return;
  const double given = card.real(thickness);
  if (card.integer(material) == 0) {
    if (given > 0 || !second)
      report.field_error(card.where(), {material, std::string(card.text(material)), "the id of a material",
                                        "each layer has a material, a thickness and an angle", "layer"});
    return;
  }
  if (!(given > 0)) {
    report.field_error(card.where(), {thickness, std::string(card.text(thickness)), "a number above zero",
                                      "each layer has a thickness", "layer"});
    return;
  }
  RawLayer layer;
  layer.material = card.integer(material);
  layer.thickness = given;
  layer.angle = (map.mirrors() ? -1 : 1) * card.real(angle) * std::numbers::pi / 180;
  layer.field = material;
  layer.where = card.where();
  layers.push_back(layer);
}

void read_composite(Cards& cards, RawDeck& deck, bool one_layer_a_card) {
  RawPart part;
  part.title = cards.text_line("the title of a part");
  const Card card = cards.next(composite_card);
  part.id = card.integer("PID");
  part.hourglass = card.good("HGID") ? card.integer("HGID") : 0;
  part.where = card.where();
  read_part_contact(cards, part);
  RawSection raw;
  raw.section.title = part.title;
  raw.formulation_given = card.real("ELFORM") != 0;
  raw.section.formulation = shell_formulation(static_cast<std::int64_t>(card.real("ELFORM")));
  raw.section.shear_factor = card.real("SHRF");
  raw.section.node_place = card.real("NLOC");
  const Affine& map = cards.placement().map;
  do {
    const Card layer = one_layer_a_card ? cards.next(long_layer_card) : cards.next(layer_card);
    take_layer(layer, false, map, cards.report(), part.layers);
    if (!one_layer_a_card) take_layer(layer, true, map, cards.report(), part.layers);
  } while (cards.more());
  double thickness = 0;
  for (const RawLayer& layer : part.layers) thickness += layer.thickness;
  raw.section.thickness = {thickness, thickness, thickness, thickness};
  raw.section.thickness_points = static_cast<int>(part.layers.size());
  raw.where = card.where();
  raw.order = deck.section_count();
  part.own_section = deck.sections.size();
  if (!card.good("PID") || part.layers.empty()) return;
  deck.sections.push_back(std::move(raw));
  deck.parts.push_back(std::move(part));
}

/// A card of layers has a thickness with a point or an exponent; that of an element whole numbers alone.
bool is_layer_line(std::string_view line) {
  return line.find_first_of(".eEdD") != std::string_view::npos;
}

}  // namespace

void read_part_composite(Cards& cards, RawDeck& deck) {
  read_composite(cards, deck, false);
}

void read_part_composite_long(Cards& cards, RawDeck& deck) {
  read_composite(cards, deck, true);
}

void read_element_shell_composite(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    RawShell shell;
    const bool complete = read_shell(cards, shell);
    std::vector<RawLayer> layers;
    do {
      const Card card = cards.next(element_layer_card);
      take_layer(card, false, cards.placement().map, cards.report(), layers);
      take_layer(card, true, cards.placement().map, cards.report(), layers);
    } while (cards.more() && is_layer_line(cards.peek()));
    if (!complete || layers.empty()) continue;
    double thickness = 0;
    for (const RawLayer& layer : layers) thickness += layer.thickness;
    shell.thickness = {thickness, thickness, thickness, thickness};
    deck.element_layers.push_back(std::move(layers));
    shell.layers = deck.element_layers.size();
    deck.shells.push_back(shell);
  }
}

void read_integration_shell(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next(shell_rule_card);
    RawIntegrationRule rule;
    rule.id = card.integer("IRID");
    rule.unfailing_layers_hold = card.real("FAILOPT") == 1;
    rule.where = card.where();
    const auto count = card.good("NIP") ? static_cast<int>(card.integer("NIP")) : 0;
    const bool equal = card.real("ESOP") == 1;
    for (int i = 0; i < count; ++i) {
      RawIntegrationPoint point;
      point.share = 1.0 / count;
      point.place = (2.0 * i + 1) / count - 1;
      point.where = card.where();
      if (!equal) {
        const Card given = cards.next(layup_point_card);
        point.place = given.real("S");
        point.share = given.real("WF");
        point.part = given.good("PID") ? given.integer("PID") : 0;
        point.where = given.where();
      }
      rule.points.push_back(point);
    }
    if (card.good("IRID") && count > 0) deck.integration_rules.push_back(std::move(rule));
  }
}

}  // namespace crumple::deck
