// SPDX-License-Identifier: BSD-3-Clause
#include "app/preparation/part_tables.hpp"

#include <algorithm>
#include <ostream>
#include <string_view>
#include <variant>
#include <vector>

#include "app/console/print.hpp"
#include "base/counted.hpp"
#include "elements/line/beam_kernel_list.hpp"
#include "elements/registry.hpp"
#include "materials/common/shell_material.hpp"
#include "output/results/part_masses.hpp"

namespace crumple::app {

namespace {

/// Rows of a table; of more parts only the first are listed.
constexpr Index part_rows = 60;

std::string thickness_range(const model::Model& model, Index part) {
  double least = 1e300;
  double most = 0;
  for (const model::ShellElement& shell : model.shells) {
    if (shell.part != part) continue;
    for (const double thickness : model::shell_thickness(model, shell)) {
      least = std::min(least, thickness);
      most = std::max(most, thickness);
    }
  }
  if (most == 0) return "-";
  return least == most ? fmt::format("{:.4g}", most) : fmt::format("{:.4g}-{:.4g}", least, most);
}

/// Number of the points through the thickness and their rule.
std::string points_words(const model::Model& model, const model::Part& part,
                         const model::ShellSection& section) {
  if (part.layup != no_index && !model.layups[part.layup].follows_rule)
    return counted(model.layups[part.layup].layers.size(), "layer");
  const char* rule = section.thickness_rule == model::ThicknessRule::Gauss     ? "Gauss"
                     : section.thickness_rule == model::ThicknessRule::Lobatto ? "Lobatto"
                                                                               : "trapezoid";
  return fmt::format("{} {}", section.thickness_points, rule);
}

bool is_solid(const model::Part& part) {
  return part.solid_section != no_index;
}

struct ElementWords {
  const char* kind;
  std::string points;
};
ElementWords beam_words(const model::BeamSection& section) {
  return {elements::beam_name(section.formulation),
          section.points.empty() ? "-" : std::to_string(section.points.size())};
}
ElementWords element_words(const model::Model& model, const model::Part& part) {
  if (is_solid(part)) {
    const elements::SolidKind kind =
        elements::solid_kind(model.solid_sections[part.solid_section].formulation);
    return {kind.name, std::to_string(kind.points)};
  }
  if (const model::ElementKind kind = model::kind_of(part); kind == model::ElementKind::Beam)
    return beam_words(model.beam_sections[part.beam_section]);
  else if (kind == model::ElementKind::Discrete)
    return {model.discrete_sections[part.discrete_section].torsional ? "discrete, torsional" : "discrete",
            "-"};
  const model::ShellSection& section = model.shell_sections[part.section];
  return {elements::shell_kind(section.formulation).name, points_words(model, part, section)};
}

bool is_shell(const model::Part& part) {
  return model::kind_of(part) == model::ElementKind::Shell;
}

/// The law of all layers, or that there are several.
const char* layers_words(const model::Model& model, const model::Layup& layup) {
  const auto name_of = [&](const model::ShellLayer& layer) {
    return materials::shell_material_name(model.materials[layer.material].law);
  };
  const char* const first = name_of(layup.layers.front());
  for (const model::ShellLayer& layer : layup.layers)
    if (std::string_view(name_of(layer)) != first) return "layers of several laws";
  return first;
}

const char* material_words(const model::Model& model, const model::Part& part) {
  if (model::is_rigid(model, part)) return "rigid";
  if (part.spring_material != no_index)
    return model::name_of(model.spring_materials[part.spring_material].law);
  const model::ConstitutiveLaw& law = model.materials[part.material].law;
  if (std::holds_alternative<model::ResultantPlasticity>(law)) return "resultant plasticity";
  if (std::holds_alternative<model::SpotWeldLaw>(law)) return "spot weld";
  if (part.layup != no_index) return layers_words(model, model.layups[part.layup]);
  if (const auto* discrete = std::get_if<model::DiscreteBeamLaw>(&law))
    return discrete->kind == model::DiscreteBeamLaw::Kind::Axes    ? "six directions"
           : discrete->kind == model::DiscreteBeamLaw::Kind::Cable ? "cable"
                                                                   : "spring";
  return materials::shell_material_name(law);
}

/// Words for the forms of solids, in the order of the enumeration.
constexpr const char* solid_forms[] = {"viscous, standard",       "viscous",
                                       "viscous, exact volume",   "stiffness",
                                       "stiffness, exact volume", "assumed strain"};

void print_make(std::ostream& out, const model::Model& model, const domain::Domain& domain, Index rows) {
  const output::PartMasses masses(output::View{model, domain, 0});
  std::vector<Index> elements(model.parts.size());
  for (const model::ShellElement& shell : model.shells) ++elements[shell.part];
  for (const model::SolidElement& solid : model.solids) ++elements[solid.part];
  for (const model::BeamElement& beam : model.beams) ++elements[beam.part];
  for (const model::DiscreteElement& discrete : model.discretes) ++elements[discrete.part];
  print(out, "  {:>8} {:>8}  {:<29} {:<27} {:>12} {:>14} {:>11}  title\n", "part", "elements", "element",
        "material", "points", "thickness", "mass");
  for (Index p = 0; p < rows; ++p) {
    const model::Part& part = model.parts[p];
    const ElementWords words = element_words(model, part);
    print(out, "  {:>8} {:>8}  {:<26} {:<23} {:>12} {:>14} {:>11.4g}  {}\n", part.id, elements[p], words.kind,
          material_words(model, part), words.points, thickness_range(model, p), masses.mass(p), part.title);
  }
}

void print_options(std::ostream& out, const model::Model& model, Index rows) {
  print(out, "  {:>8} {:>8}  {:<29} {}\n", "part", "NLOC", "hourglass control", "strain rate effect");
  for (Index p = 0; p < rows; ++p) {
    const model::Part& part = model.parts[p];
    const std::string place =
        !is_shell(part) ? "-" : fmt::format("{:.4g}", model.shell_sections[part.section].node_place);
    print(out, "  {:>8} {:>8}  {:<29} {}\n", part.id, place, hourglass_words(model, part),
          part.material == no_index ? "-" : rate_words(model.materials[part.material].law));
  }
}

std::string with_option(std::string_view effect, bool viscoplastic) {
  return fmt::format("{}, VP {}", effect, viscoplastic ? 1 : 0);
}

/// Words for each kind of law.
struct RateWords {
  template <class Law>
  std::string operator()(const Law& law) const {
    if constexpr (requires { law.cowper_symonds_rate; })
      if (law.cowper_symonds_rate > 0) return with_option("Cowper-Symonds", law.viscoplastic);
    return "none";
  }
  std::string operator()(const model::SheetPlasticity& law) const {
    return law.cowper_symonds_rate > 0 ? with_option("Cowper-Symonds", false) : "none";
  }
  std::string operator()(const model::BilkhuDuboisFoam& law) const {
    return law.rate_factor.abscissa.empty() ? "none" : "factors by rate";
  }
  std::string operator()(const model::CapConcrete& law) const {
    return law.has_rate_effects ? "overstress by rate" : "none";
  }
  std::string operator()(const model::HolmquistCeramic& law) const {
    return law.rate_coefficient > 0 ? "C ln(rate)" : "none";
  }
  std::string operator()(const model::HolmquistConcrete& law) const {
    return law.rate_coefficient > 0 ? "C ln(rate)" : "none";
  }
  std::string operator()(const model::JohnsonCook& law) const {
    return law.rate_coefficient > 0 ? with_option("C ln(rate)", law.viscoplastic) : "none";
  }
  // In the order in which they go before each other.
  std::string operator()(const model::PiecewiseLinearPlasticity& law) const {
    if (!law.by_rate.empty())
      return with_option(counted(law.by_rate.size(), "curve") + " by rate", law.viscoplastic);
    if (!law.factor_rate.empty()) return with_option("factors by rate", law.viscoplastic);
    return law.cowper_symonds_rate > 0 ? with_option("Cowper-Symonds", law.viscoplastic) : "none";
  }
};

}  // namespace

std::string hourglass_words(const model::Model& model, const model::Part& part) {
  if (model::is_rigid(model, part)) return "none";
  using enum model::ShellFormulation;
  if (is_solid(part)) {
    using model::SolidFormulation;
    if (model.solid_sections[part.solid_section].formulation != SolidFormulation::OnePointHexahedron)
      return "none";
    const model::HourglassControl control = model::solid_hourglass_of(model, part);
    return fmt::format("{} QM {:.4g}", solid_forms[static_cast<std::size_t>(control.solid_form)],
                       control.coefficient);
  }
  if (!is_shell(part)) return "none";
  const model::ShellFormulation formulation = model.shell_sections[part.section].formulation;
  if (!model::is_hourglassing(formulation)) return "none";
  if (!materials::has_stiffness(model.materials[part.material].law)) return "none";
  const model::HourglassControl& control = model::hourglass_of(model, part);
  if (control.form == model::HourglassForm::Material) return "stiffness of the material";
  const char* form = control.form == model::HourglassForm::Viscous ? "viscous" : "stiffness";
  // Of selectively reduced shells only the warping is controlled.
  if (formulation == HughesLiuSelectiveReduced) return fmt::format("{} QW {:.4g}", form, control.warping);
  if (formulation == Membrane)
    return control.warping == control.coefficient
               ? fmt::format("{} QM {:.4g}", form, control.coefficient)
               : fmt::format("{} QM {:.4g} QW {:.4g}", form, control.coefficient, control.warping);
  if (control.bending == control.coefficient && control.warping == control.coefficient)
    return fmt::format("{} QM {:.4g}", form, control.coefficient);
  return fmt::format("{} QM {:.4g} QB {:.4g} QW {:.4g}", form, control.coefficient, control.bending,
                     control.warping);
}

std::string rate_words(const model::ConstitutiveLaw& law) {
  return std::visit(RateWords(), law);
}

void print_parts(std::ostream& out, const model::Model& model, const domain::Domain& domain) {
  const Index rows = std::min(part_rows, static_cast<Index>(model.parts.size()));
  print_make(out, model, domain, rows);
  print_options(out, model, rows);
  if (rows < static_cast<Index>(model.parts.size()))
    print(out, "  ... and {} more\n", counted(static_cast<Index>(model.parts.size()) - rows, "part"));
}

}  // namespace crumple::app
