// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Only kernels/<formulation>.cpp include this: with the header of the formulation and
//   template SolidKernel<float> solid_formulation_kernel<Formulation, CRUMPLE_ISA, float>();
//   template SolidKernel<double> solid_formulation_kernel<Formulation, CRUMPLE_ISA, double>();
// they are all there is to compile of it for one instruction set.

#include "elements/solid_chunk.hpp"
#include "elements/solid_kernel_list.hpp"

namespace crumple::elements {

/// The instruction sets as the build names them.
[[maybe_unused]] inline constexpr Isa scalar = Isa::Scalar;
[[maybe_unused]] inline constexpr Isa baseline = Isa::Baseline;
[[maybe_unused]] inline constexpr Isa avx2 = Isa::Avx2;
[[maybe_unused]] inline constexpr Isa avx512 = Isa::Avx512;

template <class Formulation, Isa Variant, class Real>
SolidKernel<Real> solid_formulation_kernel() {
  return &solid_chunk<Formulation, NativePack<Real>>;
}

}  // namespace crumple::elements
