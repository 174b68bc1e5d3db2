// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "model/model.hpp"

namespace crumple::elements {

/// A piecewise linear function, continued with the slopes of its ends. A view: owns nothing.
class SlopedCurve {
 public:
  SlopedCurve() = default;
  /// `numbers` holds `size` abscissas and then as many ordinates.
  SlopedCurve(const double* numbers, std::size_t size) : x_(numbers), y_(numbers + size), size_(size) {}

  bool empty() const { return size_ == 0; }
  double at(double x) const;

 private:
  const double* x_ = nullptr;
  const double* y_ = nullptr;
  std::size_t size_ = 0;
};

/// What a spring or damper remembers between two steps.
struct DiscreteHistory {
  double plastic = 0;    ///< plastic deformation
  double hardening = 0;  ///< sum of its amounts
};

/// The numbers of a law as ElementBlock::material_constants holds them, curves included.
std::vector<double> discrete_law_numbers(const model::SpringLaw& law, const model::Model& model);

/// A law of springs and dampers ready to be evaluated; reads `numbers`, which must outlive it. In torsional
/// elements moment stands for force and angle for deformation.
class DiscreteLaw {
 public:
  explicit DiscreteLaw(const std::vector<double>& numbers);

  /// The force at a deformation and its rate; brings the history up to date.
  double force(double deformation, double rate, DiscreteHistory& history) const;
  /// Largest stiffness there can be, zero of a damper.
  double stiffness() const { return stiffness_; }
  /// Largest damping there can be, zero of a spring.
  double damping() const { return damping_; }

 private:
  double plastic_force(double deformation, DiscreteHistory& history) const;

  double stiffness_ = 0;
  double damping_ = 0;
  double yield_force_ = 0;      ///< zero: does not yield
  double plastic_modulus_ = 0;  ///< yield force over plastic deformation
  SlopedCurve spring_, damper_, rate_factor_;
};

}  // namespace crumple::elements
