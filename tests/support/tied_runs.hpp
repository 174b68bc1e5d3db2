// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the models of ties.hpp tell when they are run, shared by the tests of ties by constraint and by
// springs.

#include <algorithm>
#include <cmath>

#include "support/conservation.hpp"
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
  double largest = 0;  ///< of the loaded edge, along y [length]
  double energy_error = 0;
};

/// Runs shell_joint().
inline Deflection deflection(const model::Model& model) {
  timeloop::Simulation simulation(model, execution());
  Deflection found;
  run(simulation, [&](const domain::Domain& domain) {
    for (const model::NodalLoad& load : model.nodal_loads)
      found.largest = std::max(found.largest, std::fabs(displacement(domain, load.node).y));
  });
  found.energy_error = simulation.domain().energy.error();
  return found;
}

}  // namespace crumple::test
