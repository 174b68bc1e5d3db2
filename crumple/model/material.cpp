// SPDX-License-Identifier: BSD-3-Clause
#include "model/material.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/elastic_moduli.hpp"

namespace crumple::model {

namespace {

struct Use {
  template <class Law>
  LawUse operator()(const Law& /*law*/) const {
    return {};
  }
  LawUse operator()(const OrthotropicElastic& /*law*/) const { return {true, false, false, false}; }
  LawUse operator()(const CompositeDamage& /*law*/) const { return {true, false, false, false}; }
  LawUse operator()(const JohnsonCook& law) const { return {true, true, !law.simplified, false}; }
  LawUse operator()(const NullMaterial& /*law*/) const { return {true, true, true, true}; }
  LawUse operator()(const ResultantPlasticity& /*law*/) const { return {false, false, false, false}; }
  LawUse operator()(const SpotWeldLaw& /*law*/) const { return {false, false, false, false}; }
  LawUse operator()(const DiscreteBeamLaw& /*law*/) const { return {false, false, false, false}; }
  LawUse operator()(const BlatzKo& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const MooneyRivlin& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const CrushableFoam& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const LowDensityFoam& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const OgdenRubber& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const PolynomialRubber& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const Viscoelastic& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const Honeycomb& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const SoilAndFoam& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const ViscousFoam& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const CapConcrete& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const ThreeSurfaceConcrete& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const HolmquistCeramic& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const HolmquistConcrete& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const HydroPlasticity& /*law*/) const { return {false, true, true, true}; }
  LawUse operator()(const FailingSolid& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const LaminatedFabric& /*law*/) const { return {true, false, false, false}; }
  LawUse operator()(const SheetPlasticity& /*law*/) const { return {true, false, false, false}; }
  LawUse operator()(const BilkhuDuboisFoam& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const SimplifiedRubber& /*law*/) const { return {false, true, false, false}; }
  LawUse operator()(const Cohesive& /*law*/) const { return {false, true, false, false, false, true}; }
  LawUse operator()(const Fabric& /*law*/) const { return {true, false, false, false, true}; }
};

}  // namespace

LawUse use_of(const ConstitutiveLaw& law) {
  return std::visit(Use(), law);
}

bool is_elastic(const ConstitutiveLaw& law) {
  if (const auto* rubber = std::get_if<SimplifiedRubber>(&law)) return !rubber->is_foam;
  if (const auto* rubber = std::get_if<OgdenRubber>(&law)) return rubber->relaxing.empty();
  if (const auto* rubber = std::get_if<PolynomialRubber>(&law)) return rubber->relaxing.empty();
  return std::holds_alternative<Elastic>(law) || std::holds_alternative<BlatzKo>(law) ||
         std::holds_alternative<MooneyRivlin>(law);
}

bool is_crushable(const ConstitutiveLaw& law) {
  if (const auto* rubber = std::get_if<SimplifiedRubber>(&law)) return rubber->is_foam;
  return std::holds_alternative<CrushableFoam>(law) || std::holds_alternative<LowDensityFoam>(law) ||
         std::holds_alternative<BilkhuDuboisFoam>(law) || std::holds_alternative<ViscousFoam>(law) ||
         std::holds_alternative<SoilAndFoam>(law) || std::holds_alternative<Honeycomb>(law);
}

bool has_plastic_strain(const ConstitutiveLaw& law) {
  return std::holds_alternative<PlasticKinematic>(law) || std::holds_alternative<PowerLawPlasticity>(law) ||
         std::holds_alternative<PiecewiseLinearPlasticity>(law) ||
         std::holds_alternative<SheetPlasticity>(law) || std::holds_alternative<JohnsonCook>(law) ||
         std::holds_alternative<HydroPlasticity>(law) || std::holds_alternative<FailingSolid>(law) ||
         std::holds_alternative<CompressionTension>(law);
}

bool has_damage(const PiecewiseLinearPlasticity& law) {
  return !law.damage.empty();
}

bool has_strain_limits(const PiecewiseLinearPlasticity& law) {
  if (has_damage(law)) return false;
  return law.failure_thinning > 0 || law.failure_major > 0 || law.failed_points > 0 || law.failed_share > 0;
}

double stiffness_share(const Honeycomb& law) {
  double largest = 0;
  for (std::size_t k = 0; k < law.moduli.size(); ++k)
    largest = std::max(largest, (k < 3 ? 1 : 2) * law.moduli[k]);
  const double nu = law.poissons_ratio;
  const double compacted = law.youngs_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  return std::min(1.0, largest / compacted);
}

void set_instantaneous(Viscoelastic& law) {
  double shear = 0;
  double bulk = 0;
  for (const Relaxation& part : law.shear) shear += part.modulus;
  for (const Relaxation& part : law.bulk) bulk += part.modulus;
  if (!(shear > 0 && bulk > 0)) return;
  set_moduli(law, bulk, shear);
}

void set_stand_in(OrthotropicElastic& law) {
  const double poisson_ab = law.poisson_ba * law.modulus_a / law.modulus_b;
  const double determinant = 1 - law.poisson_ba * poisson_ab;
  const double aa = law.modulus_a / determinant;
  const double bb = law.modulus_b / determinant;
  const double ab = law.poisson_ba * aa;
  // Largest eigenvalue of the acoustic tensor over the directions of propagation.
  double fastest = 0;
  constexpr int directions = 180;
  for (int k = 0; k < directions; ++k) {
    const double angle = std::numbers::pi * k / directions;
    const double cc = std::cos(angle) * std::cos(angle);
    const double ss = 1 - cc;
    const double first = aa * cc + law.shear_ab * ss;
    const double second = bb * ss + law.shear_ab * cc;
    const double mixed = (ab + law.shear_ab) * std::cos(angle) * std::sin(angle);
    const double half = 0.5 * (first - second);
    fastest = std::max(fastest, 0.5 * (first + second) + std::sqrt(half * half + mixed * mixed));
  }
  // E / (1 - nu^2) = fastest and E / (2 (1 + nu)) >= shear.
  const double shear = std::max(law.shear_bc, law.shear_ca);
  law.poissons_ratio = std::clamp(1 - 2 * shear / fastest, -0.9, 0.4);
  law.youngs_modulus = fastest * (1 - law.poissons_ratio * law.poissons_ratio);
}

void set_stand_in(Fabric& law) {
  OrthotropicElastic all = law.sheet;
  // Moduli of the sum of both: the plane-stress stiffnesses add up by their shares of the thickness.
  const auto stiffness = [&](const OrthotropicElastic& of) {
    const double ab = of.poisson_ba * of.modulus_a / of.modulus_b;
    return of.modulus_a / (1 - of.poisson_ba * ab);
  };
  const double fabric = 1 - law.liner_share;
  const double liner = law.liner_share * law.liner_modulus / (1 - law.liner_ratio * law.liner_ratio);
  const double aa = fabric * stiffness(law.sheet) + liner;
  const double bb = fabric * stiffness(law.sheet) * law.sheet.modulus_b / law.sheet.modulus_a + liner;
  const double ab = fabric * law.sheet.poisson_ba * stiffness(law.sheet) + liner * law.liner_ratio;
  all.modulus_a = aa - ab * ab / bb;
  all.modulus_b = bb - ab * ab / aa;
  all.poisson_ba = ab / aa;
  all.shear_ab = fabric * law.sheet.shear_ab + 0.5 * (1 - law.liner_ratio) * liner;
  all.shear_bc = all.shear_ca = all.shear_ab;
  set_stand_in(all);
  // Damping of the share D of the critical one shortens the step by sqrt(1 + D^2) - D.
  const double shorter = std::sqrt(1 + law.damping * law.damping) - law.damping;
  law.youngs_modulus = all.youngs_modulus / (shorter * shorter);
  law.poissons_ratio = all.poissons_ratio;
}

}  // namespace crumple::model
