// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "model/control_volume.hpp"
#include "model/curve.hpp"

namespace crumple::loads {

/// What fills a control volume at a time. Numbers only, all of which a restart needs.
struct FillingState {
  double volume = 0;          ///< of the filling [volume]
  double initial_volume = 0;  ///< [volume]
  double pressure = 0;        ///< above the ambient one [stress]
  double stiffness =
      0;               ///< what the pressure loses by a unit of volume at constant mass, or 0 [stress/volume]
  double mass = 0;     ///< [mass]
  double energy = 0;   ///< internal energy; 0 where the law has none [energy]
  double inflow = 0;   ///< [mass/time]
  double outflow = 0;  ///< [mass/time]
  double temperature = 0;  ///< 0 where the law has none
  double vents_open = 0;   ///< 1 once the pressure has reached that which opens them
};

/// Fabric that lets gas through, and its area at the end of a step.
struct PorousArea {
  const model::PorousFabric* fabric = nullptr;
  double area = 0;  ///< [length^2]
};

/// The time that a filling goes on to, and the volume that it then has.
struct FillingStep {
  double time = 0;                          ///< at the end [time]
  double length = 0;                        ///< [time]
  double volume = 0;                        ///< at the end [volume]
  std::span<const PorousArea> porous = {};  ///< counts for gas that flows in and out
};

/// The laws of what may fill a control volume. Sources: LS-DYNA Keyword User's Manual, *AIRBAG; outflow
/// through an orifice: J.T. Wang and O.J. Nefske, A new CAL3D airbag inflation model, SAE 880654 (1988),
/// which is the isentropic nozzle of A. Saint-Venant and L. Wantzel (1839); the rest in
/// docs/theory/airbags.md.
class Filling {
 public:
  /// Curves and filling must outlive it.
  Filling(const model::VolumeFilling& filling, const std::vector<model::Curve>& curves)
      : filling_(&filling), curves_(&curves) {}

  /// The filling at time zero in a volume [volume].
  FillingState initial(double volume) const;

  /// Goes on by a step.
  void advance(FillingState& state, const FillingStep& step) const;

 private:
  const model::VolumeFilling* filling_;
  const std::vector<model::Curve>* curves_;
};

/// Mass that flows through an orifice of unit effective area from a gas of absolute pressure p and density
/// rho into a room of absolute pressure `ambient`, isentropic; choked above the critical ratio
/// [mass/(time length^2)]. `exponent` is the ratio of the specific heats. Nothing flows back.
double orifice_flow(double pressure, double density, double ambient, double exponent);

}  // namespace crumple::loads
