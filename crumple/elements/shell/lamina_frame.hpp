// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "math/pack_vec3.hpp"

namespace crumple::elements {

/// Orthonormal axes that rotate with an element.
template <class Pack>
struct LaminaFrame {
  math::PackVec3<Pack> e1, e2, e3;
  Pack normal_length;  ///< |a x b|
};

/// Axes from two vectors that span the lamina. e3 is normal to both, as Belytschko, Lin & Tsay (1984) take it
/// from the diagonals. e1 is not tied to side 1-2, which turns against the material when the element is
/// sheared; it is turned by the rotation R of the polar decomposition of the in-plane deformation gradient
/// F = J J0^-1 at the centre, J = (g1, g2), so that the stress rate is Green and Naghdi's and nothing depends
/// on which node comes first (docs/theory/belytschko_tsay.md). `first` and `second` are the two numbers that
/// J0^-1 leaves over, see reference_frame().
template <class Pack>
CRUMPLE_INLINE LaminaFrame<Pack> lamina_frame(const math::PackVec3<Pack>& g1, const math::PackVec3<Pack>& g2,
                                              const Pack& first, const Pack& second) {
  using Real = RealOf<Pack>;
  const auto normal = math::cross(g1, g2);
  const Pack length = square_root(math::dot(normal, normal));
  const auto e3 = Pack(Pack(Real(1)) / length) * normal;
  const auto f2 = math::multiply_add(first, g1, second * g2);
  const auto along = g1 + math::cross(f2, e3);
  const auto e1 = Pack(Pack(Real(1)) / square_root(math::dot(along, along))) * along;
  return {e1, math::cross(e3, e1), e3, length};
}

}  // namespace crumple::elements
