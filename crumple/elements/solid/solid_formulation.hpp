// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Solid elements of four, eight and ten nodes.
//
//     OnePointHexahedron         ELFORM 1    D.P. Flanagan & T. Belytschko, IJNME 17 (1981) 679-706; needs
//                                            hourglass control (hexahedron_hourglass.hpp)
//     SelectiveHexahedron        ELFORM 2    J.C. Nagtegaal, D.M. Parks & J.R. Rice, CMAME 4 (1974) 153-177;
//                                            2 x 2 x 2 points, one dilatation
//     AssumedStrainHexahedron     ELFORM -1, -2   the same with assumed strains of bending
//                                            (assumed_bending.hpp)
//     Tetrahedron                ELFORM 10   constant strain
//     NodalPressureTetrahedron   ELFORM 13   J. Bonet & A.J. Burton, Commun. Numer. Meth. Engng 14 (1998)
//                                            437-449; dilatation averaged at the nodes (nodal_average.hpp)
//     CohesiveHexahedron         ELFORM 19   tractions between two faces, which may coincide
//     QuadraticTetrahedron       ELFORM 16, 17   O.C. Zienkiewicz & R.L. Taylor: ten nodes, four points
//
//         8--------7       Fields of a hexahedron are sums of the eight patterns of the trilinear map: 1, xi,
//        /|       /|       eta, zeta, and four hourglass patterns (solid_patterns.hpp). Their coefficients
//       5--------6 |       follow from the nodal values by a fast Hadamard transform of 24 additions.
//       | 4------|-3
//       |/       |/        Stresses are in global axes: the old stress is turned by the rotation of the step
//       1--------2         (Hughes & Winget, IJNME 15 (1980) 1862-1867), then the law adds its increment.
//
// Order of calls, per tile (solid_chunk.hpp): gather, strains() at the middle of the step, the material at
// all points, forces() at its end with bulk viscosity and the stable step (solid_resistance.hpp), scatter in
// the order of the elements, erosion.
//
// A formulation of solids is a type with
//   static constexpr model::SolidFormulation formulation, const char* name
//   static constexpr int points          integration points
//   static constexpr int corners         nodes, 8, 4 or 10
//   static constexpr int rows            numbers per element kept from strains() to forces()
//   static constexpr KeptItem kept       what it keeps from step to step
//   static constexpr bool averages       dilatation averaged at the nodes before (nodal_average.hpp)
//   template <class Pack> static void strains(const SolidPlace<Real>&)
//   template <class Pack> static SolidForces<Pack, corners> forces(const SolidPlace<Real>&)
// strains() leaves strain increments and rotations of all points, forces() makes nodal forces of the updated
// stresses. Between the two the material brings the tile up to date (solid_chunk.hpp).

#include "elements/common/lane_sums.hpp"
#include "elements/solid/solid_task.hpp"
#include "materials/common/solid_stress.hpp"
#include "math/pack_vec3.hpp"
#include "model/section.hpp"

