// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/solid/solid_scatter.hpp"
#include "math/pack_vec3.hpp"

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

/// One vector field, or what is conjugate to it, by pattern: sums over the nodes with the pattern's signs,
/// eight times the coefficients, and forces conjugate to those sums. So neither the sums nor the nodal forces
/// need a factor.
template <class Pack>
struct SolidPatterns {
  math::PackVec3<Pack> of[pattern::count];
};

/// What the other seven nodes have more than the first.
template <class Pack>
struct SolidSides {
  math::PackVec3<Pack> of[7];
};

/// Patterns of a field from differences to the first node, which keep the digits and lose the translation.
template <class Pack>
CRUMPLE_INLINE SolidPatterns<Pack> patterns_of_sides(const SolidSides<Pack>& side) {
  SolidPatterns<Pack> p;
  const auto along = [&](Pack math::PackVec3<Pack>::*axis) {
    const auto node = [&](int k) { return side.of[k - 1].*axis; };
    const Pack up[4] = {node(4), node(5) - node(1), node(6) - node(2), node(7) - node(3)};
    const Pack sum[4] = {node(4), node(5) + node(1), node(6) + node(2), node(7) + node(3)};
    const auto around = [&](const Pack(&f)[4], int xi, int eta, int both) {
      const Pack d31 = f[2] - f[0];
      const Pack d42 = f[3] - f[1];
      p.of[xi].*axis = d31 - d42;
      p.of[eta].*axis = d31 + d42;
      p.of[both].*axis = (f[0] + f[2]) - (f[1] + f[3]);
    };
    around(sum, pattern::xi, pattern::eta, pattern::xi_eta);
    around(up, pattern::xi_zeta, pattern::eta_zeta, pattern::xi_eta_zeta);
    p.of[pattern::zeta].*axis = (up[0] + up[2]) + (up[1] + up[3]);
  };
  along(&math::PackVec3<Pack>::x);
  along(&math::PackVec3<Pack>::y);
  along(&math::PackVec3<Pack>::z);
  return p;
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

/// Forces at the nodes from those conjugate to the patterns.
template <class Pack>
CRUMPLE_INLINE SolidForces<Pack> nodal_forces(const SolidPatterns<Pack>& conjugate) {
  using Vec = math::PackVec3<Pack>;
  const auto& f = conjugate.of;
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
