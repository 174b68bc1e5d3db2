// SPDX-License-Identifier: BSD-3-Clause
#include "elements/solid/selective_hexahedron.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template SolidKernel<float> formulation_kernel<SelectiveHexahedron, compiled_isa, float>();
template SolidKernel<double> formulation_kernel<SelectiveHexahedron, compiled_isa, double>();
template SolidKernel<float> formulation_kernel<AssumedStrainHexahedron, compiled_isa, float>();
template SolidKernel<double> formulation_kernel<AssumedStrainHexahedron, compiled_isa, double>();

}  // namespace crumple::elements
