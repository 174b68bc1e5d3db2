// SPDX-License-Identifier: BSD-3-Clause
// *CONTROL_DYNAMIC_RELAXATION.
#include <algorithm>
#include <cmath>

#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field relaxation_card[] = {
    real_or_default("NRCYCK", 250, not_negative),
    real_or_default("DRTOL", 0.001, not_negative),
    real_or_default("DRFCTR", 0.995, within(0, 1, "what is left of velocities in each step")),
    real("DRTERM", 0, not_negative),
    real("TSSFDR", 0, within(0, 1, "a factor on the stable time step")),
    only("IRELAL", {0, 1}, "DRFCTR is kept (0), or the factor follows from the motion (1)"),
    real_or_default("EDTTL", 0.04, not_negative),
    only(
        "IDRFLG", {0, 1, -1, -999},
        "0, 1 and -1 are of explicit steps, -999 is none; places from a file (2), parts of a set (3, -3) and "
        "implicit steps (5, 6) are not supported"),
};

}  // namespace

/// The following card is about sets of parts and implicit relaxation.
void read_control_dynamic_relaxation(Cards& cards, RawDeck& deck) {
  const Card card = cards.next_or_default(relaxation_card);
  cards.skip_rest();
  RawRelaxation raw;
  raw.flag = static_cast<int>(card.real("IDRFLG"));
  raw.settings.check_cycles = std::max(1L, std::lround(card.real("NRCYCK")));
  raw.settings.tolerance = card.real("DRTOL");
  raw.settings.factor = card.real("DRFCTR");
  raw.settings.end_time = card.real("DRTERM");
  raw.settings.step_scale = card.real("TSSFDR");
  raw.settings.automatic = card.real("IRELAL") == 1;
  raw.settings.automatic_tolerance = card.real("EDTTL");
  raw.where = card.where();
  deck.relaxation = raw;
}

}  // namespace crumple::deck
