// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/fibres.hpp"

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

  static constexpr int row_rates = 0;
  static constexpr int rows = 5;

  template <class Pack>
  static void strains(const ShellPlace<RealOf<Pack>>& place);
  template <class Pack>
  static ShellForces<Pack> forces(const ShellPlace<RealOf<Pack>>& place);
};

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
  const ShellNodes<Pack> n = gathered<Pack>(place).all();
  const ElementShape<Pack> shape = middle_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const auto g = lamina_geometry(shape);
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
  keep_modes(place, row_rates, hourglass_rates(frame, g, n.v_mode, n.w_mode, gradients));
}

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
  const ElementShape<Pack> shape = end_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const auto g = lamina_geometry(shape);
  const Pack active = own_state<Pack>(place, element_state::active);

  const Pack mean_thickness = update_thickness<Pack>(place);
  const Pack full_thickness = own_state<Pack>(place, element_state::thickness);
  const Pack thickness = active * full_thickness;
  leave_internal_energy(place, Pack(active * mean_thickness));

  const FibreTilts<Pack> tilt = fibre_tilts(g, full_thickness);
  const LayerForces<Pack> layers = integrate_layers(place, g, tilt, thickness);
  const auto q = update_hourglass(place, g, thickness, kept_modes<Pack>(place, row_rates));
  limit_step(place, g.area, shape);
  return fibre_forces(frame, g, tilt, layers, q);
}

}  // namespace crumple::elements
