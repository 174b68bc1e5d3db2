// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "contact/surface/surface.hpp"
#include "domain/node_fields.hpp"

namespace crumple::contact {

/// Turns connected pieces of shells towards the nodes that may touch them: a piece in which no segment has a
/// `known` orientation gets its outside where most of its segments, or of a sample of them, have the nearest
/// of these nodes. Neighbours must be oriented alike and the topology be there. True if any piece was
/// reversed, after which the topology must be built again.
bool face_other_side(Surface& surface, const domain::NodeFields& nodes,
                     const std::vector<std::uint8_t>& known);

}  // namespace crumple::contact
