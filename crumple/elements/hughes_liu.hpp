// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/formulation.hpp"

namespace crumple::elements {

/// The four-node degenerated Mindlin-Reissner shell of Hughes & Liu (CMAME 26 (1981) 331-362) with one point
/// in plane: docs/theory/hughes_liu.md. A point of the shell is x = sum N_I (x_I + z y_I) with a fibre y_I at
/// each node. The fibres are found anew in every cycle, normal to the present surface (LS-DYNA's IRNXX = -1);
/// every layer has a Jacobian and a velocity gradient of its own.
struct HughesLiu {
  static constexpr model::ShellFormulation formulation = model::ShellFormulation::HughesLiu;
  static constexpr const char* name = "Hughes-Liu";
  static constexpr int planes = 1;
  static constexpr bool own_areas = true;

  static constexpr int row_r31 = 0;
  static constexpr int row_r42 = 3;
  static constexpr int row_mode = 6;
  static constexpr int row_rates = 9;
  static constexpr int rows = 14;

  template <class Pack>
  static void strains(const ShellPlace<RealOf<Pack>>& place);
  template <class Pack>
  static ShellForces<Pack> forces(const ShellPlace<RealOf<Pack>>& place);
};

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

/// Diagonals of one layer; they lie in the lamina of the reference surface.
template <class Pack>
struct Layer {
  Pack x31, y31, x42, y42;
  Pack twice_area;
};
template <class Pack>
CRUMPLE_INLINE Layer<Pack> make_layer(const LaminaGeometry<Pack>& g, const FibreTilts<Pack>& tilt,
                                      const Pack& z) {
  Layer<Pack> l;
  l.x31 = multiply_add(z, tilt.x31, g.x31);
  l.y31 = multiply_add(z, tilt.y31, g.y31);
  l.x42 = multiply_add(z, tilt.x42, g.x42);
  l.y42 = multiply_add(z, tilt.y42, g.y42);
  l.twice_area = multiply_add(l.x31, l.y42, Pack(-(l.x42 * l.y31)));
  return l;
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

/// Strain increments of one layer. The mean fibre is the normal, so that its rate is the gradient along it.
template <class Pack>
CRUMPLE_INLINE materials::PlaneStrain<Pack> layer_strain(const Layer<Pack>& l, const LaminaMotion<Pack>& m,
                                                         const Pack& z, const Pack& step,
                                                         const Pack& shear_root) {
  const auto v31 = math::multiply_add(z, m.fibre31, m.v31);
  const auto v42 = math::multiply_add(z, m.fibre42, m.v42);
  const Pack over_area = step / l.twice_area;
  const auto along_x = [&](const Pack& f31, const Pack& f42) {
    return Pack(over_area * multiply_add(l.y42, f31, Pack(-(l.y31 * f42))));
  };
  const auto along_y = [&](const Pack& f31, const Pack& f42) {
    return Pack(over_area * multiply_add(l.x31, f42, Pack(-(l.x42 * f31))));
  };
  return {along_x(v31.x, v42.x), along_y(v31.y, v42.y), along_y(v31.x, v42.x) + along_x(v31.y, v42.y),
          shear_root * multiply_add(step, m.fibre_mean.y, along_y(v31.z, v42.z)),
          shear_root * multiply_add(step, m.fibre_mean.x, along_x(v31.z, v42.z))};
}

template <class Pack>
CRUMPLE_INLINE void HughesLiu::strains(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const ShellNodes<Pack> n = gather<Pack>(place.task.nodes, place.node);
  const Pack back(-(Real(0.5) * place.task.step));
  const auto r31 = math::multiply_add(back, n.v31, n.r31);
  const auto r42 = math::multiply_add(back, n.v42, n.r42);
  const auto r_mode = math::multiply_add(back, n.v_mode, n.r_mode);
  const auto frame = lamina_frame(r31 - r42, r31 + r42, own_state<Pack>(place, element_state::frame),
                                  own_state<Pack>(place, element_state::frame + 1));
  const auto g = lamina_geometry(frame, r31, r42, r_mode);
  const Pack thickness = own_state<Pack>(place, element_state::thickness);
  const FibreTilts<Pack> tilt = fibre_tilts(g, thickness);
  const LaminaMotion<Pack> m = lamina_motion(frame, n, tilt);

  const Pack half_thickness = Real(0.5) * thickness;
  for (int p = 0; p < constants.points; ++p) {
    const Pack z = half_thickness * Pack(constants.place[p]);
    const Layer<Pack> layer = make_layer(g, tilt, z);
    const auto strain = layer_strain(layer, m, z, Pack(place.task.step), Pack(constants.shear_root));
    materials::store_five(place.strain + p * materials::components * tile_lanes, tile_lanes, strain);
    store(place.area + p * tile_lanes, Pack(Pack(Real(0.5)) * layer.twice_area));
  }

  const VelocityGradients<Pack> gradients{gradient(g, m.v31.x, m.v42.x), gradient(g, m.v31.y, m.v42.y),
                                          gradient(g, m.v31.z, m.v42.z), gradient(g, m.w31.x, m.w42.x),
                                          gradient(g, m.w31.y, m.w42.y)};
  keep_modes(place, row_rates, hourglass_rates(frame, g, n, gradients));
  keep_vec(place, row_r31, n.r31);
  keep_vec(place, row_r42, n.r42);
  keep_vec(place, row_mode, n.r_mode);
}

/// Forces that do work on the members of LaminaMotion: on the velocities over the diagonals, their first
/// moments over the thickness on the fibre rates over the diagonals, and the shear on the mean fibre rate.
template <class Pack>
struct LayerForces {
  math::PackVec3<Pack> on31, on42;
  math::PackVec3<Pack> moment31, moment42;
  math::PackVec3<Pack> on_mean;
};

template <class Pack>
CRUMPLE_INLINE void add_layer(LayerForces<Pack>& sum, const Layer<Pack>& l,
                              const materials::PlaneStress<Pack>& s, const Pack& share, const Pack& z) {
  using Vec = math::PackVec3<Pack>;
  // `share` is half the layer's thickness; the volume is share * twice_area.
  const auto on_31 = [&](const Pack& x, const Pack& y) {
    return Pack(share * multiply_add(l.y42, x, Pack(-(l.x42 * y))));
  };
  const auto on_42 = [&](const Pack& x, const Pack& y) {
    return Pack(share * multiply_add(l.x31, y, Pack(-(l.y31 * x))));
  };
  const Vec on31{on_31(s.xx, s.xy), on_31(s.xy, s.yy), on_31(s.zx, s.yz)};
  const Vec on42{on_42(s.xx, s.xy), on_42(s.xy, s.yy), on_42(s.zx, s.yz)};
  sum.on31 = sum.on31 + on31;
  sum.on42 = sum.on42 + on42;
  sum.moment31 = math::multiply_add(z, on31, sum.moment31);
  sum.moment42 = math::multiply_add(z, on42, sum.moment42);
  const Pack volume = share * l.twice_area;
  sum.on_mean.x = multiply_add(volume, s.zx, sum.on_mean.x);
  sum.on_mean.y = multiply_add(volume, s.yz, sum.on_mean.y);
}

/// `thickness` is that of the forces: zero for elements that are not active.
template <class Pack>
CRUMPLE_INLINE LayerForces<Pack> integrate_layers(const ShellPlace<RealOf<Pack>>& place,
                                                  const LaminaGeometry<Pack>& g, const FibreTilts<Pack>& tilt,
                                                  const Pack& thickness) {
  using Real = RealOf<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const Pack half_thickness = Real(0.5) * own_state<Pack>(place, element_state::thickness);
  const Pack root(constants.shear_root);
  const Pack zero(Real(0));
  const math::PackVec3<Pack> none{zero, zero, zero};
  LayerForces<Pack> sum{none, none, none, none, none};
  for (int p = 0; p < constants.points; ++p) {
    const Pack z = half_thickness * Pack(constants.place[p]);
    auto stress = materials::load_five<materials::PlaneStress<Pack>>(
        place.state + p * materials::components * lanes, lanes);
    stress.yz = root * stress.yz;
    stress.zx = root * stress.zx;
    add_layer(sum, make_layer(g, tilt, z), stress, Pack(thickness * Pack(Real(0.5) * constants.weight[p])),
              z);
  }
  return sum;
}

template <class Pack>
CRUMPLE_INLINE ShellForces<Pack> HughesLiu::forces(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  const Vec r31 = kept_vec<Pack>(place, row_r31);
  const Vec r42 = kept_vec<Pack>(place, row_r42);
  const Vec r_mode = kept_vec<Pack>(place, row_mode);
  const auto frame = lamina_frame<Pack>(r31 - r42, r31 + r42, own_state<Pack>(place, element_state::frame),
                                        own_state<Pack>(place, element_state::frame + 1));
  const auto g = lamina_geometry(frame, r31, r42, r_mode);
  const Pack active = own_state<Pack>(place, element_state::active);

  const Pack mean_thickness = update_thickness<Pack>(place);
  const Pack full_thickness = own_state<Pack>(place, element_state::thickness);
  const Pack thickness = active * full_thickness;
  const auto energy = sum_over_planes<Pack>(place, scratch_row::material_energy);
  store(place.rows + scratch_row::internal_energy * tile_lanes, Pack(energy * (active * mean_thickness)));

  const FibreTilts<Pack> tilt = fibre_tilts(g, full_thickness);
  LayerForces<Pack> layers = integrate_layers(place, g, tilt, thickness);
  const auto q = update_hourglass(place, g, thickness, kept_modes<Pack>(place, row_rates));
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
  limit_step(place, g, r31, r42, r_mode);
  return out;
}

}  // namespace crumple::elements
