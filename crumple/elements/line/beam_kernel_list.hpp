// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/isa.hpp"
#include "elements/line/beam_task.hpp"

namespace crumple::elements {

using BeamKernel = void (*)(const BeamTask& task, ElementSums& sums);

/// The kernel of one formulation of beams. Defined in kernels/beams.cpp, which is compiled once per
/// instruction set.
template <Isa Variant>
BeamKernel beam_formulation_kernel(model::BeamFormulation formulation);

/// The kernel for an instruction set chosen at run time.
BeamKernel beam_kernel(Isa isa, model::BeamFormulation formulation);

/// What a formulation of beams is called.
const char* beam_name(model::BeamFormulation formulation);

}  // namespace crumple::elements
