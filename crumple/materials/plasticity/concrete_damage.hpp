// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/plasticity/cap_surface.hpp"

namespace crumple::materials {

/// Constants of the damage and of the rate effects, behind those of the surface.
enum ConcretePlace {
  ConcreteYoungs = CapSurfaceCount,
  ConcretePoisson,
  ConcreteRates,             ///< 1: with rate effects
  ConcreteErodes,            ///< 1: points fail at
  ConcreteErosion,           ///< this largest principal strain
  ConcreteWaveSquare,        ///< square of the speed of longitudinal waves
  ConcreteRootModulus,       ///< sqrt(E)
  ConcreteBrittleShape,      ///< D
  ConcreteBrittleLength,     ///< (1 + D) ln(1 + D) / D
  ConcreteDuctileShape,      ///< B
  ConcreteDuctileLength,     ///< (1 + B) ln(1 + B) / B
  ConcreteDuctileDilog,      ///< -(1 + B) / B Li2(-B)
  ConcreteTension,           ///< GFT
  ConcreteCompression,       ///< GFC
  ConcreteShear,             ///< GFS
  ConcreteTensionPower,      ///< PWRT
  ConcreteCompressionPower,  ///< PWRC
  ConcretePressurePower,     ///< PMOD
  ConcreteFirst,             ///< PRED
  ConcreteKept,              ///< share of brittle damage that stays under pressure
  ConcreteByVolume,          ///< 1: the volume must be compressed as well
  ConcreteTensionFluidity,   ///< three numbers: eta0, N, largest overstress
  ConcreteCompressionFluidity = ConcreteTensionFluidity + 3,
  ConcreteShearFluidity = ConcreteCompressionFluidity + 3,  ///< SRATE
  ConcreteEnergyPower,                                      ///< REPOW
  ConcreteCount
};

/// Items of the history: threshold and damage of both kinds. A threshold of zero: none has begun.
enum ConcreteDamageItem { BrittleStart, Brittle, DuctileStart, Ductile, ConcreteDamageItems };

/// Brittle and ductile damage (J.C. Simo & J.W. Ju, IJSS 23 (1987) 821-869, as Murray uses it) and fluidity
/// (docs/theory/cscm_concrete.md).
template <class Pack>
struct ConcreteDamage {
  using Real = RealOf<Pack>;
  using Mask = MaskOf<Pack>;

  static constexpr Real tiny = sizeof(Real) == sizeof(float) ? Real(1e-30) : Real(1e-200);
  static constexpr Real most_damage = Real(0.999);

  const double* c;

  CRUMPLE_INLINE Pack number(int place) const { return Pack(static_cast<Real>(c[place])); }

  /// Stress without rate effects: I and the root of J2.
  struct At {
    Pack trace, size;
  };
  /// I over sqrt(3 J2): 1 in uniaxial compression, -1 in tension, 0 in shear.
  CRUMPLE_INLINE static Pack triaxiality(const At& at) {
    return at.trace / larger(Pack(Pack(Real(1.7320508075688773)) * at.size), Pack(tiny));
  }
  /// From shear to uniaxial stress.
  CRUMPLE_INLINE Pack transition(const Pack& triaxiality, int power) const {
    const Pack bounded = smaller(larger(triaxiality, Pack(Real(0))), Pack(Real(1)));
    return c[power] == 1 ? bounded : math::power(bounded, number(power));
  }

  CRUMPLE_INLINE Pack fluidity_of(int place, const Pack& rate) const {
    const Pack stiff = larger(Pack(number(ConcreteYoungs) * rate), Pack(tiny));
    const Pack free = number(place) / math::power(larger(rate, Pack(tiny)), number(place + 1));
    return c[place + 2] > 0 ? smaller(free, Pack(number(place + 2) / stiff)) : free;
  }
  /// eta, of the Duvaut-Lions form: [time].
  CRUMPLE_INLINE Pack fluidity(const At& at, const Pack& rate) const {
    const Pack along = triaxiality(at);
    const Pack tension = fluidity_of(ConcreteTensionFluidity, rate);
    const Pack shear = number(ConcreteShearFluidity) * tension;
    const Mask pressed = along >= Pack(Real(0));
    const Pack share = select<Pack>(pressed, transition(along, ConcreteCompressionPower),
                                    transition(Pack(-along), ConcreteTensionPower));
    const Pack end = select<Pack>(pressed, fluidity_of(ConcreteCompressionFluidity, rate), tension);
    return multiply_add(share, Pack(end - shear), shear);
  }

  /// What wears the point in a step.
  struct Load {
    At at;
    Mask dilates;
    Pack overstress;  ///< E rate eta [stress]
    Pack volume;      ///< volumetric strain
    Pack strain;      ///< largest principal strain; need not be known under pressure
    Pack energy;      ///< stress times strain, without rate effects
  };
  struct Worn {
    Pack lost;  ///< share of the stress that is lost now
    Pack most;  ///< the larger damage
  };

