// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/motion_tracker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "cellsearch/box.hpp"
#include "cellsearch/error.hpp"
#include "cellsearch/search.hpp"
#include "cellsearch/search_interval.hpp"
#include "scenes.hpp"

namespace cellsearch::motion_tracker_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> random_points(int count, std::uint64_t seed) {
  scenes::Random random(seed);
  std::vector<double> points(3 * static_cast<std::size_t>(count));
  for (double& x : points) x = random.uniform(-5.0, 5.0);
  return points;
}

template <class Call>
void expect_error(ErrorKind kind, Index index, const Call& call) {
  try {
    call();
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_EQ(error.index(), index) << error.what();
    if (index >= 0) {
      EXPECT_NE(std::string(error.what()).find(std::to_string(index)), std::string::npos) << error.what();
    }
  }
}

TEST(MotionTracker, IsDueUntilItIsStarted) {
  MotionTracker tracker(2.0, 0.5);
  const std::vector<double> points{0, 0, 0};
  EXPECT_TRUE(tracker.due());
  tracker.update(Positions(points));
  EXPECT_TRUE(tracker.due());
  EXPECT_EQ(tracker.used(), infinity);
  EXPECT_EQ(tracker.predicted_steps(Positions(points), 1.0, 10), 1);
  tracker.start(Positions(points));
  EXPECT_FALSE(tracker.due());
  EXPECT_EQ(tracker.used(), 0.0);
  EXPECT_EQ(tracker.room(), 1.5);
  EXPECT_EQ(tracker.left(), 1.5);
}

// Numbers that are exact in binary: nothing is used up, not even a rounding error.
TEST(MotionTracker, UsesUpNothingInARigidTranslation) {
  std::vector<double> points = random_points(2000, 1);
  for (double& x : points) x = std::floor(x * 1024) / 1024;
  MotionTracker tracker(0.25, 0.125);
  tracker.start(Positions(points));
  for (int step = 0; step < 50; ++step) {
    for (std::size_t i = 0; i < points.size(); ++i) points[i] += std::array{3.5, -40.25, 700.0}[i % 3];
    tracker.update(Positions(points));
    EXPECT_EQ(tracker.motion(), (Point{0.0, 0.0, 0.0}));
    EXPECT_FALSE(tracker.due());
  }
}

// A ring of radius r about the z axis, turned by an angle a: displacements lie on a circle of radius
// 2 r sin(a/2), so their range is twice that along x and y, and nothing along z.
TEST(MotionTracker, MeasuresARotation) {
  constexpr int count = 720;
  constexpr double radius = 3.0;
  const auto ring = [&](double turned) {
    std::vector<double> points;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / count + turned;
      points.insert(points.end(), {radius * std::cos(angle), radius * std::sin(angle), 7.0});
    }
    return points;
  };
  const std::vector<double> start = ring(0.0);
  MotionTracker tracker(1.0, 0.0);
  tracker.start(Positions(start));
  for (const double angle : {0.01, 0.1, 0.16, 0.17, 1.0}) {
    const std::vector<double> now = ring(angle);
    tracker.update(Positions(now));
    const double expected = 4.0 * radius * std::sin(0.5 * angle);
    // The ring's nodes are half a degree apart, so the extreme displacement is met to 1 - cos(0.25 degrees).
    EXPECT_NEAR(tracker.motion()[0], expected, 1e-5 * expected);
    EXPECT_NEAR(tracker.motion()[1], expected, 1e-5 * expected);
    EXPECT_EQ(tracker.motion()[2], 0.0);
    EXPECT_EQ(tracker.used(), std::max(tracker.motion()[0], tracker.motion()[1]));
    EXPECT_EQ(tracker.due(), expected > 1.0);
  }
}

