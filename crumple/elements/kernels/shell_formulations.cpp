// SPDX-License-Identifier: BSD-3-Clause
// All formulations of the list, for the instruction set that this file is being compiled for.
#include "elements/chunk.hpp"
#include "elements/kernel_list.hpp"
#include "elements/list.hpp"

namespace crumple::elements {
namespace {

template <class Real, class... Formulations>
ShellKernel<Real> pick(int kind, FormulationList<Formulations...> /*list*/) {
  constexpr ShellKernel<Real> kernels[] = {&shell_chunk<Formulations, NativePack<Real>>...};
  return kernels[kind];
}

/// The instruction set's value, spelled as the build names it.
[[maybe_unused]] constexpr Isa scalar = Isa::Scalar;
[[maybe_unused]] constexpr Isa baseline = Isa::Baseline;
[[maybe_unused]] constexpr Isa avx2 = Isa::Avx2;
[[maybe_unused]] constexpr Isa avx512 = Isa::Avx512;

}  // namespace

template <>
ShellKernel<float> shell_formulation_kernel<CRUMPLE_ISA, float>(int kind) {
  return pick<float>(kind, ShellFormulations{});
}
template <>
ShellKernel<double> shell_formulation_kernel<CRUMPLE_ISA, double>(int kind) {
  return pick<double>(kind, ShellFormulations{});
}

}  // namespace crumple::elements
