// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model/section.hpp"

namespace crumple::elements {

/// What a beam of one length has at each of its nodes, and its moduli.
struct BeamDynamics {
  double length = 0;          ///< [length]
  double mass = 0;            ///< [mass]
  double inertia = 0;         ///< [mass length^2]
  double youngs_modulus = 0;  ///< [stress]
  double shear_modulus = 0;   ///< [stress]
};

/// Square of the highest frequency of a free integrated beam, from above by less than a percent [1/time^2].
double highest_frequency_squared(const model::BeamSection& section, const BeamDynamics& beam);

}  // namespace crumple::elements
