// SPDX-License-Identifier: BSD-3-Clause
#include "output/paraview/wall_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "output/paraview/paraview_series.hpp"
#include "output/sample.hpp"
#include "output/vtu_reader.hpp"

namespace crumple::output::wall_mesh_test {
namespace {

using model::WallShape;

/// Volume inside faces whose normals point outward, by the divergence theorem.
double volume(const WallMesh& mesh) {
  double sum = 0;
  for (const auto& face : mesh.faces)
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      sum += dot(mesh.points[face[0]], cross(mesh.points[face[k]], mesh.points[face[k + 1]])) / 6;
  return sum;
}

model::RigidWall make(WallShape shape) {
  model::RigidWall wall;
  wall.id = 12;
  wall.shape = shape;
  wall.point = {1, 2, 3};
  wall.normal = {0, 0, 1};
  wall.edge = {1, 0, 0};
  return wall;
}

TEST(WallMesh, ClosedWallsHaveTheirVolumeAndFacesPointOutward) {
  model::RigidWall prism = make(WallShape::Prism);
  prism.lengths = {2, 3, 4};
  EXPECT_NEAR(volume(wall_mesh(prism, {})), 24, 1e-12);
  model::RigidWall cylinder = make(WallShape::Cylinder);
  cylinder.radius = 2;
  cylinder.lengths[0] = 5;
  // A prism of 48 sides.
  EXPECT_NEAR(volume(wall_mesh(cylinder, {})), 5 * 24 * 4 * std::sin(2 * std::numbers::pi / 48), 1e-12);
  model::RigidWall sphere = make(WallShape::Sphere);
  sphere.radius = 2;
  EXPECT_NEAR(volume(wall_mesh(sphere, {})) / (4.0 / 3 * std::numbers::pi * 8), 1, 0.01);
}

TEST(WallMesh, WhatIsInfiniteIsCutToTheModel) {
  model::Nodes nodes;
  nodes.id = {1, 2};
  nodes.position = {{-5, 0, 0}, {9, 2, 7}};
  const WallMesh mesh = wall_mesh(make(WallShape::Flat), nodes);
  ASSERT_EQ(mesh.points.size(), 4U);
  EXPECT_EQ(mesh.points[0].x, -5);
  EXPECT_EQ(mesh.points[2].x, 9);
  EXPECT_EQ(mesh.points[0].z, 3);
  EXPECT_TRUE(wall_mesh(make(WallShape::Plane), nodes).faces.empty());
}

class WallSeries : public SampleTest {};

TEST_F(WallSeries, WallsAreASecondPartOfEachFrameAndMove) {
  model::RigidWall wall = make(WallShape::Prism);
  wall.lengths = {2, 3, 4};
  model_.rigid_walls.push_back(wall);
  domain_.walls.push_back({.id = 12});
  ParaviewSeries series(folder_, "run", view());
  series.write_frame(view());
  domain_.walls.back().displacement_now = {0, 0, 0.5};
  series.write_frame(view());
  const std::string collection = read(series.collection());
  EXPECT_NE(collection.find("part=\"1\" file=\"vtu/run_walls_000001.vtu\""), std::string::npos);
  const VtuReader file(read(folder_ / "vtu/run_walls_000001.vtu"));
  EXPECT_EQ(file["position"].values<float>()[2], 3.5F);
  EXPECT_EQ(file["wall"].values<std::int64_t>(), std::vector<std::int64_t>(6, 12));
}

}  // namespace
}  // namespace crumple::output::wall_mesh_test
