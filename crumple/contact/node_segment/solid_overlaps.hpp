// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "base/index.hpp"
#include "contact/enforcement/contact_pair.hpp"
#include "contact/surface/inside_outside.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"

namespace crumple::contact {

/// A node of the surface inside of a solid element that is not its own.
struct NodeInSolid {
  Index node = no_index;  ///< place in Surface::nodes
  ElementPlace element;
  double depth = 0;  ///< distance from the nearest side of the element that it is not on [length]
};

/// All such nodes that may touch the element's part, ascending, with one element each; not those on outer
/// sides, to a hundredth of the element's size. Interior elements count as well, so that no node is too deep
/// to be seen. O(N) for elements of similar size.
std::vector<NodeInSolid> nodes_in_solids(const Surface& surface, const domain::Domain& domain);

/// A node deep inside of a solid and the face through which it must have come.
struct DeepPair {
  Index node = no_index;  ///< place in Surface::nodes
  Index segment = no_index;
  double depth = 0;  ///< distance from the face [length]
};

/// For each of the nodes the nearest face of the same part that has the node behind it and that the node's
/// own faces can meet; nodes without one, or with other faces much nearer, are left out.
std::vector<DeepPair> faces_over(const SurfaceAt& now, const std::vector<NodeInSolid>& inside);

/// Counts nodes in solids now that neither are among those `at_start` (places, ascending) nor have a
/// remembered pair that knows of it.
void inspect_solids(const Surface& surface, const domain::Domain& domain,
                    std::span<const RememberedPair> remembered, std::span<const Index> at_start,
                    domain::ContactInspection& seen);

/// True if a node may enter a face with that normal: one of the node's faces, or their mean, points against
/// it; a tip, a node of a shell and a node alone may enter any. The node of a plate does not enter the side
/// of a block that slides over it, be the lower rim of the block a little below the plate's face or not.
/// `hidden`: faces of the node that do not count, as another body is right in front of them.
bool may_enter(const SurfaceAt& now, Index place, const Vec3& normal, std::span<const Index> hidden = {});

}  // namespace crumple::contact
