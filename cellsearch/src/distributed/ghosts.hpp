// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "cellsearch/distributed/distributed.hpp"
#include "footprint.hpp"
#include "ghost_message.hpp"
#include "rank_summary.hpp"

namespace cellsearch {

/// Which segments of other ranks this rank needs, what they are, and how their nodes follow. A search makes
/// three rounds between ranks whose boxes touch:
///
///   1. footprints: the marked cells of the nodes, from who has the nodes to who has the segments;
///   2. ghosts: the segments whose territories cover a marked cell, and their nodes, back;
///   3. wishes: which of these nodes the receiver wants to follow: not those that it holds itself, and each
///   one from
///      the lowest rank that sent it.
///
/// An update then is one round of three numbers per node that was wished for.
class Ghosts {
 public:
  /// Collective.
  explicit Ghosts(Transport& transport);

  /// Rounds 1 and 2: afterwards all messages are there. `ranks`: the summaries of all.
  void exchange(const RankScene& own, const std::vector<RankSummary>& ranks);

  /// Merges what arrived with what is held. Nothing travels. Throws Error(BadNodeId), Error(BadSegmentId).
  void merge(const RankScene& own);

  /// Round 3.
  void exchange_wishes();

  /// An update: 3 numbers per node.
  void start_values(const Positions& own);
  void finish_values(std::span<double> ghosts);

  /// \name What is held; ghosts in the order of their global numbers, whatever the order of arrival
  /// @{
  HeldSegments segments;
  Array<double> expansion;      ///< whole expansion of each held segment [length], if they differ
  Array<Index> group;           ///< group of each held segment, if there are groups
  Array<GlobalId> node_id;      ///< of ghost nodes
  Array<double> node_position;  ///< of ghost nodes, 3 each [length]
  /// @}

  void count(DistributedStatistics& statistics) const;

 private:
  /// A rank that gets segments from this one.
  struct Receiver {
    int rank = 0;
    Footprint footprint;
    Array<Index> chosen;  // own segments
    GhostMessage message;
    Array<std::byte> wishes;  // places in the message's nodes
    Array<Index> followed;    // own nodes that it follows
    Array<double> values;
  };

  /// A rank that this one gets segments from.
  struct Sender {
    int rank = 0;
    Array<std::byte> bytes;
    GhostView view;
    Array<Index> held;    // held nodes, by place in the message
    Array<Index> wishes;  // places
    Array<Index> slots;   // ghost nodes, in the order of the wishes
    Array<double> values;
  };

  /// A node in a message.
  struct Arrival {
    GlobalId id;
    Index sender;
    Index place;
  };

  /// A held segment, own (sender -1) or in a message.
  struct Member {
    GlobalId id;
    Index sender;
    Index place;
  };

  void find_neighbours(const std::vector<RankSummary>& ranks);
  void exchange_footprints(const RankScene& own, const std::vector<RankSummary>& ranks);
  void choose(const RankScene& own, const std::vector<RankSummary>& ranks);
  void index_own_nodes(const RankScene& own);
  Index own_node(const RankScene& own, GlobalId id) const;
  void merge_nodes(const RankScene& own);
  void place_node(const RankScene& own, std::span<const Arrival> same);
  void collect_members(const RankScene& own);
  void merge_segments(const RankScene& own);
  void put_member(const RankScene& own, const Member& member, std::size_t at);

  Transport& transport_;
  std::unique_ptr<Exchange> footprint_round_;
  std::unique_ptr<Exchange> ghost_round_;
  std::unique_ptr<Exchange> wish_round_;
  std::unique_ptr<Exchange> value_round_;
  std::vector<Receiver> receivers_;  // ascending by rank; more than are in use, for their memory
  std::vector<Sender> senders_;
  std::size_t receiver_count_ = 0;
  std::size_t sender_count_ = 0;
  std::vector<Outgoing> sends_;
  std::vector<Incoming> receives_;
  Footprint own_footprint_;
  bool expansions_differ_ = false;
  bool grouped_ = false;
  Array<Box> territories_;
  Array<Index> stamp_;       // by own node: its place in the message being written, or -1
  Array<Index> node_order_;  // own nodes by global number; empty if they ascend
  Array<Arrival> arrivals_;
  Array<Member> own_members_;
  Array<Member> ghost_members_;
  Array<Member> members_;
};

}  // namespace cellsearch
