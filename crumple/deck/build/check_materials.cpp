// SPDX-License-Identifier: BSD-3-Clause
// Numbers of materials that are right one by one and hardly so together.
#include <fmt/core.h>

#include <cmath>
#include <variant>

#include "deck/build/build.hpp"
#include "deck/build/units.hpp"

namespace crumple::deck {

namespace {

/// Yield stress at zero plastic strain and rate; zero for laws without one.
struct FirstYield {
  template <class Law>
  double operator()(const Law& law) const {
    if constexpr (requires { law.yield_stress > 0; })
      return law.yield_stress;
    else
      return 0;
  }
  double operator()(const model::PiecewiseLinearPlasticity& law) const {
    const auto& stress = law.by_rate.empty() ? law.yield_stress : law.by_rate.front().yield_stress;
    return stress.empty() ? 0 : stress.front();
  }
  double operator()(const model::SheetPlasticity& law) const {
    return law.yield_stress.empty() ? law.strength * std::pow(law.yield_strain, law.hardening_exponent)
                                    : law.yield_stress.front();
  }
  double operator()(const model::PowerLawPlasticity& law) const {
    return law.strength * std::pow(law.yield_strain, law.exponent);
  }
};

void check_yield_stress(const RawMaterial& raw, const model::Material& material, Report& report) {
  constexpr double largest_strain = 0.1;
  const double modulus = std::visit([](const auto& law) { return law.youngs_modulus; }, material.law);
  const double yield = std::visit(FirstYield(), material.law);
  if (modulus > 0 && yield > largest_strain * modulus)
    report.warning(raw.where, "yield stress",
                   fmt::format("the first yield stress {:.4g} is above a tenth of the modulus {:.4g}, metals "
                               "yield at a thousandth to a hundredth: are both in the same unit? A material "
                               "that stays elastic is *MAT_ELASTIC",
                               yield, modulus));
}

}  // namespace

void check_materials(Build& build) {
  const std::vector<std::string> doubts = unit_doubts(build.model);
  for (std::size_t i = 0; i < doubts.size(); ++i) {
    const RawMaterial& raw = build.deck.materials[i];
    check_yield_stress(raw, build.model.materials[i], build.report);
    if (!doubts[i].empty()) build.report.warning(raw.where, "units", doubts[i]);
  }
}

}  // namespace crumple::deck
