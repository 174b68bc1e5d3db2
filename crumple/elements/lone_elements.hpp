// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "domain/domain.hpp"
#include "math/vec3.hpp"
#include "model/model.hpp"

namespace crumple::elements {

/// Shells and tetrahedra that have few others beside them. Their usual limits are those of elements in a
/// mesh: neighbours that share their nodes cannot all swing in their stiffest mode at once. One alone can,
/// and needs 0.58 to 0.88 of that (docs/theory/time_integration.md).
class LoneElements {
 public:
  /// Counts the elements at each node; the blocks must know their nodes, no more.
  LoneElements(const model::Model& model, const domain::Domain& domain);

  /// Factor on the usual step of the element at `place` of a block, in the geometry of `domain`, at most 1
  /// [-].
  double factor(const domain::Domain& domain, const domain::ShellBlock& block, Index place) const;
  double factor(const domain::Domain& domain, const domain::SolidBlock& block, Index place) const;

 private:
  double own_share(std::span<const Index> nodes) const;

  std::vector<int> count_;  ///< elements with stiffness at each node
};

/// Largest eigenvalue of sum_n (stress of sum_m sym(u_m g_m)) g_n over the displacements u of the corners, by
/// power iteration; with the wave speed c the corners, of equal mass, vibrate with omega^2 = corners * c^2 *
/// eigenvalue at most.
/// `gradients` are those of the shape functions [1/length], without a component z in plane stress; the stress
/// of a strain E is dilatation * trace(E) I + shear * E, over that of a longitudinal wave.
double largest_eigenvalue(std::span<const math::Vec3> gradients, double dilatation, double shear);

}  // namespace crumple::elements
