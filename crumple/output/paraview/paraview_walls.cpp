// SPDX-License-Identifier: BSD-3-Clause
#include "output/paraview/paraview_walls.hpp"

#include <cstdint>

namespace crumple::output {

ParaviewWalls::ParaviewWalls(const View& view) {
  constexpr std::uint8_t vtk_polygon = 7;
  std::vector<std::int32_t> connectivity;
  std::vector<std::int32_t> offsets;
  std::vector<std::int64_t> ids;
  for (std::size_t i = 0; i < view.model.rigid_walls.size(); ++i) {
    WallMesh mesh = wall_mesh(view.model.rigid_walls[i], view.model.nodes);
    if (mesh.faces.empty()) continue;
    for (const std::vector<Index>& face : mesh.faces) {
      for (const Index point : face) connectivity.push_back(points_ + point);
      offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
      ids.push_back(view.model.rigid_walls[i].id);
    }
    points_ += static_cast<Index>(mesh.points.size());
    meshes_.emplace_back(static_cast<Index>(i), std::move(mesh));
  }
  faces_ = static_cast<Index>(offsets.size());
  topology_.push_back(packer_.array<std::int32_t>("connectivity", 1, connectivity));
  topology_.push_back(packer_.array<std::int32_t>("offsets", 1, offsets));
  topology_.push_back(
      packer_.array<std::uint8_t>("types", 1, std::vector<std::uint8_t>(offsets.size(), vtk_polygon)));
  wall_id_ = packer_.array<std::int64_t>("wall", 1, ids);
}

std::string ParaviewWalls::text(const View& view) {
  std::vector<float> values;
  values.reserve(3 * static_cast<std::size_t>(points_));
  for (const auto& [wall, mesh] : meshes_)
    for (const math::Vec3& point : mesh.points) {
      const math::Vec3 now = point + view.domain.walls[wall].displacement_now;
      for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(now[axis]));
    }
  const VtuArray positions = packer_.array<float>("position", 3, values);
  VtuGrid grid;
  grid.time = view.domain.clock.time;
  grid.points = points_;
  grid.cells = faces_;
  grid.positions = {&positions};
  for (const VtuArray& array : topology_) grid.topology.push_back(&array);
  grid.cell_data = {&wall_id_};
  return vtu_text(grid);
}

}  // namespace crumple::output
