// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include <cellsearch/error.hpp>
#include <cellsearch/scene.hpp>

#include "contact/surface/surface.hpp"
#include "math/vec3.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// Vectors by domain node as cellsearch reads them; nothing is copied [any].
cellsearch::Positions view(std::span<const Vec3> values);

/// All positions, by domain node, with those of `nodes` replaced by what they were at a search: x, y, z of
/// each in the order of `nodes` [length].
std::vector<Vec3> positions_at_search(std::span<const Vec3> position, std::span<const Index> nodes,
                                      std::span<const double> searched);

/// What the expansion of territories leaves beyond the largest contact distance: that of the settings, or a
/// share of the mean edge. Throws Error for an expansion that does not exceed the contact distance [length].
double margin_of(const Surface& surface, const model::SearchSettings& settings);

/// What an error of cellsearch means to the user of a contact: NumericalError, with the user's number of the
/// node, for a position that is no number any more, else Error with cellsearch's own words.
[[noreturn]] void rethrow(const cellsearch::Error& error, const Surface& surface);

}  // namespace crumple::contact
