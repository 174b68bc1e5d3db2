// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "contact/edge_edge/edge_pair.hpp"
#include "contact/edge_edge/edge_view.hpp"
#include "domain/reports.hpp"

namespace crumple::contact {

/// Counts edges that had gone through each other in the step before, that no pair of `present` holds any
/// more, and that are not back: they hang in each other, and nothing pushes them apart. Edges that slid off
/// an end where nothing continues are released, and so are those that have come back to their side; what
/// eroded is not remembered any more. `present` are the pairs now, in order; `lost` names the first.
void count_lost_edges(const EdgeView& view, std::span<const EdgePair> present, long cycle,
                      domain::LostContacts& lost);

}  // namespace crumple::contact
