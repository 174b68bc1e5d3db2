// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/distributed/distributed.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <vector>

#include "checks.hpp"
#include "ghosts.hpp"
#include "rank_summary.hpp"

namespace cellsearch {

namespace {

void add_difference(const Traffic& before, const Traffic& after, Traffic& sum) {
  sum.messages += after.messages - before.messages;
  sum.bytes += after.bytes - before.bytes;
  sum.reductions += after.reductions - before.reductions;
  sum.gathers += after.gathers - before.gathers;
  sum.bytes_given += after.bytes_given - before.bytes_given;
  sum.bytes_gathered += after.bytes_gathered - before.bytes_gathered;
}

Settings checked(const Settings& settings) {
  if (settings.method == Method::Nbs) {
    throw Error(ErrorKind::BadSetting, -1,
                "The method nbs refuses scenes by their sizes: what one rank holds would decide.");
  }
  return settings;
}

}  // namespace

class Distributed::State {
 public:
  State(Transport& connection, const Settings& settings)
      : transport(connection), search(checked(settings)), ghosts(connection) {}

  void find(const RankScene& own);
  void start_update(const Positions& own);
  void check_count(const Positions& own) const;

  Transport& transport;
  Search search;
  Ghosts ghosts;
  NodeCandidates candidates;
  Array<double> positions;
  std::size_t own_count = 0;
  bool searched = false;  // successfully, by the last call
  DistributedStatistics statistics;

 private:
  std::optional<Error> try_check(const RankScene& own, RankSummary& summary) const;
  std::optional<Error> try_merge(const RankScene& own);
  void clear();
  void copy_own(const Positions& own);
  Scene held_scene(const Scene& own);
  void turn_around(const Scene& own, const Candidates& found);

