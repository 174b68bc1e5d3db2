// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/node_fields.hpp"
#include "model/model.hpp"

namespace crumple::domain {

/// Lists in nodes.local_holds what the supports with axes or times of their own hold of translations at a
/// time. The global axes that are fixed must be in place. Once listed it allocates no more.
void list_local_holds(const model::Model& model, double time, NodeFields& nodes);

}  // namespace crumple::domain