  /// Energy per area of the crack at a stress between shear and `end`.
  CRUMPLE_INLINE Pack energy(const Pack& share, int end, const Pack& rise) const {
    const Pack shear = number(ConcreteShear);
    const Pack slow = multiply_add(share, Pack(number(end) - shear), shear);
    if (c[ConcreteRates] == 0) return slow;
    return slow * (c[ConcreteEnergyPower] == 1 ? rise : math::power(rise, number(ConcreteEnergyPower)));
  }
  /// most (1 - e) / (1 + shape e) with e = exp(-rate past).
  CRUMPLE_INLINE static Pack softened(const Pack& rate, const Pack& past, const Pack& shape,
                                      const Pack& most) {
    const Pack one(Real(1));
    const Pack e = CapSurface<Pack>::exponential(Pack(-(rate * larger(past, Pack(Real(0))))));
    return most * (one - e) / multiply_add(shape, e, one);
  }

  CRUMPLE_INLINE Pack brittle(const Load& load_now, const Pack& start, const Pack& driver,
                              const Pack& length) const {
    const Pack begin = larger(start, Pack(tiny));
    const Pack more = load_now.overstress / number(ConcreteRootModulus);
    const Pack rise = Pack(Real(1)) + more / begin;
    const Pack share = transition(Pack(-triaxiality(load_now.at)), ConcreteTensionPower);
    const Pack held = energy(share, ConcreteTension, rise);
    // Of the stress with rate effects, which begins to soften later and from more.
    const Pack late = start + more;
    const Pack rate = late * (length * number(ConcreteBrittleLength)) / held;
    return softened(rate, Pack(driver - late), number(ConcreteBrittleShape), Pack(most_damage));
  }

  CRUMPLE_INLINE Pack ductile(const Load& load_now, const Pack& start, const Pack& driver,
                              const Pack& length) const {
    const Pack one(Real(1));
    const Pack begin = larger(start, Pack(tiny));
    const Pack along = triaxiality(load_now.at);
    // Of a uniaxial stress s the driver is s / sqrt(2 E).
    const Pack more = load_now.overstress / (Pack(Real(1.4142135623730951)) * number(ConcreteRootModulus));
    const Pack rise = one + more / begin;
    const Pack share = transition(along, ConcreteCompressionPower);
    const Pack held = energy(share, ConcreteCompression, rise) / (Pack(Real(4)) * (rise * length));
    const Pack late = start + more;
    const Pack linear = late * number(ConcreteDuctileLength);
    const Pack four = Pack(Real(4)) * number(ConcreteDuctileDilog);
    const Pack root = square_root(multiply_add(linear, linear, Pack(four * held)));
    Pack rate = (linear + root) / (held + held);
    // Under pressure from the sides part of the strength stays.
    const Pack over = one / larger(along, one);
    const Pack most = smaller(Pack(over * square_root(over)), Pack(most_damage));
    if (c[ConcretePressurePower] != 0)
      rate = rate * math::power(Pack(most + Pack(Real(0.001))), number(ConcretePressurePower));
    return softened(rate, Pack(driver - late), number(ConcreteDuctileShape), most);
  }

  /// Brings thresholds and damage up to date. A threshold is where the point first flows with growing volume,
  /// under tension that of brittle damage, under pressure that of ductile damage.
  CRUMPLE_INLINE Worn advance(const Load& load_now, const Pack& length,
                              Real* const (&items)[ConcreteDamageItems]) const {
    const Pack zero(Real(0));
    const Mask pressed = load_now.at.trace >= zero;
    const Pack strained = number(ConcreteRootModulus) * larger(load_now.strain, zero);
    const Pack stored = square_root(Pack(Pack(Real(0.5)) * larger(load_now.energy, zero)));
    const auto begin = [&](int item, const Mask& where, const Pack& driver) {
      const Pack old = load<Pack>(items[item]);
      const Pack now =
          select<Pack>(where && load_now.dilates && (old == zero), larger(driver, Pack(tiny)), old);
      store(items[item], now);
      return now;
    };
    const Pack brittle_start = begin(BrittleStart, !pressed, strained);
    const Pack ductile_start = begin(DuctileStart, pressed, stored);
    Pack torn = larger(load<Pack>(items[Brittle]), number(ConcreteFirst));
    Pack crushed = larger(load<Pack>(items[Ductile]), number(ConcreteFirst));
    const Mask tears = (!pressed) && (brittle_start > zero) && (strained > brittle_start);
    if (any<Pack>(tears)) {
      const Pack now = brittle(load_now, brittle_start, strained, length);
      torn = select<Pack>(tears, larger(torn, now), torn);
    }
    const Mask yields = pressed && (ductile_start > zero) && (stored > ductile_start);
    if (any<Pack>(yields)) {
      const Pack now = ductile(load_now, ductile_start, stored, length);
      crushed = select<Pack>(yields, larger(crushed, now), crushed);
    }
    store(items[Brittle], torn);
    store(items[Ductile], crushed);
    // Cracks close under pressure.
    Mask closed = pressed;
    if (c[ConcreteByVolume] != 0) closed = closed && (load_now.volume < zero);
    const Pack kept = select<Pack>(closed, Pack(number(ConcreteKept) * torn), torn);
    return {larger(kept, crushed), larger(torn, crushed)};
  }
};

}  // namespace crumple::materials
