// SPDX-License-Identifier: BSD-3-Clause
#include "distributed_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace cellsearch::distributed_checks {

namespace {

std::size_t at(Index number) {
  return static_cast<std::size_t>(number);
}

/// 0 to count - 1 in an order drawn by lot.
std::vector<Index> shuffled_numbers(std::size_t count, scenes::Random& random) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t left = count; left > 1; --left) std::swap(order[left - 1], order[at(random.below(left))]);
  return order;
}

int rank_of(Partition partition, std::size_t number, std::size_t count, int size, scenes::Random& random) {
  const Index dealt = random.below(static_cast<std::size_t>(size));
  if (partition == Partition::Dealt) return dealt;
  if (partition == Partition::OneRank) return size - 1;
  return static_cast<int>(number * static_cast<std::size_t>(size) / count);
}

void compare(const std::vector<std::vector<GlobalId>>& found,
             const std::vector<std::vector<GlobalId>>& expected, const std::string& what) {
  if (found == expected) return;
  std::string message = what + ": another result";
  for (std::size_t row = 0; row < std::min(found.size(), expected.size()); ++row) {
    if (found[row] == expected[row]) continue;
    message += "; row " + std::to_string(row) + " has " + std::to_string(found[row].size()) + " instead of " +
               std::to_string(expected[row].size());
    break;
  }
  throw std::runtime_error(message);
}

/// What each rank holds of a node must be where the model has it.
void check_held(const Distributed& search, const Part& part, const std::vector<double>& positions) {
  const std::size_t stride = part.model.mesh.stride;
  std::map<GlobalId, Index> node_of;
  for (std::size_t node = 0; node < part.model.node_id.size(); ++node) {
    node_of[part.model.node_id[node]] = static_cast<Index>(node);
  }
  const Positions held = search.positions();
  const Index count = search.own_nodes() + search.ghost_nodes();
  if (held.count() != at(count)) throw std::runtime_error("another number of held nodes");
  for (Index node = 0; node < count; ++node) {
    const bool own = node < search.own_nodes();
    const GlobalId id = own ? part.node_id[at(node)] : search.ghost_node_ids()[at(node - search.own_nodes())];
    const double* expected = positions.data() + stride * at(node_of.at(id));
    for (int axis = 0; axis < 3; ++axis) {
      if (held[node][axis] == expected[axis] || std::isnan(expected[axis])) continue;
      throw std::runtime_error("a held node is elsewhere");
    }
  }
}

/// Segments of others have the nodes that the model gives them, by global numbers.
void check_segments(const Distributed& search, const Part& part) {
  const HeldSegments& held = search.segments();
  const Model& model = part.model;
  std::map<GlobalId, std::size_t> segment_of;
  for (std::size_t segment = 0; segment < model.segment_id.size(); ++segment) {
    segment_of[model.segment_id[segment]] = segment;
  }
  for (Index segment = 0; segment < held.count(); ++segment) {
    const std::size_t whole = segment_of.at(held.id[at(segment)]);
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const Index node = held.nodes_of(segment)[corner];
      const GlobalId id = node < search.own_nodes() ? part.node_id[at(node)]
                                                    : search.ghost_node_ids()[at(node - search.own_nodes())];
      if (id != model.node_id[at(model.mesh.segments[4 * whole + corner])]) {
        throw std::runtime_error("a held segment has another node");
      }
    }
  }
}

std::vector<double> moved(const std::vector<double>& positions, double step) {
  std::vector<double> result = positions;
  for (std::size_t place = 0; place < result.size(); ++place) {
    result[place] += step * std::sin(static_cast<double>(place));
  }
  return result;
}

std::vector<double> own_of(const Part& part, const std::vector<double>& positions) {
  std::vector<double> own;
  for (const Index node : part.nodes) {
    const double* xyz = positions.data() + part.model.mesh.stride * at(node);
    own.insert(own.end(), xyz, xyz + 3);
  }
  return own;
}

void check_updates(Distributed& search, const Part& part) {
  for (const double step : {0.01, 0.02}) {
    const std::vector<double> whole = moved(part.model.mesh.positions, step);
    const std::vector<double> own = own_of(part, whole);
    search.start_update(Positions(own));
    search.finish_update();
    check_held(search, part, whole);
  }
  // Velocities travel the same way and leave the positions alone.
  const std::vector<double> whole = moved(part.model.mesh.positions, 0.02);
  const std::vector<double> own = own_of(part, moved(part.model.mesh.positions, 7.0));
  std::vector<double> ghosts(3 * at(search.ghost_nodes()));
  search.start_values(Positions(own));
  search.finish_values(ghosts);
  check_held(search, part, whole);
}

