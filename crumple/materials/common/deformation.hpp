// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"
#include "base/pack.hpp"
#include "materials/common/solid_stress.hpp"

// What laws of total deformation and equations of state make of strain increment and rotation: elements need
// not know of it. Sums are kept with what they have lost to rounding, or float would drift.
namespace crumple::materials {

/// Adds to the number at `place`, whose lost digits stand at `rest` (D.E. Knuth, The Art of Computer
/// Programming 2, section 4.2.2). Returns the sum.
template <class Pack>
CRUMPLE_INLINE Pack add_kept(RealOf<Pack>* place, RealOf<Pack>* rest, const Pack& growth) {
  const Pack old = load<Pack>(place);
  const Pack more = growth + load<Pack>(rest);
  const Pack sum = old + more;
  const Pack taken = sum - old;
  store(rest, Pack((old - (sum - taken)) + (more - taken)));
  store(place, sum);
  return sum;
}

/// Increment A = L dt of the step, L the velocity gradient at the middle of the step: the symmetric part is
/// the strain increment, the spin is taken back out of the rotation (I - W/2)^-1 (I + W/2).
template <class Pack>
CRUMPLE_INLINE Turn<Pack> step_gradient(const SolidStrain<Pack>& e, const Turn<Pack>& turn) {
  using Real = RealOf<Pack>;
  const Pack half(Real(0.5));
  // Of the axial vector t of W: skew part of the rotation k t, its trace -k t.t, with k = 1 / (1 + t.t / 4).
  const Pack trace = turn.xx + (turn.yy + turn.zz);
  const Pack over = half / multiply_add(Pack(Real(0.25)), trace, Pack(Real(1)));
  const Pack x = over * (turn.zy - turn.yz);
  const Pack y = over * (turn.xz - turn.zx);
  const Pack z = over * (turn.yx - turn.xy);
  const Pack xy = half * e.xy;
  const Pack yz = half * e.yz;
  const Pack zx = half * e.zx;
  return {e.xx, xy - z, zx + y, xy + z, e.yy, yz - x, zx - y, yz + x, e.zz};
}

/// Invariants of a 3x3 matrix.
template <class Pack>
struct Invariants {
  Pack trace, second, determinant;
};
template <class Pack>
CRUMPLE_INLINE Invariants<Pack> invariants(const Turn<Pack>& a) {
  const Pack xx = multiply_add(a.yy, a.zz, Pack(-(a.yz * a.zy)));
  const Pack yx = multiply_add(a.yz, a.zx, Pack(-(a.yx * a.zz)));
  const Pack zx = multiply_add(a.yx, a.zy, Pack(-(a.yy * a.zx)));
  const Pack yy = multiply_add(a.xx, a.zz, Pack(-(a.xz * a.zx)));
  const Pack zz = multiply_add(a.xx, a.yy, Pack(-(a.xy * a.yx)));
  return {a.xx + (a.yy + a.zz), xx + (yy + zz),
          multiply_add(a.xx, xx, multiply_add(a.xy, yx, Pack(a.xz * zx)))};
}

/// Volume at the end of the step over that at its beginning, less 1: det (I + A/2) / det (I - A/2) - 1. Exact
/// where the motion of the step is linear in time and space.
template <class Pack>
CRUMPLE_INLINE Pack volume_growth(const Turn<Pack>& gradient) {
  using Real = RealOf<Pack>;
  const Invariants<Pack> a = invariants(gradient);
  const Pack change = multiply_add(Pack(Real(0.25)), a.determinant, a.trace);
  Pack begin = multiply_add(Pack(Real(0.25)), a.second, Pack(Real(1)));
  begin = begin - multiply_add(Pack(Real(0.125)), a.determinant, Pack(Real(0.5) * a.trace));
  return change / begin;
}

template <class Pack>
CRUMPLE_INLINE Turn<Pack> product(const Turn<Pack>& a, const Turn<Pack>& b) {
  const auto dot = [](const Pack& x, const Pack& y, const Pack& z, const Pack& u, const Pack& v,
                      const Pack& w) { return multiply_add(x, u, multiply_add(y, v, Pack(z * w))); };
  return {dot(a.xx, a.xy, a.xz, b.xx, b.yx, b.zx), dot(a.xx, a.xy, a.xz, b.xy, b.yy, b.zy),
          dot(a.xx, a.xy, a.xz, b.xz, b.yz, b.zz), dot(a.yx, a.yy, a.yz, b.xx, b.yx, b.zx),
          dot(a.yx, a.yy, a.yz, b.xy, b.yy, b.zy), dot(a.yx, a.yy, a.yz, b.xz, b.yz, b.zz),
          dot(a.zx, a.zy, a.zz, b.xx, b.yx, b.zx), dot(a.zx, a.zy, a.zz, b.xy, b.yy, b.zy),
          dot(a.zx, a.zy, a.zz, b.xz, b.yz, b.zz)};
}

/// Deformation gradient of the step less the unit matrix, (I - A/2)^-1 A, by the adjugate.
template <class Pack>
CRUMPLE_INLINE Turn<Pack> step_deformation(const Turn<Pack>& a) {
  using Real = RealOf<Pack>;
  const Pack half(Real(0.5));
  const Pack one(Real(1));
  const Pack xx = one - half * a.xx;
  const Pack yy = one - half * a.yy;
  const Pack zz = one - half * a.zz;
  const Pack xy = -half * a.xy;
  const Pack xz = -half * a.xz;
  const Pack yx = -half * a.yx;
  const Pack yz = -half * a.yz;
  const Pack zx = -half * a.zx;
  const Pack zy = -half * a.zy;
  const auto minor = [](const Pack& p, const Pack& q, const Pack& r, const Pack& s) {
    return multiply_add(p, q, Pack(-(r * s)));
  };
  const Turn<Pack> adjugate{minor(yy, zz, yz, zy), minor(xz, zy, xy, zz), minor(xy, yz, xz, yy),
                            minor(yz, zx, yx, zz), minor(xx, zz, xz, zx), minor(xz, yx, xx, yz),
                            minor(yx, zy, yy, zx), minor(xy, zx, xx, zy), minor(xx, yy, xy, yx)};
  const Pack determinant =
      multiply_add(xx, adjugate.xx, multiply_add(xy, adjugate.yx, Pack(xz * adjugate.zx)));
  const Pack over = one / determinant;
  Turn<Pack> f = product(adjugate, a);
  for (Pack* const number : {&f.xx, &f.xy, &f.xz, &f.yx, &f.yy, &f.yz, &f.zx, &f.zy, &f.zz})
    *number = over * *number;
  return f;
}

/// Deformation gradient F less the unit matrix: nine numbers at rows of `stride`, and nine with what their
/// sums have lost. F becomes (I - A/2)^-1 (I + A/2) F; the rest is returned.
template <class Pack>
CRUMPLE_INLINE Turn<Pack> advance_deformation(RealOf<Pack>* place, RealOf<Pack>* rest, Index stride,
                                              const Turn<Pack>& gradient) {
  const Turn<Pack> step = step_deformation(gradient);
  const Turn<Pack> old = load_turn<Pack>(place, stride);
  const Turn<Pack> more = product(step, old);
  const Pack* const from_unit[] = {&step.xx, &step.xy, &step.xz, &step.yx, &step.yy,
                                   &step.yz, &step.zx, &step.zy, &step.zz};
  const Pack* const from_old[] = {&more.xx, &more.xy, &more.xz, &more.yx, &more.yy,
                                  &more.yz, &more.zx, &more.zy, &more.zz};
  for (int k = 0; k < 9; ++k)
    add_kept(place + k * stride, rest + k * stride, Pack(*from_unit[k] + *from_old[k]));
  return load_turn<Pack>(place, stride);
}

/// -1/4 (new - old stress) : (A^2 - tr A A), of third order in the step: by what the trapezoid of the forces'
/// work at both ends of the step differs from that with the gradient A of its middle.
template <class Pack>
CRUMPLE_INLINE Pack end_work(const SolidStress<Pack>& old, const SolidStress<Pack>& now,
                             const Turn<Pack>& a) {
  using Real = RealOf<Pack>;
  const Pack trace = a.xx + (a.yy + a.zz);
  const Turn<Pack> square = product(a, a);
  const auto less = [&](const Pack& s, const Pack& of) { return s - trace * of; };
  Pack sum = (now.zx - old.zx) * (less(square.zx, a.zx) + less(square.xz, a.xz));
  sum = multiply_add(Pack(now.yz - old.yz), Pack(less(square.yz, a.yz) + less(square.zy, a.zy)), sum);
  sum = multiply_add(Pack(now.xy - old.xy), Pack(less(square.xy, a.xy) + less(square.yx, a.yx)), sum);
  sum = multiply_add(Pack(now.zz - old.zz), less(square.zz, a.zz), sum);
  sum = multiply_add(Pack(now.yy - old.yy), less(square.yy, a.yy), sum);
  sum = multiply_add(Pack(now.xx - old.xx), less(square.xx, a.xx), sum);
  return Real(-0.25) * sum;
}

/// Left Cauchy-Green tensor less the unit matrix, D + D^T + D D^T, of F = I + D.
template <class Pack>
CRUMPLE_INLINE SolidStress<Pack> left_cauchy_green(const Turn<Pack>& d) {
  const auto dot = [](const Pack& x, const Pack& y, const Pack& z, const Pack& u, const Pack& v,
                      const Pack& w) { return multiply_add(x, u, multiply_add(y, v, Pack(z * w))); };
  return {(d.xx + d.xx) + dot(d.xx, d.xy, d.xz, d.xx, d.xy, d.xz),
          (d.yy + d.yy) + dot(d.yx, d.yy, d.yz, d.yx, d.yy, d.yz),
          (d.zz + d.zz) + dot(d.zx, d.zy, d.zz, d.zx, d.zy, d.zz),
          (d.xy + d.yx) + dot(d.xx, d.xy, d.xz, d.yx, d.yy, d.yz),
          (d.yz + d.zy) + dot(d.yx, d.yy, d.yz, d.zx, d.zy, d.zz),
          (d.zx + d.xz) + dot(d.zx, d.zy, d.zz, d.xx, d.xy, d.xz)};
}

/// An upper bound of the largest eigenvalue, exact where the two others are equal: mean + sqrt(2/3)
/// |deviator|.
template <class Pack>
CRUMPLE_INLINE Pack largest_bound(const SolidStress<Pack>& s) {
  using Real = RealOf<Pack>;
  return multiply_add(Pack(Real(2.0 / 3.0)), square_root(equivalent_square(s)), mean_stress(s));
}

}  // namespace crumple::materials
