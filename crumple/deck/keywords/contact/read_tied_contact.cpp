// SPDX-License-Identifier: BSD-3-Clause
// *CONTACT_TIED_..., *CONTACT_TIEBREAK_..., *CONTACT_AUTOMATIC_..._TIEBREAK.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "deck/keywords/contact/contact_cards.hpp"
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field tied_card_1[] = {
    reference("SSID", kind_of_first_side),
    reference("MSID", kind_of_second_side),
    only("SSTYP", {0, 1, 2, 3, 4, 5, 6},
         "0 is a segment set, 1 a shell set, 2 a part set, 3 a part, 4 a node set, 5 all parts, 6 all but a "
         "part set"),
    only("MSTYP", {0, 1, 2, 3, 5, 6},
         "0 is a segment set, 1 a shell set, 2 a part set, 3 a part, 5 all parts, 6 all but a part set"),
    reference("SBOXID"),
    reference("MBOXID"),
    unused("SPR"),  // output
    unused("MPR"),
};

// Friction and damping act once a tie has broken.
constexpr Field tied_card_2[] = {
    real("FS", 0, not_negative),
    real("FD", 0, not_negative),
    real("DC", 0, not_negative),
    real("VC", 0, not_negative),
    real("VDC", 0, not_negative),
    unused("PENCHK"),
    only("BT", {0}, "a tie begins at time zero"),
    real_or_default("DT", 1e20, above_zero),
};

constexpr Field tied_card_3[] = {
    real_or_default("SFS", 1, above_zero),
    real_or_default("SFM", 1, above_zero),
    real("SST"),
    real("MST"),
    real_or_default("SFST", 1, above_zero),
    real_or_default("SFMT", 1, above_zero),
    real_or_default("FSF", 1, above_zero),
    real_or_default("VSF", 1, above_zero),
};

constexpr Field automatic_tiebreak_card[] = {
    only(
        "OPTION", {2, 1, 6, 8, 9, 11},
        "1 ties for good, 2 until stresses reach NFLS and SFLS, 6 and 8 soften from there until the ends are "
        "PARAM apart, 9 and 11 by ERATEN and ERATES; there is no failure after sticking (3), no sliding of "
        "what is tied (4), no curve of damage (5), no Dycoss model (7, 10), no law of *MAT_240 (13, 14), and "
        "no moments are tied (-1 to -3)"),
    real("NFLS", 0, not_negative),
    real("SFLS", 0, not_negative),
    real("PARAM"),
    real("ERATEN", 0, not_negative),
    real("ERATES", 0, not_negative),
    real_or_default("CT2CN", 1, above_zero),
    real("CN", 0, not_negative),
};

// What the codes of OPTION mean.
constexpr int for_good = 1;
constexpr int until_strength = 2;
constexpr int until_opening = 6;
constexpr int until_opening_of_shells = 8;
constexpr int until_energy = 9;

constexpr Field tiebreak_nodes_card[] = {
    real("NFLF", 0, not_negative),
    real("SFLF", 0, not_negative),
    real_or_default("NEN", 2, above_zero),
    real_or_default("MES", 2, above_zero),
};

constexpr Field tiebreak_surface_card[] = {
    real("NFLS", 0, not_negative),
    real("SFLS", 0, not_negative),
    only("TBLCID", {0}, "the stress does not fall gradually when a tie breaks"),
    harmless("THKOFF", {0, 1}, "the thickness of shells is kept"),
};

// Optional cards A to F: nothing on them but the thickness of solids concerns ties.
constexpr Field optional_card[] = {unused("1"), unused("2"), unused("3"), unused("4"),
                                   unused("5"), unused("6"), unused("7"), unused("8")};
constexpr Field optional_card_e[] = {
    unused("SHAREC"),
    unused("CPARM8"),
    harmless("IPBACK", {0}, "no second tie by penalty is made beside one by constraint"),
    unused("SRNDE"),
    unused("FRICSF"),
    unused("ICOR"),
    unused("FTORQ"),
    unused("REGION"),
};

constexpr int card_e = 4;
constexpr int optional_cards = 6;

/// Distance from negative SST and MST, which are distances of mid-surfaces: half of their sum.
double tolerance_of(double first, double second) {
  return first < 0 || second < 0 ? 0.5 * (std::fabs(first) + std::fabs(second)) : 0;
}

RawContactSide side_of(const Card& card, bool first) {
  using Target = RawContactSide::Target;
  constexpr Target targets[] = {Target::SegmentSet, Target::ShellSet, Target::PartSet,      Target::Part,
                                Target::NodeSet,    Target::All,      Target::AllButPartSet};
  RawContactSide side;
  side.field = first ? "SSID" : "MSID";
  side.box_field = first ? "SBOXID" : "MBOXID";
  side.id = card.integer(side.field);
  side.box = card.integer(side.box_field);
  const auto type = static_cast<std::size_t>(card.real(first ? "SSTYP" : "MSTYP"));
  side.target = type < std::size(targets) ? targets[type] : Target::SegmentSet;
  return side;
}

