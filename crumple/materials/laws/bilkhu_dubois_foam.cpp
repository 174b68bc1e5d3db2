// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/bilkhu_dubois_foam.hpp"

#include <string>
#include <variant>

#include "materials/common/checks.hpp"
#include "materials/plasticity/hardening_table.hpp"

namespace crumple::materials {
namespace {

void require_foam_curve(const model::Material& material, const model::PointCurve& curve,
                        const std::string& which) {
  require(!curve.abscissa.empty() && curve.abscissa.size() == curve.ordinate.size(), material,
          which + " must have points");
  require(curve.abscissa.front() == 0, material, which + " must start at zero");
  for (std::size_t k = 0; k < curve.abscissa.size(); ++k) {
    require(curve.ordinate[k] > 0, material, which + " must be above zero");
    if (k > 0)
      require(curve.abscissa[k] > curve.abscissa[k - 1], material,
              "the strains of " + which + " must ascend");
  }
  const std::size_t last = curve.ordinate.size() - 1;
  require(last == 0 || curve.ordinate[last] >= curve.ordinate[last - 1], material,
          which + " must not fall at its end");
}

}  // namespace

std::vector<double> BilkhuDuboisFoamLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require_foam_curve(material, law.pressure, "the yield pressure over the volumetric strain");
  require_foam_curve(material, law.uniaxial, "the uniaxial yield stress over the volumetric strain");
  require(model::no_ellipse(law) < 0, material,
          "the yield pressure must be above a third of the uniaxial yield stress at every volumetric strain");
  require(law.tension_pressure >= 0 && law.tension_pressure_share >= 0 && law.tension_stress >= 0 &&
              law.tension_stress_share >= 0,
          material, "the strengths in tension must not be negative");
  require(law.tension_stress_share <= 1, material,
          "the share of the uniaxial yield stress must not exceed 1");
  require(law.rate_factor.abscissa.size() == law.rate_factor.ordinate.size(), material,
          "the curve of rate factors must have as many factors as rates");
  std::vector<double> numbers(Count);
  numbers[Youngs] = law.youngs_modulus;
  numbers[Poissons] = law.poissons_ratio;
  numbers[HydrostaticShare] = law.tension_pressure_share;
  numbers[Hydrostatic] = law.tension_pressure;
  numbers[UniaxialShare] = law.tension_stress_share;
  numbers[Uniaxial] = law.tension_stress;
  const bool none = law.tension_pressure == 0 && law.tension_pressure_share == 0 && law.tension_stress == 0 &&
                    law.tension_stress_share == 0;
  if (none) numbers[Hydrostatic] = 0.1 * law.pressure.ordinate.front();
  numbers[PressurePoints] = static_cast<double>(law.pressure.abscissa.size());
  numbers[UniaxialPoints] = static_cast<double>(law.uniaxial.abscissa.size());
  numbers[RatePoints] = static_cast<double>(law.rate_factor.abscissa.size());
  append_table(law.pressure.abscissa, law.pressure.ordinate, true, numbers);
  append_table(law.uniaxial.abscissa, law.uniaxial.ordinate, true, numbers);
  append_table(law.rate_factor.abscissa, law.rate_factor.ordinate, false, numbers);
  return numbers;
}

}  // namespace crumple::materials
