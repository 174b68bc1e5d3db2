// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/inside_outside.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "contact/bodies.hpp"
#include "support/largest.hpp"

namespace crumple::inside_outside_test {
namespace {

using contact::NearestPoint;
using contact::SurfaceAt;
using test::Bodies;
using test::Vec3;

struct Mesh {
  explicit Mesh(const Bodies& bodies)
      : made(bodies.build()), surface(contact::build_surface(bodies.model, made, bodies.contact)) {}
  SurfaceAt at() const { return {&surface, {made.nodes.position.data(), made.nodes.velocity.data(), 0}}; }
  domain::Domain made;
  contact::Surface surface;
};

/// A sheet of warped quadrilaterals bent to a ridge of the given angle between its two halves.
Bodies rough_ridge(double angle, unsigned seed) {
  Bodies bodies(0.01);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-0.006, 0.006);
  bodies.sheet(6, 4, [&](double u, double v) {
    const double s = u - 0.5;
    const double bend = s > 0 ? 0.5 * angle : -0.5 * angle;
    return Vec3{s * std::cos(bend) + noise(random), v + noise(random), s * std::sin(bend) + noise(random)};
  });
  return bodies;
}

// The mesh normal is the normalised sum of the neighbours' normals: for a ridge between two planes the
// direction of the bisector.
TEST(InsideOutside, MeshNormalBisectsARidge) {
  test::Largest off("normal of the mesh at ridges of 17 to 178 degrees: component along the bisector, off 1",
                    "bisector", 1e-12);
  for (const double angle : {0.3, 1.0, 2.0, 2.6, 3.1}) {
    Bodies bodies(0.01);
    bodies.sheet(2, 1, [&](double u, double v) {
      const double s = 2 * u - 1;
      return Vec3{std::fabs(s) * std::sin(0.5 * (std::numbers::pi - angle)) * (s < 0 ? -1 : 1), v,
                  -std::fabs(s) * std::cos(0.5 * (std::numbers::pi - angle))};
    });
    const Mesh mesh(bodies);
    for (Index s = 0; s < 2; ++s)
      for (int k = 0; k < 4; ++k) {
        const Index edge = mesh.surface.topology.edges_of[s][k];
        if (mesh.surface.topology.kind[edge] != contact::EdgeKind::Shared) continue;
        const Vec3 normal = contact::mesh_normal(mesh.at(), s, mesh.at().shape(s), k);
        off.compare(std::fabs(normal.z), 1, 1, "angle " + std::to_string(angle));
        EXPECT_NEAR(norm(normal), 1.0, 1e-12);
      }
  }
}

TEST(InsideOutside, NeighboursSeeTheSameDividingPlane) {
  const Bodies bodies = rough_ridge(1.3, 3);
  const Mesh mesh(bodies);
  const contact::Topology& topology = mesh.surface.topology;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.5, 1.0);
  test::Largest planes("dividing plane of two segments: distance of edge and normal from it", "none", 1e-12);
  for (Index e = 0; e < topology.edges(); ++e) {
    if (topology.kind[e] != contact::EdgeKind::Shared) continue;
    const auto pair = topology.at_edge(e);
    int k[2] = {0, 0};
    for (int i = 0; i < 2; ++i)
      while (topology.edges_of[pair[i]][k[i]] != e) ++k[i];
    const Vec3 p{place(random), place(random), place(random)};
    EXPECT_EQ(contact::inner_side(mesh.at(), pair[0], k[0], p),
              -contact::inner_side(mesh.at(), pair[1], k[1], p));
    // The plane holds the edge and the mesh normal.
    const Index* nodes = mesh.surface.segment(pair[0]);
    const Vec3 normal = contact::mesh_normal(mesh.at(), pair[0], mesh.at().shape(pair[0]), k[0]);
    for (const int end : {k[0], (k[0] + 1) % 4}) {
      const Vec3 on_plane = mesh.at().x[nodes[end]] + 0.7 * normal;
      planes.add(std::fabs(contact::inner_side(mesh.at(), pair[0], k[0], on_plane)));
    }
  }
}

