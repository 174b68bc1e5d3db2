// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The air blast of TNT at sea level, as fitted to experiments by C. N. Kingery and G. Bulmash, Airblast
// Parameters from TNT Spherical Air Burst and Hemispherical Surface Burst, ARBRL-TR-02555, US Army Ballistic
// Research Laboratory, 1984. The fits are polynomials in u = a + b log10 Z for log10 of what is wanted; Z is
// the distance over the cube root of the mass. Theory page: docs/theory/air_blast.md, which names the sources
// that the numbers were compared with.

#include "model/air_blast.hpp"

namespace crumple::loads {

/// A blast wave at one distance. Times and impulses are over the cube root of the mass.
struct ScaledWave {
  double incident_pressure = 0;   ///< peak over that of the air, on a segment along the way of the wave [psi]
  double reflected_pressure = 0;  ///< on one that faces the charge [psi]
  double arrival = 0;             ///< since the detonation [ms/lb^(1/3)]
  double duration = 0;            ///< of the positive phase [ms/lb^(1/3)]
  double incident_impulse = 0;    ///< of the positive phase [psi ms/lb^(1/3)]
  double reflected_impulse = 0;   ///< likewise [psi ms/lb^(1/3)]
};

/// The wave at a scaled distance [ft/lb^(1/3)], which must be in the range of the fits
/// (model::scaled_range): they are meaningless elsewhere.
ScaledWave scaled_wave(model::AirBlast::Burst burst, double scaled_distance);

/// The decay b of Friedlander's pulse p (1 - t/d) exp(-b t/d) whose integral from 0 to d is an impulse, from
/// p d / impulse, which must be above 1/3: p d (b - 1 + exp(-b)) / b^2 is that impulse. Below 2 the decay is
/// negative.
double friedlander_decay(double pressure_times_duration_over_impulse);

}  // namespace crumple::loads
