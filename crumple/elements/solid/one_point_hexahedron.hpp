// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/solid/hexahedron_gather.hpp"
#include "elements/solid/hexahedron_hourglass.hpp"
#include "elements/solid/solid_resistance.hpp"

namespace crumple::elements {

/// The eight-node hexahedron with one point and hourglass control (Flanagan & Belytschko, IJNME 17 (1981)
/// 679-706; Goudreau & Hallquist, CMAME 33 (1982) 725-757): docs/theory/one_point_hexahedron.md.
struct OnePointHexahedron {
  static constexpr model::SolidFormulation formulation = model::SolidFormulation::OnePointHexahedron;
  static constexpr const char* name = "one-point hexahedron";
  static constexpr int points = 1;
  static constexpr int corners = 8;
  static constexpr KeptItem kept{"hourglass", "force or energy^1/2", 12};  ///< energy^1/2: IHQ 6
  static constexpr bool averages = false;

  static constexpr int row_volume = solid_scratch::own;
  static constexpr int row_dilatation = row_volume + 1;  ///< rate
  static constexpr int row_rates = row_dilatation + 1;   ///< of the four hourglass modes, or assumed strains
  static constexpr int rows = row_rates + 12;

  template <class Pack>
  static void strains(const SolidPlace<RealOf<Pack>>& place);
  template <class Pack>
  static SolidForces<Pack> forces(const SolidPlace<RealOf<Pack>>& place);
};

// Strains and rotation are those of the geometry at the middle of the step (Hughes & Winget 1980). Every
// function below is compiled for both kinds of gradient: `exact_volume` is known where it is called.
template <class Pack>
CRUMPLE_INLINE void hexahedron_strains(const SolidPlace<RealOf<Pack>>& place, bool exact_volume) {
  using Vec = math::PackVec3<Pack>;
  using Element = OnePointHexahedron;
  const SolidConstants<RealOf<Pack>>& constants = place.task.constants;
  const SolidMotion<Pack> motion = gathered_motion<Pack>(place, Element::kept.count);
  const SolidPatterns<Pack>& x = motion.x;
  const SolidPatterns<Pack>& v = motion.v;
  const SolidGeometry<Pack> g = solid_geometry(x, exact_volume);
  const PackMatrix<Pack> l = velocity_gradient(g, v, exact_volume);
  leave_strains(place, 0, l);
  keep_row(place, Element::row_volume, g.volume);
  keep_row(place, Element::row_dilatation, trace(l));
  resist_early(place, g.volume, trace(l));
  const auto keep_rates = [&](const auto& kept_rate) {
    for (int mode = 0; mode < 4; ++mode) {
      const int p = pattern::hourglass + mode;
      keep_vector(place, Element::row_rates + 3 * mode, kept_rate(v.of[p], x.of[p]));
    }
  };
  const auto without_linear_part = [&](const Vec& rate, const Vec& pattern) { return rate - l * pattern; };
  if (constants.assumed_strain) {
    const PackMatrix<Pack> axes = side_axes(x);
    HourglassVectors<Pack> rate;
    for (int mode = 0; mode < 4; ++mode) {
      const int p = pattern::hourglass + mode;
      rate.of[mode] = axes * without_linear_part(v.of[p], x.of[p]);
    }
    const HourglassVectors<Pack> of_strains =
        assumed_strain_rates(constants, AssumedStrainModuli<Pack>(place, axes, x), rate);
    for (int mode = 0; mode < 4; ++mode)
      keep_vector(place, Element::row_rates + 3 * mode, of_strains.of[mode]);
  } else if (constants.without_linear_part) {
    keep_rates(without_linear_part);
  } else {
    keep_rates([](const Vec& rate, const Vec& /*pattern*/) { return rate; });
  }
}

/// Of the forms 1 to 5.
template <class Pack>
CRUMPLE_INLINE Pack viscous_or_stiff_modulus(const SolidPlace<RealOf<Pack>>& place, const Pack& active,
                                             const SolidGeometry<Pack>& g,
                                             const Resistance<Pack>& resistance) {
  const SolidConstants<RealOf<Pack>>& constants = place.task.constants;
  const Pack modulus = active * hourglass_modulus(constants, g, resistance);
  return constants.present_wave_speed > 0 ? Pack(modulus * hourglass_share<Pack>(place)) : modulus;
}

/// Takes from the stress what keeps the modes' forces from doing work on linear fields: the mean over the
/// volume of what they are at the patterns of the positions.
template <class Pack>
CRUMPLE_INLINE void take_linear_part(PackMatrix<Pack>& stress, const HourglassForces<Pack>& q,
                                     const SolidPatterns<Pack>& x, const Pack& per_volume) {
  using Vec = math::PackVec3<Pack>;
  const auto row = [&](Vec& of_stress, auto component) {
    Vec sum = component(q.of[0]) * x.of[pattern::hourglass];
    for (int mode = 1; mode < 4; ++mode)
      sum = math::multiply_add(component(q.of[mode]), x.of[pattern::hourglass + mode], sum);
    of_stress = math::multiply_add(Pack(-per_volume), sum, of_stress);
  };
  row(stress.x, [](const Vec& f) { return f.x; });
  row(stress.y, [](const Vec& f) { return f.y; });
  row(stress.z, [](const Vec& f) { return f.z; });
}

template <class Pack>
CRUMPLE_INLINE SolidForces<Pack> hexahedron_forces(const SolidPlace<RealOf<Pack>>& place, bool exact_volume) {
  using Element = OnePointHexahedron;
  const SolidConstants<RealOf<Pack>>& constants = place.task.constants;
  const SolidPatterns<Pack> x = left_positions<Pack>(place);
  const SolidGeometry<Pack> g = solid_geometry(x, exact_volume);
  const Pack active = own_item<Pack>(place, solid_state::active);
  const Pack dilatation = kept_row<Pack>(place, Element::row_dilatation);
  const Resistance<Pack> resistance = resist(place, active, g.volume, dilatation);
  leave_limit(place, active,
              smaller(Pack(g.volume / square_root(largest_face_squared(x))),
                      free_length(g, patterns_of_gradient(exact_volume), shear_share_of<Pack>(place))),
              resistance);
  const Pack viscous_work = -resistance.mean * (Pack(place.task.step) * dilatation);
  const Pack work = multiply_add(active, kept_row<Pack>(place, solid_scratch::material_energy), viscous_work);
  keep_row(place, solid_scratch::internal_energy, Pack(work * kept_row<Pack>(place, Element::row_volume)));
  leave_damping_energy(place, active, Element::row_volume);

  const HourglassForces<Pack> q =
      constants.assumed_strain ? assumed_strain_forces(place, Element::row_rates, active, x)
                               : hourglass_forces(place, Element::row_rates,
                                                  viscous_or_stiff_modulus(place, active, g, resistance));
  keep_row(place, solid_scratch::hourglass_energy, q.work);
  PackMatrix<Pack> stress = stress_of<Pack>(place, 0, active);
  lessen_diagonal(stress, resistance.pressure);
  if (constants.without_linear_part)
    take_linear_part(stress, q, left_positions<Pack>(place), resistance.per_volume);
  SolidPatterns<Pack> conjugate;
  for (int p = 0; p < patterns_of_gradient(exact_volume); ++p) conjugate.of[p] = stress * g.gradient[p];
  for (int mode = 0; mode < 3; ++mode) {
    const int p = pattern::hourglass + mode;
    conjugate.of[p] = exact_volume ? conjugate.of[p] + q.of[mode] : q.of[mode];
  }
  conjugate.of[pattern::xi_eta_zeta] = q.of[3];
  return nodal_forces(conjugate);
}

template <class Pack>
CRUMPLE_INLINE void OnePointHexahedron::strains(const SolidPlace<RealOf<Pack>>& place) {
  if (place.task.constants.exact_volume)
    hexahedron_strains<Pack>(place, true);
  else
    hexahedron_strains<Pack>(place, false);
}
template <class Pack>
CRUMPLE_INLINE SolidForces<Pack> OnePointHexahedron::forces(const SolidPlace<RealOf<Pack>>& place) {
  if (place.task.constants.exact_volume) return hexahedron_forces<Pack>(place, true);
  return hexahedron_forces<Pack>(place, false);
}

}  // namespace crumple::elements
