// SPDX-License-Identifier: BSD-3-Clause
// *CONTACT of surfaces that push each other, and force transducers.
#include <fmt/core.h>

#include <array>
#include <cmath>

#include "deck/keywords/contact/contact_cards.hpp"
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view of_surfaces =
    "0 is a segment set, 1 a shell set, 2 a part set, 3 a part, 5 all parts, 6 all but a part set";
constexpr std::string_view of_nodes =
    "0 is a segment set, 1 a shell set, 2 a part set, 3 a part, 4 a node set, 5 all parts, 6 all but a part "
    "set";

constexpr Field card_1_single[] = {
    reference("SSID", kind_of_first_side),
    unused("MSID"),  // single-surface contact has one side
    only("SSTYP", {0, 1, 2, 3, 5, 6}, of_surfaces),
    unused("MSTYP"),
    reference("SBOXID"),
    unused("MBOXID"),
    integer("SPR"),
    unused("MPR"),
};

constexpr Field card_1_surfaces[] = {
    reference("SSID", kind_of_first_side),
    reference("MSID", kind_of_second_side),
    only("SSTYP", {0, 1, 2, 3, 5, 6}, of_surfaces),
    only("MSTYP", {0, 1, 2, 3, 5, 6}, of_surfaces),
    reference("SBOXID"),
    reference("MBOXID"),
    integer("SPR"),
    integer("MPR"),
};

constexpr Field card_1_nodes[] = {
    reference("SSID", kind_of_first_side),
    reference("MSID", kind_of_second_side),
    only("SSTYP", {0, 1, 2, 3, 4, 5, 6}, of_nodes),
    only("MSTYP", {0, 1, 2, 3, 5, 6}, of_surfaces),
    reference("SBOXID"),
    reference("MBOXID"),
    integer("SPR"),
    integer("MPR"),
};

constexpr Field contact_card_2[] = {
    real("FS"),
    real("FD", 0, not_negative),
    real("DC", 0, not_negative),
    real("VC", 0, not_negative),
    real("VDC", 0, not_negative),
    harmless("PENCHK", {0}, "it is for other kinds of contact"),
    real("BT", 0, not_negative),
    real_or_default("DT", 1e20, above_zero),
};

constexpr Field contact_card_3[] = {
    real_or_default("SFS", 1, above_zero),  real_or_default("SFM", 1, above_zero),
    real("SST", 0, not_negative),           real("MST", 0, not_negative),
    real_or_default("SFST", 1, above_zero), real_or_default("SFMT", 1, above_zero),
    real_or_default("FSF", 1, above_zero),  real_or_default("VSF", 1, above_zero),
};

// Of contact with erosion: what erosion exposes takes part anyway.
constexpr Field contact_card_4[] = {
    only("ISYM", {0, 1}, "1 leaves out faces of solids on planes of symmetry"),
    unused("EROSOP"),
    unused("IADJ"),
};

// Of contact by constraints: how the two sides share what is kinematic.
constexpr Field contact_card_4_constraint[] = {harmless("KPF", {0}, "both sides are treated alike")};

// Of the _MPP option; a second one begins with an ampersand.
constexpr Field contact_card_mpp[] = {
    unused("IGNORE"),  unused("BCKT"),
    unused("LCBCKT"),  unused("NS2TRK"),
    unused("INITITR"), unused("PARMAX"),
    unused("-"),       only("CPARM8", {0}, "all edges and beams take part")};

constexpr Field contact_card_a[] = {
    only("SOFT", {0, 1, 2},
         "0 takes the penalty stiffness from the material, 1 at least from mass and step, 2 always from "
         "these"),
    real_or_default("SOFSCL", 0.1, above_zero),  // for SOFT=1
    only("LCIDAB", {0}, "the thickness does not change over time"),
    unused("MAXPAR"),  // inside-outside search has no such margin
    unused("SBOPT"),   // for SOFT=2
    integer("DEPTH"),  // says which edges take part; there is no depth of search
    unused("BSORT"),   // the search is repeated when motion demands it
    harmless("FRCFRQ", {1, 0}, "contact forces are computed in every cycle"),
};

