// SPDX-License-Identifier: BSD-3-Clause
#include "model/erosion.hpp"

#include <algorithm>
#include <array>

namespace crumple::model {

bool ErosionCriteria::any() const {
  const std::array<const std::optional<double>*, 12> given = {&largest_pressure,
                                                              &smallest_pressure,
                                                              &largest_principal_stress,
                                                              &largest_equivalent_stress,
                                                              &largest_principal_strain,
                                                              &smallest_principal_strain,
                                                              &effective_strain,
                                                              &effective_plastic_strain,
                                                              &volumetric_strain,
                                                              &shear_strain,
                                                              &impulse,
                                                              &time};
  return std::any_of(given.begin(), given.end(),
                     [](const std::optional<double>* criterion) { return criterion->has_value(); });
}

}  // namespace crumple::model
