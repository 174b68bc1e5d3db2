// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/common/formulation_list.hpp"
#include "elements/solid/cohesive_hexahedron.hpp"
#include "elements/solid/one_point_hexahedron.hpp"
#include "elements/solid/quadratic_tetrahedron.hpp"
#include "elements/solid/selective_hexahedron.hpp"
#include "elements/solid/tetrahedron.hpp"

namespace crumple::elements {

/// Every formulation of solids, one line each. What one must have is written in solid_formulation.hpp.
using SolidFormulations = FormulationList<  //
    OnePointHexahedron,                     //
    SelectiveHexahedron,                    //
    AssumedStrainHexahedron,                //
    Tetrahedron,                            //
    NodalPressureTetrahedron,               //
    QuadraticTetrahedron,                   //
    CohesiveHexahedron>;

}  // namespace crumple::elements
