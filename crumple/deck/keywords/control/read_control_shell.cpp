// SPDX-License-Identifier: BSD-3-Clause
// *CONTROL_SHELL.
#include <algorithm>
#include <utility>

#include "deck/keywords/families.hpp"
#include "deck/keywords/shell_formulations.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view no_deletion =
    "distorted elements are not deleted; a failure strain of the material erodes shells";

constexpr std::string_view distorted_stay = "shells with a negative Jacobian are reported, and stay";

constexpr Field card_1[] = {
    unused("WRPANG"),   // limit of a warning
    unused("ESORT"),    // triangles are always sorted out
    real("IRNXX", -1),  // of Hughes-Liu shells
    only("ISTUPD", {0, 1, 2, 3, 4},
         "1 and 3 let the thickness follow the membrane strain, 0 and 2 do not; 4 would leave out the "
         "elastic part, "
         "and is taken as 1"),
    real("THEORY"),  // of sections without ELFORM
    only("BWC", {2, 0, 1}, "1 makes Belytschko-Tsay shells Belytschko-Wong-Chiang"),
    unused("MITER"),  // plasticity is always iterated to the end
    unused("PROJ"),  // the warping stiffness needs neither projection (docs/theory/belytschko_wong_chiang.md)
};

constexpr Field card_2[] = {
    only("ROTASCL", {1, 0}, "rotary inertia is not scaled by the user"),
    only("INTGRD", {0, 1}, "0 is Gauss, 1 Lobatto for 3 to 10 points"),
    real("LAMSHT"),    // of layered shells
    unused("CSTYP6"),  // for ELFORM 6
    harmless("THSHEL", {0}, "there is no thermal solution"),
    // Where older versions of the format have them.
    only("NFAIL1", {0, 1, 2}, distorted_stay),
    only("NFAIL4", {0, 1, 2}, distorted_stay),
};

constexpr Field card_3[] = {
    only("PSSTUPD", {0}, "ISTUPD holds for all parts"),
    unused("SIDT4TU"),  // for ISTUPD=4
    real("CNTCO"),      // of shells that are not where their nodes are
    harmless("ITSFLG", {0}, "triangles have no mass scaling of their own"),
    unused("IRQUAD"),  // for higher-order shells
    only("W-MODE", {0}, no_deletion),
    only("STRETCH", {0}, no_deletion),
    only("ICRQ", {0}, "thickness and strain are not averaged at the nodes"),
};

constexpr Field card_4[] = {
    only("NFAIL1", {0, 1, 2}, distorted_stay),
    only("NFAIL4", {0, 1, 2}, distorted_stay),
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

/// Notes a value that is not among the supported ones: whether it matters is known once there are shells.
void note_option(const Card& card, RawShellOption option, std::initializer_list<double> supported,
                 RawDeck& deck) {
  if (!card.good(option.field)) return;
  if (std::find(supported.begin(), supported.end(), card.real(option.field)) != supported.end()) return;
  option.where = card.where();
  option.read = card.text(option.field);
  deck.shell_options.push_back(std::move(option));
}

void take_failure(const Card& card, RawDistortedShells& shells) {
  shells.where = card.where();
  shells.one_point = shells.one_point || card.real("NFAIL1") != 0;
  shells.fully_integrated = shells.fully_integrated || card.real("NFAIL4") != 0;
}

}  // namespace

void read_control_shell(Cards& cards, RawDeck& deck) {
  const Card card = cards.next_or_default(card_1);
  deck.control_shell = card.where();
  deck.control.thickness_change = follows_strain(card, cards.report());
  using About = RawShellOption::About;
  const auto note = [&](const Card& on, RawShellOption option, std::initializer_list<double> supported) {
    note_option(on, std::move(option), supported, deck);
  };
  if (is_shell_formulation(card.real("THEORY")))
    deck.default_formulation = shell_formulation(static_cast<std::int64_t>(card.real("THEORY")));
  note(card,
       {About::ShellsOfNoFormulation, {}, "THEORY", {}, supported_formulations, meaning_of_formulations},
       {0, 1, 2, 4, 5, 6, 9, 10, 16});
  note(card,
       {About::HughesLiuShells,
        {},
        "IRNXX",
        {},
        "-1 or 0",
        "the fibres of Hughes-Liu shells are recomputed in "
        "every cycle"},
       {-1, 0});
  deck.warping_stiffness = card.real("BWC") == 1;
  if (cards.has_line()) {
    const Card second = cards.next(card_2);
    deck.lobatto_points = second.real("INTGRD") == 1;
    note(second, {About::LayeredShells, {}, "LAMSHT", {}, "0", "laminated shell theory is not supported"},
         {0});
    if (second.real("NFAIL1") != 0 || second.real("NFAIL4") != 0) take_failure(second, deck.distorted_shells);
  }
  if (cards.has_line())
    note(cards.next(card_3),
         {About::OffsetShells, {}, "CNTCO", {}, "0", "contact is with the mid-surface and the thickness"},
         {0});
  if (cards.has_line()) take_failure(cards.next(card_4), deck.distorted_shells);
  if (cards.has_line()) cards.next(card_5);
}

}  // namespace crumple::deck
