// SPDX-License-Identifier: BSD-3-Clause
#include "materials/plasticity/hardening_table.hpp"

#include <algorithm>
#include <cstddef>

#include "materials/common/checks.hpp"

namespace crumple::materials {

void append_table(const std::vector<double>& abscissa, const std::vector<double>& value, bool goes_on,
                  std::vector<double>& numbers) {
  double slope = 0;
  for (std::size_t k = 0; k < abscissa.size(); ++k) {
    if (k + 1 < abscissa.size())
      slope = (value[k + 1] - value[k]) / (abscissa[k + 1] - abscissa[k]);
    else if (!goes_on)
      slope = 0;
    numbers.insert(numbers.end(), {abscissa[k], value[k], slope});
  }
}

bool ascending(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), [](double a, double b) { return !(b > a); }) ==
         values.end();
}

void require_hardening_table(const model::Material& material, double youngs_modulus,
                             const std::vector<double>& strain, const std::vector<double>& stress) {
  require(!strain.empty() && strain.size() == stress.size(), material,
          "the hardening table needs as many yield stresses as plastic strains, and at least one");
  require(strain.front() == 0, material, "the hardening table must start at zero plastic strain");
  require(*std::min_element(stress.begin(), stress.end()) > 0, material,
          "every yield stress of the hardening table must be above zero");
  require(ascending(strain), material, "the plastic strains of the hardening table must ascend");
  // Softening as steep as the elastic unloading has no stable answer.
  for (std::size_t k = 0; k + 1 < strain.size(); ++k)
    require(stress[k + 1] - stress[k] > -0.25 * youngs_modulus * (strain[k + 1] - strain[k]), material,
            "the hardening table falls more steeply than a quarter of Young's modulus");
}

}  // namespace crumple::materials
