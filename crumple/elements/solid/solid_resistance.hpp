// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/solid/solid_formulation.hpp"
#include "math/cube_root.hpp"

// What all solids have: bulk viscosity with its energy, and the stable step.
namespace crumple::elements {

/// Pressure against compression, rho l (Q1 l d^2 - Q2 c d) of a dilatation rate d below zero (von Neumann &
/// Richtmyer 1950; Landshoff 1955), and what it takes from the stable step.
template <class Pack>
struct BulkViscosity {
  Pack pressure;
  Pack speed;  ///< Q2 c - Q1 l d, to be added to the wave speed
};
template <class Pack>
CRUMPLE_INLINE BulkViscosity<Pack> bulk_viscosity(const SolidConstants<RealOf<Pack>>& constants,
                                                  const Pack& wave_speed, const Pack& density,
                                                  const Pack& length, const Pack& dilatation_rate) {
  const Pack zero(RealOf<Pack>(0));
  const Pack closing = larger(zero, Pack(-dilatation_rate));
  const Pack linear = Pack(constants.bulk_linear) * wave_speed;
  // Also of an element that expands: steps that change with the sign of a rate would make energy of it.
  const Pack speed = multiply_add(Pack(constants.bulk_quadratic) * length, closing, linear);
  return {density * length * closing * speed, speed};
}

/// Where the wave speed varies: makes the bulk viscosity of the step before the material runs, as the energy
/// of an equation of state takes its work. `volume` is that of the middle of the step, the wave speed that of
/// its beginning.
template <class Pack>
CRUMPLE_INLINE void resist_early(const SolidPlace<RealOf<Pack>>& place, const Pack& volume,
                                 const Pack& dilatation) {
  using Real = RealOf<Pack>;
  const SolidConstants<Real>& constants = place.task.constants;
  if (constants.present_wave_speed == 0) return;
  const Pack density =
      Pack(constants.density) * own_item<Pack>(place, solid_state::reference_volume) / volume;
  const Pack length = math::cube_root(volume);
  const Pack wave_speed = load<Pack>(place.state + constants.present_wave_speed * lanes);
  const BulkViscosity<Pack> bulk = bulk_viscosity(constants, wave_speed, density, length, dilatation);
  const Pack pressure = own_item<Pack>(place, solid_state::active) * bulk.pressure;
  keep_row(place, solid_scratch::bulk_pressure, pressure);
  keep_row(place, solid_scratch::viscosity,
           Pack(Real(0.5) * (pressure + own_item<Pack>(place, solid_state::bulk_viscosity))));
}

/// At the end of the step; for forces() only.
template <class Pack>
CRUMPLE_INLINE Pack wave_speed_of(const SolidPlace<RealOf<Pack>>& place) {
  if (place.task.constants.present_wave_speed == 0) return Pack(place.task.constants.wave_speed);
  return kept_row<Pack>(place, solid_scratch::wave_speed);
}

/// Factor on hourglass control where the wave speed varies: the step follows that, and so must what limits
/// it.
template <class Pack>
CRUMPLE_INLINE Pack hourglass_share(const SolidPlace<RealOf<Pack>>& place) {
  const auto& constants = place.task.constants;
  const Pack share = wave_speed_of<Pack>(place) * Pack(RealOf<Pack>(1) / constants.wave_speed);
  return constants.viscous ? share : Pack(share * share);
}

/// Pressure of interior contact, K (V* / V - 1) of a volume V below V*: linear in the density, so that its
/// wave speed is constant, and without bound where the volume goes to zero (own derivation,
/// docs/theory/interior_contact.md).
template <class Pack>
CRUMPLE_INLINE Pack interior_pressure(const SolidPlace<RealOf<Pack>>& place, const Pack& per_volume) {
  using Real = RealOf<Pack>;
  const SolidConstants<Real>& constants = place.task.constants;
  const Pack least = Pack(constants.interior_volume) * own_item<Pack>(place, solid_state::reference_volume);
  const Pack excess = larger(Pack(Real(0)), multiply_add(least, per_volume, Pack(Real(-1))));
  return Pack(constants.interior_modulus) * excess;
}

/// The bulk viscosity of an element at the end of the step, and its interior contact.
template <class Pack>
struct Resistance {
  Pack pressure;
  Pack speed;    ///< see BulkViscosity
  Pack density;  ///< [mass/volume]
  Pack length;   ///< third root of the volume
  Pack per_volume;
  Pack mean;  ///< of the pressure over the step
};
template <class Pack>
CRUMPLE_INLINE Resistance<Pack> resist(const SolidPlace<RealOf<Pack>>& place, const Pack& active,
                                       const Pack& volume, const Pack& dilatation) {
  using Real = RealOf<Pack>;
  const SolidConstants<Real>& constants = place.task.constants;
  Resistance<Pack> found;
  found.per_volume = Pack(Real(1)) / volume;
  found.density =
      Pack(constants.density) * own_item<Pack>(place, solid_state::reference_volume) * found.per_volume;
  found.length = math::cube_root(volume);
  const Pack wave_speed = wave_speed_of<Pack>(place);
  const BulkViscosity<Pack> bulk =
      bulk_viscosity(constants, wave_speed, found.density, found.length, dilatation);
  const Pack old_pressure = own_item<Pack>(place, solid_state::bulk_viscosity);
  found.pressure = active * bulk.pressure;
  if (constants.present_wave_speed > 0) {
    found.pressure = kept_row<Pack>(place, solid_scratch::bulk_pressure);
    store(place.state + constants.present_wave_speed * lanes, wave_speed);
  }
  if (constants.interior_modulus > 0)
    found.pressure = found.pressure + active * interior_pressure(place, found.per_volume);
  found.speed = bulk.speed;
  found.mean = Pack(Real(0.5)) * (old_pressure + found.pressure);
  set_own_item(place, solid_state::bulk_viscosity, found.pressure);
  return found;
}

/// 2 mu / (lambda + 2 mu): of a wave speed that varies only what the pressure adds changes.
template <class Pack>
CRUMPLE_INLINE Pack shear_share_of(const SolidPlace<RealOf<Pack>>& place) {
  const auto& constants = place.task.constants;
  const Pack share(constants.shear_share);
  if (constants.present_wave_speed == 0) return share;
  const Pack slower = Pack(constants.wave_speed) / wave_speed_of<Pack>(place);
  return smaller(Pack(RealOf<Pack>(1)), Pack(share * (slower * slower)));
}

/// Leaves the stable step of an element: l / (Q + sqrt(Q^2 + c^2)), Q the speed of the resistance. That is
/// made with the third root of the volume, but damps the mode of the length l: in elements flatter than a
/// cube, where the root is more than sqrt(3) l, Q grows in proportion.
template <class Pack>
CRUMPLE_INLINE void leave_limit(const SolidPlace<RealOf<Pack>>& place, const Pack& active, const Pack& length,
                                const Resistance<Pack>& resistance) {
  using Real = RealOf<Pack>;
  const Pack speed = wave_speed_of<Pack>(place);
  const Pack flatness = Pack(Real(0.5773502691896258)) * (resistance.length / length);
  const Pack resistance_speed = resistance.speed * larger(Pack(Real(1)), flatness);
  const Pack square = multiply_add(speed, speed, Pack(place.task.constants.interior_speed_square));
  const Pack limit =
      own_item<Pack>(place, solid_state::step_scale) * length /
      (resistance_speed + square_root(multiply_add(resistance_speed, resistance_speed, square)));
  keep_row(place, solid_scratch::shortest_step,
           select<Pack>(active > Pack(Real(0)), limit, Pack(Real(1e30))));
}

}  // namespace crumple::elements
