// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/distributed/distributed.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cellsearch/distributed/solo_transport.hpp"
#include "cellsearch/distributed/thread_transport.hpp"
#include "distributed_checks.hpp"

namespace cellsearch::distributed_test {
namespace {

using distributed_checks::Model;
using distributed_checks::Partition;

// Among the models are degenerate ones of all kinds (scenes::make_mesh), with filters of all kinds.
TEST(Distributed, FindsWhatOneSearchOfTheWholeFinds) {
  for (const int ranks : {1, 2, 3, 4, 7}) {
    ThreadRanks hub(ranks, ranks == 3 ? std::optional<std::uint64_t>{} : std::optional<std::uint64_t>{5});
    hub.run([&](Transport& transport) {
      const Offset foreign = distributed_checks::check_models(transport, 0, 40);
      if (ranks > 1) {
        EXPECT_GT(foreign, 1000) << "pairs of nodes and segments of different ranks";
      }
    });
  }
}

TEST(Distributed, FindsWhatOneSearchOfTheWholeFindsInHundredsOfModelsNightly) {
  for (const int ranks : {2, 4, 5}) {
    ThreadRanks hub(ranks, 9);
    hub.run([](Transport& transport) { distributed_checks::check_models(transport, 40, 400); });
  }
}

TEST(Distributed, NeedsNoOtherRank) {
  SoloTransport transport;
  EXPECT_EQ(distributed_checks::check_models(transport, 0, 20), 0);
}

TEST(Distributed, AgreesOnScenesOfTheBenchmarks) {
  for (const scenes::Family& family : scenes::families()) {
    const Model model(family.make(4000, 3));
    ThreadRanks hub(4, 2);
    hub.run([&](Transport& transport) {
      distributed_checks::check_model(transport, model, Partition::Slabs, 1);
      distributed_checks::check_model(transport, model, Partition::Dealt, 1);
    });
  }
}

/// n x n x n unit squares, each the floor of a unit cube.
scenes::Mesh lattice(Index n) {
  scenes::Mesh mesh;
  mesh.name = "lattice";
  mesh.expansion = 0.4;
  const auto node = [&](Index x, Index y, Index z) { return (z * (n + 1) + y) * (n + 1) + x; };
  for (Index z = 0; z < n; ++z) {
    for (Index y = 0; y <= n; ++y) {
      for (Index x = 0; x <= n; ++x) mesh.add_node(x, y, z);
    }
  }
  for (Index z = 0; z < n; ++z) {
    for (Index y = 0; y < n; ++y) {
      for (Index x = 0; x < n; ++x) {
        mesh.add_segment(node(x, y, z), node(x + 1, y, z), node(x + 1, y + 1, z), node(x, y + 1, z));
      }
    }
  }
  return mesh;
}

/// The octant `rank` of a lattice: its own segments, and all their nodes.
struct Octant {
  Octant(const scenes::Mesh& mesh, Index n, int rank) {
    std::vector<Index> own(mesh.node_count(), -1);
    for (std::size_t segment = 0; segment < mesh.segment_count(); ++segment) {
      const auto cell = static_cast<Index>(segment);
      const std::array<Index, 3> place{cell % n, cell / n % n, cell / (n * n)};
      int octant = 0;
      for (int axis = 0; axis < 3; ++axis)
        octant += place[static_cast<std::size_t>(axis)] < n / 2 ? 0 : 1 << axis;
      if (octant != rank) continue;
      segment_id.push_back(static_cast<GlobalId>(segment));
      for (std::size_t corner = 0; corner < 4; ++corner) {
        const Index node = mesh.segments[4 * segment + corner];
        if (own[static_cast<std::size_t>(node)] < 0) {
          own[static_cast<std::size_t>(node)] = static_cast<Index>(node_id.size());
          node_id.push_back(node);
          const double* xyz = mesh.positions.data() + 3 * static_cast<std::size_t>(node);
          positions.insert(positions.end(), xyz, xyz + 3);
        }
        connectivity.push_back(own[static_cast<std::size_t>(node)]);
      }
    }
    scene.scene.positions = Positions(positions);
    scene.scene.segments = Segments(connectivity);
    scene.scene.expansion = mesh.expansion;
    scene.node_id = node_id;
    scene.segment_id = segment_id;
  }

