// SPDX-License-Identifier: BSD-3-Clause
// *CONTACT_AUTOMATIC_SINGLE_SURFACE, *CONTACT_SINGLE_SURFACE.
#include "deck/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view no_boxes = "boxes are not supported; use a set";

constexpr Field contact_card_1[] = {
    reference("SSID"),
    unused("MSID"),  // single-surface contact has one side
    only("SSTYP", {0, 2, 3, 5, 6}, "2 is a part set, 3 a part, 5 all parts, 6 all but a part set"),
    unused("MSTYP"),
    only("SBOXID", {0}, no_boxes),
    unused("MBOXID"),
    unused("SPR"),  // output
    unused("MPR"),
};

constexpr Field contact_card_2[] = {
    real("FS", 0, not_negative),  real("FD", 0, not_negative),
    real("DC", 0, not_negative),  real("VC", 0, not_negative),
    real("VDC", 0, not_negative), harmless("PENCHK", {0}, "it is for other kinds of contact"),
    real("BT", 0, not_negative),  real_or_default("DT", 1e20, above_zero),
};

constexpr Field contact_card_3[] = {
    real_or_default("SFS", 1, above_zero),  real_or_default("SFM", 1, above_zero),
    real("SST", 0, not_negative),           unused("MST"),
    real_or_default("SFST", 1, above_zero), unused("SFMT"),
    real_or_default("FSF", 1, above_zero),  real_or_default("VSF", 1, above_zero),
};

constexpr Field contact_card_a[] = {
    only(
        "SOFT", {0, 1},
        "0 takes the penalty stiffness from the material, 1 at least from mass and step; contact of segments "
        "with segments (2) is not supported"),
    real_or_default("SOFSCL", 0.1, above_zero),  // for SOFT=1
    only("LCIDAB", {0}, "airbags are not supported"),
    unused("MAXPAR"),  // inside-outside search has no such margin
    unused("SBOPT"),   // for SOFT=2
    unused("DEPTH"),
    unused("BSORT"),  // the search is repeated when motion demands it
    harmless("FRCFRQ", {1, 0}, "contact forces are computed in every cycle"),
};

constexpr Field contact_card_b[] = {
    only("PENMAX", {0}, "nodes are not released by their penetration"),
    unused("THKOPT"),
    unused("SHLTHK"),  // single-surface contact always takes the thickness
    harmless("SNLOG", {0}, "node release logic is built in"),
    only("ISYM", {0}, "symmetry planes are not known to contact"),
    unused("I2D3D"),
    only("SLDTHK", {0}, "faces of solids have no thickness"),
    only("SLDSTF", {0}, "the stiffness of faces comes from the bulk modulus"),
};

constexpr Field contact_card_c[] = {
    unused("IGAP"),    // implicit
    unused("IGNORE"),  // see docs/deck.md: initial penetrations are tracked
    only("DPRFAC", {0}, "penetration is not reduced over time"),
    only("DTSTIF", {0}, "the penalty stiffness does not come from a time step"),
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
constexpr Field contact_card_e[] = {unused("SHAREC"), unused("CPARM8"), unused("IPBACK"), unused("SRNDE"),
                                    unused("FRICSF"), unused("ICOR"),   unused("FTORQ"),  unused("REGION")};

constexpr Field contact_card_f[] = {unused("PSTIFF"), unused("IGNROFF"), unused("-"),     unused("FSTOL"),
                                    unused("2DBINR"), unused("SSFTYP"),  unused("SWTPR"), unused("TETFAC")};

RawContact::Target target_of(const Card& card) {
  const auto kind = static_cast<int>(card.real("SSTYP"));
  if (kind == 5 || card.integer("SSID") == 0) return RawContact::Target::All;
  if (kind == 2) return RawContact::Target::PartSet;
  if (kind == 6) return RawContact::Target::AllButPartSet;
  return RawContact::Target::Part;
}

}  // namespace

void read_contact_automatic_single_surface(Cards& cards, RawDeck& deck) {
  const Heading heading = cards.heading();
  const Card first = cards.next(contact_card_1);
  const Card second = cards.next(contact_card_2);
  const Card third = cards.next(contact_card_3);
  RawContact raw;
  if (cards.has_line()) {
    const Card soft = cards.next(contact_card_a);
    if (soft.real("SOFT") == 1) raw.contact.soft_scale = soft.real("SOFSCL");
  }
  for (const Layout layout : {Layout(contact_card_b), Layout(contact_card_c), Layout(contact_card_d),
                              Layout(contact_card_e), Layout(contact_card_f)})
    if (cards.has_line()) cards.next(layout);
  raw.contact.id = heading.id;
  raw.contact.title = heading.title;
  raw.contact.static_friction = second.real("FS") * third.real("FSF");
  raw.contact.dynamic_friction = second.real("FD") * third.real("FSF");
  raw.contact.friction_decay = second.real("DC");
  raw.contact.friction_stress = second.real("VC") * third.real("VSF");
  raw.contact.viscous_damping = second.real("VDC") / 100;  // percent of critical
  raw.contact.birth_time = second.real("BT");
  raw.contact.death_time = second.real("DT");
  raw.contact.stiffness_scale = third.real("SFS") * third.real("SFM");
  raw.contact.contact_thickness = third.real("SST");
  raw.contact.thickness_scale = third.real("SFST");
  raw.id = first.integer("SSID");
  raw.target = target_of(first);
  raw.where = first.where();
  if (first.good("SSTYP") && first.real("SSTYP") == 0 && raw.id != 0)
    cards.report().field_unsupported(
        first.where(), {"SSTYP", std::string(first.text("SSTYP")), "2, 3, 5 or 6 with this SSID",
                        "segment sets (0) are not supported; SSID=0 means all parts", "segments"});
  else if (first.good("SSID") && first.good("SSTYP"))
    deck.contacts.push_back(std::move(raw));
}

}  // namespace crumple::deck
