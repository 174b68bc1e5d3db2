// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/fully_integrated_membrane.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template ShellKernel<float> formulation_kernel<FullyIntegratedMembrane, compiled_isa, float>();
template ShellKernel<double> formulation_kernel<FullyIntegratedMembrane, compiled_isa, double>();

}  // namespace crumple::elements
