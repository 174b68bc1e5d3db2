// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// Rates of the modes' forces, all sums over the nodes, by assumed strains (Belytschko & Bindeman, CMAME 105
/// (1993) 225-260): the energy of the elastic law in the strains of the modes, without the shear of those
/// that bend, and with the lateral strains of plane stress. `rate` and the result are in the element's axes;
/// the element counts as a box of half sides a, b, c.
template <class Pack>
CRUMPLE_INLINE HourglassVectors<Pack> assumed_strain_rates(const SolidConstants<RealOf<Pack>>& constants,
                                                           const Pack& a, const Pack& b, const Pack& c,
                                                           const HourglassVectors<Pack>& rate) {
  using Real = RealOf<Pack>;
  const Pack m = Pack(constants.hourglass * Real(1.0 / 24));  // QM mu, 8/3 of every H, 1/64 for the sums
  const Pack hxx = b * c / a;
  const Pack hyy = c * a / b;
  const Pack hzz = a * b / c;
  const Pack twice(Real(2));
  const auto& [q1, q2, q3, q4] = rate.of;
  HourglassVectors<Pack> f;
  const Pack plane(constants.plane_stress);
  const Pack across(constants.anticlastic);
  // The mode named after the other two directions shears, as the other two such modes do.
  const auto shear = [&](const Pack& sum, const Pack& own, const Pack& h, const Pack& first, const Pack& k,
                         const Pack& second) {
    return m * multiply_add(sum, own, multiply_add(h, first, Pack(k * second)));
  };
  f.of[0].x = shear(hyy + hzz, q1.x, c, q2.y, b, q3.z);
  f.of[1].y = shear(hzz + hxx, q2.y, c, q1.x, a, q3.z);
  f.of[2].z = shear(hxx + hyy, q3.z, b, q1.x, a, q2.y);
  // Those that bend, in pairs that stretch the same layer.
  const auto bend = [&](const Pack& h, const Pack& own, const Pack& pair, const Pack& other) {
    return twice * m * multiply_add(Pack(plane * h), own, Pack(Pack(across * pair) * other));
  };
  f.of[1].x = bend(hxx, q2.x, c, q1.y);
  f.of[0].y = bend(hyy, q1.y, c, q2.x);
  f.of[2].x = bend(hxx, q3.x, b, q1.z);
  f.of[0].z = bend(hzz, q1.z, b, q3.x);
  f.of[2].y = bend(hyy, q3.y, a, q2.z);
  f.of[1].z = bend(hzz, q2.z, a, q3.y);
  const Pack warp = twice * m * Pack(constants.uniaxial);
  f.of[3] = {warp * hxx * q4.x, warp * hyy * q4.y, warp * hzz * q4.z};
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
    const Pack stiffness = modulus * step;
    for (int mode = 0; mode < 4; ++mode) {
      const Vec rate = rate_of(mode);
      const Vec before = old_force(mode);
      const Vec old = before + turned * before;
      keep_hourglass(place, mode, old, rate, math::multiply_add(stiffness, rate, old), found);
    }
  }
  found.work = step * found.work;
  return found;
}

/// Form 6. The forces are kept in the element's axes, in which the rates have been left.
template <class Pack>
CRUMPLE_INLINE HourglassForces<Pack> assumed_strain_forces(const SolidPlace<RealOf<Pack>>& place,
                                                           int row_rates, const Pack& active,
                                                           const SolidPatterns<Pack>& x) {
  using Vec = math::PackVec3<Pack>;
  const Pack step = active * Pack(place.task.step);
  const PackMatrix<Pack> axes = side_axes(x);
  const auto half_side = [&](const Vec& axis, int p) {
    return Pack(RealOf<Pack>(0.125)) * math::dot(axis, x.of[p]);
  };
  HourglassVectors<Pack> rate;
  for (int mode = 0; mode < 4; ++mode) rate.of[mode] = kept_vector<Pack>(place, row_rates + 3 * mode);
  const HourglassVectors<Pack> change =
      assumed_strain_rates(place.task.constants, half_side(axes.x, pattern::xi),
                           half_side(axes.y, pattern::eta), half_side(axes.z, pattern::zeta), rate);
  HourglassForces<Pack> found;
  found.work = Pack(RealOf<Pack>(0));
  for (int mode = 0; mode < 4; ++mode) {
    const Vec old = own_vector<Pack>(place, solid_state::own + 3 * mode);
    keep_hourglass(place, mode, old, rate.of[mode], math::multiply_add(step, change.of[mode], old), found);
    found.of[mode] = in_global_axes(axes, found.of[mode]);
  }
  found.work = Pack(place.task.step) * found.work;
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