constexpr Field contact_card_b[] = {
    real("PENMAX", 0, not_negative),
    only("THKOPT", {0, 1, 2}, "0 takes SHLTHK of *CONTROL_CONTACT, 1 that beside it, 2 is no thickness"),
    only("SHLTHK", {0, 1, 2}, "0 leaves out the thickness of shells, 1 that of rigid ones"),
    harmless("SNLOG", {0}, "node release logic is built in"),
    only("ISYM", {0, 1}, "1 leaves out faces of solids on planes of symmetry"),
    unused("I2D3D"),
    real("SLDTHK", 0, not_negative),
    real("SLDSTF", 0, not_negative),
};

constexpr Field contact_card_c[] = {
    unused("IGAP"),    // implicit
    unused("IGNORE"),  // see docs/deck.md: initial penetrations are tracked
    only("DPRFAC", {0}, "penetration is not reduced over time"),
    harmless("DTSTIF", {0}, "stiffness by mass (SOFT 1, 2) takes the step of the run"),
    unused("EDGEK"),
    unused("-"),
    harmless("FLANGL", {0}, "mesh normals smooth the surface"),
    unused("CID_RCF"),  // axes of output
};

constexpr Field contact_card_d[] = {
    unused("Q2TRI"),  unused("DTPCHK"),
    unused("SFNBR"),
    unused("FNLSCL"),  // for SOFT=2
    unused("DNLSCL"), unused("TCSO"),
    unused("TIEDID"), harmless("SHLEDG", {0}, "free edges of shells are rounded"),
};

// Rounding and friction of segment-based and mortar contact.
constexpr Field contact_card_e[] = {
    unused("SHAREC"), unused("CPARM8"),
    unused("IPBACK"), harmless("SRNDE", {0}, "free edges of shells are round"),
    unused("FRICSF"), only("ICOR", {0}, "VDC is damping, and no coefficient of restitution"),
    unused("FTORQ"),  only("REGION", {0}, "contact acts everywhere")};

constexpr Field contact_card_f[] = {
    unused("PSTIFF"), only("IGNROFF", {0}, "the thickness of shells counts on both sides"),
    unused("-"),      unused("FSTOL"),
    unused("2DBINR"), unused("SSFTYP"),
    unused("SWTPR"),  unused("TETFAC")};

constexpr Field interior_card[] = {
    reference("PSID1", IdKind::Set), reference("PSID2", IdKind::Set), reference("PSID3", IdKind::Set),
    reference("PSID4", IdKind::Set), reference("PSID5", IdKind::Set), reference("PSID6", IdKind::Set),
    reference("PSID7", IdKind::Set), reference("PSID8", IdKind::Set),
};

using Target = RawContactSide::Target;

/// The meanings of SSTYP and MSTYP, by their number.
constexpr std::array<Target, 7> targets = {Target::SegmentSet,   Target::ShellSet, Target::PartSet,
                                           Target::Part,         Target::NodeSet,  Target::All,
                                           Target::AllButPartSet};

/// Names of the fields of a side.
struct SideFields {
  std::string_view id;
  std::string_view type;
  std::string_view box;
  std::string_view node_forces;
};

constexpr SideFields first_fields{"SSID", "SSTYP", "SBOXID", "SPR"};
constexpr SideFields second_fields{"MSID", "MSTYP", "MBOXID", "MPR"};

RawContactSide side_of(const Card& card, const SideFields& fields) {
  RawContactSide side;
  side.field = fields.id;
  side.box_field = fields.box;
  side.id = card.integer(fields.id);
  side.box = card.integer(fields.box);
  if (card.good(fields.type)) side.target = targets[static_cast<std::size_t>(card.real(fields.type))];
  return side;
}