/// Cards 1 to 3.
RawTiedContact read_first_cards(Cards& cards, bool& good) {
  const Heading heading = cards.heading();
  skip_mpp_cards(cards);
  const Card first = cards.next(tied_card_1);
  const Card second = cards.next(tied_card_2);
  const Card third = cards.next(tied_card_3);
  RawTiedContact raw;
  raw.where = first.where();
  raw.tied.id = heading.id;
  raw.tied.title = heading.title;
  raw.tied.death_time = second.real("DT");
  raw.tied.side[0].stiffness_scale = third.real("SFS");
  raw.tied.side[1].stiffness_scale = third.real("SFM");
  raw.tied.side[0].thickness_scale = third.real("SFST");
  raw.tied.side[1].thickness_scale = third.real("SFMT");
  raw.tied.side[0].contact_thickness = std::fmax(third.real("SST"), 0);
  raw.tied.side[1].contact_thickness = std::fmax(third.real("MST"), 0);
  raw.tied.tolerance = tolerance_of(third.real("SST"), third.real("MST"));
  raw.side[0] = side_of(first, true);
  raw.side[1] = side_of(first, false);
  good = first.good("SSID") && first.good("MSID") && first.good("SSTYP") && first.good("MSTYP") &&
         first.good("SBOXID") && first.good("MBOXID");
  model::Contact after;
  after.static_friction = second.real("FS") * third.real("FSF");
  after.dynamic_friction = second.real("FD") * third.real("FSF");
  after.friction_decay = second.real("DC");
  after.friction_stress = second.real("VC") * third.real("VSF");
  after.viscous_damping = second.real("VDC") / 100;  // percent of critical
  after.death_time = second.real("DT");
  raw.afterwards = after;
  return raw;
}

void finish(Cards& cards, RawDeck& deck, RawTiedContact raw, bool good) {
  for (int card = 0; card < optional_cards && cards.has_line(); ++card)
    cards.next(card == card_e ? Layout(optional_card_e) : Layout(optional_card));
  if (good) deck.tied_contacts.push_back(std::move(raw));
}

void read_tie(Cards& cards, RawDeck& deck, model::TieMethod method, bool rotations) {
  bool good = false;
  RawTiedContact raw = read_first_cards(cards, good);
  const auto softened = [](const model::ContactSide& side) { return side.stiffness_scale < 1; };
  const bool soft = std::ranges::any_of(raw.tied.side, softened);
  raw.tied.method = soft && method == model::TieMethod::Offset ? model::TieMethod::Penalty : method;
  raw.tied.ties_rotations = rotations;
  raw.afterwards.reset();
  finish(cards, deck, std::move(raw), good);
}

/// One of the two strengths must be there.
void check_strength(Cards& cards, const Card& card, std::string_view field,
                    const model::TieFailure& failure) {
  if (failure.normal_strength > 0 || failure.shear_strength > 0) return;
  cards.report().field_error(card.where(), {field, std::string(card.text(field)), "a strength above zero",
                                            "what never breaks is *CONTACT_TIED_..._OFFSET", "strength"});
}

/// A field that a kind of tiebreak needs.
void require_above_zero(Cards& cards, const Card& card, std::string_view field, std::string_view why) {
  if (!card.good(field) || card.real(field) > 0) return;
  cards.report().field_error(card.where(), {field, std::string(card.text(field)), "a number above zero",
                                            std::string(why), "softening"});
}

/// Ties that soften until they have taken the energies of the two modes.
model::TieSoftening softening_by_energy(Cards& cards, const Card& card) {
  for (const std::string_view field : {"NFLS", "SFLS"})
    require_above_zero(cards, card, field, "OPTION 9 and 11 need both strengths, as numbers");
  for (const std::string_view field : {"ERATEN", "ERATES"})
    require_above_zero(cards, card, field, "OPTION 9 and 11 need the energy per area of both modes");
  const double exponent = card.real("PARAM");
  model::TieSoftening softening;
  softening.law =
      exponent < 0 ? model::TieSoftening::Law::BenzeggaghKenane : model::TieSoftening::Law::PowerLaw;
  softening.normal_energy = card.real("ERATEN");
  softening.shear_energy = card.real("ERATES");
  softening.exponent = exponent == 0 ? 1 : std::fabs(exponent);
  softening.shear_ratio = card.real("CT2CN");
  softening.stiffness = card.real("CN");
  if (softening.stiffness > 0)
    cards.report().field_warning(
        card.where(),
        {"CN", std::string(card.text("CN")), "0, or a stiffness that the time step allows",
         "what is beyond half of the stability budget of contact is cut: the bond is softer then "
         "up to its strength, which stays, as does its energy",
         "stiffness"});
  return softening;
}

