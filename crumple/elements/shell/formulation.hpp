// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Shell elements of four nodes, and triangles, which repeat their third node.
//
//     BelytschkoTsay         ELFORM 2    T. Belytschko, J.I. Lin & C.S. Tsay, CMAME 42 (1984) 225-251
//     BelytschkoWongChiang   ELFORM 10   T. Belytschko, B.L. Wong & H.Y. Chiang, CMAME 96 (1992) 93-107
//     HughesLiu              ELFORM 1    T.J.R. Hughes & W.K. Liu, CMAME 26 (1981) 331-362
//     HughesLiuSelective     ELFORM 6    the same; 2 x 2 points, transverse shear at the centre
//     FullyIntegrated        ELFORM 16   B.E. Engelmann, R.G. Whirley & G.L. Goudreau, ASME CED-3 (1989)
//     Triangle               ELFORM 4    J.M. Kennedy, T. Belytschko & J.I. Lin, NED 97 (1986) 1-24
//     Membrane               ELFORM 5    Belytschko-Tsay without bending and transverse shear
//     FullyIntegratedMembrane  ELFORM 9  the membrane of FullyIntegrated; triangles are MembraneTriangle
//
//       4-----------3       e3 is normal to both diagonals; e1 turns with the rotation of the polar
//        \     ^ e2  \      decomposition of the in-plane deformation gradient (lamina_frame.hpp), so that
//         \    +-> e1 \     stresses turn with the material, whichever node comes first.
//          1-----------2
//                           Stresses xx, yy, xy, yz, zx are kept in these axes, at each point through the
//                           thickness and, with several planes, at each point in plane.
//
// Order of calls, per tile (chunk.hpp): gather, strains() at the middle of the step (middle_shape()), the
// material at all points, forces() at its end (end_shape()), scatter in the order of the elements, erosion.
// Quadrilaterals with one point in plane need hourglass control (hourglass.hpp). The stable step is area /
// longest side / plate wave speed; of triangles twice that.
//
// A shell formulation is a type with
//   static constexpr model::ShellFormulation formulation, const char* name
//   static constexpr int planes          points in plane
//   static constexpr int rows            numbers per element kept from strains() to forces()
//   static constexpr bool own_areas      strains() leaves the area that each point stands for in
//                                        ShellPlace::area; true if there are several planes
//   template <class Pack> static void strains(const ShellPlace<Real>&)
//   template <class Pack> static ShellForces<Pack> forces(const ShellPlace<Real>&)
// strains() leaves the strain increments of all points, forces() makes nodal forces of
// the updated stresses. Between the two the material brings the tile up to date (chunk.hpp).

#include "elements/common/gather.hpp"
#include "elements/common/lane_sums.hpp"
#include "elements/shell/hourglass.hpp"
#include "elements/shell/lamina_frame.hpp"
#include "elements/shell/scatter.hpp"
#include "elements/shell/shell_task.hpp"
#include "materials/common/plane_stress.hpp"

