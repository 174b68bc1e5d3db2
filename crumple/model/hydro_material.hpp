// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model/spall.hpp"

namespace crumple::model {

/// Solids whose deviator is elastic-plastic and whose pressure is that of an equation of state
/// (*MAT_ELASTIC_PLASTIC_HYDRO). docs/theory/elastic_plastic_hydro.md.
struct HydroPlasticity {
  double youngs_modulus = 0;             ///< of G and the equation of state at rest [stress]
  double poissons_ratio = 0.3;           ///< the same [-]
  double shear_modulus = 0;              ///< G [stress]
  std::vector<double> plastic_strain{};  ///< ascending from 0
  std::vector<double> yield_stress{};    ///< there [stress]; the slope before the last point goes on
  double hardening = 0;                  ///< EH: slope of the yield stress behind one point alone [stress]
  double pressure_factor = 0;            ///< A1: of the pressure above zero, added to the yield stress [-]
  double pressure_square = 0;            ///< A2: of its square [1/stress]
  double least_pressure = 0;             ///< PC, not above zero; 0 is no cut-off [stress]
  Spall spall = Spall::None;             ///< what happens at the cut-off
  double failure_strain = 0;             ///< FS, effective plastic strain; 0 is none
};

}  // namespace crumple::model
