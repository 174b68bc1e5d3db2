// SPDX-License-Identifier: BSD-3-Clause
// What elements ask of the constitutive laws of integrated beams, answered through their list.
#include <variant>

#include "base/isa_variants.hpp"
#include "materials/common/section_material.hpp"
#include "materials/laws/section_laws.hpp"

namespace crumple::materials {
namespace {

/// Calls visit(Law{}, kind) for the law that computes this model; false if the list has none.
template <class Visit, class... Laws>
bool with_section_law(const model::ConstitutiveLaw& law, const Visit& visit,
                      SectionLawList<Laws...> /*list*/) {
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

}  // namespace

int section_material_kind(const model::ConstitutiveLaw& law) {
  // Heat, damage and limits of strains are there for shells and solids only.
  if (const auto* heated = std::get_if<model::JohnsonCook>(&law); heated != nullptr && !heated->simplified)
    return -1;
  if (const auto* limited = std::get_if<model::PiecewiseLinearPlasticity>(&law);
      limited != nullptr && model::has_strain_limits(*limited))
    return -1;
  int found = -1;
  with_section_law(
      law, [&](auto, int kind) { found = kind; }, SectionLaws{});
  return found;
}

Index declare_section_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block) {
  const Index first = block.components;
  with_section_law(
      law, [&]<class Law>(Law, int) { Law::declare_history(law, block, section_components); }, SectionLaws{});
  return first;
}

std::vector<double> section_material_constants(const model::Material& material) {
  std::vector<double> constants;
  with_section_law(
      material.law, [&]<class Law>(Law, int) { constants = Law::constants(material); }, SectionLaws{});
  return constants;
}

SectionUpdate section_material_update(Isa isa, int kind) {
  return visit_isa(isa, [&]<Isa Variant>() { return section_law_kernel<Variant>(kind); });
}

}  // namespace crumple::materials
