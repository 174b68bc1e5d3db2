// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "contact/enforcement/contact_pair.hpp"
#include "contact/surface/saved_state.hpp"
#include "contact/surface/surface.hpp"

namespace crumple::contact {

/// Throws Error unless the pairs that a restart file has are of nodes and segments of the surface, in order,
/// and the nodes that were in solids at the start are its nodes.
inline void require_saved_pairs(std::span<const RememberedPair> pairs, std::span<const Index> in_solids,
                                const Surface& surface) {
  const auto fits = [&](const RememberedPair& pair) {
    return is_one_of(pair.node, surface.nodes.size()) && is_one_of(pair.segment, surface.segment_id.size()) &&
           pair.side >= -1 && pair.side <= 1 && (pair.wrong == 0 || pair.wrong == 1) &&
           (pair.let_go == 0 || pair.let_go == 1);
  };
  require_all_saved(pairs, fits, "pairs of nodes and segments");
  const auto is_node = [&](Index place) { return is_one_of(place, surface.nodes.size()); };
  require_all_saved(in_solids, is_node, "nodes in solids");
  const auto unordered = [](const RememberedPair& a, const RememberedPair& b) { return a.node > b.node; };
  require_saved(std::ranges::adjacent_find(pairs, unordered) == pairs.end(), "pairs of nodes and segments");
}

}  // namespace crumple::contact
