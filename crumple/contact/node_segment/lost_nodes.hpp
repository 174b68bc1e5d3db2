// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "contact/enforcement/contact_pair.hpp"
#include "contact/node_segment/ragged_nodes.hpp"
#include "contact/surface/inside_outside.hpp"
#include "domain/reports.hpp"

namespace crumple::contact {

/// Counts the remembered pairs that ended in this step although nothing released the node: it was beyond the
/// mid-surface of a shell or behind the face of a solid, and no pair of the node with that segment or one
/// connected to it is left. Released are nodes that are on their own side again, that passed a free edge,
/// that were too deep (`let_go`), and those of `ragged`. Both lists are ordered by node; `lost` names the
/// first one.
void count_lost_nodes(const SurfaceAt& now, std::span<const RememberedPair> remembered,
                      std::span<const ContactPair> pairs, const RaggedNodes& ragged, long cycle,
                      domain::LostNodes& lost);

}  // namespace crumple::contact