TEST(MotionTracker, NoticesOneNodeThatRunsAway) {
  std::vector<double> points = random_points(20000, 3);
  MotionTracker tracker(1.0, 0.5, 3);
  tracker.start(Positions(points));
  points[3 * 17171 + 1] -= 0.375;
  tracker.update(Positions(points));
  EXPECT_NEAR(tracker.used(), 0.375, 1e-14);
  EXPECT_NEAR(tracker.left(), 0.125, 1e-14);
  EXPECT_FALSE(tracker.due());
  points[3 * 17171 + 1] -= 0.375;
  tracker.update(Positions(points));
  EXPECT_NEAR(tracker.left(), -0.25, 1e-14);
  EXPECT_TRUE(tracker.due());
  points[3 * 17171 + 1] += 0.375;  // what counts is where nodes are, not how far they went
  tracker.update(Positions(points));
  EXPECT_FALSE(tracker.due());
}

TEST(MotionTracker, WatchesListedNodesOnlyAndReadsRecords) {
  std::vector<double> records(8 * 5, nan);
  for (const std::size_t node : {1U, 3U}) {
    for (std::size_t axis = 0; axis < 3; ++axis) records[8 * node + axis] = 1.0;
  }
  const std::vector<Index> nodes{3, 1};
  MotionTracker tracker(1.0, 0.0);
  tracker.start(Positions(records, 8), nodes);
  records[8 * 3 + 2] = 1.5;
  tracker.update(Positions(records, 8));
  EXPECT_EQ(tracker.motion(), (Point{0.0, 0.0, 0.5}));
}

// Nodes against segments of the other surface: motion within a surface costs nothing.
TEST(MotionTracker, ComparesTwoSurfacesWithEachOther) {
  std::vector<double> points{0, 0, 0, 1, 0, 0, 0, 0, 5, 1, 0, 5};
  const std::vector<Index> nodes{2, 3};
  const std::vector<Index> segment_nodes{0, 1};
  const std::vector<Index> all{0, 1, 2, 3};
  MotionTracker two(1.0, 0.0);
  MotionTracker one(1.0, 0.0);
  two.start(Positions(points), nodes, segment_nodes);
  one.start(Positions(points), all);
  points[3 * 2] += 0.75;  // the nodes' surface stretches to both sides
  points[3 * 3] -= 0.5;
  two.update(Positions(points));
  one.update(Positions(points));
  EXPECT_EQ(two.motion(), (Point{0.75, 0.0, 0.0}));
  EXPECT_EQ(one.motion(), (Point{1.25, 0.0, 0.0}));
  points[3 * 0] -= 0.25;  // the other one comes along to one side
  two.update(Positions(points));
  EXPECT_EQ(two.motion(), (Point{1.0, 0.0, 0.0}));
  points[3 * 3] -= 3.0;  // now the nodes' surface leads to the other side
  two.update(Positions(points));
  EXPECT_EQ(two.motion(), (Point{3.5, 0.0, 0.0}));
  two.start(Positions(points), nodes, {});
  points[3 * 3] -= 100.0;
  two.update(Positions(points));
  EXPECT_EQ(two.used(), 0.0);  // nobody to meet
}

TEST(MotionTracker, WatchesWhatASceneLooksAt) {
  // Nodes 0 to 3 and 4 to 7 are segments, the second one eroded; node 8 is free.
  std::vector<double> points(3 * 9, 1.0);
  const std::vector<Index> connectivity{0, 1, 2, 3, 4, 5, 6, 7};
  const std::vector<std::uint8_t> active{1, 0};
  const std::vector<Index> listed{8};
  Scene scene;
  scene.positions = Positions(points);
  scene.segments = Segments(connectivity);
  scene.segment_active = active;
  scene.nodes = listed;
  const auto used_when = [&](std::size_t node, MotionTracker& tracker) {
    points[3 * node] += 0.5;
    tracker.update(scene.positions);
    points[3 * node] -= 0.5;
    return tracker.used();
  };
  MotionTracker tracker(1.0, 0.0);
  tracker.start(scene);
  EXPECT_EQ(used_when(3, tracker), 0.5);
  EXPECT_EQ(used_when(5, tracker), 0.0);  // belongs to no segment any more and is not listed
  EXPECT_EQ(used_when(8, tracker), 0.5);
  scene.nodes.reset();
  tracker.start(scene);
  EXPECT_EQ(used_when(5, tracker), 0.5);
  scene.nodes = listed;
  const std::vector<Index> beyond{0, 1, 2, 9, 4, 5, 6, 7};
  scene.segments = Segments(beyond);
  expect_error(ErrorKind::BadConnectivity, 0, [&] { tracker.start(scene); });
  EXPECT_TRUE(tracker.due());
}

