// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "base/index.hpp"
#include "math/vec3.hpp"

namespace crumple::domain {

/// What is wrong with the energy of one part or contact: energy that is there and that no motion has put in.
struct EnergyResidual {
  const char* kind = "part";  ///< "part" or "contact"
  UserId id = 0;
  double energy = 0;    ///< of a part internal, hourglass and eroded, of a contact that of its normal forces
  double residual = 0;  ///< of it, what does not come from the motion [energy]
};

/// Neighbouring elements of one part, and their share of its residual.
struct ElementResidual {
  UserId part = 0;
  const char* kind = "shell";  ///< what the elements are called
  UserId first = 0;            ///< user numbers of the first and the last of them, in the order of the run
  UserId last = 0;
  Index elements = 0;
  double residual = 0;  ///< [energy]
  UserId node = 0;      ///< the one of their nodes that moves fastest, and where it is now
  double speed = 0;     ///< [length/time]
  math::Vec3 place{};   ///< [length]
};

/// Where energy goes wrong, at time n.
struct EnergyTraceReport {
  std::vector<EnergyResidual> parts;     ///< in the order of the model
  std::vector<EnergyResidual> contacts;  ///< likewise
  std::vector<ElementResidual> worst;    ///< elements with the largest residuals, the worst first
};

}  // namespace crumple::domain
