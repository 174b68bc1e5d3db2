// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/fibres.hpp"
#include "elements/shell/resultants.hpp"

namespace crumple::elements {

/// Belytschko-Tsay with the warp's coupling of membrane and curvature and the projected transverse shear of
/// Belytschko, Wong & Chiang (CMAME 96 (1992) 93-107): docs/theory/belytschko_wong_chiang.md.
struct BelytschkoWongChiang {
  static constexpr model::ShellFormulation formulation = model::ShellFormulation::BelytschkoWongChiang;
  static constexpr const char* name = "Belytschko-Wong-Chiang";
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

/// Rates of the curvature: first order in z of the gradient over the layer at z, its sides x + z p moving
/// with v + z dp/dt.
template <class Pack>
CRUMPLE_INLINE Bending<Pack> curvature_rates(const LaminaGeometry<Pack>& g, const FibreTilts<Pack>& tilt,
                                             const LaminaMotion<Pack>& m) {
  const auto fibre_x = gradient(g, m.fibre31.x, m.fibre42.x);
  const auto fibre_y = gradient(g, m.fibre31.y, m.fibre42.y);
  const auto coupled = [&](const Pack& f31, const Pack& f42) {
    return CentreGradient<Pack>{g.inverse_twice_area * multiply_add(tilt.y42, f31, Pack(-(tilt.y31 * f42))),
                                g.inverse_twice_area * multiply_add(tilt.x31, f42, Pack(-(tilt.x42 * f31)))};
  };
  const auto vx = coupled(m.v31.x, m.v42.x);
  const auto vy = coupled(m.v31.y, m.v42.y);
  return {fibre_x.x + vx.x, fibre_y.y + vy.y, (fibre_x.y + vx.y) + (fibre_y.x + vy.x)};
}

/// Transverse shear from its projection on the four sides: along a side it is the mean fibre rate of the ends
/// along the side and the slope against the mean fibre. Opposite sides are averaged; over the diagonals that
/// is the slope and the mean fibre rate of Belytschko & Tsay and what the element's taper and warp add.
template <class Pack>
CRUMPLE_INLINE CentreGradient<Pack> projected_shear(const LaminaGeometry<Pack>& g,
                                                    const FibreTilts<Pack>& tilt, const LaminaMotion<Pack>& m,
                                                    const math::PackVec3<Pack>& v_mode) {
  using Vec = math::PackVec3<Pack>;
  const Pack quarter(RealOf<Pack>(0.25));
  const Vec mode{g.x_mode, g.y_mode, g.z_mode};
  const auto in_lamina_plane = [](const Pack& x, const Pack& y, const Vec& b) {
    return Pack(multiply_add(x, b.x, Pack(y * b.y)));
  };
  const Pack rest31 = math::dot(mode, m.fibre31) + in_lamina_plane(tilt.x31, tilt.y31, v_mode);
  const Pack rest42 = math::dot(mode, m.fibre42) + in_lamina_plane(tilt.x42, tilt.y42, v_mode);
  const Pack along31 =
      multiply_add(quarter, rest31, Pack(m.v31.z + in_lamina_plane(g.x31, g.y31, m.fibre_mean)));
  const Pack along42 =
      multiply_add(Pack(-quarter), rest42, Pack(m.v42.z + in_lamina_plane(g.x42, g.y42, m.fibre_mean)));
  return gradient(g, along31, along42);
}

template <class Pack>
CRUMPLE_INLINE void BelytschkoWongChiang::strains(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const ShellNodes<Pack> n = gathered<Pack>(place).all();
  const ElementShape<Pack> shape = middle_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const auto g = lamina_geometry(shape);
  const Pack thickness = own_state<Pack>(place, element_state::thickness);
  const FibreTilts<Pack> tilt = fibre_tilts(g, thickness);
  const LaminaMotion<Pack> m = lamina_motion(frame, n, tilt);

  const VelocityGradients<Pack> d{gradient(g, m.v31.x, m.v42.x), gradient(g, m.v31.y, m.v42.y),
                                  gradient(g, m.v31.z, m.v42.z), gradient(g, m.w31.x, m.w42.x),
                                  gradient(g, m.w31.y, m.w42.y)};
  const auto shear = projected_shear(g, tilt, m, in_lamina(frame, n.v_mode));
  const Pack step(place.task.step);
  const Pack shear_step = step * Pack(place.task.constants.shear_root);
  const materials::PlaneStrain<Pack> membrane{step * d.vx.x, step * d.vy.y, step * (d.vx.y + d.vy.x),
                                              shear_step * shear.y, shear_step * shear.x};
  const Pack bend = Real(0.5) * thickness * step;
  const Bending<Pack> rates = curvature_rates(g, tilt, m);
  store_strains(place, membrane, Bending<Pack>{bend * rates.xx, bend * rates.yy, bend * rates.xy});

  keep_modes(place, row_rates, hourglass_rates(frame, g, n.v_mode, n.w_mode, d));
  keep(place, row_area, g.area);
}

/// The resultants' work on the members of LaminaMotion; `on_mode` does work on the velocities' pattern.
template <class Pack>
struct WarpedForces {
  LayerForces<Pack> layers;
  math::PackVec3<Pack> on_mode;
};

template <class Pack>
CRUMPLE_INLINE WarpedForces<Pack> warped_forces(const LaminaGeometry<Pack>& g, const FibreTilts<Pack>& tilt,
                                                const Resultants<Pack>& r) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  const Pack half(Real(0.5));
  const Pack quarter(Real(0.25));
  const Pack zero(Real(0));
  // Area times the gradients' coefficients, of the middle surface and of what tilts add to them.
  const auto force = [&](const Pack& a, const Pack& b, const Pack& xx, const Pack& yy, const Pack& xy) {
    return Vec{half * multiply_add(a, xx, Pack(b * xy)), half * multiply_add(b, yy, Pack(a * xy)),
               Pack(zero)};
  };
  const Vec coupled31 = force(tilt.y42, -tilt.x42, r.bend_xx, r.bend_yy, r.bend_xy);
  const Vec coupled42 = force(-tilt.y31, tilt.x31, r.bend_xx, r.bend_yy, r.bend_xy);
  const Pack shear31 = half * multiply_add(g.y42, r.zx, Pack(-(g.x42 * r.yz)));
  const Pack shear42 = half * multiply_add(g.x31, r.yz, Pack(-(g.y31 * r.zx)));
  const Vec mode{g.x_mode, g.y_mode, g.z_mode};

