// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "base/index.hpp"

namespace crumple::model {

// What fills a control volume (*AIRBAG): one struct for each law. Pressures are above the ambient one unless
// they are called absolute; curves are indices into Model::curves.

/// *AIRBAG_SIMPLE_PRESSURE_VOLUME: a pressure that depends on the volume alone.
struct PressureOfVolume {
  double coefficient = 0;  ///< CN times BETA: the pressure at the initial volume [stress]
  Index curve = no_index;  ///< LCID, instead: volume over initial volume [-], pressure [stress]
};

/// *AIRBAG_ADIABATIC_GAS_MODEL: an ideal gas without exchange of mass or heat.
struct AdiabaticGas {
  double scale = 1;     ///< PSF: factor on the pressure above the ambient one [-]
  double exponent = 0;  ///< GAMMA: ratio of the specific heats [-]
  double pressure = 0;  ///< P0: at time zero, above the ambient one [stress]
  double ambient = 0;   ///< PE: absolute [stress]
  double density = 0;   ///< RO: at time zero [mass/volume]
};

/// *AIRBAG_LINEAR_FLUID: a liquid whose mass may change.
struct LinearFluid {
  double bulk_modulus = 0;             ///< BULK [stress]
  double density = 0;                  ///< RO: of the unloaded liquid [mass/volume]
  double limit = 0;                    ///< P_LIMIT: no pressure above; 0 is none [stress]
  Index inflow = no_index;             ///< LCINT: time, [mass/time]
  Index outflow = no_index;            ///< LCOUTT: time, [mass/time]
  Index outflow_pressure = no_index;   ///< LCOUTP: pressure, [mass/time]
  Index added_pressure = no_index;     ///< LCFIT: time, pressure
  Index bulk_modulus_time = no_index;  ///< LCBULK: time, bulk modulus; instead of the constant
  Index limit_time = no_index;         ///< P_LIMLC: time, limit; instead of the constant
};

/// *AIRBAG_SIMPLE_AIRBAG_MODEL, _WANG_NEFSKE: an ideal gas that flows in by a curve and out through orifices.
struct InflatedGas {
  double heat_at_volume = 0;    ///< CV [energy/(mass temperature)]
  double heat_at_pressure = 0;  ///< CP [energy/(mass temperature)]
  double temperature = 0;       ///< T: of what flows in
  double vent = 0;              ///< MU AREA, or C23 A23 + CP23 AP23: effective area of orifices [length^2]
  double opening_pressure = 0;  ///< PPOP: orifices are closed until this is reached [stress]
  double ambient = 0;           ///< PE: absolute, and that of the gas at time zero [stress]
  double density = 0;           ///< RO: of the gas at time zero [mass/volume]
  Index inflow = no_index;      ///< LCID, LCMT: time, [mass/time]
  Index outflow = no_index;     ///< LOU: pressure, [mass/time]; instead of orifices
  Index temperature_time = no_index;  ///< LCT: time, temperature of what flows in; instead of the constant
};

/// Fabric in the surface that lets gas through (*MAT_FABRIC).
struct PorousFabric {
  std::vector<std::array<Index, 4>> segments;  ///< those of the surface that are of it
  double coefficient = 0;                      ///< FLC [-]
  Index coefficient_time = no_index;           ///< time, FLC; instead of the constant
  double area = 0;                             ///< FAC: effective area over that of the fabric [-]
  Index area_pressure = no_index;              ///< absolute pressure, FAC; instead of the constant
  bool by_velocity = false;  ///< the curve has the velocity of the gas through the fabric [length/time]
};

using VolumeFilling = std::variant<PressureOfVolume, AdiabaticGas, LinearFluid, InflatedGas>;

/// A closed surface and what is in it.
struct ControlVolume {
  UserId id = 0;
  std::string title;
  /// Nodes counter-clockwise seen from outside; a triangle repeats its third one.
  std::vector<std::array<Index, 4>> segments;
  double volume_scale = 1;    ///< VSCA: the filling has the volume of the surface times this [-]
  double pressure_scale = 1;  ///< PSCA: the surface feels the filling's pressure times this [-]
  VolumeFilling filling;
  std::vector<PorousFabric> porous{};  ///< of InflatedGas, besides its orifices
};

/// Volume that a closed surface of bilinear segments encloses, negative where nodes are clockwise seen from
/// outside. Exact: half of the sums over the tetrahedra of both ways to cut each segment into triangles.
double enclosed_volume(const std::vector<std::array<double, 3>>& positions,
                       const std::vector<std::array<Index, 4>>& segments);

}  // namespace crumple::model
