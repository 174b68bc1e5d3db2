// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "domain/node_fields.hpp"
#include "elements/solid/solid_formulation.hpp"
#include "elements/solid/solid_scatter.hpp"
#include "math/pack_vec3.hpp"

namespace crumple::elements {

/// Corners of a face in the parent square: nodes 1 to 4, and 5 to 8 above them.
namespace cohesive {
inline constexpr int points = 4;
inline constexpr int xi[4] = {-1, 1, 1, -1};
inline constexpr int eta[4] = {-1, -1, 1, 1};
/// Weight of corner `k` at the point of corner `p`, whose coordinates are +-place.
template <class Real>
CRUMPLE_INLINE constexpr Real weight(int p, int k, Real place) {
  return (1 + Real(xi[p] * xi[k]) * place) * (1 + Real(eta[p] * eta[k]) * place) / 4;
}
// Of what the element keeps: areas of the points [length^2], then the separations of the four pairs of nodes
// at time zero in its axes.
inline constexpr Index area = 0;
inline constexpr Index separation = points;
inline constexpr Index kept = separation + 12;
}  // namespace cohesive

/// Middle surface and separations of the four pairs of nodes.
template <class Pack>
struct CohesivePose {
  math::PackVec3<Pack> tangent[2];  ///< of the middle surface at its centre, along xi and eta
  math::PackVec3<Pack> pair[4];     ///< from the node of the lower face to that of the upper one
};
/// Rows of it in the order of its vectors.
inline constexpr int cohesive_rows = 18;

/// Axes that follow the middle surface.
template <class Pack>
struct CohesiveAxes {
  math::PackVec3<Pack> axis[3];  ///< along the first tangent, across it, along the normal
  Pack per_length;               ///< 1 / length of the first tangent
  Pack per_area;                 ///< 1 / area between the tangents, a quarter of the element's
};
template <class Pack>
CRUMPLE_INLINE CohesiveAxes<Pack> cohesive_axes(const CohesivePose<Pack>& pose) {
  const Pack one(RealOf<Pack>(1));
  const math::PackVec3<Pack> across = math::cross(pose.tangent[0], pose.tangent[1]);
  CohesiveAxes<Pack> axes;
  axes.per_length = one / square_root(math::dot(pose.tangent[0], pose.tangent[0]));
  axes.per_area = one / square_root(math::dot(across, across));
  axes.axis[0] = axes.per_length * pose.tangent[0];
  axes.axis[2] = axes.per_area * across;
  axes.axis[1] = math::cross(axes.axis[2], axes.axis[0]);
  return axes;
}
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> in_axes(const CohesiveAxes<Pack>& axes, const math::PackVec3<Pack>& v) {
  return {math::dot(axes.axis[0], v), math::dot(axes.axis[1], v), math::dot(axes.axis[2], v)};
}

/// From the positions of the eight nodes; differences are formed in double.
template <class Pack, class Position>
CRUMPLE_INLINE void cohesive_pose(const Position& position, double (&row)[cohesive_rows]) {
  for (int axis = 0; axis < 3; ++axis) {
    double middle[4];
    for (int k = 0; k < 4; ++k) {
      // Relative to the first node of each face, or digits are lost far from the origin.
      const double lower = position(k)[axis] - position(0)[axis];
      const double upper = position(k + 4)[axis] - position(4)[axis];
      middle[k] = 0.5 * (lower + upper);
      row[6 + 3 * k + axis] = position(k + 4)[axis] - position(k)[axis];
    }
    const double one = middle[2] - middle[0];
    const double other = middle[3] - middle[1];
    row[axis] = 0.25 * (one - other);
    row[3 + axis] = 0.25 * (one + other);
  }
}

/// A solid of two faces with four nodes each, that may coincide, held together by tractions at 2 x 2 points
/// of its middle surface: docs/theory/cohesive_solids.md.
struct CohesiveHexahedron {
  static constexpr model::SolidFormulation formulation = model::SolidFormulation::CohesiveHexahedron;
  static constexpr const char* name = "cohesive hexahedron";
  static constexpr int points = cohesive::points;
  static constexpr int corners = 8;
  static constexpr KeptItem kept{"cohesive_reference", "length", cohesive::kept};
  static constexpr bool averages = false;
  static constexpr int rows = solid_scratch::own;

  template <class Pack>
  static void strains(const SolidPlace<RealOf<Pack>>& place);
  template <class Pack>
  static SolidForces<Pack> forces(const SolidPlace<RealOf<Pack>>& place);

