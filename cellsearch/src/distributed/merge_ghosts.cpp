// SPDX-License-Identifier: BSD-3-Clause
// Ghosts: what arrived is put in the order of the global numbers and joined with what this rank holds itself.
#include <algorithm>
#include <limits>
#include <string>

#include "cellsearch/error.hpp"
#include "ghosts.hpp"

namespace cellsearch {

void Ghosts::index_own_nodes(const RankScene& own) {
  node_order_.clear();
  if (std::is_sorted(own.node_id.begin(), own.node_id.end())) return;
  node_order_.resize(own.node_id.size());
  for (std::size_t place = 0; place < node_order_.size(); ++place)
    node_order_[place] = static_cast<Index>(place);
  std::sort(node_order_.begin(), node_order_.end(), [&](Index one, Index other) {
    return own.node_id[static_cast<std::size_t>(one)] < own.node_id[static_cast<std::size_t>(other)];
  });
}

/// The own node of that global number; -1 if this rank does not hold it.
Index Ghosts::own_node(const RankScene& own, GlobalId id) const {
  if (node_order_.empty()) {
    const auto found = std::lower_bound(own.node_id.begin(), own.node_id.end(), id);
    if (found == own.node_id.end() || *found != id) return -1;
    return static_cast<Index>(found - own.node_id.begin());
  }
  const auto found = std::lower_bound(
      node_order_.begin(), node_order_.end(), id,
      [&](Index node, GlobalId sought) { return own.node_id[static_cast<std::size_t>(node)] < sought; });
  if (found == node_order_.end() || own.node_id[static_cast<std::size_t>(*found)] != id) return -1;
  return *found;
}

/// `same`: one node in all messages that have it, senders ascending.
void Ghosts::place_node(const RankScene& own, std::span<const Arrival> same) {
  Index held = own_node(own, same.front().id);
  const auto own_count = static_cast<Index>(own.node_id.size());
  const auto position_in = [&](const Arrival& arrival) {
    return senders_[static_cast<std::size_t>(arrival.sender)].view.position.data() +
           3 * static_cast<std::size_t>(arrival.place);
  };
  const double* position = held >= 0 ? own.scene.positions[held] : position_in(same.front());
  for (const Arrival& arrival : same) {
    if (std::equal(position, position + 3, position_in(arrival))) continue;
    throw Error(
        ErrorKind::BadNodeId, held,
        "The node with the global number " + std::to_string(arrival.id) + " has other coordinates on rank " +
            std::to_string(senders_[static_cast<std::size_t>(arrival.sender)].rank) + " than on rank " +
            std::to_string(held >= 0 ? transport_.rank()
                                     : senders_[static_cast<std::size_t>(same.front().sender)].rank) +
            ".");
  }
  if (held < 0) {
    const auto slot = static_cast<Index>(node_id.size());
    held = own_count + slot;
    node_id.push_back(same.front().id);
    node_position.insert(node_position.end(), position, position + 3);
    Sender& provider = senders_[static_cast<std::size_t>(same.front().sender)];
    provider.wishes.push_back(same.front().place);
    provider.slots.push_back(slot);
  }
  for (const Arrival& arrival : same) {
    senders_[static_cast<std::size_t>(arrival.sender)].held[static_cast<std::size_t>(arrival.place)] = held;
  }
}

void Ghosts::merge_nodes(const RankScene& own) {
  arrivals_.clear();
  node_id.clear();
  node_position.clear();
  for (std::size_t at = 0; at < sender_count_; ++at) {
    Sender& sender = senders_[at];
    const std::span<const GlobalId> ids = sender.view.node_id;
    sender.held.assign(ids.size(), -1);
    sender.wishes.clear();
    sender.slots.clear();
    for (std::size_t place = 0; place < ids.size(); ++place) {
      arrivals_.push_back({ids[place], static_cast<Index>(at), static_cast<Index>(place)});
    }
  }
  std::sort(arrivals_.begin(), arrivals_.end(), [](const Arrival& one, const Arrival& other) {
    return one.id != other.id ? one.id < other.id : one.sender < other.sender;
  });
  for (std::size_t begin = 0; begin < arrivals_.size();) {
    std::size_t end = begin + 1;
    while (end < arrivals_.size() && arrivals_[end].id == arrivals_[begin].id) ++end;
    place_node(own, std::span<const Arrival>(arrivals_).subspan(begin, end - begin));
    begin = end;
  }
}

/// Own active segments and ghosts, by global number.
void Ghosts::collect_members(const RankScene& own) {
  const auto by_id = [](const Member& one, const Member& other) { return one.id < other.id; };
  own_members_.clear();
  for (Index segment = 0; segment < static_cast<Index>(own.scene.segments.count()); ++segment) {
    if (!own.scene.active(segment)) continue;
    own_members_.push_back({own.segment_id[static_cast<std::size_t>(segment)], -1, segment});
  }
  if (!std::is_sorted(own_members_.begin(), own_members_.end(), by_id)) {
    std::sort(own_members_.begin(), own_members_.end(), by_id);
  }
  ghost_members_.clear();
  for (std::size_t at = 0; at < sender_count_; ++at) {
    const std::span<const GlobalId> ids = senders_[at].view.segment_id;
    for (std::size_t place = 0; place < ids.size(); ++place) {
      ghost_members_.push_back({ids[place], static_cast<Index>(at), static_cast<Index>(place)});
    }
  }
  std::sort(ghost_members_.begin(), ghost_members_.end(), by_id);
  members_.resize(own_members_.size() + ghost_members_.size());
  std::merge(own_members_.begin(), own_members_.end(), ghost_members_.begin(), ghost_members_.end(),
             members_.begin(), by_id);
  if (members_.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max())) {
    throw Error(ErrorKind::BadLayout, -1, "A rank would hold more than 2147483647 segments.");
  }
}