/// What sets the kinds of contact apart.
struct Form {
  model::ContactKind kind = model::ContactKind::SingleSurface;
  bool automatic = true;  ///< both sides of shells, with their thickness
  bool eroding = false;
  bool forming = false;  ///< the blank has its thickness, rigid tools have none
  bool constrains = false;
  bool only_measures = false;
  model::ContactEdges edges = model::ContactEdges::None;
};

bool has_option(const Cards& cards, std::string_view option) {
  return cards.where().keyword.find(option) != std::string_view::npos;
}

Layout card_1_of(const Form& form) {
  if (form.only_measures || form.kind == model::ContactKind::SurfaceToSurface) return card_1_surfaces;
  return form.kind == model::ContactKind::SingleSurface ? Layout(card_1_single) : Layout(card_1_nodes);
}

/// FS is a coefficient, or says where they are: -1 in *PART_CONTACT, -2 in the *DEFINE_FRICTION of FD.
void read_friction(Cards& cards, const Card& second, const Card& third, RawContact& raw) {
  constexpr double first_code = 2;  // a table by pressure and speed
  const double at_rest = second.real("FS");
  raw.friction_where = second.where();
  raw.friction_scale = third.real("FSF");
  raw.stress_scale = third.real("VSF");
  if (at_rest == -1) {
    raw.friction = FrictionSource::Parts;
    return;
  }
  if (at_rest == -2) {
    raw.friction = FrictionSource::Table;
    raw.friction_table = cards.placement().id(IdKind::Definition, std::llround(second.real("FD")));
    return;
  }
  if (at_rest < 0 || at_rest >= first_code) {
    cards.report().field_error(
        second.where(), {"FS", std::string(second.text("FS")), "a coefficient from 0 to below 2, -1 or -2",
                         "-1 takes the friction of *PART_CONTACT, -2 that of *DEFINE_FRICTION; friction by "
                         "tables of pressure and speed (2) is not supported",
                         "friction"});
    return;
  }
  raw.contact.static_friction = at_rest * raw.friction_scale;
  raw.contact.dynamic_friction = second.real("FD") * raw.friction_scale;
  raw.contact.friction_decay = second.real("DC");
  raw.contact.friction_stress = second.real("VC") * raw.stress_scale;
}

/// Cards 2 and 3.
void read_forces(Cards& cards, const Form& form, RawContact& raw) {
  model::Contact& contact = raw.contact;
  const Card second = cards.next(contact_card_2);
  const Card third = cards.next(contact_card_3);
  read_friction(cards, second, third, raw);
  contact.viscous_damping = second.real("VDC") / 100;  // percent of critical
  contact.birth_time = second.real("BT");
  contact.death_time = second.real("DT");
  contact.side[0].stiffness_scale = third.real("SFS");
  contact.side[1].stiffness_scale = third.real("SFM");
  if (form.kind == model::ContactKind::SingleSurface)
    contact.side[0].stiffness_scale *= contact.side[1].stiffness_scale;
  contact.side[0].contact_thickness = third.real("SST");
  contact.side[1].contact_thickness = third.real("MST");
  contact.side[0].thickness_scale = third.real("SFST");
  contact.side[1].thickness_scale = third.real("SFMT");
}

/// DEPTH of 5, 15, 25, ...: edges against edges, with SOFT = 2 and in contacts with edges.
void read_depth(Cards& cards, const Card& card, RawContact& raw) {
  constexpr int last_digit = 10;
  constexpr int edges_to_edges = 5;
  model::Contact& contact = raw.contact;
  if (card.integer("DEPTH") % last_digit != edges_to_edges) return;
  if (contact.edges == model::ContactEdges::None && !contact.mass_stiffness) return;
  // Nodes have no edges, and an edge of shells with an outside is on neither side of another one.
  if (!has_option(cards, "_NODES_TO_SURFACE") && !contact.oriented &&
      contact.enforcement == model::Enforcement::Penalty) {
    contact.edges = model::ContactEdges::All;
    return;
  }
  cards.report().warning(
      card.where(), "depth",
      fmt::format("edges do not touch edges in this contact, DEPTH {} acts like 2: AUTOMATIC "
                  "contacts of surfaces have such edges",
                  card.integer("DEPTH")));
}

