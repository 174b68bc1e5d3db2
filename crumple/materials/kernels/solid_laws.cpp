// SPDX-License-Identifier: BSD-3-Clause
// All laws of the list of solids, for the instruction set that this file is being compiled for.
#include "base/isa_variants.hpp"
#include "materials/kernel_list.hpp"
#include "materials/list.hpp"
#include "materials/separation_update.hpp"
#include "materials/solid_update.hpp"

namespace crumple::materials {

// The longest laws have files of their own (cap_concrete.cpp and more), that all are compiled at the same
// time.
extern template void update_solids<CapConcreteLaw::SolidUpdate<NativePack<float>>, NativePack<float>>(
    const SolidMaterialTask<float>& task);
extern template void update_solids<CapConcreteLaw::SolidUpdate<NativePack<double>>, NativePack<double>>(
    const SolidMaterialTask<double>& task);
extern template void update_solids<ThreeSurfaceConcreteLaw::SolidUpdate<NativePack<float>>,
                                   NativePack<float>>(const SolidMaterialTask<float>& task);
extern template void update_solids<ThreeSurfaceConcreteLaw::SolidUpdate<NativePack<double>>,
                                   NativePack<double>>(const SolidMaterialTask<double>& task);
extern template void update_solids<HolmquistCeramicLaw::SolidUpdate<NativePack<float>>, NativePack<float>>(
    const SolidMaterialTask<float>& task);
extern template void update_solids<HolmquistCeramicLaw::SolidUpdate<NativePack<double>>, NativePack<double>>(
    const SolidMaterialTask<double>& task);
extern template void update_solids<HolmquistConcreteLaw::SolidUpdate<NativePack<float>>, NativePack<float>>(
    const SolidMaterialTask<float>& task);
extern template void update_solids<HolmquistConcreteLaw::SolidUpdate<NativePack<double>>, NativePack<double>>(
    const SolidMaterialTask<double>& task);

namespace {

template <class Law, class Real>
void update(const SolidMaterialTask<Real>& task) {
  using Pack = NativePack<Real>;
  using Update = typename Law::template SolidUpdate<Pack>;
  if constexpr (requires { Update::is_of_separations; })
    update_separations<Update, Pack>(task);
  else
    update_solids<Update, Pack>(task);
}

template <class Real, class... Laws>
SolidMaterialUpdate<Real> pick(int kind, LawList<Laws...> /*list*/) {
  constexpr SolidMaterialUpdate<Real> updates[] = {&update<Laws, Real>...};
  return updates[kind];
}

}  // namespace

template <>
SolidMaterialUpdate<float> solid_law_kernel<compiled_isa, float>(int kind) {
  return pick<float>(kind, SolidLaws{});
}
template <>
SolidMaterialUpdate<double> solid_law_kernel<compiled_isa, double>(int kind) {
  return pick<double>(kind, SolidLaws{});
}

}  // namespace crumple::materials
