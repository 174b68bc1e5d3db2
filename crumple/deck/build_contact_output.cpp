// SPDX-License-Identifier: BSD-3-Clause
// Contacts and output requests.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "deck/build.hpp"

namespace crumple::deck {

namespace {

std::vector<Index> parts_with_surface(const Build& build) {
  std::vector<Index> parts;
  for (std::size_t i = 0; i < build.shells_of_part.size(); ++i)
    if (build.shells_of_part[i] > 0 || build.solids_of_part[i] > 0) parts.push_back(static_cast<Index>(i));
  return parts;
}

/// The parts that a contact names, before those without elements are taken out. Nothing if there is a fault.
std::optional<std::vector<Index>> named_parts(Build& build, const RawContact& raw) {
  const Reference reference{raw.id, "SSID", raw.where};
  if (raw.target == RawContact::Target::All) return parts_with_surface(build);
  if (raw.target == RawContact::Target::Part) {
    const Index part = build.find(Item::Part, reference);
    if (part == no_index) return std::nullopt;
    return std::vector<Index>{part};
  }
  const Index set = build.find(Item::PartSet, reference);
  if (set == no_index) return std::nullopt;
  const std::vector<Index>& members = build.model.part_sets[static_cast<std::size_t>(set)].parts;
  if (raw.target == RawContact::Target::PartSet) return members;
  std::vector<Index> others = parts_with_surface(build);
  for (const Index part : members) std::erase(others, part);
  return others;
}

/// Contact knows the surfaces of shells and solids only.
void refuse_beams(Build& build, const RawContact& raw, const std::vector<Index>& named) {
  std::vector<char> takes_part(build.model.parts.size(), raw.target == RawContact::Target::All ? 1 : 0);
  if (raw.target == RawContact::Target::AllButPartSet) {
    const Index set = build.find_quietly(Item::PartSet, raw.id);
    takes_part.assign(build.model.parts.size(), 1);
    for (const Index part : build.model.part_sets[static_cast<std::size_t>(set)].parts)
      takes_part[static_cast<std::size_t>(part)] = 0;
  }
  for (const Index part : named) takes_part[static_cast<std::size_t>(part)] = 1;
  for (std::size_t part = 0; part < takes_part.size(); ++part)
    if (takes_part[part] && model::kind_of(build.model.parts[part]) == ElementKind::Beam)
      build.report.unsupported(
          raw.where, "beams",
          fmt::format(
              "part {} consists of beams, which contact does not know yet; take it out of the contact, "
              "or run with --allow-unsupported to do without its contact",
              build.model.parts[part].id));
}

}  // namespace

void build_contacts(Build& build, bool automatic_contact) {
  const std::vector<Index> with_surface = parts_with_surface(build);
  for (std::size_t i = 0; i < build.deck.contacts.size(); ++i) {
    const RawContact& raw = build.deck.contacts[i];
    model::SingleSurfaceContact contact = raw.contact;
    if (contact.id == 0) contact.id = static_cast<UserId>(i) + 1;
    build.enter(Item::Contact, {contact.id, "ID", raw.where}, i);
    const std::optional<std::vector<Index>> named = named_parts(build, raw);
    if (!named) continue;
    refuse_beams(build, raw, *named);
    for (const Index part : *named)
      if (std::binary_search(with_surface.begin(), with_surface.end(), part)) contact.parts.push_back(part);
    std::sort(contact.parts.begin(), contact.parts.end());
    contact.parts.erase(std::unique(contact.parts.begin(), contact.parts.end()), contact.parts.end());
    if (contact.parts.empty())
      build.report.warning(raw.where, "empty", "the contact has neither shells nor solids and is left out");
    else
      build.model.contacts.push_back(std::move(contact));
  }
  if (automatic_contact && build.deck.contacts.empty() && !with_surface.empty()) {
    model::SingleSurfaceContact contact;
    contact.id = 1;
    contact.title = "automatic, all parts";
    contact.parts = with_surface;
    build.model.contacts.push_back(std::move(contact));
  }
}

void build_output(Build& build) {
  model::OutputRequests& output = build.model.output;
  if (build.deck.state_count > 0)
    output.state_interval = build.model.control.end_time / static_cast<double>(build.deck.state_count);
  const auto add = [&](Index node) {
    if (std::find(output.history_nodes.begin(), output.history_nodes.end(), node) ==
        output.history_nodes.end())
      output.history_nodes.push_back(node);
  };
  for (const RawHistory& raw : build.deck.histories) {
    const Index index = build.find(raw.is_set ? Item::NodeSet : Item::Node, {raw.id, "ID", raw.where});
    if (index == no_index) continue;
    if (!raw.is_set)
      add(index);
    else
      for (const Index node : build.model.node_sets[static_cast<std::size_t>(index)].nodes) add(node);
  }
}

}  // namespace crumple::deck
