// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/belytschko_tsay.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template ShellKernel<float> formulation_kernel<BelytschkoTsay, compiled_isa, float>();
template ShellKernel<double> formulation_kernel<BelytschkoTsay, compiled_isa, double>();

}  // namespace crumple::elements
