// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "domain/damped_block.hpp"
#include "model/section.hpp"

namespace crumple::domain {

/// Points through the thickness, one beside the other, that one law brings up to date with the same numbers.
struct LayerRun {
  int law = 0;          ///< place in the list of constitutive laws
  Index first = 0;      ///< the lowest of them
  Index points = 0;     ///< in each plane
  Index history = 0;    ///< first component of the law's items in the state
  Index constants = 0;  ///< first of its numbers in ElementBlock::material_constants
  bool can_fail = false;
};

/// The quadrilaterals or the triangles of one part: one formulation and integration rule, one material or one
/// stack of layers, so that a kernel meets no choice inside. A triangle's fourth node repeats its third. Its
/// item "stress" is [plane][thickness][xx, yy, xy, yz, zx].
struct ShellBlock : DampedBlock {
  model::ShellFormulation formulation = model::ShellFormulation::BelytschkoTsay;
  Index thickness_points = 0;        ///< integration points through the thickness
  Index plane_points = 1;            ///< in plane; over each of them are thickness_points
  Index layup = no_index;            ///< in Model::layups; no_index: one law for all points
  bool has_own_layup = false;        ///< the layup is that of the elements, not of the part
  std::vector<LayerRun> runs;        ///< of layered shells, upwards; else empty
  bool layers_hold = false;          ///< the elements do not go, because some layers cannot fail
  std::vector<double> point_place;   ///< of the points over half the thickness, -1 to 1 [-]
  std::vector<double> point_weight;  ///< of the points, summing to 1 [-]

  /// The domain nodes of element `place`.
  std::array<Index, 4> nodes_of(Index place) const;
};

}  // namespace crumple::domain