// The bound is sharp. A unit square, c = 0.5, h = 0.125: a node just outside the territory moves down by
// hardly more than c - h and is then in contact without being a candidate; a hair less, and the tracker
// rightly lets the candidates stand.
TEST(MotionTracker, IsDueExactlyWhenAPairCanBeMissed) {
  constexpr double c = 0.5;
  constexpr double h = 0.125;
  constexpr double hair = 1e-13;
  const std::vector<Index> connectivity{0, 1, 2, 3};
  const auto points = [](double z) {
    return std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, z};
  };
  const auto closer_than = [&](double distance, const std::vector<double>& at) {
    Scene scene;
    scene.positions = Positions(at);
    scene.segments = Segments(connectivity);
    scene.expansion = distance;
    return Search({.method = Method::BruteForce}).find(scene).pairs() == 1;
  };
  for (const bool inside : {true, false}) {
    const std::vector<double> start = points(inside ? c : c + hair);
    const bool candidate = closer_than(c, start);
    EXPECT_EQ(candidate, inside);
    MotionTracker tracker(c, h);
    tracker.start(Positions(start));
    const std::vector<double> before = points(h + 2 * hair);
    tracker.update(Positions(before));
    EXPECT_FALSE(tracker.due());
    EXPECT_FALSE(closer_than(h, before));
    const std::vector<double> after = points(h);
    tracker.update(Positions(after));
    EXPECT_TRUE(closer_than(h, after));
    // Outside, the pair is missed: the tracker must say so. Inside, it is at the limit, where it may.
    if (!inside) {
      EXPECT_TRUE(tracker.due());
    }
  }
}

TEST(MotionTracker, KeepsAMarginForRounding) {
  // At coordinates of 1e9 a unit in the last place is 1.2e-7: a room below that is none.
  const std::vector<double> points{1e9, 0, 0, 1e9, 1, 0};
  MotionTracker tracker(1e-7, 0.0);
  tracker.start(Positions(points));
  EXPECT_TRUE(tracker.due());
  MotionTracker wide(1e-2, 0.0);
  wide.start(Positions(points));
  EXPECT_FALSE(wide.due());
}

TEST(MotionTracker, PredictsByEquation10) {
  const std::vector<double> points = random_points(3, 1);
  const std::vector<double> velocities{10.0, 0.25, 0.0, 10.5, 0.0, 0.0, 10.25, 0.125, 0.0};
  MotionTracker tracker(2.75, 0.25);
  tracker.start(Positions(points));
  EXPECT_EQ(tracker.relative_speed(Positions(velocities)), (Point{0.5, 0.25, 0.0}));
  EXPECT_EQ(tracker.predicted_steps(Positions(velocities), 0.25, 100), 20);
  EXPECT_EQ(tracker.predicted_steps(Positions(velocities), 0.25, 100),
            search_interval(2.75, 0.25, 0.5, 0.25, 100));
  EXPECT_EQ(tracker.predicted_steps(Positions(velocities), 0.25, 7), 7);
  std::vector<double> now = points;
  now[0] += 1.25;  // half of the room
  tracker.update(Positions(now));
  EXPECT_EQ(tracker.predicted_steps(Positions(velocities), 0.25, 100), 10);
  const std::vector<double> common(9, 4.0);
  EXPECT_EQ(tracker.predicted_steps(Positions(common), 0.25, 100), 100);
  std::vector<double> unknown = velocities;
  unknown[4] = nan;
  EXPECT_TRUE(std::isnan(tracker.relative_speed(Positions(unknown))[0]));
  EXPECT_EQ(tracker.predicted_steps(Positions(unknown), 0.25, 100), 1);
}

