// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "base/aligned_array.hpp"
#include "domain/node_fields.hpp"

namespace crumple::timeloop {

/// The frequency that a relaxation still moves with, from its last velocities (IRELAL). With
/// v(n+1/2) = k v(n-1/2) + step a(n) for all nodes, (w step)^2 is the change of acceleration along the
/// motion:
///
///     - sum m v2.((v3 - k v2) - (v2 - k v1)) / sum m v2.v2         v1, v2, v3 one after the other
///
/// a Rayleigh quotient of the present increment, as P. Underwood has it (in T. Belytschko, T.J.R. Hughes,
/// Computational Methods for Transient Analysis, North-Holland 1983, chapter 5). Where one mode c is left,
/// v2 = c v1, it is 1 + k - c - k / c, the relation of M. Papadrakakis (Comput. Methods Appl. Mech. Eng. 25,
/// 1981, 35-48).
class SlowestRate {
 public:
  /// `tolerance`: two successive estimates that differ by less are steady [-].
  explicit SlowestRate(double tolerance) : tolerance_(tolerance) {}

  /// (w step)^2 where it is steady and above zero. To be called after each step; `factor`: the k of it.
  std::optional<double> observe(const domain::NodeFields& nodes, double factor);

 private:
  double tolerance_;
  AlignedArray<math::Vec3> first_;   ///< v1 [length/time]
  AlignedArray<math::Vec3> second_;  ///< v2 [length/time]
  double last_factor_ = 0;
  double estimate_ = 0;
};

}  // namespace crumple::timeloop
