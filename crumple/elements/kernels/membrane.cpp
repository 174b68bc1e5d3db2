// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/membrane.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template ShellKernel<float> formulation_kernel<Membrane, compiled_isa, float>();
template ShellKernel<double> formulation_kernel<Membrane, compiled_isa, double>();

}  // namespace crumple::elements
