// SPDX-License-Identifier: BSD-3-Clause
#include "elements/line/section_frequency.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace crumple::elements {
namespace {

using Square = std::array<std::array<double, 3>, 3>;

/// Just above the largest eigenvalue of a symmetric matrix that has no negative one: the Frobenius norm of
/// its power 2^k is the largest eigenvalue to that power times at most the root of 3.
double eigenvalue_from_above(Square matrix) {
  constexpr int squarings = 6;
  double eigenvalue = 1;
  for (int k = 0; k <= squarings; ++k) {
    double sum = 0;
    for (const auto& row : matrix)
      for (const double number : row) sum += number * number;
    const double norm = std::sqrt(sum);
    if (!(norm > 0)) return 0;
    double root = norm;
    for (int i = 0; i < k; ++i) root = std::sqrt(root);
    eigenvalue *= root;
    Square next{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t n = 0; n < 3; ++n) next[i][j] += matrix[i][n] / norm * (matrix[n][j] / norm);
    matrix = next;
  }
  return eigenvalue;
}

/// Adds a point whose strain is `share` of three numbers of the cross section.
void add_point(const std::array<double, 3>& share, double stiffness, Square& matrix) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) matrix[i][j] += stiffness * share[i] * share[j];
}

void scale(const std::array<double, 3>& root, double factor, Square& matrix) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) matrix[i][j] *= factor * root[i] * root[j];
}

}  // namespace

// The six strains are orthogonal in the inverse of the mass: the square of their norm there is 2 / m l^2 of
// the stretch, 2 / J l^2 of curvatures and twist, 2 / m l^2 + 1 / 2J of the shears.
double highest_frequency_squared(const model::BeamSection& section, const BeamDynamics& beam) {
  Square axial{};  // stretch, curvature about s, about t
  Square shear{};  // twist, shear along s, along t
  for (const model::SectionPoint& point : section.points) {
    add_point({1, point.t, -point.s}, beam.youngs_modulus * point.area, axial);
    add_point({-point.t, 1, 0}, beam.shear_modulus * point.area, shear);
    add_point({point.s, 0, 1}, beam.shear_modulus * point.area, shear);
  }
  const double square = beam.length * beam.length;
  const double stretching = std::sqrt(2 / (beam.mass * square));
  const double turning = std::sqrt(2 / (beam.inertia * square));
  const double shearing = std::sqrt(section.shear_factor * (2 / (beam.mass * square) + 0.5 / beam.inertia));
  scale({stretching, turning, turning}, beam.length, axial);
  scale({turning, shearing, shearing}, beam.length, shear);
  return std::max(eigenvalue_from_above(axial), eigenvalue_from_above(shear));
}

}  // namespace crumple::elements
