// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "compare/curves/curve.hpp"

namespace crumple::compare {

/// Our name of a quantity that LS-DYNA calls `name` in its file `group`, as binout spells it
/// (`kinetic_energy`); the name itself if we have none; empty for what is no history of the model (cycles,
/// times of the processor).
std::string from_ls_dyna(std::string_view group, std::string_view name);

/// Words of a table as binout spells them: `Sliding interface energy...` is `sliding_interface_energy`.
std::string binout_spelling(std::string_view words);

/// Curves of one kind have one unit, so that their sizes can be compared: the energies of glstat, the forces
/// of rwforc, the displacements of nodout, ...
std::string kind_of(const Curve& curve);

/// Adds sums that other programs write as one: `sliding_interface` of contact and friction, `eroded` of
/// eroded kinetic, internal and hourglass energy; and the size of the forces on interfaces, `resultant`,
/// which the report shows.
void add_derived_curves(CurveSet& set);

}  // namespace crumple::compare
