// SPDX-License-Identifier: BSD-3-Clause
#include "elements/solid/selective_hexahedron.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template SolidKernel<float> formulation_kernel<SelectiveHexahedron, CRUMPLE_ISA, float>();
template SolidKernel<double> formulation_kernel<SelectiveHexahedron, CRUMPLE_ISA, double>();

}  // namespace crumple::elements
