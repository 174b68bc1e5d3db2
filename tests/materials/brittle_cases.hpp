// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Samples of the laws of Johnson & Holmquist, and the paths that their tests take.

#include <algorithm>
#include <cmath>

#include "materials/motion_driver.hpp"

namespace crumple::materials::testing {

/// Alumina (G.R. Johnson & T.J. Holmquist, AIP Conf. Proc. 309 (1994) 981-984), in t, mm, s; without rate
/// effect.
inline model::Material alumina() {
  model::Material material;
  material.id = 110;
  material.density = 3.7e-9;
  model::HolmquistCeramic law;
  law.shear_modulus = 90160;
  law.intact_factor = 0.93;
  law.fractured_factor = 0.31;
  law.fractured_power = 0.6;
  law.intact_power = 0.6;
  law.tension = 200;
  law.elastic_limit = 2790;
  law.limit_pressure = 1460;
  law.bulking = 1;
  law.fracture_factor = 0.005;
  law.fracture_power = 1;
  law.bulk_modulus = 130950;
  model::set_elastic(law);
  material.law = law;
  return material;
}
inline model::HolmquistCeramic& ceramic_law(model::Material& material) {
  return std::get<model::HolmquistCeramic>(material.law);
}

/// Concrete of 48 MPa (T.J. Holmquist, G.R. Johnson & W.H. Cook, 14th Int. Symp. on Ballistics (1993)
/// 591-600), in t, mm, s; without rate effect.
inline model::Material ballistic_concrete() {
  model::Material material;
  material.id = 111;
  material.density = 2.44e-9;
  model::HolmquistConcrete law;
  law.shear_modulus = 14860;
  law.cohesion = 0.79;
  law.pressure_factor = 1.6;
  law.pressure_power = 0.61;
  law.strength = 48;
  law.tension = 4;
  law.least_fracture = 0.01;
  law.largest_strength = 7;
  law.crush_pressure = 16;
  law.crush_volume = 0.001;
  law.lock_pressure = 800;
  law.lock_volume = 0.1;
  law.fracture_factor = 0.04;
  law.fracture_power = 1;
  law.bulk_modulus = 85000;
  law.bulk_quadratic = -171000;
  law.bulk_cubic = 208000;
  model::set_elastic(law);
  material.law = law;
  return material;
}
inline model::HolmquistConcrete& ballistic_law(model::Material& material) {
  return std::get<model::HolmquistConcrete>(material.law);
}

/// The same compression along all axes.
inline Matrix squeezed_to(double mu) {
  return volumetric(1 / (1 + mu));
}
/// Pure shear by the logarithmic angle gamma, at constant volume, after a compression. Its effective strain
/// is gamma/sqrt(3).
inline Matrix sheared(double gamma, const Matrix& first) {
  Matrix pure = unit;
  pure[0][0] = pure[1][1] = std::cosh(gamma / 2);
  pure[0][1] = pure[1][0] = std::sinh(gamma / 2);
  return times(pure, first);
}
/// Compression along y alone.
inline Matrix confined(double mu) {
  return {{{1, 0, 0}, {0, 1 / (1 + mu), 0}, {0, 0, 1}}};
}

}  // namespace crumple::materials::testing
