// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What loads by a pressure on segments share: their geometry, forces and work, and their end with shells.

#include <array>
#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::loads {

/// A loaded segment: three or four nodes of the domain, a triangle with its third one twice.
using SegmentNodes = std::array<Index, 4>;

/// The nodes of the domain for those of the model.
SegmentNodes domain_nodes(const domain::Domain& domain, const std::array<Index, 4>& node);

/// Nodes that share the force: three or four.
std::size_t corners(const SegmentNodes& node);

/// Mean of the positions of the nodes [length].
math::Vec3 centre(const domain::Domain& domain, const SegmentNodes& node);

/// 1/2 (x3 - x1) x (x4 - x2): along the normal, nodes counter-clockwise seen from its tip [length^2].
math::Vec3 vector_area(const domain::Domain& domain, const SegmentNodes& node);

/// Adds a force to each node and, by the trapezoidal rule, the work since time n-1 to the ledger's external
/// work. `previous` is the force on each node at time n-1, and becomes that at time n.
void add_equal_forces(domain::Domain& domain, const SegmentNodes& node, const math::Vec3& force,
                      math::Vec3& previous);

/// Which shells have eroded, found again only when more have.
class ErodedShells {
 public:
  /// Whether more shells have eroded than when it was asked last; `gone` is up to date then.
  bool have_changed(const domain::Domain& domain, const model::Model& model);
  /// By shell of the model.
  bool gone(Index shell) const { return gone_[static_cast<std::size_t>(shell)] != 0; }
  /// How many had eroded when it was asked last: what a restart needs.
  Index& count() { return count_; }

 private:
  Index count_ = 0;
  std::vector<char> gone_;
};

}  // namespace crumple::loads
