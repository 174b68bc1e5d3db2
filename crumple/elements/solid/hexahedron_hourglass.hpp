// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "elements/solid/solid_formulation.hpp"
#include "elements/solid/solid_geometry.hpp"
#include "elements/solid/solid_resistance.hpp"

// Hourglass control of the one-point hexahedron: docs/theory/one_point_hexahedron.md.
namespace crumple::elements {

/// One vector for each of the four modes: rates, or the forces conjugate to them.
template <class Pack>
struct HourglassVectors {
  math::PackVec3<Pack> of[4];
};

/// Axes of the element for assumed strains, unit vectors: the first along xi at the centre, the third across
/// xi and eta.
template <class Pack>
CRUMPLE_INLINE PackMatrix<Pack> side_axes(const SolidPatterns<Pack>& x) {
  const Pack one(RealOf<Pack>(1));
  const auto unit = [&](const math::PackVec3<Pack>& v) {
    return Pack(one / square_root(math::dot(v, v))) * v;
  };
  PackMatrix<Pack> axes;
  axes.x = unit(x.of[pattern::xi]);
  axes.z = unit(math::cross(x.of[pattern::xi], x.of[pattern::eta]));
  axes.y = math::cross(axes.z, axes.x);
  return axes;
}
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> in_global_axes(const PackMatrix<Pack>& axes,
                                                   const math::PackVec3<Pack>& v) {
  return math::multiply_add(v.x, axes.x, math::multiply_add(v.y, axes.y, v.z * axes.z));
}

// Assumed strains (Belytschko & Bindeman, CMAME 105 (1993) 225-260): the energy of the elastic law in the
// strains of the modes, without the shear of those that bend, and with the lateral strains of plane stress.
// That energy is a sum of twelve squares, s^2 / 2, with ds = L dq and the forces Q = L' s; L goes with the
// shape of the element. Kept are the s [energy^1/2]: whatever becomes of the shape, what is stored is never
// negative, only work changes it, and a way back to the shape of the start gives it back. Forces that were
// kept and increased by L'L dq would give back more or less than they took.

/// What L is made of: sqrt(QM mu V0 / 192) over the half sides of the element, as a box, V0 its volume at the
/// start, for modes that are sums over the nodes [energy^1/2 / length].
template <class Pack>
struct AssumedStrainModuli {
  Pack xx, yy, zz;

