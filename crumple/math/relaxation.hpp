// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "math/power.hpp"

namespace crumple::math {

/// What a step makes of a force or stress that relaxes exponentially: exact where the rate of deformation is
/// constant in the step (L.R. Herrmann & F.E. Peterson, Proc. 7th ICRPG Mechanical Behavior Meeting, 1968).
struct Relaxation {
  double lost = 0;    ///< 1 - exp(-decay dt), taken from the force
  double gained = 0;  ///< force per increment of deformation
};

/// `modulus`: force per deformation at once; `decay` [1/time]; `step` [time].
inline Relaxation relaxation(double modulus, double decay, double step) {
  const double x = decay * step;
  // Of small x the difference from 1 would lose its digits: (1 - exp(-x)) / x by its series.
  constexpr double small = 0.02;
  double mean = 1;
  if (x >= small)
    mean = (1 - power_of_two(-1.4426950408889634 * x)) / x;
  else
    for (int k = 7; k >= 2; --k) mean = 1 - x / k * mean;
  return {x * mean, modulus * mean};
}

}  // namespace crumple::math
