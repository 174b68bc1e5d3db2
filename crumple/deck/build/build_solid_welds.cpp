// SPDX-License-Identifier: BSD-3-Clause
// *MAT_SPOTWELD of solids.
#include <fmt/core.h>

#include <array>
#include <string>
#include <utility>
#include <variant>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

/// Strengths by resultants, which solids do not have.
void check_strengths(const RawPart& raw, const model::SpotWeldLaw& law, Report& report) {
  const std::array<std::pair<const char*, double>, 6> strengths = {{{"NRR", law.tension_strength},
                                                                    {"NRS", law.shear_strength_s},
                                                                    {"NRT", law.shear_strength_t},
                                                                    {"MRR", law.torsion_strength},
                                                                    {"MSS", law.bending_strength_s},
                                                                    {"MTT", law.bending_strength_t}}};
  for (const auto& [field, strength] : strengths) {
    if (strength == 0) continue;
    report.field_unsupported(
        raw.where,
        {"MID", std::to_string(raw.material), fmt::format("a *MAT_SPOTWELD without {}", field),
         "solid welds fail by plastic strain (EFAIL) and at a time (TFAIL); forces and moments are "
         "compared in beams, ELFORM 9",
         "weld"});
    return;
  }
}

/// The same metal for solids.
model::Material of_solids(model::Material material) {
  const auto weld = std::get<model::SpotWeldLaw>(material.law);
  model::PlasticKinematic metal;
  metal.youngs_modulus = weld.youngs_modulus;
  metal.poissons_ratio = weld.poissons_ratio;
  metal.yield_stress = weld.yield_stress;
  // EH is the slope over the plastic strain.
  metal.tangent_modulus = weld.youngs_modulus * weld.hardening / (weld.youngs_modulus + weld.hardening);
  metal.isotropic_fraction = 1;
  metal.failure_strain = weld.failure_strain;
  material.law = metal;
  constexpr double never = 1e20;
  if (weld.failure_time < never) {
    if (!material.erosion) material.erosion.emplace();
    if (!material.erosion->time) material.erosion->time = weld.failure_time;
  }
  return material;
}

}  // namespace

void check_solid_weld(const RawPart& raw, const model::SpotWeldLaw& law, Report& report) {
  check_strengths(raw, law, report);
  if (law.least_step > 0)
    report.field_warning(raw.where,
                         {"MID", std::to_string(raw.material), "a *MAT_SPOTWELD without DT",
                          "no mass is added to solid welds: the step is as short as they are; DT2MS "
                          "adds some to all elements that need it",
                          "weld"});
}

void build_solid_welds(Build& build) {
  model::Model& model = build.model;
  for (model::Part& part : model.parts) {
    if (part.solid_section == no_index || part.material == no_index) continue;
    const auto index = static_cast<std::size_t>(part.material);
    if (!std::holds_alternative<model::SpotWeldLaw>(model.materials[index].law)) continue;
    // Beams may have the same material.
    part.material = static_cast<Index>(model.materials.size());
    model.materials.push_back(of_solids(model.materials[index]));
  }
}

}  // namespace crumple::deck
