// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/laws/johnson_holmquist.hpp"
#include "materials/laws/total_deformation.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Ceramics and glass with an intact and a fractured strength, and bulking (JH-2;
/// docs/theory/johnson_holmquist.md).
struct HolmquistCeramicLaw {
  using Model = model::HolmquistCeramic;
  static constexpr const char* name = "ceramic, Johnson-Holmquist";
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
      IntactFactor = Base::OwnConstants,
      IntactPower,
      FracturedFactor,
      FracturedPower,
      LargestFractured,
      LimitStress,  ///< von Mises stress at the Hugoniot elastic limit
      PerPressure,  ///< 1/PHEL
      Bulking,      ///< 2 BETA K1/(6 G)
      Count
    };

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task) : Base(task) {}

    using Base::number;
    using Base::one;

    struct Strength {
      Pack intact, fractured;
      CRUMPLE_INLINE Pack at(const Pack& damage) const { return intact - damage * (intact - fractured); }
    };
    CRUMPLE_INLINE Strength strength(const Pack& p, const Pack& shifted, const Pack& factor) const {
      const Pack size = number(LimitStress);
      const Pack intact = number(IntactFactor) * math::power(shifted, number(IntactPower));
      const Pack squeezed = number(PerPressure) * larger(p, Pack(Real(0)));
      const Pack fractured = number(FracturedFactor) * math::power(squeezed, number(FracturedPower));
      return {size * (factor * intact), size * smaller(Pack(factor * fractured), number(LargestFractured))};
    }

    /// The bulking pressure when the strength falls: beta of the elastic energy that the deviator loses stays
    /// as energy of the pressure, (K1 mu + dP)^2/(2 K1).
    CRUMPLE_INLINE Pack bulked(const Pack& bulking, const Pack& mu, const Pack& before,
                               const Pack& after) const {
      const Pack zero(Real(0));
      const Pack gain = number(Bulking) * larger(Pack((before - after) * (before + after)), zero);
      const Pack base = multiply_add(number(Base::Bulk), larger(mu, zero), bulking);
      const Pack sum = base + square_root(multiply_add(base, base, gain));
      return bulking + gain / larger(sum, Pack(Real(1e-30)));
    }

    CRUMPLE_INLINE TotalStress<Pack> updated(const SolidStress<Pack>& old, const SolidStrain<Pack>& strain,
                                             const Turn<Pack>& turn, const History& history) const {
      const Pack zero(Real(0));
      const Pack whole(Real(1));
      const auto squeezed = Base::compress(history, strain, turn);
      const auto from_volume = Base::polynomial(squeezed.mu);
      const Pack bulking = load<Pack>(one(history, Base::Memory));
      const Pack damage = load<Pack>(one(history, Base::Damage));
      const Pack free = from_volume.value + bulking;
      const Pack tension = number(Base::Tension);
      const Pack p = larger(free, Pack(-(tension * (whole - damage))));
      const Pack shifted = larger(Pack(number(PerPressure) * (p + tension)), zero);
      const Strength bound = strength(p, shifted, this->rate.factor(strain));
      const Pack before = bound.at(damage);
      const auto flown = Base::flow(old, strain, p, before, history);
      const Pack fracture = number(Base::FractureFactor) * math::power(shifted, number(Base::FracturePower));
      const Pack now = Base::worn(damage, flown.strain, fracture);
      store(one(history, Base::Damage), now);
      store(one(history, Base::Memory), bulked(bulking, squeezed.mu, before, bound.at(now)));
      Base::judge(free, damage, history);
      return {flown.stress, Base::wave_square(from_volume.slope, squeezed.volume)};
    }
  };
};

}  // namespace crumple::materials
