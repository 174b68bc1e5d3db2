// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/pack.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Stresses in the plane of a sheet along its axes, or strains with the engineering shear.
template <class Pack>
struct SheetPlane {
  Pack x, y, s;
};

/// A symmetric matrix over these.
template <class Pack>
struct SheetMatrix {
  Pack xx, yy, ss, xy, ys, sx;

  CRUMPLE_INLINE SheetPlane<Pack> times(const SheetPlane<Pack>& v) const {
    const auto dot = [](const Pack& a, const Pack& b, const Pack& c, const SheetPlane<Pack>& of) {
      return multiply_add(a, of.x, multiply_add(b, of.y, Pack(c * of.s)));
    };
    return {dot(xx, xy, sx, v), dot(xy, yy, ys, v), dot(sx, ys, ss, v)};
  }
  CRUMPLE_INLINE SheetMatrix inverse() const {
    const auto minor = [](const Pack& p, const Pack& q, const Pack& r, const Pack& t) {
      return multiply_add(p, q, Pack(-(r * t)));
    };
    const SheetMatrix a{minor(yy, ss, ys, ys), minor(xx, ss, sx, sx), minor(xx, yy, xy, xy),
                        minor(sx, ys, xy, ss), minor(xy, sx, xx, ys), minor(xy, ys, yy, sx)};
    const Pack over = Pack(RealOf<Pack>(1)) / multiply_add(xx, a.xx, multiply_add(xy, a.xy, Pack(sx * a.sx)));
    return {over * a.xx, over * a.yy, over * a.ss, over * a.xy, over * a.ys, over * a.sx};
  }
};

template <class Pack>
CRUMPLE_INLINE Pack dot(const SheetPlane<Pack>& a, const SheetPlane<Pack>& b) {
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, Pack(a.s * b.s)));
}

/// The criterion of F. Barlat & J. Lian, Int. J. Plasticity 5 (1989) 51-66: of the stresses u = x, v = h y, w
/// = p s, K1 = (u + v) / 2 and K2 = |((u - v) / 2, w)|,
///   2 Y^m = a |K1 + K2|^m + a |K1 - K2|^m + c |2 K2|^m.
template <class Pack>
struct BarlatYield {
  using Real = RealOf<Pack>;
  using Plane = SheetPlane<Pack>;

  Real a, c, h, p, m;

  CRUMPLE_INLINE BarlatYield(double first, double second, double across, double shear, double exponent)
      : a(static_cast<Real>(first)),
        c(static_cast<Real>(second)),
        h(static_cast<Real>(across)),
        p(static_cast<Real>(shear)),
        m(static_cast<Real>(exponent)) {}

  /// The equivalent stress, which is of first degree in the stresses, its gradient and second derivatives.
  struct Value {
    Pack size;
    Plane normal;
    SheetMatrix<Pack> curvature;
  };

  /// |x|^(m - 2); never zero, or a derivative would be a quotient of zeros.
  CRUMPLE_INLINE Pack lowered(const Pack& x) const {
    const Pack tiny(sizeof(Real) == sizeof(float) ? Real(1e-4) : Real(1e-12));
    return math::power(larger(absolute(x), tiny), Pack(m - Real(2)));
  }

  /// K1 and K2 over a size of the stress, so that powers neither overflow nor vanish.
  struct Parts {
    Pack size, mean, apart, shear, radius;
  };
  CRUMPLE_INLINE Parts parts(const Plane& stress) const {
    const Pack half(Real(0.5));
    const Pack tiny(sizeof(Real) == sizeof(float) ? Real(1e-30) : Real(1e-200));
    const Pack across = Pack(h) * stress.y;
    const Pack mean = half * (stress.x + across);
    const Pack apart = half * (stress.x - across);
    const Pack shear = Pack(p) * stress.s;
    const Pack size = larger(absolute(mean) + larger(absolute(apart), absolute(shear)), tiny);
    const Pack over = Pack(Real(1)) / size;
    const Pack d = over * apart;
    const Pack w = over * shear;
    return {size, over * mean, d, w, square_root(multiply_add(d, d, Pack(w * w)))};
  }

  CRUMPLE_INLINE Pack size(const Plane& stress) const {
    const Parts k = parts(stress);
    const Pack first = k.mean + k.radius;
    const Pack second = k.mean - k.radius;
    const Pack twice = k.radius + k.radius;
    const Pack sum =
        Pack(a) * multiply_add(lowered(first) * first, first, lowered(second) * second * second) +
        Pack(c) * (lowered(twice) * twice * twice);
    return k.size * math::power(Pack(Pack(Real(0.5)) * sum), Pack(Real(1) / m));
  }

  CRUMPLE_INLINE Value at(const Plane& stress) const {
    const Pack half(Real(0.5));
    const Pack two(Real(2));
    const Pack more(m - Real(1));
    const Parts k = parts(stress);
    const Pack first = k.mean + k.radius;
    const Pack second = k.mean - k.radius;
    const Pack twice = k.radius + k.radius;
    const Pack by_first = Pack(a) * lowered(first);
    const Pack by_second = Pack(a) * lowered(second);
    const Pack by_twice = Pack(c) * lowered(twice);
    const Pack phi =
        half * multiply_add(by_first * first, first,
                            multiply_add(by_second * second, second, Pack(by_twice * twice * twice)));
    const Pack over = half / phi;
    // Derivatives over K1 and K2, by the equivalent stress of the reduced stresses.
    const Pack f1 = over * multiply_add(by_first, first, Pack(by_second * second));
    const Pack f2 = over * multiply_add(two * by_twice, twice, by_first * first - by_second * second);
    const Pack f11 = more * multiply_add(over, Pack(by_first + by_second), Pack(-(f1 * f1)));
    const Pack f12 = more * multiply_add(over, Pack(by_first - by_second), Pack(-(f1 * f2)));
    const Pack f22 =
        more * multiply_add(over, Pack((by_first + by_second) + two * two * by_twice), Pack(-(f2 * f2)));
    // K2 turns in the plane of half difference and shear; where it vanishes its direction has no meaning.
    const Pack radius = larger(k.radius, Pack(sizeof(Real) == sizeof(float) ? Real(1e-4) : Real(1e-8)));
    const Pack along = k.apart / radius;
    const Pack beside = k.shear / radius;
    const Pack turn = f2 / radius;
    const Pack size = math::power(phi, Pack(Real(1) / m));
    Value found;
    found.size = size * k.size;
    const Pack across(h);
    const Pack shear(p);
    found.normal = {size * (half * multiply_add(f2, along, f1)),
                    size * across * (half * multiply_add(Pack(-f2), along, f1)),
                    size * shear * (f2 * beside)};
    // e = (1/2, 1/2, 0), g = (along/2, -along/2, beside), t = (-beside/2, beside/2, along).
    const Pack quarter(Real(0.25));
    const Pack gg = multiply_add(f22 * along, along, turn * beside * beside);
    const Pack gs = half * multiply_add(f22 * along, beside, Pack(-(turn * along * beside)));
    const Pack eg = two * f12 * along;
    const Pack es = half * f12 * beside;
    const Pack scale = size / k.size;
    found.curvature = {scale * (quarter * (f11 + (gg + eg))),
                       scale * across * across * (quarter * (f11 + (gg - eg))),
                       scale * shear * shear * multiply_add(f22 * beside, beside, turn * along * along),
                       scale * across * (quarter * (f11 - gg)),
                       scale * across * shear * (es - gs),
                       scale * shear * (es + gs)};
    return found;
  }
};

}  // namespace crumple::materials
