// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "contact/bodies.hpp"
#include "contact/surface/surface.hpp"
#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/verified.hpp"

namespace crumple::eroded_test {
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

void move_to(contact::Interface& touching, domain::Domain& made, const std::vector<Vec3>& by_model_node) {
  std::vector<Vec3> x(by_model_node.size());
  for (Index i = 0; i < static_cast<Index>(x.size()); ++i) x[test::at(made, i)] = by_model_node[i];
  test::move_to(touching, made, x, 0.02);
}

// The independent formulation of a shell that has gone is a mesh that never had it.
void expect_as_if_never_been(model::LocalSearchKind kind) {
  Bodies whole = stack();
  Bodies holed = stack();
  whole.model.search.local = holed.model.search.local = kind;
  std::vector<model::ShellElement>& shells = holed.model.shells;
  const std::vector<Index> without = gone();
  for (auto shell = shells.begin(); shell != shells.end();)
    shell = std::find(without.begin(), without.end(), static_cast<Index>(shell->id - 5000)) != without.end()
                ? shells.erase(shell)
                : shell + 1;
  domain::Domain eroded = whole.build();
  domain::Domain never = holed.build();
  test::make_erodible(eroded);
  contact::Interface one = whole.attach(eroded);
  contact::Interface other = holed.attach(never);
  one.verify_search_every(1);
  test::erode(eroded, without);
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
      difference = test::larger_of(difference, norm(here - there));
      largest = test::larger_of(largest, norm(there));
    }
  }
  EXPECT_GT(largest, 0);
  test::verified(std::string("contact of a sheet with eroded shells, ") +
                     (kind == model::LocalSearchKind::Pinballs ? "pinballs" : "inside and outside") +
                     ": force over the largest, difference",
                 "mesh that never had them")
      .below(difference / largest, 1e-11);
}

TEST(Eroded, ShellsTouchAsIfTheyHadNeverBeen) {
  expect_as_if_never_been(model::LocalSearchKind::InsideOutside);
}

TEST(Eroded, PinballsTouchAsIfTheyHadNeverBeen) {
  expect_as_if_never_been(model::LocalSearchKind::Pinballs);
}

TEST(Eroded, ShellsLetGoAtOnceAndTheirLonelyNodesToo) {
  const Bodies bodies = stack();
  domain::Domain made = bodies.build();
  test::make_erodible(made);
  contact::Interface touching = bodies.attach(made);
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
  test::erode(made, gone());
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
  test::make_erodible(made);
  contact::Surface surface = contact::build_surface(bodies.model, made, bodies.contact);
  const auto free_edges = [&] {
    return std::count(surface.topology.kind.begin(), surface.topology.kind.end(), contact::EdgeKind::Free);
  };
  const auto before = free_edges();
  EXPECT_FALSE(contact::follow_erosion(surface, made, 1));
  test::erode(made, gone());
  EXPECT_TRUE(contact::follow_erosion(surface, made, 1));
  EXPECT_FALSE(contact::follow_erosion(surface, made, 1));
  // The hole has a rim of 8; the corner shell takes two free edges along and leaves two.
  EXPECT_EQ(free_edges(), before + 8);
  EXPECT_FALSE(surface.bears(surface.place[test::at(made, lonely_node)]));
  EXPECT_EQ(surface.eroded, 5);
}

/// A column of two solids, one on the other, and a small sheet above it.
class Column {
 public:
  Column() {
    model::Model& model = bodies_.model;
    bodies_.sheet(1, 1, [](double u, double v) { return Vec3{0.4 + 0.2 * u, 0.4 + 0.2 * v, 2.3}; });
    model.solid_sections.resize(1);
    model.parts.push_back({.id = 2, .title = "column"});
    model.parts[1].section = no_index;
    model.parts[1].solid_section = 0;
    model.parts[1].material = 0;
    test::add_box(model, 1, 1, 1, 2, [](double u, double v, double w) { return test::Point{u, v, 2 * w}; });
    bodies_.contact.side[0].parts = {0, 1};
    made_ = bodies_.build();
    for (domain::SolidBlock& block : made_.solids) {
      domain::add_item(block, "active", "-", 1);
      domain::add_item(block, "energy", "energy", 2);
      block.double_state.assign(static_cast<std::size_t>(block.groups()) * block.components * lanes, 0.0);
      for (Index place = 0; place < block.elements; ++place) block.set_state(place, 0, 1);
    }
    touching_.emplace(bodies_.attach(made_));
    touching_->verify_search_every(1);
    test::add_forces(*touching_, made_);
  }

  void erode_top() {
    domain::SolidBlock& block = made_.solids[0];
    for (Index place = 0; place < block.elements; ++place)
      if (block.element[place] == 1) block.set_state(place, block.find("active")->first, 0);
    ++block.eroded;
  }
  void lower_sheet(double by) {
    std::vector<Vec3> x(made_.nodes.position.begin(), made_.nodes.position.end());
    for (Index i = 0; i < 4; ++i) x[test::at(made_, i)].z -= by;
    test::move_to(*touching_, made_, x, 0.1);
  }
  double force() const {
    double sum = 0;
    for (Index i = 0; i < 4; ++i) sum += made_.contact_force[test::at(made_, i)].z;
    return sum;
  }
  const contact::Surface& surface() const { return touching_->surface(); }

 private:
  Bodies bodies_{0.1};
  domain::Domain made_;
  std::optional<contact::Interface> touching_;
};

// The face between two solids is none until one of them has eroded; then what comes down lands on it.
TEST(Eroded, SolidsLeaveTheFacesBehindThem) {
  Column whole;
  EXPECT_EQ(std::count(whole.surface().active.begin(), whole.surface().active.end(), 1), 10 + 1);
  whole.lower_sheet(0.28);
  EXPECT_GT(whole.force(), 0);

  Column column;
  column.erode_top();
  column.lower_sheet(0.28);
  EXPECT_EQ(column.force(), 0);
  EXPECT_EQ(std::count(column.surface().active.begin(), column.surface().active.end(), 1), 6 + 1);
  for (int step = 0; step < 20; ++step) column.lower_sheet(0.0488);
  EXPECT_EQ(column.force(), 0) << "at z = 1.044; the sheet has a contact thickness of 0.08, 0.4 of its edge";
  column.lower_sheet(0.02);
  EXPECT_GT(column.force(), 0);
}

}  // namespace
}  // namespace crumple::eroded_test
