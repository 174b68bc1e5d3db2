// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/membrane.hpp"

namespace crumple::elements {

/// The triangle of constant strain in parts of membranes: docs/theory/membranes.md. Its fourth node repeats
/// the third, so that the differences over the "diagonals" 31 and 42 are those over sides 1-3 and 2-3.
struct MembraneTriangle {
  static constexpr model::ShellFormulation formulation = model::ShellFormulation::MembraneTriangle;
  static constexpr const char* name = "membrane triangle";
  static constexpr int planes = 1;
  static constexpr bool own_areas = false;

  static constexpr int row_area = 0;
  static constexpr int rows = 1;

  template <class Pack>
  static void strains(const ShellPlace<RealOf<Pack>>& place);
  template <class Pack>
  static ShellForces<Pack> forces(const ShellPlace<RealOf<Pack>>& place);
};

template <class Pack>
CRUMPLE_INLINE void MembraneTriangle::strains(const ShellPlace<RealOf<Pack>>& place) {
  const GatheredNodes<Pack> n = gathered<Pack>(place);
  const ElementShape<Pack> shape = middle_shape<Pack>(place);
  const LaminaFrame<Pack>& frame = shape.frame;
  const auto g = lamina_geometry(shape);
  const auto v31 = n.v31();
  const auto v32 = n.v42();
  const auto vx = gradient(g, math::dot(v31, frame.e1), math::dot(v32, frame.e1));
  const auto vy = gradient(g, math::dot(v31, frame.e2), math::dot(v32, frame.e2));
  const Pack step(place.task.step);
  store_membrane_strain(place, 0, Pack(step * vx.x), Pack(step * vy.y), Pack(step * (vx.y + vy.x)));
  keep(place, row_area, g.area);
}

template <class Pack>
CRUMPLE_INLINE ShellForces<Pack> MembraneTriangle::forces(const ShellPlace<RealOf<Pack>>& place) {
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
  const Pack zero(Real(0));
  store(place.rows + scratch_row::hourglass_energy * tile_lanes, zero);

  const MembraneForce<Pack> r = membrane_force(place, 0, thickness);
  const Pack half(Real(0.5));
  // a and b: area times d/dx and d/dy by the difference over a side.
  const auto on_side = [&](const Pack& a, const Pack& b) {
    const Pack x = multiply_add(a, r.xx, Pack(b * r.xy));
    const Pack y = multiply_add(b, r.yy, Pack(a * r.xy));
    return math::multiply_add(x, frame.e1, y * frame.e2);
  };
  const Vec on31 = on_side(half * g.y42, -(half * g.x42));
  const Vec on32 = on_side(-(half * g.y31), half * g.x31);
  ShellForces<Pack> out;
  out.force[0] = Pack(Real(-1)) * on31;
  out.force[1] = Pack(Real(-1)) * on32;
  out.force[2] = on31 + on32;
  out.force[3] = {zero, zero, zero};
  no_moments(out);
  return out;
}

}  // namespace crumple::elements
