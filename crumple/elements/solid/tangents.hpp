// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/solid/solid_formulation.hpp"

// Tangents of the map of an element, or of a field on it, at a point.
namespace crumple::elements {

/// Three vectors: tangents, sides of a tetrahedron, their rates, or the vector areas across them.
template <class Pack>
struct ThreeVectors {
  math::PackVec3<Pack> of[3];
};

/// Vector areas across the tangents: over the Jacobian (of a tetrahedron's sides: six volumes) the gradients
/// of the coordinates along them.
template <class Pack>
CRUMPLE_INLINE ThreeVectors<Pack> areas_across(const ThreeVectors<Pack>& tangent) {
  return {{math::cross(tangent.of[1], tangent.of[2]), math::cross(tangent.of[2], tangent.of[0]),
           math::cross(tangent.of[0], tangent.of[1])}};
}

/// Gradient of a field from its derivatives along the tangents and the areas across these, `share` one over
/// the Jacobian: row i holds the derivatives of component i.
template <class Pack>
CRUMPLE_INLINE PackMatrix<Pack> gradient_of(const ThreeVectors<Pack>& rate, const ThreeVectors<Pack>& area,
                                            const Pack& share) {
  using Vec = math::PackVec3<Pack>;
  const auto row = [&](auto component) {
    Vec sum = component(rate.of[0]) * area.of[0];
    for (int s = 1; s < 3; ++s) sum = math::multiply_add(component(rate.of[s]), area.of[s], sum);
    return share * sum;
  };
  return {row([](const Vec& u) { return u.x; }), row([](const Vec& u) { return u.y; }),
          row([](const Vec& u) { return u.z; })};
}

}  // namespace crumple::elements
