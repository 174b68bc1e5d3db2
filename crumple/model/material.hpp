// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "base/index.hpp"

namespace crumple::model {

/// Linear isotropic elasticity (LS-DYNA's *MAT_ELASTIC).
struct Elastic {
  double youngs_modulus = 0;  ///< E [stress]
  double poissons_ratio = 0;  ///< nu [-]
};

/// J2 plasticity with linear hardening, mixed isotropic and kinematic (*MAT_PLASTIC_KINEMATIC).
struct PlasticKinematic {
  double youngs_modulus = 0;           ///< E [stress]
  double poissons_ratio = 0;           ///< nu [-]
  double yield_stress = 0;             ///< sigma_0, at zero plastic strain and rate [stress]
  double tangent_modulus = 0;          ///< E_t, slope of the uniaxial stress over total strain [stress]
  double isotropic_fraction = 0;       ///< beta: 0 is kinematic, 1 is isotropic hardening
  double cowper_symonds_rate = 0;      ///< C [1/time]; 0 switches the rate effect off
  double cowper_symonds_exponent = 0;  ///< p [-]
  double failure_strain = 0;           ///< effective plastic strain at failure; 0 is none
};

/// J2 plasticity with tabulated isotropic hardening (*MAT_PIECEWISE_LINEAR_PLASTICITY).
struct PiecewiseLinearPlasticity {
  double youngs_modulus = 0;           ///< E [stress]
  double poissons_ratio = 0;           ///< nu [-]
  std::vector<double> plastic_strain;  ///< effective plastic strain, ascending from 0
  std::vector<double> yield_stress;    ///< yield stress at those strains [stress]; last slope 0 beyond
  double cowper_symonds_rate = 0;      ///< C [1/time]; 0 switches the rate effect off
  double cowper_symonds_exponent = 0;  ///< p [-]
  double failure_strain = 0;           ///< effective plastic strain at failure; 0 is none
};

/// The constitutive law and its constants. A new law is one more alternative here.
using ConstitutiveLaw = std::variant<Elastic, PlasticKinematic, PiecewiseLinearPlasticity>;

struct Material {
  UserId id = 0;
  std::string title;
  double density = 0;  ///< rho [mass/volume]
  ConstitutiveLaw law;
};

}  // namespace crumple::model
