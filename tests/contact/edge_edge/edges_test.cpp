// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "contact/bodies.hpp"
#include "contact/edge_edge/edge_contact.hpp"
#include "contact/edge_edge/edge_geometry.hpp"
#include "contact/edge_edge/edge_search.hpp"
#include "contact/edge_edge/edges.hpp"
#include "support/largest.hpp"

namespace crumple::edges_test {
namespace {

using model::ContactEdges;
using test::Bodies;
using test::Vec3;

/// Two upright strips, one along x above z = 0 of `along` elements, one along y below z = -gap: their edges
/// cross. The upper one is `shift` to the side.
struct Cross {
  explicit Cross(double gap, int along = 1, double shift = 0, double thickness = 0.1) : bodies(thickness) {
    bodies.contact.edges = ContactEdges::Free;
    upper = bodies.sheet(along, 1, [&](double u, double v) { return Vec3{2 * u - 1 + shift, 0, v}; });
    lower = bodies.sheet(1, 1, [&](double u, double v) { return Vec3{0, 2 * u - 1, -gap - v}; });
  }

  /// Places with the upper strip moved.
  std::vector<Vec3> moved(const domain::Domain& made, const Vec3& by) const {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    for (Index i = upper; i < lower; ++i) x[test::at(made, i)] += by;
    return x;
  }

  Vec3 on_upper(const domain::Domain& made) const {
    Vec3 sum;
    for (Index i = upper; i < lower; ++i) sum += made.contact_force[test::at(made, i)];
    return sum;
  }

  /// Friction between the edges, on the upper one: the nodes bear its couple besides.
  Vec3 friction_on_upper(const contact::Interface& touching, const domain::Domain& made) const {
    Vec3 sum;
    for (const contact::Touch& touch : touching.touches()) {
      const Index node = made.nodes.model_node[touching.surface().nodes[touch.place[0]]];
      sum += (node < lower ? 1.0 : -1.0) * touch.friction;
    }
    return sum;
  }

