// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/hughes_liu_selective.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template ShellKernel<float> formulation_kernel<HughesLiuSelective, compiled_isa, float>();
template ShellKernel<double> formulation_kernel<HughesLiuSelective, compiled_isa, double>();

}  // namespace crumple::elements
