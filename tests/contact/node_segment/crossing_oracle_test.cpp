// SPDX-License-Identifier: BSD-3-Clause
//
// Nothing passes through a mid-surface unnoticed. An independent detector finds every passage of a node
// through a flat triangle of a segment in a step, by the sign of a tetrahedron's volume and bisection in
// time; the contact must hold every such node as one that is on the wrong side, or that has just come back.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "contact/bodies.hpp"

namespace crumple::crossing_oracle_test {
namespace {

using test::Bodies;
using test::Vec3;

using Triangle = std::array<Vec3, 3>;

double volume(const Vec3& p, const Triangle& t) {
  return dot(p - t[0], cross(t[1] - t[0], t[2] - t[0]));
}

bool contains(const Vec3& p, const Triangle& t) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  for (int k = 0; k < 3; ++k)
    if (dot(cross(t[(k + 1) % 3] - t[k], p - t[k]), n) < 0) return false;
  return true;
}

Triangle between(const Triangle& a, const Triangle& b, double t) {
  Triangle mixed;
  for (int k = 0; k < 3; ++k) mixed[k] = (1 - t) * a[k] + t * b[k];
  return mixed;
}

bool goes_through(const Vec3& p0, const Vec3& p1, const Triangle& t0, const Triangle& t1) {
  const bool above = volume(p0, t0) > 0;
  if (above == (volume(p1, t1) > 0)) return false;
  double before = 0;
  double after = 1;
  for (int i = 0; i < 50; ++i) {
    const double m = 0.5 * (before + after);
    ((volume((1 - m) * p0 + m * p1, between(t0, t1, m)) > 0) == above ? before : after) = m;
  }
  return contains((1 - after) * p0 + after * p1, between(t0, t1, after));
}

Triangle quarter(const std::vector<Vec3>& x, const Index* nodes, int k) {
  const Vec3 centre = 0.25 * (x[nodes[0]] + x[nodes[1]] + x[nodes[2]] + x[nodes[3]]);
  return {x[nodes[k]], x[nodes[(k + 1) % 4]], centre};
}

/// (node, segment) pairs of which the node went through the segment.
std::set<std::pair<Index, Index>> passages(const contact::Surface& surface, const std::vector<Vec3>& x0,
                                           const std::vector<Vec3>& x1) {
  std::set<std::pair<Index, Index>> found;
  for (const Index node : surface.nodes)
    for (Index s = 0; s < surface.segments(); ++s) {
      if (surface.owns(s, node) || norm(x1[node] - x1[surface.segment(s)[0]]) > 1.0) continue;
      for (int k = 0; k < 4; ++k)
        if (goes_through(x0[node], x1[node], quarter(x0, surface.segment(s), k),
                         quarter(x1, surface.segment(s), k)))
          found.emplace(node, s);
    }
  return found;
}

std::set<UserId> astray(const contact::Interface& touching) {
  std::set<UserId> nodes;
  for (const contact::Penetration& pair : touching.penetrations())
    if (pair.depth > pair.reach) nodes.insert(pair.node);
  return nodes;
}

// Two wavy sheets of loose masses, thrown at each other with much too soft a contact and random velocities:
// nodes go through by the hundred. Each passage is noticed, and in the end all nodes are pushed back.
TEST(CrossingOracle, EveryPassageIsNoticed) {
  Bodies bodies(0.06);
  bodies.sheet(9, 7, [](double u, double v) { return Vec3{2 * u, 1.5 * v, 0.03 * std::sin(7 * u + 4 * v)}; });
  bodies.sheet(8, 8, [](double u, double v) {
    return Vec3{2 * u + 0.05, 1.5 * v - 0.03, 0.12 + 0.03 * std::sin(5 * u - 6 * v)};
  });
  bodies.model.control.contact_stiffness_scale = 0.02;
  domain::Domain made = bodies.build(1.0);
  for (Index i = 0; i < made.nodes.count(); ++i)
    made.nodes.velocity[i] = {0.15 * std::sin(12.9 * i), 0.15 * std::sin(78.2 * i),
                              made.nodes.reference[i].z > 0.06 ? -0.35 : 0.35};
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  int noticed = 0;
  for (int cycle = 0; cycle < 250; ++cycle) {
    const std::vector<Vec3> x0(made.nodes.position.begin(), made.nodes.position.end());
    const std::set<UserId> before = astray(touching);
    test::integrate(touching, made, 4e-3);
    const std::vector<Vec3> x1(made.nodes.position.begin(), made.nodes.position.end());
    const std::set<UserId> now = astray(touching);
    for (const auto& [node, segment] : passages(touching.surface(), x0, x1)) {
      const UserId id = touching.surface().node_id[touching.surface().place[node]];
      EXPECT_TRUE(now.contains(id) || before.contains(id)) << "node " << id << " at cycle " << cycle;
      ++noticed;
    }
  }
  EXPECT_GT(noticed, 20);
}

}  // namespace
}  // namespace crumple::crossing_oracle_test
