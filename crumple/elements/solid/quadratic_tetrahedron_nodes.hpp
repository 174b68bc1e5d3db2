// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/common/gather.hpp"
#include "elements/solid/tetrahedron_nodes.hpp"
#include "model/solid_nodes.hpp"

// The tetrahedron with ten nodes: its fields at four points, and its step.
//
//     corners 1, 2, 3 and 4, nodes 5 to 10 between 1-2, 2-3, 3-1, 1-4, 2-4, 3-4
//
// A field f is the sum of nodal values times L_i (2 L_i - 1) at corners and 4 L_i L_j between them, L the
// four volume coordinates (O.C. Zienkiewicz & R.L. Taylor, The Finite Element Method). The four points have
// one L of (5 + 3 sqrt 5) / 20 and three of (5 - sqrt 5) / 20, and a quarter of the volume each (P.C. Hammer,
// O.J. Marlowe & A.H. Stroud, Math. Tables Aids Comput. 10 (1956) 130-137).
namespace crumple::elements {

namespace quadratic_tetrahedron {
inline constexpr int points = 4;
inline constexpr int sides = 9;  ///< from the first node to the others
/// Rows that gather_quadratic_tetrahedra() fills: sides at time n, then their rates at n - 1/2.
inline constexpr int velocity = 3 * sides;
inline constexpr int rows = 2 * velocity;
/// Derivative of the field along L_2, L_3, L_4 at each point by the value of each node but the first.
struct Slopes {
  double of[points][sides][3];
};
constexpr Slopes slopes() {
  constexpr double root = 2.2360679774997896964;  // of 5
  constexpr double near = (5 + 3 * root) / 20;
  constexpr double far = (5 - root) / 20;
  Slopes found{};
  for (int point = 0; point < points; ++point) {
    double l[4] = {far, far, far, far};
    l[point] = near;
    for (int k = 0; k < 3; ++k) {
      // L_1 becomes less by what L_(k + 2) becomes more.
      const auto slope = [&](int i) { return (i == k + 1 ? 1.0 : 0.0) - (i == 0 ? 1.0 : 0.0); };
      for (int corner = 1; corner < 4; ++corner)
        found.of[point][corner - 1][k] = (4 * l[corner] - 1) * slope(corner);
      for (int side = 0; side < 6; ++side) {
        const auto& ends = model::sides_of_tetrahedron[static_cast<std::size_t>(side)];
        const int i = static_cast<int>(ends[0]);
        const int j = static_cast<int>(ends[1]);
        found.of[point][side + 3][k] = 4 * (l[j] * slope(i) + l[i] * slope(j));
      }
    }
  }
  return found;
}
inline constexpr Slopes slope = slopes();
}  // namespace quadratic_tetrahedron

/// Reads the nodes of width_of<Pack> elements into `rows`, [quadratic_tetrahedron::rows][width]; `node` is
/// [10][lanes] from the first of them. Differences of positions are taken in double.
template <class Pack>
CRUMPLE_INLINE void gather_quadratic_tetrahedra(const domain::NodeRecord<RealOf<Pack>>* nodes,
                                                const Index* node, RealOf<Pack>* rows) {
  using Real = RealOf<Pack>;
  constexpr int width = width_of<Pack>;
  for (int lane = 0; lane < width; ++lane) {
    const domain::NodeRecord<Real>& first = nodes[node[lane]];
    for (int side = 0; side < quadratic_tetrahedron::sides; ++side) {
      const domain::NodeRecord<Real>& end = nodes[node[(side + 1) * lanes + lane]];
      for (int axis = 0; axis < 3; ++axis) {
        Real* const at = rows + (3 * side + axis) * width + lane;
        *at = static_cast<Real>(end.position[axis] - first.position[axis]);
        at[quadratic_tetrahedron::velocity * width] = end.velocity[axis] - first.velocity[axis];
      }
    }
  }
}

/// Nine vectors from the first node to the others.
template <class Pack>
struct QuadraticSides {
  math::PackVec3<Pack> of[quadratic_tetrahedron::sides];
};
/// What gather_quadratic_tetrahedra() has left from `rows` on.
template <class Pack>
CRUMPLE_INLINE QuadraticSides<Pack> quadratic_sides(const RealOf<Pack>* rows) {
  QuadraticSides<Pack> found;
  for (int s = 0; s < quadratic_tetrahedron::sides; ++s) {
    const RealOf<Pack>* const at = rows + 3 * s * width_of<Pack>;
    found.of[s] = {load<Pack>(at), load<Pack>(at + width_of<Pack>), load<Pack>(at + 2 * width_of<Pack>)};
  }
  return found;
}

/// Derivatives of a field along the volume coordinates 2 to 4 at a point.
template <class Pack>
CRUMPLE_INLINE ThreeVectors<Pack> quadratic_tangents(const QuadraticSides<Pack>& f, int point) {
  using Real = RealOf<Pack>;
  ThreeVectors<Pack> found;
  for (int k = 0; k < 3; ++k) {
    const auto& slope = quadratic_tetrahedron::slope.of[point];
    found.of[k] = Pack(Real(slope[0][k])) * f.of[0];
    for (int s = 1; s < quadratic_tetrahedron::sides; ++s)
      found.of[k] = math::multiply_add(Pack(Real(slope[s][k])), f.of[s], found.of[k]);
  }
  return found;
}

/// Greatest v / l^2 of the points, v the volume of the tetrahedron of the tangents and l its
/// tetrahedron_length(); and the least six v with its sign.
template <class Pack>
struct QuadraticStiffness {
  Pack greatest;
  Pack narrowest;

  CRUMPLE_INLINE void add(const ThreeVectors<Pack>& area, const Pack& six_volumes) {
    const Pack length = tetrahedron_length(area, six_volumes);
    greatest = larger(greatest, Pack(Pack(RealOf<Pack>(1.0 / 6.0)) * six_volumes / (length * length)));
    narrowest = smaller(narrowest, six_volumes);
  }
};
template <class Pack>
CRUMPLE_INLINE QuadraticStiffness<Pack> no_quadratic_stiffness() {
  return {Pack(RealOf<Pack>(0)), Pack(RealOf<Pack>(1e30))};
}

/// What a wave must cross in one step, 2 c / omega: omega^2 is at most 25 c^2 (1 + 0.7 (1 - shear_share))
/// times the greatest v / l^2 over the volume of the element. The 25 is proven for scalar fields, the rest is
/// measured: docs/theory/quadratic_tetrahedra.md.
template <class Pack>
CRUMPLE_INLINE Pack quadratic_length(const QuadraticStiffness<Pack>& stiffness, const Pack& volume,
                                     const Pack& shear_share) {
  using Real = RealOf<Pack>;
  const Pack swelling = multiply_add(Pack(Real(-0.7)), shear_share, Pack(Real(1.7)));
  return Pack(Real(0.4)) * square_root(Pack(volume / (swelling * stiffness.greatest)));
}

}  // namespace crumple::elements
