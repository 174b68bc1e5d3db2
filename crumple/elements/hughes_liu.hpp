// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/formulation.hpp"

namespace crumple::elements {

/// The four-node degenerated Mindlin-Reissner shell of Hughes & Liu (CMAME 26 (1981) 331-362) with one point
/// in plane: docs/theory/hughes_liu.md. A point of the shell is x = sum N_I (x_I + z y_I) with a unit fibre
/// y_I at each node, which the element owns and which turns with the node; every layer has a lamina, a
/// Jacobian and a velocity gradient of its own.
struct HughesLiu {
  static constexpr model::ShellFormulation formulation = model::ShellFormulation::HughesLiu;
  static constexpr const char* name = "Hughes-Liu";
  static constexpr bool has_fibres = true;
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

/// The four fibres of an element.
template <class Pack>
struct Fibres {
  math::PackVec3<Pack> node[4];

  CRUMPLE_INLINE math::PackVec3<Pack> difference31() const { return node[2] - node[0]; }
  CRUMPLE_INLINE math::PackVec3<Pack> difference42() const { return node[3] - node[1]; }
  CRUMPLE_INLINE math::PackVec3<Pack> mean() const {
    return Pack(RealOf<Pack>(0.25)) * ((node[0] + node[1]) + (node[2] + node[3]));
  }
};

template <class Pack>
CRUMPLE_INLINE Fibres<Pack> load_fibres(const ShellPlace<RealOf<Pack>>& place) {
  Fibres<Pack> fibres;
  for (int k = 0; k < 4; ++k) {
    const Index item = element_state::fibre + 3 * k;
    fibres.node[k] = {own_state<Pack>(place, item), own_state<Pack>(place, item + 1),
                      own_state<Pack>(place, item + 2)};
  }
  return fibres;
}

template <class Pack>
CRUMPLE_INLINE void store_fibre(const ShellPlace<RealOf<Pack>>& place, int node,
                                const math::PackVec3<Pack>& fibre) {
  RealOf<Pack>* const to = place.state + (place.task.constants.own + element_state::fibre + 3 * node) * lanes;
  store(to, fibre.x);
  store(to + lanes, fibre.y);
  store(to + 2 * lanes, fibre.z);
}

/// Turns the fibres of the state to time n by Hughes and Winget's rotation (IJNME 15 (1980) 1862-1867),
/// y' - y = dt w x (y' + y) / 2. Leaves the fibres of the middle of the step and their rates w x y there.
template <class Pack>
CRUMPLE_INLINE void turn_fibres(const ShellPlace<RealOf<Pack>>& place, const ShellNodes<Pack>& n,
                                Fibres<Pack>& middle, Fibres<Pack>& rate) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  const Pack half(Real(0.5));
  const Pack half_step(Real(0.5) * place.task.step);
  const Vec twice13 = half * (n.w_sum + n.w_mode);  // angular velocities of nodes 1 and 3, summed
  const Vec twice24 = half * (n.w_sum - n.w_mode);
  const Vec spin[4] = {half * (twice13 - n.w31), half * (twice24 - n.w42), half * (twice13 + n.w31),
                       half * (twice24 + n.w42)};
  const Fibres<Pack> old = load_fibres<Pack>(place);
  for (int k = 0; k < 4; ++k) {
    const Vec turn = half_step * spin[k];
    const Vec& y = old.node[k];
    const Pack over = Pack(Real(1)) / (Pack(Real(1)) + math::dot(turn, turn));
    middle.node[k] = over * math::multiply_add(math::dot(turn, y), turn, y + math::cross(turn, y));
    rate.node[k] = math::cross(spin[k], middle.node[k]);
    const Vec now = math::multiply_add(Pack(place.task.step), rate.node[k], y);
    // One Newton step back to unit length: round-off, not theory.
    const Pack unit = multiply_add(Pack(-half), math::dot(now, now), Pack(Real(1.5)));
    store_fibre(place, k, unit * now);
  }
}

/// Lamina axes of one layer and its base vectors in them: r31 and r42 of the layer lie in the lamina, the
/// mean fibre points out of it.
template <class Pack>
struct Layer {
  LaminaFrame<Pack> frame;
  Pack x31, y31, x42, y42;
  Pack fibre_x, fibre_y, fibre_z;
  Pack twice_area;
};
template <class Pack>
CRUMPLE_INLINE Layer<Pack> make_layer(const ShellPlace<RealOf<Pack>>& place, const math::PackVec3<Pack>& r31,
                                      const math::PackVec3<Pack>& r42, const math::PackVec3<Pack>& fibre) {
  Layer<Pack> l;
  l.frame = lamina_frame<Pack>(r31 - r42, r31 + r42, own_state<Pack>(place, element_state::frame),
                               own_state<Pack>(place, element_state::frame + 1));
  l.x31 = math::dot(r31, l.frame.e1);
  l.y31 = math::dot(r31, l.frame.e2);
  l.x42 = math::dot(r42, l.frame.e1);
  l.y42 = math::dot(r42, l.frame.e2);
  l.fibre_x = math::dot(fibre, l.frame.e1);
  l.fibre_y = math::dot(fibre, l.frame.e2);
  l.fibre_z = math::dot(fibre, l.frame.e3);
  l.twice_area = multiply_add(l.x31, l.y42, Pack(-(l.x42 * l.y31)));
  return l;
}

/// Strain increments of one layer from the velocities over its diagonals and along its fibre.
template <class Pack>
CRUMPLE_INLINE materials::PlaneStrain<Pack> layer_strain(const Layer<Pack>& l,
                                                         const math::PackVec3<Pack>& v31,
                                                         const math::PackVec3<Pack>& v42,
                                                         const math::PackVec3<Pack>& v_fibre,
                                                         const Pack& step, const Pack& shear_root) {
  const Pack over_area = step / l.twice_area;
  const auto along = [&](const math::PackVec3<Pack>& axis, Pack& x, Pack& y) {
    const Pack f31 = math::dot(v31, axis);
    const Pack f42 = math::dot(v42, axis);
    x = over_area * multiply_add(l.y42, f31, Pack(-(l.y31 * f42)));
    y = over_area * multiply_add(l.x31, f42, Pack(-(l.x42 * f31)));
  };
  Pack xx, xy, yx, yy, zx, zy;
  along(l.frame.e1, xx, xy);
  along(l.frame.e2, yx, yy);
  along(l.frame.e3, zx, zy);
  // The gradient along the normal is what the rate along the fibre leaves after its in-plane part.
  const auto through = [&](const math::PackVec3<Pack>& axis, const Pack& x, const Pack& y) {
    const Pack in_plane = multiply_add(x, l.fibre_x, Pack(y * l.fibre_y));
    return (step * math::dot(v_fibre, axis) - in_plane) / l.fibre_z;
  };
  const Pack xz = through(l.frame.e1, xx, xy);
  const Pack yz = through(l.frame.e2, yx, yy);
  return {xx, yy, xy + yx, shear_root * (yz + zy), shear_root * (zx + xz)};
}

template <class Pack>
CRUMPLE_INLINE void HughesLiu::strains(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const ShellNodes<Pack> n = gather<Pack>(place.task.nodes, place.node);
  const Pack back(-(Real(0.5) * place.task.step));
  const Vec r31 = math::multiply_add(back, n.v31, n.r31);
  const Vec r42 = math::multiply_add(back, n.v42, n.r42);
  const Vec r_mode = math::multiply_add(back, n.v_mode, n.r_mode);
  Fibres<Pack> fibre;
  Fibres<Pack> rate;
  turn_fibres(place, n, fibre, rate);

  const Vec fibre31 = fibre.difference31();
  const Vec fibre42 = fibre.difference42();
  const Vec fibre_mean = fibre.mean();
  const Vec rate31 = rate.difference31();
  const Vec rate42 = rate.difference42();
  const Vec rate_mean = rate.mean();
  const Pack half_thickness = Pack(Real(0.5)) * own_state<Pack>(place, element_state::thickness);
  const Pack step(place.task.step);
  for (int p = 0; p < constants.points; ++p) {
    const Pack z = half_thickness * Pack(constants.place[p]);
    const Layer<Pack> layer = make_layer(place, math::multiply_add(z, fibre31, r31),
                                         math::multiply_add(z, fibre42, r42), fibre_mean);
    const auto strain =
        layer_strain(layer, math::multiply_add(z, rate31, n.v31), math::multiply_add(z, rate42, n.v42),
                     rate_mean, step, Pack(constants.shear_root));
    materials::store_five(place.strain + p * materials::components * tile_lanes, tile_lanes, strain);
    store(place.area + p * tile_lanes, Pack(Pack(Real(0.5)) * (layer.twice_area * layer.fibre_z)));
  }

  const auto frame = lamina_frame<Pack>(r31 - r42, r31 + r42, own_state<Pack>(place, element_state::frame),
                                        own_state<Pack>(place, element_state::frame + 1));
  const auto g = lamina_geometry(frame, r31, r42, r_mode);
  const auto velocity = [&](const Vec& axis) {
    return gradient(g, math::dot(n.v31, axis), math::dot(n.v42, axis));
  };
  const auto spin = [&](const Vec& axis) {
    return gradient(g, math::dot(n.w31, axis), math::dot(n.w42, axis));
  };
  const VelocityGradients<Pack> gradients{velocity(frame.e1), velocity(frame.e2), velocity(frame.e3),
                                          spin(frame.e1), spin(frame.e2)};
  keep_modes(place, row_rates, hourglass_rates(frame, g, n, gradients));
  keep_vec(place, row_r31, n.r31);
  keep_vec(place, row_r42, n.r42);
  keep_vec(place, row_mode, n.r_mode);
}

/// Forces that do work on the velocities over the diagonals and along the fibre, and the first moments of
/// the former over the thickness, which do work on the differences of the fibre rates.
template <class Pack>
struct LayerForces {
  math::PackVec3<Pack> on31, on42, on_fibre;
  math::PackVec3<Pack> moment31, moment42;
};

template <class Pack>
CRUMPLE_INLINE void add_layer(LayerForces<Pack>& sum, const Layer<Pack>& l,
                              const materials::PlaneStress<Pack>& s, const Pack& share, const Pack& z) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  // `share` is half the layer's thickness; the volume is share * twice_area * fibre_z.
  const auto conjugate = [&](const Pack& on_x, const Pack& on_y, const Pack& on_z, Pack& f31, Pack& f42) {
    const Pack x = multiply_add(l.fibre_z, on_x, Pack(-(l.fibre_x * on_z)));
    const Pack y = multiply_add(l.fibre_z, on_y, Pack(-(l.fibre_y * on_z)));
    f31 = share * multiply_add(l.y42, x, Pack(-(l.x42 * y)));
    f42 = share * multiply_add(l.x31, y, Pack(-(l.y31 * x)));
  };
  Pack x31, x42, y31, y42, z31, z42;
  conjugate(s.xx, s.xy, s.zx, x31, x42);
  conjugate(s.xy, s.yy, s.yz, y31, y42);
  conjugate(s.zx, s.yz, Pack(Real(0)), z31, z42);
  const auto global = [&](const Pack& x, const Pack& y, const Pack& z_part) {
    return math::multiply_add(x, l.frame.e1, math::multiply_add(y, l.frame.e2, z_part * l.frame.e3));
  };
  const Vec on31 = global(x31, y31, z31);
  const Vec on42 = global(x42, y42, z42);
  const Pack shear = share * l.twice_area;
  const Vec on_fibre = math::multiply_add(Pack(shear * s.zx), l.frame.e1, Pack(shear * s.yz) * l.frame.e2);
  sum.on31 = sum.on31 + on31;
  sum.on42 = sum.on42 + on42;
  sum.on_fibre = sum.on_fibre + on_fibre;
  sum.moment31 = math::multiply_add(z, on31, sum.moment31);
  sum.moment42 = math::multiply_add(z, on42, sum.moment42);
}

