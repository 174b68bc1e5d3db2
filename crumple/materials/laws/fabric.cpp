// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/fabric.hpp"

#include <cmath>
#include <variant>

#include "materials/common/checks.hpp"
#include "materials/laws/orthotropic_elastic.hpp"

namespace crumple::materials {
namespace {

/// Fills the numbers of SheetNumbers.
void set_sheet(const model::OrthotropicElastic& sheet, double* to) {
  const double poisson_ab = sheet.poisson_ba * sheet.modulus_a / sheet.modulus_b;
  const double determinant = 1 - sheet.poisson_ba * poisson_ab;
  to[SheetNumbers::Aa] = sheet.modulus_a / determinant;
  to[SheetNumbers::Bb] = sheet.modulus_b / determinant;
  to[SheetNumbers::Ab] = sheet.poisson_ba * sheet.modulus_a / determinant;
  to[SheetNumbers::Gab] = sheet.shear_ab;
  const double aa = 1 / sheet.modulus_a;
  const double bb = 1 / sheet.modulus_b;
  const double mixed = 1 / sheet.shear_ab - 2 * sheet.poisson_ba / sheet.modulus_b;
  to[SheetNumbers::ComplianceAa] = aa;
  to[SheetNumbers::ComplianceBb] = bb;
  to[SheetNumbers::ComplianceMixed] = mixed;
  for (int k = 0; k < wrinkle_directions; ++k) {
    const double cc = wrinkle_cosine[k] * wrinkle_cosine[k];
    const double ss = wrinkle_sine[k] * wrinkle_sine[k];
    to[SheetNumbers::Roots + k] = 1 / std::sqrt(aa * cc * cc + bb * ss * ss + mixed * cc * ss);
  }
}

}  // namespace

void FabricLaw::declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                                Index /*tensor*/) {
  domain::add_item(block, "material_axis", "-", 2);
  domain::add_item(block, "fabric_strain", "-", 3 * block.points);
}

void FabricLaw::prepare_element(const model::ConstitutiveLaw& law, const LaminaAxes& axes,
                                domain::ElementBlock& block, Index history, Index place) {
  OrthotropicElasticLaw::prepare_element(std::get<Model>(law).sheet, axes, block, history, place);
}

std::vector<double> FabricLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  const model::OrthotropicElastic& sheet = law.sheet;
  require(sheet.modulus_a > 0 && sheet.modulus_b > 0 && sheet.shear_ab > 0, material,
          "the moduli EA, EB and GAB must be above zero");
  require(sheet.poisson_ba * sheet.poisson_ba * sheet.modulus_a < sheet.modulus_b, material,
          "Poisson's ratio PRBA is too large for the moduli: its square must stay below EB / EA");
  require(law.liner_share >= 0 && law.liner_share < 1, material,
          "the share LRATIO of the liner must be at least zero and below one");
  require(law.damping >= 0 && law.damping <= 1, material, "the damping DAMP must be between zero and one");
  std::vector<double> numbers(count);
  numbers[Wrinkles] = law.wrinkles ? 1 : 0;
  numbers[Share] = 1 - law.liner_share;
  numbers[Damping] = law.damping;
  if (law.liner_share > 0) {
    require_elastic(material, law.liner_modulus, law.liner_ratio);
    const double direct = law.liner_share * law.liner_modulus / (1 - law.liner_ratio * law.liner_ratio);
    numbers[LinerDirect] = direct;
    numbers[LinerCross] = law.liner_ratio * direct;
    numbers[LinerShear] = 0.5 * (1 - law.liner_ratio) * direct;
  }
  set_sheet(sheet, numbers.data() + Sheet);
  return numbers;
}

}  // namespace crumple::materials