void read_optional_cards(Cards& cards, RawContact& raw) {
  if (!cards.has_line()) return;
  const Card soft = cards.next(contact_card_a);
  if (soft.real("SOFT") == 1) raw.contact.soft_scale = soft.real("SOFSCL");
  raw.contact.mass_stiffness = soft.real("SOFT") == 2;
  read_depth(cards, soft, raw);
  if (!cards.has_line()) return;
  const Card thickness = cards.next(contact_card_b);
  // Of MORTAR it is a depth that the contact keeps, not one at which it lets go.
  if (!has_option(cards, "_MORTAR")) raw.contact.release_depth = thickness.real("PENMAX");
  raw.contact.solid_thickness = thickness.real("SLDTHK");
  raw.contact.symmetry_planes |= thickness.real("ISYM") == 1;
  raw.contact.solid_modulus = thickness.real("SLDSTF");
  if (thickness.real("THKOPT") > 0) raw.takes_own_thickness_option = true;
  if (thickness.real("THKOPT") == 1) raw.thickness_option = static_cast<int>(thickness.real("SHLTHK"));
  for (const Layout layout :
       {Layout(contact_card_c), Layout(contact_card_d), Layout(contact_card_e), Layout(contact_card_f)})
    if (cards.has_line()) cards.next(layout);
}

/// True if a side is named; reports it if not.
bool has_side(const Card& card, const SideFields& fields, Cards& cards) {
  if (!card.good(fields.id) || !card.good(fields.type)) return false;
  if (card.integer(fields.id) != 0 || card.real(fields.type) == 5) return true;
  cards.report().field_error(card.where(), {fields.id, std::string(card.text(fields.id)), "an id",
                                            fmt::format("{}=5 means all parts", fields.type)});
  return false;
}

/// Whether an automatic contact of two surfaces names neither: it is then one of all parts with each other.
bool names_no_surface(const Card& first, const Form& form) {
  const auto blank = [&](const SideFields& fields) {
    constexpr double all = 5;
    return first.good(fields.id) && first.good(fields.type) && first.integer(fields.id) == 0 &&
           first.real(fields.type) != all;
  };
  return form.kind == model::ContactKind::SurfaceToSurface && form.automatic && !form.only_measures &&
         blank(first_fields) && blank(second_fields);
}

void read(Cards& cards, RawDeck& deck, Form form) {
  const Heading heading = cards.heading();
  skip_mpp_cards(cards);
  const Card first = cards.next(card_1_of(form));
  if (names_no_surface(first, form)) {
    form.kind = model::ContactKind::SingleSurface;
    cards.report().warning(first.where(), "surfaces",
                           "neither surface is named: all parts are in contact with each other, as in "
                           "*CONTACT_AUTOMATIC_SINGLE_SURFACE");
  }
  if (has_option(cards, "_MORTAR"))
    cards.report().warning(first.where(), "mortar",
                           "the penalty acts at nodes and edges, as in the contact without MORTAR: forces "
                           "between segments are not integrated over their area");
  RawContact raw;
  raw.contact.id = heading.id;
  raw.contact.title = heading.title;
  raw.contact.kind = form.kind;
  raw.contact.oriented = !form.automatic;
  raw.contact.edges = form.edges;
  raw.only_measures = form.only_measures;
  constexpr int but_of_rigid_shells = 1;  // SHLTHK
  raw.takes_own_thickness_option = form.forming;
  if (form.forming) raw.thickness_option = but_of_rigid_shells;
  raw.where = first.where();
  raw.side[0] = side_of(first, first_fields);
  raw.contact.side[0].node_forces = first.integer(first_fields.node_forces) > 0;
  read_forces(cards, form, raw);
  if (form.eroding) raw.contact.symmetry_planes = cards.next(contact_card_4).real("ISYM") == 1;
  if (form.constrains) {
    raw.contact.enforcement = model::Enforcement::Multipliers;
    cards.next(contact_card_4_constraint);
  }
  read_optional_cards(cards, raw);
  bool good = first.good("SSTYP") && first.good("SSID");
  if (form.kind == model::ContactKind::SingleSurface && !form.only_measures) {
    // Contact with itself is of all parts where none is named.
    if (raw.side[0].id == 0) raw.side[0].target = Target::All;
  } else {
    raw.side[1] = side_of(first, second_fields);
    raw.contact.side[1].node_forces = first.integer(second_fields.node_forces) > 0;
    good = has_side(first, first_fields, cards);
    if (!form.only_measures) good = has_side(first, second_fields, cards) && good;
  }
  if (good) deck.contacts.push_back(std::move(raw));
}

}  // namespace

