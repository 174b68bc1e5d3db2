// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Points of solids driven along given deformation gradients, with or without an equation of state.

#include <cmath>

#include "materials/solid_driver.hpp"
#include "support/larger.hpp"

namespace crumple::materials::testing {

inline constexpr Matrix unit{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

inline Matrix times(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}
/// a + factor b.
inline Matrix plus(const Matrix& a, double factor, const Matrix& b) {
  Matrix c = a;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) c[i][j] += factor * b[i][j];
  return c;
}
inline Matrix transposed(const Matrix& a) {
  Matrix t{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) t[i][j] = a[j][i];
  return t;
}
inline double determinant(const Matrix& a) {
  return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
         a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
         a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}
inline Matrix inverse(const Matrix& a) {
  Matrix inv{};
  const double over = 1 / determinant(a);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int r = (j + 1) % 3;
      const int s = (j + 2) % 3;
      const int p = (i + 1) % 3;
      const int q = (i + 2) % 3;
      inv[i][j] = over * (a[r][p] * a[s][q] - a[r][q] * a[s][p]);
    }
  return inv;
}
inline Matrix rotation(const std::array<double, 3>& axis, double angle) {
  return plus(turn_about(axis, angle), 1, unit);
}
inline Matrix matrix_of(const Six& s) {
  return {{{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}}};
}
inline Six six_of(const Matrix& m) {
  return {m[0][0], m[1][1], m[2][2], m[0][1], m[1][2], m[2][0]};
}
inline double largest_difference(const Six& a, const Six& b) {
  double largest = 0;
  for (int c = 0; c < 6; ++c) largest = test::larger_of(largest, std::fabs(a[c] - b[c]));
  return largest;
}

/// What an element hands over of a motion that is linear in time from one deformation gradient to another:
/// the gradient of the displacement about the middle, its symmetric part and the rotation of its skew part.
struct StepMotion {
  Six strain{};
  Matrix turn{};
};
inline StepMotion motion_between(const Matrix& from, const Matrix& to) {
  Matrix middle = plus(from, 1, to);
  for (auto& row : middle)
    for (double& value : row) value *= 0.5;
  const Matrix a = times(plus(to, -1, from), inverse(middle));
  Matrix half{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) half[i][j] = 0.25 * (a[i][j] - a[j][i]);
  const Matrix turn = plus(times(inverse(plus(unit, -1, half)), plus(unit, 1, half)), -1, unit);
  return {{a[0][0], a[1][1], a[2][2], a[0][1] + a[1][0], a[1][2] + a[2][1], a[2][0] + a[0][2]}, turn};
}

/// One point, the others of the tile stay at rest.
template <class Real>
class MotionDriver : public TileDriver<Real, domain::SolidBlock, solid_components> {
  using Base = TileDriver<Real, domain::SolidBlock, solid_components>;

 public:
  MotionDriver(const model::Material& material, Isa isa, const model::EquationOfState* equation = nullptr,
               const SolidCorners& corners = unit_corners())
      : Base(material, 1), update_(solid_material_update<Real>(isa, solid_material_kind(material.law))) {
    this->history_ = declare_solid_history(material.law, this->block_);
    std::vector<double> constants = solid_material_constants(material, equation);
    if (equation != nullptr) {
      const Index history = declare_eos_history(this->block_) - this->history_;
      own_ = constants.size();
      const std::vector<double> numbers = eos_constants(material, *equation, history);
      constants.insert(constants.end(), numbers.begin(), numbers.end());
    }
    this->allocate(constants, 3);
    if (solid_can_fail(material)) this->intact_.assign(tile_lanes, Real(-1));
    for (Index place = 0; place < tile_lanes; ++place)
      prepare_solid_element(material.law, corners, 1, this->block_, this->history_, place);
    turn_.assign(9 * tile_lanes, Real(0));
  }

  /// `viscosity` is the mean over the step of the pressure of bulk viscosity.
  void move_to(const Matrix& to, double step = 1, double viscosity = 0) {
    const StepMotion motion = motion_between(at_, to);
    const double middle = 0.5 * (determinant(at_) + determinant(to));
    this->set_strain(0, 0, motion.strain);
    for (int k = 0; k < 9; ++k) turn_[k * tile_lanes] = static_cast<Real>(motion.turn[k / 3][k % 3]);
    this->out_[tile_lanes] = static_cast<Real>(viscosity);
    auto task = this->template task<SolidMaterialTask<Real>>(step);
    task.turn = turn_.data();
    if (own_ > 0) task.equation_of_state = this->block_.material_constants.data() + own_;
    task.viscosity = this->out_.data() + tile_lanes;
    task.wave_speed = this->out_.data() + 2 * tile_lanes;
    update_(task);
    work_ += middle * static_cast<double>(this->out_[0]);
    at_ = to;
  }
  /// In equal pieces of the displacement.
  void move_in_steps(const Matrix& to, int steps, double step = 1) {
    const Matrix from = at_;
    for (int i = 1; i <= steps; ++i)
      move_to(plus(from, static_cast<double>(i) / steps, plus(to, -1, from)), step);
  }

  const Matrix& at() const { return at_; }
  /// Per volume at time zero.
  double work() const { return work_; }
  double wave_speed() const { return static_cast<double>(this->out_[2 * tile_lanes]); }
  double pressure() const { return -mean(this->stress()); }

 private:
  SolidMaterialUpdate<Real> update_;
  AlignedArray<Real> turn_;
  std::size_t own_ = 0;
  Matrix at_ = unit;
  double work_ = 0;
};

inline Matrix volumetric(double volume) {
  const double side = std::cbrt(volume);
  return {{{side, 0, 0}, {0, side, 0}, {0, 0, side}}};
}

}  // namespace crumple::materials::testing
