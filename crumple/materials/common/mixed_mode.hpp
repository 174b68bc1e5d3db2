// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/pack.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Numbers of a traction that rises linearly over a separation up to its strength and then falls linearly to
/// zero, in any mixture of opening and sliding (P.P. Camanho, C.G. Davila & M.F. de Moura, Journal of
/// Composite Materials 37 (2003) 1415-1438; LS-DYNA Keyword User's Manual, *MAT_COHESIVE_MIXED_MODE). Ties
/// that soften and cohesive solids share it: docs/theory/cohesive_ties.md.
template <class Real>
struct MixedMode {
  enum class Criterion {
    PowerLaw,
    BenzeggaghKenane,
    CriticalOpening,  ///< complete at a length of the separation, whatever the mode
    Brittle,          ///< complete at the strength, tension and shear each by itself
  };
  Criterion criterion = Criterion::PowerLaw;
  Real normal_stiffness = 0;    ///< [stress/length]
  Real shear_stiffness = 0;     ///< [stress/length]
  Real normal_use = 0;          ///< (stiffness / strength)^2; 0: no strength [1/length^2]
  Real shear_use = 0;           ///< likewise
  Real normal_energy = 0;       ///< G_Ic [energy/area]
  Real shear_energy = 0;        ///< G_IIc [energy/area]
  Real exponent = 1;            ///< of the criterion [-]
  Real stiffness_exponent = 1;  ///< gamma of the stiffness in mixed modes, Benzeggagh & Kenane [-]
  Real critical_opening = 0;    ///< [length]
};

/// x^y, exactly x where y is one.
template <class Pack>
CRUMPLE_INLINE Pack plain_power(const Pack& x, RealOf<Pack> y) {
  return y == RealOf<Pack>(1) ? x : math::power(x, Pack(y));
}

/// Square of the separation over that of the onset of damage on the same ray, from the squares of the opening
/// (zero in compression) and the sliding; above 1 there is damage.
template <class Pack>
CRUMPLE_INLINE Pack squared_use(const MixedMode<RealOf<Pack>>& law, const Pack& opening,
                                const Pack& sliding) {
  const Pack normal = Pack(law.normal_use) * opening;
  const Pack shear = Pack(law.shear_use) * sliding;
  if (law.criterion == MixedMode<RealOf<Pack>>::Criterion::Brittle) return larger(normal, shear);
  return normal + shear;
}

/// Separation at complete damage over that at its onset on the ray of the two squares, whose squared_use() is
/// `use`: twice the energy of the mode over that stored at the onset.
template <class Pack>
CRUMPLE_INLINE Pack failure_over_onset(const MixedMode<RealOf<Pack>>& law, const Pack& opening,
                                       const Pack& sliding, const Pack& use) {
  using Real = RealOf<Pack>;
  using Criterion = typename MixedMode<Real>::Criterion;
  const Pack normal = Pack(law.normal_stiffness) * opening;
  const Pack shear = Pack(law.shear_stiffness) * sliding;
  const Pack twice = Pack(Real(2)) * use;
  switch (law.criterion) {
    case Criterion::PowerLaw: {
      const Pack sum = plain_power(Pack(normal / Pack(law.normal_energy)), law.exponent) +
                       plain_power(Pack(shear / Pack(law.shear_energy)), law.exponent);
      return twice / plain_power(sum, Real(1) / law.exponent);
    }
    case Criterion::BenzeggaghKenane: {
      const Pack share = plain_power(Pack(shear / (normal + shear)), law.exponent);
      const Pack energy =
          multiply_add(Pack(law.shear_energy - law.normal_energy), share, Pack(law.normal_energy));
      if (law.stiffness_exponent == Real(1)) return twice * energy / (normal + shear);
      const Pack square = opening + sliding;
      const Pack mean = opening / square * plain_power(Pack(law.normal_stiffness), law.stiffness_exponent) +
                        sliding / square * plain_power(Pack(law.shear_stiffness), law.stiffness_exponent);
      return twice * energy / (square * plain_power(mean, Real(1) / law.stiffness_exponent));
    }
    case Criterion::CriticalOpening:
      return Pack(law.critical_opening) * square_root(Pack(use / (opening + sliding)));
    case Criterion::Brittle:
      break;
  }
  return Pack(Real(0));
}

/// Damage at the squares of the opening (zero in compression) and the sliding, where it has been `before`; 1
/// is broken. On a ray D = d_f (d - d_0) / (d (d_f - d_0)), which never falls.
template <class Pack>
CRUMPLE_INLINE Pack mixed_mode_damage(const MixedMode<RealOf<Pack>>& law, const Pack& opening,
                                      const Pack& sliding, const Pack& before) {
  const Pack one(RealOf<Pack>(1));
  const Pack use = squared_use(law, opening, sliding);
  const auto softens = use > one;
  // Most are below their strength, and where they fail takes powers to find.
  if (!any<Pack>(softens)) return before;
  const Pack failure = failure_over_onset(law, opening, sliding, use);
  const Pack length = square_root(use);
  const auto breaks = length >= failure;
  const Pack rest = select<Pack>(breaks, one, Pack(length * (failure - one)));
  const Pack damage = select<Pack>(breaks, one, Pack(failure * (length - one) / rest));
  return select<Pack>(softens, larger(before, damage), before);
}

}  // namespace crumple::materials
