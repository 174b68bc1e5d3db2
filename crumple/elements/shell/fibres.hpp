// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Fibres of a warped shell: normals of its bilinear surface at the nodes, their rates, and the nodal forces
// that do work on them. Used by the formulations that know the warp.

#include "elements/shell/formulation.hpp"

namespace crumple::elements {

/// What the fibres y_I differ by over the diagonals, in lamina axes. At the centre they average to e3, so
/// that the nodes' are y_3,1 = e3 +- (x31, y31)/2 and y_4,2 = e3 +- (x42, y42)/2.
template <class Pack>
struct FibreTilts {
  Pack x31, y31, x42, y42;
};

/// The normals of the bilinear surface, scaled to the component 1 along e3; the taper is left out, so that a
/// re-entrant corner or a triangle has fibres like any other element. An element warped and thick beyond
/// reason would turn its outer layers over: the tilts are held where a layer has 0.44 of the area or more.
template <class Pack>
CRUMPLE_INLINE FibreTilts<Pack> fibre_tilts(const LaminaGeometry<Pack>& g, const Pack& thickness) {
  Pack squares = g.x31 * g.x31;
  squares = multiply_add(g.y31, g.y31, squares);
  squares = multiply_add(g.x42, g.x42, squares);
  squares = multiply_add(g.y42, g.y42, squares);
  const Pack most = (g.area + g.area) / (thickness * squares);
  const Pack twist = (g.inverse_twice_area + g.inverse_twice_area) * g.z_mode;
  const Pack held = larger(Pack(-most), smaller(most, twist));
  return {-(held * g.y42), held * g.x42, -(held * g.y31), held * g.x31};
}

/// Half of the tilt over one diagonal, a vector in the lamina.
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> half_tilt(const Pack& x, const Pack& y) {
  const Pack half(RealOf<Pack>(0.5));
  return {half * x, half * y, Pack(RealOf<Pack>(0))};
}

/// a x e3 in lamina axes.
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> cross_normal(const math::PackVec3<Pack>& a) {
  return {a.y, -a.x, Pack(RealOf<Pack>(0))};
}

template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> in_lamina(const LaminaFrame<Pack>& frame, const math::PackVec3<Pack>& v) {
  return {math::dot(v, frame.e1), math::dot(v, frame.e2), math::dot(v, frame.e3)};
}
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> in_space(const LaminaFrame<Pack>& frame, const math::PackVec3<Pack>& v) {
  return math::multiply_add(v.x, frame.e1, math::multiply_add(v.y, frame.e2, v.z * frame.e3));
}

/// Velocities of the reference surface over its diagonals and rates w x y of the fibres, over the diagonals
/// and in the mean, all in lamina axes.
template <class Pack>
struct LaminaMotion {
  math::PackVec3<Pack> v31, v42;
  math::PackVec3<Pack> w31, w42;
  math::PackVec3<Pack> fibre31, fibre42, fibre_mean;
};
template <class Pack>
CRUMPLE_INLINE LaminaMotion<Pack> lamina_motion(const LaminaFrame<Pack>& frame, const ShellNodes<Pack>& n,
                                                const FibreTilts<Pack>& tilt) {
  using Real = RealOf<Pack>;
  const Pack half(Real(0.5));
  const auto tilt31 = half_tilt(tilt.x31, tilt.y31);
  const auto tilt42 = half_tilt(tilt.x42, tilt.y42);
  const auto sum = in_lamina(frame, n.w_sum);
  const auto mode = in_lamina(frame, n.w_mode);
  LaminaMotion<Pack> m;
  m.v31 = in_lamina(frame, n.v31);
  m.v42 = in_lamina(frame, n.v42);
  m.w31 = in_lamina(frame, n.w31);
  m.w42 = in_lamina(frame, n.w42);
  // With w1 + w3 = (sum + mode) / 2 and w2 + w4 = (sum - mode) / 2.
  m.fibre31 = cross_normal(m.w31) + math::cross(half * (sum + mode), tilt31);
  m.fibre42 = cross_normal(m.w42) + math::cross(half * (sum - mode), tilt42);
  m.fibre_mean =
      Pack(Real(0.25)) * (cross_normal(sum) + (math::cross(m.w31, tilt31) + math::cross(m.w42, tilt42)));
  return m;
}

/// Forces that do work on the members of LaminaMotion: on the velocities over the diagonals, their first
/// moments over the thickness on the fibre rates over the diagonals, and the shear on the mean fibre rate.
template <class Pack>
struct LayerForces {
  math::PackVec3<Pack> on31, on42;
  math::PackVec3<Pack> moment31, moment42;
  math::PackVec3<Pack> on_mean;
};

/// Nodal forces of the layers and of the hourglass stresses `q`.
template <class Pack>
CRUMPLE_INLINE ShellForces<Pack> fibre_forces(const LaminaFrame<Pack>& frame, const LaminaGeometry<Pack>& g,
                                              const FibreTilts<Pack>& tilt, LayerForces<Pack> layers,
                                              const HourglassModes<Pack>& q) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  // What the warp takes out of the membrane rates, the forces take out of the moments.
  const Pack lift = g.inverse_twice_area * g.z_mode;
  const Pack lift_x = lift * q.x;
  const Pack lift_y = lift * q.y;
  layers.on31.z = layers.on31.z + multiply_add(g.y42, lift_x, Pack(-(g.x42 * lift_y)));
  layers.on42.z = layers.on42.z + multiply_add(g.x31, lift_y, Pack(-(g.y31 * lift_x)));

  // The moment of a force p on the fibre y = e3 + tilt is y x p.
  const Vec quarter = Pack(Real(0.25)) * layers.on_mean;
  const auto moment = [&](const Vec& tilt_here, const Vec& p) {
    return math::cross(tilt_here, p) - cross_normal(p);
  };
  const Vec tilt31 = half_tilt(tilt.x31, tilt.y31);
  const Vec tilt42 = half_tilt(tilt.x42, tilt.y42);
  const Pack minus(Real(-1));
  const Vec force[4] = {minus * layers.on31, minus * layers.on42, layers.on31, layers.on42};
  const Vec on_nodes[4] = {
      moment(minus * tilt31, quarter - layers.moment31), moment(minus * tilt42, quarter - layers.moment42),
      moment(tilt31, quarter + layers.moment31), moment(tilt42, quarter + layers.moment42)};
  const HourglassVector<Pack> gamma = hourglass_vector(g);
  const Vec force_q{q.x, q.y, q.z};
  const Vec moment_q{q.bending_x, q.bending_y, Pack(Real(0))};
  ShellForces<Pack> out;
  for (int k = 0; k < 4; ++k) {
    out.force[k] = in_space(frame, math::multiply_add(gamma.node[k], force_q, force[k]));
    out.moment[k] = in_space(frame, math::multiply_add(gamma.node[k], moment_q, on_nodes[k]));
  }
  return out;
}
}  // namespace crumple::elements
