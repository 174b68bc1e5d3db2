// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/solid_stress.hpp"

namespace crumple::materials {

/// Principal values of a symmetric tensor and, in the columns of `axes`, their directions: s = Q diag(v) Q^T.
template <class Pack>
struct Principal {
  Pack value[3];
  Pack axis[3][3];  ///< [component][which]
};

/// Jacobi's method with a fixed number of sweeps, so that lanes do not depend on each other (C.G.J. Jacobi,
/// J. reine angew. Math. 30 (1846) 51-94; G.H. Golub & C.F. Van Loan, Matrix Computations, section 8.5).
/// Convergence is quadratic: six sweeps leave round-off alone.
template <class Pack>
CRUMPLE_INLINE Principal<Pack> principal(const SolidStress<Pack>& s) {
  using Real = RealOf<Pack>;
  const Pack zero(Real(0));
  const Pack one(Real(1));
  Pack a[3][3] = {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  Principal<Pack> found{{zero, zero, zero}, {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
  constexpr int sweeps = 6;
  constexpr int pairs[3][3] = {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}};
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const auto& [p, q, r] : pairs) {
      const Pack twice = a[p][q] + a[p][q];
      const Pack apart = a[q][q] - a[p][p];
      // tan = 2 a_pq / (d + sign(d) sqrt(d^2 + 4 a_pq^2)): the smaller of both rotations.
      const Pack root = square_root(multiply_add(apart, apart, Pack(twice * twice)));
      const Pack below = select<Pack>(apart < zero, Pack(apart - root), Pack(apart + root));
      const auto turns = absolute(below) > zero;
      const Pack tangent = select<Pack>(turns, Pack(twice / select<Pack>(turns, below, one)), zero);
      const Pack cosine = one / square_root(multiply_add(tangent, tangent, one));
      const Pack sine = tangent * cosine;
      const Pack shift = tangent * a[p][q];
      a[p][p] = a[p][p] - shift;
      a[q][q] = a[q][q] + shift;
      a[p][q] = a[q][p] = select<Pack>(turns, zero, a[p][q]);
      const Pack rp = a[r][p];
      const Pack rq = a[r][q];
      a[r][p] = a[p][r] = cosine * rp - sine * rq;
      a[r][q] = a[q][r] = sine * rp + cosine * rq;
      for (auto& row : found.axis) {
        const Pack at_p = row[p];
        const Pack at_q = row[q];
        row[p] = cosine * at_p - sine * at_q;
        row[q] = sine * at_p + cosine * at_q;
      }
    }
  for (int k = 0; k < 3; ++k) found.value[k] = a[k][k];
  return found;
}

/// The tensor of principal values in the axes of `p`.
template <class Pack>
CRUMPLE_INLINE SolidStress<Pack> in_axes(const Principal<Pack>& p, const Pack (&value)[3]) {
  const auto component = [&](int i, int j) {
    Pack sum = value[0] * (p.axis[i][0] * p.axis[j][0]);
    sum = multiply_add(value[1], Pack(p.axis[i][1] * p.axis[j][1]), sum);
    return multiply_add(value[2], Pack(p.axis[i][2] * p.axis[j][2]), sum);
  };
  return {component(0, 0), component(1, 1), component(2, 2),
          component(0, 1), component(1, 2), component(2, 0)};
}

template <class Pack>
CRUMPLE_INLINE Pack largest_principal(const SolidStress<Pack>& s) {
  const Principal<Pack> p = principal(s);
  return larger(p.value[0], larger(p.value[1], p.value[2]));
}

}  // namespace crumple::materials
