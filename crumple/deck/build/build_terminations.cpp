// SPDX-License-Identifier: BSD-3-Clause
// What ends a run before its end time.
#include <fmt/core.h>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

using Kind = model::Termination::Kind;

/// The contact of the model, if it has forces between two sides.
Index find_two_sided(Build& build, const RawTermination& raw) {
  const auto& contacts = build.model.contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].id != raw.termination.id) continue;
    if (contacts[i].kind != model::ContactKind::SingleSurface) return static_cast<Index>(i);
    build.report.field_unsupported(raw.where,
                                   {"CID", std::to_string(raw.termination.id), "a contact with two sides",
                                    "the forces of a surface on itself have no sum", "one side"});
    return no_index;
  }
  build.report.field_error(
      raw.where,
      {"CID", std::to_string(raw.termination.id), "the number of a contact with forces",
       fmt::format("the deck has no such contact {}; give it with _ID", raw.termination.id), "contact"});
  return no_index;
}

void build_termination(Build& build, const RawTermination& raw) {
  model::Termination termination = raw.termination;
  const UserId id = termination.id;
  switch (termination.kind) {
    case Kind::Place:
    case Kind::Touch:
      termination.item = build.find(Item::Node, {id, "NID", raw.where});
      break;
    case Kind::Displacement:
    case Kind::Distance:
      termination.item = build.find(Item::RigidBody, {id, "PID", raw.where});
      break;
    case Kind::NoContact:
      termination.item = find_two_sided(build, raw);
      break;
    default:
      termination.parts = find_parts(build, raw.is_set, {id, raw.is_set ? "PSID" : "PID", raw.where});
      if (!termination.parts.empty()) termination.item = termination.parts.front();
  }
  if (termination.item != no_index) build.model.terminations.push_back(std::move(termination));
}

}  // namespace

void build_terminations(Build& build) {
  for (const RawTermination& raw : build.deck.terminations) build_termination(build, raw);
}

}  // namespace crumple::deck
