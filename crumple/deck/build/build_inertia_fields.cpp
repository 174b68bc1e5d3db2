// SPDX-License-Identifier: BSD-3-Clause
// Forces of inertia, and damping.
#include <fmt/format.h>

#include <algorithm>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

/// The parts that *LOAD_BODY_PARTS names, ascending; absent without that keyword.
std::optional<std::vector<Index>> loaded_parts(Build& build) {
  if (build.deck.body_load_parts.empty()) return std::nullopt;
  std::vector<Index> all;
  for (const RawBodyLoadParts& raw : build.deck.body_load_parts) {
    const std::vector<Index> parts = find_parts(build, true, {raw.part_set, "PSID", raw.where});
    all.insert(all.end(), parts.begin(), parts.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Adds a load of the run, and to a relaxation by its curve for that (LCIDDR), or by its own if SIDR says so.
template <class Load>
void add_to_phases(const Load& load, Index relaxation_curve, Build& build,
                   std::vector<Load> model::Model::*run,
                   std::vector<Load> model::DynamicRelaxation::*relaxing) {
  (build.model.*run).push_back(load);
  if (relaxation_curve == no_index) {
    if (phase_of_load(build, load.curve) == RawCurve::Phase::Run) return;
    relaxation_curve = load.curve;
  }
  (build.relaxation.*relaxing).push_back(load);
  (build.relaxation.*relaxing).back().curve = relaxation_curve;
}

Index relaxation_curve_of(UserId curve, std::string_view field, const Where& where, Build& build) {
  return curve == 0 ? no_index : build.find(Item::Curve, {curve, field, where});
}

/// A load along an axis of all the model has a form of its own.
void build_body_load(const RawBodyLoad& raw, const std::optional<std::vector<Index>>& parts, Build& build) {
  model::BodyLoad load = raw.load;
  load.curve = build.find(Item::Curve, {raw.curve, "LCID", raw.where});
  if (load.curve == no_index) return;
  const Index relaxing = relaxation_curve_of(raw.relaxation_curve, "LCIDDR", raw.where, build);
  if (!parts && raw.system == 0) {
    add_to_phases(load, relaxing, build, &model::Model::body_loads, &model::DynamicRelaxation::body_loads);
    return;
  }
  Vector along{};
  along[static_cast<std::size_t>(load.axis)] = load.scale;
  const auto acceleration = turned(build, along, raw.system, "CID", raw.where);
  if (!acceleration) return;
  model::InertiaField field;
  field.curve = load.curve;
  field.acceleration = *acceleration;
  field.of_all = !parts;
  if (parts) field.parts = *parts;
  if (field.of_all || !field.parts.empty())
    add_to_phases(field, relaxing, build, &model::Model::inertia_fields,
                  &model::DynamicRelaxation::inertia_fields);
}

std::vector<Index> nodes_in_range(const RawInertiaField& raw, Build& build) {
  std::vector<Index> found;
  const UserId last = std::max(raw.target, raw.last);
  for (std::size_t node = 0; node < build.model.nodes.id.size(); ++node)
    if (build.model.nodes.id[node] >= raw.target && build.model.nodes.id[node] <= last)
      found.push_back(static_cast<Index>(node));
  if (found.empty())
    build.report.field_error(raw.where, {"N1", std::to_string(raw.target), "the first of some nodes",
                                         "there is no node from N1 to N2", "reference"});
  return found;
}

/// Chooses the masses of a load; false, with a message, if there are none.
bool choose_masses(const RawInertiaField& raw, const std::optional<std::vector<Index>>& parts, Build& build,
                   model::InertiaField& field) {
  using On = RawInertiaField::On;
  field.of_all = raw.on == On::All && !parts;
  if (field.of_all) return true;
  if (raw.on == On::All) {
    field.parts = *parts;
  } else if (raw.on == On::Part || raw.on == On::PartSet) {
    const bool is_set = raw.on == On::PartSet;
    field.parts = find_parts(build, is_set, {raw.target, is_set ? "PSID" : "PID", raw.where});
  } else if (raw.on == On::NodeRange) {
    field.nodes = nodes_in_range(raw, build);
  } else if (const auto* nodes = set_nodes(build, {raw.target, "NSID", raw.where})) {
    field.nodes = *nodes;
    std::sort(field.nodes.begin(), field.nodes.end());
    field.nodes.erase(std::unique(field.nodes.begin(), field.nodes.end()), field.nodes.end());
  }
  return !field.parts.empty() || !field.nodes.empty();
}

/// The curve of a field, or one that is always 1 where it has none (*LOAD_GRAVITY_PART).
Index curve_of(const RawInertiaField& raw, Build& build) {
  if (raw.curve != 0) return build.find(Item::Curve, {raw.curve, "LCID", raw.where});
  model::Curve steady;
  steady.abscissa = {0, 1e30};
  steady.ordinate = {1, 1};
  build.model.curves.push_back(std::move(steady));
  return static_cast<Index>(build.model.curves.size() - 1);
}

void build_inertia_field(const RawInertiaField& raw, const std::optional<std::vector<Index>>& parts,
                         Build& build) {
  model::InertiaField field = raw.field;
  field.curve = curve_of(raw, build);
  const auto acceleration = turned(build, raw.field.acceleration, raw.system, "CID", raw.where);
  const auto spin = turned(build, raw.field.spin, raw.system, "CID", raw.where);
  if (!choose_masses(raw, parts, build, field) || field.curve == no_index || !acceleration || !spin) return;
  field.acceleration = *acceleration;
  field.spin = *spin;
  const Index relaxing = relaxation_curve_of(raw.relaxation_curve, "LCIDDR", raw.where, build);
  add_to_phases(field, relaxing, build, &model::Model::inertia_fields,
                &model::DynamicRelaxation::inertia_fields);
}

void build_mass_damping(Build& build) {
  if (build.deck.mass_dampings.empty()) return;
  if (build.deck.mass_dampings.size() > 1)
    build.report.error(build.deck.mass_dampings[1].where, "damping",
                       "*DAMPING_GLOBAL stands twice; the damping of the whole model is given once");
  const RawMassDamping& raw = build.deck.mass_dampings.front();
  model::MassDamping damping = raw.damping;
  if (raw.curve != 0) damping.curve = build.find(Item::Curve, {raw.curve, "LCID", raw.where});
  if (damping.curve != no_index || damping.constant > 0) build.model.mass_damping = damping;
}

void build_part_damping(const RawMassDamping& raw, Build& build) {
  model::MassDamping damping = raw.damping;
  damping.curve = build.find(Item::Curve, {raw.curve, "LCID", raw.where});
  damping.parts = find_parts(build, raw.is_set, {raw.target, raw.is_set ? "PSID" : "PID", raw.where});
  if (damping.curve != no_index && !damping.parts.empty()) build.model.part_dampings.push_back(damping);
}

void build_stiffness_damping(const RawStiffnessDamping& raw, Build& build) {
  for (const Index index :
       find_parts(build, raw.is_set, {raw.target, raw.is_set ? "PSID" : "PID", raw.where})) {
    model::Part& part = build.model.parts[static_cast<std::size_t>(index)];
    if (part.damping)
      build.report.error(raw.where, "damping",
                         fmt::format("part {} has damping in proportion to stiffness already; it is given "
                                     "once",
                                     part.id));
    if (model::kind_of(part) == model::ElementKind::Discrete)
      build.report.warning(
          raw.where, "discrete damping",
          fmt::format("part {} has springs or dampers: damping in proportion to stiffness does nothing there",
                      part.id));
    else
      part.damping = raw.damping;
  }
}

void build_relative_damping(const RawRelativeDamping& raw, Build& build) {
  model::RelativeDamping damping = raw.damping;
  if (raw.curve != 0) damping.curve = build.find(Item::Curve, {raw.curve, "LCID", raw.where});
  damping.body = build.find(Item::RigidBody, {raw.body, "PIDRB", raw.where});
  damping.parts = find_parts(build, true, {raw.parts, "PSID", raw.where});
  const bool acts = damping.frequency > 0 && (damping.curve != no_index || damping.share > 0);
  if (acts && damping.body != no_index && !damping.parts.empty())
    build.model.relative_dampings.push_back(damping);
}

}  // namespace

std::vector<Index> find_parts(Build& build, bool is_set, const Reference& reference) {
  const Index index = build.find(is_set ? Item::PartSet : Item::Part, reference);
  if (index == no_index) return {};
  return is_set ? build.model.part_sets[static_cast<std::size_t>(index)].parts : std::vector<Index>{index};
}

void build_inertia_fields(Build& build) {
  const auto parts = loaded_parts(build);
  for (const RawBodyLoad& raw : build.deck.body_loads) build_body_load(raw, parts, build);
  for (const RawInertiaField& raw : build.deck.inertia_fields) build_inertia_field(raw, parts, build);
  build_mass_damping(build);
  for (const RawMassDamping& raw : build.deck.part_dampings) build_part_damping(raw, build);
  for (const RawStiffnessDamping& raw : build.deck.stiffness_dampings) build_stiffness_damping(raw, build);
  for (const RawRelativeDamping& raw : build.deck.relative_dampings) build_relative_damping(raw, build);
}

}  // namespace crumple::deck
