// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/membrane_triangle.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template ShellKernel<float> formulation_kernel<MembraneTriangle, compiled_isa, float>();
template ShellKernel<double> formulation_kernel<MembraneTriangle, compiled_isa, double>();

}  // namespace crumple::elements
