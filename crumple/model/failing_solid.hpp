// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace crumple::model {

/// Solids of J2 plasticity with linear isotropic hardening that fail by plastic strain or by tension
/// (*MAT_ISOTROPIC_ELASTIC_FAILURE). docs/theory/failing_solid.md.
struct FailingSolid {
  double youngs_modulus = 0;    ///< E [stress]
  double poissons_ratio = 0;    ///< nu [-]
  double yield_stress = 0;      ///< at zero plastic strain [stress]
  double hardening = 0;         ///< slope of the yield stress over the plastic strain [stress]
  double failure_strain = 0;    ///< EPF, effective plastic strain at which a point fails; 0 is none
  double failure_pressure = 0;  ///< PRF, pressure down to which a point is whole; 0 is none [stress]
  bool keeps_failed = false;    ///< failed points bear pressure alone; else they bear nothing and go
};

}  // namespace crumple::model
