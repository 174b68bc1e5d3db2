// SPDX-License-Identifier: BSD-3-Clause
// *CONTROL_SHELL.
#include "deck/keywords/families.hpp"
#include "deck/keywords/shell_formulations.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view no_deletion =
    "distorted elements are not deleted; a failure strain of the material erodes shells";

constexpr Field card_1[] = {
    unused("WRPANG"),  // limit of a warning
    unused("ESORT"),   // triangles are always sorted out
    only("IRNXX", {-1, 0}, "the fibres of Hughes-Liu shells are recomputed in every cycle"),
    only("ISTUPD", {0, 1, 2, 3, 4},
         "1 and 3 let the thickness follow the membrane strain, 0 and 2 do not; 4 would leave out the "
         "elastic part, "
         "and is taken as 1"),
    real("THEORY"),  // checked_formulation()
    only("BWC", {2, 0, 1}, "1 makes Belytschko-Tsay shells Belytschko-Wong-Chiang"),
    unused("MITER"),  // plasticity is always iterated to the end
    unused("PROJ"),  // the warping stiffness needs neither projection (docs/theory/belytschko_wong_chiang.md)
};

constexpr Field card_2[] = {
    only("ROTASCL", {1, 0}, "rotary inertia is not scaled by the user"),
    only("INTGRD", {0, 1}, "0 is Gauss, 1 Lobatto for 3 to 10 points"),
    only("LAMSHT", {0}, "laminated shell theory is not supported"),
    unused("CSTYP6"),  // for ELFORM 6
    harmless("THSHEL", {0}, "there is no thermal solution"),
};

constexpr Field card_3[] = {
    only("PSSTUPD", {0}, "ISTUPD holds for all parts"),
    unused("SIDT4TU"),  // for ISTUPD=4
    only("CNTCO", {0}, "contact is with the mid-surface and the thickness"),
    harmless("ITSFLG", {0}, "triangles have no mass scaling of their own"),
    unused("IRQUAD"),  // for higher-order shells
    only("W-MODE", {0}, no_deletion),
    only("STRETCH", {0}, no_deletion),
    only("ICRQ", {0}, "thickness and strain are not averaged at the nodes"),
};

constexpr Field card_4[] = {
    only("NFAIL1", {0, 1, 2}, "shells with a negative Jacobian are reported, and stay"),
    only("NFAIL4", {0, 1, 2}, "shells with a negative Jacobian are reported, and stay"),
    unused("PSNFAIL"),  // for NFAIL1 and NFAIL4
    unused("KEEPCS"),   // for failed elements
    only("DELFR", {0}, no_deletion),
    only("DRCPSID", {0}, "there is no drilling stiffness"),
    unused("DRCPRM"),
    unused("INTPERR"),  // for initial stress
};

constexpr Field card_5[] = {
    unused("DRCMTH"), only("LISPSID", {0}, "parts have no rule of their own"),
    unused("NLOCDT"),  // for NLOC of *SECTION_SHELL
};

/// ISTUPD. 2 and 3 add thick shells, which there are none of.
bool follows_strain(const Card& card, Report& report) {
  const double option = card.real("ISTUPD");
  if (option == 4)
    report.field_warning(
        card.where(), {"ISTUPD", "4", "0 to 3",
                       "it is taken as 1: the elastic strain, some thousandths of the thickness in metals, "
                       "changes it as well",
                       "elastic thickness"});
  return option == 1 || option == 3 || option == 4;
}

}  // namespace

void read_control_shell(Cards& cards, RawDeck& deck) {
  const Card card = cards.next_or_default(card_1);
  deck.control_shell = card.where();
  deck.control.thickness_change = follows_strain(card, cards.report());
  deck.default_formulation = shell_formulation(checked_formulation(card, "THEORY", cards.report()));
  deck.warping_stiffness = card.real("BWC") == 1;
  if (cards.has_line()) deck.lobatto_points = cards.next(card_2).real("INTGRD") == 1;
  if (cards.has_line()) cards.next(card_3);
  if (cards.has_line()) {
    const Card failure = cards.next(card_4);
    deck.distorted_shells = {failure.where(), failure.real("NFAIL1") != 0, failure.real("NFAIL4") != 0};
  }
  if (cards.has_line()) cards.next(card_5);
}

}  // namespace crumple::deck
