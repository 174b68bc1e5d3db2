// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/bilinear_shell.hpp"

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

/// Strains (or stresses) in the plane; xy of strains is the engineering shear.
template <class Pack>
struct Tensor2 {
  Pack xx, yy, xy;
};
template <class Pack>
CRUMPLE_INLINE Tensor2<Pack> add_scaled(const Pack& s, const Tensor2<Pack>& a, const Tensor2<Pack>& b) {
  return {multiply_add(s, a.xx, b.xx), multiply_add(s, a.yy, b.yy), multiply_add(s, a.xy, b.xy)};
}
/// Work of stress on strain.
template <class Pack>
CRUMPLE_INLINE Pack work(const Tensor2<Pack>& a, const Tensor2<Pack>& b) {
  return multiply_add(a.xx, b.xx, multiply_add(a.yy, b.yy, Pack(a.xy * b.xy)));
}

/// The two strain fields that vary over the element. Pian and Sumihara's stresses are constant but for
/// tension along x_xi that varies with eta, and along x_eta with xi; here stand the strains of these
/// stresses, of unit size, and the inverse of their compliance, by which the nodes' motion becomes their
/// amplitudes.
template <class Pack>
struct AssumedStrains {
  Tensor2<Pack> along_xi, along_eta;
  Tangential<Pack> pull_xi, pull_eta;  ///< x_xi and x_eta over the squares of their lengths
  Pack inverse_xi_xi, inverse_xi_eta, inverse_eta_eta;
};

/// Strain of the unit tension along a direction t, Hooke's law with Young's modulus 1.
template <class Pack>
CRUMPLE_INLINE Tensor2<Pack> strain_of_tension(const Tangential<Pack>& t, const Tangential<Pack>& pull,
                                               RealOf<Pack> poissons_ratio) {
  using Real = RealOf<Pack>;
  const Pack ratio(poissons_ratio);
  const Pack xx = t.x * pull.x;
  const Pack yy = t.y * pull.y;
  return {xx - ratio * yy, yy - ratio * xx, Pack(Real(2) * (Real(1) + poissons_ratio)) * (t.x * pull.y)};
}

template <class Pack>
CRUMPLE_INLINE AssumedStrains<Pack> assumed_strains(const BilinearSurface<Pack>& s,
                                                    RealOf<Pack> poissons_ratio) {
  using Real = RealOf<Pack>;
  const Pack one(Real(1));
  const Tangential<Pack> t_xi{s.xi.x, s.xi.y};
  const Tangential<Pack> t_eta{s.eta.x, s.eta.y};
  const Pack over_xi = one / dot(t_xi, t_xi);
  const Pack over_eta = one / dot(t_eta, t_eta);
  AssumedStrains<Pack> a;
  a.pull_xi = {over_xi * t_xi.x, over_xi * t_xi.y};
  a.pull_eta = {over_eta * t_eta.x, over_eta * t_eta.y};
  a.along_xi = strain_of_tension<Pack>(t_xi, a.pull_xi, poissons_ratio);
  a.along_eta = strain_of_tension<Pack>(t_eta, a.pull_eta, poissons_ratio);
  // Means of (eta - mean)^2, (xi - mean)^2 and their product over the area, times three.
  const Pack third(Real(1) / Real(3));
  const Pack eta_eta = multiply_add(Pack(-third * s.taper_eta), s.taper_eta, one);
  const Pack xi_xi = multiply_add(Pack(-third * s.taper_xi), s.taper_xi, one);
  const Pack xi_eta = -(third * (s.taper_xi * s.taper_eta));
  const Pack cosine2 = dot(t_xi, a.pull_eta) * dot(t_eta, a.pull_xi);
  const Pack mixed = xi_eta * multiply_add(Pack(Real(1) + poissons_ratio), cosine2, Pack(-poissons_ratio));
  const Pack over = one / multiply_add(eta_eta, xi_xi, Pack(-(mixed * mixed)));
  a.inverse_xi_xi = over * xi_xi;
  a.inverse_xi_eta = -(over * mixed);
  a.inverse_eta_eta = over * eta_eta;
  return a;
}

/// A strain field over the element: that of the centre and two amplitudes.
template <class Pack>
struct StrainField {
  Tensor2<Pack> centre;
  Pack along_xi, along_eta;
};