void Ghosts::put_member(const RankScene& own, const Member& member, std::size_t at) {
  segments.id[at] = member.id;
  const Scene& scene = own.scene;
  Index* corner = segments.corner.data() + 4 * at;
  if (member.sender < 0) {
    segments.owner[at] = transport_.rank();
    segments.number[at] = member.place;
    std::copy_n(scene.segments[member.place], 4, corner);
    if (expansions_differ_) expansion[at] = scene.expansion_of(member.place);
    if (grouped_) group[at] = scene.groups.segment_group[static_cast<std::size_t>(member.place)];
    return;
  }
  const Sender& sender = senders_[static_cast<std::size_t>(member.sender)];
  const auto place = static_cast<std::size_t>(member.place);
  segments.owner[at] = sender.rank;
  segments.number[at] = sender.view.number[place];
  for (std::size_t number = 0; number < 4; ++number) {
    corner[number] = sender.held[static_cast<std::size_t>(sender.view.corner[4 * place + number])];
  }
  if (expansions_differ_) expansion[at] = sender.view.expansion[place];
  if (grouped_) group[at] = sender.view.group[place];
}

void Ghosts::merge_segments(const RankScene& own) {
  collect_members(own);
  const std::size_t count = members_.size();
  segments.id.resize(count);
  segments.owner.resize(count);
  segments.number.resize(count);
  segments.corner.resize(4 * count);
  expansion.resize(expansions_differ_ ? count : 0);
  group.resize(grouped_ ? count : 0);
  for (std::size_t at = 0; at < count; ++at) {
    put_member(own, members_[at], at);
    if (at == 0 || segments.id[at] != segments.id[at - 1]) continue;
    throw Error(ErrorKind::BadSegmentId, -1,
                "The global number " + std::to_string(segments.id[at]) + " is that of segments on ranks " +
                    std::to_string(segments.owner[at - 1]) + " and " + std::to_string(segments.owner[at]) +
                    ".");
  }
}

void Ghosts::merge(const RankScene& own) {
  merge_nodes(own);
  merge_segments(own);
}

}  // namespace cellsearch
