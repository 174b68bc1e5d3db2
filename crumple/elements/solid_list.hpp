// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/formulation_list.hpp"
#include "elements/one_point_hexahedron.hpp"
#include "elements/selective_hexahedron.hpp"
#include "elements/tetrahedron.hpp"

namespace crumple::elements {

/// Every formulation of solids, one line each. What one must have is written in solid_formulation.hpp.
using SolidFormulations = FormulationList<  //
    OnePointHexahedron,                     //
    SelectiveHexahedron,                    //
    Tetrahedron,                            //
    NodalPressureTetrahedron>;

}  // namespace crumple::elements
