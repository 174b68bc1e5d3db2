// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "domain/domain.hpp"
#include "support/larger.hpp"

namespace crumple::test {

/// Largest change of the unbalanced energy after the first step. That one has the kinetic energy of the start
/// as it stands, m v(0)^2 / 2, and with forces at time zero misses f^2 dt^2 / (8 m) of the product form.
class ImbalanceAfterStart {
 public:
  void observe(const domain::Domain& domain) {
    if (domain.clock.cycle < 1) return;
    if (domain.clock.cycle == 1) first_ = domain.energy.imbalance();
    largest_ = larger_of(largest_, std::fabs(domain.energy.imbalance() - first_));
  }
  double largest() const { return largest_; }  ///< [energy]

 private:
  double first_ = 0;
  double largest_ = 0;
};

}  // namespace crumple::test
