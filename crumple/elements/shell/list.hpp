// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/common/formulation_list.hpp"
#include "elements/shell/belytschko_tsay.hpp"
#include "elements/shell/belytschko_wong_chiang.hpp"
#include "elements/shell/fully_integrated.hpp"
#include "elements/shell/fully_integrated_membrane.hpp"
#include "elements/shell/hughes_liu.hpp"
#include "elements/shell/hughes_liu_selective.hpp"
#include "elements/shell/membrane.hpp"
#include "elements/shell/membrane_triangle.hpp"
#include "elements/shell/triangle.hpp"

namespace crumple::elements {

/// Every shell formulation, one line each. What one must have is written in formulation.hpp.
using ShellFormulations = FormulationList<  //
    BelytschkoTsay,                         //
    BelytschkoWongChiang,                   //
    Triangle,                               //
    HughesLiu,                              //
    HughesLiuSelective,                     //
    FullyIntegrated,                        //
    Membrane,                               //
    MembraneTriangle,                       //
    FullyIntegratedMembrane>;

}  // namespace crumple::elements
