// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/common/damage_growth.hpp"
#include "elements/common/erode.hpp"
#include "elements/common/erosion_check.hpp"
#include "elements/common/prefetch.hpp"
#include "elements/common/short_steps.hpp"
#include "elements/common/stiffness_damping.hpp"
#include "elements/solid/hexahedron_gather.hpp"
#include "elements/solid/quadratic_tetrahedron_nodes.hpp"
#include "elements/solid/solid_formulation.hpp"
#include "elements/solid/tetrahedron_nodes.hpp"
#include "model/solid_nodes.hpp"

// As in chunk.hpp every template has the pack among its parameters.
namespace crumple::elements {

/// Arrays of one tile of solids, on the stack of the thread that processes it.
template <class Real>
struct SolidScratch {
  Real* strain;
  Real* turn;
  Real* rows;
  Real* nodes;
};

/// Rows of what a formulation keeps of the nodes.
template <class Formulation>
inline constexpr int node_rows = Formulation::corners == 8    ? hexahedron_rows
                                 : Formulation::corners == 10 ? quadratic_tetrahedron::rows
                                                              : tetrahedron_row::count;

/// A loop over the packs of one group of a tile, with the place of their first element in the group.
template <class Formulation, class Pack, class Visit>
CRUMPLE_INLINE void for_each_pack_of_group(const SolidTask<RealOf<Pack>>& task, Index first_group,
                                           Index group, const SolidScratch<RealOf<Pack>>& scratch,
                                           const Visit& visit) {
  const std::ptrdiff_t at = first_group + group;
  for (Index lane = 0; lane < lanes; lane += width_of<Pack>)
    visit(SolidPlace<RealOf<Pack>>{task, task.node + at * Formulation::corners * lanes + lane,
                                   task.state + at * static_cast<std::ptrdiff_t>(task.components) * lanes +
                                       lane,
                                   scratch.strain + group * lanes + lane, scratch.turn + group * lanes + lane,
                                   scratch.rows + group * lanes + lane,
                                   scratch.nodes + (group * lanes + lane) * node_rows<Formulation>},
          lane);
}
/// A loop over the packs of one tile.
template <class Formulation, class Pack, class Visit>
CRUMPLE_INLINE void for_each_solid_pack(const SolidTask<RealOf<Pack>>& task, Index first_group, Index groups,
                                        const SolidScratch<RealOf<Pack>>& scratch, const Visit& visit) {
  for (Index group = 0; group < groups; ++group)
    for_each_pack_of_group<Formulation, Pack>(
        task, first_group, group, scratch,
        [&](const SolidPlace<RealOf<Pack>>& place, Index /*lane*/) { visit(place); });
}

/// Value of a gathered row of a tetrahedron that is the corner of a cube and at rest: the sides from the
/// first node to the others come first, then their rates.
template <class Formulation>
CRUMPLE_INLINE constexpr double at_rest(int row) {
  const int side = row / 3;
  const auto axis = static_cast<std::size_t>(row % 3 + 1);
  if (side >= Formulation::corners - 1) return 0;
  if (side < 3) return axis == static_cast<std::size_t>(side) + 1 ? 1 : 0;
  const auto& ends = model::sides_of_tetrahedron[static_cast<std::size_t>(side - 3)];
  return ends[0] == axis || ends[1] == axis ? 0.5 : 0;
}

/// Puts the corner of a cube at rest in the place of failed tetrahedra, as rest_failed() does for shells.
template <class Formulation, class Pack>
CRUMPLE_INLINE void rest_failed_tetrahedra(const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const MaskOf<Pack> gone = gone_for_ever<Pack>(place, Formulation::kept.count);
  if (!any<Pack>(gone)) return;
  static_assert(at_rest<Formulation>(3 * (Formulation::corners - 1)) == 0, "rates follow the sides");
  for (int row = 0; row < node_rows<Formulation>; ++row) {
    Real* const at = place.nodes + row * width_of<Pack>;
    store(at, select<Pack>(gone, Pack(Real(at_rest<Formulation>(row))), load<Pack>(at)));
  }
}

template <class Pack>
materials::SolidMaterialTask<RealOf<Pack>> solid_material_task(const SolidTask<RealOf<Pack>>& task,
                                                               const SolidScratch<RealOf<Pack>>& scratch) {
  using Real = RealOf<Pack>;
  materials::SolidMaterialTask<Real> material;
  material.group_stride = static_cast<std::ptrdiff_t>(task.components) * lanes;
  material.points = task.constants.points;
  material.history = task.constants.history;
  material.strain = scratch.strain;
  material.turn = scratch.turn;
  material.constants = task.material_constants;
  material.step = task.step;
  material.energy = scratch.rows + solid_scratch::material_energy * tile_lanes;
  if (task.constants.can_fail) material.intact = scratch.rows + solid_scratch::intact * tile_lanes;
  if (task.constants.equation_of_state > 0)
    material.equation_of_state = task.material_constants + task.constants.equation_of_state;
  if (task.constants.present_wave_speed > 0) {
    material.viscosity = scratch.rows + solid_scratch::viscosity * tile_lanes;
    material.wave_speed = scratch.rows + solid_scratch::wave_speed * tile_lanes;
  }
  return material;
}

/// Works off one chunk, tile by tile: strains, material, forces.
template <class Formulation, class Pack>
void solid_chunk(const SolidTask<RealOf<Pack>>& task, ElementSums& sums) {
  using Real = RealOf<Pack>;
  using materials::tile_groups;
  alignas(cache_line) Real strain[Formulation::points * materials::solid_components * tile_lanes];
  alignas(cache_line) Real turn[Formulation::points * 9 * tile_lanes];
  alignas(cache_line) Real rows[Formulation::rows * tile_lanes];
  alignas(cache_line) Real nodes[node_rows<Formulation> * tile_lanes];
  const SolidScratch<Real> scratch{strain, turn, rows, nodes};
  GroupForces<Real, Formulation::corners> forces;
  LaneSums<Pack> lane_sums;
  sums = {};
  materials::SolidMaterialTask<Real> material = solid_material_task<Pack>(task, scratch);
  for (Index first = 0; first < task.groups; first += tile_groups) {
    const Index groups = task.groups - first < tile_groups ? task.groups - first : tile_groups;
    const GroupsAhead<Pack> ahead(task, Formulation::corners, first + tile_groups, tile_groups);
    ahead.state();
    if constexpr (Formulation::corners != 8)
      for_each_solid_pack<Formulation, Pack>(task, first, groups, scratch, [](const SolidPlace<Real>& place) {
        if constexpr (Formulation::corners == 10)
          gather_quadratic_tetrahedra<Pack>(place.task.nodes, place.node, place.nodes);
        else
          gather_tetrahedra<Pack>(place.task.nodes, place.node, place.nodes);
        if (place.task.constants.can_fail) rest_failed_tetrahedra<Formulation, Pack>(place);
      });
    for_each_solid_pack<Formulation, Pack>(task, first, groups, scratch, [](const SolidPlace<Real>& place) {
      Formulation::template strains<Pack>(place);
    });
    material.state = task.state + first * material.group_stride;
    material.groups = groups;
    ahead.nodes();
    const PointTile<Real> points{.state = material.state,
                                 .group_stride = material.group_stride,
                                 .groups = groups,
                                 .points = material.points,
                                 .strain = strain,
                                 .turn = turn,
                                 .energy = material.energy,
                                 .intact = material.intact};
    if (task.damage != nullptr) restore_stress(*task.damage, points);
    task.material(material);
    if (task.damage != nullptr) grow_damage(*task.damage, points);
    if (task.erosion != nullptr) check_erosion(*task.erosion, points);
    if (task.short_steps != nullptr) end_short_elements(*task.short_steps, points);
    ahead.forces();
    const DampingTile<Real> damped{.state = material.state,
                                   .group_stride = material.group_stride,
                                   .groups = groups,
                                   .points = material.points,
                                   .strain = strain,
                                   .turn = turn,
                                   .work = rows + solid_scratch::damping_work * tile_lanes,
                                   .limit = rows + solid_scratch::shortest_step * tile_lanes};
    if (task.damping != nullptr) add_damping(*task.damping, damped);
    for (Index group = 0; group < groups; ++group) {
      for_each_pack_of_group<Formulation, Pack>(
          task, first, group, scratch, [&](const SolidPlace<Real>& place, Index lane) {
            keep_forces<Pack>(forces, lane, Formulation::template forces<Pack>(place));
          });
      scatter_group<Pack>(
          task.force, task.target + static_cast<std::ptrdiff_t>(first + group) * Formulation::corners * lanes,
          forces);
    }
    if (task.damping != nullptr) {
      end_damping(*task.damping, damped);
      add_damping_energy<Pack>(rows + solid_scratch::damping_energy * tile_lanes, groups,
                               task.energy + first);
    }
    if (task.short_steps != nullptr)
      mark_short_elements(*task.short_steps, points, rows + solid_scratch::shortest_step * tile_lanes);
    for (Index group = 0; group < groups; ++group) {
      const GroupSums own_sums = sums_of_group(task, first + group);
      lane_sums.add_group(rows + group * lanes, own_sums);
      if (task.constants.can_fail) {
        Real* const own = material.state + group * material.group_stride + task.constants.own * lanes;
        erode<Pack>(
            {own + solid_state::active * lanes, own + (solid_state::own + Formulation::kept.count) * lanes,
             rows + group * lanes, rows + solid_scratch::intact * tile_lanes + group * lanes},
            own_sums, sums);
      }
    }
  }
  sums.shortest_step = lane_sums.shortest_step();
}

}  // namespace crumple::elements
