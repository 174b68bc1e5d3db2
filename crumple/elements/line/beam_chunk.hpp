// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/common/erode.hpp"
#include "elements/line/beam_formulation.hpp"

namespace crumple::elements {

/// Subtracts internal forces from the sums at the nodes, element after element: the order does not depend on
/// the width of the pack. `target` is [2][lanes] from the first element.
template <class Pack, bool Turns>
CRUMPLE_INLINE void scatter_beams(domain::NodeForce* sums, const Index* target,
                                  const BeamForces<Pack>& internal) {
  constexpr int width = width_of<Pack>;
  alignas(cache_line) double rows[9][width];
  const math::PackVec3<Pack> vectors[3] = {internal.force, internal.moment[0], internal.moment[1]};
  for (int v = 0; v < 3; ++v) {
    store(rows[3 * v], vectors[v].x);
    store(rows[3 * v + 1], vectors[v].y);
    store(rows[3 * v + 2], vectors[v].z);
  }
  for (int lane = 0; lane < width; ++lane) {
    domain::NodeForce& first = sums[target[lane]];
    domain::NodeForce& second = sums[target[lanes + lane]];
    for (int axis = 0; axis < 3; ++axis) {
      first.force[axis] += rows[axis][lane];
      second.force[axis] -= rows[axis][lane];
      if constexpr (Turns) {
        first.moment[axis] -= rows[3 + axis][lane];
        second.moment[axis] -= rows[6 + axis][lane];
      }
    }
  }
}

/// Works off one chunk of beams. As in chunk.hpp the pack is among the parameters.
template <class Formulation, class Pack>
void beam_chunk(const BeamTask& task, ElementSums& sums) {
  alignas(cache_line) double rows[beam_row::count * materials::tile_lanes] = {};
  LaneSums<Pack> lane_sums;
  sums = {};
  for (Index group = 0; group < task.groups; ++group) {
    double* const state = task.state + static_cast<std::ptrdiff_t>(group) * task.components * lanes;
    const std::ptrdiff_t nodes = static_cast<std::ptrdiff_t>(group) * 2 * lanes;
    for (Index lane = 0; lane < lanes; lane += width_of<Pack>) {
      const BeamPlace place{task, task.node + nodes + lane, state + lane, rows + lane};
      scatter_beams<Pack, Formulation::turns>(task.force, task.target + nodes + lane,
                                              Formulation::template forces<Pack>(place));
    }
    const GroupSums own_sums = sums_of_group(task, group);
    lane_sums.add_group(rows, own_sums);
    if (task.damping_item > 0)
      add_damping_energy<Pack>(rows + beam_row::damping_energy * materials::tile_lanes, 1, own_sums.energy);
    if constexpr (Formulation::can_fail)
      if (Formulation::fails(task.constants))
        erode<Pack>({state + beam_state::active * lanes, state + Formulation::energy * lanes, rows,
                     rows + beam_row::intact * materials::tile_lanes},
                    own_sums, sums);
  }
  sums.shortest_step = lane_sums.shortest_step();
}

}  // namespace crumple::elements