TEST(MotionTracker, NamesTheFirstNodeThatIsNotFinite) {
  const std::vector<double> good = random_points(9000, 1);
  for (const int threads : {1, 4}) {
    for (const double wrong : {nan, infinity, -infinity}) {
      MotionTracker tracker(1.0, 0.5, threads);
      tracker.start(Positions(good));
      std::vector<double> bad = good;
      bad[3 * 8000] = wrong;
      bad[3 * 7321 + 2] = wrong;
      expect_error(ErrorKind::NonFiniteCoordinate, 7321, [&] { tracker.update(Positions(bad)); });
      EXPECT_TRUE(tracker.due());
      EXPECT_EQ(tracker.used(), infinity);
      tracker.update(Positions(good));
      EXPECT_FALSE(tracker.due());
      expect_error(ErrorKind::NonFiniteCoordinate, 7321, [&] { tracker.start(Positions(bad)); });
      EXPECT_TRUE(tracker.due());
      tracker.update(Positions(good));
      EXPECT_TRUE(tracker.due());
    }
  }
}

TEST(MotionTracker, RefusesWhatDoesNotFit) {
  const std::vector<double> points = random_points(10, 1);
  for (const double wrong : {nan, infinity, -1.0}) {
    expect_error(ErrorKind::BadSetting, -1, [&] { MotionTracker(wrong, 0.0); });
    expect_error(ErrorKind::BadSetting, -1, [&] { MotionTracker(1.0, wrong); });
  }
  expect_error(ErrorKind::BadSetting, -1, [] { MotionTracker(1.0, 0.5, 0); });
  MotionTracker tracker(1.0, 0.5);
  const std::vector<Index> beyond{2, 10, -1};
  const std::vector<Index> first{0};
  expect_error(ErrorKind::BadNodeList, 1, [&] { tracker.start(Positions(points), beyond); });
  expect_error(ErrorKind::BadNodeList, 2, [&] { tracker.start(Positions(points), first, beyond); });
  EXPECT_TRUE(tracker.due());
  tracker.start(Positions(points));
  const std::span<const double> fewer(points.data(), 27);
  expect_error(ErrorKind::BadLayout, -1, [&] { tracker.update(Positions(fewer)); });
  EXPECT_TRUE(tracker.due());
  expect_error(ErrorKind::BadLayout, -1, [&] { tracker.relative_speed(Positions(fewer)); });
  // Nodes may be added behind the watched ones.
  const std::vector<double> more = random_points(11, 1);
  tracker.update(Positions(more));
  EXPECT_FALSE(tracker.due());
}

TEST(MotionTracker, IsDueWhereNothingIsLeftToMove) {
  const std::vector<double> points = random_points(10, 1);
  for (const double distance : {1.0, 2.0}) {
    MotionTracker tracker(1.0, distance);
    tracker.start(Positions(points));
    EXPECT_TRUE(tracker.due());
  }
}

TEST(MotionTracker, SurvivesDisplacementsBeyondTheRangeOfNumbers) {
  std::vector<double> points{1.5e308, 0, 0, 0, 0, 0};
  MotionTracker tracker(1.0, 0.0);
  tracker.start(Positions(points));
  points[0] = -1.5e308;
  EXPECT_NO_THROW(tracker.update(Positions(points)));
  EXPECT_TRUE(tracker.due());
}

