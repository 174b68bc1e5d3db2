// SPDX-License-Identifier: BSD-3-Clause
// Layers of shells: *PART_COMPOSITE, *ELEMENT_SHELL_COMPOSITE, and what *SECTION_SHELL asks for.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

/// As many points through the thickness as shells have (materials/common/shell_material.hpp).
constexpr std::size_t most_layers = 20;

/// Why layers cannot be of a material; empty if they can.
std::string objection(const model::Material& material) {
  const model::LawUse use = model::use_of(material.law);
  if (!use.shells) return "it is not there for shells";
  if (use.only_membranes) return "it is there for membranes of one material; BETA turns its yarns";
  if (material.rigid) return "it is rigid";
  if (const auto* law = std::get_if<model::PiecewiseLinearPlasticity>(&material.law))
    if (law->failed_points > 0 || law->failed_share > 0)
      return "its NUMINT counts all points of a shell, which are of one material then";
  return {};
}

/// The material of a layer by its id; no_index, with a message, if there is none that can be.
Index find_layer_material(Build& build, const Reference& reference) {
  const Index index = build.find(Item::Material, reference);
  if (index == no_index) return no_index;
  const bool is_spring = static_cast<std::size_t>(index) >= build.deck.materials.size();
  const std::string why = is_spring ? "springs and dampers have a material of their own"
                                    : objection(build.model.materials[static_cast<std::size_t>(index)]);
  if (why.empty()) return index;
  build.report.field_unsupported(reference.where,
                                 {reference.field, std::to_string(reference.id),
                                  "a material of deformable layers of shells", why, "layer"});
  return no_index;
}

/// Layers from the lowest up by their thicknesses, one point in the middle of each.
bool stack(Build& build, const std::vector<RawLayer>& raws, model::Layup& layup) {
  double total = 0;
  for (const RawLayer& raw : raws) total += raw.thickness;
  double below = 0;
  bool complete = true;
  for (const RawLayer& raw : raws) {
    model::ShellLayer layer;
    layer.material = find_layer_material(build, {raw.material, raw.field, raw.where});
    layer.share = raw.thickness / total;
    layer.place = (2 * below + raw.thickness) / total - 1;
    layer.angle = raw.angle;
    below += raw.thickness;
    complete = complete && layer.material != no_index;
    layup.layers.push_back(layer);
  }
  return complete;
}

/// Criteria of *MAT_ADD_EROSION hold for a whole element, and so does the failure by damage.
bool take_erosion(Build& build, const Where& where, const model::Layup& layup, model::Material& standing_in) {
  const model::Model& model = build.model;
  const Index first = layup.layers.front().material;
  bool one = true;
  bool erodes = false;
  for (const model::ShellLayer& layer : layup.layers) {
    one = one && layer.material == first;
    erodes =
        erodes || model::may_erode(model.materials[layer.material]) || model.materials[layer.material].damage;
  }
  if (!erodes) return true;
  if (one) {
    standing_in.erosion = model.materials[first].erosion;
    standing_in.damage = model.materials[first].damage;
    standing_in.least_step = model.materials[first].least_step;
    return true;
  }
  build.report.unsupported(
      where, "erosion",
      "*MAT_ADD_EROSION, *MAT_ADD_DAMAGE_GISSMO and TDEL are there for layers that are all of "
      "one material; take the "
      "failure of the laws themselves");
  return false;
}

/// Adds a layup with the material that stands in for it; no_index, with a message, if it cannot be.
Index add_layup(Build& build, const Where& where, model::Layup layup) {
  model::Model& model = build.model;
  if (layup.layers.size() > most_layers) {
    build.report.unsupported(
        where, "layers",
        fmt::format("{} layers are too many, {} are possible: join neighbours of the same material and angle",
                    layup.layers.size(), most_layers));
    return no_index;
  }
  model::Material standing_in = model::layup_material(model, layup);
  if (!take_erosion(build, where, layup, standing_in)) return no_index;
  layup.material = static_cast<Index>(model.materials.size());
  model.materials.push_back(std::move(standing_in));
  model.layups.push_back(std::move(layup));
  return static_cast<Index>(model.layups.size()) - 1;
}

/// The part's layup, and the material that stands in for it as the part's.
bool give_layup(Build& build, const Where& where, model::Layup layup, model::Part& part) {
  part.layup = add_layup(build, where, std::move(layup));
  if (part.layup == no_index) return false;
  model::Material& material = build.model.materials.back();
  material.id = part.id;
  material.title = part.title;
  part.material = build.model.layups.back().material;
  return true;
}

