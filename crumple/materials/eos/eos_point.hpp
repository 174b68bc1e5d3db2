// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/pack.hpp"

namespace crumple::materials {

/// An equation of state that is linear in the energy, p = cold + thermal E, at one compression mu, and its
/// slopes over mu. E is the internal energy per reference volume.
template <class Pack>
struct EosPoint {
  Pack cold;     ///< [stress]
  Pack thermal;  ///< [-]
  Pack cold_slope;
  Pack thermal_slope;
};

/// What stands before an equation of state's own numbers among the constants, see SolidMaterialTask.
namespace eos_place {
inline constexpr int kind = 0;            ///< place in EquationsOfState
inline constexpr int history = 1;         ///< first component of its items, counted from the law's
inline constexpr int initial_excess = 2;  ///< V0 - 1 [-]
inline constexpr int initial_energy = 3;  ///< E0 [energy/volume]
inline constexpr int per_density = 4;     ///< one over the reference density [volume/mass]
inline constexpr int shear = 5;           ///< 4/3 of the shear modulus [stress]
inline constexpr int least_square = 6;    ///< lower bound of the square of the wave speed
inline constexpr int least_pressure = 7;  ///< lower bound of the pressure [stress]
inline constexpr int spall = 8;           ///< model::Spall as a number
inline constexpr int own = 9;
}  // namespace eos_place

/// State items of an equation of state, in units of the number of points.
namespace eos_item {
inline constexpr int volume_change = 0;  ///< relative volume less V0
inline constexpr int volume_rest = 1;    ///< what its sum has lost to rounding
inline constexpr int energy = 2;         ///< internal energy per reference volume less E0
inline constexpr int energy_rest = 3;
inline constexpr int rubble = 4;  ///< 1 where the material has spalled
inline constexpr int count = 5;
}  // namespace eos_item

}  // namespace crumple::materials
