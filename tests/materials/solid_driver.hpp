// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "domain/solid_block.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/tile_driver.hpp"

namespace crumple::materials::testing {

using Six = std::array<double, solid_components>;  ///< xx, yy, zz, xy, yz, zx
using Matrix = std::array<std::array<double, 3>, 3>;

inline double equivalent(const Six& s) {
  const double mean = (s[0] + s[1] + s[2]) / 3;
  double square = 0;
  for (int c = 0; c < 3; ++c) square += 1.5 * (s[c] - mean) * (s[c] - mean) + 3 * s[c + 3] * s[c + 3];
  return std::sqrt(square);
}
/// Effective deviatoric strain; the shears are engineering strains.
inline double effective(const Six& e) {
  return equivalent({e[0], e[1], e[2], e[3] / 2, e[4] / 2, e[5] / 2}) / 1.5;
}
inline double mean(const Six& s) {
  return (s[0] + s[1] + s[2]) / 3;
}

/// Rotation about an axis of length 1 by an angle, less the unit matrix (Rodrigues).
inline Matrix turn_about(const std::array<double, 3>& axis, double angle) {
  const Matrix k{{{0, -axis[2], axis[1]}, {axis[2], 0, -axis[0]}, {-axis[1], axis[0], 0}}};
  const double half = std::sin(angle / 2);
  Matrix d{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double square = 0;
      for (int m = 0; m < 3; ++m) square += k[i][m] * k[m][j];
      d[i][j] = std::sin(angle) * k[i][j] + 2 * half * half * square;
    }
  return d;
}
/// The rotation (I + D) (I + E) less the unit matrix.
inline Matrix after(const Matrix& d, const Matrix& e) {
  Matrix all{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      all[i][j] = d[i][j] + e[i][j];
      for (int m = 0; m < 3; ++m) all[i][j] += d[i][m] * e[m][j];
    }
  return all;
}
/// R s R^T, R = I + D. A strain's shears are halved before and doubled after with shear = 0.5.
inline Six rotated(const Six& s, const Matrix& d, double shear = 1) {
  const Matrix t{{{s[0], shear * s[3], shear * s[5]},
                  {shear * s[3], s[1], shear * s[4]},
                  {shear * s[5], shear * s[4], s[2]}}};
  Matrix r = d;
  for (int i = 0; i < 3; ++i) r[i][i] += 1;
  Matrix out{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int m = 0; m < 3; ++m)
        for (int n = 0; n < 3; ++n) out[i][j] += r[i][m] * t[m][n] * r[j][n];
  return {out[0][0], out[1][1], out[2][2], out[0][1] / shear, out[1][2] / shear, out[2][0] / shear};
}

/// Corners of a cube along the axes.
inline SolidCorners unit_corners() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
}

/// One tile of solids with `points` points each, driven by strain increments and rotations.
template <class Real>
class SolidDriver : public TileDriver<Real, domain::SolidBlock, solid_components> {
  using Base = TileDriver<Real, domain::SolidBlock, solid_components>;

 public:
  SolidDriver(const model::Material& material, Isa isa, int points = 1,
              const SolidCorners& corners = unit_corners())
      : Base(material, points), update_(solid_material_update<Real>(isa, solid_material_kind(material.law))) {
    this->history_ = declare_solid_history(material.law, this->block_);
    this->allocate(solid_material_constants(material), static_cast<std::size_t>(points));
    for (Index place = 0; place < tile_lanes; ++place)
      prepare_solid_element(material.law, corners, 1, this->block_, this->history_, place);
    turn_.assign(static_cast<std::size_t>(points) * 9 * tile_lanes, Real(0));
  }

  void set_turn(Index element, int point, const Matrix& turn) {
    for (int k = 0; k < 9; ++k)
      turn_[(static_cast<std::size_t>(point) * 9 + k) * tile_lanes + element] =
          static_cast<Real>(turn[k / 3][k % 3]);
  }

  /// Applies the strains and rotations that were set.
  void apply(double step = 1) {
    auto task = this->template task<SolidMaterialTask<Real>>(step);
    task.turn = turn_.data();
    update_(task);
  }

  /// Applies one increment to point 0 of element 0.
  void apply(const Six& strain, double step = 1) {
    this->set_strain(0, 0, strain);
    apply(step);
  }

  /// Applies xx and whatever yy = zz leaves the stresses yy and zz at zero.
  void apply_uniaxial(double xx, double step = 1) {
    this->solve_lateral(-poissons_ratio * xx, -0.5 * xx, [&](double yy) {
      apply({xx, yy, yy, 0, 0, 0}, step);
    });
  }

  double energy(Index element = 0, int point = 0) const {
    return static_cast<double>(this->out_[point * tile_lanes + element]);
  }

 private:
  SolidMaterialUpdate<Real> update_;
  AlignedArray<Real> turn_;
};

}  // namespace crumple::materials::testing