namespace crumple::elements {

using materials::tile_lanes;

/// Rows of the scratch that the driver reads, before those of the formulation.
namespace scratch_row {
using sum_row::hourglass_energy;  ///< from forces()
using sum_row::internal_energy;   ///< from forces()
using sum_row::shortest_step;     ///< from forces()
inline constexpr int material_energy =
    sum_row::count;  ///< from the material, by plane: work per volume of the step
inline constexpr int thickness_strain = material_energy + materials::max_plane_points;  ///< by plane
inline constexpr int intact = thickness_strain + materials::max_plane_points;           ///< by plane
inline constexpr int yield = intact + materials::max_plane_points;        ///< MaterialTask::yield
inline constexpr int damping_work = yield + materials::yield_row::count;  ///< by plane: work per volume
inline constexpr int damping_energy = damping_work + materials::max_plane_points;  ///< from forces()
inline constexpr int own = damping_energy + 1;  ///< first row of the formulation
}  // namespace scratch_row

/// Where one pack of elements finds everything. Strides are `lanes` in the state, tile_lanes in the scratch.
template <class Real>
struct ShellPlace {
  const ShellTask<Real>& task;
  const Index* node;  ///< [4][lanes], from the first element of the pack
  Real* state;        ///< [component][lanes]
  Real* strain;       ///< [plane][points][5][tile_lanes]
  Real* rows;         ///< [row][tile_lanes]
  Real* area;         ///< [plane][points][tile_lanes]
  Real* nodes;        ///< what gather() has left, see gathered()
};

/// What the nodes of the elements are and do. They have been gathered before strains() is called.
template <class Pack>
CRUMPLE_INLINE GatheredNodes<Pack> gathered(const ShellPlace<RealOf<Pack>>& place) {
  return {place.nodes};
}

template <class Pack>
CRUMPLE_INLINE Pack own_state(const ShellPlace<RealOf<Pack>>& place, Index item) {
  return load<Pack>(place.state + (place.task.constants.own + item) * lanes);
}

template <class Pack>
CRUMPLE_INLINE void keep(const ShellPlace<RealOf<Pack>>& place, int row, const Pack& value) {
  store(place.rows + (scratch_row::own + row) * tile_lanes, value);
}
template <class Pack>
CRUMPLE_INLINE void keep_vec(const ShellPlace<RealOf<Pack>>& place, int row,
                             const math::PackVec3<Pack>& value) {
  keep(place, row, value.x);
  keep(place, row + 1, value.y);
  keep(place, row + 2, value.z);
}
template <class Pack>
CRUMPLE_INLINE Pack kept(const ShellPlace<RealOf<Pack>>& place, int row) {
  return load<Pack>(place.rows + (scratch_row::own + row) * tile_lanes);
}
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> kept_vec(const ShellPlace<RealOf<Pack>>& place, int row) {
  return {kept<Pack>(place, row), kept<Pack>(place, row + 1), kept<Pack>(place, row + 2)};
}

template <class Pack>
CRUMPLE_INLINE HourglassModes<Pack> hourglass_state(const ShellPlace<RealOf<Pack>>& place) {
  using namespace element_state;
  return {own_state<Pack>(place, hourglass), own_state<Pack>(place, hourglass + 1),
          own_state<Pack>(place, hourglass + 2), own_state<Pack>(place, hourglass + 3),
          own_state<Pack>(place, hourglass + 4)};
}
template <class Pack>
CRUMPLE_INLINE void set_hourglass_state(const ShellPlace<RealOf<Pack>>& place,
                                        const HourglassModes<Pack>& q) {
  RealOf<Pack>* const to = place.state + (place.task.constants.own + element_state::hourglass) * lanes;
  store(to, q.x);
  store(to + lanes, q.y);
  store(to + 2 * lanes, q.z);
  store(to + 3 * lanes, q.bending_x);
  store(to + 4 * lanes, q.bending_y);
}

template <class Pack>
CRUMPLE_INLINE void keep_modes(const ShellPlace<RealOf<Pack>>& place, int row,
                               const HourglassModes<Pack>& modes) {
  keep(place, row, modes.x);
  keep(place, row + 1, modes.y);
  keep(place, row + 2, modes.z);
  keep(place, row + 3, modes.bending_x);
  keep(place, row + 4, modes.bending_y);
}
template <class Pack>
CRUMPLE_INLINE HourglassModes<Pack> kept_modes(const ShellPlace<RealOf<Pack>>& place, int row) {
  return {kept<Pack>(place, row), kept<Pack>(place, row + 1), kept<Pack>(place, row + 2),
          kept<Pack>(place, row + 3), kept<Pack>(place, row + 4)};
}

/// Centre gradients of the velocities and of the in-plane angular velocities.
template <class Pack>
struct VelocityGradients {
  CentreGradient<Pack> vx, vy, vz, wx, wy;
};

/// The hourglass part of the nodes' motion. A warped element that turns as a rigid body moves its pattern of
/// positions: the turn of the normal, the gradient of vz, times the warp takes that out again.
template <class Pack>
CRUMPLE_INLINE HourglassModes<Pack> hourglass_rates(const LaminaFrame<Pack>& frame,
                                                    const LaminaGeometry<Pack>& g,
                                                    const math::PackVec3<Pack>& v_mode,
                                                    const math::PackVec3<Pack>& w_mode,
                                                    const VelocityGradients<Pack>& d) {
  return {multiply_add(g.z_mode, d.vz.x, hourglass_part(g, math::dot(v_mode, frame.e1), d.vx)),
          multiply_add(g.z_mode, d.vz.y, hourglass_part(g, math::dot(v_mode, frame.e2), d.vy)),
          hourglass_part(g, math::dot(v_mode, frame.e3), d.vz),
          hourglass_part(g, math::dot(w_mode, frame.e1), d.wx),
          hourglass_part(g, math::dot(w_mode, frame.e2), d.wy)};
}

/// Brings the hourglass stresses in the state up to date and leaves the energy for the driver.
template <class Pack>
CRUMPLE_INLINE HourglassModes<Pack> update_hourglass(const ShellPlace<RealOf<Pack>>& place,
                                                     const LaminaGeometry<Pack>& g, const Pack& thickness,
                                                     const HourglassModes<Pack>& rate) {
  using Real = RealOf<Pack>;
  const Pack step(place.task.step);
  const HourglassModes<Pack> old = hourglass_state<Pack>(place);
  const auto moduli = hourglass_moduli(place.task.constants, g, thickness);
  auto now = hourglass_stress(place.task.constants, moduli, step, old, rate);
  if (!place.task.constants.viscous) {
    namespace yield_row = materials::yield_row;
    const Real* const yield = place.rows + scratch_row::yield * tile_lanes;
    now = yielding(now, load<Pack>(yield + yield_row::left * tile_lanes),
                   plastic_limits(g, thickness, load<Pack>(yield + yield_row::stress * tile_lanes)));
  }
  // What has failed does not hold its last stress.
  if (place.task.constants.can_fail) now = scaled(now, own_state<Pack>(place, element_state::active));
  set_hourglass_state(place, now);
  store(place.rows + scratch_row::hourglass_energy * tile_lanes, hourglass_work(step, old, now, rate));
  return now;
}

/// Sum over the planes of what the material left in the rows from `first` on.
template <class Pack>
CRUMPLE_INLINE Pack sum_over_planes(const ShellPlace<RealOf<Pack>>& place, int first) {
  Pack sum = load<Pack>(place.rows + first * tile_lanes);
  for (int plane = 1; plane < place.task.constants.planes; ++plane)
    sum = sum + load<Pack>(place.rows + (first + plane) * tile_lanes);
  return sum;
}
template <class Pack>
CRUMPLE_INLINE Pack mean_over_planes(const ShellPlace<RealOf<Pack>>& place, int first) {
  const Pack sum = sum_over_planes<Pack>(place, first);
  const int planes = place.task.constants.planes;
  return planes == 1 ? sum : Pack(sum * Pack(RealOf<Pack>(1) / static_cast<RealOf<Pack>>(planes)));
}

/// New thickness where it may change; returns the mean over the step.
template <class Pack>
CRUMPLE_INLINE Pack update_thickness(const ShellPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const Pack old = own_state<Pack>(place, element_state::thickness);
  if (!place.task.constants.thickness_change) return old;
  const Pack change = old * mean_over_planes<Pack>(place, scratch_row::thickness_strain);
  store(place.state + (place.task.constants.own + element_state::thickness) * lanes, Pack(old + change));
  return multiply_add(Pack(Real(0.5)), change, old);
}

/// Where an element is: what the positions differ by, and its lamina axes.
template <class Pack>
struct ElementShape {
  math::PackVec3<Pack> r31, r42, r_mode;  ///< as in ShellNodes [length]
  LaminaFrame<Pack> frame;
};
template <class Pack>
CRUMPLE_INLINE ElementShape<Pack> shape_of(const ShellPlace<RealOf<Pack>>& place,
                                           const math::PackVec3<Pack>& r31, const math::PackVec3<Pack>& r42,
                                           const math::PackVec3<Pack>& r_mode) {
  return {r31, r42, r_mode,
          lamina_frame<Pack>(r31 - r42, r31 + r42, own_state<Pack>(place, element_state::frame),
                             own_state<Pack>(place, element_state::frame + 1))};
}

/// The shape at the middle of the step, where strains are taken (Hughes & Winget, IJNME 15 (1980) 1862-1867):
/// only there is a rigid rotation a velocity field without strain.
template <class Pack>
CRUMPLE_INLINE ElementShape<Pack> middle_shape(const ShellPlace<RealOf<Pack>>& place) {
  const GatheredNodes<Pack> n = gathered<Pack>(place);
  const Pack back(-(RealOf<Pack>(0.5) * place.task.step));
  return shape_of<Pack>(place, math::multiply_add(back, n.v31(), n.r31()),
                        math::multiply_add(back, n.v42(), n.r42()),
                        math::multiply_add(back, n.v_mode(), n.r_mode()));
}

/// The shape at the end of the step, where forces act.
template <class Pack>
CRUMPLE_INLINE ElementShape<Pack> end_shape(const ShellPlace<RealOf<Pack>>& place) {
  const GatheredNodes<Pack> n = gathered<Pack>(place);
  return shape_of<Pack>(place, n.r31(), n.r42(), n.r_mode());
}

template <class Pack>
CRUMPLE_INLINE LaminaGeometry<Pack> lamina_geometry(const ElementShape<Pack>& shape) {
  const LaminaFrame<Pack>& frame = shape.frame;
  LaminaGeometry<Pack> g;
  g.x31 = math::dot(shape.r31, frame.e1);
  g.y31 = math::dot(shape.r31, frame.e2);
  g.x42 = math::dot(shape.r42, frame.e1);
  g.y42 = math::dot(shape.r42, frame.e2);
  g.x_mode = math::dot(shape.r_mode, frame.e1);
  g.y_mode = math::dot(shape.r_mode, frame.e2);
  g.z_mode = math::dot(shape.r_mode, frame.e3);
  const Pack twice_area = multiply_add(g.x31, g.y42, Pack(-(g.x42 * g.y31)));
  g.area = RealOf<Pack>(0.5) * twice_area;
  g.inverse_twice_area = Pack(RealOf<Pack>(1)) / twice_area;
  return g;
}

/// Leaves the work of the points for the driver: what material and damping summed, times `factor`, the
/// thickness and what else the sum lacks of a volume; 0 for elements that are not active.
template <class Pack>
CRUMPLE_INLINE void leave_internal_energy(const ShellPlace<RealOf<Pack>>& place, const Pack& factor) {
  const Pack energy = sum_over_planes<Pack>(place, scratch_row::material_energy);
  store(place.rows + scratch_row::internal_energy * tile_lanes, Pack(energy * factor));
  if (place.task.damping == nullptr) return;
  const Pack damping = sum_over_planes<Pack>(place, scratch_row::damping_work);
  store(place.rows + scratch_row::damping_energy * tile_lanes, Pack(damping * factor));
}

/// Stable step: area over the longest side over the plate wave speed, times what step_scale says.
template <class Pack>
CRUMPLE_INLINE Pack stable_step(const Pack& area, const math::PackVec3<Pack>& r31,
                                const math::PackVec3<Pack>& r42, const math::PackVec3<Pack>& r_mode,
                                const Pack& scaled_slowness) {
  using Vec = math::PackVec3<Pack>;
  const Vec r21 = Pack(RealOf<Pack>(0.5)) * ((r31 - r42) - r_mode);
  const Vec r32 = r31 - r21;
  const Vec r41 = r42 + r21;
  const Vec r43 = r41 - r31;
  const Pack longest = larger(larger(math::dot(r21, r21), math::dot(r32, r32)),
                              larger(math::dot(r43, r43), math::dot(r41, r41)));
  return area * scaled_slowness / square_root(longest);
}

/// Leaves the stable step for the driver; `area` is the smallest that a layer has.
template <class Pack>
CRUMPLE_INLINE void limit_step(const ShellPlace<RealOf<Pack>>& place, const Pack& area,
                               const ElementShape<Pack>& shape) {
  using Real = RealOf<Pack>;
  const Pack slowness =
      own_state<Pack>(place, element_state::step_scale) * Pack(place.task.constants.slowness);
  const auto active = own_state<Pack>(place, element_state::active) > Pack(Real(0));
  const Pack limit = stable_step(area, shape.r31, shape.r42, shape.r_mode, slowness);
  store(place.rows + scratch_row::shortest_step * tile_lanes, select<Pack>(active, limit, Pack(Real(1e30))));
}

}  // namespace crumple::elements
