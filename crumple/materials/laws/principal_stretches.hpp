// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/laws/total_deformation.hpp"
#include "materials/plasticity/principal.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Principal axes of F F^T, and in each the square of the stretch less 1, in which nothing cancels at rest.
template <class Pack>
struct PrincipalStretches {
  Principal<Pack> of;
  Pack volume_excess;  ///< det F - 1

  CRUMPLE_INLINE Pack square_excess(int k) const { return of.value[k]; }
  /// The square, kept above zero: round-off of a flattened element may go below.
  CRUMPLE_INLINE Pack square(int k) const {
    using Real = RealOf<Pack>;
    return larger(Pack(Pack(Real(1)) + of.value[k]), Pack(Real(1e-12)));
  }
};

/// Of the deformation gradient I + D.
template <class Pack>
CRUMPLE_INLINE PrincipalStretches<Pack> principal_stretches(const Turn<Pack>& d) {
  return {principal(left_cauchy_green(d)), volume_excess(d)};
}

/// Stress of a strain energy U(stretches without their volume) + K/2 (J - 1)^2, along the principal axes k:
/// J sigma_k = dev_k + K J (J - 1), where dev_k are the derivatives of U by the logarithmic strains less
/// their mean; and the wave speed, rho_0 c^2 = largest of curvature_k - dev_k + K J^2, where curvature_k is
/// the second derivative of U along the isochoric part of a stretch in axis k.
template <class Pack>
CRUMPLE_INLINE TotalStress<Pack> isochoric_stress(const PrincipalStretches<Pack>& stretches,
                                                  const Pack (&dev)[3], const Pack (&curvature)[3],
                                                  RealOf<Pack> bulk, RealOf<Pack> per_density) {
  using Real = RealOf<Pack>;
  const Pack volume = Pack(Real(1)) + stretches.volume_excess;
  const Pack over = Pack(Real(1)) / volume;
  const Pack spherical = Pack(bulk) * stretches.volume_excess;
  const Pack volumetric = Pack(bulk) * (volume * volume);
  Pack value[3];
  // Softening of the rest must not take the speed away.
  Pack stiffness = Pack(Real(0.5)) * volumetric;
  for (int k = 0; k < 3; ++k) {
    value[k] = multiply_add(over, dev[k], spherical);
    stiffness = larger(stiffness, Pack((curvature[k] - dev[k]) + volumetric));
  }
  return {in_axes(stretches.of, value), Pack(Pack(per_density) * stiffness)};
}

}  // namespace crumple::materials
