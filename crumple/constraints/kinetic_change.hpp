// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace crumple::constraints {

/// What the kinetic energy of the nodes at time n changes by [energy].
struct KineticChange {
  double translational = 0;
  double rotational = 0;
};

}  // namespace crumple::constraints
