// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "contact/bodies.hpp"
#include "contact/intersections.hpp"
#include "contact/search/global_search.hpp"

namespace crumple::search_test {
namespace {

using test::Bodies;
using test::Vec3;

/// Three wavy sheets on top of each other, of different element sizes and distance below the thickness.
Bodies stack() {
  Bodies bodies(0.06);
  for (int layer = 0; layer < 3; ++layer)
    bodies.sheet(8 + 2 * layer, 6 + layer, [&](double u, double v) {
      return Vec3{2 * u + 0.1 * layer, 1.5 * v, 0.09 * layer + 0.02 * std::sin(5 * u + 3 * v)};
    });
  return bodies;
}

/// Random smooth motion: every node swings about its place with the frequencies of its sheet.
std::vector<Vec3> swing(const domain::Domain& made, int cycle) {
  std::vector<Vec3> x;
  const double t = 0.02 * cycle;
  for (Index i = 0; i < made.nodes.count(); ++i) {
    const Vec3& r = made.nodes.reference[i];
    const double phase = 3 * r.x + 2 * r.y + 40 * r.z;
    x.push_back({r.x + 0.5 * std::sin(t + phase) + 3 * t, r.y + 0.4 * std::sin(1.3 * t - phase),
                 r.z + 0.1 * std::sin(2.1 * t + 2 * phase)});
  }
  return x;
}

TEST(Search, NoContactIsMissedDuringRandomMotion) {
  for (const double expansion : {0.0, 0.07, 0.5}) {
    Bodies bodies = stack();
    bodies.model.search.expansion = expansion;
    domain::Domain made = bodies.build();
    contact::Interface touching = bodies.attach(made);
    touching.verify_search_every(1);
    ASSERT_NO_THROW(test::add_forces(touching, made));
    Index most = 0;
    for (int cycle = 1; cycle <= 150; ++cycle) {
      ASSERT_NO_THROW(test::move_to(touching, made, swing(made, cycle), 0.02)) << "cycle " << cycle;
      most = std::max(most, made.contacts[0].active_pairs);
    }
    EXPECT_GT(most, 20);
    EXPECT_GT(made.contacts[0].searches, 2);
    EXPECT_EQ(made.contacts[0].method, "production");
    if (expansion == 0.5) {
      EXPECT_LT(made.contacts[0].searches, 100);
    }
  }
}

// How far the territories reach, and so when a search is made, changes no bit of the forces.
TEST(Search, ExpansionDoesNotChangeTheForces) {
  std::vector<std::vector<Vec3>> forces;
  for (const double expansion : {0.0, 0.065, 0.3, 3.0}) {
    Bodies bodies = stack();
    bodies.model.search.expansion = expansion;
    bodies.model.control.contact_stiffness_scale = 5;  // stiff enough that no node goes through
    bodies.contact.static_friction = bodies.contact.dynamic_friction = 0.2;
    domain::Domain made = bodies.build();
    for (Index i = 0; i < made.nodes.count(); ++i)
      made.nodes.velocity[i] = {0.3 * std::sin(20.0 * i), made.nodes.reference[i].z, -0.4 * (i % 3)};
    contact::Interface touching = bodies.attach(made);
    test::add_forces(touching, made);
    forces.emplace_back();
    Index most = 0;
    for (int cycle = 0; cycle < 200; ++cycle) {
      test::integrate(touching, made, 2e-3);
      forces.back().insert(forces.back().end(), made.contact_force.begin(), made.contact_force.end());
      most = std::max(most, made.contacts[0].active_pairs);
      ASSERT_EQ(touching.statistics().nodes_astray, 0);
    }
    EXPECT_GT(most, 50);
  }
  for (const auto& other : forces)
    for (std::size_t i = 0; i < other.size(); ++i) {
      ASSERT_EQ(other[i].x, forces[0][i].x);
      ASSERT_EQ(other[i].y, forces[0][i].y);
      ASSERT_EQ(other[i].z, forces[0][i].z);
    }
}

// The common rigid motion of all nodes uses up nothing.
TEST(Search, RigidTranslationNeedsNoSearch) {
  const Bodies bodies = stack();
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  for (int cycle = 1; cycle <= 50; ++cycle) {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    for (Vec3& a : x) a += Vec3{0.7, -0.3, 0.2};
    test::move_to(touching, made, x, 1e-3);
  }
  EXPECT_EQ(made.contacts[0].searches, 1);
}

TEST(Search, VerificationNoticesAMissedPair) {
  const Bodies bodies = stack();
  domain::Domain made = bodies.build();
  const contact::Surface surface = contact::build_surface(bodies.model, made, bodies.contact);
  contact::GlobalSearch search(surface, bodies.model.search, 1);
  search.update(contact::present(made), false, {});
  EXPECT_NO_THROW(search.verify(contact::present(made)));
  // Moved behind the back of the search: the upper sheet goes a full length to the side.
  for (Vec3& x : made.nodes.position)
    if (x.z > 0.15) x.x -= 1.0;
  try {
    search.verify(contact::present(made));
    FAIL() << "the missed pair was not noticed";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("node 1"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("element 5"), std::string::npos) << error.what();
  }
}

TEST(Search, AllMethodsGiveTheSameForces) {
  std::vector<std::uint64_t> hashes;
  for (const cellsearch::Method method : cellsearch::methods()) {
    if (cellsearch::name_of(method) == "nbs") continue;  // refuses mixed element sizes
    Bodies bodies = stack();
    bodies.model.search.method = std::string(cellsearch::name_of(method));
    domain::Domain made = bodies.build();
    contact::Interface touching = bodies.attach(made);
    test::add_forces(touching, made);
    for (int cycle = 1; cycle <= 20; ++cycle) test::move_to(touching, made, swing(made, cycle), 0.02);
    domain::StateList list;
    made.declare(list);
    touching.declare(list);
    hashes.push_back(list.hash());
  }
  ASSERT_GE(hashes.size(), 2U);
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front());
}

// Bitwise the same for 1, 2, 3 and 4 threads: forces, energies and memory of a run with friction.
TEST(Search, ThreadsDoNotChangeABit) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 3, 4}) {
    Bodies bodies(0.03);
    for (int layer = 0; layer < 3; ++layer)
      bodies.sheet(30 + layer, 28, [&](double u, double v) {
        return Vec3{2 * u + 0.01 * layer, 1.5 * v, 0.035 * layer + 0.004 * std::sin(5 * u + 3 * v)};
      });
    bodies.contact.static_friction = 0.3;
    bodies.contact.dynamic_friction = 0.2;
    bodies.contact.friction_decay = 0.1;
    bodies.contact.viscous_damping = 0.1;
    domain::Domain made = bodies.build(1.0, threads);
    made.clock.element_limit = 0.02;
    for (Index i = 0; i < made.nodes.count(); ++i)
      made.nodes.velocity[i] = {0.2 * std::sin(20.0 * i), 0.1, -3.0 * made.nodes.position[i].z};
    contact::Interface touching = bodies.attach(made);
    test::add_forces(touching, made);
    Index most = 0;
    for (int cycle = 0; cycle < 30; ++cycle) {
      test::integrate(touching, made, 0.01);
      most = std::max(most, made.contacts[0].active_pairs);
    }
    EXPECT_GT(most, 300);
    EXPECT_NE(made.contacts[0].friction_energy, 0);
    domain::StateList list;
    made.declare(list);
    touching.declare(list);
    hashes.push_back(list.hash());
  }
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front());
}

