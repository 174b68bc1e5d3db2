// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/plasticity/principal.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Constants of the yield surface, the first of those of CapConcreteLaw. Strength and both ratios are
/// constant
/// - nonlinear exp(-exponent I) + linear I, four numbers each.
enum CapSurfacePlace {
  CapCompression,
  CapTorsion = CapCompression + 4,
  CapExtension = CapTorsion + 4,
  CapRatio = CapExtension + 4,
  CapStart,       ///< X0
  CapFirst,       ///< kappa_0, where the cap starts before any crush
  CapVolume,      ///< W
  CapLinear,      ///< D1
  CapQuadratic,   ///< D2
  CapApex,        ///< I, below zero, at which the strength ends
  CapTripleBulk,  ///< 3 K
  CapStiffness,   ///< 9 K / G
  CapSurfaceCount
};

/// The angle of a stress in the deviatoric plane: 30 degrees in triaxial compression, 0 in torsion, -30 in
/// triaxial extension.
template <class Pack>
struct LodeAngle {
  Pack sine, cosine;
};

/// A deviator's angle from its principal values, without a function of the angle: the middle one is 2/sqrt(3)
/// sqrt(J2) sin(angle).
template <class Pack>
LodeAngle<Pack> lode_angle(const SolidStress<Pack>& deviator, const Pack& size) {
  using Real = RealOf<Pack>;
  const Principal<Pack> p = principal(deviator);
  const Pack least = smaller(p.value[0], smaller(p.value[1], p.value[2]));
  const Pack most = larger(p.value[0], larger(p.value[1], p.value[2]));
  const Pack half(Real(0.5));
  const Pack none(Real(sizeof(Real) == sizeof(float) ? 1e-30 : 1e-200));
  const Pack sine = Pack(Real(-0.86602540378443865)) * (least + most) / larger(size, none);
  const Pack bounded = smaller(larger(sine, Pack(-half)), half);
  return {bounded, square_root(multiply_add(Pack(-bounded), bounded, Pack(Real(1))))};
}

/// The smooth cap model's yield surface with three invariants (docs/theory/cscm_concrete.md). I is the
/// negative trace of the stress and q the root of J2; I is in the role of a pressure, three times as large.
template <class Pack>
struct CapSurface {
  using Real = RealOf<Pack>;
  using Mask = MaskOf<Pack>;

  const double* c;

  CRUMPLE_INLINE Pack number(int place) const { return Pack(static_cast<Real>(c[place])); }
  CRUMPLE_INLINE static Pack exponential(const Pack& x) {
    return math::power_of_two(Pack(Pack(Real(1.4426950408889634)) * x));
  }

  struct Curve {
    Pack value, slope;
  };
  CRUMPLE_INLINE Curve curve(int place, const Pack& trace) const {
    const Pack fall = number(place + 2) * exponential(Pack(-(number(place + 3) * trace)));
    return {multiply_add(number(place + 1), trace, Pack(number(place) - fall)),
            multiply_add(number(place + 3), fall, number(place + 1))};
  }
  /// X, where the cap that starts at `cap` ends on the axis of pressure.
  CRUMPLE_INLINE Pack end_of(const Pack& cap) const {
    return multiply_add(number(CapRatio), curve(CapCompression, cap).value, cap);
  }
  /// What is left of the crush volume, over W, when the cap ends at X: exp(-D1 x - D2 x^2), x = X - X0.
  CRUMPLE_INLINE Pack pores(const Pack& end) const {
    const Pack x = larger(Pack(end - number(CapStart)), Pack(Real(0)));
    return exponential(Pack(-(multiply_add(number(CapQuadratic), x, number(CapLinear)) * x)));
  }

  /// Strength at an angle over that in triaxial compression (M.B. Rubin, IJSS 27 (1991) 1519-1545); in
  /// tension the surface is a triangle.
  Pack ratio(const Pack& trace, const LodeAngle<Pack>& angle) const {
    const Pack one(Real(1));
    const Pack two(Real(2));
    const Pack root3(Real(1.7320508075688773));
    const Pack lowest1(Real(0.57735026918962573));
    const Pack lowest2(Real(0.5));
    const Mask pressed = trace > Pack(Real(0));
    const auto bounded = [&](int place, const Pack& lowest) {
      return select<Pack>(pressed, smaller(larger(curve(place, trace).value, lowest), one), lowest);
    };
    const Pack q1 = bounded(CapTorsion, lowest1);
    const Pack q2 = bounded(CapExtension, lowest2);
    const Pack missing = one - q2;
    const Pack a1 = root3 * q2 - two * (q1 * missing);
    const Pack a0 = Pack(Real(8)) * (q1 * q1) * (missing * q2);
    const Pack a = Pack(Real(0.5)) * (square_root(multiply_add(a1, a1, a0)) - a1) / q2;
    const Pack sum = two * q1 + a;
    const Pack b = multiply_add(sum, sum, Pack(Real(-3)));
    const Pack side = angle.cosine - a * angle.sine;
    const Pack b2 = multiply_add(side, side, Pack(b * (angle.sine * angle.sine)));
    const Pack b1 = a * side;
    const Pack b0 = q1 * (q1 + a);
    const Pack disc = multiply_add(b1, b1, Pack(Pack(Real(4)) * (b2 * b0)));
    return two * b0 / (b1 + square_root(larger(disc, Pack(Real(0)))));
  }

