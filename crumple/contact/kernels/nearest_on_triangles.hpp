// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The point of a triangle that is nearest to another, with one triangle per lane: of a pack, or of a vector
// of four numbers. The operations and their order are those of nearest_point(): the bits are the same.

#include "base/pack.hpp"
#include "math/small_vectors.hpp"

namespace crumple::contact::lanes_of {

using Mask4 = long long __attribute__((vector_size(32)));

template <class Real>
struct MaskOfLanes {
  using Type = MaskOf<Real>;
};
template <>
struct MaskOfLanes<math::Double4> {
  using Type = Mask4;
};
template <class Real>
using Mask = typename MaskOfLanes<Real>::Type;

template <class Real>
CRUMPLE_INLINE Real choose(const Mask<Real>& mask, const Real& a, const Real& b) {
  return select<Real>(mask, a, b);
}
template <>
CRUMPLE_INLINE math::Double4 choose(const Mask4& mask, const math::Double4& a, const math::Double4& b) {
  return mask ? a : b;
}

/// One point per lane.
template <class Real>
struct Points {
  Real x;
  Real y;
  Real z;
};

template <class Real>
CRUMPLE_INLINE Points<Real> operator-(const Points<Real>& a, const Points<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
CRUMPLE_INLINE Points<Real> operator+(const Points<Real>& a, const Points<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
CRUMPLE_INLINE Points<Real> operator*(const Real& a, const Points<Real>& b) {
  return {a * b.x, a * b.y, a * b.z};
}
template <class Real>
CRUMPLE_INLINE Real dot(const Points<Real>& a, const Points<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Weights of the corners of a triangle.
template <class Real>
struct Weights {
  Real a;
  Real b;
  Real c;
};

/// Those of the point of the triangle a b c that is nearest to p.
template <class Real>
CRUMPLE_INLINE Weights<Real> nearest_on_triangles(const Points<Real>& p, const Points<Real>& a,
                                                  const Points<Real>& b, const Points<Real>& c) {
  const Real zero{};
  const Real one = zero + 1.0;
  const Points<Real> ab = b - a;
  const Points<Real> ac = c - a;
  const Real a_ab = dot(p - a, ab);
  const Real a_ac = dot(p - a, ac);
  const Real b_ab = dot(p - b, ab);
  const Real b_ac = dot(p - b, ac);
  const Real c_ab = dot(p - c, ab);
  const Real c_ac = dot(p - c, ac);
  const Real area_c = a_ab * b_ac - b_ab * a_ac;
  const Real area_b = c_ab * a_ac - a_ab * c_ac;
  const Real area_a = b_ab * c_ac - c_ab * b_ac;
  // The regions in the order in which nearest_point() asks for them; the first that fits has it.
  const Mask<Real> at_a = (a_ab <= zero) & (a_ac <= zero);
  const Mask<Real> at_b = (b_ab >= zero) & (b_ac <= b_ab);
  const Mask<Real> at_c = (c_ac >= zero) & (c_ab <= c_ac);
  const Mask<Real> on_ab = (area_c <= zero) & (a_ab >= zero) & (b_ab <= zero);
  const Mask<Real> on_ac = (area_b <= zero) & (a_ac >= zero) & (c_ac <= zero);
  const Mask<Real> on_bc = (area_a <= zero) & (b_ac - b_ab >= zero) & (c_ab - c_ac >= zero);
  const Real whole = area_a + area_b + area_c;
  Real part = choose<Real>(on_bc, b_ac - b_ab, area_b);
  Real of = choose<Real>(on_bc, (b_ac - b_ab) + (c_ab - c_ac), whole);
  part = choose<Real>(on_ac, a_ac, part);
  of = choose<Real>(on_ac, a_ac - c_ac, of);
  part = choose<Real>(on_ab, a_ab, part);
  of = choose<Real>(on_ab, a_ab - b_ab, of);
  const Mask<Real> on_rim = on_ab | on_ac | on_bc;
  const Mask<Real> divides = (!on_rim) | (of > zero);
  // No division by zero where the quotient is not asked for.
  const Real t = choose<Real>(divides, part / choose<Real>(divides, of, one), zero);
  const Real w = choose<Real>(on_rim, zero, area_c / choose<Real>(on_rim, one, whole));
  Weights<Real> weights{one - t - w, t, w};
  weights.a = choose<Real>(on_bc, zero, weights.a);
  weights.b = choose<Real>(on_bc, one - t, weights.b);
  weights.c = choose<Real>(on_bc, t, weights.c);
  weights.a = choose<Real>(on_ac, one - t, weights.a);
  weights.b = choose<Real>(on_ac, zero, weights.b);
  weights.c = choose<Real>(on_ac, t, weights.c);
  weights.a = choose<Real>(on_ab, one - t, weights.a);
  weights.b = choose<Real>(on_ab, t, weights.b);
  weights.c = choose<Real>(on_ab, zero, weights.c);
  weights.a = choose<Real>(at_c, zero, weights.a);
  weights.b = choose<Real>(at_c, zero, weights.b);
  weights.c = choose<Real>(at_c, one, weights.c);
  weights.a = choose<Real>(at_b, zero, weights.a);
  weights.b = choose<Real>(at_b, one, weights.b);
  weights.c = choose<Real>(at_b, zero, weights.c);
  weights.a = choose<Real>(at_a, one, weights.a);
  weights.b = choose<Real>(at_a, zero, weights.b);
  weights.c = choose<Real>(at_a, zero, weights.c);
  return weights;
}

}  // namespace crumple::contact::lanes_of