/// From the gradient of a bilinear field at the centre and its hourglass part.
template <class Pack>
CRUMPLE_INLINE StrainField<Pack> strain_field(const AssumedStrains<Pack>& a, const Tensor2<Pack>& centre,
                                              const Tangential<Pack>& hourglass) {
  const Pack on_xi = dot(a.pull_xi, hourglass);
  const Pack on_eta = dot(a.pull_eta, hourglass);
  return {centre, multiply_add(a.inverse_xi_xi, on_xi, Pack(a.inverse_xi_eta * on_eta)),
          multiply_add(a.inverse_xi_eta, on_xi, Pack(a.inverse_eta_eta * on_eta))};
}
/// The force on the hourglass part of the motion.
template <class Pack>
CRUMPLE_INLINE Tangential<Pack> hourglass_force(const AssumedStrains<Pack>& a, const Pack& on_xi,
                                                const Pack& on_eta) {
  const Pack pull = multiply_add(a.inverse_xi_xi, on_xi, Pack(a.inverse_xi_eta * on_eta));
  const Pack push = multiply_add(a.inverse_xi_eta, on_xi, Pack(a.inverse_eta_eta * on_eta));
  return {multiply_add(pull, a.pull_xi.x, Pack(push * a.pull_eta.x)),
          multiply_add(pull, a.pull_xi.y, Pack(push * a.pull_eta.y))};
}

/// One of the 2 x 2 points.
template <class Pack>
struct PlanePoint {
  Pack xi, eta;                          ///< coordinates less their means over the area
  Pack area;                             ///< that the point stands for
  Tangential<Pack> along_xi, along_eta;  ///< tangents
  RealOf<Pack> place_xi, place_eta;
};
template <class Pack>
CRUMPLE_INLINE PlanePoint<Pack> plane_point(const BilinearSurface<Pack>& s, int plane) {
  using Real = RealOf<Pack>;
  PlanePoint<Pack> p;
  p.place_xi = static_cast<Real>(sign_xi[plane]) * gauss_place<Real>;
  p.place_eta = static_cast<Real>(sign_eta[plane]) * gauss_place<Real>;
  const Pack xi(p.place_xi);
  const Pack eta(p.place_eta);
  const Pack third(Real(1) / Real(3));
  p.xi = xi - third * s.taper_xi;
  p.eta = eta - third * s.taper_eta;
  p.area = s.jacobian * multiply_add(s.taper_xi, xi, multiply_add(s.taper_eta, eta, Pack(Real(1))));
  p.along_xi = {multiply_add(eta, s.twist.x, s.xi.x), multiply_add(eta, s.twist.y, s.xi.y)};
  p.along_eta = {multiply_add(xi, s.twist.x, s.eta.x), multiply_add(xi, s.twist.y, s.eta.y)};
  return p;
}

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

/// Velocity gradient at the centre, in the plane and of the normal velocity.
template <class Pack>
struct SurfaceGradient {
  Tangential<Pack> x, y, z;
};
template <class Pack>
CRUMPLE_INLINE Tangential<Pack> centre_gradient(const BilinearSurface<Pack>& s, const Pack& f_xi,
                                                const Pack& f_eta) {
  return {multiply_add(s.grad_xi.x, f_xi, Pack(s.grad_eta.x * f_eta)),
          multiply_add(s.grad_xi.y, f_xi, Pack(s.grad_eta.y * f_eta))};
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

template <class Pack>
CRUMPLE_INLINE Tensor2<Pack> strain_at(const StrainField<Pack>& f, const AssumedStrains<Pack>& a,
                                       const PlanePoint<Pack>& point) {
  return add_scaled(Pack(point.eta * f.along_xi), a.along_xi,
                    add_scaled(Pack(point.xi * f.along_eta), a.along_eta, f.centre));
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

/// Stresses integrated over the element, each against what it does work on.
template <class Pack>
struct FieldForces {
  Tensor2<Pack> centre;
  Pack along_xi, along_eta;
};
template <class Pack>
CRUMPLE_INLINE void add(FieldForces<Pack>& sum, const AssumedStrains<Pack>& a, const PlanePoint<Pack>& point,
                        const Tensor2<Pack>& stress, const Pack& share) {
  const Pack area = share * point.area;
  sum.centre = add_scaled(area, stress, sum.centre);
  sum.along_xi = multiply_add(Pack(area * point.eta), work(a.along_xi, stress), sum.along_xi);
  sum.along_eta = multiply_add(Pack(area * point.xi), work(a.along_eta, stress), sum.along_eta);
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

/// What does work on the gradients at the centre, f_xi and f_eta, of one component.
template <class Pack>
CRUMPLE_INLINE Tangential<Pack> on_gradient(const BilinearSurface<Pack>& s, const Pack& x, const Pack& y) {
  return {multiply_add(s.grad_xi.x, x, Pack(s.grad_xi.y * y)),
          multiply_add(s.grad_eta.x, x, Pack(s.grad_eta.y * y))};
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
