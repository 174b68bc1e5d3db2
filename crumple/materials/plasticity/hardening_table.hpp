// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model/material.hpp"

namespace crumple::materials {

/// Appends the rows of a PointTable of `value` over `abscissa`, which have the same length: abscissa, value
/// and slope to the next row. Beyond the last point the last slope goes on, or the curve is constant.
void append_table(const std::vector<double>& abscissa, const std::vector<double>& value, bool goes_on,
                  std::vector<double>& numbers);

/// True if each value is larger than the one before.
bool ascending(const std::vector<double>& values);

/// Throws Error, naming the material, unless the yield stresses over the plastic strain [stress; -] start at
/// zero strain, ascend in the strain, are above zero, and nowhere fall more steeply than a quarter of Young's
/// modulus [stress].
void require_hardening_table(const model::Material& material, double youngs_modulus,
                             const std::vector<double>& strain, const std::vector<double>& stress);

}  // namespace crumple::materials
