// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Elements of two nodes: beams and trusses here, springs and dampers beside them.
//
//     BelytschkoSchwer   ELFORM 2   T. Belytschko, L. Schwer & M.J. Klein, IJNME 11 (1977) 65-84: resultants,
//                                   elastic or with plastic hinges at the ends
//     Truss              ELFORM 3   axial force alone; elastic or elastic-plastic
//     IntegratedBeam     ELFORM 1, 4, 5   T.J.R. Hughes & W.K. Liu, CMAME 27 (1981) 331-362: stresses at
//                                   points of the cross section half way
//     SpotWeldBeam       ELFORM 9   as ELFORM 2 with shear, elastic-plastic, fails by its resultants
//     springs, dampers   discrete_elements.hpp with the laws S01 to S05 of discrete_law.hpp
//
//                t
//                |  s (towards the orientation node)      r from the first to the second node, s in the plane
//                | /                                      of r and the orientation node, t = r x s
//         1 o----+--------------o 2  --> r                axes of both ends turn with their nodes
//
// All are computed in double in both precisions: there are few of them, and the rotations that two elements
// keep of a common node must not drift apart. Beams run in packs of elements as shells do, without tiles;
// springs run one by one in one text for all instruction sets.
//
// Order of calls: beam_chunk() takes a chunk group by group: forces() for each pack, scatter in the order of
// the elements, sums over lanes, erosion of trusses that fail. Of a chunk of springs add_discrete_forces()
// does the same (discrete_elements.hpp).
//
// A formulation of beams is a type with
//   static constexpr model::BeamFormulation formulation, const char* name
//   static constexpr bool turns          its ends have moments
//   static constexpr bool can_fail       it leaves the row `intact` and keeps its energy; then also
//   static constexpr Index energy          item of the state
//   static bool fails(const BeamConstants&)
//   template <class Pack> static BeamForces<Pack> forces(const BeamPlace&)
// forces() brings state, energy and stable step of a pack up to date. Always in double: see BeamBlock.

#include "elements/common/lane_sums.hpp"
#include "elements/line/beam_task.hpp"
#include "math/pack_vec3.hpp"

namespace crumple::elements {

/// Rows of the scratch, [row][materials::tile_lanes].
namespace beam_row {
using sum_row::hourglass_energy;
using sum_row::internal_energy;
using sum_row::shortest_step;
inline constexpr int intact = sum_row::count;
inline constexpr int damping_energy = intact + 1;  ///< increment of the step
inline constexpr int count = damping_energy + 1;
}  // namespace beam_row

/// Where one pack of beams finds everything.
struct BeamPlace {
  const BeamTask& task;
  const Index* node;  ///< [2][lanes], from the first element of the pack
  double* state;      ///< [component][lanes]
  double* rows;       ///< [row][tile_lanes]
};

/// Internal forces and moments at the two nodes, global axes.
template <class Pack>
struct BeamForces {
  math::PackVec3<Pack> force;  ///< at the second node; at the first the opposite
  math::PackVec3<Pack> moment[2];
};

template <class Pack>
CRUMPLE_INLINE Pack beam_item(const BeamPlace& place, Index item) {
  return load<Pack>(place.state + item * lanes);
}
template <class Pack>
CRUMPLE_INLINE void set_beam_item(const BeamPlace& place, Index item, const Pack& value) {
  store(place.state + item * lanes, value);
}
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> beam_vector(const BeamPlace& place, Index item) {
  return {beam_item<Pack>(place, item), beam_item<Pack>(place, item + 1), beam_item<Pack>(place, item + 2)};
}
template <class Pack>
CRUMPLE_INLINE void set_beam_vector(const BeamPlace& place, Index item, const math::PackVec3<Pack>& value) {
  set_beam_item(place, item, value.x);
  set_beam_item(place, item + 1, value.y);
  set_beam_item(place, item + 2, value.z);
}
template <class Pack>
CRUMPLE_INLINE void keep_beam_row(const BeamPlace& place, int row, const Pack& value) {
  store(place.rows + row * materials::tile_lanes, value);
}

/// No forces of what has failed, which may have any shape, and numbers that are none.
template <class Pack>
CRUMPLE_INLINE void clear_where_gone(const Pack& intact, BeamForces<Pack>& internal) {
  const Pack zero(0.0);
  for (math::PackVec3<Pack>* vector : {&internal.force, &internal.moment[0], &internal.moment[1]})
    for (Pack* number : {&vector->x, &vector->y, &vector->z})
      *number = select<Pack>(intact > zero, *number, zero);
}

/// One vector per lane: `vector_of(lane)` gives that of the lane.
template <class Pack, class VectorOf>
CRUMPLE_INLINE math::PackVec3<Pack> lane_vectors(const VectorOf& vector_of) {
  constexpr int width = width_of<Pack>;
  alignas(cache_line) double rows[3][width];
  for (int lane = 0; lane < width; ++lane) {
    const domain::Vec3 one = vector_of(lane);
    rows[0][lane] = one.x;
    rows[1][lane] = one.y;
    rows[2][lane] = one.z;
  }
  return {load<Pack>(rows[0]), load<Pack>(rows[1]), load<Pack>(rows[2])};
}

/// From the first node to the second at time n.
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> beam_span(const BeamPlace& place) {
  return lane_vectors<Pack>([&](int lane) {
    return place.task.position[place.node[lanes + lane]] - place.task.position[place.node[lane]];
  });
}

/// Stable step without damping: that of time zero, shorter as the beam becomes shorter.
template <class Pack>
CRUMPLE_INLINE Pack undamped_step(const BeamPlace& place, const Pack& length) {
  const Pack one(1.0);
  const Pack shorter = smaller(one, Pack(length / beam_item<Pack>(place, beam_state::reference_length)));
  return beam_item<Pack>(place, beam_state::stable_step) * shorter;
}

/// What damping in proportion to stiffness makes of the elastic forces of a step's deformations [-].
template <class Pack>
CRUMPLE_INLINE Pack damping_share(const BeamPlace& place, const Pack& length) {
  const BeamTask& task = place.task;
  if (!(task.step > 0)) return Pack(0.0);
  const Pack beta = task.damping.share > 0 ? Pack(Pack(task.damping.share) * undamped_step(place, length))
                                           : Pack(task.damping.beta);
  return Pack(1 / task.step) * beta;
}

/// Leaves the stable step, see damped_share().
template <class Pack>
CRUMPLE_INLINE void keep_stable_step(const BeamPlace& place, const Pack& active, const Pack& length) {
  const Pack one(1.0);
  Pack limit = undamped_step(place, length);
  if (place.task.damping_item > 0) {
    const model::StiffnessDamping& damping = place.task.damping;
    const Pack x = damping.share > 0 ? Pack(damping.share) : Pack(Pack(damping.beta) / limit);
    limit = limit / (square_root(multiply_add(x, x, one)) + x);
  }
  keep_beam_row(place, beam_row::shortest_step, select<Pack>(active > Pack(0.0), limit, Pack(1e30)));
}

}  // namespace crumple::elements
