// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/body_share.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace crumple::constraints {

namespace {

using math::Vec3;
using Matrix6 = std::array<std::array<double, 6>, 6>;

/// Of the nodes about the body's centre, in its axes: translations, then rotations.
Matrix6 mass_matrix(const domain::RigidBody& body, const domain::NodeFields& nodes) {
  Matrix6 sum{};
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const double mass = nodes.mass[body.nodes[i]];
    const Vec3& r = body.arm[i];
    std::array<Vec3, 6> motion{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    for (std::size_t axis = 0; axis < 3; ++axis) motion[3 + axis] = cross(motion[axis], r);
    for (std::size_t a = 0; a < 6; ++a)
      for (std::size_t b = 0; b < 6; ++b) sum[a][b] += mass * dot(motion[a], motion[b]);
  }
  return sum;
}

double size_of(const Matrix6& matrix) {
  double sum = 0;
  for (const auto& row : matrix)
    for (const double number : row) sum += number * number;
  return std::sqrt(sum);
}

Matrix6 squared_over(const Matrix6& matrix, double size) {
  Matrix6 found{};
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = 0; b < 6; ++b)
      for (std::size_t k = 0; k < 6; ++k) found[a][b] += matrix[a][k] / size * (matrix[k][b] / size);
  return found;
}

/// Upper bound of the largest eigenvalue of a symmetric matrix, by the norm of its 64th power: at most 1.4 %
/// above it. Roots alone, so that the bits are the same everywhere.
double largest_eigenvalue(Matrix6 matrix) {
  constexpr int squarings = 6;
  std::array<double, squarings + 1> sizes{};
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    sizes[i] = size_of(matrix);
    if (!(sizes[i] > 0)) return 0;
    matrix = squared_over(matrix, sizes[i]);
  }
  double bound = sizes[squarings];
  for (std::size_t i = squarings; i-- > 0;) bound = sizes[i] * std::sqrt(bound);
  return bound;
}

}  // namespace

double share_of_masses(const domain::RigidBody& body, const domain::NodeFields& nodes) {
  Matrix6 ratio = mass_matrix(body, nodes);
  std::array<double, 6> over{};
  for (int k = 0; k < 6; ++k) {
    const double own = k < 3 ? body.mass : body.principal_inertia[k - 3];
    over[static_cast<std::size_t>(k)] = own > 0 ? 1 / std::sqrt(own) : 0;
  }
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = 0; b < 6; ++b) ratio[a][b] *= over[a] * over[b];
  constexpr double same = 1.02;  // by what the bound may be too large
  const double largest = largest_eigenvalue(ratio);
  return largest > same ? 1 / largest : 1;
}

}  // namespace crumple::constraints
