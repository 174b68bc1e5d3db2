// SPDX-License-Identifier: BSD-3-Clause
// *CONSTRAINED_SPOTWELD, *CONSTRAINED_GENERALIZED_WELD_SPOT, *CONSTRAINED_SHELL_TO_SOLID, *CONSTRAINED_RIVET,
// *CONSTRAINED_NODE_SET, *CONSTRAINED_LINEAR_GLOBAL, *CONSTRAINED_ADAPTIVITY, *CONSTRAINED_INTERPOLATION,
// *CONSTRAINED_GLOBAL.
#include "deck/keywords/families.hpp"
#include "deck/keywords/rigid_inertia.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view no_filter = "the forces of a weld are compared as they are";

constexpr Field spotweld_card[] = {
    id("N1"),
    id("N2"),
    real("SN", 0, not_negative),
    real("SS", 0, not_negative),
    real_or_default("N", 1, above_zero),
    real_or_default("M", 1, above_zero),
    real_or_default("TF", 1e20, above_zero),
    real_or_default("EP", 1e20, above_zero),
};

constexpr Field generalized_card[] = {
    id("NSID"),
    harmless("CID", {0}, "the axes of LS-DYNA's listings"),
    harmless("FILTER", {0, 1}, no_filter),
    unused("WINDOW"),  // of the filter
    unused("NPR"),     // listings
    unused("NPRT"),
};

constexpr Field generalized_spot_card[] = {
    real_or_default("TFAIL", 1e20, above_zero),
    real_or_default("EPSF", 1e20, above_zero),
    real("SN", 0, not_negative),
    real("SS", 0, not_negative),
    real_or_default("N", 1, above_zero),
    real_or_default("M", 1, above_zero),
};

constexpr Field shell_to_solid_card[] = {id("NID"), id("NSID")};

constexpr Field rivet_card[] = {
    id("N1"),
    id("N2"),
    real_or_default("TF", 1e20, above_zero),
};

constexpr Field node_set_card[] = {
    id("NSID"),
    axes(integer("DOF", 0, within(1, 7, "1, 2, 3 are x, y, z, 4 is xy, 5 yz, 6 zx, 7 all"))),
    real_or_default("TF", 1e20, above_zero),
};

constexpr Field linear_card[] = {reference("LCID", IdKind::Other)};

constexpr Field linear_term_card[] = {
    id("NID"),
    axes(integer("DOF", 1, within(1, 6, "1, 2, 3 move along x, y, z, 4, 5, 6 turn about them"))),
    real("COEF"),
};

constexpr Field adaptivity_card[] = {
    id("DNID", IdKind::Node),
    id("NID1", IdKind::Node),
    id("NID2", IdKind::Node),
};

constexpr std::string_view of_global_axes = "degrees of freedom are those of global axes";
constexpr std::string_view all_degrees =
    "the independent nodes count with all translations, and with all rotations or none";

constexpr Field interpolation_card[] = {
    reference("ICID", IdKind::Other),
    id("DNID", IdKind::Node),
    axes(integer_or_default("DDOF", 123456, within(1, 123456, "the digits 1 to 6, each once"))),
    only("CIDD", {0}, of_global_axes),
    only("ITYP", {0, 1}, "0 has nodes, 1 sets of nodes"),
    unused("IDNSW"),  // nodes of eroded elements stay
    unused("FGM"),    // implicit
};

constexpr Field independent_card[] = {
    id("INID", IdKind::Node),
    axes(only("IDOF", {123456, 0, 123}, all_degrees)),
    real_or_default("TWGHTX", 1, above_zero),
    real("TWGHTY", 0, not_negative),
    real("TWGHTZ", 0, not_negative),
    real("RWGHTX", 0, not_negative),
    real("RWGHTY", 0, not_negative),
    real("RWGHTZ", 0, not_negative),
};

constexpr Field independent_set_card[] = {
    id("INID", IdKind::Set),
    axes(only("IDOF", {123456, 0, 123}, all_degrees)),
    real_or_default("TWGHTX", 1, above_zero),
    real("TWGHTY", 0, not_negative),
    real("TWGHTZ", 0, not_negative),
    real("RWGHTX", 0, not_negative),
    real("RWGHTY", 0, not_negative),
    real("RWGHTZ", 0, not_negative),
};

constexpr Check held_code = within(0, 7, "1, 2, 3 are x, y, z, 4 is xy, 5 yz, 6 zx, 7 all");

constexpr Field global_card[] = {
    axes(integer("TC", 0, held_code)),
    axes(integer("RC", 0, held_code)),
    axes(integer("DIR", 1, within(1, 3, "the plane is normal to x, y, z"))),
    point(real("X")),
    point(real("Y")),
    point(real("Z")),
    length(real("TOL", 0, not_negative)),
};

/// The digits of DDOF; false for one that is none of 1 to 6, or stands twice.
bool take_digits(std::int64_t number, std::array<bool, 6>& digits) {
  digits = {};
  for (; number > 0; number /= 10) {
    const std::int64_t digit = number % 10;
    if (digit < 1 || digit > 6 || digits[static_cast<std::size_t>(digit) - 1]) return false;
    digits[static_cast<std::size_t>(digit) - 1] = true;
  }
  return true;
}

/// Refuses weights that are not the same along all axes; zero takes the first.
void require_one_weight(Cards& cards, const Card& card, std::initializer_list<std::string_view> names,
                        double weight) {
  for (const std::string_view name : names)
    if (card.real(name) != 0 && card.real(name) != weight)
      cards.report().field_unsupported(card.where(),
                                       {name, std::string(card.text(name)), "the same along all axes",
                                        "each node has one weight", "weights"});
}

