// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "deck/format/cards.hpp"
#include "deck/format/raw_deck.hpp"

namespace crumple::deck {

/// Reads the cards of mass, centre, tensor and initial velocity that *PART_INERTIA and
/// *CONSTRAINED_NODAL_RIGID_BODY_INERTIA have in common. A tensor in local axes is turned into global ones.
RawInertia read_inertia(Cards& cards);

/// Axes of LS-DYNA's codes of constraints: 1, 2, 3 are x, y, z, 4 is xy, 5 yz, 6 zx, 7 all.
std::array<bool, 3> held_axes(std::int64_t code);

}  // namespace crumple::deck
