// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/bilinear_shell.hpp"

namespace crumple::elements {

/// Hughes & Liu's degenerated shell (CMAME 26 (1981) 331-362), selectively reduced: 2 x 2 points in plane for
/// membrane and bending, layer by layer, and the transverse shear of each layer from the centre alone. Fibres
/// as in HughesLiu. One hourglass mode is left, the warping. docs/theory/hughes_liu_selective.md.
struct HughesLiuSelective {
  static constexpr model::ShellFormulation formulation = model::ShellFormulation::HughesLiuSelectiveReduced;
  static constexpr const char* name = "Hughes-Liu selectively reduced";
  static constexpr int planes = 4;
  static constexpr bool own_areas = true;

  static constexpr int row_rate = 0;
  static constexpr int row_drilling = 1;
  static constexpr int rows = 4;

  template <class Pack>
  static void strains(const ShellPlace<RealOf<Pack>>& place);
  template <class Pack>
  static ShellForces<Pack> forces(const ShellPlace<RealOf<Pack>>& place);
};

/// The surface with fibres that leave every layer at least 0.73 of the area at the centre: the tangents of
/// an element warped and thick beyond reason would turn over.
template <class Pack>
CRUMPLE_INLINE BilinearSurface<Pack> layered_surface(const ElementShape<Pack>& shape, const Pack& thickness) {
  BilinearSurface<Pack> s = bilinear_surface(shape);
  const Pack most = (RealOf<Pack>(0.5) * s.jacobian) / (thickness * sum_of_squares(s));
  set_fibres(s, smaller(largest_tilt(s), most));
  return s;
}

/// Tangents of one layer at one point; the Jacobian is that of their projection on the lamina, held at a
/// tenth of the reference surface's at the centre for re-entrant elements.
template <class Pack>
struct LayerPoint {
  using Vec = math::PackVec3<Pack>;
  Vec xi, eta;
  Pack area;
};
template <class Pack>
CRUMPLE_INLINE LayerPoint<Pack> layer_point(const BilinearSurface<Pack>& s, const Pack& z, const Pack& xi,
                                            const Pack& eta) {
  LayerPoint<Pack> p;
  p.xi = math::multiply_add(eta, s.twist, math::multiply_add(z, s.fibre_xi, s.xi));
  p.eta = math::multiply_add(xi, s.twist, math::multiply_add(z, s.fibre_eta, s.eta));
  const Pack area = multiply_add(p.xi.x, p.eta.y, Pack(-(p.eta.x * p.xi.y)));
  p.area = larger(area, Pack(RealOf<Pack>(0.1) * s.jacobian));
  return p;
}

/// Strain rates in the plane. Stretches and shear of the tangents are exact for any turn of a warped element;
/// then they are taken to the lamina's axes.
template <class Pack>
CRUMPLE_INLINE materials::PlaneStrain<Pack> strain_of_tangents(const LayerPoint<Pack>& p,
                                                               const math::PackVec3<Pack>& v_xi,
                                                               const math::PackVec3<Pack>& v_eta) {
  using Real = RealOf<Pack>;
  const Pack zero(Real(0));
  const Pack over = Pack(Real(1)) / p.area;
  const Pack stretch_xi = over * math::dot(p.xi, v_xi);
  const Pack stretch_eta = over * math::dot(p.eta, v_eta);
  const Pack shear = over * (math::dot(p.xi, v_eta) + math::dot(p.eta, v_xi));
  const auto pair = [&](const Pack& a, const Pack& b, const Pack& c) {
    return Pack(over * multiply_add(a, stretch_xi, multiply_add(b, stretch_eta, Pack(c * shear))));
  };
  const Pack crossed = multiply_add(p.xi.x, p.eta.y, Pack(p.xi.y * p.eta.x));
  return {pair(p.eta.y * p.eta.y, p.xi.y * p.xi.y, -(p.xi.y * p.eta.y)),
          pair(p.eta.x * p.eta.x, p.xi.x * p.xi.x, -(p.xi.x * p.eta.x)),
          pair(-(Real(2) * (p.eta.x * p.eta.y)), -(Real(2) * (p.xi.x * p.xi.y)), crossed), zero, zero};
}

/// The transverse shear of a layer at the centre, where the mean fibre is the normal.
template <class Pack>
CRUMPLE_INLINE Tangential<Pack> centre_shear(const LayerPoint<Pack>& p, const Bilinear<Pack>& v,
                                             const Bilinear<Pack>& b, const Pack& z) {
  const Pack over = Pack(RealOf<Pack>(1)) / p.area;
  const Pack xi = multiply_add(z, b.xi.z, v.xi.z);
  const Pack eta = multiply_add(z, b.eta.z, v.eta.z);
  return {multiply_add(over, multiply_add(p.eta.y, xi, Pack(-(p.xi.y * eta))), b.mean.x),
          multiply_add(over, multiply_add(p.xi.x, eta, Pack(-(p.eta.x * xi))), b.mean.y)};
}

/// The warping pattern of the normal velocity, less what its gradient at the centre and the twist of the
/// fibres explain: so control does not feel a twist of the plate with its normals.
template <class Pack>
CRUMPLE_INLINE Pack warping_rate(const BilinearSurface<Pack>& s, const Bilinear<Pack>& v,
                                 const Bilinear<Pack>& b) {
  using Real = RealOf<Pack>;
  const Pack along_xi = multiply_add(s.grad_xi.x, s.twist.x, Pack(s.grad_xi.y * s.twist.y));
  const Pack along_eta = multiply_add(s.grad_eta.x, s.twist.x, Pack(s.grad_eta.y * s.twist.y));
  const Pack gradient = multiply_add(along_xi, v.xi.z, Pack(along_eta * v.eta.z));
  const Pack twist = math::dot(s.xi, b.eta) + math::dot(s.eta, b.xi);
  return Pack(Real(4)) * ((v.twist.z - gradient) + Pack(Real(0.5)) * twist);
}

template <class Pack>
CRUMPLE_INLINE void HughesLiuSelective::strains(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const ShellNodes<Pack> n = gathered<Pack>(place).all();
  const ElementShape<Pack> shape = middle_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const Pack thickness = own_state<Pack>(place, element_state::thickness);
  const BilinearSurface<Pack> s = layered_surface(shape, thickness);
  const Pack zero(Real(0));
  const Bilinear<Pack> v = bilinear(frame, n.v31, n.v42, n.v_mode, math::PackVec3<Pack>{zero, zero, zero});
  const Bilinear<Pack> w = bilinear(frame, n.w31, n.w42, n.w_mode, n.w_sum);
  const Bilinear<Pack> b = fibre_rates(s, w);

  const Pack step(place.task.step);
  const Pack shear_step = step * Pack(constants.shear_root);
  const Pack half_thickness = Real(0.5) * thickness;
  for (int p = 0; p < constants.points; ++p) {
    const Pack z = half_thickness * Pack(constants.place[p]);
    const Tangential<Pack> shear = centre_shear(layer_point(s, z, zero, zero), v, b, z);
    const auto v_xi = math::multiply_add(z, b.xi, v.xi);
    const auto v_eta = math::multiply_add(z, b.eta, v.eta);
    const auto v_twist = math::multiply_add(z, b.twist, v.twist);
    for (int plane = 0; plane < planes; ++plane) {
      const Pack xi(static_cast<Real>(sign_xi[plane]) * gauss_place<Real>);
      const Pack eta(static_cast<Real>(sign_eta[plane]) * gauss_place<Real>);
      const LayerPoint<Pack> point = layer_point(s, z, xi, eta);
      const auto rate = strain_of_tangents(point, math::multiply_add(eta, v_twist, v_xi),
                                           math::multiply_add(xi, v_twist, v_eta));
      const int at = plane * constants.points + p;
      materials::store_five(place.strain + at * materials::components * tile_lanes, tile_lanes,
                            materials::PlaneStrain<Pack>{step * rate.xx, step * rate.yy, step * rate.xy,
                                                         shear_step * shear.y, shear_step * shear.x});
      store(place.area + at * tile_lanes, point.area);
    }
  }
  keep(place, row_rate, warping_rate(s, v, b));
  keep_vec(place, row_drilling, math::PackVec3<Pack>{w.xi.z, w.eta.z, w.twist.z});
}

/// Forces on the coefficients of the velocities and of the fibre rates.
template <class Pack>
struct LayeredForces {
  Bilinear<Pack> on_velocity, on_fibre;
};

/// Adds one point of one layer; `share` is the layer's thickness. Returns shear stresses times volume.
template <class Pack>
CRUMPLE_INLINE Tangential<Pack> add_point(Bilinear<Pack>& sum, const LayerPoint<Pack>& p,
                                          const materials::PlaneStress<Pack>& stress, const Pack& share,
                                          const Pack& xi, const Pack& eta) {
  using Real = RealOf<Pack>;
  const Pack scale = share / p.area;
  const auto pull = [&](const Pack& a, const Pack& b, const Pack& c) {
    return Pack(scale * multiply_add(a, stress.xx, multiply_add(b, stress.yy, Pack(c * stress.xy))));
  };
  const Pack crossed = multiply_add(p.xi.x, p.eta.y, Pack(p.xi.y * p.eta.x));
  const Pack pull_xi = pull(p.eta.y * p.eta.y, p.eta.x * p.eta.x, -(Real(2) * (p.eta.x * p.eta.y)));
  const Pack pull_eta = pull(p.xi.y * p.xi.y, p.xi.x * p.xi.x, -(Real(2) * (p.xi.x * p.xi.y)));
  const Pack shear = pull(-(p.xi.y * p.eta.y), -(p.xi.x * p.eta.x), crossed);
  const auto on_xi = math::multiply_add(pull_xi, p.xi, shear * p.eta);
  const auto on_eta = math::multiply_add(pull_eta, p.eta, shear * p.xi);
  sum.xi = sum.xi + on_xi;
  sum.eta = sum.eta + on_eta;
  sum.twist = math::multiply_add(eta, on_xi, math::multiply_add(xi, on_eta, sum.twist));
  const Pack volume = share * p.area;
  return {volume * stress.zx, volume * stress.yz};
}

/// Adds a layer's transverse shear, forces times length, at the centre.
template <class Pack>
CRUMPLE_INLINE void add_shear(Bilinear<Pack>& layer, math::PackVec3<Pack>& on_mean, const LayerPoint<Pack>& p,
                              const Tangential<Pack>& shear) {
  const Pack over = Pack(RealOf<Pack>(1)) / p.area;
  on_mean.x = on_mean.x + shear.x;
  on_mean.y = on_mean.y + shear.y;
  layer.xi.z = multiply_add(over, multiply_add(p.eta.y, shear.x, Pack(-(p.eta.x * shear.y))), layer.xi.z);
  layer.eta.z = multiply_add(over, multiply_add(p.xi.x, shear.y, Pack(-(p.xi.y * shear.x))), layer.eta.z);
}

/// `thickness` is that of the forces: zero for elements that are not active.
template <class Pack>
CRUMPLE_INLINE LayeredForces<Pack> layered_forces(const ShellPlace<RealOf<Pack>>& place,
                                                  const BilinearSurface<Pack>& s, const Pack& thickness) {
  using Real = RealOf<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const Pack half_thickness = Real(0.5) * own_state<Pack>(place, element_state::thickness);
  const Pack zero(Real(0));
  const math::PackVec3<Pack> none{zero, zero, zero};
  const Bilinear<Pack> nothing{none, none, none, none};
  LayeredForces<Pack> sum{nothing, nothing};
  for (int p = 0; p < constants.points; ++p) {
    const Pack z = half_thickness * Pack(constants.place[p]);
    const Pack share = thickness * Pack(constants.weight[p]);
    Bilinear<Pack> layer = nothing;
    Tangential<Pack> shear{zero, zero};
    for (int plane = 0; plane < HughesLiuSelective::planes; ++plane) {
      const Pack xi(static_cast<Real>(sign_xi[plane]) * gauss_place<Real>);
      const Pack eta(static_cast<Real>(sign_eta[plane]) * gauss_place<Real>);
      const auto stress = materials::load_five<materials::PlaneStress<Pack>>(
          place.state + (plane * constants.points + p) * materials::components * lanes, lanes);
      const auto part = add_point(layer, layer_point(s, z, xi, eta), stress, share, xi, eta);
      shear = {shear.x + part.x, shear.y + part.y};
    }
    const Pack root(constants.shear_root);
    add_shear(layer, sum.on_fibre.mean, layer_point(s, z, zero, zero),
              Tangential<Pack>{root * shear.x, root * shear.y});
    sum.on_velocity = {none, sum.on_velocity.xi + layer.xi, sum.on_velocity.eta + layer.eta,
                       sum.on_velocity.twist + layer.twist};
    sum.on_fibre = {sum.on_fibre.mean, math::multiply_add(z, layer.xi, sum.on_fibre.xi),
                    math::multiply_add(z, layer.eta, sum.on_fibre.eta),
                    math::multiply_add(z, layer.twist, sum.on_fibre.twist)};
  }
  return sum;
}

/// Adds the warping control: `force` is its generalised stress.
template <class Pack>
CRUMPLE_INLINE void add_warping(LayeredForces<Pack>& sum, const BilinearSurface<Pack>& s, const Pack& force) {
  using Real = RealOf<Pack>;
  const Pack four = Pack(Real(4)) * force;
  const Pack two = Pack(Real(2)) * force;
  const Pack along_xi = multiply_add(s.grad_xi.x, s.twist.x, Pack(s.grad_xi.y * s.twist.y));
  const Pack along_eta = multiply_add(s.grad_eta.x, s.twist.x, Pack(s.grad_eta.y * s.twist.y));
  sum.on_velocity.twist.z = sum.on_velocity.twist.z + four;
  sum.on_velocity.xi.z = sum.on_velocity.xi.z - four * along_xi;
  sum.on_velocity.eta.z = sum.on_velocity.eta.z - four * along_eta;
  sum.on_fibre.eta = math::multiply_add(two, s.xi, sum.on_fibre.eta);
  sum.on_fibre.xi = math::multiply_add(two, s.eta, sum.on_fibre.xi);
}

/// The smaller of the outer layers' Jacobians at the centre and the reference surface's: the tangents of that
/// layer are shortest.
template <class Pack>
CRUMPLE_INLINE Pack smallest_layer(const ShellPlace<RealOf<Pack>>& place, const BilinearSurface<Pack>& s,
                                   const Pack& thickness) {
  using Real = RealOf<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const Pack zero(Real(0));
  const Pack half = Real(0.5) * thickness;
  const auto area_of = [&](Real at) { return layer_point(s, Pack(half * Pack(at)), zero, zero).area; };
  return smaller(s.jacobian,
                 smaller(area_of(constants.place[0]), area_of(constants.place[constants.points - 1])));
}

template <class Pack>
CRUMPLE_INLINE ShellForces<Pack> HughesLiuSelective::forces(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  const ElementShape<Pack> shape = end_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const auto g = lamina_geometry(shape);
  const Pack active = own_state<Pack>(place, element_state::active);

  const Pack mean_thickness = update_thickness<Pack>(place);
  const Pack full_thickness = own_state<Pack>(place, element_state::thickness);
  const Pack thickness = active * full_thickness;
  const BilinearSurface<Pack> s = layered_surface(shape, full_thickness);
  leave_internal_energy(place, Pack(active * mean_thickness));

  const Pack zero(Real(0));
  const Vec drilling = kept_vec<Pack>(place, row_drilling);
  const HourglassModes<Pack> rate{drilling.x, drilling.y, kept<Pack>(place, row_rate), drilling.z, zero};
  const ShellConstants<Real>& constants = place.task.constants;
  const auto warping = hourglass_stress(constants, hourglass_moduli(constants, g, thickness),
                                        Pack(place.task.step), hourglass_state<Pack>(place), rate);
  const auto q = update_drilling(place, thickness, rate, warping.z);
  LayeredForces<Pack> sum = layered_forces(place, s, thickness);
  add_warping(sum, s, q.z);
  ShellForces<Pack> out;
  to_nodes(frame, sum.on_velocity, out.force);
  to_nodes(frame, with_drilling(fibre_moments(s, sum.on_fibre), q), out.moment);
  limit_step(place, Pack(Real(4) * smallest_layer(place, s, full_thickness)), shape);
  return out;
}

}  // namespace crumple::elements
