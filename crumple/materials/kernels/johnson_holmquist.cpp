// SPDX-License-Identifier: BSD-3-Clause
// The laws of Johnson & Holmquist, apart from the other laws of the list (solid_laws.cpp), for the time of
// compilation alone.
#include "base/isa_variants.hpp"
#include "materials/laws/holmquist_ceramic.hpp"
#include "materials/laws/holmquist_concrete.hpp"
#include "materials/solid_update.hpp"

namespace crumple::materials {

template void update_solids<HolmquistCeramicLaw::SolidUpdate<NativePack<float>>, NativePack<float>>(
    const SolidMaterialTask<float>& task);
template void update_solids<HolmquistCeramicLaw::SolidUpdate<NativePack<double>>, NativePack<double>>(
    const SolidMaterialTask<double>& task);
template void update_solids<HolmquistConcreteLaw::SolidUpdate<NativePack<float>>, NativePack<float>>(
    const SolidMaterialTask<float>& task);
template void update_solids<HolmquistConcreteLaw::SolidUpdate<NativePack<double>>, NativePack<double>>(
    const SolidMaterialTask<double>& task);

}  // namespace crumple::materials
