// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A honeycomb whose axes are turned, and paths along and between them.

#include <array>
#include <cmath>

#include "materials/motion_driver.hpp"

namespace crumple::materials::testing::honeycomb_support {

inline constexpr double modulus = 70000;  // MPa
inline constexpr double poisson = 0.33;
inline constexpr double solid_yield = 240;
inline constexpr double compacted = 0.3;
inline const std::array<double, 6> moduli{1000, 200, 150, 400, 220, 90};
inline const double full_shear = 0.5 * modulus / (1 + poisson);
inline const double bulk = modulus / (3 * (1 - 2 * poisson));

/// Each component has a curve of its own, all with a kink at 0.4.
inline model::Honeycomb::Crush curve(int component) {
  const double scale = 1 + 0.3 * component;
  return {{0, 0.4, 0.65}, {2 * scale, 2.2 * scale, 6 * scale}};
}
inline double yield_at(int component, double crush) {
  const auto [strain, stress] = curve(component);
  const std::size_t k = crush > strain[1] ? 1 : 0;
  return stress[k] + (crush - strain[k]) * (stress[k + 1] - stress[k]) / (strain[k + 1] - strain[k]);
}
/// With axes turned against the global ones by 1.1 rad about a slanted axis.
inline const Matrix tilt = rotation({2.0 / 3, -1.0 / 3, 2.0 / 3}, 1.1);

inline model::Material honeycomb() {
  model::Material material;
  material.id = 26;
  material.density = 8e-11;
  model::Honeycomb law;
  law.youngs_modulus = modulus;
  law.poissons_ratio = poisson;
  law.yield_stress = solid_yield;
  law.compacted_volume = compacted;
  law.moduli = moduli;
  for (int k = 0; k < 6; ++k) law.crush[k] = curve(k);
  law.axes = model::Honeycomb::Axes::Vectors;
  for (int i = 0; i < 3; ++i) law.a[i] = 3 * tilt[i][0];
  for (int i = 0; i < 3; ++i) law.d[i] = tilt[i][1] - 0.4 * tilt[i][0];
  material.law = law;
  return material;
}
inline model::Material changed(void (*change)(model::Honeycomb&)) {
  model::Material material = honeycomb();
  change(std::get<model::Honeycomb>(material.law));
  return material;
}
inline void no_yield(model::Honeycomb& law) {
  for (auto& component : law.crush) component = {{0, 1}, {1e9, 1e9}};
}

/// A tensor in the material axes, seen from the global ones.
inline Matrix global(const Matrix& local) {
  return times(tilt, times(local, transposed(tilt)));
}
inline Six local(const Six& stress) {
  return six_of(times(transposed(tilt), times(matrix_of(stress), tilt)));
}
inline Matrix stretch(const std::array<double, 3>& side) {
  return {{{side[0], 0, 0}, {0, side[1], 0}, {0, 0, side[2]}}};
}
inline Matrix along(int axis, double side) {
  std::array<double, 3> sides{1, 1, 1};
  sides[axis] = side;
  return global(stretch(sides));
}
/// Pure shear by engineering strain gamma between two axes, without spin and without change of volume.
inline Matrix sheared(int component, double gamma) {
  const int i = component - 3;
  const int j = (i + 1) % 3;
  Matrix f = unit;
  f[i][i] = f[j][j] = std::cosh(gamma / 2);
  f[i][j] = f[j][i] = std::sinh(gamma / 2);
  return f;
}

}  // namespace crumple::materials::testing::honeycomb_support
