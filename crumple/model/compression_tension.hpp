// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace crumple::model {

/// J2 plasticity whose yield stress differs in compression and tension, by the mean stress
/// (*MAT_PLASTICITY_COMPRESSION_TENSION). docs/theory/compression_tension.md.
struct CompressionTension {
  double youngs_modulus = 0;                 ///< E [stress]
  double poissons_ratio = 0;                 ///< nu [-]
  std::vector<double> compression_strain{};  ///< effective plastic strain, ascending from 0
  std::vector<double> compression_stress{};  ///< yield stress there [stress]; constant beyond
  std::vector<double> tension_strain{};      ///< the same in tension
  std::vector<double> tension_stress{};
  double compression_pressure = 0;  ///< PC: from this pressure on compression alone counts [stress]
  double tension_pressure = 0;      ///< PT: from this amount of negative pressure on tension alone [stress]
  double cowper_symonds_rate = 0;   ///< C [1/time]; 0 switches the rate effect off
  double cowper_symonds_exponent = 0;  ///< p [-]
  double failure_strain = 0;           ///< effective plastic strain at failure; 0 is none
  bool viscoplastic = true;            ///< the rate is that of the plastic strain, always
};

}  // namespace crumple::model
