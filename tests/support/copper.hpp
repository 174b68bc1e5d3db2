// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Copper in mm, us and mg: km/s, GPa, mg/mm^3.

#include "model/material.hpp"

namespace crumple::test {

inline constexpr double copper_density = 8.93;

/// The strength of OFHC copper after G.R. Johnson & W.H. Cook, 7th Int. Symp. Ballistics (1983), without
/// heating.
inline model::JohnsonCook ofhc_copper() {
  model::JohnsonCook law;
  law.youngs_modulus = 124;
  law.poissons_ratio = 0.34;
  law.yield_stress = 0.09;
  law.hardening = 0.292;
  law.exponent = 0.31;
  law.rate_coefficient = 0.025;
  law.reference_rate = 1e-6;
  return law;
}

}  // namespace crumple::test