Offset check_part(Transport& transport, Distributed& search, const Part& part, const std::string& what) {
  const NodeCandidates& found = search.find(part.scene());
  const auto rows = found_rows(found, search.segments());
  compare(rows, expected_rows(part, Method::BruteForce), what + " against brute force");
  compare(rows, expected_rows(part, Method::Production), what + " against the production method");
  check_held(search, part, part.model.mesh.positions);
  check_segments(search, part);
  check_updates(search, part);
  Offset foreign = 0;
  for (const Index held : found.segment)
    foreign += search.segments().owner[at(held)] != transport.rank() ? 1 : 0;
  return foreign;
}

}  // namespace

Model::Model(scenes::Mesh whole) : mesh(std::move(whole)) {
  scenes::Random random(1);
  number(random, false);
}

Model::Model(std::uint64_t seed) : mesh(scenes::make_mesh(seed)) {
  scenes::Random random(seed + 77);
  const auto by_lot = [&](std::size_t count) { return random.below(count) == 0; };
  exclude_neighbours = by_lot(3);
  if (by_lot(3)) {
    for (std::size_t node = 0; node < mesh.node_count(); ++node) {
      radius.push_back(random.uniform(0.0, 0.3) * mesh.expansion);
    }
  }
  if (by_lot(3)) {
    for (std::size_t segment = 0; segment < mesh.segment_count(); ++segment) {
      active.push_back(by_lot(4) ? std::uint8_t{0} : std::uint8_t{1});
    }
  }
  if (by_lot(3)) {
    groups.count = 3;
    for (std::size_t node = 0; node < mesh.node_count(); ++node) node_group.push_back(random.below(3));
    for (std::size_t segment = 0; segment < mesh.segment_count(); ++segment)
      segment_group.push_back(random.below(3));
    for (int entry = 0; entry < 9; ++entry) allow.push_back(by_lot(3) ? std::uint8_t{0} : std::uint8_t{1});
  }
  number(random, by_lot(2));
}

/// Global numbers with gaps, ascending or not.
void Model::number(scenes::Random& random, bool shuffled) {
  const auto give = [&](std::vector<GlobalId>& ids, std::size_t count, GlobalId first) {
    std::vector<Index> order(count);
    std::iota(order.begin(), order.end(), 0);
    if (shuffled) order = shuffled_numbers(count, random);
    for (const Index place : order) ids.push_back(first + GlobalId{7} * place);
  };
  give(node_id, mesh.node_count(), 5000000000);
  give(segment_id, mesh.segment_count(), 0);
}

Scene Model::scene() const {
  Scene whole = mesh.scene();
  whole.node_radius = radius;
  whole.segment_active = active;
  whole.exclude_neighbours = exclude_neighbours;
  whole.groups = groups;
  whole.groups.node_group = node_group;
  whole.groups.segment_group = segment_group;
  whole.groups.allow = allow;
  return whole;
}

Settings Model::settings() const {
  return {.domain = mesh.domain};
}

