// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"
#include "base/pack.hpp"

namespace crumple::materials {

/// Stresses of a point of a solid in global axes [stress].
template <class Pack>
struct SolidStress {
  Pack xx, yy, zz, xy, yz, zx;
};

/// Strain increments of a point of a solid in global axes; the shears are engineering strains.
template <class Pack>
struct SolidStrain {
  Pack xx, yy, zz, xy, yz, zx;
};

/// Six numbers at rows of `stride` numbers each.
template <class Six>
CRUMPLE_INLINE Six load_six(const RealOf<decltype(Six::xx)>* from, Index stride) {
  using Pack = decltype(Six::xx);
  return {load<Pack>(from),
          load<Pack>(from + stride),
          load<Pack>(from + 2 * stride),
          load<Pack>(from + 3 * stride),
          load<Pack>(from + 4 * stride),
          load<Pack>(from + 5 * stride)};
}

template <class Six>
CRUMPLE_INLINE void store_six(RealOf<decltype(Six::xx)>* to, Index stride, const Six& value) {
  store(to, value.xx);
  store(to + stride, value.yy);
  store(to + 2 * stride, value.zz);
  store(to + 3 * stride, value.xy);
  store(to + 4 * stride, value.yz);
  store(to + 5 * stride, value.zx);
}

template <class Pack>
CRUMPLE_INLINE SolidStress<Pack> scaled(const SolidStress<Pack>& stress, const Pack& factor) {
  return {factor * stress.xx, factor * stress.yy, factor * stress.zz,
          factor * stress.xy, factor * stress.yz, factor * stress.zx};
}

/// Work density of the mean of two stresses on a strain increment [energy/volume].
template <class Pack>
CRUMPLE_INLINE Pack mean_work(const SolidStress<Pack>& a, const SolidStress<Pack>& b,
                              const SolidStrain<Pack>& strain) {
  Pack whole = (a.zx + b.zx) * strain.zx;
  whole = multiply_add(Pack(a.yz + b.yz), strain.yz, whole);
  whole = multiply_add(Pack(a.xy + b.xy), strain.xy, whole);
  whole = multiply_add(Pack(a.zz + b.zz), strain.zz, whole);
  whole = multiply_add(Pack(a.yy + b.yy), strain.yy, whole);
  whole = multiply_add(Pack(a.xx + b.xx), strain.xx, whole);
  return RealOf<Pack>(0.5) * whole;
}

/// A third of the trace [stress]; positive in tension.
template <class Pack>
CRUMPLE_INLINE Pack mean_stress(const SolidStress<Pack>& stress) {
  return Pack(RealOf<Pack>(1.0 / 3.0)) * (stress.xx + (stress.yy + stress.zz));
}

/// Square of von Mises' stress, 3/2 of the deviator's squares. From differences: a pressure adds nothing, not
/// even its rounding.
template <class Pack>
CRUMPLE_INLINE Pack equivalent_square(const SolidStress<Pack>& stress) {
  using Real = RealOf<Pack>;
  const Pack x = stress.xx - stress.yy;
  const Pack y = stress.yy - stress.zz;
  const Pack z = stress.zz - stress.xx;
  Pack shears = stress.zx * stress.zx;
  shears = multiply_add(stress.yz, stress.yz, shears);
  shears = multiply_add(stress.xy, stress.xy, shears);
  Pack direct = z * z;
  direct = multiply_add(y, y, direct);
  direct = multiply_add(x, x, direct);
  return multiply_add(Pack(Real(3)), shears, Pack(Pack(Real(0.5)) * direct));
}

/// Effective increment of the deviatoric strain, sqrt(2/3 e' : e').
template <class Pack>
CRUMPLE_INLINE Pack effective_strain(const SolidStrain<Pack>& strain) {
  using Real = RealOf<Pack>;
  const Pack x = strain.xx - strain.yy;
  const Pack y = strain.yy - strain.zz;
  const Pack z = strain.zz - strain.xx;
  Pack shears = strain.zx * strain.zx;
  shears = multiply_add(strain.yz, strain.yz, shears);
  shears = multiply_add(strain.xy, strain.xy, shears);
  Pack direct = z * z;
  direct = multiply_add(y, y, direct);
  direct = multiply_add(x, x, direct);
  return square_root(multiply_add(Pack(Real(2.0 / 9.0)), direct, Pack(Pack(Real(1.0 / 3.0)) * shears)));
}

/// A rotation less the unit matrix, row by row: of a rotation by little, float keeps that to full precision,
/// whereas the diagonal of the rotation itself would round its cosines.
template <class Pack>
struct Turn {
  Pack xx, xy, xz, yx, yy, yz, zx, zy, zz;
};

/// Nine rows of `stride` numbers each.
template <class Pack>
CRUMPLE_INLINE Turn<Pack> load_turn(const RealOf<Pack>* from, Index stride) {
  const auto row = [&](Index k) { return load<Pack>(from + k * stride); };
  return {row(0), row(1), row(2), row(3), row(4), row(5), row(6), row(7), row(8)};
}

/// Half of a rotation, less the unit matrix.
template <class Pack>
CRUMPLE_INLINE Turn<Pack> half_of(const Turn<Pack>& turn) {
  using Real = RealOf<Pack>;
  const Pack one(Real(1));
  // With the angle w: the trace is 2 cos w - 2, the skew part has sin w; c = cos(w / 2).
  const Pack trace = turn.xx + (turn.yy + turn.zz);
  const Pack c = square_root(larger(multiply_add(Pack(Real(0.25)), trace, one), Pack(Real(1e-12))));
  // Axial vector of the skew part, sin(w / 2) long, and what makes the square of it the rest.
  const Pack over = Pack(Real(0.25)) / c;
  const Pack x = over * (turn.zy - turn.yz);
  const Pack y = over * (turn.xz - turn.zx);
  const Pack z = over * (turn.yx - turn.xy);
  const Pack share = one / (one + c);
  const Pack sx = share * x;
  const Pack sy = share * y;
  const Pack sz = share * z;
  const Pack xy = sx * y;
  const Pack yz = sy * z;
  const Pack zx = sz * x;
  return {-multiply_add(sy, y, Pack(sz * z)), xy - z, zx + y, xy + z,
          -multiply_add(sz, z, Pack(sx * x)), yz - x, zx - y, yz + x,
          -multiply_add(sx, x, Pack(sy * y))};
}

/// R s R^T - s with R = I + D, as D s + (D s)^T + D s D^T.
template <class Pack>
CRUMPLE_INLINE SolidStress<Pack> turn_change(const SolidStress<Pack>& s, const Turn<Pack>& d) {
  const auto dot = [](const Pack& a, const Pack& b, const Pack& c, const Pack& x, const Pack& y,
                      const Pack& z) { return multiply_add(a, x, multiply_add(b, y, Pack(c * z))); };
  // t = D s
  const Pack txx = dot(d.xx, d.xy, d.xz, s.xx, s.xy, s.zx);
  const Pack txy = dot(d.xx, d.xy, d.xz, s.xy, s.yy, s.yz);
  const Pack txz = dot(d.xx, d.xy, d.xz, s.zx, s.yz, s.zz);
  const Pack tyx = dot(d.yx, d.yy, d.yz, s.xx, s.xy, s.zx);
  const Pack tyy = dot(d.yx, d.yy, d.yz, s.xy, s.yy, s.yz);
  const Pack tyz = dot(d.yx, d.yy, d.yz, s.zx, s.yz, s.zz);
  const Pack tzx = dot(d.zx, d.zy, d.zz, s.xx, s.xy, s.zx);
  const Pack tzy = dot(d.zx, d.zy, d.zz, s.xy, s.yy, s.yz);
  const Pack tzz = dot(d.zx, d.zy, d.zz, s.zx, s.yz, s.zz);
  return {
      txx + (txx + dot(txx, txy, txz, d.xx, d.xy, d.xz)), tyy + (tyy + dot(tyx, tyy, tyz, d.yx, d.yy, d.yz)),
      tzz + (tzz + dot(tzx, tzy, tzz, d.zx, d.zy, d.zz)), txy + (tyx + dot(txx, txy, txz, d.yx, d.yy, d.yz)),
      tyz + (tzy + dot(tyx, tyy, tyz, d.zx, d.zy, d.zz)), tzx + (txz + dot(tzx, tzy, tzz, d.xx, d.xy, d.xz))};
}

/// R s R^T with R = I + D.
template <class Pack>
CRUMPLE_INLINE SolidStress<Pack> turned(const SolidStress<Pack>& s, const Turn<Pack>& d) {
  const SolidStress<Pack> change = turn_change(s, d);
  return {s.xx + change.xx, s.yy + change.yy, s.zz + change.zz,
          s.xy + change.xy, s.yz + change.yz, s.zx + change.zx};
}

/// Strain increment of the middle of a step, turned on by the half of its rotation that is still to come:
/// what is added to stresses that have all of it. Hughes & Winget (1980) add the increment as it is. The
/// difference is of second order, but then a step back does not undo a step, and bodies that vibrate win
/// energy (docs/theory/time_integration.md).
template <class Pack>
CRUMPLE_INLINE SolidStrain<Pack> turned_on(const SolidStrain<Pack>& e, const Turn<Pack>& turn) {
  const Pack half(RealOf<Pack>(0.5));
  const Pack two(RealOf<Pack>(2));
  const SolidStress<Pack> tensor{e.xx, e.yy, e.zz, half * e.xy, half * e.yz, half * e.zx};
  const SolidStress<Pack> on = turned(tensor, half_of(turn));
  return {on.xx, on.yy, on.zz, two * on.xy, two * on.yz, two * on.zx};
}

/// Hooke's law in three dimensions (docs/theory/elastic.md).
template <class Real>
struct SolidElasticity {
  Real lame;       ///< nu E / ((1 + nu) (1 - 2 nu))
  Real two_shear;  ///< 2 G
  Real shear;      ///< G

