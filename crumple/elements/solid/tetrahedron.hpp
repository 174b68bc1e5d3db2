// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/solid/solid_resistance.hpp"
#include "elements/solid/tetrahedron_nodes.hpp"

namespace crumple::elements {

/// Rows that tetrahedra keep.
namespace tetrahedron_kept {
inline constexpr int volume = solid_scratch::own;
inline constexpr int dilatation = volume + 1;       ///< rate, of the element's own volume
inline constexpr int mean_stress = dilatation + 1;  ///< at the start of the step, if it averages
inline constexpr int count = mean_stress + 1;
}  // namespace tetrahedron_kept

/// A third of the trace of the stress in the state.
template <class Pack>
CRUMPLE_INLINE Pack state_mean_stress(const SolidPlace<RealOf<Pack>>& place) {
  const auto direct = [&](int c) { return load<Pack>(place.state + c * lanes); };
  return Pack(RealOf<Pack>(1.0 / 3.0)) * (direct(0) + (direct(1) + direct(2)));
}

/// Strains at the middle of the step. With `Averages` the dilatation is that which average_dilatations() has
/// left in the element's state.
template <class Pack, bool Averages>
CRUMPLE_INLINE void tetrahedron_strains(const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const ThreeVectors<Pack> v = gathered_sides<Pack>(place.nodes + tetrahedron_row::velocity * width_of<Pack>);
  ThreeVectors<Pack> side = gathered_sides<Pack>(place.nodes);
  const Pack back(-(Real(0.5) * place.task.step));
  for (int s = 0; s < 3; ++s) side.of[s] = math::multiply_add(back, v.of[s], side.of[s]);
  const ThreeVectors<Pack> area = areas_across(side);
  const Pack six_volumes = math::dot(side.of[0], area.of[0]);
  const Pack share = Pack(Real(1)) / six_volumes;
  PackMatrix<Pack> l = gradient_of(v, area, share);
  const Pack dilatation = trace(l);
  keep_row(place, tetrahedron_kept::volume, Pack(Pack(Real(1.0 / 6.0)) * six_volumes));
  keep_row(place, tetrahedron_kept::dilatation, dilatation);
  if constexpr (Averages) {
    const Pack surplus = dilatation - own_item<Pack>(place, solid_state::own);
    lessen_diagonal(l, Pack(Pack(Real(1.0 / 3.0)) * surplus));
    keep_row(place, tetrahedron_kept::mean_stress, state_mean_stress<Pack>(place));
  }
  resist_early(place, kept_row<Pack>(place, tetrahedron_kept::volume), trace(l));
  leave_strains(place, 0, l);
}

template <class Pack, bool Averages>
CRUMPLE_INLINE SolidForces<Pack, 4> tetrahedron_forces(const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const ThreeVectors<Pack> side = gathered_sides<Pack>(place.nodes);
  const ThreeVectors<Pack> area = areas_across(side);
  const Pack six_volumes = math::dot(side.of[0], area.of[0]);
  const Pack sixth(Real(1.0 / 6.0));
  const Pack active = own_item<Pack>(place, solid_state::active);
  const Pack own_dilatation = kept_row<Pack>(place, tetrahedron_kept::dilatation);
  Pack dilatation = own_dilatation;
  if constexpr (Averages) dilatation = own_item<Pack>(place, solid_state::own);
  const Resistance<Pack> resistance = resist(place, active, Pack(sixth * six_volumes), dilatation);
  // The forces of a pressure work on the element's own volume, whatever dilatation has made it.
  Pack spherical = -resistance.mean * own_dilatation;
  if constexpr (Averages) {
    const Pack both = kept_row<Pack>(place, tetrahedron_kept::mean_stress) + state_mean_stress<Pack>(place);
    spherical =
        multiply_add(Pack(active * (Pack(Real(0.5)) * both)), Pack(own_dilatation - dilatation), spherical);
  }
  const Pack work = multiply_add(active, kept_row<Pack>(place, solid_scratch::material_energy),
                                 Pack(Pack(place.task.step) * spherical));
  keep_row(place, solid_scratch::internal_energy,
           Pack(work * kept_row<Pack>(place, tetrahedron_kept::volume)));
  leave_damping_energy(place, active, tetrahedron_kept::volume);
  keep_row(place, solid_scratch::hourglass_energy, Pack(Real(0)));
  PackMatrix<Pack> stress = stress_of<Pack>(place, 0, active);
  lessen_diagonal(stress, resistance.pressure);
  leave_limit(place, active, tetrahedron_length(area, six_volumes), resistance);
  SolidForces<Pack, 4> force;
  for (int s = 0; s < 3; ++s) force.of[s + 1] = sixth * (stress * area.of[s]);
  force.of[0] = -(force.of[1] + (force.of[2] + force.of[3]));
  return force;
}

/// What both tetrahedra have in common.
template <bool Averages>
struct AnyTetrahedron {
  static constexpr int points = 1;
  static constexpr int corners = 4;
  static constexpr bool averages = Averages;
  static constexpr int rows = tetrahedron_kept::count;

  template <class Pack>
  static void strains(const SolidPlace<RealOf<Pack>>& place) {
    tetrahedron_strains<Pack, averages>(place);
  }
  template <class Pack>
  static SolidForces<Pack, 4> forces(const SolidPlace<RealOf<Pack>>& place) {
    return tetrahedron_forces<Pack, averages>(place);
  }
};

/// The tetrahedron with one point and constant stress: docs/theory/tetrahedra.md.
struct Tetrahedron : AnyTetrahedron<false> {
  static constexpr model::SolidFormulation formulation = model::SolidFormulation::Tetrahedron;
  static constexpr const char* name = "tetrahedron";
  static constexpr KeptItem kept{};
};

/// The same with the dilatation averaged at the nodes (Bonet & Burton, Commun. Numer. Meth. Engng 14 (1998)
/// 437-449), of the nodes' mean: docs/theory/tetrahedra.md.
struct NodalPressureTetrahedron : AnyTetrahedron<true> {
  static constexpr model::SolidFormulation formulation = model::SolidFormulation::NodalPressureTetrahedron;
  static constexpr const char* name = "nodal pressure tetrahedron";
  static constexpr KeptItem kept{"mean_dilatation_rate", "1/time", 1};
};

}  // namespace crumple::elements
