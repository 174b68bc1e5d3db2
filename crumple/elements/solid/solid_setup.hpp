// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "domain/domain.hpp"
#include "elements/solid/solid_patterns.hpp"
#include "elements/solid/solid_task.hpp"

namespace crumple::elements {

/// Patterns of eight vectors, one element at a time.
SolidPatterns<double> patterns_of(const std::array<math::Vec3, 8>& node);

struct SolidSize {
  double volume = 0;  ///< [length^3]; not above zero if the element is inside out at one of its points
  double length = 0;  ///< what a wave must cross in one step [length]
};

/// Of the present positions of an element's nodes, as its formulation sees it. The numbers
/// are those of its block.
SolidSize solid_size(const domain::Domain& domain, const domain::SolidBlock& block, Index place,
                     const SolidConstants<double>& constants);

}  // namespace crumple::elements
