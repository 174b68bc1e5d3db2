// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/index.hpp"
#include "math/vec3.hpp"
#include "model/model.hpp"

namespace crumple::output {

/// Points and faces to draw a wall with.
struct WallMesh {
  std::vector<math::Vec3> points;         ///< where the wall is at time zero [length]
  std::vector<std::vector<Index>> faces;  ///< points around each
};

/// The surface of a rigid wall of any shape but an infinite plane, for which it is empty. What is infinite is
/// cut to the size of the model.
WallMesh wall_mesh(const model::RigidWall& wall, const model::Nodes& nodes);

}  // namespace crumple::output
