// SPDX-License-Identifier: BSD-3-Clause
// Tied contacts.
#include <fmt/core.h>

#include <algorithm>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

using Target = RawContactSide::Target;

/// What a part or a set of parts names, without a message.
std::vector<Index> parts_named_by(const Build& build, const RawContactSide& raw) {
  if (raw.target == Target::Part) {
    const Index part = build.find_quietly(Item::Part, raw.id);
    if (part != no_index) return {part};
  }
  if (raw.target == Target::PartSet) {
    const Index set = build.find_quietly(Item::PartSet, raw.id);
    if (set != no_index) return build.model.part_sets[static_cast<std::size_t>(set)].parts;
  }
  return {};
}

/// Parts of beams and springs have nodes, and no surface. False if none is named.
bool take_lines(Build& build, const RawContactSide& raw, const Where& where, model::ContactSide& side) {
  std::vector<Index> lines;
  for (const Index part : parts_named_by(build, raw)) {
    const bool is_line = build.lines_of_part[static_cast<std::size_t>(part)] > 0;
    (is_line ? lines : side.parts).push_back(part);
  }
  if (lines.empty()) {
    side.parts.clear();
    return false;
  }
  side.nodes = nodes_of_parts(build, lines);
  if (raw.box != 0)
    build.report.field_unsupported(where,
                                   {raw.box_field, std::to_string(raw.box), "no box beside beams or springs",
                                    "take a node set of those inside", "box"});
  std::sort(side.parts.begin(), side.parts.end());
  side.parts.erase(std::unique(side.parts.begin(), side.parts.end()), side.parts.end());
  return true;
}

/// False, with a message, if what the side names is not there or is nothing.
bool take_side(Build& build, const RawContactSide& raw, const Where& where, bool nodes_will_do,
               model::ContactSide& side) {
  if (!(nodes_will_do && take_lines(build, raw, where, side)) && !add_contact_side(build, raw, where, side))
    return false;
  if (!side.empty()) return true;
  build.report.field_error(
      where, {raw.field, std::to_string(raw.id), nodes_will_do ? "nodes or a surface" : "shells or solids",
              "there is nothing to tie", "empty"});
  return false;
}

bool has_shells(const Build& build, const model::ContactSide& side) {
  return !side.shells.empty() || std::any_of(side.parts.begin(), side.parts.end(), [&](Index part) {
    return build.shells_of_part[static_cast<std::size_t>(part)] > 0;
  });
}

/// Springs know the mid-surfaces of shells and not the surfaces that are glued.
void check_softening(Build& build, const model::TiedContact& tied, const Where& where) {
  if (!tied.softening || !(has_shells(build, tied.side[0]) || has_shells(build, tied.side[1]))) return;
  build.report.warning(
      where, "softening shells",
      "openings are measured between the mid-surfaces of shells: where the two turn against "
      "each other, sliding of their distance times the angle is added, which mixes the modes");
}

}  // namespace

void build_tied_contacts(Build& build) {
  for (std::size_t i = 0; i < build.deck.tied_contacts.size(); ++i) {
    const RawTiedContact& raw = build.deck.tied_contacts[i];
    const std::size_t place = build.deck.contacts.size() + i;
    model::TiedContact tied = raw.tied;
    tied.id = enter_contact(build, tied.id, raw.where, place);
    const bool first = take_side(build, raw.side[0], raw.where, true, tied.side[0]);
    const bool second = take_side(build, raw.side[1], raw.where, false, tied.side[1]);
    if (!first || !second) continue;
    if (tied.failure && tied.failure->by_stress && !tied.side[0].nodes.empty()) {
      build.report.field_error(raw.where,
                               {"SSTYP", raw.side[0].target == Target::NodeSet ? "4" : "beams", "a surface",
                                "nodes alone have no area that a stress could act on; take "
                                "*CONTACT_TIEBREAK_NODES_TO_SURFACE",
                                "area"});
      continue;
    }
    check_softening(build, tied, raw.where);
    if (raw.afterwards) {
      model::Contact after = *raw.afterwards;
      after.id = tied.id;
      after.title = tied.title;
      after.side = tied.side;
      build.model.contacts.push_back(std::move(after));
    }
    build.model.tied_contacts.push_back(std::move(tied));
  }
}

}  // namespace crumple::deck
