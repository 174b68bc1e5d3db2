// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/plasticity/principal.hpp"
#include "materials/plasticity/yield_point.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Constants of ThreeSurfaceConcreteLaw. Tables have three numbers a row, as PointTable.
enum SurfacesPlace {
  SurfacesMaximum,                            ///< a0, a1, a2
  SurfacesYield = SurfacesMaximum + 3,        ///< a0, a1, a2
  SurfacesResidual = SurfacesYield + 3,       ///< 0, a1, a2
  SurfacesUnconfined = SurfacesResidual + 3,  ///< a third of the strength in compression, of the maximum
  SurfacesFirst,                              ///< a third of it, of yield
  SurfacesTension,                            ///< FT
  SurfacesCompressionPower,                   ///< B1
  SurfacesTensionPower,                       ///< B2
  SurfacesOpening,                            ///< B3
  SurfacesDilatancy,                          ///< OMEGA
  SurfacesShear,                              ///< G over the bulk modulus
  SurfacesPerDensity,
  SurfacesPoints,                               ///< rows of both tables of compaction
  SurfacesRows,                                 ///< rows of the table of damage
  SurfacesPeak,                                 ///< the row of the maximum
  SurfacesPeakDamage,                           ///< lambda there
  SurfacesMeridians,                            ///< table of five rows: pressure, extension over compression
  SurfacesCompaction = SurfacesMeridians + 15,  ///< table of at most `most_compaction` rows
  SurfacesUnloading = SurfacesCompaction + 30,
  SurfacesDamage = SurfacesUnloading + 30,            ///< table of at most 14 rows
  SurfacesTensionRows = SurfacesDamage + 42,          ///< rows of the factors of rates; zero is none
  SurfacesTensionRates,                               ///< table of at most 48 rows
  SurfacesPressRows = SurfacesTensionRates + 3 * 48,  ///< the same in compression
  SurfacesPressRates,
  SurfacesCount = SurfacesPressRates + 3 * 48,
};
constexpr int most_rate_rows = 48;

/// The strength of the K&C concrete model (docs/theory/three_surface_concrete.md): pressures p are positive
/// in compression, sizes are sqrt(3 J2), strengths those of triaxial compression.
template <class Pack>
struct ThreeSurfaces {
  using Real = RealOf<Pack>;
  using Mask = MaskOf<Pack>;
  static constexpr Real tiny = sizeof(Real) == sizeof(float) ? Real(1e-30) : Real(1e-200);

  const double* c;

  CRUMPLE_INLINE Pack number(int place) const { return Pack(static_cast<Real>(c[place])); }
  CRUMPLE_INLINE PointTable<Real> table(int place, int rows) const {
    return {c + place, static_cast<int>(c[rows])};
  }

  /// How many times as strong the rate makes the surfaces: they grow in all directions from the origin.
  /// Between tension and the pressure of unconfined compression the factors of both mix.
  CRUMPLE_INLINE Pack rate_factor(const Pack& p, const Pack& rate) const {
    const Pack torn = table(SurfacesTensionRates, SurfacesTensionRows).at(rate).stress;
    const Pack pressed = table(SurfacesPressRates, SurfacesPressRows).at(rate).stress;
    const Pack share = smaller(larger(Pack(p / number(SurfacesUnconfined)), Pack(Real(0))), Pack(Real(1)));
    return multiply_add(share, Pack(pressed - torn), torn);
  }

  struct Curve {
    Pack value, slope;  ///< by the pressure
  };
  CRUMPLE_INLINE Curve hyperbola(int place, const Pack& p) const {
    const Pack first = number(place + 1);
    const Pack below = Pack(Real(1)) / multiply_add(number(place + 2), p, first);
    return {multiply_add(p, below, number(place)), first * (below * below)};
  }
  CRUMPLE_INLINE static Curve chosen(const Mask& mask, const Curve& a, const Curve& b) {
    return {select<Pack>(mask, a.value, b.value), select<Pack>(mask, a.slope, b.slope)};
  }
  /// psi, the strength in triaxial extension over that in compression.
  CRUMPLE_INLINE YieldPoint<Pack> meridians(const Pack& p) const {
    return PointTable<Real>{c + SurfacesMeridians, 5}.at(larger(p, Pack(Real(0))));
  }

