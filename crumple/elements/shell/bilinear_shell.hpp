// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/formulation.hpp"

// What the shells with 2 x 2 points in plane share: a four-node surface whose nodes carry fibres, written in
// the coordinates xi, eta of -1..1 instead of node by node. docs/theory/fully_integrated.md.
namespace crumple::elements {

/// A nodal field f = mean + xi f_xi + eta f_eta + xi eta f_twist, in lamina axes.
template <class Pack>
struct Bilinear {
  using Vec = math::PackVec3<Pack>;
  Vec mean, xi, eta, twist;
};

/// Two components in the plane of the lamina.
template <class Pack>
struct Tangential {
  Pack x, y;
};
template <class Pack>
CRUMPLE_INLINE Pack dot(const Tangential<Pack>& a, const Tangential<Pack>& b) {
  return multiply_add(a.x, b.x, Pack(a.y * b.y));
}

/// A vector's components along the axes.
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> along_axes(const LaminaFrame<Pack>& frame,
                                               const math::PackVec3<Pack>& v) {
  return {math::dot(v, frame.e1), math::dot(v, frame.e2), math::dot(v, frame.e3)};
}
/// The vector that has these components.
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> from_axes(const LaminaFrame<Pack>& frame, const math::PackVec3<Pack>& v) {
  return math::multiply_add(v.x, frame.e1, math::multiply_add(v.y, frame.e2, v.z * frame.e3));
}

/// The field from its differences over the diagonals, hourglass pattern and sum (ShellNodes).
template <class Pack>
CRUMPLE_INLINE Bilinear<Pack> bilinear(const LaminaFrame<Pack>& frame, const math::PackVec3<Pack>& f31,
                                       const math::PackVec3<Pack>& f42, const math::PackVec3<Pack>& f_mode,
                                       const math::PackVec3<Pack>& f_sum) {
  const Pack quarter(RealOf<Pack>(0.25));
  const auto d31 = along_axes(frame, f31);
  const auto d42 = along_axes(frame, f42);
  return {quarter * along_axes(frame, f_sum), quarter * (d31 - d42), quarter * (d31 + d42),
          quarter * along_axes(frame, f_mode)};
}

/// The reference surface: x = xi x_xi + eta x_eta + xi eta x_twist, whose tangents at the centre lie in the
/// lamina, and its fibres y = e3 + xi y_xi + eta y_eta.
template <class Pack>
struct BilinearSurface {
  using Vec = math::PackVec3<Pack>;
  Vec xi, eta, twist;
  Pack jacobian;  ///< at the centre, a quarter of the area
  Pack inverse_jacobian;
  Tangential<Pack> grad_xi;   ///< of xi at the centre [1/length]
  Tangential<Pack> grad_eta;  ///< of eta at the centre [1/length]
  Pack taper_xi;              ///< Jacobian over that of the centre: 1 + taper_xi xi + taper_eta eta
  Pack taper_eta;
  Vec fibre_xi, fibre_eta;  ///< tilts in the plane
};

/// |x_xi|^2 + |x_eta|^2.
template <class Pack>
CRUMPLE_INLINE Pack sum_of_squares(const BilinearSurface<Pack>& s) {
  Pack squares = s.xi.x * s.xi.x;
  squares = multiply_add(s.xi.y, s.xi.y, squares);
  squares = multiply_add(s.eta.x, s.eta.x, squares);
  return multiply_add(s.eta.y, s.eta.y, squares);
}

/// The fibres are the normals of the bilinear surface, scaled to the component 1 along e3, without the
/// element's taper; their tilt per length is held at `most`.
template <class Pack>
CRUMPLE_INLINE void set_fibres(BilinearSurface<Pack>& s, const Pack& most) {
  const Pack zero(RealOf<Pack>(0));
  const Pack slope = larger(Pack(-most), smaller(most, Pack(s.twist.z * s.inverse_jacobian)));
  s.fibre_xi = {slope * s.xi.y, -(slope * s.xi.x), zero};
  s.fibre_eta = {-(slope * s.eta.y), slope * s.eta.x, zero};
}

/// An element warped beyond reason would have fibres of any length: none is tilted by more than 45 degrees.
template <class Pack>
CRUMPLE_INLINE Pack largest_tilt(const BilinearSurface<Pack>& s) {
  const Pack squares = sum_of_squares(s);
  return Pack(RealOf<Pack>(1)) / square_root(Pack(squares + squares));
}

/// From the differences of the positions. The taper of a re-entrant element is held at that of a triangle,
/// so that no point in plane has less than 0.42 of the mean area.
template <class Pack>
CRUMPLE_INLINE BilinearSurface<Pack> bilinear_surface(const ElementShape<Pack>& shape) {
  const LaminaFrame<Pack>& frame = shape.frame;
  using Real = RealOf<Pack>;
  const Pack quarter(Real(0.25));
  const Pack zero(Real(0));
  const Tangential<Pack> d31{math::dot(shape.r31, frame.e1), math::dot(shape.r31, frame.e2)};
  const Tangential<Pack> d42{math::dot(shape.r42, frame.e1), math::dot(shape.r42, frame.e2)};
  BilinearSurface<Pack> s;
  s.xi = {quarter * (d31.x - d42.x), quarter * (d31.y - d42.y), zero};
  s.eta = {quarter * (d31.x + d42.x), quarter * (d31.y + d42.y), zero};
  s.twist = quarter * along_axes(frame, shape.r_mode);
  s.jacobian = multiply_add(s.xi.x, s.eta.y, Pack(-(s.eta.x * s.xi.y)));
  s.inverse_jacobian = Pack(Real(1)) / s.jacobian;
  s.grad_xi = {s.inverse_jacobian * s.eta.y, -(s.inverse_jacobian * s.eta.x)};
  s.grad_eta = {-(s.inverse_jacobian * s.xi.y), s.inverse_jacobian * s.xi.x};
  const Pack along_xi = s.inverse_jacobian * multiply_add(s.xi.x, s.twist.y, Pack(-(s.twist.x * s.xi.y)));
  const Pack along_eta = s.inverse_jacobian * multiply_add(s.twist.x, s.eta.y, Pack(-(s.eta.x * s.twist.y)));
  const Pack sum = larger(Pack(Real(1)), Pack(absolute(along_xi) + absolute(along_eta)));
  s.taper_xi = along_xi / sum;
  s.taper_eta = along_eta / sum;
  set_fibres(s, largest_tilt(s));
  return s;
}

/// Rates w x y of the fibres at the nodes, as a bilinear field.
template <class Pack>
CRUMPLE_INLINE Bilinear<Pack> fibre_rates(const BilinearSurface<Pack>& s, const Bilinear<Pack>& w) {
  const auto turn = [](const math::PackVec3<Pack>& a) {  // a x e3
    return math::PackVec3<Pack>{a.y, -a.x, Pack(RealOf<Pack>(0))};
  };
  // At the nodes xi^2 = eta^2 = 1.
  return {turn(w.mean) + (math::cross(w.xi, s.fibre_xi) + math::cross(w.eta, s.fibre_eta)),
          turn(w.xi) + (math::cross(w.mean, s.fibre_xi) + math::cross(w.twist, s.fibre_eta)),
          turn(w.eta) + (math::cross(w.mean, s.fibre_eta) + math::cross(w.twist, s.fibre_xi)),
          turn(w.twist) + (math::cross(w.xi, s.fibre_eta) + math::cross(w.eta, s.fibre_xi))};
}

/// What does work on the angular velocities when `on_fibre` does on the fibre rates.
template <class Pack>
CRUMPLE_INLINE Bilinear<Pack> fibre_moments(const BilinearSurface<Pack>& s, const Bilinear<Pack>& on_fibre) {
  const auto turn = [](const math::PackVec3<Pack>& a) {  // e3 x a
    return math::PackVec3<Pack>{-a.y, a.x, Pack(RealOf<Pack>(0))};
  };
  const auto& p = on_fibre;
  return {turn(p.mean) + (math::cross(s.fibre_xi, p.xi) + math::cross(s.fibre_eta, p.eta)),
          turn(p.xi) + (math::cross(s.fibre_xi, p.mean) + math::cross(s.fibre_eta, p.twist)),
          turn(p.eta) + (math::cross(s.fibre_eta, p.mean) + math::cross(s.fibre_xi, p.twist)),
          turn(p.twist) + (math::cross(s.fibre_eta, p.xi) + math::cross(s.fibre_xi, p.eta))};
}

/// Vectors at the four nodes, in space, that do the same work as those on the coefficients of the field.
template <class Pack>
CRUMPLE_INLINE void to_nodes(const LaminaFrame<Pack>& frame, const Bilinear<Pack>& on,
                             math::PackVec3<Pack> (&node)[4]) {
  const Pack quarter(RealOf<Pack>(0.25));
  const auto plus_xi = quarter * (on.mean + on.xi);
  const auto minus_xi = quarter * (on.mean - on.xi);
  const auto plus_eta = quarter * (on.eta + on.twist);
  const auto minus_eta = quarter * (on.eta - on.twist);
  node[0] = from_axes(frame, minus_xi - minus_eta);
  node[1] = from_axes(frame, plus_xi - plus_eta);
  node[2] = from_axes(frame, plus_xi + plus_eta);
  node[3] = from_axes(frame, minus_xi + minus_eta);
}

/// Brings the drilling stresses in the state up to date, against what differs over the element of the nodes'
/// rotation about the normal, and leaves the energy for the driver. Where fibres of neighbours differ by
/// ever so little, free drilling rotations would open hinges between them. x, y and bending_x of the modes
/// hold xi, eta and twist of the drilling; `warping` is a new stress of the caller's, for z.
template <class Pack>
CRUMPLE_INLINE HourglassModes<Pack> update_drilling(const ShellPlace<RealOf<Pack>>& place,
                                                    const Pack& thickness, const HourglassModes<Pack>& rate,
                                                    const Pack& warping) {
  using Real = RealOf<Pack>;
  const Pack step(place.task.step);
  const Pack modulus = Pack(place.task.constants.hourglass_membrane) * (thickness * (thickness * thickness));
  const Pack stiffness = step * modulus;
  const HourglassModes<Pack> old = hourglass_state<Pack>(place);
  HourglassModes<Pack> now{multiply_add(stiffness, rate.x, old.x), multiply_add(stiffness, rate.y, old.y),
                           warping, multiply_add(stiffness, rate.bending_x, old.bending_x), Pack(Real(0))};
  if (place.task.constants.can_fail) now = scaled(now, own_state<Pack>(place, element_state::active));
  set_hourglass_state(place, now);
  store(place.rows + scratch_row::hourglass_energy * tile_lanes, hourglass_work(step, old, now, rate));
  return now;
}

/// Adds the drilling moments to those on the coefficients of the angular velocities.
template <class Pack>
CRUMPLE_INLINE Bilinear<Pack> with_drilling(const Bilinear<Pack>& moments, const HourglassModes<Pack>& q) {
  Bilinear<Pack> sum = moments;
  sum.xi.z = sum.xi.z + q.x;
  sum.eta.z = sum.eta.z + q.y;
  sum.twist.z = sum.twist.z + q.bending_x;
  return sum;
}

/// The 2 x 2 points: xi and eta are sign / sqrt(3); order as the nodes.
template <class Real>
inline constexpr Real gauss_place = static_cast<Real>(0.57735026918962576);
inline constexpr int sign_xi[4] = {-1, 1, 1, -1};
inline constexpr int sign_eta[4] = {-1, -1, 1, 1};

}  // namespace crumple::elements
