// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/node_fields.hpp"
#include "model/mesh.hpp"

namespace crumple::domain {

/// From the first node of the deck to the next that is not the same, at present positions.
Vec3 first_side(const NodeFields& nodes, const model::ShellElement& shell);

}  // namespace crumple::domain
