// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/common/gather.hpp"
#include "elements/solid/solid_scatter.hpp"
#include "elements/solid/tangents.hpp"

// What a tetrahedron has of its nodes: the three sides from the first to the others.
namespace crumple::elements {

/// Rows that gather_tetrahedra() fills: sides at time n, then their rates, the velocity differences, at n -
/// 1/2.
namespace tetrahedron_row {
inline constexpr int velocity = 9;
inline constexpr int count = 18;
}  // namespace tetrahedron_row

template <class Real, int Width>
CRUMPLE_INLINE void gather_one_tetrahedron(const domain::NodeRecord<Real>* nodes, const Index* node, int lane,
                                           Real (*rows)[Width]) {
  const domain::NodeRecord<Real>& first = nodes[node[lane]];
  for (int side = 0; side < 3; ++side) {
    const domain::NodeRecord<Real>& end = nodes[node[(side + 1) * lanes + lane]];
    for (int axis = 0; axis < 3; ++axis) {
      rows[3 * side + axis][lane] = static_cast<Real>(end.position[axis] - first.position[axis]);
      rows[tetrahedron_row::velocity + 3 * side + axis][lane] = end.velocity[axis] - first.velocity[axis];
    }
  }
}

/// Four elements, record by record; the arithmetic is that of gather_one_tetrahedron.
template <class Real, int Width>
CRUMPLE_INLINE void gather_four_tetrahedra(const domain::NodeRecord<Real>* nodes, const Index* node, int lane,
                                           Real (*rows)[Width]) {
  using math::Double4;
  using Item = std::conditional_t<std::is_same_v<Real, float>, math::Float4, Double4>;
  Item side[3][4];
  Item rate[3][4];
  for (int i = 0; i < 4; ++i) {
    const domain::NodeRecord<Real>& first = nodes[node[lane + i]];
    const Double4 x = math::read<Double4>(first.position);
    const Item v = math::read<Item>(first.velocity);
    for (int s = 0; s < 3; ++s) {
      const domain::NodeRecord<Real>& end = nodes[node[(s + 1) * lanes + lane + i]];
      side[s][i] = math::narrowed(Double4(math::read<Double4>(end.position) - x), Real(0));
      rate[s][i] = math::read<Item>(end.velocity) - v;
    }
  }
  for (int s = 0; s < 3; ++s) {
    write_rows(&rows[3 * s][lane], Width, side[s][0], side[s][1], side[s][2], side[s][3]);
    write_rows(&rows[tetrahedron_row::velocity + 3 * s][lane], Width, rate[s][0], rate[s][1], rate[s][2],
               rate[s][3]);
  }
}

/// Reads the nodes of width_of<Pack> tetrahedra into `rows`, [tetrahedron_row::count][width]; `node` is
/// [4][lanes] from the first of them.
template <class Pack>
CRUMPLE_INLINE void gather_tetrahedra(const domain::NodeRecord<RealOf<Pack>>* nodes, const Index* node,
                                      RealOf<Pack>* rows) {
  using Real = RealOf<Pack>;
  constexpr int width = width_of<Pack>;
  const auto row = reinterpret_cast<Real(*)[width]>(rows);
  if constexpr (width >= 4)
    for (int lane = 0; lane < width; lane += 4) gather_four_tetrahedra<Real, width>(nodes, node, lane, row);
  else
    for (int lane = 0; lane < width; ++lane) gather_one_tetrahedron<Real, width>(nodes, node, lane, row);
}

/// What gather_tetrahedra() has left from `rows` on.
template <class Pack>
CRUMPLE_INLINE ThreeVectors<Pack> gathered_sides(const RealOf<Pack>* rows) {
  ThreeVectors<Pack> found;
  for (int s = 0; s < 3; ++s) {
    const RealOf<Pack>* const at = rows + 3 * s * width_of<Pack>;
    found.of[s] = {load<Pack>(at), load<Pack>(at + width_of<Pack>), load<Pack>(at + 2 * width_of<Pack>)};
  }
  return found;
}

/// What a wave must cross in one step, from areas_across() the sides at the first node: 1 / sqrt of the
/// largest eigenvalue of the sum of g g^T over the gradients g of the four shape functions, or less. With m a
/// third of the trace and p^2 a sixth of the squares of the deviator no eigenvalue of a symmetric matrix is
/// above m + 2 p.
template <class Pack>
CRUMPLE_INLINE Pack tetrahedron_length(const ThreeVectors<Pack>& area, const Pack& six_volumes) {
  using Real = RealOf<Pack>;
  using math::dot;
  const math::PackVec3<Pack> first = -(area.of[0] + (area.of[1] + area.of[2]));
  const math::PackVec3<Pack> a[4] = {area.of[0], area.of[1], area.of[2], first};
  Pack trace(Real(0));
  Pack squares(Real(0));
  for (int i = 0; i < 4; ++i) {
    const Pack own = dot(a[i], a[i]);
    trace = trace + own;
    squares = multiply_add(own, own, squares);
    for (int j = 0; j < i; ++j) {
      const Pack both = dot(a[i], a[j]);
      squares = multiply_add(Pack(both + both), both, squares);
    }
  }
  const Pack mean = Pack(Real(1.0 / 3.0)) * trace;
  const Pack deviation = larger(Pack(Real(0)), multiply_add(Pack(Real(-1.0 / 3.0)) * trace, trace, squares));
  const Pack largest =
      multiply_add(Pack(Real(2)), square_root(Pack(Pack(Real(1.0 / 6.0)) * deviation)), mean);
  return six_volumes / square_root(largest);
}

}  // namespace crumple::elements
