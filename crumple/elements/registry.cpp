// SPDX-License-Identifier: BSD-3-Clause
// The registry: what the solver asks of a formulation, answered through the list.
#include "elements/registry.hpp"

#include <array>

#include "elements/list.hpp"
#include "elements/solid_list.hpp"

namespace crumple::elements {
namespace {

template <class... Formulations>
ShellKind find(model::ShellFormulation formulation, FormulationList<Formulations...> /*list*/) {
  ShellKind found;
  int kind = -1;
  const auto try_one = [&]<class Formulation>(Formulation) {
    ++kind;
    if (Formulation::formulation == formulation) found = {kind, Formulation::name, Formulation::planes};
  };
  (try_one(Formulations{}), ...);
  return found;
}

template <Isa Variant, class Real, class... Formulations>
ShellKernel<Real> pick(int kind, FormulationList<Formulations...> /*list*/) {
  static const std::array<ShellKernel<Real>, sizeof...(Formulations)> kernels{
      formulation_kernel<Formulations, Variant, Real>()...};
  return kernels[static_cast<std::size_t>(kind)];
}

template <class... Formulations>
SolidKind find(model::SolidFormulation formulation, FormulationList<Formulations...> /*list*/) {
  SolidKind found;
  int kind = -1;
  const auto try_one = [&]<class Formulation>(Formulation) {
    ++kind;
    if (Formulation::formulation == formulation)
      found = {kind, Formulation::name, Formulation::points, Formulation::kept, Formulation::averages};
  };
  (try_one(Formulations{}), ...);
  return found;
}

template <Isa Variant, class Real, class... Formulations>
SolidKernel<Real> pick_solid(int kind, FormulationList<Formulations...> /*list*/) {
  static const std::array<SolidKernel<Real>, sizeof...(Formulations)> kernels{
      solid_formulation_kernel<Formulations, Variant, Real>()...};
  return kernels[static_cast<std::size_t>(kind)];
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
      return pick<Isa::Avx512, Real>(kind, ShellFormulations{});
    case Isa::Avx2:
      return pick<Isa::Avx2, Real>(kind, ShellFormulations{});
#endif
    case Isa::Scalar:
      return pick<Isa::Scalar, Real>(kind, ShellFormulations{});
    default:
      return pick<Isa::Baseline, Real>(kind, ShellFormulations{});
  }
}
template ShellKernel<float> shell_kernel<float>(Isa isa, int kind);
template ShellKernel<double> shell_kernel<double>(Isa isa, int kind);

SolidKind solid_kind(model::SolidFormulation formulation) {
  return find(formulation, SolidFormulations{});
}

template <class Real>
SolidKernel<Real> solid_kernel(Isa isa, int kind) {
  switch (isa) {
#if defined(CRUMPLE_FAST_KERNELS)
    case Isa::Avx512:
      return pick_solid<Isa::Avx512, Real>(kind, SolidFormulations{});
    case Isa::Avx2:
      return pick_solid<Isa::Avx2, Real>(kind, SolidFormulations{});
#endif
    case Isa::Scalar:
      return pick_solid<Isa::Scalar, Real>(kind, SolidFormulations{});
    default:
      return pick_solid<Isa::Baseline, Real>(kind, SolidFormulations{});
  }
}
template SolidKernel<float> solid_kernel<float>(Isa isa, int kind);
template SolidKernel<double> solid_kernel<double>(Isa isa, int kind);

}  // namespace crumple::elements
