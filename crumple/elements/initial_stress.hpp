// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::elements {

/// Gives the shells and solids of a prepared domain the stresses at time zero of Model::shell_stresses and
/// solid_stresses (docs/theory/initial_stress.md). Throws Error where points in plane or of solids do not
/// fit.
void set_initial_stresses(const model::Model& model, domain::Domain& domain);

}  // namespace crumple::elements
