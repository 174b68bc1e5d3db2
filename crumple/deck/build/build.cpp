// SPDX-License-Identifier: BSD-3-Clause
#include "deck/build/build.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace crumple::deck {

namespace {

struct ItemWords {
  std::string_view name;
  std::string_view keyword;        ///< what defines it
  std::string_view family;         ///< beginning of the keywords, supported or not, that define it
  std::string_view second_family;  ///< another such beginning; may be empty
};

const ItemWords& words(Item item) {
  static constexpr ItemWords table[] = {
      {"node", "*NODE", "*NODE_", ""},
      {"shell", "*ELEMENT_SHELL", "*ELEMENT_SHELL_", ""},
      {"mass element", "*ELEMENT_MASS", "*ELEMENT_MASS_", ""},
      {"part", "*PART", "*PART_", ""},
      {"section", "*SECTION_SHELL or *SECTION_SOLID", "*SECTION_", ""},
      {"material", "*MAT_ELASTIC or another *MAT", "*MAT_", ""},
      {"hourglass control", "*HOURGLASS", "*HOURGLASS_", ""},
      {"curve", "*DEFINE_CURVE", "*DEFINE_CURVE_", "*DEFINE_TABLE"},
      {"node set", "*SET_NODE_LIST", "*SET_NODE_", ""},
      {"part set", "*SET_PART_LIST", "*SET_PART_", ""},
      {"rigid wall", "*RIGIDWALL_PLANAR_ID", "*RIGIDWALL_", ""},
      {"contact", "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID", "*CONTACT_", ""},
      {"table", "*DEFINE_TABLE", "*DEFINE_TABLE_", ""},
      {"solid", "*ELEMENT_SOLID", "*ELEMENT_SOLID_", ""},
      {"shell set", "*SET_SHELL_LIST", "*SET_SHELL_", ""},
      {"solid set", "*SET_SOLID_LIST", "*SET_SOLID_", ""},
      {"segment set", "*SET_SEGMENT", "*SET_SEGMENT_", ""},
      {"box", "*DEFINE_BOX", "*DEFINE_BOX_", ""},
      {"rigid body", "a part of *MAT_RIGID or *CONSTRAINED_NODAL_RIGID_BODY", "*CONSTRAINED_NODAL_RIGID_",
       ""},
      {"beam", "*ELEMENT_BEAM", "*ELEMENT_BEAM_", ""},
      {"discrete element", "*ELEMENT_DISCRETE", "*ELEMENT_DISCRETE_", ""},
      {"orientation", "*DEFINE_SD_ORIENTATION", "*DEFINE_SD_ORIENTATION_", ""},
      {"equation of state", "*EOS_GRUNEISEN or *EOS_LINEAR_POLYNOMIAL", "*EOS_", ""},
      {"coordinate system", "*DEFINE_COORDINATE_SYSTEM, _NODES or _VECTOR", "*DEFINE_COORDINATE_", ""},
      {"beam set", "*SET_BEAM", "*SET_BEAM_", ""},
      {"discrete set", "*SET_DISCRETE", "*SET_DISCRETE_", ""},
      {"cross-section", "*DATABASE_CROSS_SECTION_PLANE_ID", "*DATABASE_CROSS_SECTION_", ""},
      {"transformation", "*DEFINE_TRANSFORMATION", "*DEFINE_TRANSFORM", ""},
      {"joint", "*CONSTRAINED_JOINT_REVOLUTE_ID or another joint", "*CONSTRAINED_JOINT_", ""},
      {"airbag", "*AIRBAG_SIMPLE_AIRBAG_MODEL_ID", "*AIRBAG_", ""},
      {"vector", "*DEFINE_VECTOR", "*DEFINE_VECTOR_", ""},
      {"integration rule", "*INTEGRATION_SHELL", "*INTEGRATION_", ""},
      {"blast", "*LOAD_BLAST_ENHANCED", "*LOAD_BLAST_ENHANCED_", ""},
      {"friction table", "*DEFINE_FRICTION", "*DEFINE_FRICTION_", ""},
  };
  return table[static_cast<std::size_t>(item)];
}

}  // namespace

Build::Build(const RawDeck& raw, Report& to) : deck(raw), report(to) {
  for (const UnsupportedDefinition& definition : raw.unsupported)
    unsupported_.emplace(definition.id, &definition);
}

void Build::enter(Item item, const Reference& reference, std::size_t index) {
  Entries& entries = entries_[static_cast<std::size_t>(item)];
  const Index here = static_cast<Index>(index);
  const Index before = entries.table.insert(reference.id, here);
  if (static_cast<std::size_t>(here) >= entries.first.size())
    entries.first.resize(static_cast<std::size_t>(here) + 1);
  entries.first[static_cast<std::size_t>(here)] = reference.where;
  if (before == no_index) return;
  report_twice(item, reference, entries.first[static_cast<std::size_t>(before)]);
}

/// Names of one kind are entered keyword by keyword: the one that stands further down is the second.
void Build::report_twice(Item item, const Reference& reference, const Where& other) {
  const bool is_first = reference.where.file == other.file && reference.where.line < other.line;
  const Where& first = is_first ? reference.where : other;
  const Where& second = is_first ? other : reference.where;
  report.field_error(second, {reference.field, std::to_string(reference.id), "an id that is not used yet",
                              fmt::format("{} {} is already defined at {}; remove one or give it another id",
                                          words(item).name, reference.id, report.place(first)),
                              "duplicate"});
}

