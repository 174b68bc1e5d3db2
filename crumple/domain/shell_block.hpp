// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "domain/damped_block.hpp"
#include "model/section.hpp"

namespace crumple::domain {

/// The quadrilaterals or the triangles of one part: one formulation, material and integration rule, so that a
/// kernel meets no choice inside. A triangle's fourth node repeats its third. Its item "stress" is
/// [plane][thickness][xx, yy, xy, yz, zx].
struct ShellBlock : DampedBlock {
  model::ShellFormulation formulation = model::ShellFormulation::BelytschkoTsay;
  Index thickness_points = 0;  ///< integration points through the thickness
  Index plane_points = 1;      ///< in plane; over each of them are thickness_points

  /// The domain nodes of element `place`.
  std::array<Index, 4> nodes_of(Index place) const;
};

}  // namespace crumple::domain
