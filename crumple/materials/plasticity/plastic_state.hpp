// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/element_block.hpp"

namespace crumple::materials {

/// Adds the effective plastic strain of all points, "plastic_strain", and what its rounding has left over,
/// "plastic_strain_rest": the sum of both does not lose increments that are small beside it.
void declare_plastic_strain(domain::ElementBlock& block);

}  // namespace crumple::materials
