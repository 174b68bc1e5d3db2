// SPDX-License-Identifier: BSD-3-Clause
#include "elements/solid/cohesive_hexahedron.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template SolidKernel<float> formulation_kernel<CohesiveHexahedron, compiled_isa, float>();
template SolidKernel<double> formulation_kernel<CohesiveHexahedron, compiled_isa, double>();

}  // namespace crumple::elements
