// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace crumple::deck {

/// Guess of the unit system from densities and moduli (metals), such as "t, mm, s"; empty if there is none.
std::string guess_units(const model::Model& model);

/// By material: a sentence about a density and a modulus that go together in none of the unit systems in use,
/// whatever they are of; empty where there is no doubt. Null materials have no modulus of their own.
std::vector<std::string> unit_doubts(const model::Model& model);

}  // namespace crumple::deck
