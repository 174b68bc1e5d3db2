// SPDX-License-Identifier: BSD-3-Clause
// The registry: what the solver asks of a shell formulation, answered through the list.
#include "elements/registry.hpp"

#include "elements/list.hpp"

namespace crumple::elements {
namespace {

template <class... Formulations>
ShellKind find(model::ShellFormulation formulation, FormulationList<Formulations...> /*list*/) {
  ShellKind found;
  int kind = -1;
  const auto try_one = [&]<class Formulation>(Formulation) {
    ++kind;
    if (Formulation::formulation == formulation) found = {kind, Formulation::name};
  };
  (try_one(Formulations{}), ...);
  return found;
}

}  // namespace

ShellKind shell_kind(model::ShellFormulation formulation) {
  return find(formulation, ShellFormulations{});
}

template <class Real>
ShellKernel<Real> shell_kernel(Isa isa, int kind) {
  switch (isa) {
#if defined(CRUMPLE_FAST_KERNELS)
    case Isa::Avx512:
      return shell_formulation_kernel<Isa::Avx512, Real>(kind);
    case Isa::Avx2:
      return shell_formulation_kernel<Isa::Avx2, Real>(kind);
#endif
    case Isa::Scalar:
      return shell_formulation_kernel<Isa::Scalar, Real>(kind);
    default:
      return shell_formulation_kernel<Isa::Baseline, Real>(kind);
  }
}
template ShellKernel<float> shell_kernel<float>(Isa isa, int kind);
template ShellKernel<double> shell_kernel<double>(Isa isa, int kind);

}  // namespace crumple::elements