Index Build::find_quietly(Item item, UserId id) const {
  return entries_[static_cast<std::size_t>(item)].table.find(id);
}

const UnsupportedDefinition* Build::unsupported_definition(Item item, UserId id) const {
  const ItemWords& word = words(item);
  const auto [first, last] = unsupported_.equal_range(id);
  for (auto entry = first; entry != last; ++entry) {
    const std::string_view keyword = entry->second->where.keyword;
    const bool fits = keyword.starts_with(word.family) ||
                      (!word.second_family.empty() && keyword.starts_with(word.second_family));
    if (fits) return entry->second;
  }
  return nullptr;
}

bool Build::is_definition_faulty(Item item) const {
  const std::string_view family = words(item).family;
  return std::any_of(deck.faulty.begin(), deck.faulty.end(), [&](std::string_view keyword) {
    return keyword.starts_with(family) || keyword == family.substr(0, family.size() - 1);
  });
}

/// True of an element that the deck has and the model has not: what is wrong with it, or with its part, has
/// been said.
bool Build::is_left_out(Item item, UserId id) {
  const auto [entry, is_new] = element_ids_.try_emplace(item);
  std::vector<UserId>& ids = entry->second;
  if (is_new) {
    const auto take = [&](const auto& elements) {
      for (const auto& element : elements) ids.push_back(element.id);
    };
    if (item == Item::Shell) take(deck.shells);
    if (item == Item::Solid) take(deck.solids);
    if (item == Item::Beam) take(deck.beams);
    if (item == Item::Discrete) take(deck.discretes);
    std::sort(ids.begin(), ids.end());
  }
  return std::binary_search(ids.begin(), ids.end(), id);
}

Index Build::find(Item item, const Reference& reference) {
  const Index index = find_quietly(item, reference.id);
  if (index != no_index) return index;
  const ItemWords& word = words(item);
  FieldFault fault{
      reference.field,
      std::to_string(reference.id),
      fmt::format("the id of {} {}",
                  std::string_view("hoei").find(word.name.front()) != std::string_view::npos ? "an" : "a",
                  word.name),
      {},
      "reference"};
  if (item == Item::Part && is_dropped(reference.id)) {
    // As an error it would only repeat the one at the part.
    fault.hint = fmt::format("part {} is left out, see the message there", reference.id);
    if (report.allow_unsupported()) report.field_warning(reference.where, fault);
  } else if (is_left_out(item, reference.id)) {
    fault.hint =
        fmt::format("{} {} is left out, see the message at it or at its part", word.name, reference.id);
    if (report.allow_unsupported())
      report.field_warning(reference.where, fault);
    else if (!report.has_errors())
      report.field_error(reference.where, fault);
  } else if (const UnsupportedDefinition* definition = unsupported_definition(item, reference.id)) {
    fault.hint = fmt::format("{} {} is defined by {} at {}, which is not supported", word.name, reference.id,
                             definition->where.keyword, report.place(definition->where));
    report.field_unsupported(reference.where, fault);
  } else if (!is_definition_faulty(item)) {
    fault.hint = fmt::format("the deck has no {} {}; add it with {}", word.name, reference.id, word.keyword);
    report.field_error(reference.where, fault);
  }
  return no_index;
}

model::Model build_model(const RawDeck& deck, const ReadOptions& options, Report& report) {
  Build build(deck, report);
  build.model.title = deck.title;
  build.model.control = deck.control;
  build.model.output = deck.output;
  build.model.search = deck.search;
  build.model.run = deck.run;
  build_properties(build, options);
  check_materials(build);
  build_nodes(build);
  move_nodes(build);
  enter_coordinate_systems(build);
  build_parts(build);
  build_shells(build);
  build_solids(build);
  settle_defaults(build, options.ls_dyna_defaults);
  settle_distorted_shells(build);
  check_shell_options(build);
  build_beams(build);
  build_discretes(build);
  check_empty_parts(build);
  check_coincident_elements(build);
  build_sets(build);
  build_solid_welds(build);
  build_nominal_honeycombs(build);
  make_parts_rigid(build);
  build_interiors(build);
  build_masses(build);
  build_part_masses(build);
  build_rigid_bodies(build);
  build_connections(build);
  build_embedded_beams(build);
  build_joints(build);
  build_joint_stiffnesses(build);
  build_fixed_nodes(build);
  build_velocities(build);
  build_initial_stresses(build);
  build_loads(build);
  build_viscous_boundaries(build);
  build_airbags(build);
  build_motions(build);
  build_stoppers(build);
  build_inertia_fields(build);
  build_walls(build);
  enter_friction_tables(build);
  build_contacts(build, options.automatic_contact);
  build_tied_contacts(build);
  check_contact_of_null_shells(build);
  build_terminations(build);
  const double end_time = options.end_time.value_or(build.model.control.end_time);
  build_relaxation(build, end_time);
  check_short_curves(build, end_time);
  finish_time_curves(build);
  check_idle_loads(build);
  build_output(build);
  build_cross_sections(build);
  return std::move(build.model);
}

}  // namespace crumple::deck
