// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/assumed_strains.hpp"

namespace crumple::elements {

/// Shell with 2 x 2 points in plane and assumed strains (B.E. Engelmann, R.G. Whirley & G.L. Goudreau, 1989):
/// membrane and bending after Pian & Sumihara (IJNME 20 (1984) 1685-1695), transverse shear after Dvorkin &
/// Bathe (Eng. Comput. 1 (1984) 77-88). Nodal fibres carry the coupling of a warped element. No hourglass
/// modes. docs/theory/fully_integrated.md.
struct FullyIntegrated {
  static constexpr model::ShellFormulation formulation = model::ShellFormulation::FullyIntegrated;
  static constexpr const char* name = "fully integrated";
  static constexpr int planes = 4;
  static constexpr bool own_areas = true;

  static constexpr int row_drilling = 0;
  static constexpr int rows = 3;

  template <class Pack>
  static void strains(const ShellPlace<RealOf<Pack>>& place);
  template <class Pack>
  static ShellForces<Pack> forces(const ShellPlace<RealOf<Pack>>& place);
};

/// Transverse shear against xi varies with eta only, and against eta with xi (tied at the middles of the
/// sides).
template <class Pack>
struct TiedShear {
  Pack xi, xi_by_eta, eta, eta_by_xi;
};
template <class Pack>
CRUMPLE_INLINE TiedShear<Pack> tied_shear(const BilinearSurface<Pack>& s, const Bilinear<Pack>& v,
                                          const Bilinear<Pack>& b) {
  using math::dot;
  return {(dot(s.xi, b.mean) + v.xi.z) + (dot(s.twist, b.eta) + dot(v.twist, s.fibre_eta)),
          (dot(s.xi, b.eta) + dot(v.xi, s.fibre_eta)) + (dot(s.twist, b.mean) + v.twist.z),
          (dot(s.eta, b.mean) + v.eta.z) + (dot(s.twist, b.xi) + dot(v.twist, s.fibre_xi)),
          (dot(s.eta, b.xi) + dot(v.eta, s.fibre_xi)) + (dot(s.twist, b.mean) + v.twist.z)};
}

/// Strain rates of the reference surface and curvature rates, both as fields over the element, and the
/// transverse shear.
template <class Pack>
struct ShellRates {
  StrainField<Pack> membrane, bending;
  TiedShear<Pack> shear;
};
template <class Pack>
CRUMPLE_INLINE ShellRates<Pack> shell_rates(const BilinearSurface<Pack>& s, const AssumedStrains<Pack>& a,
                                            const Bilinear<Pack>& v, const Bilinear<Pack>& w) {
  const Bilinear<Pack> b = fibre_rates(s, w);
  const Tangential<Pack> vx = centre_gradient(s, v.xi.x, v.eta.x);
  const Tangential<Pack> vy = centre_gradient(s, v.xi.y, v.eta.y);
  const Tangential<Pack> vz = centre_gradient(s, v.xi.z, v.eta.z);
  const Tangential<Pack> twist{s.twist.x, s.twist.y};
  // A warped element that turns moves its pattern of positions; see hourglass_rates().
  const Tangential<Pack> hourglass{multiply_add(s.twist.z, vz.x, Pack(v.twist.x - dot(vx, twist))),
                                   multiply_add(s.twist.z, vz.y, Pack(v.twist.y - dot(vy, twist)))};
  // Fibres that tilt bend the shell only by what the surface's own motion does not explain.
  const auto bend = [&](const math::PackVec3<Pack>& rate, const math::PackVec3<Pack>& fibre) {
    const Tangential<Pack> tilt{fibre.x, fibre.y};
    return Tangential<Pack>{rate.x - dot(vx, tilt), rate.y - dot(vy, tilt)};
  };
  const Tangential<Pack> b_xi = bend(b.xi, s.fibre_xi);
  const Tangential<Pack> b_eta = bend(b.eta, s.fibre_eta);
  const Tangential<Pack> bx = centre_gradient(s, b_xi.x, b_eta.x);
  const Tangential<Pack> by = centre_gradient(s, b_xi.y, b_eta.y);
  const Tangential<Pack> bend_hourglass{b.twist.x - dot(bx, twist), b.twist.y - dot(by, twist)};
  return {strain_field(a, Tensor2<Pack>{vx.x, vy.y, vx.y + vy.x}, hourglass),
          strain_field(a, Tensor2<Pack>{bx.x, by.y, bx.y + by.x}, bend_hourglass), tied_shear(s, v, b)};
}

/// Transverse shear strains yz and zx at a point.
template <class Pack>
CRUMPLE_INLINE Tangential<Pack> shear_at(const TiedShear<Pack>& shear, const PlanePoint<Pack>& point) {
  const Pack over = Pack(RealOf<Pack>(1)) / point.area;
  const Pack on_xi = multiply_add(Pack(point.place_eta), shear.xi_by_eta, shear.xi);
  const Pack on_eta = multiply_add(Pack(point.place_xi), shear.eta_by_xi, shear.eta);
  return {over * multiply_add(point.along_eta.y, on_xi, Pack(-(point.along_xi.y * on_eta))),
          over * multiply_add(point.along_xi.x, on_eta, Pack(-(point.along_eta.x * on_xi)))};
}

template <class Pack>
CRUMPLE_INLINE void store_strains(const ShellPlace<RealOf<Pack>>& place, int plane,
                                  const Tensor2<Pack>& membrane, const Tensor2<Pack>& bending,
                                  const Tangential<Pack>& shear) {
  using Real = RealOf<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const Pack step(place.task.step);
  const Pack shear_step = step * Pack(constants.shear_root);
  const Pack bend = step * (Real(0.5) * own_state<Pack>(place, element_state::thickness));
  const Pack zero(Real(0));
  const Tensor2<Pack> none{zero, zero, zero};
  const Tensor2<Pack> middle = add_scaled(step, membrane, none);
  const Tensor2<Pack> outer = add_scaled(bend, bending, none);
  const Pack yz = shear_step * shear.y;
  const Pack zx = shear_step * shear.x;
  for (int p = 0; p < constants.points; ++p) {
    const Tensor2<Pack> strain = add_scaled(Pack(constants.place[p]), outer, middle);
    materials::store_five(place.strain + (plane * constants.points + p) * materials::components * tile_lanes,
                          tile_lanes, materials::PlaneStrain<Pack>{strain.xx, strain.yy, strain.xy, yz, zx});
  }
}

template <class Pack>
CRUMPLE_INLINE void FullyIntegrated::strains(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const ShellNodes<Pack> n = gathered<Pack>(place).all();
  const ElementShape<Pack> shape = middle_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const BilinearSurface<Pack> s = bilinear_surface(shape);
  const AssumedStrains<Pack> a = assumed_strains(s, constants.poissons_ratio);
  const Pack zero(Real(0));
  const Bilinear<Pack> w = bilinear(frame, n.w31, n.w42, n.w_mode, n.w_sum);
  const ShellRates<Pack> rates =
      shell_rates(s, a, bilinear(frame, n.v31, n.v42, n.v_mode, math::PackVec3<Pack>{zero, zero, zero}), w);
  for (int plane = 0; plane < planes; ++plane) {
    const PlanePoint<Pack> point = plane_point(s, plane);
    store_strains(place, plane, strain_at(rates.membrane, a, point), strain_at(rates.bending, a, point),
                  shear_at(rates.shear, point));
    for (int p = 0; p < constants.points; ++p)
      store(place.area + (plane * constants.points + p) * tile_lanes, point.area);
  }
  keep_vec(place, row_drilling, math::PackVec3<Pack>{w.xi.z, w.eta.z, w.twist.z});
}

/// Stresses of one point in plane over the thickness: mean, and mean times the place.
template <class Pack>
struct PlaneResultants {
  Tensor2<Pack> force, moment;
  Pack yz, zx;
};
template <class Pack>
CRUMPLE_INLINE PlaneResultants<Pack> plane_resultants(const ShellPlace<RealOf<Pack>>& place, int plane) {
  using Real = RealOf<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const Pack zero(Real(0));
  PlaneResultants<Pack> r{{zero, zero, zero}, {zero, zero, zero}, zero, zero};
  for (int p = 0; p < constants.points; ++p) {
    const auto stress = materials::load_five<materials::PlaneStress<Pack>>(
        place.state + (plane * constants.points + p) * materials::components * lanes, lanes);
    const Pack weight(constants.weight[p]);
    const Tensor2<Pack> in_plane{stress.xx, stress.yy, stress.xy};
    r.force = add_scaled(weight, in_plane, r.force);
    r.moment = add_scaled(Pack(constants.weight[p] * constants.place[p]), in_plane, r.moment);
    r.yz = multiply_add(weight, stress.yz, r.yz);
    r.zx = multiply_add(weight, stress.zx, r.zx);
  }
  return r;
}

template <class Pack>
CRUMPLE_INLINE void add(TiedShear<Pack>& sum, const PlanePoint<Pack>& point, const Pack& yz, const Pack& zx) {
  const Pack on_xi = multiply_add(point.along_eta.y, zx, Pack(-(point.along_eta.x * yz)));
  const Pack on_eta = multiply_add(point.along_xi.x, yz, Pack(-(point.along_xi.y * zx)));
  sum.xi = sum.xi + on_xi;
  sum.xi_by_eta = multiply_add(Pack(point.place_eta), on_xi, sum.xi_by_eta);
  sum.eta = sum.eta + on_eta;
  sum.eta_by_xi = multiply_add(Pack(point.place_xi), on_eta, sum.eta_by_xi);
}

template <class Pack>
struct ElementForces {
  FieldForces<Pack> membrane, bending;
  TiedShear<Pack> shear;
};
template <class Pack>
CRUMPLE_INLINE ElementForces<Pack> element_forces(const ShellPlace<RealOf<Pack>>& place,
                                                  const BilinearSurface<Pack>& s,
                                                  const AssumedStrains<Pack>& a, const Pack& thickness) {
  using Real = RealOf<Pack>;
  const Pack shear = thickness * Pack(place.task.constants.shear_root);
  const Pack bend = thickness * (Real(0.5) * own_state<Pack>(place, element_state::thickness));
  const Pack zero(Real(0));
  const FieldForces<Pack> none{{zero, zero, zero}, zero, zero};
  ElementForces<Pack> sum{none, none, {zero, zero, zero, zero}};
  for (int plane = 0; plane < FullyIntegrated::planes; ++plane) {
    const PlanePoint<Pack> point = plane_point(s, plane);
    const PlaneResultants<Pack> r = plane_resultants<Pack>(place, plane);
    add(sum.membrane, a, point, r.force, thickness);
    add(sum.bending, a, point, r.moment, bend);
    add(sum.shear, point, Pack(shear * r.yz), Pack(shear * r.zx));
  }
  return sum;
}

/// The transpose of shell_rates(): forces on the velocities and on the fibre rates.
template <class Pack>
struct SurfaceForces {
  Bilinear<Pack> on_velocity, on_fibre;
};
template <class Pack>
CRUMPLE_INLINE SurfaceForces<Pack> surface_forces(const BilinearSurface<Pack>& s,
                                                  const AssumedStrains<Pack>& a,
                                                  const ElementForces<Pack>& e) {
  using Vec = math::PackVec3<Pack>;
  const Pack zero(RealOf<Pack>(0));
  const Tangential<Pack> q = hourglass_force(a, e.membrane.along_xi, e.membrane.along_eta);
  const Tangential<Pack> m = hourglass_force(a, e.bending.along_xi, e.bending.along_eta);
  const Tensor2<Pack>& k = e.bending.centre;
  const Tangential<Pack> bend_x = on_gradient(s, Pack(k.xx - m.x * s.twist.x), Pack(k.xy - m.x * s.twist.y));
  const Tangential<Pack> bend_y = on_gradient(s, Pack(k.xy - m.y * s.twist.x), Pack(k.yy - m.y * s.twist.y));
  const Vec bend_xi{bend_x.x, bend_y.x, zero};
  const Vec bend_eta{bend_x.y, bend_y.y, zero};
  // p_xi y_xi + p_eta y_eta: what the tilts take from the gradient of the velocity.
  const auto taken = [&](const Pack& p_xi, const Pack& p_eta, const Pack& y_xi, const Pack& y_eta) {
    return multiply_add(p_xi, y_xi, Pack(p_eta * y_eta));
  };
  const auto from_membrane = [&](const Pack& x, const Pack& y, const Pack& hourglass,
                                 const Tangential<Pack>& p) {
    return on_gradient(s, Pack((x - hourglass * s.twist.x) - taken(p.x, p.y, s.fibre_xi.x, s.fibre_eta.x)),
                       Pack((y - hourglass * s.twist.y) - taken(p.x, p.y, s.fibre_xi.y, s.fibre_eta.y)));
  };
  const Tensor2<Pack>& n = e.membrane.centre;
  const Tangential<Pack> on_x = from_membrane(n.xx, n.xy, q.x, bend_x);
  const Tangential<Pack> on_y = from_membrane(n.xy, n.yy, q.y, bend_y);
  const Tangential<Pack> on_z = on_gradient(s, Pack(s.twist.z * q.x), Pack(s.twist.z * q.y));
  const TiedShear<Pack>& t = e.shear;
  const Pack both = t.xi_by_eta + t.eta_by_xi;
  const Vec none{zero, zero, zero};
  SurfaceForces<Pack> f;
  f.on_velocity = {
      none, math::multiply_add(t.xi_by_eta, s.fibre_eta, Vec{on_x.x, on_y.x, on_z.x + t.xi}),
      math::multiply_add(t.eta_by_xi, s.fibre_xi, Vec{on_x.y, on_y.y, on_z.y + t.eta}),
      math::multiply_add(t.xi, s.fibre_eta, math::multiply_add(t.eta, s.fibre_xi, Vec{q.x, q.y, both}))};
  f.on_fibre = {math::multiply_add(t.xi, s.xi, math::multiply_add(t.eta, s.eta, both * s.twist)),
                math::multiply_add(t.eta, s.twist, math::multiply_add(t.eta_by_xi, s.eta, bend_xi)),
                math::multiply_add(t.xi, s.twist, math::multiply_add(t.xi_by_eta, s.xi, bend_eta)),
                Vec{m.x, m.y, zero}};
  return f;
}

template <class Pack>
CRUMPLE_INLINE ShellForces<Pack> FullyIntegrated::forces(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  const ElementShape<Pack> shape = end_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const BilinearSurface<Pack> s = bilinear_surface(shape);
  const AssumedStrains<Pack> a = assumed_strains(s, place.task.constants.poissons_ratio);
  const Pack active = own_state<Pack>(place, element_state::active);

  const Pack mean_thickness = update_thickness<Pack>(place);
  const Pack thickness = active * own_state<Pack>(place, element_state::thickness);
  leave_internal_energy(place, Pack(active * mean_thickness));
  const Vec drilling = kept_vec<Pack>(place, row_drilling);
  const Pack zero(Real(0));
  const auto q = update_drilling(place, thickness,
                                 HourglassModes<Pack>{drilling.x, drilling.y, zero, drilling.z, zero}, zero);

  const SurfaceForces<Pack> f = surface_forces(s, a, element_forces(place, s, a, thickness));
  ShellForces<Pack> out;
  to_nodes(frame, f.on_velocity, out.force);
  to_nodes(frame, with_drilling(fibre_moments(s, f.on_fibre), q), out.moment);
  limit_step(place, Pack(Real(4) * s.jacobian), shape);
  return out;
}

}  // namespace crumple::elements
