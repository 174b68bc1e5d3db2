// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/solid/quadratic_tetrahedron_nodes.hpp"
#include "elements/solid/solid_resistance.hpp"

namespace crumple::elements {

/// The tetrahedron with ten nodes and four points: docs/theory/quadratic_tetrahedra.md.
struct QuadraticTetrahedron {
  static constexpr model::SolidFormulation formulation = model::SolidFormulation::QuadraticTetrahedron;
  static constexpr const char* name = "quadratic tetrahedron";
  static constexpr int points = quadratic_tetrahedron::points;
  static constexpr int corners = 10;
  static constexpr KeptItem kept{};
  static constexpr bool averages = false;

  static constexpr int row_volume = solid_scratch::own;
  static constexpr int row_dilatation = row_volume + 1;  ///< rate, the mean over the element
  static constexpr int row_share = row_dilatation + 1;   ///< volumes of the points
  static constexpr int rows = row_share + points;

  template <class Pack>
  static void strains(const SolidPlace<RealOf<Pack>>& place);
  template <class Pack>
  static SolidForces<Pack, corners> forces(const SolidPlace<RealOf<Pack>>& place);
};

template <class Pack>
CRUMPLE_INLINE void QuadraticTetrahedron::strains(const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const QuadraticSides<Pack> v =
      quadratic_sides<Pack>(place.nodes + quadratic_tetrahedron::velocity * width_of<Pack>);
  QuadraticSides<Pack> x = quadratic_sides<Pack>(place.nodes);
  const Pack back(-(Real(0.5) * place.task.step));
  for (int s = 0; s < quadratic_tetrahedron::sides; ++s) x.of[s] = math::multiply_add(back, v.of[s], x.of[s]);
  const Pack share(Real(1.0 / 24));
  Pack volume(Real(0));
  Pack rate(Real(0));
  for (int point = 0; point < points; ++point) {
    const ThreeVectors<Pack> tangent = quadratic_tangents(x, point);
    const ThreeVectors<Pack> area = areas_across(tangent);
    const Pack jacobian = math::dot(tangent.of[0], area.of[0]);
    const PackMatrix<Pack> l =
        gradient_of(quadratic_tangents(v, point), area, Pack(Pack(Real(1)) / jacobian));
    leave_strains(place, point, l);
    const Pack own = share * jacobian;
    keep_row(place, row_share + point, own);
    volume = volume + own;
    rate = multiply_add(own, trace(l), rate);
  }
  const Pack dilatation = rate / volume;
  keep_row(place, row_volume, volume);
  keep_row(place, row_dilatation, dilatation);
  resist_early(place, volume, dilatation);
}

template <class Pack>
CRUMPLE_INLINE SolidForces<Pack, 10> QuadraticTetrahedron::forces(const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  const QuadraticSides<Pack> x = quadratic_sides<Pack>(place.nodes);
  const Pack zero(Real(0));
  const Pack share(Real(1.0 / 24));
  const Pack active = own_item<Pack>(place, solid_state::active);
  ThreeVectors<Pack> area[points];
  QuadraticStiffness<Pack> stiffness = no_quadratic_stiffness<Pack>();
  Pack volume = zero;
  Pack work = zero;
  for (int point = 0; point < points; ++point) {
    const ThreeVectors<Pack> tangent = quadratic_tangents(x, point);
    area[point] = areas_across(tangent);
    const Pack jacobian = math::dot(tangent.of[0], area[point].of[0]);
    stiffness.add(area[point], jacobian);
    volume = multiply_add(share, jacobian, volume);
    work = multiply_add(Pack(active * kept_row<Pack>(place, solid_scratch::material_energy + point)),
                        kept_row<Pack>(place, row_share + point), work);
  }
  const Pack dilatation = kept_row<Pack>(place, row_dilatation);
  const Resistance<Pack> resistance = resist(place, active, volume, dilatation);
  const Pack viscous = resistance.mean * (Pack(place.task.step) * dilatation);
  keep_row(place, solid_scratch::internal_energy, Pack(work - viscous * kept_row<Pack>(place, row_volume)));
  leave_damping_energy(place, active, row_share);
  keep_row(place, solid_scratch::hourglass_energy, zero);
  SolidForces<Pack, 10> force;
  for (Vec& f : force.of) f = {zero, zero, zero};
  for (int point = 0; point < points; ++point) {
    PackMatrix<Pack> stress = stress_of<Pack>(place, point, active);
    lessen_diagonal(stress, resistance.pressure);
    for (int k = 0; k < 3; ++k) {
      const Vec along = share * (stress * area[point].of[k]);
      for (int s = 0; s < quadratic_tetrahedron::sides; ++s)
        force.of[s + 1] = math::multiply_add(Pack(Real(quadratic_tetrahedron::slope.of[point][s][k])), along,
                                             force.of[s + 1]);
    }
  }
  for (int s = 1; s < 10; ++s) force.of[0] = force.of[0] - force.of[s];
  // One that is inside out at a point ends the run.
  const Pack length = quadratic_length(stiffness, volume, shear_share_of<Pack>(place));
  leave_limit(place, active, select<Pack>(stiffness.narrowest > zero, length, stiffness.narrowest),
              resistance);
  return force;
}

}  // namespace crumple::elements
