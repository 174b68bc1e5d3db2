// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/cohesive.hpp"

#include <limits>
#include <string>
#include <variant>

#include "materials/common/brittle_mode.hpp"
#include "materials/common/checks.hpp"

namespace crumple::materials {
namespace {

using Numbers = MixedMode<double>;

Numbers::Criterion criterion_of(model::Cohesive::Failure failure) {
  switch (failure) {
    case model::Cohesive::Failure::PowerLaw:
      return Numbers::Criterion::PowerLaw;
    case model::Cohesive::Failure::BenzeggaghKenane:
      return Numbers::Criterion::BenzeggaghKenane;
    case model::Cohesive::Failure::Brittle:
      break;
  }
  return Numbers::Criterion::Brittle;
}

double use_of_strength(double stiffness, double strength) {
  return strength > 0 ? (stiffness / strength) * (stiffness / strength) : 0;
}

Numbers numbers_of(const model::Cohesive& law) {
  Numbers found;
  found.criterion = criterion_of(law.failure);
  found.normal_stiffness = law.youngs_modulus;
  found.shear_stiffness = law.shear_stiffness;
  found.normal_use = use_of_strength(law.youngs_modulus, law.normal_strength);
  found.shear_use = use_of_strength(law.shear_stiffness, law.shear_strength);
  found.normal_energy = law.normal_energy;
  found.shear_energy = law.shear_energy;
  found.exponent = law.exponent;
  found.stiffness_exponent = law.stiffness_exponent;
  return found;
}

}  // namespace

void CohesiveLaw::declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                                  Index /*tensor*/) {
  domain::add_item(block, "separation", "length", 3 * block.points);
  domain::add_item(block, "cohesive_damage", "-", block.points);
}

std::vector<double> CohesiveLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require(law.youngs_modulus > 0 && law.shear_stiffness > 0, material,
          "the stiffnesses of the tractions must be above zero");
  require(law.failed_points >= 0 && law.failed_points <= 4, material,
          "an element has four points that may fail");
  const Numbers numbers = numbers_of(law);
  if (law.failure != Model::Failure::Brittle) {
    require(law.normal_strength > 0 && law.shear_strength > 0, material,
            "the strengths in tension and shear must be above zero");
    require(law.normal_energy > 0 && law.shear_energy > 0, material,
            "the energies of both modes must be above zero");
    require(law.exponent > 0 && law.stiffness_exponent > 0, material,
            "the exponents of mixed modes must be above zero");
    const std::string mode = brittle_mode(numbers);
    require(
        mode.empty(), material,
        "in " + mode +
            " it stores more energy up to its strength than it may take in all (strength^2 / (2 stiffness) "
            "against the energy of the mode): raise the stiffness, or lower the strength");
  }
  std::vector<double> found(Count);
  found[Criterion] = static_cast<double>(numbers.criterion);
  found[NormalStiffness] = numbers.normal_stiffness;
  found[ShearStiffness] = numbers.shear_stiffness;
  found[NormalUse] = numbers.normal_use;
  found[ShearUse] = numbers.shear_use;
  found[NormalEnergy] = numbers.normal_energy;
  found[ShearEnergy] = numbers.shear_energy;
  found[Exponent] = numbers.exponent;
  found[StiffnessExponent] = numbers.stiffness_exponent;
  constexpr auto never = static_cast<double>(std::numeric_limits<float>::max());
  found[FailedPoints] = law.failed_points > 0 ? law.failed_points : never;
  return found;
}

bool CohesiveLaw::can_fail(const model::ConstitutiveLaw& law) {
  const auto& cohesive = std::get<Model>(law);
  return cohesive.failed_points > 0 && (cohesive.normal_strength > 0 || cohesive.shear_strength > 0);
}

}  // namespace crumple::materials
