// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "contact/enforcement/contact_pair.hpp"
#include "contact/node_segment/ragged_nodes.hpp"
#include "contact/surface/inside_outside.hpp"
#include "domain/reports.hpp"

namespace crumple::contact {

/// Counts the nodes whose remembered pair ended in this step although nothing released it: the node was
/// beyond the mid-surface of a shell or behind the face of a solid, no pair of it with that segment is left,
/// and none with a connected one that knows it to be behind. Released are nodes that are on their own side
/// again, that passed a free edge or a sharp rim of a solid, that were too deep (`let_go`), and those of
/// `ragged`. A node that passes and is dropped within one step has no such pair. Both lists are ordered by
/// node; `lost` names the first one.
void count_lost_nodes(const SurfaceAt& now, std::span<const RememberedPair> remembered,
                      std::span<const ContactPair> pairs, const RaggedNodes& ragged, long cycle,
                      domain::LostContacts& lost);

}  // namespace crumple::contact
