// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model/model.hpp"

namespace crumple::contact {

/// Initial bulk modulus of the material of a part, from which penalty stiffness is made [stress].
double bulk_modulus(const model::Model& model, const model::Part& part);

}  // namespace crumple::contact