Part::Part(const Model& whole, Partition partition, std::uint64_t seed, int rank, int size) : model(whole) {
  scenes::Random random(seed);
  const scenes::Mesh& mesh = model.mesh;
  std::vector<std::set<int>> holders(mesh.node_count());
  for (const Index segment : shuffled_numbers(mesh.segment_count(), random)) {
    const int owner = rank_of(partition, at(segment), mesh.segment_count(), size, random);
    if (owner == rank) segments.push_back(segment);
    for (std::size_t corner = 0; corner < 4; ++corner) {
      holders[at(mesh.segments[4 * at(segment) + corner])].insert(owner);
    }
  }
  std::vector<Index> own_number(mesh.node_count(), -1);
  std::vector<std::uint8_t> takes_part(mesh.node_count(), mesh.nodes ? 0 : 1);
  if (mesh.nodes) {
    for (const Index node : *mesh.nodes) takes_part[at(node)] = 1;
  }
  for (const Index node : shuffled_numbers(mesh.node_count(), random)) {
    const int lone = rank_of(partition, at(node), mesh.node_count(), size, random);
    std::set<int>& ranks = holders[at(node)];
    if (ranks.empty()) ranks.insert(lone);
    if (ranks.count(rank) == 0) continue;
    own_number[at(node)] = static_cast<Index>(nodes.size());
    if (*ranks.begin() == rank && takes_part[at(node)] != 0) participants.push_back(own_number[at(node)]);
    nodes.push_back(node);
    node_id.push_back(model.node_id[at(node)]);
    const double* xyz = mesh.positions.data() + mesh.stride * at(node);
    positions.insert(positions.end(), xyz, xyz + 3);
    if (!model.radius.empty()) radius.push_back(model.radius[at(node)]);
    if (model.groups.count > 0) node_group.push_back(model.node_group[at(node)]);
  }
  for (const Index segment : segments) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      connectivity.push_back(own_number[at(mesh.segments[4 * at(segment) + corner])]);
    }
    segment_id.push_back(model.segment_id[at(segment)]);
    if (!mesh.segment_expansion.empty()) segment_expansion.push_back(mesh.segment_expansion[at(segment)]);
    if (!model.active.empty()) active.push_back(model.active[at(segment)]);
    if (model.groups.count > 0) segment_group.push_back(model.segment_group[at(segment)]);
  }
}

RankScene Part::scene() const {
  RankScene own;
  own.scene.positions = Positions(positions);
  own.scene.segments = Segments(connectivity);
  own.scene.expansion = model.mesh.expansion;
  own.scene.segment_expansion = segment_expansion;
  own.scene.nodes = std::span<const Index>(participants);
  own.scene.node_radius = radius;
  own.scene.segment_active = active;
  own.scene.exclude_neighbours = model.exclude_neighbours;
  own.scene.groups = {model.groups.count, node_group, segment_group, model.allow};
  own.node_id = node_id;
  own.segment_id = segment_id;
  return own;
}

std::vector<std::vector<GlobalId>> expected_rows(const Part& part, Method method) {
  const Model& model = part.model;
  Settings settings = model.settings();
  settings.method = method;
  Search search(settings);
  const Candidates& found = search.find(model.scene());
  std::vector<std::vector<GlobalId>> by_node(model.mesh.node_count());
  for (Index segment = 0; segment < found.segments(); ++segment) {
    for (const Index node : found.of(segment)) by_node[at(node)].push_back(model.segment_id[at(segment)]);
  }
  std::vector<std::vector<GlobalId>> rows;
  for (const Index own : part.participants) {
    rows.push_back(by_node[at(part.nodes[at(own)])]);
    std::sort(rows.back().begin(), rows.back().end());
  }
  return rows;
}

std::vector<std::vector<GlobalId>> found_rows(const NodeCandidates& found, const HeldSegments& segments) {
  std::vector<std::vector<GlobalId>> rows;
  for (Index row = 0; row < found.rows(); ++row) {
    rows.emplace_back();
    for (const Index held : found.of(row)) rows.back().push_back(segments.id[at(held)]);
  }
  return rows;
}

void check_model(Transport& transport, const Model& model, Partition partition, std::uint64_t seed) {
  const Part part(model, partition, seed, transport.rank(), transport.size());
  Distributed search(transport, model.settings());
  check_part(transport, search, part, model.mesh.name);
}

Offset check_models(Transport& transport, std::uint64_t begin, std::uint64_t end) {
  Distributed kept(transport);
  std::array<Offset, 1> foreign{};
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    const Model model(seed);
    for (const Partition partition : {Partition::Dealt, Partition::Slabs, Partition::OneRank}) {
      const Part part(model, partition, seed, transport.rank(), transport.size());
      const std::string what = "model " + std::to_string(seed) + " (" + model.mesh.name + "), partition " +
                               std::to_string(static_cast<int>(partition)) + ", rank " +
                               std::to_string(transport.rank()) + " of " + std::to_string(transport.size());
      if (model.mesh.domain) {
        Distributed own(transport, model.settings());
        foreign[0] += check_part(transport, own, part, what);
      } else {
        foreign[0] += check_part(transport, kept, part, what);
      }
    }
  }
  transport.allreduce(Reduction::Sum, foreign);
  return foreign[0];
}

}  // namespace cellsearch::distributed_checks
