// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/isa.hpp"
#include "elements/element_sums.hpp"
#include "elements/shell_task.hpp"

namespace crumple::elements {

template <class Real>
using ShellKernel = void (*)(const ShellTask<Real>& task, ElementSums& sums);

/// The kernel of one formulation. Defined in kernels/<formulation>.cpp, which is compiled once per
/// instruction set (kernel_definition.hpp).
template <class Formulation, Isa Variant, class Real>
ShellKernel<Real> formulation_kernel();

/// The kernel for an instruction set chosen at run time, of the formulation at place `kind` of the list.
template <class Real>
ShellKernel<Real> shell_kernel(Isa isa, int kind);

}  // namespace crumple::elements