/// Strength, exponents and limits, whose names but two both kinds of cards share.
model::SpotWeld limits_of(const Card& card, std::string_view time, std::string_view strain) {
  constexpr double never = 1e10;
  model::SpotWeld weld;
  weld.normal_strength = card.real("SN");
  weld.shear_strength = card.real("SS");
  weld.normal_exponent = card.real("N");
  weld.shear_exponent = card.real("M");
  weld.failure_time = card.real(time);
  weld.failure_strain = card.real(strain) < never ? card.real(strain) : 0;
  return weld;
}

}  // namespace

void read_constrained_spotweld(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(spotweld_card);
    RawWeld raw;
    raw.weld = limits_of(card, "TF", "EP");
    raw.weld.id = heading.id;
    raw.node = {card.integer("N1"), card.integer("N2")};
    raw.where = card.where();
    if (card.good("N1") && card.good("N2")) deck.welds.push_back(std::move(raw));
  }
}

void read_constrained_generalized_weld_spot(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(generalized_card);
    const Card second = cards.next(generalized_spot_card);
    RawWeld raw;
    raw.weld = limits_of(second, "TFAIL", "EPSF");
    raw.weld.id = heading.id;
    raw.node_set = card.integer("NSID");
    raw.where = card.where();
    raw.limits_where = second.where();
    if (card.good("NSID")) deck.welds.push_back(std::move(raw));
  }
}

/// The fibre through the thickness is rigid: LS-DYNA lets the nodes of solids slide along it.
void read_constrained_shell_to_solid(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(shell_to_solid_card);
    RawWeld raw;
    raw.node[0] = card.integer("NID");
    raw.node_set = card.integer("NSID");
    raw.where = card.where();
    if (!card.good("NID") || !card.good("NSID")) continue;
    cards.report().warning(card.where(), "fibre",
                           "the fibre of solids at a shell's node is a rigid body: LS-DYNA lets it stretch");
    deck.welds.push_back(std::move(raw));
  }
}

void read_constrained_rivet(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(rivet_card);
    if (card.good("N1") && card.good("N2"))
      deck.rivets.push_back(
          {heading.id, {card.integer("N1"), card.integer("N2")}, card.real("TF"), card.where()});
  }
}

void read_constrained_node_set(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(node_set_card);
    if (!card.good("NSID") || !card.good("DOF")) continue;
    deck.constrained_sets.push_back(
        {card.integer("NSID"), held_axes(card.integer("DOF")), card.real("TF"), card.where()});
  }
}

void read_constrained_linear_global(Cards& cards, RawDeck& deck) {
  const Card first = cards.next(linear_card);
  RawEquation raw;
  raw.id = first.integer("LCID");
  raw.where = first.where();
  bool good = first.good("LCID");
  while (cards.more()) {
    const Card card = cards.next_filled(linear_term_card);
    good = good && card.good("NID") && card.good("DOF") && card.good("COEF");
    raw.terms.push_back(
        {card.integer("NID"), static_cast<int>(card.integer("DOF")) - 1, card.real("COEF"), card.where()});
  }
  if (good) deck.equations.push_back(std::move(raw));
}

void read_constrained_adaptivity(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(adaptivity_card);
    if (card.good("DNID") && card.good("NID1") && card.good("NID2"))
      deck.mid_nodes.push_back(
          {{card.integer("DNID"), card.integer("NID1"), card.integer("NID2")}, card.where()});
  }
}

void read_constrained_global(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(global_card);
    RawHeldPlane raw;
    raw.translation_code = static_cast<int>(card.integer("TC"));
    raw.rotation_code = static_cast<int>(card.integer("RC"));
    raw.axis = static_cast<int>(card.integer("DIR")) - 1;
    raw.point = {card.real("X"), card.real("Y"), card.real("Z")};
    raw.tolerance = card.real("TOL");
    raw.where = card.where();
    if (card.good("TC") && card.good("RC") && card.good("DIR")) deck.held_planes.push_back(raw);
  }
}

void read_constrained_interpolation(Cards& cards, RawDeck& deck) {
  const Card first = cards.next(interpolation_card);
  RawInterpolation raw;
  raw.interpolation.id = first.integer("ICID");
  raw.dependent = first.integer("DNID");
  raw.of_sets = first.real("ITYP") == 1;
  raw.where = first.where();
  bool good = first.good("DNID") && first.good("DDOF");
  if (good && !take_digits(first.integer("DDOF"), raw.interpolation.follows)) {
    cards.report().field_error(
        first.where(), {"DDOF", std::string(first.text("DDOF")), "the digits 1 to 6, each at most once",
                        "1, 2, 3 move along x, y, z, 4, 5, 6 turn about them", "digits"});
    good = false;
  }
  while (cards.more()) {
    const Card card =
        raw.of_sets ? cards.next_filled(independent_set_card) : cards.next_filled(independent_card);
    const double weight = card.real("TWGHTX");
    require_one_weight(cards, card, {"TWGHTY", "TWGHTZ"}, weight);
    const double rotation = card.real("RWGHTX") > 0 ? card.real("RWGHTX") : weight;
    require_one_weight(cards, card, {"RWGHTY", "RWGHTZ"}, rotation);
    good = good && card.good("INID") && card.good("TWGHTX");
    raw.independent.push_back(
        {card.integer("INID"), {no_index, weight, card.real("IDOF") == 123 ? 0 : rotation}, card.where()});
  }
  if (good) deck.interpolations.push_back(std::move(raw));
}

}  // namespace crumple::deck