TEST(Search, SettingsThatCannotBeFollowedAreRefused) {
  Bodies bodies = stack();
  domain::Domain made = bodies.build();
  bodies.model.search.expansion = 0.05;  // below the contact distance of 0.06
  EXPECT_THROW(bodies.attach(made), Error);
  bodies.model.search.expansion = 0;
  bodies.model.search.method = "guess";
  EXPECT_THROW(bodies.attach(made), Error);
  bodies.model.search.method = "linked-cell";
  contact::Interface touching = bodies.attach(made);
  made.nodes.position[3].y = std::nan("");
  EXPECT_THROW(test::add_forces(touching, made), NumericalError);
}

// The paper's example 3: cells over part of the model only; what is outside takes no part as a node.
TEST(Search, OnlyNodesInsideTheCellDomainCount) {
  Bodies bodies(0.1);
  bodies.sheet(4, 4, [](double u, double v) { return Vec3{4 * u, 4 * v, 0}; });
  bodies.sheet(4, 4, [](double u, double v) { return Vec3{4 * u + 0.4, 4 * v + 0.4, 0.11}; });
  bodies.model.search.has_cells = true;
  bodies.model.search.cells = {2, 4, 1};
  bodies.model.search.domain_minimum = {-0.5, -0.5, -0.5};
  bodies.model.search.domain_maximum = {2.2, 5.0, 0.5};
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  touching.verify_search_every(1);
  test::add_forces(touching, made);
  std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
  for (Vec3& a : x)
    if (a.z > 0.1) a.z = 0.09;
  test::move_to(touching, made, x, 1e-3);
  EXPECT_GT(made.contacts[0].active_pairs, 0);
  for (const contact::Penetration& pair : touching.penetrations()) {
    const Index node = static_cast<Index>(pair.node) - 1000;
    EXPECT_LE(bodies.model.nodes.position[node][0], 2.2);
  }
}

