// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/formulation.hpp"

namespace crumple::elements {

/// The Belytschko-Lin-Tsay shell without bending and transverse shear: forces in the plane of the lamina, no
/// moments, no rotary inertia. docs/theory/membranes.md.
struct Membrane {
  static constexpr model::ShellFormulation formulation = model::ShellFormulation::Membrane;
  static constexpr const char* name = "Belytschko-Tsay membrane";
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

/// Leaves the same strain increments for all points over one point in plane.
template <class Pack>
CRUMPLE_INLINE void store_membrane_strain(const ShellPlace<RealOf<Pack>>& place, int plane, const Pack& xx,
                                          const Pack& yy, const Pack& xy) {
  const Pack zero(RealOf<Pack>(0));
  const int points = place.task.constants.points;
  for (int p = 0; p < points; ++p)
    materials::store_five(place.strain + (plane * points + p) * materials::components * tile_lanes,
                          tile_lanes, materials::PlaneStrain<Pack>{xx, yy, xy, zero, zero});
}

/// Forces per length.
template <class Pack>
struct MembraneForce {
  Pack xx, yy, xy;
};

/// Mean stress over the thickness at one point in plane, times the thickness.
template <class Pack>
CRUMPLE_INLINE MembraneForce<Pack> membrane_force(const ShellPlace<RealOf<Pack>>& place, int plane,
                                                  const Pack& thickness) {
  using Real = RealOf<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const Pack zero(Real(0));
  MembraneForce<Pack> sum{zero, zero, zero};
  for (int p = 0; p < constants.points; ++p) {
    const auto stress = materials::load_five<materials::PlaneStress<Pack>>(
        place.state + (plane * constants.points + p) * materials::components * lanes, lanes);
    const Pack weight(constants.weight[p]);
    sum.xx = multiply_add(weight, stress.xx, sum.xx);
    sum.yy = multiply_add(weight, stress.yy, sum.yy);
    sum.xy = multiply_add(weight, stress.xy, sum.xy);
  }
  return {thickness * sum.xx, thickness * sum.yy, thickness * sum.xy};
}

/// Nodes of membranes feel no moments.
template <class Pack>
CRUMPLE_INLINE void no_moments(ShellForces<Pack>& forces) {
  const Pack zero(RealOf<Pack>(0));
  for (math::PackVec3<Pack>& moment : forces.moment) moment = {zero, zero, zero};
}

template <class Pack>
CRUMPLE_INLINE void Membrane::strains(const ShellPlace<RealOf<Pack>>& place) {
  const GatheredNodes<Pack> n = gathered<Pack>(place);
  const ElementShape<Pack> shape = middle_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const auto g = lamina_geometry(shape);

  const auto local = [&](const math::PackVec3<Pack>& v) {
    return math::PackVec3<Pack>{math::dot(v, frame.e1), math::dot(v, frame.e2), math::dot(v, frame.e3)};
  };
  const auto v31 = local(n.v31());
  const auto v42 = local(n.v42());
  const auto vx = gradient(g, v31.x, v42.x);
  const auto vy = gradient(g, v31.y, v42.y);
  const auto vz = gradient(g, v31.z, v42.z);
  const Pack zero(RealOf<Pack>(0));
  const CentreGradient<Pack> none{zero, zero};
  keep_modes(place, row_rates,
             hourglass_rates(frame, g, n.v_mode(), math::PackVec3<Pack>{zero, zero, zero},
                             VelocityGradients<Pack>{vx, vy, vz, none, none}));
  keep(place, row_area, g.area);

  const Pack step(place.task.step);
  store_membrane_strain(place, 0, Pack(step * vx.x), Pack(step * vy.y), Pack(step * (vx.y + vy.x)));
}

template <class Pack>
CRUMPLE_INLINE ShellForces<Pack> Membrane::forces(const ShellPlace<RealOf<Pack>>& place) {
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
  const MembraneForce<Pack> r = membrane_force(place, 0, thickness);
  const Pack half(Real(0.5));
  // Forces at node 1 (negative at 3) or 2 (and 4); b1 and b2 are the area times the node's gradients.
  const auto share = [&](const Pack& b1, const Pack& b2) {
    const Pack x = multiply_add(b1, r.xx, Pack(b2 * r.xy));
    const Pack y = multiply_add(b2, r.yy, Pack(b1 * r.xy));
    const Pack z = lift * multiply_add(b1, q.x, Pack(b2 * q.y));
    return math::multiply_add(x, frame.e1, math::multiply_add(y, frame.e2, z * frame.e3));
  };
  const Vec force_a = share(-(half * g.y42), half * g.x42);
  const Vec force_b = share(half * g.y31, -(half * g.x31));
  const Vec force_q = math::multiply_add(q.x, frame.e1, math::multiply_add(q.y, frame.e2, q.z * frame.e3));

  const HourglassVector<Pack> gamma = hourglass_vector(g);
  ShellForces<Pack> out;
  out.force[0] = math::multiply_add(gamma.node[0], force_q, force_a);
  out.force[1] = math::multiply_add(gamma.node[1], force_q, force_b);
  out.force[2] = math::multiply_add(gamma.node[2], force_q, -force_a);
  out.force[3] = math::multiply_add(gamma.node[3], force_q, -force_b);
  no_moments(out);
  return out;
}

}  // namespace crumple::elements
