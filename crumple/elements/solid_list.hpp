// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/list.hpp"
#include "elements/one_point_hexahedron.hpp"

namespace crumple::elements {

/// Every formulation of solids, one line each. What one must have is written in solid_formulation.hpp.
using SolidFormulations = FormulationList<  //
    OnePointHexahedron>;

}  // namespace crumple::elements
