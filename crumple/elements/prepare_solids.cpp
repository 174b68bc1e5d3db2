// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "elements/common/damage_growth.hpp"
#include "elements/common/erosion_check.hpp"
#include "elements/common/short_steps.hpp"
#include "elements/common/stiffness_damping.hpp"
#include "elements/lone_elements.hpp"
#include "elements/prepare.hpp"
#include "elements/prepare_cohesives.hpp"
#include "elements/registry.hpp"
#include "elements/solid/nodal_average.hpp"
#include "elements/solid/solid_setup.hpp"
#include "elements/solid/solid_task.hpp"
#include "math/cube_root.hpp"

namespace crumple::elements {
namespace {

using domain::SolidBlock;
using materials::ElasticConstants;

/// The factors that do not change during the run, see hourglass_modulus().
void set_hourglass(const model::HourglassControl& control, const ElasticConstants& elastic,
                   SolidConstants<double>& constants) {
  using Form = model::SolidHourglassForm;
  const Form form = control.solid_form;
  constants.assumed_strain = form == Form::AssumedStrain;
  constants.exact_volume =
      form == Form::ExactVolumeViscous || form == Form::ExactVolumeStiffness || constants.assumed_strain;
  constants.without_linear_part = form != Form::StandardViscous;
  constants.viscous = form != Form::FlanaganBelytschkoStiffness && form != Form::ExactVolumeStiffness;
  if (constants.assumed_strain) {
    const double nu = elastic.poissons_ratio;
    constants.hourglass = control.coefficient * elastic.shear_modulus();
    constants.bend_together = std::sqrt((1 + nu) / (1 - nu));
    constants.warp = std::sqrt(2 * (1 + nu) / 3);
    return;
  }
  const double modulus = constants.density * constants.wave_speed * constants.wave_speed;
  constants.hourglass = constants.viscous ? 0.25 * control.coefficient * constants.wave_speed
                                          : 0.5 * control.coefficient * modulus;
}

void declare_own_items(bool can_fail, const KeptItem& kept, SolidBlock& block) {
  domain::add_item(block, "reference_volume", "length^3", 1);
  domain::add_item(block, "active", "-", 1);
  domain::add_item(block, "step_scale", "-", 1);
  domain::add_item(block, "bulk_viscosity", "stress", 1);
  if (kept.count > 0) domain::add_item(block, kept.name, kept.unit, kept.count);
  if (can_fail) domain::add_item(block, "energy", "energy", 2);
}

void require_equation_of_state(const model::Part& part, const model::Material& material, bool given) {
  const model::LawUse use = model::use_of(material.law);
  require(given || !use.needs_equation_of_state, part, "its material needs an equation of state in solids");
  require(!given || use.takes_equation_of_state, part, "its material takes no equation of state");
}

/// Returns the place of its numbers behind those of the material.
Index add_equation(const model::Material& material, const model::EquationOfState& equation, Index law_history,
                   SolidBlock& block) {
  const Index history = materials::declare_eos_history(block) - law_history;
  const auto place = static_cast<Index>(block.material_constants.size());
  const std::vector<double> numbers = materials::eos_constants(material, equation, history);
  block.material_constants.insert(block.material_constants.end(), numbers.begin(), numbers.end());
  return place;
}

void set_interior(const model::Part& part, SolidConstants<double>& constants) {
  if (!part.interior) return;
  const double confined = constants.density * constants.wave_speed * constants.wave_speed;
  const double modulus = part.interior->modulus > 0 ? part.interior->modulus : confined;
  constants.interior_modulus = part.interior->scale * modulus;
  constants.interior_volume = part.interior->relative_volume;
  constants.interior_speed_square =
      constants.interior_modulus * constants.interior_volume / constants.density;
}

/// A cohesive part has tractions in the place of stresses: what acts on stresses and strains has no sense.
void require_plain(const model::Part& part, const model::Material& material) {
  require(!material.rigid, part, "cohesive solids cannot be rigid");
  require(!material.erosion && !material.damage && material.least_step == 0, part,
          "cohesive solids fail by their own material alone, not by *MAT_ADD_EROSION or damage");
  require(!part.damping, part, "cohesive solids take no damping in proportion to stiffness");
  require(!part.interior, part, "cohesive solids have no interior contact");
}

/// With a length and a wave speed of one the step of an element is what it keeps as `step_scale`.
void set_cohesive(const model::Material& material, SolidConstants<double>& constants) {
  const auto& law = std::get<model::Cohesive>(material.law);
  constants.point_place = law.at_corners ? 1 : 1 / std::numbers::sqrt3;
  constants.wave_speed = 1;
}

/// Stands for the limit that prepare_elements() sets when the steps of all elements are known: the block has
/// its room by then.
constexpr double unknown_least_step = std::numeric_limits<double>::min();

void prepare_block(const model::Model& model, const domain::Domain& domain, SolidBlock& block) {
  const model::Part& part = model.parts[block.part];
  const model::Material& material = model.materials[part.material];
  const SolidKind kind = solid_kind(block.formulation);
  const int law = materials::solid_material_kind(material.law);
  require(kind.kind >= 0, part, "its formulation of solids is not computed by any kind in the registry");
  require(law >= 0, part, "its material cannot be used with solids");
  require(model::use_of(material.law).only_cohesive == model::is_cohesive(block.formulation), part,
          "a cohesive formulation of solids and a cohesive material go together, neither without the other");
  if (model::is_cohesive(block.formulation)) require_plain(part, material);
  ElasticConstants elastic = materials::elastic_constants(material);
  const model::EquationOfState* const equation = model::equation_of_state_of(model, part);
  require_equation_of_state(part, material, equation != nullptr);
  const materials::SolidStart start = materials::solid_start(material, equation);
  elastic.youngs_modulus *= start.stiffness_share;
  SolidConstants<double> constants;
  constants.formulation = kind.kind;
  constants.points = kind.points;
  constants.material = law;
  const bool goes_by_run =
      model.control.erodes_short_solids && model.control.minimum_step_factor > 0 && !block.rigid;
  constants.can_fail = materials::solid_can_fail(material) || model::may_erode(material) || goes_by_run;
  constants.density = start.density;
  constants.wave_speed = start.wave_speed;
  const double modulus = start.density * start.wave_speed * start.wave_speed;
  constants.shear_share = std::clamp(2 * elastic.shear_modulus() / modulus, 0.0, 1.0);
  const model::HourglassControl control = model::solid_hourglass_of(model, part);
  constants.bulk_quadratic =
      control.bulk_quadratic > 0 ? control.bulk_quadratic : model.control.bulk_quadratic;
  constants.bulk_linear = std::max(control.bulk_linear > 0 ? control.bulk_linear : model.control.bulk_linear,
                                   start.linear_viscosity);
  if (start.own_viscosity) {
    constants.bulk_quadratic = 0;
    constants.bulk_linear = start.linear_viscosity;
  }
  set_hourglass(control, elastic, constants);
  set_interior(part, constants);
  if (block.formulation != model::SolidFormulation::OnePointHexahedron) constants.exact_volume = true;
  if (model::is_cohesive(block.formulation)) set_cohesive(material, constants);
  block.points = kind.points;
  domain::add_item(block, "stress", "stress", materials::solid_components * block.points);
  constants.history = materials::declare_solid_history(material.law, block);
  block.material_constants = materials::solid_material_constants(material, equation);
  if (equation != nullptr)
    constants.equation_of_state = add_equation(material, *equation, constants.history, block);
  if (start.varies) constants.present_wave_speed = domain::add_item(block, "wave_speed", "length/time", 1);
  constants.own = block.components;
  declare_own_items(constants.can_fail, kind.kept, block);
  block.erosion = material.erosion;
  if (block.erosion) declare_erosion(block);
  if (!block.rigid) block.damage = material.damage;
  declare_damage(block);
  if (!block.rigid) block.least_step = material.least_step;
  if (goes_by_run) block.least_step = std::max(block.least_step, unknown_least_step);
  declare_short_steps(block);
  if (!block.rigid) block.damping = part.damping;
  declare_damping(solid_damping(elastic, kind.averages), materials::solid_components, block);
  block.allocate(domain.execution.precision);
  block.element_constants = to_numbers(constants);
  if (kind.averages) prepare_average(block);
}

struct SolidMass {
  double mass = 0;   ///< [mass]
  double added = 0;  ///< by mass scaling [mass]
};

/// The volumes of mass that solids with stresses at time zero have; empty if none has, zero where there is
/// none.
std::vector<double> initial_volumes(const model::Model& model) {
  std::vector<double> volumes;
  if (!model.solid_stresses.empty()) volumes.resize(model.solids.size(), 0.0);
  for (const model::InitialStress& stress : model.solid_stresses)
    volumes[static_cast<std::size_t>(stress.element)] = stress.volume;
  return volumes;
}

SolidMass prepare_element(const model::Model& model, const domain::Domain& domain, SolidBlock& block,
                          Index place, const std::vector<double>& initial_volume, const LoneElements& lone) {
  const auto constants = from_numbers<SolidConstants<double>>(block.element_constants);
  const Index index = block.element[std::min(place, block.elements - 1)];
  const model::SolidElement& solid = model.solids[index];
  const SolidSize size = solid_size(domain, block, place, constants);
  if (!(size.volume > 0) || !(size.length > 0))
    throw Error(
        "Solid " + std::to_string(solid.id) +
        " has no positive volume: its nodes are not numbered as they should be, or it is inside out.");
  const model::Part& part = model.parts[block.part];
  const model::ConstitutiveLaw& law = model.materials[part.material].law;
  const double beside = lone.factor(domain, block, place);
  const double step = beside * size.length / constants.wave_speed;
  const double factor = block.rigid ? 1 : mass_factor(model.control.mass_scaling_step, step);
  const Index own = constants.own;
  const bool given = !initial_volume.empty() && initial_volume[static_cast<std::size_t>(index)] > 0;
  const double volume = given ? initial_volume[static_cast<std::size_t>(index)] : size.volume;
  block.set_state(place, own + solid_state::reference_volume, volume);
  block.set_state(place, own + solid_state::active, place < block.elements ? 1 : 0);
  block.set_state(place, own + solid_state::step_scale, beside * std::sqrt(factor));
  if (constants.present_wave_speed > 0)
    block.set_state(place, constants.present_wave_speed, constants.wave_speed);
  materials::SolidCorners corners;
  const std::array<Index, 8> node = block.nodes_of(place);
  for (std::size_t k = 0; k < 8; ++k) corners[k] = domain.nodes.position[node[k]];
  materials::prepare_solid_element(law, corners, solid.id, block, constants.history, place);
  set_damage_size(block, place, math::cube_root(volume));
  const double mass = constants.density * volume;
  return {factor * mass, (factor - 1) * mass};
}

}  // namespace

void prepare_solids(const model::Model& model, const LoneElements& lone, domain::Domain& domain) {
  const std::vector<double> volumes = initial_volumes(model);
  for (SolidBlock& block : domain.solids) {
    prepare_block(model, domain, block);
    if (model::is_cohesive(block.formulation)) {
      prepare_cohesives(model, domain, block);
      continue;
    }
    const bool scales = scales_mass(model, domain, block);
    for (Index place = 0; place < block.groups() * lanes; ++place) {
      const SolidMass solid = prepare_element(model, domain, block, place, volumes, lone);
      if (place >= block.elements) continue;
      for (Index corner = 0; corner < block.corners; ++corner)
        add_mass(domain, block.part, block.node_of(place, corner), solid.mass * block.mass_share(corner));
      domain.added_mass += solid.added;
      if (scales) block.scaled.push_back({solid.mass, 0});
    }
  }
}

}  // namespace crumple::elements
