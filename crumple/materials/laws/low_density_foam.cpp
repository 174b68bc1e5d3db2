// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/low_density_foam.hpp"

#include <algorithm>
#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {

namespace {

void check_compression(const model::Material& material, const std::vector<double>& strain,
                       const std::vector<double>& stress) {
  require(strain.size() >= 2 && stress.size() == strain.size(), material,
          "the curve of stress over strain in compression needs two points at least");
  require(strain[0] == 0 && stress[0] == 0, material,
          "the curve of stress over strain in compression must start at zero");
  for (std::size_t k = 0; k + 1 < strain.size(); ++k) {
    require(strain[k + 1] > strain[k], material, "the strains of the curve in compression must ascend");
    require(stress[k + 1] >= stress[k], material, "the stresses of the curve in compression must not fall");
  }
}

/// Slope from a point to the next; the last one goes on.
double slope_behind(const std::vector<double>& strain, const std::vector<double>& stress, std::size_t at) {
  const std::size_t k = std::min(at, strain.size() - 2);
  return (stress[k + 1] - stress[k]) / (strain[k + 1] - strain[k]);
}

}  // namespace

void LowDensityFoamLaw::declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block,
                                        Index /*tensor*/) {
  const auto& foam = std::get<Model>(law);
  declare_deformation(block);
  if (foam.unloading_factor < 1) domain::add_item(block, "largest_energy", "energy/volume", block.points);
  if (foam.tears) domain::add_item(block, "torn", "-", block.points);
  if (!foam.faster.empty()) domain::add_item(block, "compression_rate", "1/time", block.points);
}

std::vector<double> LowDensityFoamLaw::constants(const model::Material& material) {
  constexpr double unbounded = 1e30;
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require(law.tensile_stress >= 0, material, "the tension cut-off must not be negative");
  require(law.unloading_factor >= 0 && law.unloading_factor <= 1, material,
          "the factor of hysteretic unloading must be from 0 to 1");
  require(law.unloading_shape > 0, material, "the shape factor of unloading must be above zero");
  check_compression(material, law.compression, law.stress);
  std::vector<double> numbers(Count);
  numbers[Youngs] = law.youngs_modulus;
  numbers[Tension] = law.tensile_stress > 0 ? law.tensile_stress : unbounded;
  numbers[Tears] = law.tears ? 1 : 0;
  numbers[UnloadingFactor] = law.unloading_factor;
  numbers[Shape] = law.unloading_shape;
  numbers[PerDensity] = 1 / material.density;
  numbers[Slowest] = law.slowest;
  numbers[Engineering] = law.engineering_rate ? 1 : 0;
  numbers[Faster] = static_cast<double>(law.faster.size());
  numbers[Points] = static_cast<double>(law.compression.size());
  double energy = 0;
  for (std::size_t k = 0; k < law.compression.size(); ++k) {
    if (k > 0)
      energy += 0.5 * (law.stress[k - 1] + law.stress[k]) * (law.compression[k] - law.compression[k - 1]);
    numbers.insert(numbers.end(),
                   {law.compression[k], law.stress[k], slope_behind(law.compression, law.stress, k), energy});
  }
  double rate = law.slowest;
  for (const model::FoamAtRate& curve : law.faster) {
    check_compression(material, curve.compression, curve.stress);
    require(curve.rate > rate, material, "the strain rates of its curves must ascend");
    rate = curve.rate;
    numbers.insert(numbers.end(), {rate, static_cast<double>(curve.compression.size())});
    for (std::size_t k = 0; k < curve.compression.size(); ++k)
      numbers.insert(numbers.end(), {curve.compression[k], curve.stress[k],
                                     slope_behind(curve.compression, curve.stress, k)});
  }
  return numbers;
}

}  // namespace crumple::materials