namespace crumple::elements {

using materials::tile_lanes;

/// Rows of the scratch that the driver reads, before those of the formulation.
namespace solid_scratch {
using sum_row::hourglass_energy;               ///< from forces()
using sum_row::internal_energy;                ///< from forces()
using sum_row::shortest_step;                  ///< from forces()
inline constexpr int intact = sum_row::count;  ///< from the material
inline constexpr int material_energy =
    intact + 1;  ///< from the material, by point: work per volume of the step
// Where the wave speed varies, the first two are made by strains() (resist_early()), the third by the
// material.
inline constexpr int viscosity = material_energy + materials::max_solid_points;  ///< its mean over the step
inline constexpr int bulk_pressure = viscosity + 1;                              ///< at the end of the step
inline constexpr int wave_speed = bulk_pressure + 1;                             ///< at the end of the step
inline constexpr int damping_work = wave_speed + 1;  ///< by point: work per volume of the step
inline constexpr int damping_energy = damping_work + materials::max_solid_points;  ///< from forces()
inline constexpr int own = damping_energy + 1;
}  // namespace solid_scratch

/// Where one pack of elements finds everything. Strides are `lanes` in the state, tile_lanes in the scratch.
template <class Real>
struct SolidPlace {
  const SolidTask<Real>& task;
  const Index* node;  ///< [corner][lanes], from the first element of the pack
  Real* state;        ///< [component][lanes]
  Real* strain;       ///< [point][6][tile_lanes]
  Real* turn;         ///< [point][9][tile_lanes], rotation less the unit matrix
  Real* rows;         ///< [row][tile_lanes]
  Real* nodes;        ///< what the formulation keeps of the nodes from strains() to forces()
};

template <class Pack>
CRUMPLE_INLINE Pack own_item(const SolidPlace<RealOf<Pack>>& place, Index item) {
  return load<Pack>(place.state + (place.task.constants.own + item) * lanes);
}
template <class Pack>
CRUMPLE_INLINE void set_own_item(const SolidPlace<RealOf<Pack>>& place, Index item, const Pack& value) {
  store(place.state + (place.task.constants.own + item) * lanes, value);
}
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> own_vector(const SolidPlace<RealOf<Pack>>& place, Index item) {
  return {own_item<Pack>(place, item), own_item<Pack>(place, item + 1), own_item<Pack>(place, item + 2)};
}
template <class Pack>
CRUMPLE_INLINE void set_own_vector(const SolidPlace<RealOf<Pack>>& place, Index item,
                                   const math::PackVec3<Pack>& value) {
  set_own_item(place, item, value.x);
  set_own_item(place, item + 1, value.y);
  set_own_item(place, item + 2, value.z);
}

template <class Pack>
CRUMPLE_INLINE void keep_row(const SolidPlace<RealOf<Pack>>& place, int row, const Pack& value) {
  store(place.rows + row * tile_lanes, value);
}
template <class Pack>
CRUMPLE_INLINE Pack kept_row(const SolidPlace<RealOf<Pack>>& place, int row) {
  return load<Pack>(place.rows + row * tile_lanes);
}
template <class Pack>
CRUMPLE_INLINE void keep_vector(const SolidPlace<RealOf<Pack>>& place, int row,
                                const math::PackVec3<Pack>& value) {
  keep_row(place, row, value.x);
  keep_row(place, row + 1, value.y);
  keep_row(place, row + 2, value.z);
}
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> kept_vector(const SolidPlace<RealOf<Pack>>& place, int row) {
  return {kept_row<Pack>(place, row), kept_row<Pack>(place, row + 1), kept_row<Pack>(place, row + 2)};
}

/// Where elements have been off for long enough that every force that they keep, of `own_items` items, is
/// zero.
template <class Pack>
CRUMPLE_INLINE MaskOf<Pack> gone_for_ever(const SolidPlace<RealOf<Pack>>& place, Index own_items) {
  const Pack zero(RealOf<Pack>(0));
  MaskOf<Pack> gone = own_item<Pack>(place, solid_state::active) == zero &&
                      own_item<Pack>(place, solid_state::bulk_viscosity) == zero;
  for (Index c = 0; c < own_items; ++c) gone = gone && own_item<Pack>(place, solid_state::own + c) == zero;
  return gone;
}

/// Leaves the work of damping for the driver; rows from `volume` on have the volumes of the points in the
/// middle of the step.
template <class Pack>
CRUMPLE_INLINE void leave_damping_energy(const SolidPlace<RealOf<Pack>>& place, const Pack& active,
                                         int volume) {
  if (place.task.damping == nullptr) return;
  Pack work(RealOf<Pack>(0));
  for (int point = 0; point < place.task.constants.points; ++point)
    work = multiply_add(kept_row<Pack>(place, solid_scratch::damping_work + point),
                        kept_row<Pack>(place, volume + point), work);
  keep_row(place, solid_scratch::damping_energy, Pack(active * work));
}

/// A 3x3 matrix by rows.
template <class Pack>
struct PackMatrix {
  math::PackVec3<Pack> x, y, z;
};
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> operator*(const PackMatrix<Pack>& m, const math::PackVec3<Pack>& v) {
  return {math::dot(m.x, v), math::dot(m.y, v), math::dot(m.z, v)};
}

/// The rotation that a spin makes of a step, (I - W/2)^-1 (I + W/2), less the unit matrix: orthogonal
/// whatever the size of the step (Hughes & Winget, IJNME 15 (1980) 1862-1867). `turn` is the axial vector of
/// W, step times half the curl.
template <class Pack>
CRUMPLE_INLINE PackMatrix<Pack> step_rotation(const math::PackVec3<Pack>& turn) {
  using Real = RealOf<Pack>;
  const Pack half(Real(0.5));
  const Pack square = math::dot(turn, turn);
  const Pack one(Real(1));
  const Pack k = one / multiply_add(Pack(Real(0.25)), square, one);
  const math::PackVec3<Pack> a = k * turn;
  const math::PackVec3<Pack> b = half * turn;
  const Pack xx = -multiply_add(a.y, b.y, Pack(a.z * b.z));
  const Pack yy = -multiply_add(a.z, b.z, Pack(a.x * b.x));
  const Pack zz = -multiply_add(a.x, b.x, Pack(a.y * b.y));
  const Pack xy = a.x * b.y;
  const Pack yz = a.y * b.z;
  const Pack zx = a.z * b.x;
  return {{xx, xy - a.z, zx + a.y}, {xy + a.z, yy, yz - a.x}, {zx - a.y, yz + a.x, zz}};
}

template <class Pack>
CRUMPLE_INLINE Pack trace(const PackMatrix<Pack>& m) {
  return (m.x.x + m.y.y) + m.z.z;
}
/// Takes `number` away from the diagonal.
template <class Pack>
CRUMPLE_INLINE void lessen_diagonal(PackMatrix<Pack>& m, const Pack& number) {
  m.x.x = m.x.x - number;
  m.y.y = m.y.y - number;
  m.z.z = m.z.z - number;
}

/// Leaves the strain increments and the rotation of one point.
template <class Pack>
CRUMPLE_INLINE void leave_strains(const SolidPlace<RealOf<Pack>>& place, int point,
                                  const PackMatrix<Pack>& l) {
  using Real = RealOf<Pack>;
  const Pack step(place.task.step);
  Real* const strain = place.strain + point * materials::solid_components * tile_lanes;
  store(strain, Pack(step * l.x.x));
  store(strain + tile_lanes, Pack(step * l.y.y));
  store(strain + 2 * tile_lanes, Pack(step * l.z.z));
  store(strain + 3 * tile_lanes, Pack(step * (l.x.y + l.y.x)));
  store(strain + 4 * tile_lanes, Pack(step * (l.y.z + l.z.y)));
  store(strain + 5 * tile_lanes, Pack(step * (l.z.x + l.x.z)));
  const Pack half = Pack(Real(0.5)) * step;
  const PackMatrix<Pack> turned = step_rotation(
      math::PackVec3<Pack>{half * (l.z.y - l.y.z), half * (l.x.z - l.z.x), half * (l.y.x - l.x.y)});
  Real* const rotation = place.turn + point * 9 * tile_lanes;
  const math::PackVec3<Pack> rows[3] = {turned.x, turned.y, turned.z};
  for (int i = 0; i < 3; ++i) {
    store(rotation + 3 * i * tile_lanes, rows[i].x);
    store(rotation + (3 * i + 1) * tile_lanes, rows[i].y);
    store(rotation + (3 * i + 2) * tile_lanes, rows[i].z);
  }
}
template <class Pack>
CRUMPLE_INLINE PackMatrix<Pack> left_rotation(const SolidPlace<RealOf<Pack>>& place, int point) {
  const RealOf<Pack>* const at = place.turn + point * 9 * tile_lanes;
  const auto row = [&](int i) {
    return math::PackVec3<Pack>{load<Pack>(at + 3 * i * tile_lanes),
                                load<Pack>(at + (3 * i + 1) * tile_lanes),
                                load<Pack>(at + (3 * i + 2) * tile_lanes)};
  };
  return {row(0), row(1), row(2)};
}

/// Half of a rotation, both less the unit matrix: what is still to come of it from the middle of the step.
template <class Pack>
CRUMPLE_INLINE PackMatrix<Pack> half_rotation(const PackMatrix<Pack>& turned) {
  const auto [x, y, z] = turned;
  const auto half = materials::half_of(materials::Turn<Pack>{x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z});
  return {{half.xx, half.xy, half.xz}, {half.yx, half.yy, half.yz}, {half.zx, half.zy, half.zz}};
}

/// Symmetric stress of one point as a matrix, times `factor`.
template <class Pack>
CRUMPLE_INLINE PackMatrix<Pack> stress_of(const SolidPlace<RealOf<Pack>>& place, int point,
                                          const Pack& factor) {
  const auto component = [&](int c) {
    return factor * load<Pack>(place.state + (point * materials::solid_components + c) * lanes);
  };
  const Pack xy = component(3);
  const Pack yz = component(4);
  const Pack zx = component(5);
  return {{component(0), xy, zx}, {xy, component(1), yz}, {zx, yz, component(2)}};
}

}  // namespace crumple::elements
