// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/bulk_modulus.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

#include "contact/tolerances.hpp"

namespace crumple::contact {

namespace {

double steepest_slope(const std::vector<double>& x, const std::vector<double>& y, double least) {
  for (std::size_t i = 1; i < x.size(); ++i) least = std::max(least, (y[i] - y[i - 1]) / (x[i] - x[i - 1]));
  return least;
}

/// Where a curve over the crush tells how a material resists once it is dense, its steepest slope, or E.
template <class Law>
double stiffness_of(const Law& law) {
  if constexpr (requires { steepest_slope(law.crush, law.yield_stress, law.youngs_modulus); })
    return steepest_slope(law.crush, law.yield_stress, law.youngs_modulus);
  else
    return law.youngs_modulus;
}

/// Of foam KCON; else the steepest slope of its curve, or E. E alone is a tenth and less of what foam resists
/// with once it is dense (S. Bala, Best practices for modeling recoverable low density foams, d3view, 2006).
double stiffness_of(const model::LowDensityFoam& law) {
  if (law.contact_modulus > 0) return law.contact_modulus;
  return steepest_slope(law.compression, law.stress, law.youngs_modulus);
}

}  // namespace

double bulk_modulus(const model::Model& model, const model::Part& part) {
  const model::Material& material = model.materials[part.material];
  if (const auto* equation = model::equation_of_state_of(model, part))
    return model::initial_bulk_modulus(*equation, material.density);
  return std::visit(
      [](const auto& law) {
        const double compressibility =
            std::max(1.0 - 2.0 * law.poissons_ratio, tolerances::smallest_compressibility);
        return stiffness_of(law) / (3.0 * compressibility);
      },
      material.law);
}

}  // namespace crumple::contact
