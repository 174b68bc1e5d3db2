// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "base/error.hpp"
#include "elements/common/damage_growth.hpp"
#include "elements/common/erosion_check.hpp"
#include "elements/common/short_steps.hpp"
#include "elements/common/stiffness_damping.hpp"
#include "elements/lone_elements.hpp"
#include "elements/prepare.hpp"
#include "elements/registry.hpp"
#include "elements/shell/shell_geometry.hpp"
#include "elements/shell/shell_setup.hpp"
#include "elements/shell/shell_task.hpp"
#include "elements/shell/triangle_inertia.hpp"
#include "math/quadrature.hpp"

namespace crumple::elements {
namespace {

using domain::ShellBlock;
using materials::ElasticConstants;

const model::ShellSection& section_of(const model::Model& model, const ShellBlock& block) {
  return model.shell_sections[model.parts[block.part].section];
}

/// Places and weights of the points of the section's rule.
math::Quadrature rule_of(const model::Part& part, const model::ShellSection& section, int points) {
  using model::ThicknessRule;
  const bool ends = section.thickness_rule != ThicknessRule::Gauss;
  const int most = section.thickness_rule == ThicknessRule::Trapezoid ? materials::max_points : 10;
  require(points >= (ends ? 2 : 1) && points <= most, part,
          std::to_string(points) +
              " integration points through the thickness are not possible; Gauss takes " +
              "1 to 10, Lobatto 2 to 10, the trapezoidal rule 2 to " + std::to_string(materials::max_points));
  return section.thickness_rule == ThicknessRule::Gauss     ? math::gauss_rule(points)
         : section.thickness_rule == ThicknessRule::Lobatto ? math::lobatto_rule(points)
                                                            : math::trapezoid_rule(points);
}

/// The material of the elements of a block; of layered ones that which stands in for their layers.
const model::Material& material_of_block(const model::Model& model, const ShellBlock& block) {
  return model::material_of(model, model.shells[block.element.front()]);
}

void set_thickness_rule(const model::Model& model, ShellConstants<double>& constants, ShellBlock& block) {
  const model::Part& part = model.parts[block.part];
  const model::ShellSection& section = section_of(model, block);
  const int points = block.thickness_points;
  if (block.layup == no_index || model.layups[block.layup].follows_rule) {
    const math::Quadrature rule = rule_of(part, section, points);
    block.point_place.assign(rule.point.begin(), rule.point.end());
    block.point_weight.assign(rule.weight.begin(), rule.weight.end());
  } else {
    require(points <= materials::max_points, part,
            std::to_string(points) + " layers are too many; " + std::to_string(materials::max_points) +
                " are possible");
    for (const model::ShellLayer& layer : model.layups[block.layup].layers) {
      block.point_place.push_back(layer.place);
      block.point_weight.push_back(layer.share);
    }
  }
  constants.points = points;
  // Places count from the surface of the nodes.
  for (std::size_t i = 0; i < block.point_place.size(); ++i)
    constants.place[i] = block.point_place[i] - section.node_place;
  std::copy(block.point_weight.begin(), block.point_weight.end(), constants.weight);
}

/// The stiffness form with what the material resists the patterns of a square with: E t / 12 in the membrane,
/// where the form has QM E t / 8, and so on (docs/theory/hourglass.md).
model::HourglassControl with_stiffness_of_material(model::HourglassControl control) {
  control.coefficient = control.warping = 2.0 / 3;
  control.bending = 4.0 / 3;
  return control;
}

/// The factors that do not change during the run, see hourglass.hpp.
void set_hourglass(const model::HourglassControl& asked, const ElasticConstants& elastic, double shear_factor,
                   ShellConstants<double>& constants) {
  const model::HourglassControl control =
      asked.form == model::HourglassForm::Material ? with_stiffness_of_material(asked) : asked;
  constants.viscous = control.form == model::HourglassForm::Viscous;
  if (constants.viscous) {
    const double impedance = 0.25 * elastic.density * elastic.plate_wave_speed();
    constants.hourglass_membrane = control.coefficient * impedance;
    constants.hourglass_warping = control.warping * impedance;
    constants.hourglass_bending = control.bending * impedance / 12;
  } else {
    constants.hourglass_membrane = control.coefficient * elastic.youngs_modulus / 16;
    constants.hourglass_warping = control.warping * shear_factor * elastic.shear_modulus() / 24;
    constants.hourglass_bending = control.bending * elastic.youngs_modulus / 384;
  }
}

void declare_own_items(bool can_fail, ShellBlock& block) {
  domain::add_item(block, "thickness", "length", 1);
  domain::add_item(block, "active", "-", 1);
  domain::add_item(block, "frame", "-", 2);
  domain::add_item(block, "step_scale", "-", 1);
  domain::add_item(block, "hourglass", "force, force * length", 5);
  if (can_fail) domain::add_item(block, "energy", "energy", 2);
}

/// Layers of one material whose axes do not differ are one run: laws without axes do not ask for angles.
bool continues(const model::Model& model, const ShellBlock& block, std::size_t layer) {
  const std::vector<model::ShellLayer>& layers = model.layups[block.layup].layers;
  if (layer == 0 || layers[layer].material != layers[layer - 1].material) return false;
  if (!materials::has_axes(model.materials[layers[layer].material].law)) return true;
  const bool own_angles = model.shells[block.element.front()].layer_angles != no_index;
  return !own_angles && layers[layer].angle == layers[layer - 1].angle;
}

/// The items of a law for the points of a run.
void declare_run(const model::Material& material, domain::LayerRun& run, ShellBlock& block) {
  const std::size_t first_item = block.items.size();
  const Index points = block.points;
  block.points = block.plane_points * run.points;
  run.history = materials::declare_history(material.law, block);
  block.points = points;
  for (std::size_t item = first_item; item < block.items.size(); ++item) {
    block.items[item].first_layer = run.first;
    block.items[item].layers = run.points;
    block.items[item].all_layers = block.thickness_points;
  }
}

bool can_fail(const model::Model& model, const ShellBlock& block) {
  if (block.layup == no_index) return materials::can_fail(material_of_block(model, block));
  const std::vector<model::ShellLayer>& layers = model.layups[block.layup].layers;
  return std::any_of(layers.begin(), layers.end(), [&](const model::ShellLayer& layer) {
    return materials::can_fail(model.materials[layer.material]);
  });
}

/// The runs of a layered block with state and numbers of their laws.
void prepare_layers(const model::Model& model, ShellBlock& block) {
  const model::Layup& layup = model.layups[block.layup];
  std::map<Index, Index> constants_of;  // first number by material
  for (std::size_t layer = 0; layer < layup.layers.size(); ++layer) {
    if (continues(model, block, layer)) {
      ++block.runs.back().points;
      continue;
    }
    const Index index = layup.layers[layer].material;
    const model::Material& material = model.materials[index];
    domain::LayerRun run;
    run.law = materials::shell_material_kind(material.law);
    require(run.law >= 0, model.parts[block.part],
            "its layer " + std::to_string(layer + 1) + " has a material that cannot be used with shells");
    run.first = static_cast<Index>(layer);
    run.points = 1;
    run.can_fail = materials::can_fail(material);
    const auto next = static_cast<Index>(block.material_constants.size());
    const auto [entry, is_new] = constants_of.emplace(index, next);
    if (is_new) {
      const std::vector<double> numbers = materials::shell_material_constants(material);
      block.material_constants.insert(block.material_constants.end(), numbers.begin(), numbers.end());
    }
    run.constants = entry->second;
    block.runs.push_back(run);
  }
  for (domain::LayerRun& run : block.runs)
    declare_run(model.materials[layup.layers[static_cast<std::size_t>(run.first)].material], run, block);
  block.layers_hold =
      layup.unfailing_layers_hold && std::any_of(block.runs.begin(), block.runs.end(),
                                                 [](const domain::LayerRun& run) { return !run.can_fail; });
}

ShellConstants<double> prepare_block(const model::Model& model, const domain::Domain& domain,
                                     ShellBlock& block) {
  const model::Part& part = model.parts[block.part];
  const model::ShellSection& section = section_of(model, block);
  const model::Material& material = material_of_block(model, block);
  const ShellKind kind = shell_kind(block.formulation);
  const int law = materials::shell_material_kind(material.law);
  require(kind.kind >= 0, part, "its shell formulation is not computed by any kind in the registry");
  require(law >= 0, part, "its material cannot be used with shells");

  require(section.shear_factor > 0, part, "the shear factor must be above zero");
  const ElasticConstants elastic = materials::elastic_constants(material);
  ShellConstants<double> constants;
  constants.formulation = kind.kind;
  constants.planes = kind.planes;
  constants.material = law;
  constants.can_fail = can_fail(model, block) || model::may_erode(material);
  constants.thickness_change = model.control.thickness_change;
  constants.shear_root = std::sqrt(section.shear_factor);
  constants.slowness = 1 / elastic.plate_wave_speed();
  constants.poissons_ratio = elastic.poissons_ratio;
  set_thickness_rule(model, constants, block);
  set_hourglass(model::hourglass_of(model, part), elastic, section.shear_factor, constants);
  // Full integration has no membrane mode to control; drilling takes its place
  // (docs/theory/fully_integrated.md).
  if (kind.planes > 1) constants.hourglass_membrane = 0.04 * elastic.youngs_modulus / 12;
  if (!model::is_hourglassing(block.formulation) && model::is_membrane(block.formulation))
    constants.hourglass_membrane = constants.hourglass_warping = 0;

  block.plane_points = kind.planes;
  block.points = kind.planes * block.thickness_points;
  domain::add_item(block, "stress", "stress", materials::components * block.points);
  if (block.layup == no_index || block.rigid)
    constants.history = materials::declare_history(material.law, block);
  else
    prepare_layers(model, block);
  constants.own = block.components;
  declare_own_items(constants.can_fail, block);
  block.erosion = material.erosion;
  if (block.erosion) declare_erosion(block);
  if (!block.rigid) block.damage = material.damage;
  declare_damage(block);
  if (!block.rigid) block.least_step = material.least_step;
  declare_short_steps(block);
  if (!block.rigid) block.damping = part.damping;
  require(!block.damping || block.layup == no_index, part,
          "*DAMPING_PART_STIFFNESS acts on shells of one material, not on layers");
  declare_damping(shell_damping(elastic), materials::components, block);
  block.allocate(domain.execution.precision);
  if (block.runs.empty()) block.material_constants = materials::shell_material_constants(material);
  if (!materials::has_stiffness(material.law))
    constants.hourglass_membrane = constants.hourglass_warping = constants.hourglass_bending = 0;
  block.element_constants = to_numbers(constants);
  return constants;
}

/// Factor on the step of shells that have no stiffness: no other shell's step is longer.
constexpr double no_limit = 1e12;

/// From the first node of the deck to the next that is not the same. The corners of a triangle begin where
/// their last one is repeated.
math::Vec3 first_side(const model::ShellElement& shell, const ShellCorners& corner) {
  const int repeated = model::repeated_entry(shell.node);
  if (repeated < 0) return corner[1] - corner[0];
  const auto at = [&](int entry) { return corner[static_cast<std::size_t>(entry + 6 - repeated) % 4]; };
  return repeated == 0 ? at(2) - at(1) : at(1) - at(0);
}

/// What the material wants to know of an element.
materials::LaminaAxes lamina_axes(const model::ShellElement& shell, const ShellCorners& corner) {
  const math::Vec3 r31 = corner[2] - corner[0];
  const math::Vec3 r42 = corner[3] - corner[1];
  materials::LaminaAxes axes;
  axes.e1 = normalised(r31 - r42);
  axes.e3 = normalised(cross(r31, r42));
  axes.e2 = cross(axes.e3, axes.e1);
  axes.side = first_side(shell, corner);
  axes.angle = shell.material_angle;
  axes.shell = shell.id;
  return axes;
}

struct ShellMass {
  double mass = 0;     ///< [mass]
  double inertia = 0;  ///< per mass, of each node [length^2]
  double added = 0;    ///< by mass scaling [mass]
};

/// Those of a triangle, of which one is there twice.
std::array<math::Vec3, 3> three_corners(const ShellCorners& corner) {
  std::size_t first = 0;
  while (first < 3 && norm(corner[(first + 1) % 4] - corner[first]) > 0) ++first;
  return {corner[(first + 1) % 4], corner[(first + 2) % 4], corner[(first + 3) % 4]};
}

/// Rotary inertia per mass [length^2] that keeps bending and transverse shear from governing the step. One
/// free element of side L has the shear frequency kappa G / rho (4 / L^2 + 1 / inertia), to stay below
/// 4 c^2 / L^2 with the plate wave speed c. The theory manual's A/8 is that for a metal; it is too little for
/// nu = 0, and for triangles, whose L^2 is more than their area. `own` is that of the fibres, t^2 / 12 in a
/// plate: with that alone bending is as fast as stretching. In rectangles the shortest bending has no shear;
/// where an element is skewed, and in triangles, shear comes to it and needs its own part.
double rotary_inertia(const model::Model& model, const ShellBlock& block, double shear_root, double own,
                      const ShellCorners& corner, bool triangle) {
  const ElasticConstants elastic = materials::elastic_constants(material_of_block(model, block));
  const double speed = elastic.plate_wave_speed();
  if (!(speed > 0)) return std::max(own, 0.125 * shell_area(corner));
  const double ratio = shear_root * shear_root * elastic.shear_modulus() / (elastic.density * speed * speed);
  const double area = shell_area(corner);
  const double length = characteristic_length(corner, triangle);
  const double square = std::max(area, length * length);
  const double shear = 0.25 * square * ratio / std::max(1 - ratio, 0.1);
  const math::Vec3 r31 = corner[2] - corner[0];
  const math::Vec3 r42 = corner[3] - corner[1];
  // Area over the product of the lines between the middles of opposite sides: the sine of their angle.
  const double sine = 4 * area / (norm(r31 - r42) * norm(r31 + r42));
  const double skew = triangle ? 1 : std::max(0.0, 1 - sine * sine);
  const double enough = std::max({0.125 * square, shear, own + skew * shear});
  if (!triangle) return enough;
  // Of slender ones the turns of the nodes shear the element by far more than its least height would have it.
  constexpr double usual_share = 0.9;  // of the step that stretching allows, 2 L / c
  const double rate = 2 * speed / (usual_share * length);
  const double shear_speed = shear_root * std::sqrt(elastic.shear_modulus() / elastic.density);
  return std::max(enough, triangle_inertia(three_corners(corner), own, shear_speed, rate * rate));
}

/// Factor on the stable step where the nodes lie off the mid-surface by `offset`: stretching and bending are
/// coupled then. Of the shortest waves, in which neighbouring columns move and turn against each other, the
/// squared frequency over that of stretching alone is the largest eigenvalue of [1, -o/sqrt(I); -o/sqrt(I),
/// (o^2 + t^2/12)/I], I being the rotary inertia per mass.
double coupled_step(double offset, double thickness, double inertia) {
  if (offset == 0) return 1;
  const double bending = (offset * offset + thickness * thickness / 12) / inertia;
  const double half_difference = 0.5 * (1 - bending);
  const double largest =
      0.5 * (1 + bending) + std::sqrt(half_difference * half_difference + offset * offset / inertia);
  return 1 / std::sqrt(largest);
}

/// What the laws keep for each element: axes, those of layers turned by their angles.
void prepare_axes(const model::Model& model, const model::ShellElement& shell,
                  const materials::LaminaAxes& axes, Index history, ShellBlock& block, Index place) {
  if (block.runs.empty()) {
    materials::prepare_element(material_of_block(model, block).law, axes, block, history, place);
    return;
  }
  const std::vector<model::ShellLayer>& layers = model.layups[block.layup].layers;
  for (const domain::LayerRun& run : block.runs) {
    const model::ShellLayer& layer = layers[static_cast<std::size_t>(run.first)];
    materials::LaminaAxes turned = axes;
    turned.layer_angle = shell.layer_angles == no_index
                             ? layer.angle
                             : model.layer_angles[static_cast<std::size_t>(shell.layer_angles + run.first)];
    materials::prepare_element(model.materials[layer.material].law, turned, block, run.history, place);
  }
}

ShellMass prepare_element(const model::Model& model, const domain::Domain& domain, ShellBlock& block,
                          const ShellConstants<double>& constants, const LoneElements& lone, Index place) {
  const Index real = std::min(place, block.elements - 1);
  const model::ShellElement& shell = model.shells[block.element[real]];
  const std::array<Index, 4> node = block.nodes_of(place);
  const ShellCorners corner = corners_of(domain, node);
  const double area = shell_area(corner);
  const bool triangle = is_triangle(node);
  const double length = characteristic_length(corner, triangle);
  if (!(area > 0) || !(length > 0)) throw Error("Shell " + std::to_string(shell.id) + " has no area.");

  const std::array<double, 4> at_nodes = model::shell_thickness(model, shell);
  const double thickness = 0.25 * ((at_nodes[0] + at_nodes[1]) + (at_nodes[2] + at_nodes[3]));
  const model::Material& material = material_of_block(model, block);
  const bool stiff = materials::has_stiffness(material.law);
  const double offset = 0.5 * thickness * section_of(model, block).node_place;
  const double about_nodes = thickness * thickness / 12 + offset * offset;
  // Membranes leave the rotations of their nodes to other elements.
  const bool bends = !model::is_membrane(block.formulation);
  const double inertia =
      bends ? rotary_inertia(model, block, constants.shear_root, about_nodes, corner, triangle) : 0;
  const double coupled =
      lone.factor(domain, block, place) * (bends ? coupled_step(offset, thickness, inertia) : 1);
  const double factor = stiff && !block.rigid ? mass_factor(model.control.mass_scaling_step,
                                                            coupled * length * constants.slowness)
                                              : 1;
  const std::array<double, 2> frame = reference_frame(corner);
  const Index own = constants.own;
  block.set_state(place, own + element_state::thickness, thickness);
  block.set_state(place, own + element_state::active, place < block.elements ? 1 : 0);
  block.set_state(place, own + element_state::frame, frame[0]);
  block.set_state(place, own + element_state::frame + 1, frame[1]);
  block.set_state(place, own + element_state::step_scale,
                  (stiff ? triangle ? 2 : 1 : no_limit) * coupled * std::sqrt(factor));
  prepare_axes(model, shell, lamina_axes(shell, corner), constants.history, block, place);
  set_damage_size(block, place, std::sqrt(area));

  const double mass = material.density * area * thickness;
  return {factor * mass, inertia, (factor - 1) * mass};
}

}  // namespace

void prepare_shells(const model::Model& model, const LoneElements& lone, domain::Domain& domain) {
  domain::NodeFields& nodes = domain.nodes;
  for (ShellBlock& block : domain.shells) {
    const ShellConstants<double> constants = prepare_block(model, domain, block);
    const bool scales = scales_mass(model, domain, block);
    for (Index place = 0; place < block.groups() * lanes; ++place) {
      const ShellMass shell = prepare_element(model, domain, block, constants, lone, place);
      if (place >= block.elements) continue;
      const std::array<Index, 4> node = block.nodes_of(place);
      const std::array<double, 4> share = mass_shares(node);
      for (std::size_t k = 0; k < 4; ++k) {
        add_mass(domain, block.part, node[k], share[k] * shell.mass);
        // A rigid shell turns with its body, whose inertia the masses of the nodes make.
        if (!block.rigid) nodes.inertia[node[k]] += share[k] * shell.mass * shell.inertia;
      }
      domain.added_mass += shell.added;
      if (scales) block.scaled.push_back({shell.mass, shell.mass * shell.inertia});
    }
  }
}

}  // namespace crumple::elements
