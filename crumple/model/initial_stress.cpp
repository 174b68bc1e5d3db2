// SPDX-License-Identifier: BSD-3-Clause
#include "model/initial_stress.hpp"

#include <algorithm>
#include <variant>

namespace crumple::model {
namespace {

/// Of laws with a plastic strain.
std::string plastic_refusal(const InitialStress& stress, const char* unknown) {
  double least = 0;
  double most = 0;
  for (const InitialPointStress& point : stress.points) {
    least = std::min(least, point.plastic_strain);
    most = std::max(most, point.plastic_strain);
  }
  if (least < 0) return "the plastic strain EPS is below zero";
  return most > 0 && unknown != nullptr ? unknown : "";
}

struct Refusal {
  const InitialStress& stress;

  template <class Law>
  std::string operator()(const Law& /*law*/) const {
    return "the law does not go on from a stress, but from a deformation that is not known";
  }
  std::string operator()(const Elastic& /*law*/) const { return ""; }
  std::string operator()(const OrthotropicElastic& /*law*/) const { return ""; }
  std::string operator()(const Fabric& /*law*/) const { return ""; }
  std::string operator()(const NullMaterial& /*law*/) const { return "the material has no stress"; }
  std::string operator()(const SheetPlasticity& /*law*/) const { return plastic_refusal(stress, nullptr); }
  std::string operator()(const PowerLawPlasticity& /*law*/) const { return plastic_refusal(stress, nullptr); }
  std::string operator()(const CompressionTension& /*law*/) const { return plastic_refusal(stress, nullptr); }
  std::string operator()(const FailingSolid& /*law*/) const { return plastic_refusal(stress, nullptr); }
  std::string operator()(const PiecewiseLinearPlasticity& law) const {
    return plastic_refusal(
        stress, has_strain_limits(law) ? "the strains at which points fail count from the start" : nullptr);
  }
  std::string operator()(const JohnsonCook& law) const {
    const bool damages = std::any_of(law.damage.begin(), law.damage.end(), [](double d) { return d != 0; });
    const bool heats = law.heat_capacity > 0 && law.thermal_exponent != 0;
    return plastic_refusal(
        stress, damages || heats ? "the damage and the heat that belong to the plastic strain are not known"
                                 : nullptr);
  }
  std::string operator()(const PlasticKinematic& law) const {
    return plastic_refusal(
        stress,
        has_back_stress(law) && !stress.has_back_stress
            ? "the centre of the yield surface that belongs to the plastic strain is not known; give it "
              "with NHISV = 5, or use BETA = 1"
            : nullptr);
  }
};

}  // namespace

bool has_back_stress(const ConstitutiveLaw& law) {
  const auto* const own = std::get_if<PlasticKinematic>(&law);
  return own != nullptr && own->tangent_modulus != 0 && own->isotropic_fraction < 1;
}

std::string refusal_of_initial_stress(const ConstitutiveLaw& law, const InitialStress& stress) {
  return std::visit(Refusal{stress}, law);
}

std::string refusal_of_initial_stress(const Model& model, const Part& part, Index layup,
                                      const InitialStress& stress) {
  if (part.equation_of_state != no_index)
    return "the pressure is that of the equation of state, by the density";
  const auto material = [&](Index index) -> const Material& {
    return model.materials[static_cast<std::size_t>(index)];
  };
  if (layup == no_index) return refusal_of_initial_stress(material(part.material).law, stress);
  for (const ShellLayer& layer : model.layups[static_cast<std::size_t>(layup)].layers)
    if (std::string refusal = refusal_of_initial_stress(material(layer.material).law, stress);
        !refusal.empty())
      return refusal;
  return "";
}

}  // namespace crumple::model