  /// Leaves the rows of the pose, of a square at rest where the element is gone.
  template <class Pack>
  static void gather(const SolidPlace<RealOf<Pack>>& place);
  template <class Pack>
  static CohesivePose<Pack> pose(const SolidPlace<RealOf<Pack>>& place);
  /// Separation at a point, with that of time zero, in the element's axes.
  template <class Pack>
  static math::PackVec3<Pack> separation(const SolidPlace<RealOf<Pack>>& place,
                                         const math::PackVec3<Pack> (&pair)[4], int point);
};

template <class Pack>
CRUMPLE_INLINE void CohesiveHexahedron::gather(const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  constexpr int width = width_of<Pack>;
  for (int lane = 0; lane < width; ++lane) {
    double row[cohesive_rows];
    cohesive_pose<Pack>([&](int k) { return place.task.nodes[place.node[k * lanes + lane]].position; }, row);
    for (int r = 0; r < cohesive_rows; ++r) place.nodes[r * width + lane] = static_cast<Real>(row[r]);
  }
  if (!place.task.constants.can_fail) return;
  const MaskOf<Pack> gone = gone_for_ever<Pack>(place, 0);
  if (!any<Pack>(gone)) return;
  for (int r = 0; r < cohesive_rows; ++r) {
    Real* const at = place.nodes + r * width;
    store(at, select<Pack>(gone, Pack(Real(r == 0 || r == 4 ? 1 : 0)), load<Pack>(at)));
  }
}

template <class Pack>
CRUMPLE_INLINE CohesivePose<Pack> CohesiveHexahedron::pose(const SolidPlace<RealOf<Pack>>& place) {
  const auto vector = [&](int v) {
    const RealOf<Pack>* const at = place.nodes + 3 * v * width_of<Pack>;
    return math::PackVec3<Pack>{load<Pack>(at), load<Pack>(at + width_of<Pack>),
                                load<Pack>(at + 2 * width_of<Pack>)};
  };
  return {{vector(0), vector(1)}, {vector(2), vector(3), vector(4), vector(5)}};
}

template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> CohesiveHexahedron::separation(const SolidPlace<RealOf<Pack>>& place,
                                                                   const math::PackVec3<Pack> (&pair)[4],
                                                                   int point) {
  const RealOf<Pack> coordinate = place.task.constants.point_place;
  math::PackVec3<Pack> sum = Pack(cohesive::weight(point, 0, coordinate)) * pair[0];
  for (int k = 1; k < 4; ++k)
    sum = math::multiply_add(Pack(cohesive::weight(point, k, coordinate)), pair[k], sum);
  return sum;
}

template <class Pack>
CRUMPLE_INLINE void CohesiveHexahedron::strains(const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  gather<Pack>(place);
  const CohesivePose<Pack> now = pose<Pack>(place);
  const CohesiveAxes<Pack> axes = cohesive_axes(now);
  const Pack zero(Real(0));
  // What each pair has moved apart, in the axes: small beside the thickness, so it is formed first.
  math::PackVec3<Pack> moved[4];
  for (int k = 0; k < 4; ++k)
    moved[k] =
        in_axes(axes, now.pair[k]) - own_vector<Pack>(place, solid_state::own + cohesive::separation + 3 * k);
  for (int point = 0; point < points; ++point) {
    const math::PackVec3<Pack> apart = separation<Pack>(place, moved, point);
    Real* const strain = place.strain + point * materials::solid_components * tile_lanes;
    store(strain, apart.x);
    store(strain + tile_lanes, apart.y);
    store(strain + 2 * tile_lanes, apart.z);
    for (int c = 3; c < materials::solid_components; ++c) store(strain + c * tile_lanes, zero);
    for (int c = 0; c < 9; ++c) store(place.turn + (point * 9 + c) * tile_lanes, zero);
  }
}

template <class Pack>
CRUMPLE_INLINE SolidForces<Pack> CohesiveHexahedron::forces(const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  using math::cross;
  const CohesivePose<Pack> now = pose<Pack>(place);
  const CohesiveAxes<Pack> axes = cohesive_axes(now);
  const Pack zero(Real(0));
  const Pack active = own_item<Pack>(place, solid_state::active);
  Pack work = zero;
  Vec on_pair[4];
  for (Vec& f : on_pair) f = {zero, zero, zero};
  Pack tilt[2] = {zero, zero};  // conjugate to the turn of the normal towards the first two axes
  Pack spin = zero;             // and to that about the normal
  for (int point = 0; point < points; ++point) {
    const Pack area = active * own_item<Pack>(place, solid_state::own + cohesive::area + point);
    const auto force = [&](int c) {
      return area * load<Pack>(place.state + (point * materials::solid_components + c) * lanes);
    };
    const Vec f{force(0), force(1), force(2)};
    const Vec d = in_axes(axes, separation<Pack>(place, now.pair, point));
    tilt[0] = tilt[0] + multiply_add(f.z, d.x, Pack(-(f.x * d.z)));
    tilt[1] = tilt[1] + multiply_add(f.z, d.y, Pack(-(f.y * d.z)));
    spin = spin + multiply_add(f.x, d.y, Pack(-(f.y * d.x)));
    const Vec global =
        math::multiply_add(f.x, axes.axis[0], math::multiply_add(f.y, axes.axis[1], f.z * axes.axis[2]));
    for (int k = 0; k < 4; ++k)
      on_pair[k] = math::multiply_add(Pack(cohesive::weight(point, k, place.task.constants.point_place)),
                                      global, on_pair[k]);
    work = multiply_add(area, kept_row<Pack>(place, solid_scratch::material_energy + point), work);
  }
  keep_row(place, solid_scratch::internal_energy, work);
  keep_row(place, solid_scratch::hourglass_energy, zero);
  keep_row(place, solid_scratch::shortest_step,
           select<Pack>(active > zero, own_item<Pack>(place, solid_state::step_scale), Pack(Real(1e30))));
  // The axes turn with the middle surface: forces conjugate to its tangents. An eighth as each is a quarter
  // of a sum over means of two nodes.
  const Vec couple = math::multiply_add(tilt[0], axes.axis[0], tilt[1] * axes.axis[1]);
  const Pack eighth(Real(0.125));
  const Vec on_first = eighth * math::multiply_add(Pack(spin * axes.per_length), axes.axis[1],
                                                   axes.per_area * cross(now.tangent[1], couple));
  const Vec on_second = Pack(eighth * axes.per_area) * cross(couple, now.tangent[0]);
  SolidForces<Pack> found;
  for (int k = 0; k < 4; ++k) {
    const Vec both =
        math::multiply_add(Pack(Real(cohesive::xi[k])), on_first, Pack(Real(cohesive::eta[k])) * on_second);
    found.of[k] = both - on_pair[k];
    found.of[k + 4] = both + on_pair[k];
  }
  return found;
}

}  // namespace crumple::elements
