// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/hexahedron_hourglass.hpp"
#include "elements/solid_resistance.hpp"

namespace crumple::elements {

/// The eight-node hexahedron with one point and hourglass control (Flanagan & Belytschko, IJNME 17 (1981)
/// 679-706; Goudreau & Hallquist, CMAME 33 (1982) 725-757): docs/theory/one_point_hexahedron.md.
struct OnePointHexahedron {
  static constexpr model::SolidFormulation formulation = model::SolidFormulation::OnePointHexahedron;
  static constexpr const char* name = "one-point hexahedron";
  static constexpr int points = 1;
  static constexpr int corners = 8;
  static constexpr KeptItem kept{"hourglass", "force", 12};
  static constexpr bool averages = false;

  static constexpr int row_volume = solid_scratch::own;
  static constexpr int row_dilatation = row_volume + 1;  ///< rate
  static constexpr int row_rates = row_dilatation + 1;   ///< of the four hourglass modes, vectors
  static constexpr int rows = row_rates + 12;

  template <class Pack>
  static void strains(const SolidPlace<RealOf<Pack>>& place);
  template <class Pack>
  static SolidForces<Pack> forces(const SolidPlace<RealOf<Pack>>& place);
};

// Strains and rotation are those of the geometry at the middle of the step (Hughes & Winget 1980).
template <class Pack>
CRUMPLE_INLINE void OnePointHexahedron::strains(const SolidPlace<RealOf<Pack>>& place) {
  using Vec = math::PackVec3<Pack>;
  const SolidConstants<RealOf<Pack>>& constants = place.task.constants;
  const SolidPatterns<Pack> v = gathered_velocities<Pack>(place.nodes);
  const SolidPatterns<Pack> x = middle_positions(gathered_patterns<Pack>(place.nodes), v, place.task.step);
  const SolidGeometry<Pack> g = solid_geometry(x, constants.exact_volume);
  const PackMatrix<Pack> l = velocity_gradient(g, v, constants.exact_volume);
  leave_strains(place, 0, l);
  keep_row(place, row_volume, g.volume);
  keep_row(place, row_dilatation, trace(l));
  resist_early(place, g.volume, trace(l));
  const auto keep_rates = [&](const auto& in_axes) {
    for (int mode = 0; mode < 4; ++mode) {
      const int p = pattern::hourglass + mode;
      const Vec rate = constants.without_linear_part ? v.of[p] - l * x.of[p] : v.of[p];
      keep_vector(place, row_rates + 3 * mode, in_axes(rate));
    }
  };
  if (constants.assumed_strain) {
    const PackMatrix<Pack> axes = side_axes(x);
    keep_rates([&](const Vec& rate) { return axes * rate; });
  } else {
    keep_rates([](const Vec& rate) { return rate; });
  }
}

/// Of the forms 1 to 5.
template <class Pack>
CRUMPLE_INLINE Pack viscous_or_stiff_modulus(const SolidPlace<RealOf<Pack>>& place, const Pack& active,
                                             const SolidGeometry<Pack>& g,
                                             const Resistance<Pack>& resistance) {
  const SolidConstants<RealOf<Pack>>& constants = place.task.constants;
  const Pack modulus = active * hourglass_modulus(constants, g, resistance.density, resistance.length);
  return constants.present_wave_speed > 0 ? Pack(modulus * hourglass_share<Pack>(place)) : modulus;
}

template <class Pack>
CRUMPLE_INLINE SolidForces<Pack> OnePointHexahedron::forces(const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  const SolidConstants<Real>& constants = place.task.constants;
  const SolidPatterns<Pack> x = gathered_patterns<Pack>(place.nodes);
  const SolidGeometry<Pack> g = solid_geometry(x, constants.exact_volume);
  const Pack active = own_item<Pack>(place, solid_state::active);
  const Pack dilatation = kept_row<Pack>(place, row_dilatation);
  const Resistance<Pack> resistance = resist(place, active, g.volume, dilatation);
  const Pack viscous_work = -resistance.mean * (Pack(place.task.step) * dilatation);
  const Pack work = multiply_add(active, kept_row<Pack>(place, solid_scratch::material_energy), viscous_work);
  keep_row(place, solid_scratch::internal_energy, Pack(work * kept_row<Pack>(place, row_volume)));

  PackMatrix<Pack> stress = stress_of<Pack>(place, 0);
  lessen_diagonal(stress, resistance.pressure);
  const HourglassForces<Pack> q =
      constants.assumed_strain
          ? assumed_strain_forces(place, row_rates, active, x)
          : hourglass_forces(place, row_rates, viscous_or_stiff_modulus(place, active, g, resistance));
  keep_row(place, solid_scratch::hourglass_energy, q.work);

  const int last = patterns_of_gradient(constants.exact_volume);
  SolidPatterns<Pack> conjugate;
  for (int p = 0; p < last; ++p) conjugate.of[p] = active * (stress * g.gradient[p]);
  if (constants.without_linear_part) {
    const Pack per_volume = Pack(Real(1)) / g.volume;
    for (int p = 0; p < last; ++p) {
      Vec less = math::dot(g.gradient[p], x.of[pattern::hourglass]) * q.of[0];
      for (int mode = 1; mode < 4; ++mode)
        less =
            math::multiply_add(math::dot(g.gradient[p], x.of[pattern::hourglass + mode]), q.of[mode], less);
      conjugate.of[p] = math::multiply_add(Pack(-per_volume), less, conjugate.of[p]);
    }
  }
  for (int mode = 0; mode < 3; ++mode) {
    const int p = pattern::hourglass + mode;
    conjugate.of[p] = constants.exact_volume ? conjugate.of[p] + q.of[mode] : q.of[mode];
  }
  conjugate.of[pattern::xi_eta_zeta] = q.of[3];
  leave_limit(place, active, Pack(g.volume / square_root(largest_face_squared(x))), resistance.speed);
  return nodal_forces(conjugate);
}

}  // namespace crumple::elements
