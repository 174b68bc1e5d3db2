// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "cellsearch/distributed/distributed.hpp"
#include "cellsearch/distributed/solo_transport.hpp"
#include "cellsearch/distributed/thread_transport.hpp"
#include "cellsearch/error.hpp"

namespace cellsearch::distributed_error_test {
namespace {

/// Rank r of three has the unit square z = 0.1 r with nodes and segment of its own; rank 2 shares node 0 of
/// rank 0.
struct Square {
  explicit Square(int rank) {
    const double z = 0.1 * rank;
    positions = {0, 0, z, 1, 0, z, 1, 1, z, 0, 1, z};
    connectivity = {0, 1, 2, 3};
    for (int node = 0; node < 4; ++node) node_id.push_back(10 * rank + node);
    segment_id = {rank};
    if (rank == 2) {
      positions.insert(positions.end(), {0, 0, 0});
      node_id.push_back(0);
    }
  }

  RankScene scene() const {
    RankScene own;
    own.scene.positions = Positions(positions);
    own.scene.segments = Segments(connectivity);
    own.scene.expansion = expansion;
    own.node_id = node_id;
    own.segment_id = segment_id;
    return own;
  }

  std::vector<double> positions;
  std::vector<Index> connectivity;
  std::vector<GlobalId> node_id;
  std::vector<GlobalId> segment_id;
  double expansion = 0.15;
};

struct Thrown {
  bool error = false;
  ErrorKind kind = ErrorKind::BadLayout;
  Index index = -2;
  std::string message{};
};

/// What each rank throws if rank 1 brings what `spoil` makes of its square. Afterwards all must be able to
/// search.
std::array<Thrown, 3> thrown_by_all(const std::function<void(Square&)>& spoil) {
  std::array<Thrown, 3> thrown;
  ThreadRanks hub(3);
  hub.run([&](Transport& transport) {
    Distributed search(transport);
    Square square(transport.rank());
    if (transport.rank() == 1) spoil(square);
    try {
      search.find(square.scene());
    } catch (const Error& error) {
      thrown[static_cast<std::size_t>(transport.rank())] = {true, error.kind(), error.index(), error.what()};
      EXPECT_THROW(search.update(Positions(square.positions)), Error) << "there is nothing to update";
    }
    const Square good(transport.rank());
    const NodeCandidates& found = search.find(good.scene());
    EXPECT_EQ(found.pairs(), transport.rank() == 1 ? 8 : 4 + (transport.rank() == 2 ? 1 : 0));
  });
  return thrown;
}

/// All throw, rank 1 with the place.
void expect_on_all(const std::array<Thrown, 3>& thrown, ErrorKind kind, Index index) {
  for (std::size_t rank = 0; rank < 3; ++rank) {
    EXPECT_TRUE(thrown[rank].error) << rank;
    EXPECT_EQ(thrown[rank].kind, kind) << rank;
    EXPECT_EQ(thrown[rank].index, rank == 1 ? index : -1) << rank;
  }
  EXPECT_EQ(thrown[0].message, "Rank 1: " + thrown[1].message);
}

TEST(DistributedErrors, BadInputOfOneRankIsAnErrorOfAll) {
  expect_on_all(
      thrown_by_all([](Square& square) { square.positions[7] = std::numeric_limits<double>::quiet_NaN(); }),
      ErrorKind::NonFiniteCoordinate, 2);
  expect_on_all(thrown_by_all([](Square& square) { square.connectivity[2] = 4; }), ErrorKind::BadConnectivity,
                0);
  expect_on_all(thrown_by_all([](Square& square) { square.node_id.pop_back(); }), ErrorKind::BadLayout, -1);
  expect_on_all(thrown_by_all([](Square& square) { square.segment_id.clear(); }), ErrorKind::BadLayout, -1);
  expect_on_all(thrown_by_all([](Square& square) { square.node_id[2] = -1; }), ErrorKind::BadNodeId, 2);
  expect_on_all(thrown_by_all([](Square& square) { square.node_id[3] = 10; }), ErrorKind::BadNodeId, 3);
  expect_on_all(thrown_by_all([](Square& square) { square.segment_id[0] = -7; }), ErrorKind::BadSegmentId, 0);
}

TEST(DistributedErrors, RanksMustAgreeOnWhatIsCommon) {
  const std::array<Thrown, 3> thrown = thrown_by_all([](Square& square) { square.expansion = 0.2; });
  for (const Thrown& each : thrown) {
    EXPECT_EQ(each.kind, ErrorKind::BadSetting);
    EXPECT_EQ(
        each.message,
        "Rank 1 has another expansion, exclusion of neighbours, matrix of groups or domain than rank 0.");
  }
}

TEST(DistributedErrors, ASegmentNumberOnTwoRanksIsFound) {
  const std::array<Thrown, 3> thrown = thrown_by_all([](Square& square) { square.segment_id[0] = 2; });
  for (const Thrown& each : thrown) {
    EXPECT_TRUE(each.error);
    EXPECT_EQ(each.kind, ErrorKind::BadSegmentId);
  }
}

TEST(DistributedErrors, ASharedNodeMustBeAtOnePlace) {
  // Node 0 is held by ranks 0 and 2 at (0, 0, 0); here by rank 1 at (0, 0, 0.1), too.
  const std::array<Thrown, 3> thrown = thrown_by_all([](Square& square) { square.node_id[0] = 0; });
  for (const Thrown& each : thrown) {
    EXPECT_TRUE(each.error);
    EXPECT_EQ(each.kind, ErrorKind::BadNodeId);
  }
  EXPECT_NE(thrown[1].message.find("has other coordinates on rank 0 than on rank 1"), std::string::npos)
      << thrown[1].message;
}

TEST(DistributedErrors, NothingAtAllIsAnError) {
  ThreadRanks hub(2);
  hub.run([](Transport& transport) {
    Distributed search(transport);
    try {
      search.find(RankScene{});
      ADD_FAILURE() << "no rank has a node";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::EmptyInput);
    }
  });
}

TEST(DistributedErrors, RefusesNbs) {
  SoloTransport transport;
  EXPECT_THROW(Distributed(transport, {.method = Method::Nbs}), Error);
}

TEST(DistributedErrors, UpdatesNeedTheNodesOfTheSearch) {
  SoloTransport transport;
  Distributed search(transport);
  const Square square(0);
  EXPECT_THROW(search.update(Positions(square.positions)), Error) << "before the first search";
  search.find(square.scene());
  EXPECT_NO_THROW(search.update(Positions(square.positions)));
  EXPECT_THROW(search.update(Positions(std::span(square.positions).first(9))), Error);
  std::array<double, 3> ghosts{};
  search.start_values(Positions(square.positions));
  EXPECT_THROW(search.finish_values(ghosts), Error) << "there is no ghost";
}

// What is no matter of input: the others must not wait for ever.
TEST(DistributedErrors, ARankThatLeavesEndsAll) {
  ThreadRanks hub(3);
  EXPECT_THROW(hub.run([](Transport& transport) {
    Distributed search(transport);
    const Square square(transport.rank());
    search.find(square.scene());
    if (transport.rank() == 2) throw std::domain_error("a wheel came off");
    search.find(square.scene());
  }),
               std::domain_error);
}

}  // namespace
}  // namespace cellsearch::distributed_error_test
