// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/solid_formulation.hpp"
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
                                                  const Pack& density, const Pack& length,
                                                  const Pack& dilatation_rate) {
  const Pack zero(RealOf<Pack>(0));
  const Pack closing = larger(zero, Pack(-dilatation_rate));
  const Pack linear(constants.bulk_linear * constants.wave_speed);
  const Pack speed = select<Pack>(
      closing > zero, multiply_add(Pack(constants.bulk_quadratic) * length, closing, linear), zero);
  return {density * length * closing * speed, speed};
}

/// The bulk viscosity of an element at the end of the step.
template <class Pack>
struct Resistance {
  Pack pressure;
  Pack speed;    ///< see BulkViscosity
  Pack density;  ///< [mass/volume]
  Pack length;   ///< third root of the volume
  Pack mean;     ///< of the pressure over the step
};
template <class Pack>
CRUMPLE_INLINE Resistance<Pack> resist(const SolidPlace<RealOf<Pack>>& place, const Pack& active,
                                       const Pack& volume, const Pack& dilatation) {
  using Real = RealOf<Pack>;
  const SolidConstants<Real>& constants = place.task.constants;
  Resistance<Pack> found;
  found.density = Pack(constants.density) * own_item<Pack>(place, solid_state::reference_volume) / volume;
  found.length = math::cube_root(volume);
  const BulkViscosity<Pack> bulk = bulk_viscosity(constants, found.density, found.length, dilatation);
  const Pack old_pressure = own_item<Pack>(place, solid_state::bulk_viscosity);
  found.pressure = active * bulk.pressure;
  found.speed = bulk.speed;
  found.mean = Pack(Real(0.5)) * (old_pressure + found.pressure);
  set_own_item(place, solid_state::bulk_viscosity, found.pressure);
  return found;
}

/// Leaves the stable step of an element: l / (Q + sqrt(Q^2 + c^2)), Q the speed of the resistance.
template <class Pack>
CRUMPLE_INLINE void leave_limit(const SolidPlace<RealOf<Pack>>& place, const Pack& active, const Pack& length,
                                const Pack& resistance_speed) {
  using Real = RealOf<Pack>;
  const Pack speed(place.task.constants.wave_speed);
  const Pack limit =
      own_item<Pack>(place, solid_state::step_scale) * length /
      (resistance_speed + square_root(multiply_add(resistance_speed, resistance_speed, Pack(speed * speed))));
  keep_row(place, solid_scratch::shortest_step,
           select<Pack>(active > Pack(Real(0)), limit, Pack(Real(1e30))));
}

}  // namespace crumple::elements
