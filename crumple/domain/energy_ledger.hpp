// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace crumple::domain {

/// Where the energy is at time n, all in double [energy]. Work is summed by the trapezoidal rule over steps,
/// kinetic energy is 1/2 m v(n-1/2).v(n+1/2): with a constant step these two balance to round-off
/// (docs/theory/energy.md), so that what is left is an error and no artefact of the bookkeeping.
struct EnergyLedger {
  double kinetic = 0;
  double internal = 0;
  double hourglass = 0;
  double contact = 0;             ///< stored and dissipated in contact along the normal
  double contact_dissipated = 0;  ///< of that, by damping of contact and by ties that ended
  double friction = 0;            ///< dissipated by contact friction
  double rigidwall = 0;           ///< taken away by rigid walls
  double damping = 0;
  double external_work = 0;  ///< done on the model by loads and prescribed motion
  double eroded = 0;         ///< internal and hourglass energy of elements when they failed
  double initial_total = 0;  ///< total at time zero

  double total() const {
    return kinetic + internal + hourglass + contact + friction + rigidwall + damping + eroded;
  }
  /// Total over initial plus external work, as users of LS-DYNA know it. 1 if both are zero.
  double ratio() const {
    const double reference = initial_total + external_work;
    return reference != 0 ? total() / reference : 1.0;
  }
  /// Unbalanced energy [energy].
  double imbalance() const { return total() - initial_total - external_work; }
  /// Internal, hourglass, contact, friction and eroded energy [energy].
  double absorbed() const { return internal + hourglass + contact + friction + eroded; }
  /// Contact energy that can only be what penalty springs hold, or an error [energy].
  double contact_springs() const { return contact - contact_dissipated; }
  /// |unbalanced energy| over the largest energy absorbed so far, or now if that is more: bodies that rebound
  /// have given it back [-]. Where next to nothing has been absorbed, as at the first cycles or by rigid
  /// bodies alone, over that share of the largest energy.
  double error(double largest_absorbed = 0, double least_share = 1e-6) const {
    const double largest =
        std::fmax(std::fabs(kinetic), std::fmax(std::fabs(initial_total), std::fabs(external_work)));
    const double reference =
        std::fmax(least_share * largest, std::fmax(std::fabs(absorbed()), largest_absorbed));
    return reference == 0 ? 0.0 : std::fabs(imbalance()) / reference;
  }
};

}  // namespace crumple::domain
