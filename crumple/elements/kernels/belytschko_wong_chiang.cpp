// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/belytschko_wong_chiang.hpp"

#include "elements/kernel_definition.hpp"

namespace crumple::elements {

template ShellKernel<float> formulation_kernel<BelytschkoWongChiang, compiled_isa, float>();
template ShellKernel<double> formulation_kernel<BelytschkoWongChiang, compiled_isa, double>();

}  // namespace crumple::elements