  std::vector<double> positions;
  std::vector<Index> connectivity;
  std::vector<GlobalId> node_id;
  std::vector<GlobalId> segment_id;
  RankScene scene;
};

/// What the rank of the lowest octant exchanges.
DistributedStatistics statistics_of(Index n,
                                    const std::function<void(Distributed&, const RankScene&)>& then) {
  DistributedStatistics result;
  const scenes::Mesh mesh = lattice(n);
  ThreadRanks hub(8);
  hub.run([&](Transport& transport) {
    const Octant octant(mesh, n, transport.rank());
    Distributed search(transport);
    search.find(octant.scene);
    then(search, octant.scene);
    if (transport.rank() == 0) result = search.statistics();
  });
  return result;
}

// The box around the nodes of the lowest octant is m x m x (m - 1), m = n / 2. A square of another rank
// touches it, expanded by 0.4, if it shares the plane x = m or y = m with it; the layer z = m is 1 above the
// highest node.
TEST(Distributed, ExchangesWhatIsNearTheSurfaceOfBoxes) {
  for (const Index n : {8, 16, 32}) {
    const Index m = n / 2;
    const DistributedStatistics counts = statistics_of(n, [](Distributed&, const RankScene&) {});
    EXPECT_EQ(counts.ghost_segments, m * (2 * m + 1)) << n;
    // Nodes of a layer at x = m + 1 and at y = m + 1, which meet in one; those up to m are held already.
    EXPECT_EQ(counts.ghost_nodes, m * (2 * (m + 2) - 1)) << n;
  }
}

TEST(Distributed, SendsAsManyBytesAsItSays) {
  const Index n = 8;
  const DistributedStatistics counts = statistics_of(n, [](Distributed& search, const RankScene& own) {
    for (int step = 0; step < 3; ++step) search.update(own.scene.positions);
  });
  // Beside the message of each round to each neighbour: 512 bytes of footprint; 16 of header, 28 a segment,
  // 32 a node; 4 a wish.
  const Offset wishes = counts.ghost_nodes;
  EXPECT_EQ(counts.search.messages, 2 * counts.ranks_received_from + counts.ranks_sent_to);
  EXPECT_EQ(counts.search.bytes, 512 * counts.ranks_received_from + 16 * counts.ranks_sent_to +
                                     28 * counts.sent_segments + 32 * counts.sent_nodes + 4 * wishes);
  EXPECT_EQ(counts.search.gathers, 1);
  EXPECT_EQ(counts.search.bytes_given, 128);
  EXPECT_EQ(counts.search.reductions, 1);
  // Coordinates alone.
  EXPECT_EQ(counts.updates.bytes, 3 * 24 * counts.followed_nodes);
  EXPECT_LE(counts.updates.messages, 3 * counts.ranks_sent_to);
  EXPECT_GT(counts.followed_nodes, 0);
  EXPECT_LT(counts.followed_nodes, counts.sent_nodes) << "nodes that the receiver holds need not follow";
}

// A small plate in the middle of a large ring of nodes, far from all of them: the box of the ring holds the
// plate.
TEST(Distributed, SendsNothingIntoTheEmptyMiddleOfABox) {
  ThreadRanks hub(2);
  hub.run([](Transport& transport) {
    std::vector<double> positions;
    std::vector<Index> segments;
    std::vector<GlobalId> node_id;
    if (transport.rank() == 0) {
      for (int node = 0; node < 100; ++node) {
        const double angle = 0.0628 * node;
        positions.insert(positions.end(), {10.0 * std::cos(angle), 10.0 * std::sin(angle), 0.01 * node});
        node_id.push_back(node);
      }
    } else {
      positions = {0, 0, 0.5, 1, 0, 0.5, 1, 1, 0.5, 0, 1, 0.5};
      segments = {0, 1, 2, 3};
      node_id = {100, 101, 102, 103};
    }
    const std::vector<GlobalId> segment_id(segments.size() / 4, 0);
    RankScene own;
    own.scene.positions = Positions(positions);
    own.scene.segments = Segments(segments);
    own.scene.expansion = 0.5;
    own.node_id = node_id;
    own.segment_id = segment_id;
    Distributed search(transport);
    search.find(own);
    const DistributedStatistics& counts = search.statistics();
    EXPECT_EQ(counts.ranks_sent_to, transport.rank()) << "the boxes touch";
    EXPECT_EQ(counts.sent_segments, 0);
    EXPECT_EQ(counts.ghost_segments, 0);
  });
}

}  // namespace
}  // namespace cellsearch::distributed_test
