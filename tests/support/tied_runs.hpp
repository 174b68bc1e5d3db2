// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the models of ties.hpp tell when they are run, shared by the tests of ties by constraint and by
// springs.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "support/conservation.hpp"
#include "support/larger.hpp"
#include "support/ties.hpp"

namespace crumple::test {

struct Reflection {
  double amplitude = 0;  ///< of the velocity that came back from the joint, over that of the pulse [-]
  double energy_error = 0;
};

/// Runs two_bars(): by the end the pulse is in the second half; what is left in the first one came back.
inline Reflection reflection(const model::Model& model) {
  timeloop::Simulation simulation(model, execution());
  run(simulation);
  const domain::Domain& domain = simulation.domain();
  double behind = 0;
  double ahead = 0;
  for (Index i = 0; i < domain.nodes.count(); ++i) {
    const double energy = domain.nodes.mass[i] * dot(domain.nodes.velocity[i], domain.nodes.velocity[i]);
    (domain.nodes.reference[i].x < 100 ? behind : ahead) += energy;
  }
  return {std::sqrt(behind / (ahead + behind)), domain.energy.error()};
}

struct Deflection {
  double largest = 0;  ///< of the loaded edge [length]
  double energy_error = 0;
};

/// The largest of the loaded nodes along an axis.
inline Deflection deflection_along(const model::Model& model, int axis) {
  timeloop::Simulation simulation(model, execution());
  Deflection found;
  run(simulation, [&](const domain::Domain& domain) {
    for (const model::NodalLoad& load : model.nodal_loads)
      found.largest = larger_of(found.largest, std::fabs(displacement(domain, load.node)[axis]));
  });
  found.energy_error = simulation.domain().energy.error();
  return found;
}

/// Runs shell_joint().
inline Deflection deflection(const model::Model& model) {
  return deflection_along(model, 1);
}

/// Of a strip in the plane z = 0.
inline Deflection tip_deflection(const model::Model& model) {
  return deflection_along(model, 2);
}

/// Shakes the model for a time of 0.1: momentum and moment of momentum are kept to round-off, the energy to
/// the order of the step.
inline void expect_kept_when_shaken(model::Model model) {
  shake(model);
  model.control.end_time = 0.1;
  const Conservation kept = watched_run(model);
  std::printf("moment of momentum %.2e, momentum %.2e, energy %.2e\n", kept.turning_drift,
              kept.momentum_drift, kept.worst_imbalance);
  EXPECT_LT(kept.turning_drift, 3e-15);
  EXPECT_LT(kept.momentum_drift, 3e-15);
  EXPECT_LT(kept.worst_imbalance, 1e-3);
}

}  // namespace crumple::test
