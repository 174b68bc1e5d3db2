// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/hughes_liu.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template ShellKernel<float> formulation_kernel<HughesLiu, CRUMPLE_ISA, float>();
template ShellKernel<double> formulation_kernel<HughesLiu, CRUMPLE_ISA, double>();

}  // namespace crumple::elements
