// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/bodies.hpp"
#include "contact/surface.hpp"

namespace crumple {
namespace {

using test::Bodies;
using test::Vec3;

/// Three wavy sheets nearer to each other than their thickness.
Bodies stack() {
  Bodies bodies(0.06);
  for (int layer = 0; layer < 3; ++layer)
    bodies.sheet(8, 6, [&](double u, double v) {
      return Vec3{2 * u + 0.1 * layer, 1.5 * v, 0.05 * layer + 0.02 * std::sin(5 * u + 3 * v)};
    });
  return bodies;
}

/// A hole of 2 x 2 shells in the middle sheet, whose middle node is left alone, and a shell at its rim.
std::vector<Index> gone() {
  constexpr Index middle = 8 * 6;
  return {middle + 3 * 6 + 2, middle + 3 * 6 + 3, middle + 4 * 6 + 2, middle + 4 * 6 + 3, middle};
}

constexpr Index lonely_node = 9 * 7 + 4 * 7 + 3;

/// Gives all shells the item that says whether they are active.
void prepare(domain::Domain& made) {
  for (domain::ShellBlock& block : made.shells) {
    const Index active = domain::add_item(block, "active", "-", 1);
    block.double_state.assign(static_cast<std::size_t>(block.groups()) * block.components * lanes, 0.0);
    for (Index place = 0; place < block.elements; ++place) block.set_state(place, active, 1);
  }
}

void erode(domain::Domain& made, const std::vector<Index>& shells) {
  for (domain::ShellBlock& block : made.shells)
    for (Index place = 0; place < block.elements; ++place) {
      if (std::find(shells.begin(), shells.end(), block.element[place]) == shells.end()) continue;
      block.set_state(place, block.find("active")->first, 0);
      ++block.eroded;
    }
}

/// Positions by model node: every sheet swings on its own.
std::vector<Vec3> swing(const Bodies& bodies, int cycle) {
  std::vector<Vec3> x;
  const double t = 0.02 * cycle;
  for (const auto& r : bodies.model.nodes.position) {
    const double phase = 3 * r[0] + 2 * r[1] + 40 * r[2];
    x.push_back({r[0] + 0.05 * std::sin(t + phase), r[1] + 0.04 * std::sin(1.3 * t - phase),
                 r[2] + 0.01 * std::sin(2.1 * t + 2 * phase)});
  }
  return x;
}

void move_to(contact::SingleSurface& touching, domain::Domain& made, const std::vector<Vec3>& by_model_node) {
  std::vector<Vec3> x(by_model_node.size());
  for (Index i = 0; i < static_cast<Index>(x.size()); ++i) x[test::at(made, i)] = by_model_node[i];
  test::move_to(touching, made, x, 0.02);
}

// The independent formulation of a shell that has gone is a mesh that never had it.
TEST(Eroded, ShellsTouchAsIfTheyHadNeverBeen) {
  const Bodies whole = stack();
  Bodies holed = stack();
  std::vector<model::ShellElement>& shells = holed.model.shells;
  const std::vector<Index> without = gone();
  for (auto shell = shells.begin(); shell != shells.end();)
    shell = std::find(without.begin(), without.end(), static_cast<Index>(shell->id - 5000)) != without.end()
                ? shells.erase(shell)
                : shell + 1;
  domain::Domain eroded = whole.build();
  domain::Domain never = holed.build();
  prepare(eroded);
  contact::SingleSurface one = whole.attach(eroded);
  contact::SingleSurface other = holed.attach(never);
  one.verify_search_every(1);
  erode(eroded, without);
  double largest = 0;
  double difference = 0;
  for (int cycle = 0; cycle < 60; ++cycle) {
    const std::vector<Vec3> x = swing(whole, cycle);
    ASSERT_NO_THROW(move_to(one, eroded, x));
    move_to(other, never, x);
    ASSERT_EQ(eroded.contacts[0].active_pairs, never.contacts[0].active_pairs) << cycle;
    for (Index node = 0; node < whole.model.nodes.count(); ++node) {
      const Vec3 here = eroded.contact_force[test::at(eroded, node)];
      const Vec3 there = never.contact_force[test::at(never, node)];
      difference = std::max(difference, norm(here - there));
      largest = std::max(largest, norm(there));
    }
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(difference, 1e-11 * largest);
}

TEST(Eroded, ShellsLetGoAtOnceAndTheirLonelyNodesToo) {
  const Bodies bodies = stack();
  domain::Domain made = bodies.build();
  prepare(made);
  contact::SingleSurface touching = bodies.attach(made);
  touching.verify_search_every(1);
  for (int cycle = 0; cycle < 10; ++cycle) move_to(touching, made, swing(bodies, cycle));
  const auto touches = [&](UserId shell) {
    return std::any_of(touching.penetrations().begin(), touching.penetrations().end(),
                       [&](const contact::Penetration& found) { return found.segment == shell; });
  };
  const auto gone_touches = [&] {
    const std::vector<Index> shells = gone();
    return std::any_of(shells.begin(), shells.end(), [&](Index shell) { return touches(5000 + shell); });
  };
  EXPECT_TRUE(gone_touches());
  EXPECT_GT(norm(made.contact_force[test::at(made, lonely_node)]), 0);
  const long searches = made.contacts[0].searches;
  erode(made, gone());
  for (int cycle = 10; cycle < 30; ++cycle) {
    ASSERT_NO_THROW(move_to(touching, made, swing(bodies, cycle)));
    EXPECT_FALSE(gone_touches());
    EXPECT_EQ(norm(made.contact_force[test::at(made, lonely_node)]), 0);
  }
  EXPECT_GT(made.contacts[0].searches, searches);
  EXPECT_GT(made.contacts[0].active_pairs, 0);
}

TEST(Eroded, NeighboursHaveFreeEdges) {
  const Bodies bodies = stack();
  domain::Domain made = bodies.build();
  prepare(made);
  contact::Surface surface = contact::build_surface(bodies.model, made, bodies.contact);
  const auto free_edges = [&] {
    return std::count(surface.topology.kind.begin(), surface.topology.kind.end(), contact::EdgeKind::Free);
  };
  const auto before = free_edges();
  EXPECT_FALSE(contact::drop_eroded(surface, made));
  erode(made, gone());
  EXPECT_TRUE(contact::drop_eroded(surface, made));
  EXPECT_FALSE(contact::drop_eroded(surface, made));
  // The hole has a rim of 8; the corner shell takes two free edges along and leaves two.
  EXPECT_EQ(free_edges(), before + 8);
  EXPECT_FALSE(surface.bears(surface.place[test::at(made, lonely_node)]));
  EXPECT_EQ(surface.eroded, 5);
}

}  // namespace
}  // namespace crumple
