// SPDX-License-Identifier: BSD-3-Clause
// Contacts and force transducers.
#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "deck/build/build.hpp"
#include "model/solid_faces.hpp"

namespace crumple::deck {

namespace {

using Target = RawContactSide::Target;
using Face = std::array<Index, 4>;

std::vector<Index> parts_with_surface(const Build& build) {
  std::vector<Index> parts;
  for (std::size_t i = 0; i < build.shells_of_part.size(); ++i)
    if (build.shells_of_part[i] > 0 || build.solids_of_part[i] > 0) parts.push_back(static_cast<Index>(i));
  return parts;
}

void sort_out(std::vector<Index>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// What becomes of parts of beams.
enum class BeamRule {
  TakePart,
  LeaveOut,  ///< with a warning
  Refuse,
};

/// Contact by multipliers knows no beams, that by the masses of segments none here nor in LS-DYNA.
BeamRule beam_rule(const RawContact& raw) {
  if (raw.only_measures || raw.contact.mass_stiffness) return BeamRule::LeaveOut;
  return raw.contact.enforcement == model::Enforcement::Penalty ? BeamRule::TakePart : BeamRule::Refuse;
}

/// Finds what the sides of contacts consist of.
class Sides {
 public:
  explicit Sides(Build& build) : build_(build), with_surface_(parts_with_surface(build)) {}

  const std::vector<Index>& with_surface() const { return with_surface_; }

  /// Adds the members of one side. False, with a message, if there is a fault.
  bool add(const RawContactSide& raw, const Where& where, BeamRule rule, model::ContactSide& side);

 private:
  std::optional<std::vector<Index>> named_parts(const RawContactSide& raw, const Where& where);
  std::vector<Index> parts_with_beams(const RawContactSide& raw, const std::vector<Index>& named) const;
  void leave_out_beams(const Where& where, BeamRule rule, const std::vector<Index>& parts);
  void check_segments(const RawContactSide& raw, const Where& where, const std::vector<Face>& segments);
  void keep_inside(const RawBox& box, model::ContactSide& side) const;
  const std::vector<Face>& known_faces();

  template <class Nodes>
  bool all_inside(const RawBox& box, const Nodes& nodes) const {
    return std::all_of(nodes.begin(), nodes.end(), [&](Index node) {
      return is_inside(box, build_.model.nodes.position[static_cast<std::size_t>(node)]);
    });
  }

  Build& build_;
  std::vector<Index> with_surface_;
  std::vector<Face> known_faces_;  ///< keys of all shells and faces of solids, ascending; made when needed
};

/// The parts that a side names, before those without elements are taken out. Nothing if there is a fault.
std::optional<std::vector<Index>> Sides::named_parts(const RawContactSide& raw, const Where& where) {
  if (raw.target == Target::All) return with_surface_;
  const Reference reference{raw.id, raw.field, where};
  if (raw.target == Target::Part) {
    const Index part = build_.find(Item::Part, reference);
    if (part == no_index) return std::nullopt;
    return std::vector<Index>{part};
  }
  const Index set = build_.find(Item::PartSet, reference);
  if (set == no_index) return std::nullopt;
  const std::vector<Index>& members = build_.model.part_sets[static_cast<std::size_t>(set)].parts;
  if (raw.target == Target::PartSet) return members;
  std::vector<Index> others = with_surface_;
  for (const Index part : members) std::erase(others, part);
  return others;
}

/// Beams, but not spot welds and discrete beams, which touch nothing.
bool can_touch_as_beams(const model::Model& model, const model::Part& part) {
  if (model::kind_of(part) != ElementKind::Beam) return false;
  const model::BeamFormulation formulation =
      model.beam_sections[static_cast<std::size_t>(part.beam_section)].formulation;
  return formulation != model::BeamFormulation::SpotWeld && formulation != model::BeamFormulation::Discrete;
}

/// The parts of beams among what a side takes in.
std::vector<Index> Sides::parts_with_beams(const RawContactSide& raw, const std::vector<Index>& named) const {
  std::vector<char> takes_part(build_.model.parts.size(), raw.target == Target::All ? 1 : 0);
  if (raw.target == Target::AllButPartSet) {
    const Index set = build_.find_quietly(Item::PartSet, raw.id);
    takes_part.assign(build_.model.parts.size(), 1);
    for (const Index part : build_.model.part_sets[static_cast<std::size_t>(set)].parts)
      takes_part[static_cast<std::size_t>(part)] = 0;
  }
  for (const Index part : named) takes_part[static_cast<std::size_t>(part)] = 1;
  std::vector<Index> found;
  for (std::size_t part = 0; part < takes_part.size(); ++part)
    if (takes_part[part] && can_touch_as_beams(build_.model, build_.model.parts[part]))
      found.push_back(static_cast<Index>(part));
  return found;
}

void Sides::leave_out_beams(const Where& where, BeamRule rule, const std::vector<Index>& parts) {
  for (const Index part : parts) {
    const UserId id = build_.model.parts[static_cast<std::size_t>(part)].id;
    if (rule == BeamRule::LeaveOut)
      build_.report.warning(where, "beams",
                            fmt::format("part {} consists of beams, which take no part in it", id));
    else
      build_.report.unsupported(
          where, "beams",
          fmt::format(
              "part {} consists of beams, which contacts with a box or by constraints do not know; "
              "take it out of this contact, or run with --allow-unsupported to do without its contact",
              id));
  }
}

const std::vector<Face>& Sides::known_faces() {
  if (!known_faces_.empty()) return known_faces_;
  for (const model::ShellElement& shell : build_.model.shells)
    known_faces_.push_back(model::key_of(shell.node));
  for (const model::SolidElement& solid : build_.model.solids)
    for (const Face& face : model::faces_of(solid)) known_faces_.push_back(model::key_of(face));
  std::sort(known_faces_.begin(), known_faces_.end());
  return known_faces_;
}

/// The stiffness of a segment is that of its element: it must have one.
void Sides::check_segments(const RawContactSide& raw, const Where& where, const std::vector<Face>& segments) {
  const std::vector<Face>& known = known_faces();
  const auto is_bare = [&](const Face& segment) {
    return !std::binary_search(known.begin(), known.end(), model::key_of(segment));
  };
  const auto count = std::count_if(segments.begin(), segments.end(), is_bare);
  if (count == 0) return;
  const Face& first = *std::find_if(segments.begin(), segments.end(), is_bare);
  const auto id = [&](std::size_t k) { return build_.model.nodes.id[static_cast<std::size_t>(first[k])]; };
  build_.report.error(where, "bare segments",
                      fmt::format("field {}: {} of the {} segments of segment set {} are neither a shell nor "
                                  "a face of a solid, the first one has the nodes {}, {}, {}, {}; contact "
                                  "takes its stiffness from the element",
                                  raw.field, count, segments.size(), raw.id, id(0), id(1), id(2), id(3)));
}

/// What has all its nodes in the box. Parts become their shells and outer faces.
void Sides::keep_inside(const RawBox& box, model::ContactSide& side) const {
  const model::Model& model = build_.model;
  const auto takes_part = [&](Index part) {
    return std::binary_search(side.parts.begin(), side.parts.end(), part);
  };
  for (std::size_t i = 0; i < model.shells.size(); ++i)
    if (takes_part(model.shells[i].part)) side.shells.push_back(static_cast<Index>(i));
  std::vector<Index> solids;
  for (std::size_t i = 0; i < model.solids.size(); ++i)
    if (takes_part(model.solids[i].part)) solids.push_back(static_cast<Index>(i));
  for (const model::SolidFace& face : model::all_faces(model.solids, solids))
    side.segments.push_back(face.node);  // those inside as well: erosion may expose them
  side.parts.clear();
  std::erase_if(side.shells, [&](Index shell) {
    return !all_inside(box, model.shells[static_cast<std::size_t>(shell)].node);
  });
  std::erase_if(side.segments, [&](const Face& segment) { return !all_inside(box, segment); });
  std::erase_if(side.nodes, [&](Index node) { return !all_inside(box, std::array<Index, 1>{node}); });
}

bool Sides::add(const RawContactSide& raw, const Where& where, BeamRule rule, model::ContactSide& side) {
  const Reference reference{raw.id, raw.field, where};
  switch (raw.target) {
    case Target::SegmentSet: {
      const Index set = build_.find(Item::SegmentSet, reference);
      if (set == no_index) return false;
      side.segments = build_.model.segment_sets[static_cast<std::size_t>(set)].segments;
      check_segments(raw, where, side.segments);
      break;
    }
    case Target::ShellSet: {
      const Index set = build_.find(Item::ShellSet, reference);
      if (set == no_index) return false;
      side.shells = build_.model.shell_sets[static_cast<std::size_t>(set)].shells;
      break;
    }
    case Target::NodeSet: {
      const std::vector<Index>* nodes = set_nodes(build_, reference);
      if (nodes == nullptr) return false;
      side.nodes = *nodes;
      break;
    }
    default: {
      const std::optional<std::vector<Index>> named = named_parts(raw, where);
      if (!named) return false;
      for (const Index part : *named)
        if (std::binary_search(with_surface_.begin(), with_surface_.end(), part)) side.parts.push_back(part);
      const std::vector<Index> beams = parts_with_beams(raw, *named);
      if (rule == BeamRule::TakePart && raw.box == 0)
        side.parts.insert(side.parts.end(), beams.begin(), beams.end());
      else
        leave_out_beams(where, rule, beams);
      sort_out(side.parts);
    }
  }
  if (raw.box != 0) {
    const Index box = build_.find(Item::Box, {raw.box, raw.box_field, where});
    if (box == no_index) return false;
    keep_inside(build_.deck.boxes[static_cast<std::size_t>(box)], side);
  }
  sort_out(side.shells);
  sort_out(side.nodes);
  return true;
}

void set_thickness(const Build& build, const RawContact& raw, model::Contact& contact) {
  if (!contact.oriented) return;
  const int option =
      raw.takes_own_thickness_option ? raw.thickness_option : build.deck.contact_thickness_option;
  contact.shell_thickness = option >= 1;
  contact.rigid_shell_thickness = option >= 2;
}

/// Id of a contact that the deck gives none, or one that another has, from its place among all contacts; of
/// no other one.
UserId free_contact_id(const Build& build, std::size_t place) {
  const auto count = build.deck.contacts.size() + build.deck.tied_contacts.size();
  const auto is_given = [&](UserId id) {
    return std::any_of(build.deck.contacts.begin(), build.deck.contacts.end(),
                       [&](const RawContact& raw) { return raw.contact.id == id; }) ||
           std::any_of(build.deck.tied_contacts.begin(), build.deck.tied_contacts.end(),
                       [&](const RawTiedContact& raw) { return raw.tied.id == id; });
  };
  // Stepping by the count keeps generated ids unique.
  auto id = static_cast<UserId>(place) + 1;
  while (is_given(id)) id += static_cast<UserId>(count);
  return id;
}

/// Where the contact of an id stands that is entered first.
const Where& place_of_contact(const RawDeck& deck, UserId id) {
  for (const RawContact& raw : deck.contacts)
    if (raw.contact.id == id) return raw.where;
  return std::find_if(deck.tied_contacts.begin(), deck.tied_contacts.end(),
                      [&](const RawTiedContact& raw) { return raw.tied.id == id; })
      ->where;
}

void build_contact(Build& build, Sides& sides, const RawContact& raw, std::size_t number) {
  model::Contact contact = raw.contact;
  contact.id = enter_contact(build, contact.id, raw.where, number);
  const bool two_sided = contact.kind != model::ContactKind::SingleSurface;
  const bool has_second = two_sided && !(raw.only_measures && raw.side[1].id == 0);
  const BeamRule beams = beam_rule(raw);
  bool good = sides.add(raw.side[0], raw.where, beams, contact.side[0]);
  if (has_second) good = sides.add(raw.side[1], raw.where, beams, contact.side[1]) && good;
  if (!good) return;
  if (contact.side[0].empty() || (has_second && contact.side[1].empty())) {
    build.report.warning(raw.where, "empty",
                         fmt::format("{} has neither shells nor solids nor nodes; the contact is left out",
                                     !has_second               ? "it"
                                     : contact.side[0].empty() ? "its first side"
                                                               : "its second side"));
    return;
  }
  if (raw.only_measures) {
    build.model.force_transducers.push_back({contact.id, contact.title, contact.side});
    return;
  }
  set_thickness(build, raw, contact);
  take_part_friction(build, raw, contact);
  build.model.contacts.push_back(std::move(contact));
}

}  // namespace

UserId enter_contact(Build& build, UserId given, const Where& where, std::size_t place) {
  const bool is_taken = given != 0 && build.find_quietly(Item::Contact, given) != no_index;
  const UserId id = given == 0 || is_taken ? free_contact_id(build, place) : given;
  if (is_taken)
    build.report.field_warning(
        where, {"ID", std::to_string(given), "an id that is not used yet",
                fmt::format("contact {} is already defined at {}; this one acts, too, and is {} in outputs",
                            given, build.report.place(place_of_contact(build.deck, given)), id),
                "duplicate"});
  build.enter(Item::Contact, {id, "ID", where}, place);
  return id;
}

bool add_contact_side(Build& build, const RawContactSide& raw, const Where& where, model::ContactSide& side) {
  return Sides(build).add(raw, where, BeamRule::LeaveOut, side);
}

void build_contacts(Build& build, bool automatic_contact) {
  Sides sides(build);
  for (std::size_t i = 0; i < build.deck.contacts.size(); ++i)
    build_contact(build, sides, build.deck.contacts[i], i);
  if (automatic_contact && build.deck.contacts.empty() && !sides.with_surface().empty())
    build.model.contacts.push_back(model::self_contact(1, "automatic, all parts", sides.with_surface()));
}

}  // namespace crumple::deck