  CRUMPLE_INLINE SolidElasticity(double youngs_modulus, double poissons_ratio)
      : lame(static_cast<Real>(poissons_ratio * youngs_modulus /
                               ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)))),
        two_shear(static_cast<Real>(youngs_modulus / (1 + poissons_ratio))),
        shear(static_cast<Real>(0.5 * youngs_modulus / (1 + poissons_ratio))) {}

  /// Leaves the mean stress what it was: an equation of state gives it.
  CRUMPLE_INLINE void drop_pressure() { lame = Real(-1.0 / 3.0) * two_shear; }

  template <class Pack>
  CRUMPLE_INLINE SolidStress<Pack> stress(const SolidStress<Pack>& old,
                                          const SolidStrain<Pack>& strain) const {
    const Pack spherical = Pack(lame) * (strain.xx + (strain.yy + strain.zz));
    const Pack g2(two_shear);
    const Pack g(shear);
    return {old.xx + multiply_add(g2, strain.xx, spherical),
            old.yy + multiply_add(g2, strain.yy, spherical),
            old.zz + multiply_add(g2, strain.zz, spherical),
            multiply_add(g, strain.xy, old.xy),
            multiply_add(g, strain.yz, old.yz),
            multiply_add(g, strain.zx, old.zx)};
  }
};

}  // namespace crumple::materials
