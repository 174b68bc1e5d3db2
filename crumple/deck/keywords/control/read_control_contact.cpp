// SPDX-License-Identifier: BSD-3-Clause
// *CONTROL_CONTACT.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view by_part = "friction and thickness of parts are those of *PART_CONTACT";

constexpr Field card_1[] = {
    real_or_default("SLSFAC", 0.1, above_zero),
    unused("RWPNAL"),  // for rigid bodies; deformable nodes are stopped by the constraint method
    unused("ISLCHK"),  // initial penetrations are always looked for
    only("SHLTHK", {0, 1, 2}, "0 leaves out the thickness of shells, 1 that of rigid ones"),
    harmless("PENOPT", {1, 0}, "the smaller stiffness of node and segment is taken"),
    harmless("THKCHG", {0}, "contact keeps the first thickness"),
    harmless("ORIEN", {0, 1}, "parts are turned to face the other side, segments are not"),
    harmless("ENMASS", {0}, "nodes whose elements have eroded touch nothing"),
};

constexpr Field card_2[] = {
    only("USRSTR", {0}, "there are no user subroutines"),
    only("USRFRC", {0}, "there are no user subroutines"),
    unused("NSBCS"),  // the search is repeated when motion demands it
    unused("INTERM"),
    unused("XPENE"),  // for other kinds of contact
    harmless("SSTHK", {0}, "thickness is limited by the element size; give SST on *CONTACT to set it"),
    unused("ECDT"),
    harmless("TIEDPRJ", {0}, "nodes tied by constraint are put onto their segments; _OFFSET keeps gaps"),
};

constexpr Field card_3[] = {
    harmless("SFRIC", {0}, by_part),  harmless("DFRIC", {0}, by_part),
    harmless("EDC", {0}, by_part),    harmless("VFC", {0}, by_part),
    harmless("TH", {0}, by_part),     harmless("TH_SF", {0}, by_part),
    harmless("PEN_SF", {0}, by_part), unused("PTSCL"),
};

constexpr Field card_4[] = {
    unused("IGNORE"),  // see docs/deck.md: initial penetrations are tracked
    unused("FRCENG"),  // frictional energy is always computed
    unused("SKIPRWG"), unused("OUTSEG"), unused("SPOTSTP"), unused("SPOTDEL"), unused("SPOTHIN"),
};

constexpr Field card_5[] = {
    only("ISYM", {0}, "symmetry planes are not known to contact"),
    unused("NSEROD"),
    unused("RWGAPS"),
    unused("RWGDTH"),
    unused("RWKSF"),
    unused("ICOV"),
    unused("SWRADF"),
    unused("ITHOFF"),
};

constexpr Field card_6[] = {
    harmless("SHLEDG", {0}, "free edges of shells are rounded"),
    harmless("PSTIFF", {0}, "the penalty stiffness comes from the material"),
    unused("ITHCNT"),
    unused("TDCNOF"),
    unused("FTALL"),
    unused("-"),
    harmless("SHLTRW", {0}, "rigid walls stop the mid-surface of shells"),
    unused("IGACTC"),
};

}  // namespace

void read_control_contact(Cards& cards, RawDeck& deck) {
  const Card first = cards.next_or_default(card_1);
  deck.control.contact_stiffness_scale = first.real("SLSFAC");
  deck.contact_thickness_option = static_cast<int>(first.real("SHLTHK"));
  for (const Layout layout : {Layout(card_2), Layout(card_3), Layout(card_4), Layout(card_5), Layout(card_6)})
    if (cards.has_line()) cards.next(layout);
}

}  // namespace crumple::deck
