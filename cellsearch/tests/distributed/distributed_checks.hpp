// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "cellsearch/distributed/distributed.hpp"
#include "scenes.hpp"

namespace cellsearch::distributed_checks {

/// How a model is divided among ranks.
enum class Partition {
  Dealt,    ///< each segment and each lone node by lot: every box covers everything
  Slabs,    ///< in runs of their numbers
  OneRank,  ///< all on the last rank, the others are empty
};

/// A whole model with filters drawn by lot, which every rank makes for itself.
struct Model {
  /// `seed`: of scenes::make_mesh and of the filters.
  explicit Model(std::uint64_t seed);
  explicit Model(scenes::Mesh whole);

  /// The whole of it, as one scene.
  Scene scene() const;
  Settings settings() const;

  scenes::Mesh mesh;
  std::vector<double> radius{};
  std::vector<std::uint8_t> active{};
  bool exclude_neighbours = false;
  Groups groups{};
  std::vector<Index> node_group{};
  std::vector<Index> segment_group{};
  std::vector<std::uint8_t> allow{};
  std::vector<GlobalId> node_id{};
  std::vector<GlobalId> segment_id{};

 private:
  void number(scenes::Random& random, bool shuffled);
};

/// One rank's part of it.
struct Part {
  Part(const Model& whole, Partition partition, std::uint64_t seed, int rank, int size);

  /// Views of this part.
  RankScene scene() const;

  const Model& model;
  std::vector<Index> nodes;         ///< in the model, in the order of this rank, which is no order
  std::vector<Index> segments;      ///< likewise
  std::vector<Index> participants;  ///< own numbers
  std::vector<double> positions;
  std::vector<Index> connectivity;
  std::vector<double> segment_expansion;
  std::vector<double> radius;
  std::vector<std::uint8_t> active;
  std::vector<Index> node_group;
  std::vector<Index> segment_group;
  std::vector<GlobalId> node_id;
  std::vector<GlobalId> segment_id;
};

/// The rows of a part by global numbers: what a search of the whole by `method` says of its participants.
std::vector<std::vector<GlobalId>> expected_rows(const Part& part, Method method);

/// The rows that were found, by global numbers.
std::vector<std::vector<GlobalId>> found_rows(const NodeCandidates& found, const HeldSegments& segments);

/// Finds candidates on all ranks and compares with the production method and brute force on the whole; moves
/// the nodes twice and compares what ranks hold of others. Throws std::runtime_error on a difference.
void check_model(Transport& transport, const Model& model, Partition partition, std::uint64_t seed);

/// The same for the models of seeds begin..end-1 and all partitions, with one search object. Returns the
/// number of pairs whose segment is another rank's.
Offset check_models(Transport& transport, std::uint64_t begin, std::uint64_t end);

}  // namespace cellsearch::distributed_checks