TEST(MotionTracker, RemembersAcrossARestart) {
  const std::vector<double> start = random_points(100, 1);
  const std::vector<double> now = random_points(100, 2);
  MotionTracker tracker(1.0, 0.0);
  tracker.start(Positions(start));
  const std::vector<double> kept(tracker.reference().begin(), tracker.reference().end());
  EXPECT_EQ(kept, start);
  tracker.update(Positions(now));
  MotionTracker other(1.0, 0.0);
  other.start(Positions(now));
  std::copy(kept.begin(), kept.end(), other.reference().begin());
  other.update(Positions(now));
  EXPECT_EQ(other.motion(), tracker.motion());
}

// Nodes that follow each other by number are read in one go: any mixture of runs, odd or even, of records of
// any length, must give what one node at a time gives.
TEST(MotionTracker, RunsOfNodesChangeNothing) {
  const std::vector<double> before = random_points(60, 1);
  const std::vector<double> after = random_points(60, 2);
  const std::vector<std::vector<Index>> lists{
      {7}, {7, 8}, {3, 4, 5}, {0, 1, 2, 3, 9, 8, 20, 21, 22, 23, 24}, {11, 11, 12, 0, 40, 41}};
  for (const std::vector<Index>& list : lists)
    for (const std::size_t stride : {3U, 4U}) {
      MotionTracker tracker(2.0, 0.5);
      tracker.start(Positions(before, stride), list);
      tracker.update(Positions(after, stride));
      const Point together = tracker.motion();
      Point expected{0, 0, 0};
      for (const Index a : list)
        for (const Index b : list)
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto moved = [&](Index node) {
              const std::size_t at = static_cast<std::size_t>(node) * stride + axis;
              return after[at] - before[at];
            };
            expected[axis] = std::max(expected[axis], moved(a) - moved(b));
          }
      EXPECT_EQ(together, expected) << list.size() << " " << stride;
    }
}

TEST(MotionTracker, StartsAgainWithTheSameNodes) {
  const std::vector<double> points = random_points(20, 3);
  std::vector<double> moved = points;
  MotionTracker tracker(2.0, 0.5);
  tracker.start_again(Positions(points));
  EXPECT_TRUE(tracker.due());
  tracker.start(Positions(points), std::vector<Index>{2, 3, 9});
  moved[3 * 9] += 1;
  moved[3 * 10] += 5;
  tracker.update(Positions(moved));
  EXPECT_NEAR(tracker.used(), 1, 1e-14);
  tracker.start_again(Positions(moved));
  EXPECT_EQ(tracker.used(), 0);
  moved[3 * 9 + 2] = nan;
  expect_error(ErrorKind::NonFiniteCoordinate, 9, [&] { tracker.start_again(Positions(moved)); });
  EXPECT_TRUE(tracker.due());
}

TEST(MotionTracker, GivesTheSameBitsForAnyNumberOfThreads) {
  const std::vector<double> start = random_points(50000, 1);
  const std::vector<double> now = random_points(50000, 2);
  std::vector<Index> nodes;
  std::vector<Index> others;
  for (Index node = 0; node < 50000; ++node) (node % 3 == 0 ? nodes : others).push_back(node);
  std::vector<Point> one_list;
  std::vector<Point> two_lists;
  for (const int threads : {1, 2, 3, 4}) {
    MotionTracker tracker(1.0, 0.0, threads);
    tracker.start(Positions(start));
    tracker.update(Positions(now));
    one_list.push_back(tracker.motion());
    tracker.start(Positions(start), nodes, others);
    tracker.update(Positions(now));
    two_lists.push_back(tracker.motion());
    EXPECT_EQ(tracker.relative_speed(Positions(now)).size(), 3U);
  }
  for (const Point& motion : one_list) EXPECT_EQ(motion, one_list.front());
  for (const Point& motion : two_lists) EXPECT_EQ(motion, two_lists.front());
  EXPECT_LE(two_lists.front()[0], one_list.front()[0]);
}

