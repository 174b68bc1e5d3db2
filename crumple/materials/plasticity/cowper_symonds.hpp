// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/plane_stress.hpp"
#include "materials/plasticity/yield_point.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Effective strain increment if the material keeps its volume (zz = -xx - yy): sqrt(2/3 e : e). Under
/// uniaxial tension of an incompressible material it is the axial one.
template <class Pack>
CRUMPLE_INLINE Pack effective_strain(const PlaneStrain<Pack>& strain) {
  using Real = RealOf<Pack>;
  Pack shears = strain.zx * strain.zx;
  shears = multiply_add(strain.yz, strain.yz, shears);
  shears = multiply_add(strain.xy, strain.xy, shears);
  Pack direct = strain.xx * strain.yy;
  direct = multiply_add(strain.yy, strain.yy, direct);
  direct = multiply_add(strain.xx, strain.xx, direct);
  return square_root(multiply_add(Pack(Real(4.0 / 3.0)), direct, Pack(Pack(Real(1.0 / 3.0)) * shears)));
}

/// Factor on the yield stress, 1 + (rate / C)^(1/p) (Cowper & Symonds 1957). Viscoplastic: the rate is that
/// of the effective plastic strain, which the return solves for. Else it is the total effective strain rate
/// of the step, and the factor constant in the return: vibrations of the mesh then raise the yield stress,
/// and are fed by it (docs/theory/plane_stress_plasticity.md).
template <class Real>
struct CowperSymonds {
  Real per_rate = 0;  ///< 1 / (C dt); 0 switches the effect off
  Real exponent = 1;  ///< 1 / p
  bool viscoplastic = false;
  Real base = 0;  ///< stress that the rate term multiplies if viscoplastic; 0: the yield stress at rest

  CRUMPLE_INLINE CowperSymonds(double rate, double p, Real step, bool by_plastic_strain = false,
                               double base_stress = 0) {
    if (rate <= 0 || !(step > 0)) return;
    per_rate = static_cast<Real>(1 / (rate * static_cast<double>(step)));
    exponent = static_cast<Real>(1 / p);
    viscoplastic = by_plastic_strain;
    base = static_cast<Real>(base_stress);
  }

  /// Of PlaneStrain or SolidStrain.
  template <template <class> class Strain, class Pack>
  CRUMPLE_INLINE Pack factor(const Strain<Pack>& strain) const {
    const Pack one(Real(1));
    if (per_rate == 0 || viscoplastic) return one;
    return one + math::power(Pack(Pack(per_rate) * effective_strain(strain)), Pack(exponent));
  }

  /// The yield stress that a plastic strain increment within the step raises, and its slope over that
  /// increment. Only if viscoplastic.
  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> raised(const YieldPoint<Pack>& rest, const Pack& increment) const {
    const Pack term = math::power(Pack(Pack(per_rate) * increment), Pack(exponent));
    const Pack term_slope = Pack(exponent) * term / larger(increment, Pack(tiny_strain<Real>));
    if (base > 0)
      return {multiply_add(Pack(base), term, rest.stress), multiply_add(Pack(base), term_slope, rest.slope)};
    return {multiply_add(rest.stress, term, rest.stress),
            multiply_add(rest.stress, term_slope, multiply_add(rest.slope, term, rest.slope))};
  }
};

}  // namespace crumple::materials
