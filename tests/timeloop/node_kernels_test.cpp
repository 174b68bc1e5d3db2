// SPDX-License-Identifier: BSD-3-Clause
// The pass over the nodes, which takes four at a time where it can, against plain numbers.
#include "timeloop/node_kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>

namespace crumple::timeloop::node_kernels_test {
namespace {

using domain::NodeFields;
using math::Vec3;

constexpr double interval = 0.25;

/// Nodes of all sorts: most of them free, runs without rotary inertia, some held or moved by bodies or
/// without mass.
NodeFields some_nodes(Index count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  std::uniform_int_distribution<int> choice(0, 15);
  NodeFields nodes;
  const auto vector = [&] { return Vec3{number(random), number(random), number(random)}; };
  for (Index i = 0; i < count; ++i) {
    nodes.position.push_back(vector());
    nodes.velocity.push_back(vector());
    nodes.angular_velocity.push_back(vector());
    nodes.acceleration.emplace_back();
    nodes.mass.push_back(choice(random) == 0 ? 0.0 : 1.5 + number(random));
    nodes.inertia.push_back(i / 16 % 3 == 1 || choice(random) == 0 ? 0.0 : 1.2 + number(random));
    const int sort = choice(random);
    nodes.fixed.push_back(sort == 0   ? domain::fixed_translation(1) | domain::fixed_rotation(2)
                          : sort == 1 ? domain::moved_by_body
                                      : 0);
    domain::NodeForce force{};
    for (int axis = 0; axis < 3; ++axis) {
      force.force[axis] = number(random);
      force.moment[axis] = number(random);
    }
    nodes.force.push_back(force);
  }
  nodes.double_records.resize(count);
  return nodes;
}

/// The same, one number after the other.
struct Plain {
  NodeFields nodes;
  double translational = 0;
  double rotational = 0;
  double fastest[3] = {};