/// True if `node` lies within `distance` of the box of `segment` along each axis.
bool near(const Scene& scene, Index segment, Index node, double distance) {
  Box box;
  for (int corner = 0; corner < 4; ++corner) box.include(scene.positions[scene.segments[segment][corner]]);
  const double* xyz = scene.positions[node];
  for (int axis = 0; axis < 3; ++axis) {
    if (std::max(box.lo[axis] - xyz[axis], xyz[axis] - box.hi[axis]) > distance) return false;
  }
  return true;
}

/// First pair within `distance` that is no candidate, looking at all nodes and segments.
std::string first_missed(const Scene& scene, const Candidates& found, double distance) {
  for (Index segment = 0; segment < found.segments(); ++segment) {
    const std::span<const Index> row = found.of(segment);
    for (std::size_t place = 0; place < scene.participants(); ++place) {
      const Index node = scene.participant(static_cast<Index>(place));
      if (scene.segments.owns(segment, node) || !near(scene, segment, node, distance)) continue;
      if (!std::binary_search(row.begin(), row.end(), node)) {
        return "segment " + std::to_string(segment) + ", node " + std::to_string(node);
      }
    }
  }
  return "";
}

/// Runs a scene through a random motion; returns the number of searches. `two`: watch two lists.
int follow(scenes::Mesh mesh, std::uint64_t seed, int steps, bool two) {
  scenes::Random random(seed);
  const double edge = mesh.mean_edge();
  const double h = edge * random.uniform(0.0, 0.3);
  mesh.expansion = h + edge * random.uniform(0.05, 0.6);
  const double speed = edge * random.uniform(0.002, 0.04);
  Search search;
  MotionTracker tracker(mesh.expansion, h, 2);
  const std::vector<Index> all_segment_nodes = mesh.segments;
  std::vector<Index> nodes;
  for (Index node = 0; node < static_cast<Index>(mesh.node_count()); ++node) {
    if (!two || node % 2 == 0) nodes.push_back(node);
  }
  mesh.nodes = nodes;
  std::vector<double> velocities(mesh.positions.size());
  for (double& v : velocities) v = random.uniform(-speed, speed);
  Candidates found;
  int searches = 0;
  for (int step = 0; step < steps; ++step) {
    tracker.update(mesh.scene().positions);
    if (tracker.due()) {
      search.find(mesh.scene());
      found = search.take();
      ++searches;
      if (two) {
        tracker.start(mesh.scene().positions, nodes, all_segment_nodes);
      } else {
        tracker.start(mesh.scene().positions);
      }
    }
    const std::string missed = first_missed(mesh.scene(), found, h);
    EXPECT_EQ(missed, "") << mesh.name << " seed " << seed << " step " << step;
    if (!missed.empty()) return searches;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      velocities[i] = std::clamp(velocities[i] + random.uniform(-0.3, 0.3) * speed, -speed, speed);
      mesh.positions[i] += velocities[i] + std::array{3.0, -1.0, 0.5}[i % 3] * edge;  // all drift together
    }
  }
  return searches;
}

TEST(MotionTracker, MissesNoPairInRandomMotion) {
  int searches = 0;
  constexpr int steps = 25;
  constexpr int scenes_made = 24;
  for (std::uint64_t seed = 0; seed < scenes_made; ++seed) {
    const scenes::Mesh mesh = seed % 3 == 0   ? scenes::folded_sheets(150, seed)
                              : seed % 3 == 1 ? scenes::crushed_tube(150, seed)
                                              : scenes::random_soup(100, 60, seed);
    ASSERT_EQ(mesh.stride, 3U);
    searches += follow(mesh, seed, steps, seed % 2 == 1);
    if (HasFailure()) return;
  }
  // It would be no feat to search at every step.
  EXPECT_LT(searches, scenes_made * steps / 2);
  EXPECT_GT(searches, 2 * scenes_made);
}

}  // namespace
}  // namespace cellsearch::motion_tracker_test
