// SPDX-License-Identifier: BSD-3-Clause
// The registry: what the rest of the solver asks of a constitutive law, answered through the list.
#include <cmath>
#include <variant>

#include "base/error.hpp"
#include "base/isa_variants.hpp"
#include "materials/common/shell_material.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/equations_of_state.hpp"
#include "materials/kernel_list.hpp"
#include "materials/list.hpp"

namespace crumple::materials {
namespace {

/// Calls visit(Law{}, kind) for the law that computes this model; false if the list has none.
template <class Visit, class... Laws>
bool with_law(const model::ConstitutiveLaw& law, const Visit& visit, LawList<Laws...> /*list*/) {
  int kind = -1;
  const auto try_one = [&]<class Law>(Law one) {
    ++kind;
    if (!std::holds_alternative<typename Law::Model>(law)) return false;
    if constexpr (requires { Law::takes(law); })
      if (!Law::takes(law)) return false;
    visit(one, kind);
    return true;
  };
  return (try_one(Laws{}) || ...);
}

/// The same for a law of shells or solids, whose kind it does not ask for.
template <class Visit>
void with_any_law(const model::ConstitutiveLaw& law, const Visit& visit) {
  const auto without_kind = [&](auto one, int) { visit(one); };
  with_law(law, without_kind, ShellLaws{}) || with_law(law, without_kind, SolidLaws{});
}

}  // namespace

double ElasticConstants::plate_wave_speed() const {
  return std::sqrt(youngs_modulus / (density * (1 - poissons_ratio * poissons_ratio)));
}

double ElasticConstants::bulk_wave_speed() const {
  const double nu = poissons_ratio;
  return std::sqrt(youngs_modulus * (1 - nu) / (density * (1 + nu) * (1 - 2 * nu)));
}

int shell_material_kind(const model::ConstitutiveLaw& law) {
  int found = -1;
  with_law(
      law, [&](auto, int kind) { found = kind; }, ShellLaws{});
  return found;
}

const char* shell_material_name(const model::ConstitutiveLaw& law) {
  const char* name = "?";
  with_any_law(law, [&]<class Law>(Law) {
    if constexpr (requires { Law::name_of(law); })
      name = Law::name_of(law);
    else
      name = Law::name;
  });
  return name;
}

Index declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block) {
  const Index first = block.components;
  with_law(
      law, [&]<class Law>(Law, int) { Law::declare_history(law, block, components); }, ShellLaws{});
  return first;
}

std::vector<double> shell_material_constants(const model::Material& material) {
  std::vector<double> constants;
  with_law(
      material.law, [&]<class Law>(Law, int) { constants = Law::constants(material); }, ShellLaws{});
  return constants;
}

void prepare_element(const model::ConstitutiveLaw& law, const LaminaAxes& axes, domain::ElementBlock& block,
                     Index history, Index place) {
  with_law(
      law,
      [&]<class Law>(Law, int) {
        if constexpr (requires { Law::prepare_element(law, axes, block, history, place); })
          Law::prepare_element(law, axes, block, history, place);
      },
      ShellLaws{});
}

bool has_axes(const model::ConstitutiveLaw& law) {
  bool axes = false;
  with_law(
      law,
      [&]<class Law>(Law, int) {
        axes = requires(const LaminaAxes& of, domain::ElementBlock& block) {
          Law::prepare_element(law, of, block, 0, 0);
        };
      },
      ShellLaws{});
  return axes;
}

bool has_stiffness(const model::ConstitutiveLaw& law) {
  bool stiff = true;
  with_any_law(law, [&]<class Law>(Law) {
    if constexpr (requires { Law::has_stiffness; }) stiff = Law::has_stiffness;
  });
  return stiff;
}

bool can_fail(const model::Material& material) {
  bool fails = false;
  with_any_law(material.law, [&]<class Law>(Law) { fails = Law::can_fail(material.law); });
  return fails;
}

