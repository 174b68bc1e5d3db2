// SPDX-License-Identifier: BSD-3-Clause
// *CONSTRAINED_RIGID_BODY_STOPPERS.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field stopper_card[] = {
    id("PID"),
    signed_id("LCMAX", IdKind::Function),
    signed_id("LCMIN", IdKind::Function),
    only("PSIDMX", {0}, "other rigid bodies do not stop with this one"),
    only("PSIDMN", {0}, "other rigid bodies do not stop with this one"),
    reference("LCVMNX", IdKind::Function),
    only("DIR", {0, 1, 2, 3, 4}, "1 to 3 are x to z, 4 is along VID; rotations (5 to 8) are not stopped"),
    reference("VID"),
};

constexpr Field stopper_times_card[] = {
    real("TB", 0, not_negative), real_or_default("TD", 1e21, above_zero), unused("-"),
    unused("STIFF"),  // implicit
};

}  // namespace

void read_constrained_rigid_body_stoppers(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(stopper_card);
    const Card times = cards.next_or_default(stopper_times_card);
    RawStopper raw;
    raw.part = card.integer("PID");
    raw.largest = card.integer("LCMAX");
    raw.smallest = card.integer("LCMIN");
    raw.speed = card.integer("LCVMNX");
    raw.direction = static_cast<int>(card.real("DIR"));
    raw.vector = card.integer("VID");
    raw.birth = times.real("TB");
    raw.death = times.real("TD");
    raw.where = card.where();
    bool good = card.good("DIR");
    for (const std::string_view field : {"PID", "LCMAX", "LCMIN", "LCVMNX", "VID"})
      good = good && card.good(field);
    if (good && raw.direction == 0) {
      cards.report().field_error(card.where(), {"DIR", std::string(card.text("DIR")), "a number from 1 to 4",
                                                "the direction in which the body is stopped", "direction"});
      continue;
    }
    if (good) deck.stoppers.push_back(raw);
  }
}

}  // namespace crumple::deck
