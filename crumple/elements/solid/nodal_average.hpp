// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"

namespace crumple::elements {

/// Lists the elements around each node of a block and makes room for average_dilatations().
void prepare_average(domain::SolidBlock& block);

/// For the blocks whose formulation averages at the nodes: gives every element the mean over its nodes of the
/// rate of the volume around a node over that volume, at the middle of the step that has just been taken
/// (Bonet & Burton 1998). The volume around a node is a quarter of each of the block's elements there that
/// are active. Comes before the elements. In double for both precisions and compiled once: the same bits on
/// all instruction sets; each node adds its elements up in the order of the block, so for all numbers of
/// threads as well.
void average_dilatations(domain::Domain& domain);

}  // namespace crumple::elements
