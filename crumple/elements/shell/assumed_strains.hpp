// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The membrane field of Pian & Sumihara (IJNME 20 (1984) 1685-1695) over four nodes and 2 x 2 points, which
// the fully integrated shell and the fully integrated membrane share: docs/theory/fully_integrated.md.

#include "elements/shell/bilinear_shell.hpp"

namespace crumple::elements {

/// Strains (or stresses) in the plane; xy of strains is the engineering shear.
template <class Pack>
struct Tensor2 {
  Pack xx, yy, xy;
};
template <class Pack>
CRUMPLE_INLINE Tensor2<Pack> add_scaled(const Pack& s, const Tensor2<Pack>& a, const Tensor2<Pack>& b) {
  return {multiply_add(s, a.xx, b.xx), multiply_add(s, a.yy, b.yy), multiply_add(s, a.xy, b.xy)};
}
/// Work of stress on strain.
template <class Pack>
CRUMPLE_INLINE Pack work(const Tensor2<Pack>& a, const Tensor2<Pack>& b) {
  return multiply_add(a.xx, b.xx, multiply_add(a.yy, b.yy, Pack(a.xy * b.xy)));
}

/// The two strain fields that vary over the element. Pian and Sumihara's stresses are constant but for
/// tension along x_xi that varies with eta, and along x_eta with xi; here stand the strains of these
/// stresses, of unit size, and the inverse of their compliance, by which the nodes' motion becomes their
/// amplitudes.
template <class Pack>
struct AssumedStrains {
  Tensor2<Pack> along_xi, along_eta;
  Tangential<Pack> pull_xi, pull_eta;  ///< x_xi and x_eta over the squares of their lengths
  Pack inverse_xi_xi, inverse_xi_eta, inverse_eta_eta;
};

/// Strain of the unit tension along a direction t, Hooke's law with Young's modulus 1.
template <class Pack>
CRUMPLE_INLINE Tensor2<Pack> strain_of_tension(const Tangential<Pack>& t, const Tangential<Pack>& pull,
                                               RealOf<Pack> poissons_ratio) {
  using Real = RealOf<Pack>;
  const Pack ratio(poissons_ratio);
  const Pack xx = t.x * pull.x;
  const Pack yy = t.y * pull.y;
  return {xx - ratio * yy, yy - ratio * xx, Pack(Real(2) * (Real(1) + poissons_ratio)) * (t.x * pull.y)};
}

template <class Pack>
CRUMPLE_INLINE AssumedStrains<Pack> assumed_strains(const BilinearSurface<Pack>& s,
                                                    RealOf<Pack> poissons_ratio) {
  using Real = RealOf<Pack>;
  const Pack one(Real(1));
  const Tangential<Pack> t_xi{s.xi.x, s.xi.y};
  const Tangential<Pack> t_eta{s.eta.x, s.eta.y};
  const Pack over_xi = one / dot(t_xi, t_xi);
  const Pack over_eta = one / dot(t_eta, t_eta);
  AssumedStrains<Pack> a;
  a.pull_xi = {over_xi * t_xi.x, over_xi * t_xi.y};
  a.pull_eta = {over_eta * t_eta.x, over_eta * t_eta.y};
  a.along_xi = strain_of_tension<Pack>(t_xi, a.pull_xi, poissons_ratio);
  a.along_eta = strain_of_tension<Pack>(t_eta, a.pull_eta, poissons_ratio);
  // Means of (eta - mean)^2, (xi - mean)^2 and their product over the area, times three.
  const Pack third(Real(1) / Real(3));
  const Pack eta_eta = multiply_add(Pack(-third * s.taper_eta), s.taper_eta, one);
  const Pack xi_xi = multiply_add(Pack(-third * s.taper_xi), s.taper_xi, one);
  const Pack xi_eta = -(third * (s.taper_xi * s.taper_eta));
  const Pack cosine2 = dot(t_xi, a.pull_eta) * dot(t_eta, a.pull_xi);
  const Pack mixed = xi_eta * multiply_add(Pack(Real(1) + poissons_ratio), cosine2, Pack(-poissons_ratio));
  const Pack over = one / multiply_add(eta_eta, xi_xi, Pack(-(mixed * mixed)));
  a.inverse_xi_xi = over * xi_xi;
  a.inverse_xi_eta = -(over * mixed);
  a.inverse_eta_eta = over * eta_eta;
  return a;
}

/// A strain field over the element: that of the centre and two amplitudes.
template <class Pack>
struct StrainField {
  Tensor2<Pack> centre;
  Pack along_xi, along_eta;
};

/// From the gradient of a bilinear field at the centre and its hourglass part.
template <class Pack>
CRUMPLE_INLINE StrainField<Pack> strain_field(const AssumedStrains<Pack>& a, const Tensor2<Pack>& centre,
                                              const Tangential<Pack>& hourglass) {
  const Pack on_xi = dot(a.pull_xi, hourglass);
  const Pack on_eta = dot(a.pull_eta, hourglass);
  return {centre, multiply_add(a.inverse_xi_xi, on_xi, Pack(a.inverse_xi_eta * on_eta)),
          multiply_add(a.inverse_xi_eta, on_xi, Pack(a.inverse_eta_eta * on_eta))};
}
/// The force on the hourglass part of the motion.
template <class Pack>
CRUMPLE_INLINE Tangential<Pack> hourglass_force(const AssumedStrains<Pack>& a, const Pack& on_xi,
                                                const Pack& on_eta) {
  const Pack pull = multiply_add(a.inverse_xi_xi, on_xi, Pack(a.inverse_xi_eta * on_eta));
  const Pack push = multiply_add(a.inverse_xi_eta, on_xi, Pack(a.inverse_eta_eta * on_eta));
  return {multiply_add(pull, a.pull_xi.x, Pack(push * a.pull_eta.x)),
          multiply_add(pull, a.pull_xi.y, Pack(push * a.pull_eta.y))};
}

/// One of the 2 x 2 points.
template <class Pack>
struct PlanePoint {
  Pack xi, eta;                          ///< coordinates less their means over the area
  Pack area;                             ///< that the point stands for
  Tangential<Pack> along_xi, along_eta;  ///< tangents
  RealOf<Pack> place_xi, place_eta;
};
template <class Pack>
CRUMPLE_INLINE PlanePoint<Pack> plane_point(const BilinearSurface<Pack>& s, int plane) {
  using Real = RealOf<Pack>;
  PlanePoint<Pack> p;
  p.place_xi = static_cast<Real>(sign_xi[plane]) * gauss_place<Real>;
  p.place_eta = static_cast<Real>(sign_eta[plane]) * gauss_place<Real>;
  const Pack xi(p.place_xi);
  const Pack eta(p.place_eta);
  const Pack third(Real(1) / Real(3));
  p.xi = xi - third * s.taper_xi;
  p.eta = eta - third * s.taper_eta;
  p.area = s.jacobian * multiply_add(s.taper_xi, xi, multiply_add(s.taper_eta, eta, Pack(Real(1))));
  p.along_xi = {multiply_add(eta, s.twist.x, s.xi.x), multiply_add(eta, s.twist.y, s.xi.y)};
  p.along_eta = {multiply_add(xi, s.twist.x, s.eta.x), multiply_add(xi, s.twist.y, s.eta.y)};
  return p;
}

/// Gradient at the centre of a bilinear field, from its xi and eta.
template <class Pack>
CRUMPLE_INLINE Tangential<Pack> centre_gradient(const BilinearSurface<Pack>& s, const Pack& f_xi,
                                                const Pack& f_eta) {
  return {multiply_add(s.grad_xi.x, f_xi, Pack(s.grad_eta.x * f_eta)),
          multiply_add(s.grad_xi.y, f_xi, Pack(s.grad_eta.y * f_eta))};
}

template <class Pack>
CRUMPLE_INLINE Tensor2<Pack> strain_at(const StrainField<Pack>& f, const AssumedStrains<Pack>& a,
                                       const PlanePoint<Pack>& point) {
  return add_scaled(Pack(point.eta * f.along_xi), a.along_xi,
                    add_scaled(Pack(point.xi * f.along_eta), a.along_eta, f.centre));
}

/// Stresses integrated over the element, each against what it does work on.
template <class Pack>
struct FieldForces {
  Tensor2<Pack> centre;
  Pack along_xi, along_eta;
};
template <class Pack>
CRUMPLE_INLINE void add(FieldForces<Pack>& sum, const AssumedStrains<Pack>& a, const PlanePoint<Pack>& point,
                        const Tensor2<Pack>& stress, const Pack& share) {
  const Pack area = share * point.area;
  sum.centre = add_scaled(area, stress, sum.centre);
  sum.along_xi = multiply_add(Pack(area * point.eta), work(a.along_xi, stress), sum.along_xi);
  sum.along_eta = multiply_add(Pack(area * point.xi), work(a.along_eta, stress), sum.along_eta);
}

/// What does work on the gradients at the centre, f_xi and f_eta, of one component.
template <class Pack>
CRUMPLE_INLINE Tangential<Pack> on_gradient(const BilinearSurface<Pack>& s, const Pack& x, const Pack& y) {
  return {multiply_add(s.grad_xi.x, x, Pack(s.grad_xi.y * y)),
          multiply_add(s.grad_eta.x, x, Pack(s.grad_eta.y * y))};
}

}  // namespace crumple::elements
