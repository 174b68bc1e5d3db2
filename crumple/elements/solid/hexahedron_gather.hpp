// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "domain/node_fields.hpp"
#include "elements/solid/solid_formulation.hpp"
#include "elements/solid/solid_patterns.hpp"
#include "math/small_vectors.hpp"

// From the records of the nodes to patterns in packs.
namespace crumple::elements {

/// Rows of positions that strains() leaves for forces().
inline constexpr int hexahedron_rows = 3 * pattern::count;

/// Vectors of elements `first` and, in eight numbers, first + 4, each as `read` gives it.
template <class Items, class Read>
CRUMPLE_INLINE Items every_fourth(const Read& read, int first) {
  if constexpr (std::is_same_v<Items, math::Float8>)
    return math::joined(read(first), read(first + 4));
  else
    return read(first);
}

/// Elements gathered at a time. With AVX-512 half a pack: to turn whole registers takes as long as both
/// halves.
template <class Pack>
inline constexpr int gathered_width = width_of<Pack> * sizeof(RealOf<Pack>) == 64 ? width_of<Pack> / 2
                                                                                  : width_of<Pack>;

/// Rows of the three numbers of a vector of every element, [3][width], from four vectors of every_fourth() or
/// from one for each element.
template <int Width, class Real, class Items>
CRUMPLE_INLINE void write_columns(Real* row, int stride, const Items (&items)[4]) {
  if constexpr (Width >= 4) {
    const auto columns = math::transposed(items[0], items[1], items[2], items[3]);
    for (int axis = 0; axis < 3; ++axis) math::write(row + axis * stride, columns.row[axis]);
  } else {
    for (int lane = 0; lane < Width; ++lane)
      for (int axis = 0; axis < 3; ++axis) row[axis * stride + lane] = items[lane][axis];
  }
}

/// Differences to the first node as they are gathered, [node][axis][width].
template <class Pack>
struct HexahedronSides {
  alignas(cache_line) RealOf<Pack> x[7][3][width_of<Pack>];  ///< of positions at time n
  alignas(cache_line) RealOf<Pack> v[7][3][width_of<Pack>];  ///< of velocities at n - 1/2
};
template <class Pack>
CRUMPLE_INLINE SolidSides<Pack> loaded(const RealOf<Pack> (&rows)[7][3][width_of<Pack>]) {
  SolidSides<Pack> side;
  for (int k = 0; k < 7; ++k)
    side.of[k] = {load<Pack>(rows[k][0]), load<Pack>(rows[k][1]), load<Pack>(rows[k][2])};
  return side;
}

template <class Pack>
CRUMPLE_INLINE void gather_sides(const SolidPlace<RealOf<Pack>>& place, int start,
                                 HexahedronSides<Pack>& side) {
  using Real = RealOf<Pack>;
  constexpr int width = gathered_width<Pack>;
  using Items = ItemsOf<Real, width>;
  constexpr int vectors = width < 4 ? width : 4;
  const auto record = [&](int k, int element) -> const domain::NodeRecord<Real>& {
    return place.task.nodes[place.node[k * lanes + start + element]];
  };
  // In double, or the digits of the difference are lost.
  const auto positions = [&](int k, int r) {
    const auto difference = [&](int element) {
      using math::Double4;
      return math::narrowed(Double4(math::read<Double4>(record(k, element).position) -
                                    math::read<Double4>(record(0, element).position)),
                            Real(0));
    };
    return every_fourth<Items>(difference, r);
  };
  const auto velocities = [&](int k, int r) {
    return every_fourth<Items>(
        [&](int element) { return math::read<ItemsOf<Real, 4>>(record(k, element).velocity); }, r);
  };
  Items first[4];
  for (int r = 0; r < vectors; ++r) first[r] = velocities(0, r);
  for (int k = 1; k < 8; ++k) {
    Items x[4];
    Items v[4];
    for (int r = 0; r < vectors; ++r) {
      x[r] = positions(k, r);
      v[r] = velocities(k, r) - first[r];
    }
    write_columns<width>(side.x[k - 1][0] + start, width_of<Pack>, x);
    write_columns<width>(side.v[k - 1][0] + start, width_of<Pack>, v);
  }
}

/// Motion of the elements of a pack: patterns at the end of the step n, and at its middle.
template <class Pack>
struct SolidMotion {
  SolidPatterns<Pack> x;  ///< positions at the middle of the step
  SolidPatterns<Pack> v;  ///< velocities there
};

/// Puts a cube at rest in the place of elements whose every force is zero for ever: the nodes of eroded
/// elements may go anywhere, and must not lead to numbers that are none.
template <class Pack>
CRUMPLE_INLINE void rest_failed_cubes(const MaskOf<Pack>& gone, SolidPatterns<Pack>& x,
                                      SolidPatterns<Pack>& v) {
  using Vec = math::PackVec3<Pack>;
  const auto put = [&](Vec& vec, const Vec& rest) {
    vec = {select<Pack>(gone, rest.x, vec.x), select<Pack>(gone, rest.y, vec.y),
           select<Pack>(gone, rest.z, vec.z)};
  };
  const Pack one(RealOf<Pack>(1));
  const Pack zero(RealOf<Pack>(0));
  const Vec none{zero, zero, zero};
  const Vec axes[3] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
  for (int p = 0; p < pattern::count; ++p) {
    put(x.of[p], p < 3 ? axes[p] : none);
    put(v.of[p], none);
  }
}

/// Gathers what strains() needs and leaves the positions at time n for forces(). `own_items` is the number of
/// items that the formulation keeps.
template <class Pack>
CRUMPLE_INLINE SolidMotion<Pack> gathered_motion(const SolidPlace<RealOf<Pack>>& place, Index own_items) {
  HexahedronSides<Pack> side;
  for (int start = 0; start < width_of<Pack>; start += gathered_width<Pack>) gather_sides(place, start, side);
  SolidPatterns<Pack> x = patterns_of_sides(loaded<Pack>(side.x));
  SolidPatterns<Pack> v = patterns_of_sides(loaded<Pack>(side.v));
  if (place.task.constants.can_fail)
    if (const MaskOf<Pack> gone = gone_for_ever<Pack>(place, own_items); any<Pack>(gone))
      rest_failed_cubes<Pack>(gone, x, v);
  for (int p = 0; p < pattern::count; ++p) {
    RealOf<Pack>* const at = place.nodes + 3 * p * width_of<Pack>;
    store(at, x.of[p].x);
    store(at + width_of<Pack>, x.of[p].y);
    store(at + 2 * width_of<Pack>, x.of[p].z);
  }
  return {middle_positions(x, v, place.task.step), v};
}

/// What gathered_motion() has left.
template <class Pack>
CRUMPLE_INLINE SolidPatterns<Pack> left_positions(const SolidPlace<RealOf<Pack>>& place) {
  SolidPatterns<Pack> found;
  for (int p = 0; p < pattern::count; ++p) {
    const RealOf<Pack>* const at = place.nodes + 3 * p * width_of<Pack>;
    found.of[p] = {load<Pack>(at), load<Pack>(at + width_of<Pack>), load<Pack>(at + 2 * width_of<Pack>)};
  }
  return found;
}

}  // namespace crumple::elements
