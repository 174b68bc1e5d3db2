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
  /// Where the value is y, of a curve that rises.
  double inverse(double y) const;

 private:
  const double* x_ = nullptr;
  const double* y_ = nullptr;
  std::size_t size_ = 0;
};

/// The motion of a step of a spring or damper.
struct DiscreteMotion {
  double deformation = 0;  ///< at its end
  double change = 0;       ///< of the deformation in the step
  double rate = 0;         ///< of the deformation
  double time = 0;         ///< at its end
  double step = 0;         ///< may be 0
};

/// What a spring or damper remembers between two steps.
struct DiscreteHistory {
  double plastic = 0;    ///< plastic deformation, or that of a damper in series with a spring
  double hardening = 0;  ///< sum of its amounts
};

/// The numbers of a law as ElementBlock::material_constants holds them, curves included.
std::vector<double> discrete_law_numbers(const model::SpringLaw& law, const model::Model& model);

/// A law of springs and dampers ready to be evaluated; reads `numbers`, which must outlive it. In torsional
/// elements moment stands for force and angle for deformation.
class DiscreteLaw {
 public:
  explicit DiscreteLaw(const std::vector<double>& numbers);

  /// The force at the end of the step; brings the history up to date.
  double force(const DiscreteMotion& motion, DiscreteHistory& history) const;
  /// Largest stiffness there can be, zero of a damper.
  double stiffness() const { return stiffness_; }
  /// Largest damping there can be, zero of a spring.
  double damping() const { return damping_; }

 private:
  double plastic_force(double deformation, DiscreteHistory& history) const;
  double relaxing_force(const DiscreteMotion& motion, DiscreteHistory& history) const;
  double one_sided_force(double deformation, DiscreteHistory& history) const;

  double stiffness_ = 0;
  double damping_ = 0;
  double yield_force_ = 0;      ///< zero: does not yield
  double plastic_modulus_ = 0;  ///< yield force over plastic deformation
  double relaxing_ = 0;         ///< stiffness that goes with time; zero: none
  double decay_ = 0;
  double cut_off_ = 0;
  double cut_off_force_ = 0;
  double side_ = 0;  ///< 1: bears tension alone, -1: compression alone; 0: both
  SlopedCurve spring_, damper_, rate_factor_;
};

}  // namespace crumple::elements
