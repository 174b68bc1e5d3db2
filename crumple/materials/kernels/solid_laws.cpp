// SPDX-License-Identifier: BSD-3-Clause
// All laws of the list of solids, for the instruction set that this file is being compiled for.
#include "materials/kernel_list.hpp"
#include "materials/list.hpp"
#include "materials/solid_update.hpp"

namespace crumple::materials {
namespace {

template <class Law, class Real>
void update(const SolidMaterialTask<Real>& task) {
  using Pack = NativePack<Real>;
  update_solids<typename Law::template SolidUpdate<Pack>, Pack>(task);
}

template <class Real, class... Laws>
SolidMaterialUpdate<Real> pick(int kind, LawList<Laws...> /*list*/) {
  constexpr SolidMaterialUpdate<Real> updates[] = {&update<Laws, Real>...};
  return updates[kind];
}

/// The instruction set's value, spelled as the build names it.
[[maybe_unused]] constexpr Isa scalar = Isa::Scalar;
[[maybe_unused]] constexpr Isa baseline = Isa::Baseline;
[[maybe_unused]] constexpr Isa avx2 = Isa::Avx2;
[[maybe_unused]] constexpr Isa avx512 = Isa::Avx512;

}  // namespace

template <>
SolidMaterialUpdate<float> solid_law_kernel<CRUMPLE_ISA, float>(int kind) {
  return pick<float>(kind, SolidLaws{});
}
template <>
SolidMaterialUpdate<double> solid_law_kernel<CRUMPLE_ISA, double>(int kind) {
  return pick<double>(kind, SolidLaws{});
}

}  // namespace crumple::materials
