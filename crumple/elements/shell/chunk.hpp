// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/common/damage_growth.hpp"
#include "elements/common/erode.hpp"
#include "elements/common/erosion_check.hpp"
#include "elements/common/lane_sums.hpp"
#include "elements/common/prefetch.hpp"
#include "elements/common/short_steps.hpp"
#include "elements/common/stiffness_damping.hpp"
#include "elements/shell/erosion.hpp"
#include "elements/shell/formulation.hpp"

// Every template here has the pack among its parameters: one of the number type alone would be the same
// function for all instruction sets, and the linker would keep any of them.
namespace crumple::elements {

/// Arrays of one tile, on the stack of the thread that processes it.
template <class Real>
struct TileScratch {
  Real* strain;
  Real* rows;
  Real* area;
  Real* nodes;
};

/// A loop over the packs of one tile.
template <class Pack, class Visit>
CRUMPLE_INLINE void for_each_pack(const ShellTask<RealOf<Pack>>& task, Index first_group, Index groups,
                                  const TileScratch<RealOf<Pack>>& scratch, const Visit& visit) {
  for (Index group = 0; group < groups; ++group)
    for (Index lane = 0; lane < lanes; lane += width_of<Pack>) {
      const std::ptrdiff_t at = first_group + group;
      visit(ShellPlace<RealOf<Pack>>{task, task.node + at * 4 * lanes + lane,
                                     task.state + at * static_cast<std::ptrdiff_t>(task.components) * lanes +
                                         lane,
                                     scratch.strain + group * lanes + lane,
                                     scratch.rows + group * lanes + lane, scratch.area + group * lanes + lane,
                                     scratch.nodes + (group * lanes + lane) * gather_row::count},
            task.target + at * 4 * lanes + lane);
    }
}

/// What is the same for every tile and plane of a chunk.
template <class Formulation, class Pack>
materials::MaterialTask<RealOf<Pack>> material_task(const ShellTask<RealOf<Pack>>& task) {
  using Real = RealOf<Pack>;
  materials::MaterialTask<Real> material;
  material.group_stride = static_cast<std::ptrdiff_t>(task.components) * lanes;
  material.points = task.constants.points;
  material.all_points = task.constants.points * Formulation::planes;
  material.history = task.constants.history;
  material.weight = task.constants.weight;
  material.constants = task.material_constants;
  material.step = task.step;
  return material;
}

/// Brings the points of a tile up to date, plane by plane.
template <class Formulation, class Pack>
void update_points(const ShellTask<RealOf<Pack>>& task, const TileScratch<RealOf<Pack>>& scratch,
                   materials::MaterialTask<RealOf<Pack>>& material) {
  const int points = task.constants.points;
  for (int plane = 0; plane < Formulation::planes; ++plane) {
    const auto row = [&](int first) { return scratch.rows + (first + plane) * tile_lanes; };
    material.first_point = plane * points;
    material.strain = scratch.strain + material.first_point * materials::components * tile_lanes;
    material.area = Formulation::own_areas ? scratch.area + material.first_point * tile_lanes : nullptr;
    material.energy = row(scratch_row::material_energy);
    material.thickness_strain = row(scratch_row::thickness_strain);
    // One-point shells alone have hourglass stresses that yield.
    const bool one_point = Formulation::planes == 1 && !task.constants.viscous;
    material.yield = one_point ? scratch.rows + scratch_row::yield * tile_lanes : nullptr;
    material.intact = task.constants.can_fail ? row(scratch_row::intact) : nullptr;
    if (task.layer_calls == 0)
      task.material(material);
    else
      update_layers<RealOf<Pack>, Pack>(task, material, plane, Formulation::planes);
  }
}

/// What one call of a law leaves, for one plane of a tile.
template <class Real>
struct LayerRows {
  alignas(cache_line) Real energy[tile_lanes];
  alignas(cache_line) Real thickness_strain[tile_lanes];
  alignas(cache_line) Real yield[materials::yield_row::count * tile_lanes];
  alignas(cache_line) Real intact[tile_lanes];
};

/// Adds what the law of some layers has left to what the driver reads. An element is intact as long as a
/// layer is that can fail.
template <class Real, class Pack>
void add_layers(const LayerRows<Real>& own, bool can_fail, Index count,
                const materials::MaterialTask<Real>& sum) {
  namespace yield_row = materials::yield_row;
  for (Index k = 0; k < count; ++k) {
    sum.energy[k] += own.energy[k];
    sum.thickness_strain[k] += own.thickness_strain[k];
    if (can_fail && sum.intact != nullptr && own.intact[k] != Real(0)) sum.intact[k] = Real(1);
  }
  if (sum.yield == nullptr) return;
  for (Index k = 0; k < count; ++k) {
    sum.yield[yield_row::stress * tile_lanes + k] += own.yield[yield_row::stress * tile_lanes + k];
    sum.yield[yield_row::left * tile_lanes + k] += own.yield[yield_row::left * tile_lanes + k] - Real(1);
  }
}

/// One plane of a layered shell: each law for its layers. `material` says where all points are, and where
/// the sums go.
template <class Real, class Pack>
void update_layers(const ShellTask<Real>& task, const materials::MaterialTask<Real>& material, int plane,
                   int planes) {
  using materials::components;
  LayerRows<Real> own;
  bool holds = task.layers_hold;
  bool fails = false;
  for (int i = 0; i < task.layer_calls; ++i) fails = fails || task.layers[i].can_fail;
  holds = holds || !fails;
  const Index count = material.groups * lanes;
  for (Index k = 0; k < count; ++k) {
    material.energy[k] = material.thickness_strain[k] = Real(0);
    if (material.intact != nullptr) material.intact[k] = holds ? Real(1) : Real(0);
    if (material.yield == nullptr) continue;
    material.yield[materials::yield_row::stress * tile_lanes + k] = Real(0);
    material.yield[materials::yield_row::left * tile_lanes + k] = Real(1);
  }
  for (int i = 0; i < task.layer_calls; ++i) {
    const LayerCall<Real>& call = task.layers[i];
    materials::MaterialTask<Real> layers = material;
    layers.points = call.points;
    layers.all_points = planes * call.points;
    layers.first_point = plane * call.points;
    layers.stress = material.stress + components * (material.first_point + call.first - layers.first_point);
    layers.history = call.history;
    layers.strain = material.strain + call.first * components * tile_lanes;
    layers.weight = material.weight + call.first;
    if (material.area != nullptr) layers.area = material.area + call.first * tile_lanes;
    layers.constants = material.constants + call.constants;
    layers.energy = own.energy;
    layers.thickness_strain = own.thickness_strain;
    layers.yield = material.yield != nullptr ? own.yield : nullptr;
    layers.intact = call.can_fail ? own.intact : nullptr;
    call.update(layers);
    add_layers<Real, Pack>(own, call.can_fail, count, material);
  }
}

/// Takes the stress, with its share in the work of the step, from all layers of elements that go in it: those
/// that cannot fail still have theirs, and the forces of the element end with the step. Plain loops over
/// lanes: the same bits for every instruction set.
template <class Formulation, class Pack>
void drop_layers(const ShellTask<RealOf<Pack>>& task, const TileScratch<RealOf<Pack>>& scratch,
                 const materials::MaterialTask<RealOf<Pack>>& material) {
  using Real = RealOf<Pack>;
  using materials::components;
  const int points = task.constants.points;
  Real* const intact = scratch.rows + scratch_row::intact * tile_lanes;
  Real* const energy = scratch.rows + scratch_row::material_energy * tile_lanes;
  for (Index k = 0; k < material.groups * lanes; ++k) {
    bool goes = true;
    for (int plane = 0; plane < Formulation::planes; ++plane)
      goes = goes && intact[plane * tile_lanes + k] == Real(0);
    if (!goes) continue;
    Real* const state = material.state + k / lanes * material.group_stride + k % lanes;
    for (int p = 0; p < Formulation::planes * points; ++p) {
      Real work = Real(0);
      for (int c = p * components; c < (p + 1) * components; ++c) {
        work += state[c * lanes] * scratch.strain[c * tile_lanes + k];
        state[c * lanes] = Real(0);
      }
      const Real area = Formulation::own_areas ? scratch.area[p * tile_lanes + k] : Real(1);
      energy[p / points * tile_lanes + k] -= Real(0.5) * task.constants.weight[p % points] * area * work;
    }
  }
}

/// The points of a tile, for damage and for criteria of failure. Laws without failure of their own leave no
/// `intact`.
template <class Formulation, class Pack>
PointTile<RealOf<Pack>> point_tile(const TileScratch<RealOf<Pack>>& scratch,
                                   const materials::MaterialTask<RealOf<Pack>>& material) {
  using Real = RealOf<Pack>;
  const auto row = [&](int first) { return scratch.rows + first * tile_lanes; };
  return PointTile<Real>{.state = material.state,
                         .group_stride = material.group_stride,
                         .groups = material.groups,
                         .planes = Formulation::planes,
                         .points = material.points,
                         .strain = scratch.strain,
                         .thickness_strain = row(scratch_row::thickness_strain),
                         .weight = material.weight,
                         .area = Formulation::own_areas ? scratch.area : nullptr,
                         .energy = row(scratch_row::material_energy),
                         .intact = row(scratch_row::intact),
                         .yield_stress = material.yield};
}

/// A tile of which damping is to be added or ended.
template <class Formulation, class Pack>
DampingTile<RealOf<Pack>> damping_tile(const ShellTask<RealOf<Pack>>& task,
                                       const TileScratch<RealOf<Pack>>& scratch,
                                       const materials::MaterialTask<RealOf<Pack>>& material) {
  return {.state = material.state,
          .group_stride = material.group_stride,
          .groups = material.groups,
          .planes = Formulation::planes,
          .points = material.points,
          .strain = scratch.strain,
          .weight = task.constants.weight,
          .area = Formulation::own_areas ? scratch.area : nullptr,
          .work = scratch.rows + scratch_row::damping_work * tile_lanes,
          .limit = scratch.rows + scratch_row::shortest_step * tile_lanes};
}

/// Works off one chunk, tile by tile: strains, material, forces.
template <class Formulation, class Pack>
void shell_chunk(const ShellTask<RealOf<Pack>>& task, ElementSums& sums) {
  using Real = RealOf<Pack>;
  using materials::tile_groups;
  constexpr int most_points = Formulation::planes * materials::max_points;
  alignas(cache_line) Real strain[most_points * materials::components * tile_lanes];
  alignas(cache_line) Real rows[(scratch_row::own + Formulation::rows) * tile_lanes];
  alignas(cache_line) Real area[Formulation::own_areas ? most_points * tile_lanes : tile_lanes];
  alignas(cache_line) Real nodes[gather_row::count * tile_lanes];
  const TileScratch<Real> scratch{strain, rows, area, nodes};
  LaneSums<Pack> lane_sums;
  sums = {};
  materials::MaterialTask<Real> material = material_task<Formulation, Pack>(task);
  for (Index first = 0; first < task.groups; first += tile_groups) {
    const Index groups = task.groups - first < tile_groups ? task.groups - first : tile_groups;
    const GroupsAhead<Pack> ahead(task, 4, first + tile_groups, tile_groups);
    ahead.state();
    // The whole tile first: what has just been written in small parts is slow to be read as one pack.
    for_each_pack<Pack>(task, first, groups, scratch,
                        [](const ShellPlace<Real>& place, const Index* /*target*/) {
                          gather<Pack>(place.task.nodes, place.node, place.nodes);
                          if (place.task.constants.can_fail) rest_failed<Pack>(place);
                        });
    ahead.nodes();
    for_each_pack<Pack>(task, first, groups, scratch,
                        [](const ShellPlace<Real>& place, const Index* /*target*/) {
                          Formulation::template strains<Pack>(place);
                        });
    material.state = task.state + first * material.group_stride;
    material.groups = groups;
    if (task.damage != nullptr)
      restore_stress(*task.damage, point_tile<Formulation, Pack>(scratch, material));
    if (task.erosion != nullptr || task.damage != nullptr || task.short_steps != nullptr)
      for (int k = 0; k < Formulation::planes * tile_lanes; ++k)
        rows[scratch_row::intact * tile_lanes + k] = Real(1);
    update_points<Formulation, Pack>(task, scratch, material);
    if (task.layer_calls != 0 && task.constants.can_fail)
      drop_layers<Formulation, Pack>(task, scratch, material);
    if (task.damage != nullptr) grow_damage(*task.damage, point_tile<Formulation, Pack>(scratch, material));
    if (task.erosion != nullptr)
      check_erosion(*task.erosion, point_tile<Formulation, Pack>(scratch, material));
    if (task.short_steps != nullptr)
      end_short_elements(*task.short_steps, point_tile<Formulation, Pack>(scratch, material));
    ahead.forces();
    if (task.damping != nullptr)
      add_damping(*task.damping, damping_tile<Formulation, Pack>(task, scratch, material));
    for_each_pack<Pack>(task, first, groups, scratch,
                        [&](const ShellPlace<Real>& place, const Index* target) {
                          scatter(task.force, target, Formulation::template forces<Pack>(place));
                        });
    if (task.damping != nullptr) {
      end_damping(*task.damping, damping_tile<Formulation, Pack>(task, scratch, material));
      add_damping_energy<Pack>(rows + scratch_row::damping_energy * tile_lanes, groups, task.energy + first);
    }
    if (task.short_steps != nullptr)
      mark_short_elements(*task.short_steps, point_tile<Formulation, Pack>(scratch, material),
                          rows + scratch_row::shortest_step * tile_lanes);
    for (Index group = 0; group < groups; ++group) {
      const GroupSums own_sums = sums_of_group(task, first + group);
      lane_sums.add_group(rows + group * lanes, own_sums);
      if (task.constants.can_fail) {
        Real* const own = material.state + group * material.group_stride + task.constants.own * lanes;
        erode<Pack>(
            {own + element_state::active * lanes, own + element_state::energy * lanes, rows + group * lanes,
             rows + scratch_row::intact * tile_lanes + group * lanes, task.constants.planes},
            own_sums, sums);
      }
    }
  }
  sums.shortest_step = lane_sums.shortest_step();
}

}  // namespace crumple::elements
