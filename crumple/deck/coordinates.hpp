// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "deck/raw_deck.hpp"
#include "deck/vector.hpp"

namespace crumple::deck {

/// Right-handed axes of unit length: the first along `first`, the second in the plane that `first` and
/// `other` span, on the side of `other`. Absent if the two span no plane.
std::optional<std::array<Vector, 3>> local_axes(const Vector& first, const Vector& other);

class Build;

/// Enters the ids of the coordinate systems. The nodes of the model must be there.
void enter_coordinate_systems(Build& build);

/// The axes of the coordinate system that a field refers to. Absent, with a message, where there is none or
/// where it has no axes.
std::optional<std::array<Vector, 3>> find_axes(Build& build, UserId id, std::string_view field,
                                               const Where& where);

}  // namespace crumple::deck
