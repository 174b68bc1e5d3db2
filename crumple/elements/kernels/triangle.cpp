// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/triangle.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template ShellKernel<float> formulation_kernel<Triangle, compiled_isa, float>();
template ShellKernel<double> formulation_kernel<Triangle, compiled_isa, double>();

}  // namespace crumple::elements