  explicit Plain(const NodeFields& from) : nodes(from) {
    for (Index i = 0; i < nodes.count(); ++i) kick(i);
  }
  void kick(Index i) {
    const bool free = nodes.is_free(i);
    const double per_mass = free && nodes.mass[i] > 0 ? 1 / nodes.mass[i] : 0;
    const double per_inertia = free && nodes.inertia[i] > 0 ? 1 / nodes.inertia[i] : 0;
    for (int axis = 0; axis < 3; ++axis) {
      const bool held = (nodes.fixed[i] & domain::fixed_translation(axis)) != 0;
      const double a = held ? 0 : per_mass * nodes.force[i].force[axis];
      nodes.acceleration[i][axis] = a;
      const double v = nodes.velocity[i][axis];
      nodes.velocity[i][axis] = v + interval * a;
      if (free) translational += 0.5 * nodes.mass[i] * v * nodes.velocity[i][axis];
      fastest[axis] = std::max(fastest[axis], nodes.velocity[i][axis] * nodes.velocity[i][axis]);
      if (!(nodes.inertia[i] > 0)) continue;
      const double w = nodes.angular_velocity[i][axis];
      const bool stays = (nodes.fixed[i] & domain::fixed_rotation(axis)) != 0;
      nodes.angular_velocity[i][axis] =
          stays ? 0 : w + interval * (per_inertia * nodes.force[i].moment[axis]);
      if (free) rotational += 0.5 * nodes.inertia[i] * w * nodes.angular_velocity[i][axis];
    }
  }
};

void expect_equal(const AlignedArray<Vec3>& ours, const AlignedArray<Vec3>& plain) {
  for (std::size_t i = 0; i < plain.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(ours[i][axis], plain[i][axis]) << i << ' ' << axis;
}

class NodeKernelsOf : public ::testing::TestWithParam<Isa> {};

TEST_P(NodeKernelsOf, KickIsWhatPlainNumbersSay) {
  for (const Index count : {1, 4, 7, 250, 1023}) {
    NodeFields nodes = some_nodes(count);
    const Plain plain(nodes);
    const AlignedArray<Vec3> before = nodes.velocity;
    AlignedArray<Vec3> previous(nodes.velocity.size());
    Kick kick;
    kick.interval = interval;
    kick.previous_velocity = previous.data();
    kick.keep_acceleration = true;
    const KickSums sums = node_kernels(GetParam()).kick(nodes, {0, count}, kick);
    expect_equal(nodes.velocity, plain.nodes.velocity);
    expect_equal(nodes.angular_velocity, plain.nodes.angular_velocity);
    expect_equal(nodes.acceleration, plain.nodes.acceleration);
    expect_equal(previous, before);
    EXPECT_NEAR(sums.translational, plain.translational, 1e-13 * count);
    EXPECT_NEAR(sums.rotational, plain.rotational, 1e-13 * count);
    EXPECT_DOUBLE_EQ(sums.fastest, std::sqrt(plain.fastest[0] + plain.fastest[1] + plain.fastest[2]));
    for (const domain::NodeForce& force : nodes.force)
      for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(force.force[axis] + force.moment[axis], 0);
  }
}

TEST_P(NodeKernelsOf, KickTouchesNoNodeBeyondItsRange) {
  NodeFields nodes = some_nodes(64);
  const NodeFields before = nodes;
  Kick kick;
  kick.interval = interval;
  node_kernels(GetParam()).kick(nodes, {8, 31}, kick);
  for (Index i = 0; i < 64; ++i) {
    if (i >= 8 && i < 31) continue;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(nodes.velocity[i][axis], before.velocity[i][axis]);
      EXPECT_EQ(nodes.angular_velocity[i][axis], before.angular_velocity[i][axis]);
      EXPECT_EQ(nodes.force[i].force[axis], before.force[i].force[axis]);
    }
  }
}

TEST_P(NodeKernelsOf, DriftMovesNodesAndWritesTheirRecords) {
  NodeFields nodes = some_nodes(37);
  const NodeFields before = nodes;
  node_kernels(GetParam()).drift(nodes, {0, 37}, interval);
  for (Index i = 0; i < 37; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const double x = before.position[i][axis] + interval * before.velocity[i][axis];
      EXPECT_EQ(nodes.position[i][axis], x);
      EXPECT_EQ(nodes.double_records[i].position[axis], x);
      EXPECT_EQ(nodes.double_records[i].velocity[axis], before.velocity[i][axis]);
      EXPECT_EQ(nodes.double_records[i].angular_velocity[axis], before.angular_velocity[i][axis]);
    }
}

TEST_P(NodeKernelsOf, DriftTellsTheRangeOfVelocities) {
  NodeFields nodes = some_nodes(37);
  nodes.velocity[0] = nodes.velocity[36] = {1e6, 1e6, 1e6};  // not of the range
  const VelocityRange range = node_kernels(GetParam()).drift(nodes, {1, 36}, interval);
  for (int axis = 0; axis < 3; ++axis) {
    const auto by_axis = [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; };
    const auto [low, high] = std::minmax_element(&nodes.velocity[1], &nodes.velocity[36], by_axis);
    EXPECT_EQ(range.low[axis], (*low)[axis]);
    EXPECT_EQ(range.high[axis], (*high)[axis]);
  }
  EXPECT_TRUE(range.finite);
  EXPECT_EQ(range.relative_speed(), math::norm(range.high - range.low));
}

TEST_P(NodeKernelsOf, DriftTellsTheRangeWhicheverNodeBoundsIt) {
  constexpr NodeRange range{1, 36};
  NodeFields nodes = some_nodes(37);
  nodes.velocity[0] = nodes.velocity[36] = {1e6, 1e6, 1e6};  // not of the range
  for (Index i = range.first; i < range.last; ++i)
    for (int axis = 0; axis < 3; ++axis)
      for (const double fast : {5.0, -5.0}) {
        const double before = std::exchange(nodes.velocity[i][axis], fast);
        const VelocityRange found = node_kernels(GetParam()).drift(nodes, range, interval);
        EXPECT_EQ(fast > 0 ? found.high[axis] : found.low[axis], fast) << i << ' ' << axis;
        EXPECT_LE(std::fabs(fast > 0 ? found.low[axis] : found.high[axis]), 1) << i << ' ' << axis;
        nodes.velocity[i][axis] = before;
      }
}

TEST_P(NodeKernelsOf, DriftTellsOfVelocitiesThatAreNotFinite) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr Index count = 9;
  const auto drift = [](NodeFields& nodes, Index first, Index last) {
    return node_kernels(GetParam()).drift(nodes, {first, last}, interval);
  };
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
    for (Index i = 0; i < count; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        NodeFields nodes = some_nodes(count);
        nodes.velocity[i][axis] = bad;
        EXPECT_EQ(drift(nodes, 0, count).relative_speed(), infinity) << i << ' ' << axis;
        EXPECT_TRUE(i == 0 || drift(nodes, 0, i).finite) << i << ' ' << axis;
        EXPECT_TRUE(i + 1 == count || drift(nodes, i + 1, count).finite) << i << ' ' << axis;
      }
}

INSTANTIATE_TEST_SUITE_P(All, NodeKernelsOf, ::testing::ValuesIn(available_isas()),
                         [](const auto& which) { return std::string(isa_name(which.param)); });

}  // namespace
}  // namespace crumple::timeloop::node_kernels_test
