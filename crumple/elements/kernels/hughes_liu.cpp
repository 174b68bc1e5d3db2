// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/hughes_liu.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template ShellKernel<float> formulation_kernel<HughesLiu, compiled_isa, float>();
template ShellKernel<double> formulation_kernel<HughesLiu, compiled_isa, double>();

}  // namespace crumple::elements
