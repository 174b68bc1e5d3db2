// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Only kernels/<formulation>.cpp include this: with the header of the formulation and
//   template ShellKernel<float> formulation_kernel<Formulation, compiled_isa, float>();
//   template ShellKernel<double> formulation_kernel<Formulation, compiled_isa, double>();
// or the same with SolidKernel they are all there is to compile of it for one instruction set.

#include "base/isa_variants.hpp"
#include "elements/kernel_list.hpp"
#include "elements/shell/chunk.hpp"
#include "elements/solid/solid_chunk.hpp"

namespace crumple::elements {

template <class Formulation, Isa Variant, class Real>
Kernel<std::conditional_t<is_of_solids<Formulation>, SolidTask<Real>, ShellTask<Real>>> formulation_kernel() {
  if constexpr (is_of_solids<Formulation>)
    return &solid_chunk<Formulation, NativePack<Real>>;
  else
    return &shell_chunk<Formulation, NativePack<Real>>;
}

}  // namespace crumple::elements