  Curve maximum(const Pack& p) const {
    const Pack zero(Real(0));
    const Pack tension = number(SurfacesTension);
    const auto psi = meridians(p);
    const Pack per = Pack(Real(1.5)) / psi.stress;
    const Pack middle = per * (p + tension);
    const Curve low{middle, per - middle * (psi.slope / psi.stress)};
    const Pack three(Real(3));
    const Curve torn{three * (p + tension), three};
    const Pack pressed = larger(p, zero);
    return chosen(p < zero, torn,
                  chosen(p < number(SurfacesUnconfined), low, hyperbola(SurfacesMaximum, pressed)));
  }
  Curve yield(const Pack& p) const {
    const Pack zero(Real(0));
    const Pack begin = Pack(Real(1.35)) * number(SurfacesTension);
    const Pack first = number(SurfacesFirst);
    const Pack rise = Pack(Real(3)) - begin / first;
    const Curve low{multiply_add(rise, p, begin), rise};
    const Pack steep(Real(1.35));
    const Curve torn{multiply_add(steep, p, begin), steep};
    return chosen(p < zero, torn, chosen(p < first, low, hyperbola(SurfacesYield, larger(p, zero))));
  }

  /// The strength as a function of eta: base + eta rise, before the maximum and behind it.
  struct Sides {
    Curve base, rise;
  };
  CRUMPLE_INLINE static Sides sides(const Curve& base, const Curve& top) {
    return {base, {top.value - base.value, top.slope - base.slope}};
  }
  CRUMPLE_INLINE Sides hardening(const Pack& p, const Curve& most) const {
    const Curve first = yield(p);
    return sides(chosen(first.value > most.value, most, first), most);
  }
  CRUMPLE_INLINE Sides softening(const Pack& p, const Curve& most) const {
    const Pack zero(Real(0));
    const Pack three(Real(3));
    const Curve held = hyperbola(SurfacesResidual, larger(p, zero));
    const Sides pressed = sides(chosen(held.value > most.value, most, held), most);
    // In tension the whole surface draws back to the origin.
    const Mask torn = p < zero;
    return {chosen(torn, {three * p, three}, pressed.base),
            chosen(torn, {three * number(SurfacesTension), zero}, pressed.rise)};
  }
  CRUMPLE_INLINE Mask softens(const Pack& damage) const { return damage >= number(SurfacesPeakDamage); }
  CRUMPLE_INLINE Pack eta(const Pack& damage) const {
    return table(SurfacesDamage, SurfacesRows).at(damage).stress;
  }
  /// eta behind the maximum, one before it.
  CRUMPLE_INLINE Pack held(const Pack& damage) const {
    return select<Pack>(softens(damage), eta(damage), Pack(Real(1)));
  }
  CRUMPLE_INLINE Pack speed(const Pack& damage, const Pack& softening_speed) const {
    return select<Pack>(softens(damage), softening_speed, Pack(Real(1)));
  }

  /// In triaxial compression, not below zero.
  Curve strength(const Pack& p, const Pack& damage) const {
    const Curve most = maximum(p);
    const Sides before = hardening(p, most);
    const Sides behind = softening(p, most);
    const Mask soft = softens(damage);
    const Pack at = eta(damage);
    const auto mixed = [&](const Curve& base, const Curve& rise) {
      return Curve{multiply_add(at, rise.value, base.value), multiply_add(at, rise.slope, base.slope)};
    };
    const Curve now = chosen(soft, mixed(behind.base, behind.rise), mixed(before.base, before.rise));
    return {larger(now.value, Pack(Real(0))), larger(now.slope, Pack(Real(0)))};
  }