  CRUMPLE_INLINE AssumedStrainModuli(const SolidPlace<RealOf<Pack>>& place, const PackMatrix<Pack>& axes,
                                     const SolidPatterns<Pack>& x) {
    using Real = RealOf<Pack>;
    // 8/3 of every product of half sides, an eighth of the volume each, and 1/64 for the sums.
    const SolidConstants<Real>& constants = place.task.constants;
    Pack root = square_root(Pack(constants.hourglass * Real(1.0 / 192)) *
                            own_item<Pack>(place, solid_state::reference_volume));
    // The step follows the wave speed where that varies, and so must what limits it. hourglass_share() serves
    // forces() alone, and may exceed 1; here strains() needs the speed of the last step.
    if (constants.present_wave_speed > 0) {
      const Pack speed = load<Pack>(place.state + constants.present_wave_speed * lanes);
      root = smaller(Pack(Real(1)), Pack(speed * Pack(Real(1) / constants.wave_speed))) * root;
    }
    const auto side = [&](const math::PackVec3<Pack>& axis, int p) {
      return larger(Pack(Pack(Real(0.125)) * math::dot(axis, x.of[p])), Pack(Real(0)));
    };
    const Pack a = side(axes.x, pattern::xi);
    const Pack b = side(axes.y, pattern::eta);
    const Pack c = side(axes.z, pattern::zeta);
    // Bounds the modulus of an element that is crushed flat.
    const Pack least =
        multiply_add(Pack(Real(1e-3)), Pack(a + b + c), Pack(std::numeric_limits<Real>::min()));
    xx = root / larger(a, least);
    yy = root / larger(b, least);
    zz = root / larger(c, least);
  }
};

/// Rates of the s from those of the modes, which are sums over the nodes in the element's axes.
template <class Pack>
CRUMPLE_INLINE HourglassVectors<Pack> assumed_strain_rates(const SolidConstants<RealOf<Pack>>& constants,
                                                           const AssumedStrainModuli<Pack>& h,
                                                           const HourglassVectors<Pack>& rate) {
  const auto& [q1, q2, q3, q4] = rate.of;
  HourglassVectors<Pack> s;
  // The mode named after the other two directions shears, as the other two such modes do.
  s.of[0].x = multiply_add(h.yy, q1.x, Pack(h.xx * q2.y));
  s.of[1].y = multiply_add(h.zz, q1.x, Pack(h.xx * q3.z));
  s.of[2].z = multiply_add(h.zz, q2.y, Pack(h.yy * q3.z));
  // Those that bend, in pairs that stretch the same layer, as sum and difference.
  const Pack together(constants.bend_together);
  const auto bend = [&](Pack& sum, Pack& difference, const Pack& first, const Pack& second) {
    sum = together * (first + second);
    difference = first - second;
  };
  bend(s.of[1].x, s.of[0].y, Pack(h.xx * q2.x), Pack(h.yy * q1.y));
  bend(s.of[2].x, s.of[0].z, Pack(h.xx * q3.x), Pack(h.zz * q1.z));
  bend(s.of[2].y, s.of[1].z, Pack(h.yy * q3.y), Pack(h.zz * q2.z));
  const Pack warp(constants.warp);
  s.of[3] = {warp * h.xx * q4.x, warp * h.yy * q4.y, warp * h.zz * q4.z};
  return s;
}

/// The modes' forces from the s: the transposed of assumed_strain_rates().
template <class Pack>
CRUMPLE_INLINE HourglassVectors<Pack> assumed_strain_stress(const SolidConstants<RealOf<Pack>>& constants,
                                                            const AssumedStrainModuli<Pack>& h,
                                                            const HourglassVectors<Pack>& s) {
  HourglassVectors<Pack> f;
  f.of[0].x = multiply_add(h.yy, s.of[0].x, Pack(h.zz * s.of[1].y));
  f.of[1].y = multiply_add(h.xx, s.of[0].x, Pack(h.zz * s.of[2].z));
  f.of[2].z = multiply_add(h.xx, s.of[1].y, Pack(h.yy * s.of[2].z));
  const Pack together(constants.bend_together);
  const auto bend = [&](Pack& first, Pack& second, const Pack& sum, const Pack& difference, const Pack& along,
                        const Pack& across) {
    const Pack mean = together * sum;
    first = along * (mean + difference);
    second = across * (mean - difference);
  };
  bend(f.of[1].x, f.of[0].y, s.of[1].x, s.of[0].y, h.xx, h.yy);
  bend(f.of[2].x, f.of[0].z, s.of[2].x, s.of[0].z, h.xx, h.zz);
  bend(f.of[2].y, f.of[1].z, s.of[2].y, s.of[1].z, h.yy, h.zz);
  const Pack warp(constants.warp);
  f.of[3] = {warp * h.xx * s.of[3].x, warp * h.yy * s.of[3].y, warp * h.zz * s.of[3].z};
  return f;
}

/// Generalised hourglass forces from those of the last step and the rates between, and their work.
template <class Pack>
struct HourglassForces : HourglassVectors<Pack> {
  Pack work;
};

/// Keeps the new forces, whose old ones and rates are in the same axes, and adds up their work.
template <class Pack>
CRUMPLE_INLINE void keep_hourglass(const SolidPlace<RealOf<Pack>>& place, int mode,
                                   const math::PackVec3<Pack>& old, const math::PackVec3<Pack>& rate,
                                   math::PackVec3<Pack> now, HourglassForces<Pack>& found) {
  // What has failed does not hold its last force.
  if (place.task.constants.can_fail) now = own_item<Pack>(place, solid_state::active) * now;
  set_own_vector(place, solid_state::own + 3 * mode, now);
  found.of[mode] = now;
  found.work = multiply_add(Pack(RealOf<Pack>(0.5)), math::dot(old + now, rate), found.work);
}

/// Forms 1 to 5. Force per rate (viscous) or per displacement (stiffness): `modulus`.
template <class Pack>
CRUMPLE_INLINE HourglassForces<Pack> hourglass_forces(const SolidPlace<RealOf<Pack>>& place, int row_rates,
                                                      const Pack& modulus) {
  using Vec = math::PackVec3<Pack>;
  const Pack step(place.task.step);
  HourglassForces<Pack> found;
  found.work = Pack(RealOf<Pack>(0));
  const auto old_force = [&](int mode) { return own_vector<Pack>(place, solid_state::own + 3 * mode); };
  const auto rate_of = [&](int mode) { return kept_vector<Pack>(place, row_rates + 3 * mode); };
  if (place.task.constants.viscous) {
    for (int mode = 0; mode < 4; ++mode) {
      const Vec rate = rate_of(mode);
      keep_hourglass(place, mode, old_force(mode), rate, modulus * rate, found);
    }
  } else {
    const PackMatrix<Pack> turned = left_rotation<Pack>(place, 0);
    const PackMatrix<Pack> half_turned = half_rotation(turned);
    const Pack stiffness = modulus * step;
    for (int mode = 0; mode < 4; ++mode) {
      const Vec middle = rate_of(mode);
      const Vec rate = middle + half_turned * middle;
      const Vec before = old_force(mode);
      const Vec old = before + turned * before;
      keep_hourglass(place, mode, old, rate, math::multiply_add(stiffness, rate, old), found);
    }
  }
  found.work = step * found.work;
  return found;
}

/// Form 6. Kept are the s of the assumed strains, whose rates have been left.
template <class Pack>
CRUMPLE_INLINE HourglassForces<Pack> assumed_strain_forces(const SolidPlace<RealOf<Pack>>& place,
                                                           int row_rates, const Pack& active,
                                                           const SolidPatterns<Pack>& x) {
  using Vec = math::PackVec3<Pack>;
  const Pack step = active * Pack(place.task.step);
  HourglassForces<Pack> stored;
  stored.work = Pack(RealOf<Pack>(0));
  for (int mode = 0; mode < 4; ++mode) {
    const Vec old = own_vector<Pack>(place, solid_state::own + 3 * mode);
    const Vec rate = kept_vector<Pack>(place, row_rates + 3 * mode);
    keep_hourglass(place, mode, old, rate, math::multiply_add(step, rate, old), stored);
  }
  const SolidConstants<RealOf<Pack>>& constants = place.task.constants;
  const PackMatrix<Pack> axes = side_axes(x);
  const HourglassVectors<Pack> forces = assumed_strain_stress(
      constants, AssumedStrainModuli<Pack>(place, axes, x), HourglassVectors<Pack>(stored));
  HourglassForces<Pack> found;
  for (int mode = 0; mode < 4; ++mode) found.of[mode] = in_global_axes(axes, forces.of[mode]);
  found.work = Pack(place.task.step) * stored.work;
  return found;
}

/// Force per rate (viscous) or per displacement (stiffness) of a mode's sum over the nodes. Viscous: Q rho c
/// V^(2/3) / 4 (Goudreau & Hallquist 1982); stiffness: 1/2 Q (lambda + 2 mu) B.B / V, B the derivatives of
/// the volume (Flanagan & Belytschko 1981).
template <class Pack>
CRUMPLE_INLINE Pack hourglass_modulus(const SolidConstants<RealOf<Pack>>& constants,
                                      const SolidGeometry<Pack>& g, const Resistance<Pack>& resistance) {
  const Pack factor(constants.hourglass);
  if (constants.viscous) return factor * resistance.density * (resistance.length * resistance.length);
  Pack squares = math::dot(g.gradient[0], g.gradient[0]);
  for (int p = 1; p < patterns_of_gradient(constants.exact_volume); ++p)
    squares = squares + math::dot(g.gradient[p], g.gradient[p]);
  return factor * squares * resistance.per_volume;
}

}  // namespace crumple::elements
