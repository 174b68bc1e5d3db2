// SPDX-License-Identifier: BSD-3-Clause
#include "materials/initial_stress.hpp"

#include <array>
#include <variant>

#include "materials/laws/fabric.hpp"

namespace crumple::materials {
namespace {

/// The strain, in the axes of the yarns, of which fabric and liner together have the stress: of what is taut.
std::array<double, 3> strain_of(const model::Fabric& law, const std::array<double, 3>& stress) {
  const model::OrthotropicElastic& sheet = law.sheet;
  const double share = 1 - law.liner_share;
  const double direct = law.liner_share * law.liner_modulus / (1 - law.liner_ratio * law.liner_ratio);
  const double determinant = 1 - sheet.poisson_ba * sheet.poisson_ba * sheet.modulus_a / sheet.modulus_b;
  const double aa = share * sheet.modulus_a / determinant + direct;
  const double bb = share * sheet.modulus_b / determinant + direct;
  const double ab = share * sheet.poisson_ba * sheet.modulus_a / determinant + law.liner_ratio * direct;
  const double shear = share * sheet.shear_ab + 0.5 * (1 - law.liner_ratio) * direct;
  const double over = 1 / (aa * bb - ab * ab);
  return {over * (bb * stress[0] - ab * stress[1]), over * (aa * stress[1] - ab * stress[0]),
          stress[2] / shear};
}

void set_fabric_strain(const model::Fabric& law, std::span<const double> stress, domain::ElementBlock& block,
                       Index history, Index element, Index point) {
  const double c = block.state(element, history);
  const double s = block.state(element, history + 1);
  const std::array<double, 3> in_yarns = {c * c * stress[0] + s * s * stress[1] + 2 * c * s * stress[2],
                                          s * s * stress[0] + c * c * stress[1] - 2 * c * s * stress[2],
                                          c * s * (stress[1] - stress[0]) + (c * c - s * s) * stress[2]};
  const std::array<double, 3> strain = strain_of(law, in_yarns);
  for (Index k = 0; k < 3; ++k)
    block.set_state(element, history + FabricLaw::strain_item + k * block.points + point,
                    strain[static_cast<std::size_t>(k)]);
}

/// Sets what an item has for a point: each run of layers has an item of its own.
void set_point(const char* name, std::span<const double> values, domain::ElementBlock& block, Index element,
               Index point) {
  const auto count = static_cast<Index>(values.size());
  for (const domain::StateItem& item : block.items) {
    if (item.name != name) continue;
    const Index at = item.point_of(point);
    if (at == no_index || (at + 1) * count > item.count) continue;
    for (Index k = 0; k < count; ++k)
      block.set_state(element, item.first + at * count + k, values[static_cast<std::size_t>(k)]);
  }
}

}  // namespace

void set_initial_stress(const model::ConstitutiveLaw& law, const PointStart& start,
                        domain::ElementBlock& block, Index history, Index element, Index point) {
  set_point("stress", start.stress, block, element, point);
  const double plastic = start.plastic_strain;
  set_point("plastic_strain", {&plastic, 1}, block, element, point);
  set_point("back_stress", start.back_stress, block, element, point);
  if (const auto* fabric = std::get_if<model::Fabric>(&law))
    set_fabric_strain(*fabric, start.stress, block, history, element, point);
}

}  // namespace crumple::materials