template <class Pack>
CRUMPLE_INLINE LayerForces<Pack> integrate_layers(const ShellPlace<RealOf<Pack>>& place,
                                                  const math::PackVec3<Pack>& r31,
                                                  const math::PackVec3<Pack>& r42, const Fibres<Pack>& fibre,
                                                  const Pack& thickness) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const Vec fibre31 = fibre.difference31();
  const Vec fibre42 = fibre.difference42();
  const Vec mean = fibre.mean();
  const Pack half_thickness = Pack(Real(0.5)) * own_state<Pack>(place, element_state::thickness);
  const Pack root(constants.shear_root);
  const Pack zero(Real(0));
  const Vec none{zero, zero, zero};
  LayerForces<Pack> sum{none, none, none, none, none};
  for (int p = 0; p < constants.points; ++p) {
    const Pack z = half_thickness * Pack(constants.place[p]);
    const Layer<Pack> layer =
        make_layer(place, math::multiply_add(z, fibre31, r31), math::multiply_add(z, fibre42, r42), mean);
    auto stress = materials::load_five<materials::PlaneStress<Pack>>(
        place.state + p * materials::components * lanes, lanes);
    stress.yz = root * stress.yz;
    stress.zx = root * stress.zx;
    add_layer(sum, layer, stress, Pack(thickness * Pack(Real(0.5) * constants.weight[p])), z);
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
  const Fibres<Pack> fibre = load_fibres<Pack>(place);
  const Pack active = own_state<Pack>(place, element_state::active);

  const Pack mean_thickness = update_thickness<Pack>(place);
  const Pack thickness = active * own_state<Pack>(place, element_state::thickness);
  const auto energy = load<Pack>(place.rows + scratch_row::material_energy * tile_lanes);
  store(place.rows + scratch_row::internal_energy * tile_lanes, Pack(energy * (active * mean_thickness)));

  const LayerForces<Pack> layers = integrate_layers(place, r31, r42, fibre, thickness);
  const auto frame = lamina_frame<Pack>(r31 - r42, r31 + r42, own_state<Pack>(place, element_state::frame),
                                        own_state<Pack>(place, element_state::frame + 1));
  const auto g = lamina_geometry(frame, r31, r42, r_mode);
  const auto q = update_hourglass(place, g, thickness, kept_modes<Pack>(place, row_rates));
  // What the warp takes out of the membrane rates, the forces take out of the moments.
  const Pack lift = g.inverse_twice_area * g.z_mode;
  const Pack lift_x = lift * q.x;
  const Pack lift_y = lift * q.y;
  const Vec on31 =
      math::multiply_add(multiply_add(g.y42, lift_x, Pack(-(g.x42 * lift_y))), frame.e3, layers.on31);
  const Vec on42 =
      math::multiply_add(multiply_add(g.x31, lift_y, Pack(-(g.y31 * lift_x))), frame.e3, layers.on42);
  const Vec force_q = math::multiply_add(q.x, frame.e1, math::multiply_add(q.y, frame.e2, q.z * frame.e3));
  const Vec moment_q = math::multiply_add(q.bending_x, frame.e1, q.bending_y * frame.e2);

  const Pack minus(Real(-1));
  const Vec quarter = Pack(Real(0.25)) * layers.on_fibre;
  const Vec force[4] = {minus * on31, minus * on42, on31, on42};
  const Vec on_fibre[4] = {quarter - layers.moment31, quarter - layers.moment42, quarter + layers.moment31,
                           quarter + layers.moment42};
  const HourglassVector<Pack> gamma = hourglass_vector(g);
  ShellForces<Pack> out;
  for (int k = 0; k < 4; ++k) {
    out.force[k] = math::multiply_add(gamma.node[k], force_q, force[k]);
    out.moment[k] = math::multiply_add(gamma.node[k], moment_q, math::cross(fibre.node[k], on_fibre[k]));
  }
  limit_step(place, g, r31, r42, r_mode);
  return out;
}

}  // namespace crumple::elements
