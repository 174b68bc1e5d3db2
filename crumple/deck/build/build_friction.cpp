// SPDX-License-Identifier: BSD-3-Clause
// Friction that depends on the parts that touch: FS = -1 and -2 of *CONTACT.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

using model::Friction;
using model::PartFriction;

auto key_of(const Friction& friction) {
  return std::tuple(friction.at_rest, friction.when_sliding, friction.decay, friction.stress);
}

Friction scaled(Friction friction, const RawContact& raw) {
  friction.at_rest *= raw.friction_scale;
  friction.when_sliding *= raw.friction_scale;
  friction.stress *= raw.stress_scale;
  return friction;
}

/// Between two parts of different friction the mean of both; a bound of the stress that only one has is that.
Friction mean_of(const Friction& one, const Friction& other) {
  const auto mean = [](double a, double b) { return 0.5 * (a + b); };
  return {mean(one.at_rest, other.at_rest), mean(one.when_sliding, other.when_sliding),
          mean(one.decay, other.decay),
          one.stress > 0 && other.stress > 0 ? mean(one.stress, other.stress)
                                             : std::max(one.stress, other.stress)};
}

/// The parts whose surface takes part in the contact.
std::vector<char> parts_in(const model::Model& model, const model::Contact& contact) {
  std::vector<char> found(model.parts.size(), 0);
  for (const model::ContactSide& side : contact.side) {
    for (const Index part : side.parts) found[static_cast<std::size_t>(part)] = 1;
    for (const Index shell : side.shells)
      found[static_cast<std::size_t>(model.shells[static_cast<std::size_t>(shell)].part)] = 1;
    if (!side.segments.empty() || !side.nodes.empty()) std::fill(found.begin(), found.end(), 1);
  }
  return found;
}

/// FS = -1: parts without *PART_CONTACT have none.
PartFriction friction_of_parts(Build& build, const RawContact& raw, const model::Contact& contact) {
  const std::vector<char> takes_part = parts_in(build.model, contact);
  PartFriction found;
  std::map<decltype(key_of(Friction())), Index> groups;
  std::vector<Friction> of_group;
  found.group.assign(build.model.parts.size(), 0);
  bool any = false;
  std::vector<char> used;
  for (const RawPart& part : build.deck.parts) {
    const Index index = build.find_quietly(Item::Part, part.id);
    if (index == no_index) continue;
    const Friction own = part.friction ? scaled(*part.friction, raw) : Friction{};
    const auto [entry, is_new] = groups.try_emplace(key_of(own), static_cast<Index>(of_group.size()));
    if (is_new) {
      of_group.push_back(own);
      used.push_back(0);
    }
    found.group[static_cast<std::size_t>(index)] = entry->second;
    if (takes_part[static_cast<std::size_t>(index)] == 0) continue;
    any = any || part.friction.has_value();
    used[static_cast<std::size_t>(entry->second)] = 1;
  }
  if (!any)
    build.report.field_error(raw.friction_where, {"FS", "-1", "a part with *PART_CONTACT in the contact",
                                                  "none of its parts has friction of its own", "friction"});
  else if (std::count(used.begin(), used.end(), 1) > 1)
    build.report.field_warning(
        raw.friction_where,
        {"FS", "-1", "parts of the same FS, FD, DC and VC",
         "where parts with different ones touch, the mean acts, none counting as zero; LS-DYNA's manual does "
         "not say what does there. *DEFINE_FRICTION gives each pair its own",
         "friction of parts"});
  found.groups = static_cast<Index>(of_group.size());
  for (const Friction& one : of_group)
    for (const Friction& other : of_group) found.between.push_back(mean_of(one, other));
  return found;
}

/// Which table FS = -2 means; null, with a message, if there is none.
const RawFrictionTable* table_of(Build& build, const RawContact& raw) {
  const std::vector<RawFrictionTable>& tables = build.deck.friction_tables;
  if (raw.friction_table != 0) {
    const Index index = build.find(Item::FrictionTable, {raw.friction_table, "FD", raw.friction_where});
    return index == no_index ? nullptr : &tables[static_cast<std::size_t>(index)];
  }
  if (tables.size() == 1) return &tables.front();
  build.report.field_error(
      raw.friction_where,
      {"FD", "0", "the id of a *DEFINE_FRICTION",
       fmt::format("FS = -2 takes friction from one of them, and the deck has {}", tables.size()),
       "friction"});
  return nullptr;
}

/// The parts that one side of a line names; empty, with a message, if there are none.
std::vector<Index> parts_of(Build& build, const RawFrictionTable& table, const RawFrictionTable::Pair& pair,
                            std::size_t side) {
  const Item item = pair.is_set[side] ? Item::PartSet : Item::Part;
  const Index index = table.skips_missing
                          ? build.find_quietly(item, pair.id[side])
                          : build.find(item, {pair.id[side], side == 0 ? "PID_I" : "PID_J", pair.where});
  if (index == no_index) return {};
  if (!pair.is_set[side]) return {index};
  return build.model.part_sets[static_cast<std::size_t>(index)].parts;
}

/// FS = -2. Parts that no line names are one group, each of the others is one of its own.
PartFriction friction_of_table(Build& build, const RawContact& raw, const RawFrictionTable& table) {
  struct Line {
    std::array<std::vector<Index>, 2> parts;
    Friction friction;
  };
  std::vector<Line> lines;
  PartFriction found;
  found.group.assign(build.model.parts.size(), 0);
  found.groups = 1;
  for (const RawFrictionTable::Pair& pair : table.pairs) {
    Line line{{parts_of(build, table, pair, 0), parts_of(build, table, pair, 1)}, scaled(pair.friction, raw)};
    for (const std::vector<Index>& parts : line.parts)
      for (const Index part : parts)
        if (Index& group = found.group[static_cast<std::size_t>(part)]; group == 0) group = found.groups++;
    lines.push_back(std::move(line));
  }
  const auto count = static_cast<std::size_t>(found.groups);
  found.between.assign(count * count, scaled(table.others, raw));
  for (const Line& line : lines)
    for (const Index one : line.parts[0])
      for (const Index other : line.parts[1]) {
        const auto i = static_cast<std::size_t>(found.group[static_cast<std::size_t>(one)]);
        const auto j = static_cast<std::size_t>(found.group[static_cast<std::size_t>(other)]);
        found.between[i * count + j] = found.between[j * count + i] = line.friction;
      }
  return found;
}

}  // namespace

void enter_friction_tables(Build& build) {
  for (std::size_t i = 0; i < build.deck.friction_tables.size(); ++i) {
    const RawFrictionTable& table = build.deck.friction_tables[i];
    build.enter(Item::FrictionTable, {table.id, "ID", table.where}, i);
  }
}

void take_part_friction(Build& build, const RawContact& raw, model::Contact& contact) {
  if (raw.friction == FrictionSource::Parts) contact.part_friction = friction_of_parts(build, raw, contact);
  if (raw.friction != FrictionSource::Table) return;
  const RawFrictionTable* const table = table_of(build, raw);
  if (table == nullptr) return;
  contact.part_friction = friction_of_table(build, raw, *table);
  const Friction others = scaled(table->others, raw);
  contact.static_friction = others.at_rest;
  contact.dynamic_friction = others.when_sliding;
  contact.friction_decay = others.decay;
  contact.friction_stress = others.stress;
}

}  // namespace crumple::deck
