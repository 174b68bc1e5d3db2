// SPDX-License-Identifier: BSD-3-Clause
#include "elements/line/beam_chunk.hpp"
#include "elements/line/beam_kernel_list.hpp"
#include "elements/line/belytschko_schwer.hpp"
#include "elements/line/truss.hpp"

namespace crumple::elements {
namespace {

/// The instruction set's value, spelled as the build names it.
[[maybe_unused]] constexpr Isa scalar = Isa::Scalar;
[[maybe_unused]] constexpr Isa baseline = Isa::Baseline;
[[maybe_unused]] constexpr Isa avx2 = Isa::Avx2;
[[maybe_unused]] constexpr Isa avx512 = Isa::Avx512;

}  // namespace

template <>
BeamKernel beam_formulation_kernel<CRUMPLE_ISA>(model::BeamFormulation formulation) {
  if (formulation == model::BeamFormulation::Truss) return &beam_chunk<Truss, NativePack<double>>;
  return &beam_chunk<BelytschkoSchwer, NativePack<double>>;
}

}  // namespace crumple::elements