// Every point near the surface has one owner: brute force over all segments, by the rules of the local
// search, against the nearest point of the whole surface.
TEST(InsideOutside, EveryPointHasExactlyOneOwner) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const double angle : {-0.3, -0.2, 0.0, 0.3, 0.9, 1.8, 2.6}) {
    const Bodies bodies = rough_ridge(angle, 17);
    Mesh mesh(bodies);
    mesh.surface.place.push_back(0);  // of the free node below: on the same side as all
    const SurfaceAt at = mesh.at();
    int checked = 0;
    for (int trial = 0; trial < 4000; ++trial) {
      // A point at a small distance from a random place of the surface, on either side.
      const Index base =
          std::min(static_cast<Index>(unit(random) * mesh.surface.segments()), mesh.surface.segments() - 1);
      const contact::SegmentShape shape = at.shape(base);
      const double u = unit(random);
      const double v = unit(random);
      const Vec3 foot = (1 - v) * ((1 - u) * shape.corner[0] + u * shape.corner[1]) +
                        v * ((1 - u) * shape.corner[3] + u * shape.corner[2]);
      const Vec3 up = normalised(contact::area_normal(shape));
      const Vec3 p = foot + (unit(random) - 0.5) * 0.04 * up;

      // All segments on which the nearest place of the surface around is found.
      std::vector<std::pair<Index, NearestPoint>> local;
      double smallest = 1e30;
      AlignedArray<Vec3> x = mesh.made.nodes.position;
      x.push_back(p);  // a free node, which no segment owns
      const SurfaceAt with{&mesh.surface, {x.data(), nullptr, 0}};
      const Index node = static_cast<Index>(x.size()) - 1;
      for (Index s = 0; s < mesh.surface.segments(); ++s) {
        const NearestPoint nearest = contact::nearest_point(with.shape(s), p);
        smallest = std::min(smallest, nearest.distance_squared);
        if (std::sqrt(nearest.distance_squared) < 0.05 && contact::nearest_around(with, node, s, nearest))
          local.emplace_back(s, nearest);
      }
      ASSERT_FALSE(local.empty()) << "dead zone at angle " << angle;
      // Of those that push alike one survives, and the nearest place is never lost.
      std::vector<bool> kept(local.size(), true);
      for (std::size_t i = 0; i < local.size(); ++i)
        for (std::size_t j = i + 1; j < local.size(); ++j) {
          if (!kept[i] || !kept[j]) continue;
          ASSERT_TRUE(contact::connected(mesh.surface, local[i].first, local[j].first));
          const Vec3 a = normalised(p - local[i].second.point);
          const Vec3 b = normalised(p - local[j].second.point);
          if (dot(a, b) < 0.87) continue;
          const bool first = contact::owns_first(with, local[i].first, local[j].first, p,
                                                 std::sqrt(local[i].second.distance_squared),
                                                 std::sqrt(local[j].second.distance_squared));
          const bool reverse = contact::owns_first(with, local[j].first, local[i].first, p,
                                                   std::sqrt(local[j].second.distance_squared),
                                                   std::sqrt(local[i].second.distance_squared));
          EXPECT_NE(first, reverse) << "both or none own the point";
          kept[first ? j : i] = false;
        }
      int owners = 0;
      double nearest_kept = 1e30;
      for (std::size_t i = 0; i < local.size(); ++i)
        if (kept[i]) {
          ++owners;
          nearest_kept = std::min(nearest_kept, local[i].second.distance_squared);
        }
      ASSERT_GE(owners, 1);
      // On shallow ridges one owner; in sharp concave ones two walls. Warped segments part by their planes,
      // which may prefer a foot that is further by the warp, not by more.
      if (std::fabs(angle) < 0.5) {
        EXPECT_EQ(owners, 1) << "angle " << angle;
      }
      EXPECT_NEAR(std::sqrt(nearest_kept), std::sqrt(smallest), 0.15 * std::sqrt(smallest) + 1e-9);
      ++checked;
    }
    EXPECT_EQ(checked, 4000);
  }
}

// On planes the dividing plane is where both segments are equally far.
TEST(InsideOutside, DividingPlaneIsEquidistantInAConcaveRidge) {
  Bodies bodies(0.01);
  const double slope = 0.35;
  bodies.sheet(2, 1, [&](double u, double v) {
    const double s = 2 * u - 1;
    return Vec3{s, v, slope * std::fabs(s)};
  });
  const Mesh mesh(bodies);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 p{0.2 * (unit(random) - 0.5), 0.2 + 0.6 * unit(random), 0.15 + 0.1 * unit(random)};
    double distance[2] = {0, 0};
    double side[2] = {0, 0};
    for (Index s = 0; s < 2; ++s) {
      distance[s] = std::sqrt(contact::nearest_point(mesh.at().shape(s), p).distance_squared);
      for (int k = 0; k < 4; ++k) side[s] += contact::inner_side(mesh.at(), s, k, p);
      EXPECT_EQ(contact::inside(mesh.at(), s, p), side[s] >= 0);
    }
    EXPECT_EQ(side[0] > 0, distance[0] < distance[1]);
  }
}

}  // namespace
}  // namespace crumple::inside_outside_test
