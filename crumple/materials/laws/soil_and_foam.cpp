// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/soil_and_foam.hpp"

#include <algorithm>
#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {

std::vector<double> SoilAndFoamLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require(law.shear_modulus > 0, material, "the shear modulus must be above zero");
  require(law.least_pressure <= 0, material, "the pressure cut-off must not be above zero");
  require(!law.crushes || law.unloading_modulus > 0, material,
          "the bulk modulus of unloading must be above zero");
  const std::size_t points = law.compression.size();
  require(points >= 2 && law.pressure.size() == points, material,
          "the curve of pressure over volume needs two points at least");
  require(law.compression[0] == 0 && law.pressure[0] == 0, material,
          "the curve of pressure over volume must start at zero");
  std::vector<double> numbers(Count);
  numbers[Shear] = law.shear_modulus;
  numbers[Unloading] = law.unloading_modulus;
  for (std::size_t k = 0; k < 3; ++k) numbers[Yield0 + k] = law.yield[k];
  numbers[LeastPressure] = law.least_pressure;
  numbers[Crushes] = law.crushes ? 1 : 0;
  numbers[PerDensity] = 1 / material.density;
  numbers[Points] = static_cast<double>(points);
  for (std::size_t k = 0; k < points; ++k) {
    const std::size_t from = std::min(k, points - 2);
    require(law.compression[from + 1] > law.compression[from], material,
            "the volumetric strains must grow in compression");
    require(law.pressure[from + 1] >= law.pressure[from], material,
            "the pressures must not fall in compression");
    numbers.insert(numbers.end(), {law.compression[k], law.pressure[k],
                                   (law.pressure[from + 1] - law.pressure[from]) /
                                       (law.compression[from + 1] - law.compression[from])});
  }
  return numbers;
}

}  // namespace crumple::materials
