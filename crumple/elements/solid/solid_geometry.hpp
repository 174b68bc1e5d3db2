// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/solid/solid_formulation.hpp"
#include "elements/solid/solid_patterns.hpp"

namespace crumple::elements {

/// Volume of a hexahedron and its derivatives by the patterns of the positions, which are sums over the
/// nodes. Over the volume they are the gradient operator: grad f = sum of f_p gradient_p / volume.
template <class Pack>
struct SolidGeometry {
  math::PackVec3<Pack> gradient[6];  ///< for the patterns up to xi eta; the volume does not know the last
  Pack volume;
};

/// Patterns whose gradient is not zero: at the centre only those of the tangents have one.
CRUMPLE_INLINE constexpr int patterns_of_gradient(bool exact_volume) {
  return exact_volume ? 6 : 3;
}

/// With `exact_volume` the trilinear volume, whose derivatives are the mean gradient over the element
/// (Flanagan & Belytschko, IJNME 17 (1981) 679-706); else eight times the Jacobian at the centre.
/// docs/theory/one_point_hexahedron.md.
template <class Pack>
CRUMPLE_INLINE SolidGeometry<Pack> solid_geometry(const SolidPatterns<Pack>& x, bool exact_volume) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  using math::cross;
  const Vec& xi = x.of[pattern::xi];
  const Vec& eta = x.of[pattern::eta];
  const Vec& zeta = x.of[pattern::zeta];
  const Pack share(Real(1.0 / 64));  // eight times that of the coefficients, 8 det, over 8^3
  const Pack zero(Real(0));
  SolidGeometry<Pack> g;
  g.gradient[pattern::xi] = share * cross(eta, zeta);
  g.gradient[pattern::eta] = share * cross(zeta, xi);
  g.gradient[pattern::zeta] = share * cross(xi, eta);
  for (int p = pattern::hourglass; p < 6; ++p) g.gradient[p] = {zero, zero, zero};
  g.volume = math::dot(xi, g.gradient[pattern::xi]);
  if (!exact_volume) return g;
  const Vec& h1 = x.of[pattern::eta_zeta];
  const Vec& h2 = x.of[pattern::xi_zeta];
  const Vec& h3 = x.of[pattern::xi_eta];
  const Pack third(Real(1.0 / 192));
  const auto add = [&](int p, const Vec& more) {
    g.gradient[p] = math::multiply_add(third, more, g.gradient[p]);
  };
  add(pattern::xi, cross(h3, h2));
  add(pattern::eta, cross(h1, h3));
  add(pattern::zeta, cross(h2, h1));
  add(pattern::eta_zeta, cross(h3, eta) + cross(zeta, h2));
  add(pattern::xi_zeta, cross(xi, h3) + cross(h1, zeta));
  add(pattern::xi_eta, cross(h2, xi) + cross(eta, h1));
  // The volume is of the third degree in the positions.
  Pack thrice = zero;
  for (int p = 0; p < 6; ++p) thrice = thrice + math::dot(x.of[p], g.gradient[p]);
  g.volume = Pack(Real(1.0 / 3.0)) * thrice;
  return g;
}

/// Gradient of a velocity field, the mean over the volume or that at the centre: row i holds the derivatives
/// of component i.
template <class Pack>
CRUMPLE_INLINE PackMatrix<Pack> velocity_gradient(const SolidGeometry<Pack>& g, const SolidPatterns<Pack>& v,
                                                  bool exact_volume) {
  using math::multiply_add;
  const auto row = [&](auto component) {
    auto sum = component(v.of[0]) * g.gradient[0];
    for (int p = 1; p < 3; ++p) sum = multiply_add(component(v.of[p]), g.gradient[p], sum);
    if (exact_volume)
      for (int p = 3; p < 6; ++p) sum = multiply_add(component(v.of[p]), g.gradient[p], sum);
    return sum;
  };
  const Pack per_volume = Pack(RealOf<Pack>(1)) / g.volume;
  return {per_volume * row([](const auto& u) { return u.x; }),
          per_volume * row([](const auto& u) { return u.y; }),
          per_volume * row([](const auto& u) { return u.z; })};
}

/// Square of the largest area of a face, by its diagonals.
template <class Pack>
CRUMPLE_INLINE Pack largest_face_squared(const SolidPatterns<Pack>& x) {
  using Vec = math::PackVec3<Pack>;
  Pack largest(RealOf<Pack>(0));
  // The two faces across `u` and `v`: tangents at their centres.
  const auto pair = [&](const Vec& u, const Vec& u_change, const Vec& v, const Vec& v_change) {
    const Vec one = math::cross(u + u_change, v + v_change);
    const Vec other = math::cross(u - u_change, v - v_change);
    largest = larger(largest, larger(math::dot(one, one), math::dot(other, other)));
  };
  using namespace pattern;
  pair(x.of[xi], x.of[xi_zeta], x.of[eta], x.of[eta_zeta]);
  pair(x.of[xi], x.of[xi_eta], x.of[zeta], x.of[eta_zeta]);
  pair(x.of[eta], x.of[xi_eta], x.of[zeta], x.of[xi_zeta]);
  return Pack(RealOf<Pack>(1.0 / 256)) * largest;
}

/// l of the stable step l / c of a free hexahedron: 2 / omega of its uniform strain with an eighth of the
/// mass at each node, c that of longitudinal waves. With the pattern gradients g_p over the volume, omega^2
/// is at most 64 c^2 (sum g_p.g_p - shear_share (sum g_p.g_p - m)), m the largest eigenvalue of g_p.g_q, here
/// by Gershgorin's circles; `shear_share` = 2 mu / (lambda + 2 mu). docs/theory/one_point_hexahedron.md.
template <class Pack>
CRUMPLE_INLINE Pack free_length(const SolidGeometry<Pack>& g, int patterns, const Pack& shear_share) {
  const auto& of = g.gradient;
  const Pack one_two = absolute(math::dot(of[0], of[1]));
  const Pack two_three = absolute(math::dot(of[1], of[2]));
  const Pack three_one = absolute(math::dot(of[2], of[0]));
  const Pack square[3] = {math::dot(of[0], of[0]), math::dot(of[1], of[1]), math::dot(of[2], of[2])};
  Pack rest(RealOf<Pack>(0));
  for (int p = 3; p < patterns; ++p) rest = rest + math::dot(of[p], of[p]);
  const Pack sum = square[0] + (square[1] + (square[2] + rest));
  const Pack largest = rest + larger(Pack(square[0] + (one_two + three_one)),
                                     larger(Pack(square[1] + (one_two + two_three)),
                                            Pack(square[2] + (two_three + three_one))));
  // The circles may be larger than the sum of all eigenvalues.
  const Pack others = larger(Pack(RealOf<Pack>(0)), Pack(sum - largest));
  return Pack(RealOf<Pack>(0.25)) * g.volume / square_root(Pack(sum - shear_share * others));
}

}  // namespace crumple::elements
