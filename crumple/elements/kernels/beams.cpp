// SPDX-License-Identifier: BSD-3-Clause
#include "base/isa_variants.hpp"
#include "elements/line/beam_chunk.hpp"
#include "elements/line/beam_kernel_list.hpp"
#include "elements/line/belytschko_schwer.hpp"
#include "elements/line/discrete_beam.hpp"
#include "elements/line/integrated_beam.hpp"
#include "elements/line/spot_weld_beam.hpp"
#include "elements/line/truss.hpp"

namespace crumple::elements {
template <>
BeamKernel beam_formulation_kernel<compiled_isa>(model::BeamFormulation formulation) {
  if (formulation == model::BeamFormulation::Truss) return &beam_chunk<Truss, NativePack<double>>;
  if (formulation == model::BeamFormulation::Integrated)
    return &beam_chunk<IntegratedBeam, NativePack<double>>;
  if (formulation == model::BeamFormulation::Discrete) return &beam_chunk<DiscreteBeam, NativePack<double>>;
  if (formulation == model::BeamFormulation::SpotWeld) return &beam_chunk<SpotWeldBeam, NativePack<double>>;
  return &beam_chunk<BelytschkoSchwer, NativePack<double>>;
}

}  // namespace crumple::elements
