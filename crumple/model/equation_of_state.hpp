// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <variant>

#include "base/index.hpp"

namespace crumple::model {

/// Mie-Gruneisen with the shock velocity as a polynomial of the particle velocity (*EOS_GRUNEISEN).
struct Gruneisen {
  double sound_speed = 0;          ///< C, intercept of the shock velocity [length/time]
  std::array<double, 3> slopes{};  ///< S1, S2, S3 [-]
  double gamma = 0;                ///< Gruneisen's coefficient at the reference density [-]
  double volume_correction = 0;    ///< a: the coefficient is gamma + a mu [-]
};

/// Pressure as a polynomial of the compression, linear in the energy (*EOS_LINEAR_POLYNOMIAL).
struct LinearPolynomial {
  std::array<double, 7> coefficients{};  ///< C0 to C3 [stress], C4 to C6 [-]
};

/// The relation between pressure, volume and internal energy. A new one is one more alternative here.
using PressureLaw = std::variant<Gruneisen, LinearPolynomial>;

struct EquationOfState {
  UserId id = 0;
  std::string title;
  double initial_energy = 0;  ///< E0 per reference volume [energy/volume]
  double initial_volume = 1;  ///< V0, reference density over density at time zero [-]
  PressureLaw law;
};

/// Slope of the pressure over the compression at constant entropy at time zero, of a material with this
/// reference density: its bulk modulus [stress]. Not above zero where the equation of state gives no
/// stiffness.
double initial_bulk_modulus(const EquationOfState& equation, double density);

}  // namespace crumple::model