  Gathered gathered_;
  std::vector<RankSummary> summaries_;
  Array<Index> participants_;
  Array<Index> place_of_;
  Array<double> radius_;
  Array<Index> node_group_;
};

void Distributed::State::clear() {
  searched = false;
  candidates.first.clear();
  candidates.segment.clear();
  statistics = DistributedStatistics{};
}

std::optional<Error> Distributed::State::try_check(const RankScene& own, RankSummary& summary) const {
  try {
    check_rank(own, search.settings().threads);
    summary = summarise(own, search.settings());
  } catch (const Error& error) {
    return error;
  }
  return std::nullopt;
}

void Distributed::State::copy_own(const Positions& own) {
  double* place = positions.data();
  for (Index node = 0; node < static_cast<Index>(own_count); ++node) place = std::copy_n(own[node], 3, place);
}

/// What this rank holds as one scene: own nodes keep their numbers, ghosts follow and take no part.
Scene Distributed::State::held_scene(const Scene& own) {
  const std::size_t held = own_count + ghosts.node_id.size();
  Scene scene;
  scene.positions = Positions(positions);
  scene.segments = Segments(ghosts.segments.corner);
  scene.expansion = own.expansion;
  if (!ghosts.expansion.empty()) {
    scene.expansion = 0.0;  // 0 + c is c, in every bit
    scene.segment_expansion = ghosts.expansion;
  }
  scene.exclude_neighbours = own.exclude_neighbours;
  if (own.nodes) {
    scene.nodes = own.nodes;
  } else if (held > own_count) {
    participants_.resize(own_count);
    std::iota(participants_.begin(), participants_.end(), 0);
    scene.nodes = std::span<const Index>(participants_);
  }
  if (!own.node_radius.empty()) {
    radius_.assign(own.node_radius.begin(), own.node_radius.end());
    radius_.resize(held);
    std::fill(radius_.begin() + static_cast<std::ptrdiff_t>(own_count), radius_.end(), 0.0);
    scene.node_radius = radius_;
  }
  if (own.groups.count > 0) {
    node_group_.assign(own.groups.node_group.begin(), own.groups.node_group.end());
    node_group_.resize(held);
    std::fill(node_group_.begin() + static_cast<std::ptrdiff_t>(own_count), node_group_.end(), 0);
    scene.groups = own.groups;
    scene.groups.node_group = node_group_;
    scene.groups.segment_group = ghosts.group;
  }
  return scene;
}

/// From rows of nodes to rows of segments. Segments come ascending, and so they do in each row.
void Distributed::State::turn_around(const Scene& own, const Candidates& found) {
  const std::size_t rows = own.participants();
  if (own.nodes) {
    place_of_.resize(own_count);
    for (std::size_t place = 0; place < rows; ++place) {
      place_of_[static_cast<std::size_t>((*own.nodes)[place])] = static_cast<Index>(place);
    }
  }
  const auto row_of = [&](Index node) {
    return static_cast<std::size_t>(own.nodes ? place_of_[static_cast<std::size_t>(node)] : node);
  };
  Array<Offset>& first = candidates.first;
  // Counted two entries on and summed, entry row + 1 is the beginning of the row; filling moves it to the
  // end.
  first.assign(rows + 2, 0);
  for (const Index node : found.node) ++first[row_of(node) + 2];
  std::partial_sum(first.begin(), first.end(), first.begin());
  candidates.segment.resize(found.node.size());
  for (Index segment = 0; segment < found.segments(); ++segment) {
    for (const Index node : found.of(segment)) {
      candidates.segment[static_cast<std::size_t>(first[row_of(node) + 1]++)] = segment;
    }
  }
  first.pop_back();
}

std::optional<Error> Distributed::State::try_merge(const RankScene& own) {
  try {
    ghosts.merge(own);
    own_count = own.scene.positions.count();
    positions.resize(3 * own_count);
    positions.insert(positions.end(), ghosts.node_position.begin(), ghosts.node_position.end());
    copy_own(own.scene.positions);
    if (own.scene.participants() > 0) {
      turn_around(own.scene, search.find(held_scene(own.scene)));
    } else {
      candidates.first.assign(1, 0);
    }
  } catch (const Error& error) {
    return error;
  }
  return std::nullopt;
}

void Distributed::State::find(const RankScene& own) {
  clear();
  const Traffic before = transport.traffic();
  RankSummary summary;
  const std::optional<Error> bad_input = try_check(own, summary);
  exchange_summaries(transport, summary, bad_input, gathered_, summaries_);
  ghosts.exchange(own, summaries_);
  const std::optional<Error> failure = try_merge(own);
  if (failure) clear();
  try {
    agree(transport, failure);
  } catch (...) {
    clear();
    throw;
  }
  ghosts.exchange_wishes();
  searched = true;
  ghosts.count(statistics);
  add_difference(before, transport.traffic(), statistics.search);
}

void Distributed::State::check_count(const Positions& own) const {
  if (!searched) throw Error(ErrorKind::BadSetting, -1, "There was no successful search before the update.");
  check_positions(own);
  if (own.count() != own_count) {
    throw Error(ErrorKind::BadLayout, -1, "The number of nodes is not that of the last search.");
  }
}

void Distributed::State::start_update(const Positions& own) {
  check_count(own);
  const Traffic before = transport.traffic();
  ghosts.start_values(own);
  copy_own(own);
  add_difference(before, transport.traffic(), statistics.updates);
}

Distributed::Distributed(Transport& transport, const Settings& settings)
    : state_(std::make_unique<State>(transport, settings)) {}

Distributed::~Distributed() = default;

void Distributed::set(const Settings& settings) {
  state_->search = Search(checked(settings));
}

const NodeCandidates& Distributed::find(const RankScene& own) {
  state_->find(own);
  return state_->candidates;
}

const HeldSegments& Distributed::segments() const {
  return state_->ghosts.segments;
}

Positions Distributed::positions() const {
  return {state_->positions};
}

Index Distributed::own_nodes() const {
  return static_cast<Index>(state_->own_count);
}

Index Distributed::ghost_nodes() const {
  return static_cast<Index>(state_->ghosts.node_id.size());
}

std::span<const GlobalId> Distributed::ghost_node_ids() const {
  return state_->ghosts.node_id;
}

void Distributed::start_update(const Positions& own) {
  state_->start_update(own);
}

void Distributed::finish_update() {
  state_->ghosts.finish_values(std::span<double>(state_->positions).subspan(3 * state_->own_count));
}

void Distributed::start_values(const Positions& own) {
  state_->check_count(own);
  const Traffic before = state_->transport.traffic();
  state_->ghosts.start_values(own);
  add_difference(before, state_->transport.traffic(), state_->statistics.updates);
}

void Distributed::finish_values(std::span<double> ghosts) {
  if (ghosts.size() != 3 * state_->ghosts.node_id.size()) {
    throw Error(ErrorKind::BadLayout, -1, "There must be three numbers for each ghost node.");
  }
  state_->ghosts.finish_values(ghosts);
}

const DistributedStatistics& Distributed::statistics() const {
  return state_->statistics;
}

}  // namespace cellsearch
