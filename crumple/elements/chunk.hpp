// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/formulation.hpp"

namespace crumple::elements {

/// Arrays of one tile, on the stack of whoever works it off.
template <class Real>
struct TileScratch {
  Real* strain;
  Real* rows;
  Real* area;
};

/// A loop over the packs of one tile.
template <class Pack, class Visit>
CRUMPLE_INLINE void for_each_pack(const ShellTask<RealOf<Pack>>& task, Index first_group, Index groups,
                                  const TileScratch<RealOf<Pack>>& scratch, const Visit& visit) {
  for (Index group = 0; group < groups; ++group)
    for (Index lane = 0; lane < lanes; lane += width_of<Pack>) {
      const std::ptrdiff_t at = first_group + group;
      visit(
          ShellPlace<RealOf<Pack>>{
              task, task.node + at * 4 * lanes + lane,
              task.state + at * static_cast<std::ptrdiff_t>(task.components) * lanes + lane,
              scratch.strain + group * lanes + lane, scratch.rows + group * lanes + lane,
              scratch.area + group * lanes + lane},
          task.target + at * 4 * lanes + lane);
    }
}

/// Works off one chunk, tile by tile: strains, material, forces. Sums run lane by lane in double over the
/// groups, then over the lanes in order: the same bits for every width of pack.
template <class Formulation, class Pack>
void shell_chunk(const ShellTask<RealOf<Pack>>& task, ShellSums& sums) {
  using Real = RealOf<Pack>;
  using materials::tile_groups;
  alignas(cache_line) Real strain[materials::max_points * materials::components * tile_lanes];
  alignas(cache_line) Real rows[(scratch_row::own + Formulation::rows) * tile_lanes];
  alignas(cache_line) Real area[Formulation::own_areas ? materials::max_points * tile_lanes : tile_lanes];
  const TileScratch<Real> scratch{strain, rows, area};
  alignas(cache_line) double internal[lanes] = {};
  alignas(cache_line) double hourglass[lanes] = {};
  alignas(cache_line) Real shortest[lanes];
  for (Index lane = 0; lane < lanes; ++lane) shortest[lane] = Real(1e30);

  materials::MaterialTask<Real> material;
  material.group_stride = static_cast<std::ptrdiff_t>(task.components) * lanes;
  material.points = task.constants.points;
  material.history = task.constants.history;
  material.strain = strain;
  material.weight = task.constants.weight;
  material.area = Formulation::own_areas ? area : nullptr;
  material.constants = task.material_constants;
  material.step = task.step;
  material.energy = rows + scratch_row::material_energy * tile_lanes;
  material.thickness_strain = rows + scratch_row::thickness_strain * tile_lanes;

  for (Index first = 0; first < task.groups; first += tile_groups) {
    const Index groups = task.groups - first < tile_groups ? task.groups - first : tile_groups;
    for_each_pack<Pack>(task, first, groups, scratch,
                        [](const ShellPlace<Real>& place, const Index* /*target*/) {
                          Formulation::template strains<Pack>(place);
                        });
    material.state = task.state + first * material.group_stride;
    material.groups = groups;
    task.material(material);
    for_each_pack<Pack>(task, first, groups, scratch,
                        [&](const ShellPlace<Real>& place, const Index* target) {
                          scatter(task.force, target, Formulation::template forces<Pack>(place));
                        });
    for (Index group = 0; group < groups; ++group) {
      const Real* const own = rows + group * lanes;
      for (Index lane = 0; lane < lanes; ++lane) {
        internal[lane] += static_cast<double>(own[scratch_row::internal_energy * tile_lanes + lane]);
        hourglass[lane] += static_cast<double>(own[scratch_row::hourglass_energy * tile_lanes + lane]);
        const Real limit = own[scratch_row::shortest_step * tile_lanes + lane];
        shortest[lane] = limit < shortest[lane] ? limit : shortest[lane];
      }
    }
  }
  sums = {0, 0, 1e30};
  for (Index lane = 0; lane < lanes; ++lane) {
    sums.internal_energy += internal[lane];
    sums.hourglass_energy += hourglass[lane];
    const auto limit = static_cast<double>(shortest[lane]);
    sums.shortest_step = limit < sums.shortest_step ? limit : sums.shortest_step;
  }
}

}  // namespace crumple::elements
