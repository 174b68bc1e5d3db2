// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/laws/johnson_holmquist.hpp"
#include "materials/laws/total_deformation.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Concrete under high pressures, after Holmquist, Johnson & Cook (docs/theory/johnson_holmquist.md).
struct HolmquistConcreteLaw {
  using Model = model::HolmquistConcrete;
  static constexpr const char* name = "concrete, Holmquist-Johnson-Cook";
  static constexpr bool wave_speed_varies = true;

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law);

  template <class Pack>
  struct SolidUpdate : BrittlePoint<Pack> {
    using Base = BrittlePoint<Pack>;
    using typename Base::History;
    using typename Base::Mask;
    using typename Base::Real;
    static constexpr bool can_yield = false;
    static constexpr bool may_fail = true;

    enum Place {
      Cohesion = Base::OwnConstants,
      PressureFactor,
      PressurePower,
      UniaxialStrength,
      PerStrength,
      PerTension,
      LargestStrength,
      CrushPressure,
      CrushVolume,
      CrushSlope,   ///< of the pressure over mu while pores collapse
      FullVolume,   ///< mu at which the last pore has gone, under PL
      PerCrushing,  ///< 1/(FullVolume - CrushVolume)
      ElasticBulk,
      LockVolume,
      LeastFracture,
      Count
    };

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task) : Base(task) {}

    using Base::number;
    using Base::one;

    /// The line of unloading from a largest mu, which lies between UC and FullVolume.
    struct Line {
      Pack start, top, stiffness;                                           ///< mu, pressure there, slope
      CRUMPLE_INLINE Pack rest() const { return start - top / stiffness; }  ///< mu without pressure
    };
    CRUMPLE_INLINE Line line_from(const Pack& most) const {
      const Pack first = number(CrushVolume);
      const Pack start = larger(smaller(most, number(FullVolume)), first);
      const Pack elastic = number(ElasticBulk);
      const Pack share = number(PerCrushing) * (start - first);
      return {start, multiply_add(number(CrushSlope), Pack(start - first), number(CrushPressure)),
              multiply_add(share, Pack(number(Base::Bulk) - elastic), elastic)};
    }

    struct Pressure {
      Pack value, slope;  ///< without limit in tension; over mu, the steepest that there may be
      Pack crushed;       ///< growth of the plastic volume, as mu
    };
    CRUMPLE_INLINE Pressure pressure(const Pack& mu, const History& history) const {
      const Pack zero(Real(0));
      const Pack whole(Real(1));
      Real* const place = one(history, Base::Memory);
      const Pack old = load<Pack>(place);
      const Pack most = larger(old, mu);
      store(place, most);
      const Line line = line_from(most);
      const Pack grain = whole / (whole + number(LockVolume));
      const auto dense = Base::polynomial(Pack(grain * (mu - number(LockVolume))));
      const Mask full = most > number(FullVolume);
      return {select<Pack>(full, dense.value, Pack(line.top - line.stiffness * (line.start - mu))),
              select<Pack>(full, larger(Pack(grain * dense.slope), number(Base::Bulk)),
                           larger(line.stiffness, number(CrushSlope))),
              larger(Pack(line.rest() - line_from(old).rest()), zero)};
    }

    CRUMPLE_INLINE Pack strength(const Pack& p, const Pack& damage, const Pack& factor) const {
      const Pack zero(Real(0));
      const Pack whole(Real(1));
      const Pack left = multiply_add(number(PerTension), smaller(p, zero), Pack(whole - damage));
      const Pack squeezed = number(PerStrength) * larger(p, zero);
      const Pack sum = multiply_add(number(PressureFactor), math::power(squeezed, number(PressurePower)),
                                    Pack(number(Cohesion) * larger(left, zero)));
      return number(UniaxialStrength) * smaller(Pack(factor * sum), number(LargestStrength));
    }

    CRUMPLE_INLINE TotalStress<Pack> updated(const SolidStress<Pack>& old, const SolidStrain<Pack>& strain,
                                             const Turn<Pack>& turn, const History& history) const {
      const Pack zero(Real(0));
      const Pack whole(Real(1));
      const auto squeezed = Base::compress(history, strain, turn);
      const Pressure from_volume = pressure(squeezed.mu, history);
      const Pack damage = load<Pack>(one(history, Base::Damage));
      const Pack tension = number(Base::Tension);
      const Pack p = larger(from_volume.value, Pack(-(tension * (whole - damage))));
      const auto flown = Base::flow(old, strain, p, strength(p, damage, this->rate.factor(strain)), history);
      const Pack shifted = larger(Pack(number(PerStrength) * (p + tension)), zero);
      const Pack fracture =
          larger(Pack(number(Base::FractureFactor) * math::power(shifted, number(Base::FracturePower))),
                 number(LeastFracture));
      store(one(history, Base::Damage),
            Base::worn(damage, Pack(flown.strain + from_volume.crushed), fracture));
      Base::judge(from_volume.value, damage, history);
      return {flown.stress, Base::wave_square(from_volume.slope, squeezed.volume)};
    }
  };
};

}  // namespace crumple::materials
