// SPDX-License-Identifier: BSD-3-Clause
// *NODE_TRANSFORM, and ids of *DEFINE_TRANSFORMATION.
#include <algorithm>
#include <map>
#include <set>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

const RawSet* find_raw_set(const std::vector<RawSet>& sets, UserId id) {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const RawSet& set) { return set.id == id; });
  return found == sets.end() ? nullptr : &*found;
}

/// Whether an id is one of a member's range, whose ends may be far apart.
bool is_in_range(UserId id, const RawMember& member) {
  return id >= member.first && id <= member.last &&
         (id - member.first) % std::max<UserId>(member.increment, 1) == 0;
}

/// The ids of the nodes that sets list, each set once.
class ListedNodes {
 public:
  explicit ListedNodes(const RawDeck& deck) : deck_(&deck) {}

  /// Null if the set takes nodes by their place, part or elements, which are known only once the nodes are
  /// where they belong, or has itself as a member.
  const std::set<UserId>* of(const RawSet& set) {
    const auto [at, is_new] = known_.try_emplace(set.id);
    if (is_new && list(set, at->second.ids)) at->second.is_listed = true;
    return at->second.is_listed ? &at->second.ids : nullptr;
  }

 private:
  struct Known {
    bool is_listed = false;  ///< false also while its members are being listed
    std::set<UserId> ids;
  };

  bool list(const RawSet& set, std::set<UserId>& ids);

  const RawDeck* deck_;
  std::map<UserId, Known> known_;
};

bool ListedNodes::list(const RawSet& set, std::set<UserId>& ids) {
  for (const RawMember& member : set.members) {
    if (member.what == RawMember::What::OwnSet) {
      for (const RawSet& other : deck_->node_sets) {
        if (!is_in_range(other.id, member)) continue;
        const std::set<UserId>* added = of(other);
        if (added == nullptr) return false;
        ids.insert(added->begin(), added->end());
      }
    } else if (member.what != RawMember::What::Member) {
      return false;
    } else if (member.removes) {
      std::erase_if(ids, [&](UserId id) { return is_in_range(id, member); });
    } else if (member.first == member.last) {
      ids.insert(member.first);
    } else {
      for (const RawNode& node : deck_->nodes)
        if (is_in_range(node.id, member)) ids.insert(node.id);
    }
  }
  return true;
}

}  // namespace

void move_nodes(Build& build) {
  const RawDeck& deck = build.deck;
  for (std::size_t i = 0; i < deck.transformations.size(); ++i)
    build.enter(Item::Transformation, {deck.transformations[i].id, "TRANID", deck.transformations[i].where},
                i);
  ListedNodes listed(deck);
  for (const RawNodeTransform& raw : deck.node_transforms) {
    const Index index = build.find(Item::Transformation, {raw.transformation, "TRSID", raw.where});
    const RawSet* set = find_raw_set(deck.node_sets, raw.node_set);
    const std::string id = std::to_string(raw.node_set);
    const std::set<UserId>* ids = set == nullptr ? nullptr : listed.of(*set);
    if (set == nullptr) {
      build.report.field_error(
          raw.where, {"NSID", id, "the id of a node set",
                      "the deck has no node set " + id + "; add it with *SET_NODE_LIST", "reference"});
    } else if (ids == nullptr) {
      build.report.field_unsupported(
          raw.where, {"NSID", id, "a set that lists its nodes",
                      "sets by parts, boxes, elements or themselves cannot be moved; list the nodes "
                      "with *SET_NODE_LIST or _GENERATE",
                      "listed"});
    } else if (index != no_index) {
      for (const UserId node_id : *ids) {
        const Index node = build.find_quietly(Item::Node, node_id);
        if (node == no_index) continue;
        auto& x = build.model.nodes.position[static_cast<std::size_t>(node)];
        const Vector moved = deck.transformations[static_cast<std::size_t>(index)].map.of_point(x);
        if (is_finite(moved))
          x = moved;
        else
          build.report.error(raw.where, "placed", "a node is moved out of the range of numbers");
      }
    }
  }
}

}  // namespace crumple::deck