// Eq. (12) of the paper: Ncell + N integers of four bytes, whatever the model.
TEST(Search, ItsCostIsReported) {
  Bodies bodies = stack();
  bodies.model.search.method = "linked-cell";
  bodies.model.search.has_cells = true;
  bodies.model.search.cells = {9, 7, 5};
  bodies.model.search.domain_minimum = {-1, -1, -1};
  bodies.model.search.domain_maximum = {4, 3, 1};
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  const domain::SearchReport first = made.contacts[0].search;
  EXPECT_EQ(first.participants, made.nodes.count());
  EXPECT_EQ(first.cells, 9 * 7 * 5);
  EXPECT_EQ(first.bytes, 4 * (first.cells + first.participants));
  EXPECT_GE(first.node_visits, made.contacts[0].candidates) << "a candidate has been looked at";
  EXPECT_GE(first.cell_visits, made.contacts[0].segments) << "a territory inside meets a cell";
  EXPECT_GT(first.expansion, 0.06) << "the contact distance";
  EXPECT_GT(first.find_seconds, 0);
  for (int cycle = 1; cycle <= 40; ++cycle) test::move_to(touching, made, swing(made, cycle), 0.02);
  const domain::ContactReport& later = made.contacts[0];
  EXPECT_GT(later.searches, 1);
  EXPECT_GT(later.search.node_visits, first.node_visits);
  EXPECT_GT(later.search.find_seconds, first.find_seconds);
  EXPECT_EQ(later.search.bytes, first.bytes);
}

TEST(Intersections, SheetsThatCutEachOtherAreCounted) {
  Bodies bodies(0.01);
  bodies.sheet(4, 1, [](double u, double v) { return Vec3{4 * u, v, 0}; });
  // A sheet standing across, through the second and third element of the other.
  bodies.sheet(2, 1, [](double u, double v) { return Vec3{1.5 + u, 0.3 + 0.1 * u, 2 * v - 1}; });
  const domain::Domain made = bodies.build();
  const contact::Surface surface = contact::build_surface(bodies.model, made, bodies.contact);
  // (1.5..2) cuts element 1 and touches the line to element 2 at x = 2; (2..2.5) cuts element 2.
  const auto found = contact::intersecting_segments(surface, made.nodes.position, 1);
  EXPECT_GE(found.size(), 2U);
  for (const auto& pair : found)
    EXPECT_NE(surface.segment_id[pair[0]] < 5004, surface.segment_id[pair[1]] < 5004);

  Bodies apart(0.01);
  apart.sheet(4, 3, [](double u, double v) { return Vec3{4 * u, 3 * v, 0.3 * std::sin(9 * u)}; });
  apart.sheet(4, 3, [](double u, double v) { return Vec3{4 * u, 3 * v, 0.3 * std::sin(9 * u) + 0.01}; });
  const domain::Domain parallel = apart.build();
  const contact::Surface sheets = contact::build_surface(apart.model, parallel, apart.contact);
  EXPECT_TRUE(contact::intersecting_segments(sheets, parallel.nodes.position, 1).empty());
}