/// The material of a part that a rule names; the part may have no elements.
Index material_of_part(Build& build, const RawIntegrationPoint& point) {
  for (const RawPart& raw : build.deck.parts)
    if (raw.id == point.part && raw.layers.empty())
      return find_layer_material(build, {raw.material, "MID", raw.where});
  build.report.field_error(point.where,
                           {"PID", std::to_string(point.part), "the id of a part with one material",
                            "its material is that of the point; the part may have no elements", "reference"});
  return no_index;
}

/// The points of *INTEGRATION_SHELL.
bool take_points(Build& build, const RawIntegrationRule& rule, Index own, model::Layup& layup) {
  double sum = 0;
  for (const RawIntegrationPoint& point : rule.points) sum += point.share;
  constexpr double tolerance = 0.01;
  if (std::fabs(sum - 1) > tolerance) {
    build.report.error(rule.where, "weights",
                       fmt::format("the weights WF sum to {:.6g}, expected 1: each is the share that the "
                                   "point stands for in the thickness",
                                   sum));
    return false;
  }
  bool complete = true;
  for (const RawIntegrationPoint& point : rule.points) {
    model::ShellLayer layer;
    layer.material = point.part == 0 ? own : material_of_part(build, point);
    layer.place = point.place;
    layer.share = point.share / sum;
    complete = complete && layer.material != no_index;
    layup.layers.push_back(layer);
  }
  return complete;
}

void take_angles(const RawSection& section, model::Layup& layup) {
  for (std::size_t i = 0; i < std::min(section.angles.size(), layup.layers.size()); ++i)
    layup.layers[i].angle = section.angles[i];
}

}  // namespace

bool build_part_layup(Build& build, const RawPart& raw, model::Part& part) {
  if (part.section == no_index) return true;
  model::Layup layup;
  if (!raw.layers.empty())
    return stack(build, raw.layers, layup) && give_layup(build, raw.where, std::move(layup), part);
  const RawSection& section = build.deck.sections[static_cast<std::size_t>(part.section)];
  const model::Material& material = build.model.materials[static_cast<std::size_t>(part.material)];
  const bool is_layered = section.integration_rule != 0 || !section.angles.empty();
  if (!is_layered || material.rigid) return true;
  if (const std::string why = objection(material); !why.empty()) {
    build.report.field_unsupported(raw.where, {"MID", std::to_string(raw.material),
                                               "a material of deformable layers of shells", why, "layer"});
    return false;
  }
  if (section.integration_rule == 0) {
    const auto points = static_cast<std::size_t>(section.section.thickness_points);
    layup.follows_rule = true;
    layup.layers.assign(points, {.material = part.material, .share = 1.0 / static_cast<double>(points)});
  } else {
    const Index rule =
        build.find(Item::IntegrationRule, {section.integration_rule, "QR", section.rule_where});
    if (rule == no_index) return false;
    const RawIntegrationRule& points = build.deck.integration_rules[static_cast<std::size_t>(rule)];
    layup.unfailing_layers_hold = points.unfailing_layers_hold;
    if (!take_points(build, points, part.material, layup)) return false;
    if (!section.angles.empty() && section.angles.size() < layup.layers.size()) {
      build.report.error(section.rule_where, "angles",
                         fmt::format("there are {} angles for the {} points of rule {}; NIP says how many "
                                     "angles are read",
                                     section.angles.size(), layup.layers.size(), section.integration_rule));
      return false;
    }
  }
  take_angles(section, layup);
  return give_layup(build, raw.where, std::move(layup), part);
}

bool build_element_layup(Build& build, const RawShell& raw, model::ShellElement& shell) {
  model::Model& model = build.model;
  if (model::is_rigid(model, model.parts[static_cast<std::size_t>(shell.part)])) return true;
  model::Layup layup;
  if (!stack(build, build.deck.element_layers[raw.layers - 1], layup)) return false;
  shell.layer_angles = static_cast<Index>(model.layer_angles.size());
  std::vector<double> key;
  for (model::ShellLayer& layer : layup.layers) {
    key.push_back(layer.material);
    key.push_back(layer.share);
    model.layer_angles.push_back(layer.angle);
    layer.angle = 0;
  }
  const auto found = build.layups.find(key);
  if (found != build.layups.end()) {
    shell.layup = found->second;
    return true;
  }
  shell.layup = add_layup(build, raw.where, std::move(layup));
  if (shell.layup == no_index) return false;
  model::Material& material = model.materials.back();
  material.id = model.parts[static_cast<std::size_t>(shell.part)].id;
  build.layups.emplace(std::move(key), shell.layup);
  return true;
}

}  // namespace crumple::deck
