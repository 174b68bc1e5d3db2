// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "cellsearch/array.hpp"
#include "cellsearch/distributed/transport.hpp"
#include "cellsearch/scene.hpp"
#include "cellsearch/search.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch {

/// Number of a node or segment in the whole model, the same on every rank; >= 0, in any order, with gaps or
/// not.
using GlobalId = std::int64_t;

/// What one rank brings: its part of the model, in its own numbers, and what these are called in the whole
/// model.
///
/// Every segment belongs to one rank, which holds all its nodes. A node may be held by several ranks; its
/// coordinates are then the same on all of them. `scene.nodes` are those whose candidates this rank wants:
/// usually each node belongs to one rank, but two may ask for the same. A rank may be empty. The common
/// expansion, the exclusion of neighbours, the number of groups and their matrix must be the same on all
/// ranks.
struct RankScene {
  Scene scene;                             ///< views, needed until find() returns
  std::span<const GlobalId> node_id{};     ///< one per node, none twice
  std::span<const GlobalId> segment_id{};  ///< one per segment, none twice, nor on another rank
};

/// The candidate segments of each node that takes part here, as compressed rows in the order of
/// `scene.nodes`. In each row the numbers of held segments ascend, and with them the global numbers.
struct NodeCandidates {
  Array<Offset> first;   ///< participants + 1 numbers
  Array<Index> segment;  ///< held segments (HeldSegments) of all rows

  /// Number of rows.
  Index rows() const { return first.empty() ? 0 : static_cast<Index>(first.size() - 1); }

  /// Number of pairs.
  Offset pairs() const { return static_cast<Offset>(segment.size()); }

  /// The candidates of the participant at `place` of `scene.nodes`.
  std::span<const Index> of(Index place) const {
    const auto begin = static_cast<std::size_t>(first[static_cast<std::size_t>(place)]);
    const auto end = static_cast<std::size_t>(first[static_cast<std::size_t>(place) + 1]);
    return {segment.data() + begin, end - begin};
  }

  bool operator==(const NodeCandidates&) const = default;
};

/// The active segments that a rank knows after a search: its own and the ghosts, by ascending global number.
struct HeldSegments {
  Array<GlobalId> id;   ///< global numbers
  Array<int> owner;     ///< rank
  Array<Index> number;  ///< what the owner calls it
  Array<Index> corner;  ///< 4 held nodes each: own ones by their number, ghosts from own_nodes() on

  Index count() const { return static_cast<Index>(id.size()); }

  /// The four held nodes of `segment`.
  const Index* nodes_of(Index segment) const { return corner.data() + 4 * static_cast<std::size_t>(segment); }
};

/// What the last search and the updates since have exchanged, by this rank.
struct DistributedStatistics {
  Offset ranks_sent_to = 0;        ///< those whose nodes are near the box around this rank's segments
  Offset ranks_received_from = 0;  ///< those whose segments are near the box around this rank's nodes
  Offset sent_segments = 0;        ///< copies of own segments given to others
  Offset sent_nodes = 0;           ///< their nodes, once for each rank that gets them
  Offset followed_nodes = 0;       ///< nodes whose motion this rank sends at each update, likewise
  Offset ghost_segments = 0;       ///< segments of others held here
  Offset ghost_nodes = 0;          ///< their nodes, as far as this rank does not hold them itself
  Traffic search;                  ///< of the last search
  Traffic updates;                 ///< of the updates since
};

/// The contact search over ranks: finds for the nodes of each rank the candidate segments of all ranks. The
/// answers are those of one search of the whole model, in every bit and for any number of ranks, any
/// partition and any order of arrival of messages (docs/distributed.md).
///
///     cellsearch::Distributed search(transport);
///     const cellsearch::NodeCandidates& found = search.find(own);       // all ranks together
///     for (cellsearch::Index held : found.of(place)) search.segments().id[held] ...
///     ...
///     search.start_update(positions);   // in each step: ghosts follow their owners, lists stay
///     search.finish_update();
///
/// All functions with "collective" are called by all ranks in the same order. Memory is re-used; an update
/// allocates nothing.
class Distributed {
 public:
  /// Collective. `settings` as of Search; the method must not be Nbs, which refuses scenes by the sizes of
  /// what one rank happens to hold. `transport` must outlive this object. Throws Error(BadSetting) or
  /// Error(BadDomain).
  explicit Distributed(Transport& transport, const Settings& settings = {});
  ~Distributed();
  Distributed(const Distributed&) = delete;
  Distributed& operator=(const Distributed&) = delete;

  /// Takes other settings from the next search on. Errors as above; the old ones stay then.
  void set(const Settings& settings);

  /// Collective. The result belongs to this object and is overwritten by the next call. If the input of any
  /// rank is wrong all ranks throw Error and stay usable: that rank its own error; the others the one of the
  /// lowest such rank, with the index -1. There is then no result. Beside the errors of Search::build:
  /// BadNodeId for a number that is negative or given twice, and for a node whose coordinates differ from
  /// rank to rank; BadSegmentId for a number that is negative or given twice, as far as a rank holds both.
  /// EmptyInput if all ranks together have no node. Throws TransportFault.
  const NodeCandidates& find(const RankScene& own);

  /// Own and ghost segments of the last search.
  const HeldSegments& segments() const;

  /// Positions of held nodes [length]: copies of those of the own ones, then ghosts by ascending global
  /// number; as of the last search or finished update.
  Positions positions() const;

  /// Numbers of held nodes: the own ones, as many as the rank's scene has, then the ghosts.
  Index own_nodes() const;
  Index ghost_nodes() const;

  /// Global numbers of the ghost nodes, ascending.
  std::span<const GlobalId> ghost_node_ids() const;

  /// Collective. Moves positions(): own ones from `own` (all nodes of the rank's scene), ghosts from their
  /// owners. Between the two calls messages travel. The candidates stay those of the search. Throws
  /// Error(BadLayout) if `own` has another number of nodes, Error(BadSetting) after a search that threw,
  /// TransportFault.
  void start_update(const Positions& own);
  void finish_update();
  void update(const Positions& own) {
    start_update(own);
    finish_update();
  }

  /// Collective. The same for any three numbers of each node, velocities for example: `own` for the own
  /// nodes, `ghosts`, 3 per ghost node, for what arrives. Not while an update is under way.
  void start_values(const Positions& own);
  void finish_values(std::span<double> ghosts);

  /// Counts of the last search and the updates since.
  const DistributedStatistics& statistics() const;

 private:
  class State;

  std::unique_ptr<State> state_;
};

}  // namespace cellsearch