ElasticConstants elastic_constants(const model::Material& material) {
  return std::visit(
      [&](const auto& law) {
        return ElasticConstants{law.youngs_modulus, law.poissons_ratio, material.density};
      },
      material.law);
}

template <class Real>
MaterialUpdate<Real> shell_material_update(Isa isa, int kind) {
  return visit_isa(isa, [&]<Isa Variant>() { return shell_law_kernel<Variant, Real>(kind); });
}
template MaterialUpdate<float> shell_material_update<float>(Isa isa, int kind);
template MaterialUpdate<double> shell_material_update<double>(Isa isa, int kind);

int solid_material_kind(const model::ConstitutiveLaw& law) {
  int found = -1;
  with_law(
      law, [&](auto, int kind) { found = kind; }, SolidLaws{});
  return found;
}

Index declare_solid_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block) {
  const Index first = block.components;
  with_law(
      law, [&]<class Law>(Law, int) { Law::declare_history(law, block, solid_components); }, SolidLaws{});
  return first;
}

void prepare_solid_element(const model::ConstitutiveLaw& law, const SolidCorners& corners, UserId solid,
                           domain::ElementBlock& block, Index history, Index place) {
  with_law(
      law,
      [&]<class Law>(Law, int) {
        if constexpr (requires { Law::prepare_solid_element(law, corners, solid, block, history, place); })
          Law::prepare_solid_element(law, corners, solid, block, history, place);
      },
      SolidLaws{});
}

std::vector<double> solid_material_constants(const model::Material& material,
                                             const model::EquationOfState* equation) {
  model::Material used = material;
  if (auto* law = std::get_if<model::JohnsonCook>(&used.law))
    if (equation != nullptr && law->shear_modulus > 0)
      law->youngs_modulus = 2 * law->shear_modulus * (1 + law->poissons_ratio);
  std::vector<double> constants;
  with_law(
      used.law,
      [&]<class Law>(Law, int) {
        if constexpr (requires { Law::solid_constants(used); })
          constants = Law::solid_constants(used);
        else
          constants = Law::constants(used);
      },
      SolidLaws{});
  return constants;
}

SolidStart solid_start(const model::Material& material, const model::EquationOfState* equation) {
  const ElasticConstants elastic = elastic_constants(material);
  SolidStart start;
  start.density = material.density;
  if (equation != nullptr) {
    start.density /= equation->initial_volume;
    start.wave_speed = eos_wave_speed(material, *equation);
    start.varies = true;
    return start;
  }
  start.wave_speed = elastic.bulk_wave_speed();
  with_law(
      material.law,
      [&]<class Law>(Law, int) {
        start.varies = requires {
          Law::wave_speed_varies;
        };
        if constexpr (requires { Law::linear_viscosity(material.law); })
          start.linear_viscosity = Law::linear_viscosity(material.law);
        if constexpr (requires { Law::own_viscosity(material.law); })
          start.own_viscosity = Law::own_viscosity(material.law);
        if constexpr (requires { Law::stiffness_share(material.law); })
          start.stiffness_share = Law::stiffness_share(material.law);
      },
      SolidLaws{});
  start.wave_speed *= std::sqrt(start.stiffness_share);
  return start;
}

bool solid_can_fail(const model::Material& material) {
  bool fails = false;
  with_law(
      material.law,
      [&]<class Law>(Law, int) {
        if constexpr (requires { Law::solid_can_fail(material.law); })
          fails = Law::solid_can_fail(material.law);
        else
          fails = Law::can_fail(material.law);
      },
      SolidLaws{});
  return fails;
}

template <class Real>
SolidMaterialUpdate<Real> solid_material_update(Isa isa, int kind) {
  return visit_isa(isa, [&]<Isa Variant>() { return solid_law_kernel<Variant, Real>(kind); });
}
template SolidMaterialUpdate<float> solid_material_update<float>(Isa isa, int kind);
template SolidMaterialUpdate<double> solid_material_update<double>(Isa isa, int kind);

}  // namespace crumple::materials
