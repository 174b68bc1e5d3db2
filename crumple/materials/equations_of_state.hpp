// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model/equation_of_state.hpp"
#include "model/material.hpp"

namespace crumple::materials {

/// Speed of longitudinal waves at time zero of a material whose pressure an equation of state gives
/// [length/time]. Throws Error naming the material if there is no stiffness.
double eos_wave_speed(const model::Material& material, const model::EquationOfState& equation);

}  // namespace crumple::materials
