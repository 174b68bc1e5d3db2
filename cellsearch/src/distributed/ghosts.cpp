// SPDX-License-Identifier: BSD-3-Clause
#include "ghosts.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "cellsearch/error.hpp"
#include "cellsearch/territory.hpp"

namespace cellsearch {

Ghosts::Ghosts(Transport& transport)
    : transport_(transport),
      footprint_round_(transport.open_exchange()),
      ghost_round_(transport.open_exchange()),
      wish_round_(transport.open_exchange()),
      value_round_(transport.open_exchange()) {}

/// Both sides of a pair of ranks decide by the same two boxes.
void Ghosts::find_neighbours(const std::vector<RankSummary>& ranks) {
  receiver_count_ = 0;
  sender_count_ = 0;
  const RankSummary& own = ranks[static_cast<std::size_t>(transport_.rank())];
  for (int rank = 0; rank < transport_.size(); ++rank) {
    if (rank == transport_.rank()) continue;
    const RankSummary& other = ranks[static_cast<std::size_t>(rank)];
    if (own.territories.intersects(other.nodes)) {
      if (receivers_.size() == receiver_count_) receivers_.emplace_back();
      receivers_[receiver_count_++].rank = rank;
    }
    if (other.territories.intersects(own.nodes)) {
      if (senders_.size() == sender_count_) senders_.emplace_back();
      senders_[sender_count_++].rank = rank;
    }
  }
}

void Ghosts::exchange_footprints(const RankScene& own, const std::vector<RankSummary>& ranks) {
  sends_.clear();
  receives_.clear();
  if (sender_count_ > 0) {
    own_footprint_.reset(ranks[static_cast<std::size_t>(transport_.rank())].nodes);
    own_footprint_.mark(own.scene);
  }
  for (std::size_t at = 0; at < sender_count_; ++at) {
    sends_.push_back({senders_[at].rank, std::as_bytes(own_footprint_.marks())});
  }
  for (std::size_t at = 0; at < receiver_count_; ++at) {
    Receiver& receiver = receivers_[at];
    receiver.footprint.reset(ranks[static_cast<std::size_t>(receiver.rank)].nodes);
    receives_.push_back(
        {.from = receiver.rank, .buffer = std::as_writable_bytes(receiver.footprint.marks())});
  }
  footprint_round_->start(sends_, receives_);
}

/// The segments for each receiver and their nodes, into the messages.
void Ghosts::choose(const RankScene& own, const std::vector<RankSummary>& ranks) {
  const Scene& scene = own.scene;
  for (std::size_t at = 0; at < receiver_count_; ++at) {
    Receiver& receiver = receivers_[at];
    const Box& nodes = ranks[static_cast<std::size_t>(receiver.rank)].nodes;
    GhostMessage& message = receiver.message;
    message.clear();
    receiver.chosen.clear();
    for (Index segment = 0; segment < static_cast<Index>(scene.segments.count()); ++segment) {
      const Box& territory = territories_[static_cast<std::size_t>(segment)];
      if (!territory.intersects(nodes) || !receiver.footprint.meets(territory)) continue;
      receiver.chosen.push_back(segment);
      message.segment_id.push_back(own.segment_id[static_cast<std::size_t>(segment)]);
      message.number.push_back(segment);
      if (expansions_differ_) message.expansion.push_back(scene.expansion_of(segment));
      if (grouped_) message.group.push_back(scene.groups.segment_group[static_cast<std::size_t>(segment)]);
      for (int corner = 0; corner < 4; ++corner) {
        const Index node = scene.segments[segment][corner];
        Index& stamp = stamp_[static_cast<std::size_t>(node)];
        if (stamp < 0) {
          stamp = static_cast<Index>(message.node.size());
          message.node.push_back(node);
          message.node_id.push_back(own.node_id[static_cast<std::size_t>(node)]);
          message.position.insert(message.position.end(), scene.positions[node], scene.positions[node] + 3);
        }
        message.corner.push_back(stamp);
      }
    }
    for (const Index node : message.node) stamp_[static_cast<std::size_t>(node)] = -1;
    message.pack();
  }
}

void Ghosts::exchange(const RankScene& own, const std::vector<RankSummary>& ranks) {
  expansions_differ_ = std::any_of(ranks.begin(), ranks.end(),
                                   [](const RankSummary& rank) { return rank.expansion_differs != 0; });
  grouped_ = own.scene.groups.count > 0;
  find_neighbours(ranks);
  exchange_footprints(own, ranks);
  // While the footprints travel.
  const auto count = static_cast<Index>(own.scene.segments.count());
  territories_.assign(static_cast<std::size_t>(receiver_count_ > 0 ? count : 0), Box{});
  for (Index segment = 0; receiver_count_ > 0 && segment < count; ++segment) {
    // An empty box touches none: segments that are switched off stay at home.
    if (own.scene.active(segment))
      territories_[static_cast<std::size_t>(segment)] = territory(own.scene, segment);
  }
  stamp_.assign(own.scene.positions.count(), -1);
  footprint_round_->finish();

  choose(own, ranks);
  sends_.clear();
  receives_.clear();
  for (std::size_t at = 0; at < receiver_count_; ++at) {
    sends_.push_back({receivers_[at].rank, receivers_[at].message.bytes});
  }
  for (std::size_t at = 0; at < sender_count_; ++at) {
    receives_.push_back({.from = senders_[at].rank, .grown = &senders_[at].bytes});
  }
  ghost_round_->start(sends_, receives_);
  index_own_nodes(own);
  ghost_round_->finish();
  for (std::size_t at = 0; at < sender_count_; ++at) {
    senders_[at].view.read(senders_[at].bytes, expansions_differ_, grouped_);
  }
}

void Ghosts::exchange_wishes() {
  sends_.clear();
  receives_.clear();
  for (std::size_t at = 0; at < sender_count_; ++at) {
    const Array<Index>& wishes = senders_[at].wishes;
    sends_.push_back({senders_[at].rank, std::as_bytes(std::span<const Index>(wishes))});
    senders_[at].values.resize(3 * wishes.size());
  }
  for (std::size_t at = 0; at < receiver_count_; ++at) {
    receives_.push_back({.from = receivers_[at].rank, .grown = &receivers_[at].wishes});
  }
  wish_round_->start(sends_, receives_);
  wish_round_->finish();
  for (std::size_t at = 0; at < receiver_count_; ++at) {
    Receiver& receiver = receivers_[at];
    const auto* wishes = reinterpret_cast<const Index*>(receiver.wishes.data());
    const std::size_t count = receiver.wishes.size() / sizeof(Index);
    receiver.followed.resize(count);
    for (std::size_t wish = 0; wish < count; ++wish) {
      receiver.followed[wish] = receiver.message.node[static_cast<std::size_t>(wishes[wish])];
    }
    receiver.values.resize(3 * count);
  }
  // The messages of an update are the same each time.
  sends_.clear();
  receives_.clear();
  for (std::size_t at = 0; at < receiver_count_; ++at) {
    const Array<double>& values = receivers_[at].values;
    if (!values.empty())
      sends_.push_back({receivers_[at].rank, std::as_bytes(std::span<const double>(values))});
  }
  for (std::size_t at = 0; at < sender_count_; ++at) {
    Array<double>& values = senders_[at].values;
    if (!values.empty()) {
      receives_.push_back(
          {.from = senders_[at].rank, .buffer = std::as_writable_bytes(std::span<double>(values))});
    }
  }
}

void Ghosts::start_values(const Positions& own) {
  for (std::size_t at = 0; at < receiver_count_; ++at) {
    Receiver& receiver = receivers_[at];
    double* place = receiver.values.data();
    for (const Index node : receiver.followed) place = std::copy_n(own[node], 3, place);
  }
  value_round_->start(sends_, receives_);
}

void Ghosts::finish_values(std::span<double> ghosts) {
  value_round_->finish();
  for (std::size_t at = 0; at < sender_count_; ++at) {
    const Sender& sender = senders_[at];
    const double* value = sender.values.data();
    for (const Index slot : sender.slots) {
      std::copy_n(value, 3, ghosts.data() + 3 * static_cast<std::size_t>(slot));
      value += 3;
    }
  }
}

void Ghosts::count(DistributedStatistics& statistics) const {
  statistics.ranks_sent_to = static_cast<Offset>(receiver_count_);
  statistics.ranks_received_from = static_cast<Offset>(sender_count_);
  for (std::size_t at = 0; at < receiver_count_; ++at) {
    statistics.sent_segments += static_cast<Offset>(receivers_[at].chosen.size());
    statistics.sent_nodes += static_cast<Offset>(receivers_[at].message.node.size());
    statistics.followed_nodes += static_cast<Offset>(receivers_[at].followed.size());
  }
  for (std::size_t at = 0; at < sender_count_; ++at) {
    statistics.ghost_segments += static_cast<Offset>(senders_[at].view.segment_id.size());
  }
  statistics.ghost_nodes = static_cast<Offset>(node_id.size());
}

}  // namespace cellsearch
