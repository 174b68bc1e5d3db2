// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/assumed_strains.hpp"
#include "elements/shell/membrane.hpp"

namespace crumple::elements {

/// The membrane part of the fully integrated shell, with the strain that the warp adds: in tension a warped
/// element is drawn flat, so that no motion needs hourglass control. docs/theory/membranes.md.
struct FullyIntegratedMembrane {
  static constexpr model::ShellFormulation formulation = model::ShellFormulation::FullyIntegratedMembrane;
  static constexpr const char* name = "fully integrated membrane";
  static constexpr int planes = 4;
  static constexpr bool own_areas = true;
  static constexpr int rows = 0;

  template <class Pack>
  static void strains(const ShellPlace<RealOf<Pack>>& place);
  template <class Pack>
  static ShellForces<Pack> forces(const ShellPlace<RealOf<Pack>>& place);
};

/// Mean strain over the element per unit of the product of warp and its growth: the slopes of a warped
/// surface are eta z along xi and xi z along eta, and the means of eta^2, xi^2 and 2 xi eta are 1/3, 1/3 and
/// 0.
template <class Pack>
CRUMPLE_INLINE Tensor2<Pack> strain_of_warp(const BilinearSurface<Pack>& s) {
  using Real = RealOf<Pack>;
  const Pack third(Real(1) / Real(3));
  const Pack both(Real(2) / Real(3));
  return {third * multiply_add(s.grad_xi.x, s.grad_xi.x, Pack(s.grad_eta.x * s.grad_eta.x)),
          third * multiply_add(s.grad_xi.y, s.grad_xi.y, Pack(s.grad_eta.y * s.grad_eta.y)),
          both * multiply_add(s.grad_xi.x, s.grad_xi.y, Pack(s.grad_eta.x * s.grad_eta.y))};
}

template <class Pack>
CRUMPLE_INLINE void FullyIntegratedMembrane::strains(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const GatheredNodes<Pack> n = gathered<Pack>(place);
  const ElementShape<Pack> shape = middle_shape<Pack>(place);
  const BilinearSurface<Pack> s = bilinear_surface(shape);
  const AssumedStrains<Pack> a = assumed_strains(s, constants.poissons_ratio);
  const Pack zero(Real(0));
  const Bilinear<Pack> v =
      bilinear(shape.frame, n.v31(), n.v42(), n.v_mode(), math::PackVec3<Pack>{zero, zero, zero});
  const Tangential<Pack> vx = centre_gradient(s, v.xi.x, v.eta.x);
  const Tangential<Pack> vy = centre_gradient(s, v.xi.y, v.eta.y);
  const Tangential<Pack> vz = centre_gradient(s, v.xi.z, v.eta.z);
  const Tangential<Pack> twist{s.twist.x, s.twist.y};
  // A warped element that turns moves its pattern of positions; see hourglass_rates().
  const Tangential<Pack> hourglass{multiply_add(s.twist.z, vz.x, Pack(v.twist.x - dot(vx, twist))),
                                   multiply_add(s.twist.z, vz.y, Pack(v.twist.y - dot(vy, twist)))};
  const Pack warping = s.twist.z * (v.twist.z - dot(vz, twist));
  const Tensor2<Pack> centre = add_scaled(warping, strain_of_warp(s), Tensor2<Pack>{vx.x, vy.y, vx.y + vy.x});
  const StrainField<Pack> field = strain_field(a, centre, hourglass);
  const Pack step(place.task.step);
  for (int plane = 0; plane < planes; ++plane) {
    const PlanePoint<Pack> point = plane_point(s, plane);
    const Tensor2<Pack> rate = strain_at(field, a, point);
    store_membrane_strain(place, plane, Pack(step * rate.xx), Pack(step * rate.yy), Pack(step * rate.xy));
    for (int p = 0; p < constants.points; ++p)
      store(place.area + (plane * constants.points + p) * tile_lanes, point.area);
  }
}

template <class Pack>
CRUMPLE_INLINE ShellForces<Pack> FullyIntegratedMembrane::forces(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const ElementShape<Pack> shape = end_shape<Pack>(place);
  const BilinearSurface<Pack> s = bilinear_surface(shape);
  const AssumedStrains<Pack> a = assumed_strains(s, place.task.constants.poissons_ratio);
  const Pack active = own_state<Pack>(place, element_state::active);
  const Pack zero(Real(0));

  const Pack mean_thickness = update_thickness<Pack>(place);
  const Pack thickness = active * own_state<Pack>(place, element_state::thickness);
  leave_internal_energy(place, Pack(active * mean_thickness));
  store(place.rows + scratch_row::hourglass_energy * tile_lanes, zero);

  FieldForces<Pack> sum{{zero, zero, zero}, zero, zero};
  for (int plane = 0; plane < planes; ++plane) {
    const MembraneForce<Pack> r = membrane_force(place, plane, thickness);
    add(sum, a, plane_point(s, plane), Tensor2<Pack>{r.xx, r.yy, r.xy}, Pack(Real(1)));
  }
  const Tensor2<Pack>& m = sum.centre;
  const Tangential<Pack> q = hourglass_force(a, sum.along_xi, sum.along_eta);
  const Pack lift = s.twist.z * work(strain_of_warp(s), m);
  const auto on = [&](const Pack& x, const Pack& y, const Pack& hourglass) {
    return on_gradient(s, Pack(x - hourglass * s.twist.x), Pack(y - hourglass * s.twist.y));
  };
  const Tangential<Pack> on_x = on(m.xx, m.xy, q.x);
  const Tangential<Pack> on_y = on(m.xy, m.yy, q.y);
  const Tangential<Pack> on_z = on(s.twist.z * q.x, s.twist.z * q.y, lift);
  ShellForces<Pack> out;
  to_nodes(shape.frame,
           Bilinear<Pack>{
               {zero, zero, zero}, {on_x.x, on_y.x, on_z.x}, {on_x.y, on_y.y, on_z.y}, {q.x, q.y, lift}},
           out.force);
  no_moments(out);
  limit_step(place, Pack(Real(4) * s.jacobian), shape);
  return out;
}

}  // namespace crumple::elements
