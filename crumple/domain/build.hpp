// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::domain {

/// Turns a model into a domain: nodes and elements renumbered for locality, fields at their initial values,
/// lumped masses and fixed degrees of freedom in place, one block per part that has shells with its
/// connectivity and assembly. State, constants, masses and inertias of the elements are left to the element
/// layer. Throws Error listing the faults if model::faults finds any.
Domain build(const model::Model& model, const Execution& execution);

/// Deals the elements out to the threads: builds the assembly and makes room for its slots. To be called
/// again where it has become known how many points elements have, which is what they cost.
void deal_out(Domain& domain);

}  // namespace crumple::domain
