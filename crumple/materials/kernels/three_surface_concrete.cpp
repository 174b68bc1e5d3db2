// SPDX-License-Identifier: BSD-3-Clause
// Concrete of three surfaces, apart from the other laws of the list (solid_laws.cpp), for the time of
// compilation alone.
#include "materials/laws/three_surface_concrete.hpp"

#include "base/isa_variants.hpp"
#include "materials/solid_update.hpp"

namespace crumple::materials {

template void update_solids<ThreeSurfaceConcreteLaw::SolidUpdate<NativePack<float>>, NativePack<float>>(
    const SolidMaterialTask<float>& task);
template void update_solids<ThreeSurfaceConcreteLaw::SolidUpdate<NativePack<double>>, NativePack<double>>(
    const SolidMaterialTask<double>& task);

}  // namespace crumple::materials
