// SPDX-License-Identifier: BSD-3-Clause
#include "elements/solid/tetrahedron.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template SolidKernel<float> formulation_kernel<Tetrahedron, compiled_isa, float>();
template SolidKernel<double> formulation_kernel<Tetrahedron, compiled_isa, double>();
template SolidKernel<float> formulation_kernel<NodalPressureTetrahedron, compiled_isa, float>();
template SolidKernel<double> formulation_kernel<NodalPressureTetrahedron, compiled_isa, double>();

}  // namespace crumple::elements
