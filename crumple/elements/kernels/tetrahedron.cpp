// SPDX-License-Identifier: BSD-3-Clause
#include "elements/solid/tetrahedron.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template SolidKernel<float> formulation_kernel<Tetrahedron, CRUMPLE_ISA, float>();
template SolidKernel<double> formulation_kernel<Tetrahedron, CRUMPLE_ISA, double>();
template SolidKernel<float> formulation_kernel<NodalPressureTetrahedron, CRUMPLE_ISA, float>();
template SolidKernel<double> formulation_kernel<NodalPressureTetrahedron, CRUMPLE_ISA, double>();

}  // namespace crumple::elements
