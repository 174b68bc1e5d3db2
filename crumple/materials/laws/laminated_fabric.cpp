// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/laminated_fabric.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {
namespace {

/// Strength, m, 1 / (m e), the bound and the drive at the strength. m makes the strength the largest stress,
/// at the strain that goes with it; where that is the elastic one, the fall is as steep as it gets.
std::array<double, LaminatedFabricLaw::PerMode> fabric_mode_of(const model::Material& material,
                                                               double modulus, double strength, double strain,
                                                               double bound) {
  constexpr double steepest = 1000;
  require(strength > 0, material, "the strengths XT, XC, YT, YC and SC must be above zero");
  require(bound >= 0 && bound <= 1, material, "the limits SLIMT1 to SLIMS must be from 0 to 1");
  const double ratio = modulus * strain / strength;
  require(ratio > 1 - 1e-6, material, "a strain at strength must not be below the strength over the modulus");
  const double m = std::min(steepest, 1 / std::log(std::max(ratio, 1 + 1e-9)));
  return {1 / strength, m, -std::numbers::log2e / (m * std::numbers::e), bound, std::exp(1 / m)};
}

}  // namespace

void LaminatedFabricLaw::declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                                         Index /*tensor*/) {
  domain::add_item(block, "material_axis", "-", 2);
  domain::add_item(block, "damage_drive", "-", fabric_mode::count * block.points);
  domain::add_item(block, "damage", "-", 3 * block.points);
  domain::add_item(block, "failed", "-", block.points);
  domain::add_item(block, "ply_strain", "-", 3 * block.points);
  domain::add_item(block, "ply_strain_rest", "-", 3 * block.points);
}

void LaminatedFabricLaw::prepare_element(const model::ConstitutiveLaw& law, const LaminaAxes& axes,
                                         domain::ElementBlock& block, Index history, Index place) {
  OrthotropicElasticLaw::set_axes(std::get<Model>(law), axes, block, history, place);
}

std::vector<double> LaminatedFabricLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  std::vector<double> numbers = OrthotropicElasticLaw::constants_of(law, material);
  numbers.resize(Count);
  numbers[YoungsA] = law.modulus_a;
  numbers[YoungsB] = law.modulus_b;
  numbers[PoissonAb] = law.poisson_ba * law.modulus_a / law.modulus_b;
  numbers[PoissonBa] = law.poisson_ba;
  numbers[Erosion] = law.erosion_strain;
  numbers[Surface] = law.surface == Model::Surface::Facets   ? -1
                     : law.surface == Model::Surface::Across ? 0
                                                             : 1;
  const std::array<double, LaminatedFabricLaw::PerMode> modes[] = {
      fabric_mode_of(material, law.modulus_a, law.tension_a.strength, law.tension_a.strain,
                     law.tension_a.left),
      fabric_mode_of(material, law.modulus_a, law.compression_a.strength, law.compression_a.strain,
                     law.compression_a.left),
      fabric_mode_of(material, law.modulus_b, law.tension_b.strength, law.tension_b.strain,
                     law.tension_b.left),
      fabric_mode_of(material, law.modulus_b, law.compression_b.strength, law.compression_b.strain,
                     law.compression_b.left),
      fabric_mode_of(material, law.shear_ab, law.shear.strength, law.shear.strain, law.shear.left)};
  for (std::size_t k = 0; k < std::size(modes); ++k)
    std::copy(modes[k].begin(), modes[k].end(),
              numbers.begin() + Modes + PerMode * static_cast<std::ptrdiff_t>(k));
  if (law.surface != Model::Surface::Facets || law.first_shear_strain == 0) return numbers;
  require(law.first_shear_strain < law.shear.strain && law.first_shear_stress <= law.shear.strength &&
              law.first_shear_stress > 0,
          material, "TAU1 and GAMMA1 must be below the shear strength SC and its strain GMS");
  const auto first =
      fabric_mode_of(material, law.shear_ab, law.first_shear_stress, law.first_shear_strain, law.shear.left);
  numbers[FirstShear] = law.first_shear_strain;
  numbers[FirstStress] = law.first_shear_stress;
  numbers[LastShear] = law.shear.strain;
  numbers[LineBound] = law.shear.strength * law.shear.left;
  numbers[LineSlope] =
      (law.shear.strength - law.first_shear_stress) / (law.shear.strain - law.first_shear_strain);
  numbers[Modes + PerMode * fabric_mode::shear + Exponent] = first[Exponent];
  numbers[Modes + PerMode * fabric_mode::shear + Rate] = first[Rate];
  numbers[Modes + PerMode * fabric_mode::shear + Peak] = first[Peak];
  return numbers;
}

}  // namespace crumple::materials
