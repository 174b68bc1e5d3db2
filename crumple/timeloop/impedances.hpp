// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "loads/viscous_boundary.hpp"
#include "model/model.hpp"

namespace crumple::timeloop {

/// By part of the model: density times the speeds of dilatational and shear waves of its solids at time zero,
/// from the elastic moduli of the law, or from its equation of state and its shear modulus. Zero for parts
/// without viscous segments.
std::vector<loads::Impedance> impedances_of_parts(const model::Model& model);

}  // namespace crumple::timeloop