// What cut at the start, there or beside, is not the contact's fault.
TEST(Intersections, ThoseOfTheStartAreKnown) {
  Bodies bodies(0.01);
  bodies.sheet(8, 1, [](double u, double v) { return Vec3{8 * u, v, 0}; });
  const Index across = bodies.sheet(1, 1, [](double u, double v) {
    return Vec3{1.5, 0.3 + 0.4 * u, 2 * v - 1};
  });
  domain::Domain made = bodies.build();
  const contact::Surface surface = contact::build_surface(bodies.model, made, bodies.contact);
  const auto initial = contact::intersecting_segments(surface, made.nodes.position, 1);
  ASSERT_EQ(initial.size(), 1U);
  const auto found_at = [&](double x) {
    for (Index n = across; n < across + 4; ++n) made.nodes.position[test::at(made, n)].x = x;
    const auto cut = contact::intersecting_segments(surface, made.nodes.position, 1);
    EXPECT_EQ(cut.size(), 1U);
    return contact::cut_since(surface, initial, cut).size();
  };
  EXPECT_EQ(found_at(1.6), 0U);
  EXPECT_EQ(found_at(2.5), 0U);  // of the segment beside
  EXPECT_EQ(found_at(4.5), 1U);
  EXPECT_TRUE(contact::cut_since(surface, initial, {}).empty());
}

// What a penalty lets soft bodies be beyond a mid-surface is less than the thickness.
TEST(Intersections, ThoseThroughTheThicknessAreToldApart) {
  Bodies bodies(0.01);
  bodies.sheet(4, 4, [](double u, double v) { return Vec3{4 * u, 4 * v, 0}; });
  const Index across = bodies.sheet(1, 1, [](double u, double v) { return Vec3{1.5, 1.3 + 0.4 * u, 2 * v}; });
  domain::Domain made = bodies.build();
  const contact::Surface surface = contact::build_surface(bodies.model, made, bodies.contact);
  const auto found_at = [&](double depth, contact::CutDepth which) {
    for (Index n = across; n < across + 2; ++n) made.nodes.position[test::at(made, n)].z = -depth;
    return contact::intersecting_segments(surface, made.nodes.position, 1, which).size();
  };
  EXPECT_EQ(found_at(0.004, contact::CutDepth::Any), 1U);
  EXPECT_EQ(found_at(0.004, contact::CutDepth::Through), 0U);
  EXPECT_EQ(found_at(0.006, contact::CutDepth::Through), 1U);
  EXPECT_EQ(found_at(-0.006, contact::CutDepth::Any), 0U);
}

TEST(Intersections, PenetrationsAreSummarised) {
  std::vector<contact::Penetration> found;
  for (int i = 1; i <= 200; ++i) found.push_back({0.004 * i, 1.0, i, 2 * i});
  const contact::PenetrationSummary summary = contact::summarise(found);
  EXPECT_EQ(summary.pairs, 200);
  EXPECT_DOUBLE_EQ(summary.largest, 0.8);
  EXPECT_DOUBLE_EQ(summary.percentile_99, 0.004 * 198);
  EXPECT_EQ(summary.worst_node, 200);
  EXPECT_EQ(summary.beyond, 0);
}

}  // namespace
}  // namespace crumple::search_test