void skip_mpp_cards(Cards& cards) {
  if (!has_option(cards, "_MPP")) return;
  cards.next(contact_card_mpp);
  if (cards.peek().starts_with("&")) cards.text_line("the second card of _MPP");
}

// *CONTACT_SINGLE_SURFACE, *CONTACT_ERODING_SINGLE_SURFACE and the automatic form are the same contact here.
void read_contact_single_surface(Cards& cards, RawDeck& deck) {
  read(cards, deck, {.eroding = has_option(cards, "_ERODING")});
}

void read_contact_automatic_general(Cards& cards, RawDeck& deck) {
  read(cards, deck,
       {.edges = has_option(cards, "_INTERIOR") ? model::ContactEdges::All : model::ContactEdges::Free});
}

void read_contact_automatic_surface_to_surface(Cards& cards, RawDeck& deck) {
  read(cards, deck, {.kind = model::ContactKind::SurfaceToSurface});
}

void read_contact_automatic_nodes_to_surface(Cards& cards, RawDeck& deck) {
  read(cards, deck, {.kind = model::ContactKind::NodesToSurface});
}

void read_contact_forming_surface_to_surface(Cards& cards, RawDeck& deck) {
  read(cards, deck, {.kind = model::ContactKind::SurfaceToSurface, .automatic = false, .forming = true});
}

void read_contact_forming_nodes_to_surface(Cards& cards, RawDeck& deck) {
  read(cards, deck, {.kind = model::ContactKind::NodesToSurface, .automatic = false, .forming = true});
}

void read_contact_surface_to_surface(Cards& cards, RawDeck& deck) {
  read(cards, deck, {.kind = model::ContactKind::SurfaceToSurface, .automatic = false});
}

void read_contact_nodes_to_surface(Cards& cards, RawDeck& deck) {
  read(cards, deck, {.kind = model::ContactKind::NodesToSurface, .automatic = false});
}

// Faces of solids have an outside and shells that erode are worth both of their sides.
void read_contact_eroding_surface_to_surface(Cards& cards, RawDeck& deck) {
  read(cards, deck, {.kind = model::ContactKind::SurfaceToSurface, .eroding = true});
}

void read_contact_eroding_nodes_to_surface(Cards& cards, RawDeck& deck) {
  read(cards, deck, {.kind = model::ContactKind::NodesToSurface, .eroding = true});
}

void read_contact_constraint_surface_to_surface(Cards& cards, RawDeck& deck) {
  read(cards, deck, {.kind = model::ContactKind::SurfaceToSurface, .constrains = true});
}

void read_contact_constraint_nodes_to_surface(Cards& cards, RawDeck& deck) {
  read(cards, deck, {.kind = model::ContactKind::NodesToSurface, .constrains = true});
}

void read_contact_force_transducer(Cards& cards, RawDeck& deck) {
  read(cards, deck, {.kind = model::ContactKind::SurfaceToSurface, .only_measures = true});
}

void read_contact_interior(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(interior_card);
    for (const Field& field : interior_card)
      if (card.good(field.name) && card.integer(field.name) != 0)
        deck.interiors.push_back({card.integer(field.name), field.name, card.where()});
  }
}

}  // namespace crumple::deck
