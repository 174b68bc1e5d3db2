// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "domain/node_fields.hpp"
#include "elements/gather.hpp"
#include "elements/solid_scatter.hpp"
#include "math/pack_vec3.hpp"
#include "math/small_vectors.hpp"

// A nodal field of a hexahedron is the sum of eight patterns of +1 and -1: f = f0 + f_xi xi + f_eta eta +
// f_zeta zeta + f_1 eta zeta + f_2 xi zeta + f_3 xi eta + f_4 xi eta zeta. In these the element's arithmetic
// is short: volume, gradients and hourglass modes are written in them at once, and rigid translation is gone.
namespace crumple::elements {

/// Places of the patterns. Nodes 1 to 4 lie at (xi, eta) = (-1, -1), (1, -1), (1, 1), (-1, 1) with zeta = -1,
/// nodes 5 to 8 above them.
namespace pattern {
inline constexpr int xi = 0;
inline constexpr int eta = 1;
inline constexpr int zeta = 2;
inline constexpr int eta_zeta = 3;
inline constexpr int xi_zeta = 4;
inline constexpr int xi_eta = 5;
inline constexpr int xi_eta_zeta = 6;
inline constexpr int count = 7;
inline constexpr int hourglass = 3;  ///< the first of the four hourglass patterns
}  // namespace pattern

/// One vector field, or what is conjugate to it, by pattern.
template <class Pack>
struct SolidPatterns {
  math::PackVec3<Pack> of[pattern::count];
};

/// Coefficients of the patterns of one number, or small vector, per node.
template <class Number>
struct PatternItems {
  Number of[pattern::count];
};
template <class Real, class Number>
CRUMPLE_INLINE PatternItems<Number> pattern_items(const Number (&node)[8]) {
  // Relative to node 1 first, to keep the digits.
  Number up[4];
  Number sum[4];
  for (int k = 0; k < 4; ++k) {
    const Number low = node[k] - node[0];
    const Number high = node[k + 4] - node[0];
    up[k] = high - low;
    sum[k] = high + low;
  }
  const auto around = [](const Number(&f)[4], Number& xi, Number& eta, Number& both) {
    const Number d31 = f[2] - f[0];
    const Number d42 = f[3] - f[1];
    xi = d31 - d42;
    eta = d31 + d42;
    both = (f[0] + f[2]) - (f[1] + f[3]);
  };
  PatternItems<Number> p;
  around(sum, p.of[pattern::xi], p.of[pattern::eta], p.of[pattern::xi_eta]);
  around(up, p.of[pattern::xi_zeta], p.of[pattern::eta_zeta], p.of[pattern::xi_eta_zeta]);
  p.of[pattern::zeta] = (up[0] + up[2]) + (up[1] + up[3]);
  for (Number& item : p.of) item = Real(0.125) * item;
  return p;
}

/// Rows of positions at time n, then of velocities at n - 1/2: gather_solids() leaves the vectors from node 1
/// to the others, make_patterns() puts the coefficients of the patterns in their place.
namespace solid_row {
inline constexpr int velocity = 3 * pattern::count;
inline constexpr int count = 6 * pattern::count;
}  // namespace solid_row

template <class Real, int Width>
CRUMPLE_INLINE void gather_one_solid(const domain::NodeRecord<Real>* nodes, const Index* node, int lane,
                                     Real (*rows)[Width]) {
  const domain::NodeRecord<Real>& first = nodes[node[lane]];
  for (int k = 0; k < pattern::count; ++k) {
    const domain::NodeRecord<Real>& other = nodes[node[(k + 1) * lanes + lane]];
    for (int axis = 0; axis < 3; ++axis) {
      rows[3 * k + axis][lane] = static_cast<Real>(other.position[axis] - first.position[axis]);
      rows[solid_row::velocity + 3 * k + axis][lane] = other.velocity[axis] - first.velocity[axis];
    }
  }
}

CRUMPLE_INLINE math::Float4 narrowed(const math::Double4& v, float /*to*/) {
  return math::to_float(v);
}
CRUMPLE_INLINE math::Double4 narrowed(const math::Double4& v, double /*to*/) {
  return v;
}

/// Four elements, record by record; the arithmetic is that of gather_one_solid.
template <class Real, int Width>
CRUMPLE_INLINE void gather_four_solids(const domain::NodeRecord<Real>* nodes, const Index* node, int lane,
                                       Real (*rows)[Width]) {
  using math::Double4;
  using Item = std::conditional_t<std::is_same_v<Real, float>, math::Float4, Double4>;
  Double4 x[4];
  Item v[4];
  for (int i = 0; i < 4; ++i) {
    const domain::NodeRecord<Real>& first = nodes[node[lane + i]];
    x[i] = math::read<Double4>(first.position);
    v[i] = math::read<Item>(first.velocity);
  }
  for (int k = 0; k < pattern::count; ++k) {
    Item position[4];
    Item velocity[4];
    for (int i = 0; i < 4; ++i) {
      const domain::NodeRecord<Real>& other = nodes[node[(k + 1) * lanes + lane + i]];
      position[i] = narrowed(Double4(math::read<Double4>(other.position) - x[i]), Real(0));
      velocity[i] = math::read<Item>(other.velocity) - v[i];
    }
    write_rows(&rows[3 * k][lane], Width, position[0], position[1], position[2], position[3]);
    write_rows(&rows[solid_row::velocity + 3 * k][lane], Width, velocity[0], velocity[1], velocity[2],
               velocity[3]);
  }
}

/// Reads the nodes of width_of<Pack> hexahedra into `rows`, [solid_row::count][width]; `node` is [8][lanes]
/// from the first of them.
template <class Pack>
CRUMPLE_INLINE void gather_solids(const domain::NodeRecord<RealOf<Pack>>* nodes, const Index* node,
                                  RealOf<Pack>* rows) {
  using Real = RealOf<Pack>;
  constexpr int width = width_of<Pack>;
  const auto row = reinterpret_cast<Real(*)[width]>(rows);
  if constexpr (width >= 4)
    for (int lane = 0; lane < width; lane += 4) gather_four_solids<Real, width>(nodes, node, lane, row);
  else
    for (int lane = 0; lane < width; ++lane) gather_one_solid<Real, width>(nodes, node, lane, row);
}

/// Turns what gather_solids() has left into coefficients of patterns, in place.
template <class Pack>
CRUMPLE_INLINE void make_patterns(RealOf<Pack>* rows) {
  using Real = RealOf<Pack>;
  for (const int quantity : {0, solid_row::velocity})
    for (int axis = 0; axis < 3; ++axis) {
      Real* const at = rows + (quantity + axis) * width_of<Pack>;
      Pack node[8];
      node[0] = Pack(Real(0));
      for (int k = 0; k < pattern::count; ++k) node[k + 1] = load<Pack>(at + 3 * k * width_of<Pack>);
      const PatternItems<Pack> items = pattern_items<Real>(node);
      for (int p = 0; p < pattern::count; ++p) store(at + 3 * p * width_of<Pack>, items.of[p]);
    }
}

/// What make_patterns() has left.
template <class Pack>
CRUMPLE_INLINE SolidPatterns<Pack> gathered_patterns(const RealOf<Pack>* rows) {
  SolidPatterns<Pack> found;
  for (int p = 0; p < pattern::count; ++p) {
    const RealOf<Pack>* const at = rows + 3 * p * width_of<Pack>;
    found.of[p] = {load<Pack>(at), load<Pack>(at + width_of<Pack>), load<Pack>(at + 2 * width_of<Pack>)};
  }
  return found;
}

template <class Pack>
CRUMPLE_INLINE SolidPatterns<Pack> gathered_velocities(const RealOf<Pack>* rows) {
  return gathered_patterns<Pack>(rows + solid_row::velocity * width_of<Pack>);
}
/// Positions at the middle of the step from those at its end.
template <class Pack>
CRUMPLE_INLINE SolidPatterns<Pack> middle_positions(const SolidPatterns<Pack>& end,
                                                    const SolidPatterns<Pack>& velocity, RealOf<Pack> step) {
  const Pack back(-(RealOf<Pack>(0.5) * step));
  SolidPatterns<Pack> middle;
  for (int p = 0; p < pattern::count; ++p) middle.of[p] = math::multiply_add(back, velocity.of[p], end.of[p]);
  return middle;
}

/// Forces at the nodes from those conjugate to the patterns' coefficients.
template <class Pack>
CRUMPLE_INLINE SolidForces<Pack> nodal_forces(const SolidPatterns<Pack>& conjugate) {
  using Vec = math::PackVec3<Pack>;
  Vec f[pattern::count];
  for (int p = 0; p < pattern::count; ++p) f[p] = Pack(RealOf<Pack>(0.125)) * conjugate.of[p];
  const auto around = [](const Vec& along, const Vec& across, const Vec& both, Vec(&out)[4]) {
    const Vec sum = along + across;
    const Vec difference = along - across;
    out[0] = both - sum;
    out[1] = difference - both;
    out[2] = both + sum;
    out[3] = -(both + difference);
  };
  Vec level[4];
  Vec up[4];
  around(f[pattern::xi], f[pattern::eta], f[pattern::xi_eta], level);
  around(f[pattern::xi_zeta], f[pattern::eta_zeta], f[pattern::xi_eta_zeta], up);
  SolidForces<Pack> nodal;
  for (int k = 0; k < 4; ++k) {
    const Vec lift = up[k] + f[pattern::zeta];
    nodal.of[k] = level[k] - lift;
    nodal.of[k + 4] = level[k] + lift;
  }
  return nodal;
}

}  // namespace crumple::elements
