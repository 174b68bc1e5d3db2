// SPDX-License-Identifier: BSD-3-Clause
#include "elements/solid/quadratic_tetrahedron.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template SolidKernel<float> formulation_kernel<QuadraticTetrahedron, compiled_isa, float>();
template SolidKernel<double> formulation_kernel<QuadraticTetrahedron, compiled_isa, double>();

}  // namespace crumple::elements