  Bodies bodies;
  Index upper = 0;
  Index lower = 0;
};

/// SLSFAC K A / (largest diagonal) of a strip of 2 by 1, E = 1000, nu = 0.25.
double strip_stiffness() {
  return 0.1 * (1000.0 / 1.5) * 2 / std::sqrt(5.0);
}

TEST(Edges, NearestPointsAreThoseOfFineSampling) {
  const auto number = [](int i) {
    return std::sin(12.9898 * i) * 43758.5453 - std::floor(std::sin(12.9898 * i) * 43758.5453);
  };
  const auto point = [&](int i) { return Vec3{number(3 * i), number(3 * i + 1), number(3 * i + 2)}; };
  test::Largest longer("nearest points of two edges: distance over the least sampled one, excess",
                       "brute force, 201 samples", 1e-12);
  test::Largest ends("nearest points of two edges: distance of the points off the distance", "geometry",
                     1e-12);
  for (int i = 0; i < 200; ++i) {
    contact::EdgeShape a{point(4 * i), point(4 * i + 1)};
    contact::EdgeShape b{point(4 * i + 2), point(4 * i + 3)};
    if (i % 10 == 0) b.end = b.start + 0.7 * a.along();  // parallel
    if (i % 10 == 1) b.end = b.start;                    // a point
    const contact::NearestOnEdges nearest = contact::nearest_points(a, b);
    double best = 1e9;
    constexpr int steps = 200;
    for (int k = 0; k <= steps; ++k) {
      const double s = static_cast<double>(k) / steps;
      best = std::min(best, norm(a.at(s) - b.at(contact::nearest_fraction(b, a.at(s)))));
    }
    // It may be shorter: no sample need lie on the nearest points.
    longer.add(std::max(nearest.distance / best - 1, 0.0));
    EXPECT_GE(nearest.distance, best - 1.0 / steps);
    ends.compare(norm(a.at(nearest.fraction[0]) - b.at(nearest.fraction[1])), nearest.distance);
  }
}

TEST(Edges, CrossedStripsPushEachOtherApart) {
  Cross cross(0.2, 1, 0.3);
  domain::Domain made = cross.bodies.build();
  contact::Interface touching = cross.bodies.attach(made);
  touching.verify_search_every(1);
  test::add_forces(touching, made);
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
  test::move_to(touching, made, cross.moved(made, {0, 0, -0.16}), 1e-3);
  test::settle(touching, made);
  // 0.04 apart with thickness 0.1: penetration 0.06; the lever arms share it out.
  EXPECT_EQ(made.contacts[0].active_pairs, 1);
  const double half = 0.05;
  const double force = strip_stiffness() * (0.06 + 0.5 * 9 / half * 0.01 * 0.01);
  const std::string strips = "two strips edge on edge: ";
  test::verified(strips + "force", "penalty law").within(cross.on_upper(made).z, force, 1e-12);
  test::verified(strips + "share of the first node", "lever arms")
      .near(made.contact_force[test::at(made, cross.upper)].z / force, 0.65, 1e-12);
  EXPECT_LT(norm(test::total_force(made)), 1e-15 * force);
  test::verified(strips + "sum of moments over the force", "conservation")
      .below(norm(test::total_moment(made)) / force, 1e-14);
}

TEST(Edges, NothingHappensWithoutThem) {
  Cross cross(0.2);
  cross.bodies.contact.edges = ContactEdges::None;
  domain::Domain made = cross.bodies.build();
  contact::Interface touching = cross.bodies.attach(made);
  test::add_forces(touching, made);
  test::move_to(touching, made, cross.moved(made, {0, 0, -0.16}), 1e-3);
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
}

// Of two sides the edges of one touch those of the other, and never those of their own.
TEST(Edges, OfTwoSidesTouchThoseOfTheOther) {
  using model::ContactKind;
  const auto force = [](ContactKind kind, const std::vector<Index>& first, const std::vector<Index>& second) {
    Cross cross(0.2);
    cross.bodies.part();
    for (const double z : {3.0, 5.0})  // far away, so that both sides have segments
      cross.bodies.sheet(1, 1, [&](double u, double v) { return Vec3{u, v, z}; });
    cross.bodies.model.shells[1].part = cross.bodies.part();
    cross.bodies.contact.kind = kind;
    cross.bodies.contact.edges = ContactEdges::All;
    cross.bodies.contact.side[0].parts = first;
    cross.bodies.contact.side[1].parts = second;
    domain::Domain made = cross.bodies.build();
    contact::Interface touching = cross.bodies.attach(made);
    touching.verify_search_every(1);
    test::add_forces(touching, made);
    test::move_to(touching, made, cross.moved(made, {0, 0, -0.16}), 1e-3);
    const Vec3 sum = cross.on_upper(made);
    if (second == std::vector<Index>{2}) {
      EXPECT_EQ(made.contacts[0].force.z, sum.z) << "on the first side";
    }
    return sum.z;
  };
  const double one_surface = force(ContactKind::SingleSurface, {0, 2}, {});
  EXPECT_GT(one_surface, 0);
  EXPECT_EQ(force(ContactKind::SurfaceToSurface, {0}, {2}), one_surface);
  EXPECT_EQ(force(ContactKind::SurfaceToSurface, {0}, {1, 2}), one_surface);
  EXPECT_EQ(force(ContactKind::SurfaceToSurface, {0, 2}, {1}), 0) << "both on the first side";
  EXPECT_EQ(force(ContactKind::SurfaceToSurface, {1}, {0, 2}), 0);
}

// Sliding along an edge of several elements, over their nodes: one force, whoever sees to it.
TEST(Edges, ForceStaysTheSameOverNodes) {
  Cross cross(0.2, 4, 0.0);
  domain::Domain made = cross.bodies.build();
  contact::Interface touching = cross.bodies.attach(made);
  test::add_forces(touching, made);
  test::move_to(touching, made, cross.moved(made, {0.21, 0, -0.11}), 1e-3);
  for (int i = 0; i < 15; ++i) test::move_to(touching, made, cross.moved(made, {0, 0, -0.001}), 1e-3);
  const double before = cross.on_upper(made).z;
  EXPECT_GT(before, 0);
  const double stored = made.contacts[0].energy;
  ASSERT_GT(stored, 0);
  test::Largest forces("edge slides over nodes of another: force, relative change", "constant distance",
                       1e-12);
  for (int i = 0; i < 100; ++i) {
    // Over a node at x = 0.5 and exactly on it on the way.
    test::move_to(touching, made, cross.moved(made, {-0.0042, 0, 0}), 1e-3);
    forces.compare(cross.on_upper(made).z, before, before, std::to_string(i));
  }
  test::verified("edge slides over nodes of another: energy of the contact over that before", "conservation")
      .near(made.contacts[0].energy / stored, 1, 1e-12);
  EXPECT_NEAR(made.contacts[0].friction_energy, 0, 1e-15);
}

// In a step of three times the thickness the edges go through each other: they belong where they were.
TEST(Edges, FastOnesAreHeldBack) {
  Cross cross(0.15);
  domain::Domain made = cross.bodies.build();
  contact::Interface touching = cross.bodies.attach(made);
  test::add_forces(touching, made);
  test::move_to(touching, made, cross.moved(made, {0, 0, -0.32}), 1e-3);
  EXPECT_EQ(touching.statistics().edges_astray, 1);
  EXPECT_GT(cross.on_upper(made).z, 0);
  // Pushed back all the way.
  for (Vec3& v : made.nodes.velocity) v = {};
  bool home = false;
  for (int i = 0; i < 2000 && !home; ++i) {
    test::integrate(touching, made, 1e-3);
    home = made.contacts[0].active_pairs == 0;
  }
  EXPECT_TRUE(home);
  EXPECT_GT(made.nodes.position[test::at(made, cross.upper)].z,
            made.nodes.position[test::at(made, cross.lower)].z);
}

// The same right at a node of the edge, where neither of the two elements need be crossed inside.
TEST(Edges, FastOnesAreHeldBackAtNodes) {
  for (const double shift : {-0.02, -1e-3, 0.0, 1e-3, 0.02}) {
    Cross cross(0.15, 4, shift);
    domain::Domain made = cross.bodies.build();
    contact::Interface touching = cross.bodies.attach(made);
    test::add_forces(touching, made);
    for (int i = 0; i < 8; ++i) test::move_to(touching, made, cross.moved(made, {0.002, 0, -0.04}), 1e-3);
    EXPECT_GT(cross.on_upper(made).z, 0) << shift;
  }
}

TEST(Edges, ParallelOnesAreLeftToTheirNodes) {
  std::vector<Vec3> forces[2];
  for (const ContactEdges edges : {ContactEdges::None, ContactEdges::Free}) {
    Bodies bodies(0.1);
    bodies.contact.edges = edges;
    bodies.sheet(4, 2, [](double u, double v) { return Vec3{4 * u, 2 * v, 0}; });
    bodies.sheet(3, 2, [](double u, double v) { return Vec3{3.6 * u, 2.2 + 2 * v, 0.03 * u}; });
    domain::Domain made = bodies.build();
    contact::Interface touching = bodies.attach(made);
    test::add_forces(touching, made);
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    for (Vec3& a : x)
      if (a.y > 2.1) a.y -= 0.13;
    test::move_to(touching, made, x, 1e-3);
    EXPECT_GT(made.contacts[0].active_pairs, 3);
    forces[edges == ContactEdges::None ? 0 : 1].assign(made.contact_force.begin(), made.contact_force.end());
  }
  for (std::size_t i = 0; i < forces[0].size(); ++i) EXPECT_EQ(norm(forces[0][i] - forces[1][i]), 0);
}

TEST(Edges, OverlapAtTheStartIsLeftAlone) {
  Cross cross(0.04);
  domain::Domain made = cross.bodies.build();
  contact::Interface touching = cross.bodies.attach(made);
  test::add_forces(touching, made);
  EXPECT_EQ(cross.on_upper(made).z, 0);
  EXPECT_EQ(touching.statistics().initial_penetrations, 1);
  EXPECT_NEAR(touching.statistics().worst_initial, 0.06, 1e-12);
  test::move_to(touching, made, cross.moved(made, {0, 0, -0.01}), 1e-3);
  EXPECT_NEAR(cross.on_upper(made).z, strip_stiffness() * 0.01, 1e-10);
}

TEST(Edges, FrictionSticksAndSlips) {
  Cross cross(0.2);
  cross.bodies.contact.static_friction = cross.bodies.contact.dynamic_friction = 0.3;
  domain::Domain made = cross.bodies.build();
  contact::Interface touching = cross.bodies.attach(made);
  test::add_forces(touching, made);
  test::move_to(touching, made, cross.moved(made, {0, 0, -0.15}), 1e-3);
  test::settle(touching, made);
  const double normal = cross.on_upper(made).z;
  test::move_to(touching, made, cross.moved(made, {1e-3, 2e-3, 0}), 1e-3);
  Vec3 force = cross.friction_on_upper(touching, made);
  test::verified("edges that stick: friction along", "stiffness times way")
      .near(force.x, -strip_stiffness() * 1e-3, 1e-12);
  test::verified("edges that stick: friction across", "stiffness times way")
      .near(force.y, -strip_stiffness() * 2e-3, 1e-12);
  // Far slips at mu N against the movement; turning both as one changes nothing.
  for (int i = 0; i < 20; ++i) test::move_to(touching, made, cross.moved(made, {0, 0.01, 0}), 1e-3);
  force = cross.friction_on_upper(touching, made);
  test::verified("edges that slip: friction over the normal force", "Coulomb")
      .near(std::hypot(force.x, force.y) / normal, 0.3, 1e-12);
  EXPECT_LT(force.y, -0.29 * normal);
  EXPECT_GT(made.contacts[0].friction_energy, 0);
  EXPECT_LT(norm(test::total_moment(made)), 1e-12);
  std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
  const double angle = 0.02;
  for (Vec3& a : x)
    a = {std::cos(angle) * a.x - std::sin(angle) * a.y, std::sin(angle) * a.x + std::cos(angle) * a.y, a.z};
  test::move_to(touching, made, x, 1e-3);
  const Vec3 turned = cross.friction_on_upper(touching, made);
  EXPECT_NEAR(turned.x, std::cos(angle) * force.x - std::sin(angle) * force.y, 1e-3 * normal);
  EXPECT_NEAR(turned.y, std::sin(angle) * force.x + std::cos(angle) * force.y, 1e-3 * normal);
}

// A sheet bends and folds: its own edges are no contact.
TEST(Edges, NeighboursDoNotFeelEachOther) {
  for (const ContactEdges edges : {ContactEdges::Free, ContactEdges::All}) {
    Bodies bodies(0.4);
    bodies.contact.edges = edges;
    bodies.sheet(8, 5, [](double u, double v) { return Vec3{8 * u, 5 * v, 0}; });
    domain::Domain made = bodies.build();
    contact::Interface touching = bodies.attach(made);
    test::add_forces(touching, made);
    for (int i = 1; i <= 30; ++i) {
      std::vector<Vec3> x(made.nodes.position.size());
      const double radius =
          60.0 / i;  // bent to a part of a cylinder, in the end a quarter of a turn and more
      for (Index n = 0; n < made.nodes.count(); ++n) {
        const Vec3& r = made.nodes.reference[n];
        x[n] = {radius * std::sin(r.x / radius), r.y, radius * (1 - std::cos(r.x / radius))};
      }
      test::move_to(touching, made, x, 1e-3);
      EXPECT_EQ(made.contacts[0].active_pairs, 0) << i;
    }
  }
}

/// Two roofs whose ridges cross, or two flat sheets, one above the other.
Bodies roofs(double slope, ContactEdges edges) {
  Bodies bodies(0.1);
  bodies.contact.edges = edges;
  bodies.sheet(2, 3, [&](double u, double v) {
    return Vec3{2 * u - 1, 3 * v - 1.5, -slope * std::fabs(2 * u - 1)};
  });
  bodies.sheet(2, 3, [&](double u, double v) {
    return Vec3{3 * v - 1.37, 2 * u - 1.1, 0.15 + slope * std::fabs(2 * u - 1)};
  });
  return bodies;
}

double push(const Bodies& bodies) {
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  touching.verify_search_every(1);
  test::add_forces(touching, made);
  std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
  for (Index i = 12; i < 24; ++i) x[test::at(made, i)].z -= 0.08;
  test::move_to(touching, made, x, 1e-3);
  Vec3 sum;
  for (Index i = 12; i < 24; ++i) sum += made.contact_force[test::at(made, i)];
  test::verified("two roofs or sheets pressed together: sum of forces", "conservation")
      .below(norm(test::total_force(made)), 1e-12);
  test::verified("two roofs or sheets pressed together: sum of moments", "conservation")
      .below(norm(test::total_moment(made)), 1e-11);
  return sum.z;
}

TEST(Edges, FoldsTouchIfAllTakePart) {
  EXPECT_EQ(push(roofs(0.7, ContactEdges::None)), 0);
  EXPECT_EQ(push(roofs(0.7, ContactEdges::Free)), 0);
  EXPECT_GT(push(roofs(0.7, ContactEdges::All)), 0.1);
  EXPECT_GT(push(roofs(0, ContactEdges::None)), 0.1);
  EXPECT_GE(push(roofs(0, ContactEdges::All)), push(roofs(0, ContactEdges::None)));
}

// Of two flat sheets on each other every line crosses many of the other: nodes see to that. A free edge
// touches the lines that it crosses.
TEST(Edges, LinesInFlatSheetsRest) {
  Bodies bodies(0.1);
  bodies.contact.edges = ContactEdges::All;
  bodies.sheet(5, 5, [](double u, double v) { return Vec3{5 * u, 5 * v, 0}; });
  bodies.sheet(3, 3, [](double u, double v) { return Vec3{3.2 * u + 0.7, 3.2 * v + 0.6, 0.08}; });
  const domain::Domain made = bodies.build();
  const contact::Surface surface = contact::build_surface(bodies.model, made, bodies.contact);
  const std::span<contact::ContactPair> no_nodes;
  contact::EdgeContact edges(bodies.model, made, bodies.contact, surface, no_nodes);
  edges.update(made, contact::present(made), false, true);
  domain::ContactReport report;
  edges.find(made, contact::present(made), true, report);
  int resting = 0;
  int acting = 0;
  for (const contact::EdgePair& pair : edges.pairs()) {
    const bool free = edges.edges().segments_at(pair.key.first).size() == 1 ||
                      edges.edges().segments_at(pair.key.second).size() == 1;
    EXPECT_TRUE(free || pair.share == 0);
    (pair.share > 0 ? acting : resting) += 1;
  }
  // Each of the four free edges crosses three lines.
  EXPECT_EQ(acting, 12);
  EXPECT_GE(resting, 12);
}

/// Every shell, wire and strip that there is, thrown at each other: for what must hold of any motion.
Bodies heap() {
  Bodies bodies(0.06);
  bodies.add_wires(0.03);
  for (int k = 0; k < 4; ++k) {
    const double z = 0.25 * k;
    bodies.sheet(6, 1, [&](double u, double v) { return Vec3{2 * u, 0.3 * k + 0.1 * u, z + 0.1 * v}; });
    bodies.sheet(6, 1, [&](double u, double v) {
      return Vec3{0.4 * k + 0.2, 2 * u - 0.5, z + 0.13 + 0.08 * v};
    });
    bodies.wire(5, [&](double u) { return Vec3{2 * u, 1.5 - 1.4 * u + 0.1 * k, z + 0.02}; });
    bodies.wire(6, [&](double u) { return Vec3{1.9 * u, 0.2 + 0.9 * u, z + 0.12}; });
  }
  return bodies;
}

void stir(domain::Domain& made) {
  made.clock.element_limit = 2e-3;
  for (Index i = 0; i < made.nodes.count(); ++i) {
    const Vec3& r = made.nodes.reference[i];
    made.nodes.velocity[i] = {0.3 * std::sin(7 * r.y), 0.3 * std::sin(5 * r.x + 9 * r.z), -2 * r.z};
  }
}

TEST(Edges, NoContactIsMissed) {
  Bodies bodies = heap();
  domain::Domain made = bodies.build();
  stir(made);
  contact::Interface touching = bodies.attach(made);
  touching.verify_search_every(1);
  test::add_forces(touching, made);
  Index most = 0;
  for (int cycle = 0; cycle < 200; ++cycle) {
    ASSERT_NO_THROW(test::integrate(touching, made, 2e-3)) << "cycle " << cycle;
    most = std::max(most, made.contacts[0].active_pairs);
  }
  EXPECT_GT(most, 30);
  EXPECT_GT(made.contacts[0].searches, 4);
}

TEST(Edges, VerificationNoticesAMissedPair) {
  Cross cross(0.5);
  domain::Domain made = cross.bodies.build();
  const contact::Surface surface = contact::build_surface(cross.bodies.model, made, cross.bodies.contact);
  const contact::Edges edges = contact::build_edges(cross.bodies.model, made, cross.bodies.contact, surface);
  cross.bodies.model.search.expansion = 0.11;
  contact::EdgeSearch narrow(edges, surface, cross.bodies.model.search, 1);
  narrow.update(contact::present(made), false);
  EXPECT_NO_THROW(narrow.verify(contact::present(made)));
  for (Index i = cross.upper; i < cross.lower; ++i) made.nodes.position[test::at(made, i)].z -= 0.45;
  try {
    narrow.verify(contact::present(made));
    FAIL() << "the missed pair was not noticed";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("element 5000"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("element 5001"), std::string::npos) << error.what();
  }
}

// Neither threads nor how far the boxes reach change a bit.
TEST(Edges, ThreadsAndExpansionChangeNothing) {
  std::vector<std::uint64_t> hashes;
  std::vector<std::vector<Vec3>> forces;
  const auto run = [&](int threads, double expansion) {
    Bodies bodies = heap();
    bodies.model.search.expansion = expansion;
    bodies.contact.static_friction = bodies.contact.dynamic_friction = 0.2;
    bodies.contact.viscous_damping = 0.1;
    domain::Domain made = bodies.build(1.0, threads);
    stir(made);
    contact::Interface touching = bodies.attach(made);
    test::add_forces(touching, made);
    forces.emplace_back();
    for (int cycle = 0; cycle < 150; ++cycle) {
      test::integrate(touching, made, 2e-3);
      forces.back().insert(forces.back().end(), made.contact_force.begin(), made.contact_force.end());
    }
    EXPECT_NE(made.contacts[0].friction_energy, 0);
    domain::StateList list;
    made.declare(list);
    touching.declare(list);
    return list.hash();
  };
  for (const int threads : {1, 2, 3, 4}) hashes.push_back(run(threads, 0));
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front());
  for (const double expansion : {0.08, 0.5}) run(1, expansion);
  for (const auto& other : forces)
    for (std::size_t i = 0; i < other.size(); ++i) ASSERT_EQ(norm(other[i] - forces[0][i]), 0) << i;
}

TEST(Edges, AppearWhereShellsErode) {
  Bodies bodies(0.1);
  bodies.contact.edges = ContactEdges::Free;
  bodies.sheet(1, 2, [](double u, double v) { return Vec3{2 * u - 1, 0, 2 * v - 1}; });
  bodies.sheet(1, 1, [](double u, double v) { return Vec3{0, 2 * u - 1, -0.2 - v}; });
  domain::Domain made = bodies.build();
  for (domain::ShellBlock& block : made.shells) {
    const Index active = domain::add_item(block, "active", "-", 1);
    block.double_state.assign(static_cast<std::size_t>(block.groups()) * block.components * lanes, 0.0);
    for (Index place = 0; place < block.elements; ++place) block.set_state(place, active, 1);
  }
  const contact::Surface whole = contact::build_surface(bodies.model, made, bodies.contact);
  contact::Interface touching = bodies.attach(made);
  touching.verify_search_every(1);
  test::add_forces(touching, made);
  for (domain::ShellBlock& block : made.shells)
    for (Index place = 0; place < block.elements; ++place)
      if (block.element[place] == 0) {
        block.set_state(place, block.find("active")->first, 0);
        ++block.eroded;
      }
  test::add_forces(touching, made);
  const contact::Surface& now = touching.surface();
  contact::Edges edges = contact::build_edges(bodies.model, made, bodies.contact, whole);
  EXPECT_EQ(edges.taking_part.size(), 6U + 4U);
  contact::refresh(edges, now, made);
  EXPECT_EQ(edges.taking_part.size(), 4U + 4U);
  std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
  for (Index i = 6; i < 10; ++i) x[test::at(made, i)].z += 0.14;
  test::move_to(touching, made, x, 1e-3);
  EXPECT_EQ(made.contacts[0].active_pairs, 1);
}

}  // namespace
}  // namespace crumple::edges_test
