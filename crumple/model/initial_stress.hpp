// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/model.hpp"

namespace crumple::model {

/// Why elements of this law cannot begin with such points, in words; empty if they can. The stress of laws
/// that add increments to it is all that they need; fabric finds the strain that belongs to it.
std::string refusal_of_initial_stress(const ConstitutiveLaw& law, const InitialStress& stress);

/// The same of an element of a part, with all laws of its layers (in Model::layups; no_index: it has none).
std::string refusal_of_initial_stress(const Model& model, const Part& part, Index layup,
                                      const InitialStress& stress);

/// True of laws whose yield surface may have another centre than zero, see InitialPointStress::back_stress.
bool has_back_stress(const ConstitutiveLaw& law);

}  // namespace crumple::model
