// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include <cellsearch/error.hpp>
#include <cellsearch/scene.hpp>

#include "contact/surface.hpp"
#include "math/vec3.hpp"

namespace crumple::contact {

/// Vectors by domain node as cellsearch reads them; nothing is copied [any].
cellsearch::Positions view(std::span<const Vec3> values);

/// What an error of cellsearch means to the user of a contact: NumericalError, with the user's number of the
/// node, for a position that is no number any more, else Error with cellsearch's own words.
[[noreturn]] void rethrow(const cellsearch::Error& error, const Surface& surface);

}  // namespace crumple::contact
