// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/belytschko_tsay.hpp"
#include "elements/belytschko_wong_chiang.hpp"
#include "elements/formulation_list.hpp"
#include "elements/fully_integrated.hpp"
#include "elements/hughes_liu.hpp"
#include "elements/hughes_liu_selective.hpp"
#include "elements/triangle.hpp"

namespace crumple::elements {

/// Every shell formulation, one line each. What one must have is written in formulation.hpp.
using ShellFormulations = FormulationList<  //
    BelytschkoTsay,                         //
    BelytschkoWongChiang,                   //
    Triangle,                               //
    HughesLiu,                              //
    HughesLiuSelective,                     //
    FullyIntegrated>;

}  // namespace crumple::elements