  WarpedForces<Pack> f;
  f.layers.on31 = force(g.y42, -g.x42, r.xx, r.yy, r.xy) + coupled31;
  f.layers.on42 = force(-g.y31, g.x31, r.xx, r.yy, r.xy) + coupled42;
  f.layers.on31.z = shear31;
  f.layers.on42.z = shear42;
  f.layers.moment31 =
      math::multiply_add(quarter * shear31, mode, force(g.y42, -g.x42, r.bend_xx, r.bend_yy, r.bend_xy));
  f.layers.moment42 =
      math::multiply_add(-(quarter * shear42), mode, force(-g.y31, g.x31, r.bend_xx, r.bend_yy, r.bend_xy));
  f.layers.on_mean = {g.area * r.zx, g.area * r.yz, zero};
  f.on_mode = {quarter * multiply_add(shear31, tilt.x31, Pack(-(shear42 * tilt.x42))),
               quarter * multiply_add(shear31, tilt.y31, Pack(-(shear42 * tilt.y42))), zero};
  return f;
}

template <class Pack>
CRUMPLE_INLINE ShellForces<Pack> BelytschkoWongChiang::forces(const ShellPlace<RealOf<Pack>>& place) {
  using Vec = math::PackVec3<Pack>;
  const ElementShape<Pack> shape = end_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const auto g = lamina_geometry(shape);
  const Pack active = own_state<Pack>(place, element_state::active);

  const Pack mean_thickness = update_thickness<Pack>(place);
  const Pack full_thickness = own_state<Pack>(place, element_state::thickness);
  const Pack thickness = active * full_thickness;
  leave_internal_energy(place, Pack(active * (mean_thickness * kept<Pack>(place, row_area))));

  const FibreTilts<Pack> tilt = fibre_tilts(g, full_thickness);
  const auto q = update_hourglass(place, g, thickness, kept_modes<Pack>(place, row_rates));
  const WarpedForces<Pack> f = warped_forces(g, tilt, integrate(place, thickness));
  ShellForces<Pack> out = fibre_forces(frame, g, tilt, f.layers, q);
  const Vec on_mode = in_space(frame, f.on_mode);
  out.force[0] = out.force[0] + on_mode;
  out.force[1] = out.force[1] - on_mode;
  out.force[2] = out.force[2] + on_mode;
  out.force[3] = out.force[3] - on_mode;
  limit_step(place, g.area, shape);
  return out;
}

}  // namespace crumple::elements
