// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/resultants.hpp"

namespace crumple::elements {

/// The one-point corotational shell of Belytschko, Lin & Tsay (CMAME 42 (1984) 225-251):
/// docs/theory/belytschko_tsay.md.
struct BelytschkoTsay {
  static constexpr model::ShellFormulation formulation = model::ShellFormulation::BelytschkoTsay;
  static constexpr const char* name = "Belytschko-Tsay";
  static constexpr int planes = 1;
  static constexpr bool own_areas = false;

  static constexpr int row_rates = 0;
  static constexpr int row_area = 5;
  static constexpr int rows = 6;

  template <class Pack>
  static void strains(const ShellPlace<RealOf<Pack>>& place);
  template <class Pack>
  static ShellForces<Pack> forces(const ShellPlace<RealOf<Pack>>& place);
};

template <class Pack>
CRUMPLE_INLINE void BelytschkoTsay::strains(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const GatheredNodes<Pack> n = gathered<Pack>(place);
  const ElementShape<Pack> shape = middle_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const auto g = lamina_geometry(shape);

  // One vector after the other: all of them at once are more than there are registers.
  const auto local = [&](const math::PackVec3<Pack>& v) {
    return math::PackVec3<Pack>{math::dot(v, frame.e1), math::dot(v, frame.e2), math::dot(v, frame.e3)};
  };
  const auto v31 = local(n.v31());
  const auto v42 = local(n.v42());
  const auto vx = gradient(g, v31.x, v42.x);
  const auto vy = gradient(g, v31.y, v42.y);
  const auto vz = gradient(g, v31.z, v42.z);
  const auto w31 = n.w31();
  const auto w42 = n.w42();
  const auto wx = gradient(g, math::dot(w31, frame.e1), math::dot(w42, frame.e1));
  const auto wy = gradient(g, math::dot(w31, frame.e2), math::dot(w42, frame.e2));
  keep_modes(place, row_rates,
             hourglass_rates(frame, g, n.v_mode(), n.w_mode(), VelocityGradients<Pack>{vx, vy, vz, wx, wy}));
  keep(place, row_area, g.area);

  const Pack step(place.task.step);
  const Pack shear_step = step * Pack(constants.shear_root);
  const Pack quarter(Real(0.25));
  const auto w_sum = n.w_sum();
  const materials::PlaneStrain<Pack> membrane{
      step * vx.x, step * vy.y, step * (vx.y + vy.x),
      shear_step * multiply_add(-quarter, math::dot(w_sum, frame.e1), vz.y),
      shear_step * multiply_add(quarter, math::dot(w_sum, frame.e2), vz.x)};
  const Pack half_thickness = Real(0.5) * own_state<Pack>(place, element_state::thickness);
  const Pack bend = half_thickness * step;
  store_strains(place, membrane, Bending<Pack>{bend * wy.x, -(bend * wx.y), bend * (wy.y - wx.x)});
}

/// What node 1 (and, negative, node 3) or node 2 (and 4) gets of the resultants; b1 and b2 are the area times
/// the node's gradients.
template <class Pack>
struct NodeShare {
  math::PackVec3<Pack> force;  ///< lamina axes
  Pack moment_x, moment_y;
};
template <class Pack>
CRUMPLE_INLINE NodeShare<Pack> node_share(const Resultants<Pack>& r, const Pack& b1, const Pack& b2,
                                          const Pack& lift_x, const Pack& lift_y) {
  return {{multiply_add(b1, r.xx, Pack(b2 * r.xy)), multiply_add(b2, r.yy, Pack(b1 * r.xy)),
           multiply_add(b1, Pack(r.zx + lift_x), Pack(b2 * (r.yz + lift_y)))},
          -multiply_add(b2, r.bend_yy, Pack(b1 * r.bend_xy)),
          multiply_add(b1, r.bend_xx, Pack(b2 * r.bend_xy))};
}

template <class Pack>
CRUMPLE_INLINE ShellForces<Pack> BelytschkoTsay::forces(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  const ElementShape<Pack> shape = end_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const auto g = lamina_geometry(shape);
  limit_step(place, g.area, shape);
  const Pack active = own_state<Pack>(place, element_state::active);

  const Pack mean_thickness = update_thickness<Pack>(place);
  const Pack thickness = active * own_state<Pack>(place, element_state::thickness);
  leave_internal_energy(place, Pack(active * (mean_thickness * kept<Pack>(place, row_area))));

  const auto q = update_hourglass(place, g, thickness, kept_modes<Pack>(place, row_rates));

  // What the warp takes out of the membrane rates, the forces take out of the moments.
  const Pack lift = (g.inverse_twice_area + g.inverse_twice_area) * g.z_mode;
  const Resultants<Pack> r = integrate(place, thickness);
  const Pack half(Real(0.5));
  const Pack a1 = -(half * g.y42);
  const Pack a2 = half * g.x42;
  const Pack b1 = half * g.y31;
  const Pack b2 = -(half * g.x31);
  const NodeShare<Pack> share_a = node_share<Pack>(r, a1, a2, lift * q.x, lift * q.y);
  const NodeShare<Pack> share_b = node_share<Pack>(r, b1, b2, lift * q.x, lift * q.y);
  const Pack quarter_area = Real(0.25) * g.area;

  const auto global3 = [&](const Vec& v) {
    return math::multiply_add(v.x, frame.e1, math::multiply_add(v.y, frame.e2, v.z * frame.e3));
  };
  const auto global2 = [&](const Pack& x, const Pack& y) {
    return math::multiply_add(x, frame.e1, y * frame.e2);
  };
  const Vec force_a = global3(share_a.force);
  const Vec force_b = global3(share_b.force);
  const Vec force_q = global3({q.x, q.y, q.z});
  const Vec moment_a = global2(share_a.moment_x, share_a.moment_y);
  const Vec moment_b = global2(share_b.moment_x, share_b.moment_y);
  const Vec moment_s = global2(-(quarter_area * r.yz), quarter_area * r.zx);
  const Vec moment_q = global2(q.bending_x, q.bending_y);

  const HourglassVector<Pack> gamma = hourglass_vector(g);
  ShellForces<Pack> out;
  out.force[0] = math::multiply_add(gamma.node[0], force_q, force_a);
  out.force[1] = math::multiply_add(gamma.node[1], force_q, force_b);
  out.force[2] = math::multiply_add(gamma.node[2], force_q, -force_a);
  out.force[3] = math::multiply_add(gamma.node[3], force_q, -force_b);
  out.moment[0] = math::multiply_add(gamma.node[0], moment_q, moment_s + moment_a);
  out.moment[1] = math::multiply_add(gamma.node[1], moment_q, moment_s + moment_b);
  out.moment[2] = math::multiply_add(gamma.node[2], moment_q, moment_s - moment_a);
  out.moment[3] = math::multiply_add(gamma.node[3], moment_q, moment_s - moment_b);
  return out;
}

}  // namespace crumple::elements
