// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/resultants.hpp"

namespace crumple::elements {

/// The C0 triangle of Kennedy, Belytschko & Lin (Nuclear Engineering and Design 97 (1986) 1-24):
/// docs/theory/c0_triangle.md. Its fourth node repeats the third, so that the differences over the
/// "diagonals" 31 and 42 are those over sides 1-3 and 2-3. Membrane and bending strains are constant; nothing
/// is left for hourglass control to hold.
struct Triangle {
  static constexpr model::ShellFormulation formulation = model::ShellFormulation::Triangle;
  static constexpr const char* name = "C0 triangle";
  static constexpr int planes = 1;
  static constexpr bool own_areas = false;

  static constexpr int row_area = 0;
  static constexpr int rows = 1;

  template <class Pack>
  static void strains(const ShellPlace<RealOf<Pack>>& place);
  template <class Pack>
  static ShellForces<Pack> forces(const ShellPlace<RealOf<Pack>>& place);
};

/// Components along e1 and e2.
template <class Pack>
struct PlaneVector {
  Pack x, y;
};
template <class Pack>
CRUMPLE_INLINE PlaneVector<Pack> plane_vector(const LaminaFrame<Pack>& frame, const math::PackVec3<Pack>& v) {
  return {math::dot(v, frame.e1), math::dot(v, frame.e2)};
}

/// Transverse shear along sides 1-3 and 2-3, times their lengths, at the centroid. Along a side the shear is
/// constant: the slope and the rotation across it, mean of its ends. At a corner the two sides that meet
/// there give the whole vector; the mean over the corners is the centroid's.
template <class Pack>
CRUMPLE_INLINE PlaneVector<Pack> centroid_shear(const LaminaGeometry<Pack>& g, const Pack& vz31,
                                                const Pack& vz32, const PlaneVector<Pack>& w31,
                                                const PlaneVector<Pack>& w32,
                                                const PlaneVector<Pack>& w_sum) {
  using Real = RealOf<Pack>;
  const Pack quarter(Real(0.25));
  const Pack third(Real(1) / Real(3));
  // A side s and the mean rotation m of its ends: the fibre's rate along the side is s_x m_y - s_y m_x.
  const auto along = [&](const Pack& sx, const Pack& sy, const Pack& mx, const Pack& my) {
    return Pack(quarter * multiply_add(sx, my, Pack(-(sy * mx))));
  };
  // w1 + w3 = (sum - w31 + w32) / 2, and so on: the third node counts twice in the sum.
  const PlaneVector<Pack> apart{w31.x - w32.x, w31.y - w32.y};
  const PlaneVector<Pack> both{w31.x + w32.x, w31.y + w32.y};
  const Pack side31 = along(g.x31, g.y31, w_sum.x - apart.x, w_sum.y - apart.y);
  const Pack side32 = along(g.x42, g.y42, w_sum.x + apart.x, w_sum.y + apart.y);
  const Pack side21 = along(g.x31 - g.x42, g.y31 - g.y42, w_sum.x - both.x, w_sum.y - both.y);
  const Pack slip = third * ((side31 - side32) - side21);
  // The mean over the corners is side21 + slip along 2-1 and side31 - slip along 3-1, and so
  // side31 - side21 - 2 slip along 3-2.
  return {vz31 + (side31 - slip), vz32 + ((side31 - side21) - (slip + slip))};
}

template <class Pack>
CRUMPLE_INLINE void Triangle::strains(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const ShellNodes<Pack> n = gathered<Pack>(place).all();
  const ElementShape<Pack> shape = middle_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const auto g = lamina_geometry(shape);

  const PlaneVector<Pack> v31 = plane_vector(frame, n.v31);
  const PlaneVector<Pack> v32 = plane_vector(frame, n.v42);
  const PlaneVector<Pack> w31 = plane_vector(frame, n.w31);
  const PlaneVector<Pack> w32 = plane_vector(frame, n.w42);
  const auto vx = gradient(g, v31.x, v32.x);
  const auto vy = gradient(g, v31.y, v32.y);
  const auto wx = gradient(g, w31.x, w32.x);
  const auto wy = gradient(g, w31.y, w32.y);
  const PlaneVector<Pack> shear = centroid_shear(g, math::dot(n.v31, frame.e3), math::dot(n.v42, frame.e3),
                                                 w31, w32, plane_vector(frame, n.w_sum));
  const auto sheared = gradient(g, shear.x, shear.y);

  const Pack step(place.task.step);
  const Pack shear_step = step * Pack(place.task.constants.shear_root);
  const materials::PlaneStrain<Pack> membrane{step * vx.x, step * vy.y, step * (vx.y + vy.x),
                                              shear_step * sheared.y, shear_step * sheared.x};
  const Pack bend = Real(0.5) * own_state<Pack>(place, element_state::thickness) * step;
  store_strains(place, membrane, Bending<Pack>{bend * wy.x, -(bend * wx.y), bend * (wy.y - wx.x)});

  keep(place, row_area, g.area);
}

/// What does work on the rates over sides 1-3 and 2-3.
template <class Pack>
struct SideForces {
  math::PackVec3<Pack> on31, on32;   ///< on the velocities, lamina axes
  PlaneVector<Pack> turn31, turn32;  ///< on the angular velocities
  PlaneVector<Pack> turn_sum;        ///< on the sum of the angular velocities, the third counted twice
};

template <class Pack>
CRUMPLE_INLINE SideForces<Pack> side_forces(const LaminaGeometry<Pack>& g, const Resultants<Pack>& r) {
  using Real = RealOf<Pack>;
  const Pack half(Real(0.5));
  const Pack a31 = half * g.y42;  // area times d/dx by the difference over 1-3, and so on
  const Pack b31 = -(half * g.x42);
  const Pack a32 = -(half * g.y31);
  const Pack b32 = half * g.x31;
  // Shear along the two sides, and from there back through centroid_shear().
  const Pack q31 = multiply_add(a31, r.zx, Pack(b31 * r.yz));
  const Pack q32 = multiply_add(a32, r.zx, Pack(b32 * r.yz));
  const Pack third(Real(1) / Real(3));
  const Pack slip = third * (-(q31 + (q32 + q32)));
  const Pack quarter(Real(0.25));
  const Pack s31 = quarter * ((q31 + q32) + slip);
  const Pack s32 = quarter * (-slip);
  const Pack s21 = quarter * (-(q32 + slip));
  const auto turn = [](const Pack& s, const Pack& x, const Pack& y) {
    return PlaneVector<Pack>{-(s * y), s * x};
  };
  const PlaneVector<Pack> t31 = turn(s31, g.x31, g.y31);
  const PlaneVector<Pack> t32 = turn(s32, g.x42, g.y42);
  const PlaneVector<Pack> t21 = turn(s21, g.x31 - g.x42, g.y31 - g.y42);
  SideForces<Pack> f;
  f.on31 = {multiply_add(a31, r.xx, Pack(b31 * r.xy)), multiply_add(b31, r.yy, Pack(a31 * r.xy)), q31};
  f.on32 = {multiply_add(a32, r.xx, Pack(b32 * r.xy)), multiply_add(b32, r.yy, Pack(a32 * r.xy)), q32};
  // Bending on w31 and w32; apart = w31 - w32 enters t31 negative, t32 positive; both enters t21 negative.
  f.turn31 = {((t32.x - t31.x) - t21.x) - multiply_add(b31, r.bend_yy, Pack(a31 * r.bend_xy)),
              ((t32.y - t31.y) - t21.y) + multiply_add(a31, r.bend_xx, Pack(b31 * r.bend_xy))};
  f.turn32 = {((t31.x - t32.x) - t21.x) - multiply_add(b32, r.bend_yy, Pack(a32 * r.bend_xy)),
              ((t31.y - t32.y) - t21.y) + multiply_add(a32, r.bend_xx, Pack(b32 * r.bend_xy))};
  f.turn_sum = {t31.x + (t32.x + t21.x), t31.y + (t32.y + t21.y)};
  return f;
}

template <class Pack>
CRUMPLE_INLINE ShellForces<Pack> Triangle::forces(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  const ElementShape<Pack> shape = end_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const auto g = lamina_geometry(shape);
  const Pack active = own_state<Pack>(place, element_state::active);

  const Pack mean_thickness = update_thickness<Pack>(place);
  const Pack thickness = active * own_state<Pack>(place, element_state::thickness);
  leave_internal_energy(place, Pack(active * (mean_thickness * kept<Pack>(place, row_area))));
  const Pack zero(Real(0));
  store(place.rows + scratch_row::hourglass_energy * tile_lanes, zero);

  const SideForces<Pack> f = side_forces(g, integrate(place, thickness));
  const auto global2 = [&](const PlaneVector<Pack>& v) {
    return math::multiply_add(v.x, frame.e1, v.y * frame.e2);
  };
  const auto global3 = [&](const Vec& v) {
    return math::multiply_add(v.x, frame.e1, math::multiply_add(v.y, frame.e2, v.z * frame.e3));
  };
  const Vec on31 = global3(f.on31);
  const Vec on32 = global3(f.on32);
  const Vec turn31 = global2(f.turn31);
  const Vec turn32 = global2(f.turn32);
  const Vec turn_sum = global2(f.turn_sum);
  // The third node gets all of its share through its first entry, the entry that repeats it gets nothing.
  const Vec none{zero, zero, zero};
  ShellForces<Pack> out;
  out.force[0] = Pack(Real(-1)) * on31;
  out.force[1] = Pack(Real(-1)) * on32;
  out.force[2] = on31 + on32;
  out.force[3] = none;
  out.moment[0] = turn_sum - turn31;
  out.moment[1] = turn_sum - turn32;
  out.moment[2] = (turn_sum + turn_sum) + (turn31 + turn32);
  out.moment[3] = none;

  limit_step(place, g.area, shape);
  return out;
}

}  // namespace crumple::elements
