// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"
#include "base/pack.hpp"

namespace crumple::materials {

/// Stresses of a shell point in lamina axes; zz is zero [stress].
template <class Pack>
struct PlaneStress {
  Pack xx, yy, xy, yz, zx;
};

/// Strain increments of a shell point in lamina axes; the shears are engineering strains.
template <class Pack>
struct PlaneStrain {
  Pack xx, yy, xy, yz, zx;
};

/// Five numbers at rows of `stride` numbers each.
template <class Five>
CRUMPLE_INLINE Five load_five(const RealOf<decltype(Five::xx)>* from, Index stride) {
  using Pack = decltype(Five::xx);
  return {load<Pack>(from), load<Pack>(from + stride), load<Pack>(from + 2 * stride),
          load<Pack>(from + 3 * stride), load<Pack>(from + 4 * stride)};
}

template <class Five>
CRUMPLE_INLINE void store_five(RealOf<decltype(Five::xx)>* to, Index stride, const Five& value) {
  store(to, value.xx);
  store(to + stride, value.yy);
  store(to + 2 * stride, value.xy);
  store(to + 3 * stride, value.yz);
  store(to + 4 * stride, value.zx);
}

template <class Pack>
CRUMPLE_INLINE PlaneStress<Pack> scaled(const PlaneStress<Pack>& stress, const Pack& factor) {
  return {factor * stress.xx, factor * stress.yy, factor * stress.xy, factor * stress.yz, factor * stress.zx};
}

/// Half of a stress times a strain increment [energy/volume].
template <class Pack>
CRUMPLE_INLINE Pack half_work(const PlaneStress<Pack>& stress, const PlaneStrain<Pack>& strain) {
  Pack whole = stress.zx * strain.zx;
  whole = multiply_add(stress.yz, strain.yz, whole);
  whole = multiply_add(stress.xy, strain.xy, whole);
  whole = multiply_add(stress.yy, strain.yy, whole);
  whole = multiply_add(stress.xx, strain.xx, whole);
  return RealOf<Pack>(0.5) * whole;
}

/// Work density of the mean of two stresses on a strain increment [energy/volume].
template <class Pack>
CRUMPLE_INLINE Pack mean_work(const PlaneStress<Pack>& a, const PlaneStress<Pack>& b,
                              const PlaneStrain<Pack>& strain) {
  return half_work(PlaneStress<Pack>{a.xx + b.xx, a.yy + b.yy, a.xy + b.xy, a.yz + b.yz, a.zx + b.zx},
                   strain);
}

/// A third of the trace [stress]; positive in tension.
template <class Pack>
CRUMPLE_INLINE Pack mean_stress(const PlaneStress<Pack>& stress) {
  return Pack(RealOf<Pack>(1.0 / 3.0)) * (stress.xx + stress.yy);
}

/// Square of von Mises' stress.
template <class Pack>
CRUMPLE_INLINE Pack equivalent_square(const PlaneStress<Pack>& stress) {
  Pack square = stress.xx * stress.xx - stress.xx * stress.yy;
  square = multiply_add(stress.yy, stress.yy, square);
  Pack shears = stress.xy * stress.xy;
  shears = multiply_add(stress.yz, stress.yz, shears);
  shears = multiply_add(stress.zx, stress.zx, shears);
  return multiply_add(Pack(RealOf<Pack>(3)), shears, square);
}

/// Hooke's law with zero stress zz (docs/theory/elastic.md).
template <class Real>
struct PlaneStressElasticity {
  Real direct;   ///< E / (1 - nu^2)
  Real cross;    ///< nu E / (1 - nu^2)
  Real shear;    ///< G
  Real lateral;  ///< nu / E

  CRUMPLE_INLINE PlaneStressElasticity(double youngs_modulus, double poissons_ratio)
      : direct(static_cast<Real>(youngs_modulus / (1 - poissons_ratio * poissons_ratio))),
        cross(static_cast<Real>(poissons_ratio * youngs_modulus / (1 - poissons_ratio * poissons_ratio))),
        shear(static_cast<Real>(0.5 * youngs_modulus / (1 + poissons_ratio))),
        lateral(static_cast<Real>(poissons_ratio / youngs_modulus)) {}

  template <class Pack>
  CRUMPLE_INLINE PlaneStress<Pack> stress(const PlaneStress<Pack>& old,
                                          const PlaneStrain<Pack>& strain) const {
    const Pack d(direct);
    const Pack c(cross);
    const Pack g(shear);
    return {multiply_add(d, strain.xx, multiply_add(c, strain.yy, old.xx)),
            multiply_add(d, strain.yy, multiply_add(c, strain.xx, old.yy)),
            multiply_add(g, strain.xy, old.xy), multiply_add(g, strain.yz, old.yz),
            multiply_add(g, strain.zx, old.zx)};
  }
};

}  // namespace crumple::materials
