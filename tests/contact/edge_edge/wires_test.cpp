// SPDX-License-Identifier: BSD-3-Clause
// Beams in contact: with each other and with shells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "contact/bodies.hpp"
#include "support/largest.hpp"

namespace crumple::wires_test {
namespace {

using test::Bodies;
using test::Vec3;

// Two wires of several beams meet obliquely and part again: momenta to round-off, the energy is given back.
TEST(Wires, CrossedWiresBounceElastically) {
  const std::string crossed = "two crossed wires bounce, three offsets: ";
  test::Largest momenta(crossed + "momentum, change", "conservation", 1e-12);
  test::Largest spins(crossed + "moment of momentum, change", "conservation", 1e-12);
  test::Largest energies(crossed + "imbalance over the kinetic energy at first", "conservation", 1e-12);
  test::Largest left(crossed + "energy left in the contact over the most stored", "none", 1e-5);
  for (const double aside : {0.0, 0.13, 0.5}) {
    Bodies bodies;
    bodies.add_wires(0.05);
    const Index first = bodies.wire(4, [&](double u) { return Vec3{2 * u - 1 + aside, 0.1 * u, 0}; });
    const Index second = bodies.wire(3, [](double u) { return Vec3{0.2 * u, 2 * u - 1, 0.13}; });
    domain::Domain made = bodies.build(1.0);
    for (Index i = first; i < second; ++i) made.nodes.velocity[test::at(made, i)] = {0.05, 0, 0.3};
    contact::Interface touching = bodies.attach(made);
    touching.verify_search_every(1);
    test::add_forces(touching, made);
    const test::Impact found = test::impact(touching, made, 1e-3, 3000);
    momenta.add(found.momentum);
    spins.add(found.spin);
    EXPECT_GT(found.stored, 0.03 * found.start.kinetic);
    energies.add(found.imbalance / found.start.kinetic);
    left.add(std::fabs(made.contacts[0].energy) / found.stored, std::to_string(aside));
    EXPECT_EQ(made.contacts[0].active_pairs, 0);
    // Had they passed through each other the second would be at rest again. It got 2 m* v, and m* of points
    // of two edges with unit masses at their ends is 1/2 at least.
    double received = 0;
    for (Index i = second; i < made.nodes.count(); ++i)
      received += made.nodes.mass[test::at(made, i)] * made.nodes.velocity[test::at(made, i)].z;
    EXPECT_GT(received, 0.98 * 2 * 0.5 * 0.3) << aside;
  }
}

// A wire falls on a wire along it, and one end on: the nodes of either carry it.
TEST(Wires, WiresTouchWithTheirNodesToo) {
  const std::string fallen = "wire falls on a wire, along it and end on: ";
  test::Largest forces(fallen + "sum of forces", "conservation", 1e-12);
  test::Largest moments(fallen + "sum of moments", "conservation", 1e-12);
  for (const bool along : {true, false}) {
    Bodies bodies;
    bodies.add_wires(0.05);
    const Index first = bodies.wire(4, [](double u) { return Vec3{2 * u - 1, 0, 0}; });
    const Index second = along ? bodies.wire(3,
                                             [](double u) {
                                               return Vec3{1.8 * u - 0.93, 0, 0.12};
                                             })
                               : bodies.wire(3, [](double u) {
                                   return Vec3{0.13, 0, 0.12 + u};
                                 });
    domain::Domain made = bodies.build(1.0);
    for (Index i = first; i < second; ++i) made.nodes.velocity[test::at(made, i)] = {0, 0, 0.3};
    contact::Interface touching = bodies.attach(made);
    touching.verify_search_every(1);
    test::add_forces(touching, made);
    Index most = 0;
    for (int i = 0; i < 1500; ++i) {
      test::integrate(touching, made, 1e-3);
      most = std::max(most, made.contacts[0].active_pairs);
      forces.add(norm(test::total_force(made)));
      moments.add(norm(test::total_moment(made)));
    }
    EXPECT_GE(most, along ? 6 : 1);
    EXPECT_LT(std::fabs(made.contacts[0].energy), 1e-6);
    for (Index i = first; along && i < second; ++i) {
      EXPECT_LT(made.nodes.position[test::at(made, i)].z, made.nodes.position[test::at(made, second)].z);
    }
  }
}

/// A wire that comes down on a sheet of two shells: with a node over a shell, or with its middle across the
/// free edge. Returns how many pairs touch then.
Index pairs_of_wire_on_sheet(bool over_face, const std::function<void(Bodies&)>& change) {
  Bodies bodies(0.1);
  bodies.add_wires(0.05);
  change(bodies);
  bodies.sheet(2, 1, [](double u, double v) { return Vec3{2 * u, v, 0}; });
  const Index wire = bodies.wire(1, [&](double u) {
    return over_face ? Vec3{0.6, 0.4, 0.15 + u} : Vec3{0.6, 2 * u + 0.3, 0.3 - 0.2 * u};
  });
  domain::Domain made = bodies.build(1.0);
  contact::Interface touching = bodies.attach(made);
  touching.verify_search_every(1);
  test::add_forces(touching, made);
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
  std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
  for (int i = 0; i < 2; ++i) x[test::at(made, wire + i)].z -= over_face ? 0.08 : 0.15;
  test::move_to(touching, made, x, 1e-3);
  const Index pairs = made.contacts[0].active_pairs;
  const Vec3 force = made.contact_force[test::at(made, wire)] + made.contact_force[test::at(made, wire + 1)];
  EXPECT_EQ(force.z > 0, pairs > 0);
  EXPECT_LT(norm(test::total_force(made)), 1e-12);
  EXPECT_LT(norm(test::total_moment(made)), 1e-12);
  return pairs;
}

TEST(Wires, WiresTouchShells) {
  for (const bool over_face : {true, false}) EXPECT_EQ(pairs_of_wire_on_sheet(over_face, [](Bodies&) {}), 1);
}

TEST(Wires, NodesAloneTouchSegmentsInContactsWithoutEdges) {
  using enum model::ContactKind;
  for (const model::ContactKind kind : {SingleSurface, NodesToSurface, SurfaceToSurface}) {
    const auto without_edges = [&](Bodies& bodies) {
      bodies.contact.edges = model::ContactEdges::None;
      bodies.contact.kind = kind;
      if (kind == SingleSurface) return;
      bodies.contact.side[0].parts = {1};
      bodies.contact.side[1].parts = {0};
    };
    EXPECT_EQ(pairs_of_wire_on_sheet(true, without_edges), 1);
    EXPECT_EQ(pairs_of_wire_on_sheet(false, without_edges), 0);
  }
}

// The lower end of an upright wire rests on a sheet until its beam erodes.
TEST(Wires, NodesOfErodedBeamsTouchNothing) {
  for (const bool erodes : {false, true}) {
    Bodies bodies(0.1);
    bodies.sheet(1, 1, [](double u, double v) { return Vec3{2 * u - 1, 2 * v - 1, 0}; });
    bodies.add_wires(0.05);
    const Index wire = bodies.wire(1, [](double u) { return Vec3{0.1, 0.2, 0.3 + u}; });
    domain::Domain made = bodies.build();
    domain::BeamBlock& block = made.beams[0];
    const Index active = domain::add_item(block, "active", "-", 1);
    block.double_state.assign(static_cast<std::size_t>(block.groups()) * block.components * lanes, 0.0);
    block.set_state(0, active, 1);
    contact::Interface touching = bodies.attach(made);
    touching.verify_search_every(1);
    test::add_forces(touching, made);
    if (erodes) {
      block.set_state(0, active, 0);
      ++block.eroded;
    }
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    for (Index i = wire; i < wire + 2; ++i) x[test::at(made, i)].z -= 0.22;
    test::move_to(touching, made, x, 1e-3);
    EXPECT_EQ(made.contacts[0].active_pairs, erodes ? 0 : 1);
  }
}

}  // namespace
}  // namespace crumple::wires_test
