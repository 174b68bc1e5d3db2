// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "elements/common/element_sums.hpp"
#include "elements/line/discrete_law.hpp"

namespace crumple::elements {

/// The state of a spring or damper. The item "force" is what it pulls with, scale included.
namespace discrete_state {
inline constexpr Index axis = 0;                  ///< unit vector; zero: from the first to the second node
inline constexpr Index grounded = axis + 3;       ///< 1: the second end does not move
inline constexpr Index reference = grounded + 1;  ///< distance of the ends without deformation
inline constexpr Index scale = reference + 1;     ///< on the force
inline constexpr Index stable_step = scale + 1;   ///< with the share of the nodes' masses
inline constexpr Index deformation = stable_step + 1;
inline constexpr Index force = deformation + 1;
inline constexpr Index plastic = force + 1;  ///< history of the law
inline constexpr Index hardening = plastic + 1;
inline constexpr Index count = hardening + 1;
}  // namespace discrete_state

/// Works off the elements of one chunk, in double. Plain code, the same for all instruction sets: there are
/// few, and what they do depends on their law.
void add_discrete_forces(domain::Domain& domain, domain::DiscreteBlock& block, const domain::Chunk& chunk,
                         ElementSums& sums);

}  // namespace crumple::elements
