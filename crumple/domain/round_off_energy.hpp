// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"

namespace crumple::domain {

/// What round-off alone gives a model at rest: places are known to the last digit of the largest coordinate,
/// and stiffness throws nodes about by that much in a step (own estimate). Costs a pass over the nodes
/// [energy].
double round_off_energy(const Domain& domain);

}  // namespace crumple::domain
