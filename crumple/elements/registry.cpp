// SPDX-License-Identifier: BSD-3-Clause
// The registry: what the solver asks of a formulation, answered through the lists.
#include "elements/registry.hpp"

#include <array>

#include "base/isa_variants.hpp"
#include "elements/shell/list.hpp"
#include "elements/solid/solid_list.hpp"

namespace crumple::elements {
namespace {

/// Calls visit(place, Formulation()) for the entry of a list that computes `formulation`, if there is one.
template <class Name, class Visit, class... Formulations>
void find(Name formulation, FormulationList<Formulations...> /*list*/, const Visit& visit) {
  int kind = -1;
  const auto try_one = [&](auto entry) {
    ++kind;
    if (decltype(entry)::formulation == formulation) visit(kind, entry);
  };
  (try_one(Formulations{}), ...);
}

template <Isa Variant, class Real, class First, class... Others>
auto pick(int kind, FormulationList<First, Others...> /*list*/) {
  static const std::array<decltype(formulation_kernel<First, Variant, Real>()), 1 + sizeof...(Others)>
      kernels{formulation_kernel<First, Variant, Real>(), formulation_kernel<Others, Variant, Real>()...};
  return kernels[static_cast<std::size_t>(kind)];
}

template <class Real, class List>
auto kernel(Isa isa, int kind, List list) {
  return visit_isa(isa, [&]<Isa Variant>() { return pick<Variant, Real>(kind, list); });
}

}  // namespace

ShellKind shell_kind(model::ShellFormulation formulation) {
  ShellKind found;
  find(formulation, ShellFormulations{}, [&]<class Formulation>(int kind, Formulation) {
    found = {kind, Formulation::name, Formulation::planes};
  });
  return found;
}

SolidKind solid_kind(model::SolidFormulation formulation) {
  SolidKind found;
  find(formulation, SolidFormulations{}, [&]<class Formulation>(int kind, Formulation) {
    found = {kind, Formulation::name, Formulation::points, Formulation::kept, Formulation::averages};
  });
  return found;
}

template <class Real>
ShellKernel<Real> shell_kernel(Isa isa, int kind) {
  return kernel<Real>(isa, kind, ShellFormulations{});
}
template <class Real>
SolidKernel<Real> solid_kernel(Isa isa, int kind) {
  return kernel<Real>(isa, kind, SolidFormulations{});
}
template ShellKernel<float> shell_kernel<float>(Isa isa, int kind);
template ShellKernel<double> shell_kernel<double>(Isa isa, int kind);
template SolidKernel<float> solid_kernel<float>(Isa isa, int kind);
template SolidKernel<double> solid_kernel<double>(Isa isa, int kind);

}  // namespace crumple::elements