  /// Strength at an angle over that in triaxial compression (K.J. Willam & E.P. Warnke, IABSE Proc. 19,
  /// 1975).
  Pack ratio(const Pack& p, const Pack& cosine) const {
    const Pack one(Real(1));
    const Pack two(Real(2));
    const Pack four(Real(4));
    const Pack psi = meridians(p).stress;
    const Pack missing = one - psi * psi;
    const Pack skew = two * psi - one;
    const Pack wide = four * (missing * (cosine * cosine));
    const Pack inner = multiply_add(Pack(Real(5)), Pack(psi * psi), Pack(wide - four * psi));
    const Pack above =
        multiply_add(skew, square_root(larger(inner, Pack(Real(0)))), Pack(two * (missing * cosine)));
    const Pack below = multiply_add(skew, skew, wide);
    return select<Pack>(psi >= one, one, above / larger(below, Pack(tiny)));
  }

  /// A trial outside of the surface, stresses over the factor of the rate.
  struct Flow {
    Pack pressure, size, ratio, damage;
    Pack volume;  ///< plastic volumetric strain per plastic strain of shear
    Pack bulk;
    Pack softening_speed;
    Pack rate_factor;
  };
  struct End {
    Pack strain, damage;  ///< plastic strain of shear; lambda
  };
  /// Growth of lambda per plastic strain of shear, before the maximum.
  CRUMPLE_INLINE Pack growth(const Flow& f) const {
    const Pack one(Real(1));
    const Pack least(Real(0.01));
    const Pack base = larger(Pack(one + f.pressure / number(SurfacesTension)), least);
    const Pack power = select<Pack>(f.pressure < Pack(Real(0)), number(SurfacesTensionPower),
                                    number(SurfacesCompressionPower));
    const Pack all = square_root(multiply_add(Pack(Pack(Real(2.0 / 9.0)) * f.volume), f.volume, one));
    return all / (f.rate_factor * math::power(base, power));
  }

  /// The size falls with the plastic strain, by shear and by what dilation adds to the pressure; the strength
  /// is straight between the rows of the table of damage: the first row before which both meet.
  End returned(const Flow& f, const Pack& slope, const Mask& mask) const {
    const Pack zero(Real(0));
    const Pack one(Real(1));
    const Pack fall = f.bulk * multiply_add(f.volume, slope, Pack(Pack(Real(3)) * number(SurfacesShear)));
    const Curve most = maximum(f.pressure);
    const Sides before = hardening(f.pressure, most);
    const Sides behind = softening(f.pressure, most);
    const Pack slow = growth(f);
    const Pack fast = slow * f.softening_speed;
    const int rows = static_cast<int>(c[SurfacesRows]);
    const double* const row = c + SurfacesDamage;
    End found{zero, f.damage};
    Mask open = mask;
    for (int k = 0; k + 1 < rows && any<Pack>(open); ++k) {
      const Pack last(static_cast<Real>(row[3 * k + 3]));
      const Mask here = open && (found.damage < last);
      if (!any<Pack>(here)) continue;
      const bool soft = k >= static_cast<int>(c[SurfacesPeak]);
      const Sides& side = soft ? behind : before;
      const Pack from(static_cast<Real>(row[3 * k]));
      const Pack first = multiply_add(Pack(static_cast<Real>(row[3 * k + 2])), Pack(found.damage - from),
                                      Pack(static_cast<Real>(row[3 * k + 1])));
      const Pack second(static_cast<Real>(row[3 * k + 4]));
      const auto excess = [&](const Pack& share, const Pack& strain) {
        const Pack bound = f.ratio * larger(multiply_add(share, side.rise.value, side.base.value), zero);
        return multiply_add(Pack(-fall), strain, Pack(f.size - bound));
      };
      const Pack more = last - found.damage;
      const Pack span = more / (soft ? fast : slow);
      const Pack start = larger(excess(first, found.strain), zero);
      const Pack end = excess(second, Pack(found.strain + span));
      const Mask meets = end <= zero;
      const Pack part = select<Pack>(meets, start / larger(Pack(start - end), Pack(tiny)), one);
      found.strain = select<Pack>(here, multiply_add(part, span, found.strain), found.strain);
      const Pack damage = select<Pack>(meets, multiply_add(part, more, found.damage), last);
      found.damage = select<Pack>(here, damage, found.damage);
      open = open && !(here && meets);
    }
    return found;
  }
};

}  // namespace crumple::materials
