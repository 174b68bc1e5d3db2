// SPDX-License-Identifier: BSD-3-Clause
#include "elements/tetrahedron.hpp"

#include "elements/solid_kernel_definition.hpp"

namespace crumple::elements {

template SolidKernel<float> solid_formulation_kernel<Tetrahedron, CRUMPLE_ISA, float>();
template SolidKernel<double> solid_formulation_kernel<Tetrahedron, CRUMPLE_ISA, double>();
template SolidKernel<float> solid_formulation_kernel<NodalPressureTetrahedron, CRUMPLE_ISA, float>();
template SolidKernel<double> solid_formulation_kernel<NodalPressureTetrahedron, CRUMPLE_ISA, double>();

}  // namespace crumple::elements
