// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/fully_integrated.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template ShellKernel<float> formulation_kernel<FullyIntegrated, CRUMPLE_ISA, float>();
template ShellKernel<double> formulation_kernel<FullyIntegrated, CRUMPLE_ISA, double>();

}  // namespace crumple::elements
