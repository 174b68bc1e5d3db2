// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/isa.hpp"
#include "elements/element_sums.hpp"
#include "elements/solid_task.hpp"

namespace crumple::elements {

template <class Real>
using SolidKernel = void (*)(const SolidTask<Real>& task, ElementSums& sums);

/// The kernel of one formulation of solids. Defined in kernels/<formulation>.cpp, which is compiled once per
/// instruction set (solid_kernel_definition.hpp).
template <class Formulation, Isa Variant, class Real>
SolidKernel<Real> solid_formulation_kernel();

/// The kernel for an instruction set chosen at run time, of the formulation at place `kind` of the list.
template <class Real>
SolidKernel<Real> solid_kernel(Isa isa, int kind);

}  // namespace crumple::elements