/// When and how the tie ends, by OPTION.
void take_option(Cards& cards, const Card& card, model::TiedContact& tied) {
  const int option = card.good("OPTION") ? static_cast<int>(card.real("OPTION")) : until_strength;
  if (option == for_good) {
    cards.report().field_warning(
        card.where(), {"OPTION", "1", "2, where later contact must not stick",
                       "what is in contact at time zero is tied for good; nodes that come into contact "
                       "later touch, and do not stick",
                       "sticking"});
    return;
  }
  tied.failure = {.normal_strength = card.real("NFLS"), .shear_strength = card.real("SFLS")};
  if (option < until_energy) {
    if (option == until_strength) check_strength(cards, card, "NFLS", *tied.failure);
    if (card.real("CN") != 0)
      cards.report().field_warning(
          card.where(), {"CN", std::string(card.text("CN")), "0",
                         "only OPTION 9 and 11 have it; the stiffness is that of ties", "stiffness"});
  }
  if (option == until_strength && card.real("PARAM") != 0)
    cards.report().field_unsupported(card.where(), {"PARAM", std::string(card.text("PARAM")), "0",
                                                    "the thickness of shells is kept", "thickness"});
  if (option == until_opening || option == until_opening_of_shells) {
    for (const std::string_view field : {"NFLS", "SFLS"})
      require_above_zero(cards, card, field,
                         "without one of the strengths ties soften neither in that mode nor near it");
    require_above_zero(cards, card, "PARAM",
                       "with OPTION 6 and 8 it is the distance at which the tie is gone");
    tied.softening = model::TieSoftening{.law = model::TieSoftening::Law::CriticalOpening,
                                         .critical_opening = card.real("PARAM")};
  }
  if (option >= until_energy) tied.softening = softening_by_energy(cards, card);
}

void read_automatic(Cards& cards, RawDeck& deck, model::ContactKind kind) {
  bool good = false;
  RawTiedContact raw = read_first_cards(cards, good);
  const Card card = cards.next(automatic_tiebreak_card);
  raw.tied.method = model::TieMethod::Penalty;
  take_option(cards, card, raw.tied);
  raw.afterwards->kind = kind;
  finish(cards, deck, std::move(raw), good);
}

}  // namespace

void read_contact_tied(Cards& cards, RawDeck& deck) {
  read_tie(cards, deck, model::TieMethod::Constraint, false);
}

void read_contact_tied_offset(Cards& cards, RawDeck& deck) {
  read_tie(cards, deck, model::TieMethod::Offset, false);
}

void read_contact_tied_shell_edge(Cards& cards, RawDeck& deck) {
  read_tie(cards, deck, model::TieMethod::Constraint, true);
}

void read_contact_tied_edge_offset(Cards& cards, RawDeck& deck) {
  read_tie(cards, deck, model::TieMethod::Offset, true);
}

void read_contact_tied_edge_to_solid(Cards& cards, RawDeck& deck) {
  const std::size_t before = deck.tied_contacts.size();
  read_tie(cards, deck, model::TieMethod::Constraint, true);
  if (deck.tied_contacts.size() > before) deck.tied_contacts.back().tied.turns_on_faces = true;
}

void read_contact_automatic_tiebreak(Cards& cards, RawDeck& deck) {
  read_automatic(cards, deck, model::ContactKind::SurfaceToSurface);
}

void read_contact_automatic_one_way_tiebreak(Cards& cards, RawDeck& deck) {
  read_automatic(cards, deck, model::ContactKind::NodesToSurface);
}

void read_contact_tiebreak_nodes(Cards& cards, RawDeck& deck) {
  bool good = false;
  RawTiedContact raw = read_first_cards(cards, good);
  const Card card = cards.next(tiebreak_nodes_card);
  raw.tied.method = model::TieMethod::Penalty;
  raw.tied.failure = {.normal_strength = card.real("NFLF"),
                      .shear_strength = card.real("SFLF"),
                      .normal_exponent = card.real("NEN"),
                      .shear_exponent = card.real("MES"),
                      .by_stress = false};
  check_strength(cards, card, "NFLF", *raw.tied.failure);
  raw.afterwards->kind = model::ContactKind::NodesToSurface;
  finish(cards, deck, std::move(raw), good);
}

void read_contact_tiebreak_surface(Cards& cards, RawDeck& deck) {
  bool good = false;
  RawTiedContact raw = read_first_cards(cards, good);
  const Card card = cards.next(tiebreak_surface_card);
  raw.tied.method = model::TieMethod::Penalty;
  raw.tied.failure = {.normal_strength = card.real("NFLS"), .shear_strength = card.real("SFLS")};
  check_strength(cards, card, "NFLS", *raw.tied.failure);
  raw.afterwards->kind = model::ContactKind::SurfaceToSurface;
  finish(cards, deck, std::move(raw), good);
}

}  // namespace crumple::deck
