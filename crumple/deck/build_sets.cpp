// SPDX-License-Identifier: BSD-3-Clause
// Node sets and part sets.
#include <fmt/format.h>

#include "deck/build.hpp"

namespace crumple::deck {

namespace {

Where place_of(const RawSet& set, const RawMember& member) {
  Where where = set.where;
  where.line = member.line;
  where.card = member.card;
  return where;
}

/// Indices of the members of a set, each once. A range stands for those of its ids that exist, a single id
/// must exist.
template <class AllIds>
std::vector<Index> members_of(const RawSet& set, Item item, const AllIds& all_ids, Build& build) {
  std::vector<Index> indices;
  std::vector<char> taken(all_ids.size(), 0);
  bool missing = false;
  const auto take = [&](std::size_t index) {
    if (!taken[index]) indices.push_back(static_cast<Index>(index));
    taken[index] = 1;
  };
  for (const RawMember& member : set.members) {
    if (member.first == member.last) {
      const Index index = build.find(item, {member.first, "ID", place_of(set, member)});
      if (index != no_index)
        take(static_cast<std::size_t>(index));
      else
        missing = true;
      continue;
    }
    for (std::size_t i = 0; i < all_ids.size(); ++i)
      if (all_ids[i] >= member.first && all_ids[i] <= member.last) take(i);
  }
  if (indices.empty() && !missing)
    build.report.warning(set.where, "empty", fmt::format("set {} has no members", set.id));
  return indices;
}

}  // namespace

void build_sets(Build& build) {
  for (const RawSet& raw : build.deck.node_sets) {
    build.enter(Item::NodeSet, {raw.id, "SID", raw.where}, build.model.node_sets.size());
    build.model.node_sets.push_back(
        {raw.id, raw.title, members_of(raw, Item::Node, build.model.nodes.id, build)});
  }
  std::vector<UserId> part_ids;
  for (const model::Part& part : build.model.parts) part_ids.push_back(part.id);
  for (const RawSet& raw : build.deck.part_sets) {
    build.enter(Item::PartSet, {raw.id, "SID", raw.where}, build.model.part_sets.size());
    build.model.part_sets.push_back({raw.id, raw.title, members_of(raw, Item::Part, part_ids, build)});
  }
}

}  // namespace crumple::deck
