// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "domain/domain.hpp"
#include "elements/solid_patterns.hpp"

namespace crumple::elements {

/// Coefficients of the patterns of eight vectors, one element at a time.
SolidPatterns<double> patterns_of(const std::array<math::Vec3, 8>& node);

struct SolidSize {
  double volume = 0;  ///< [length^3]
  double length = 0;  ///< volume over the largest face: what a wave must cross in one step [length]
};

/// Of the present positions of an element's nodes. `exact_volume` as in solid_geometry().
SolidSize solid_size(const domain::Domain& domain, const std::array<Index, 8>& node, bool exact_volume);

}  // namespace crumple::elements