  /// The elastic trial: I, q, where the cap starts, and the ratio at the stress's angle.
  struct Trial {
    Pack trace, size, cap, ratio;
  };
  /// The bound of q, and its derivative by I times `root`, which stays finite at the end of the cap.
  struct Bound {
    Pack value, root, rooted_slope, end;
  };
  // Not inline, as all that is called several times here: the compiler would take a minute over it.
  Bound bound(const Pack& trace, const Pack& cap, const Pack& ratio) const {
    const Pack zero(Real(0));
    const Curve strength = curve(CapCompression, trace);
    const Pack end = end_of(cap);
    const Pack span = end - cap;
    const Pack part = larger(Pack(trace - cap), zero) / span;
    const Pack square = larger(multiply_add(Pack(-part), part, Pack(Real(1))), zero);
    const Pack root = square_root(square);
    const Pack size = ratio * larger(strength.value, zero);
    return {size * root, root, multiply_add(ratio * strength.slope, square, Pack(-(size * (part / span)))),
            end};
  }
  /// Outside of the surface, its two ends on the axis included.
  CRUMPLE_INLINE Mask exceeds(const Trial& t, const Bound& at) const {
    return (t.size > at.value) || (t.trace > at.end) || (t.trace < number(CapApex));
  }

  /// Where the return ends: on the surface, with the cap where crush has pushed it.
  struct Return {
    Pack trace, size, cap;
    Mask dilates;  ///< flows with growing volume: on the failure surface
  };

  /// Flow normal to the surface in I and q, at a constant angle: dI = -9 K l dF/dI, dq = -G l. Where it
  /// dilates, the unknown is I and the cap stays; where it crushes, the unknown is the cap, whose plastic
  /// volume gives I. The residual rises through zero between both ends of the bracket.
  struct Residual {
    Pack value, trace, size, root;
  };
  Residual residual(const Trial& t, const Mask& crushes, const Pack& old_pores, const Pack& unknown) const {
    const Pack zero(Real(0));
    const Pack cap = select<Pack>(crushes, unknown, t.cap);
    const Pack crushed = number(CapVolume) * (old_pores - pores(end_of(cap)));
    const Pack pushed = larger(Pack(t.trace - number(CapTripleBulk) * crushed), number(CapApex));
    const Pack trace = select<Pack>(crushes, pushed, unknown);
    const Bound at = bound(trace, cap, t.ratio);
    const Pack excess = larger(Pack(t.size - at.value), zero);
    const Pack pull = number(CapStiffness) * (excess * at.rooted_slope);
    const Pack value =
        multiply_add(Pack(trace - t.trace), at.root, Pack(larger(Pack(trace - at.end), zero) - pull));
    return {select<Pack>(crushes, Pack(-value), value), trace, smaller(t.size, at.value), at.root};
  }

  /// Regula falsi, after Illinois, with a bisection now and then. A lane that has converged is left alone.
  Return returned(const Trial& t, const Mask& mask, const Bound& at) const {
    constexpr bool single = sizeof(Real) == sizeof(float);
    constexpr int most_iterations = 90;
    const Pack half(Real(0.5));
    const Pack zero(Real(0));
    const Pack apex = number(CapApex);
    const Mask crushes = (t.trace >= at.end) || ((t.trace > apex) && (at.rooted_slope < zero));
    const Pack old_pores = pores(at.end);
    Pack low = select<Pack>(crushes, t.cap, larger(t.trace, apex));
    Pack high = select<Pack>(crushes, larger(t.trace, t.cap), at.end);
    Residual first = residual(t, crushes, old_pores, low);
    Pack below = first.value;
    Pack above = residual(t, crushes, old_pores, high).value;
    const Pack noise = Pack(single ? Real(1.2e-7) : Real(4e-16)) *
                       ((absolute(t.trace) + t.size) + curve(CapCompression, larger(t.trace, zero)).value);
    // Of the excess at first, or slow loading would drift by what is left of each step.
    const Pack enough = Pack(single ? Real(-1e-5) : Real(-1e-11)) * below;
    Return found{first.trace, first.size, select<Pack>(crushes, low, t.cap), !crushes};
    Mask open = mask && (below < zero);
    Pack last = zero;
    for (int i = 0; i < most_iterations && any<Pack>(open); ++i) {
      const Pack rise = above - below;
      const Pack share = i % 4 == 3 ? half : Pack(-below / select<Pack>(rise > zero, rise, Pack(Real(1))));
      const Pack unknown = multiply_add(share, Pack(high - low), low);
      const Residual now = residual(t, crushes, old_pores, unknown);
      found.trace = select<Pack>(open, now.trace, found.trace);
      found.size = select<Pack>(open, now.size, found.size);
      found.cap = select<Pack>(open && crushes, unknown, found.cap);
      const Mask under = now.value < zero;
      // The end that stays a second time counts half.
      const Pack side = select<Pack>(under, Pack(Real(-1)), Pack(Real(1)));
      const Mask again = side == last;
      above = select<Pack>(under, select<Pack>(again, Pack(half * above), above), now.value);
      below = select<Pack>(under, now.value, select<Pack>(again, Pack(half * below), below));
      low = select<Pack>(under, unknown, low);
      high = select<Pack>(under, high, unknown);
      last = side;
      const Pack tolerance = multiply_add(noise, now.root, enough);
      open = open && (absolute(now.value) > tolerance) && (high - low > noise);
    }
    return found;
  }
};

}  // namespace crumple::materials
