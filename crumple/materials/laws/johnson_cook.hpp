// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/plasticity/plane_stress_plasticity.hpp"
#include "materials/plasticity/solid_plasticity.hpp"

namespace crumple::materials {

/// A + B p^n up to a largest value, and up to what the rate factor leaves of a saturation stress.
template <class Real>
struct JohnsonCookHardening {
  static constexpr bool rough = true;

  Real initial;
  Real modulus;
  Real exponent;
  Real largest;     ///< of A + B p^n
  Real saturation;  ///< of that times the rate factor

  template <class Strain, class Pack>
  CRUMPLE_INLINE Pack aside(const Strain& /*strain*/, const Pack& factor) const {
    return smaller(Pack(largest), Pack(Pack(saturation) / factor));
  }
  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> at(const Pack& strain, const Pack& bound) const {
    const Pack grown = Pack(modulus) * math::power(strain, Pack(exponent));
    const Pack stress = Pack(initial) + grown;
    const Pack slope = Pack(exponent) * grown / larger(strain, Pack(tiny_strain<Real>));
    return {smaller(stress, bound), select<Pack>(stress < bound, slope, Pack(Real(0)))};
  }
  CRUMPLE_INLINE bool viscoplastic() const { return false; }
  template <class Pack>
  CRUMPLE_INLINE Pack least(const Pack& bound) const {
    return smaller(Pack(initial), bound);
  }
};

/// 1 + C ln(rate / reference), and 1 below the reference rate.
template <class Real>
struct LogarithmicRate {
  static constexpr Real ln2 = Real(0.69314718055994531);

  Real coefficient = 0;
  Real per_reference = 0;  ///< 1 / (reference rate times the step); 0 switches the effect off
  bool viscoplastic = false;

  CRUMPLE_INLINE LogarithmicRate(double rate_coefficient, double reference_rate, Real step,
                                 bool by_plastic_strain) {
    if (!(step > 0)) return;
    per_reference = static_cast<Real>(1 / (reference_rate * static_cast<double>(step)));
    coefficient = static_cast<Real>(rate_coefficient);
    viscoplastic = by_plastic_strain && rate_coefficient > 0;
  }

  /// ln of a strain increment's rate over the reference, at least 0.
  template <class Pack>
  CRUMPLE_INLINE Pack log_rate(const Pack& increment) const {
    return Pack(ln2) * math::binary_log(larger(Pack(Pack(per_reference) * increment), Pack(Real(1))));
  }
  template <template <class> class Strain, class Pack>
  CRUMPLE_INLINE Pack factor(const Strain<Pack>& strain) const {
    const Pack one(Real(1));
    if (coefficient == 0 || viscoplastic) return one;
    return multiply_add(Pack(coefficient), log_rate(effective_strain(strain)), one);
  }
  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> raised(const YieldPoint<Pack>& rest, const Pack& increment) const {
    const Pack one(Real(1));
    const Pack factor = multiply_add(Pack(coefficient), log_rate(increment), one);
    const auto fast = Pack(per_reference) * increment > one;
    const Pack by_rate = Pack(coefficient) * rest.stress / larger(increment, Pack(tiny_strain<Real>));
    return {factor * rest.stress,
            multiply_add(factor, rest.slope, select<Pack>(fast, by_rate, Pack(Real(0))))};
  }
};

/// Plasticity with heating and fracture after Johnson & Cook (docs/theory/johnson_cook.md).
struct JohnsonCookLaw {
  using Model = model::JohnsonCook;
  static constexpr const char* name = "Johnson-Cook";

  static const char* name_of(const model::ConstitutiveLaw& law);
  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law);

  enum Place {
    Youngs,
    Poissons,
    Initial,
    Modulus,
    Exponent,
    Largest,
    Saturation,
    RateCoefficient,
    ReferenceRate,
    Viscoplastic,
    Failure,
    ThermalExponent,
    PerMelting,
    RisePerWork,
    Softens,
    Damages,
    D1,
    D2,
    D3,
    D4,
    D5,
    LeastFracture,
    Count
  };

  template <class Pack, class Base>
  struct UpdateOf : Base {
    using typename Base::History;
    using typename Base::Mask;
    using typename Base::Real;
    using typename Base::Strain;
    using typename Base::Stress;
    using Hardening = JohnsonCookHardening<Real>;
    using RateEffect = LogarithmicRate<Real>;

    struct Trial : Base::Trial {
      Pack temperature;  ///< (T - T0) / (melting - T0) at the start of the step
      Pack log_rate;     ///< ln(rate / reference) of the total strain, at least 0
    };

    /// In solids: the law then brings the deviator alone.
    static constexpr bool takes_equation_of_state = requires(typename Base::Task task) {
      task.equation_of_state;
    };

    const double* c;
    bool softens;  ///< there is a temperature in the state
    bool damages;  ///< there is a damage in the state

    CRUMPLE_INLINE explicit UpdateOf(const typename Base::Task& task)
        : Base(task.constants[Youngs], task.constants[Poissons], 0,
               Hardening{
                   static_cast<Real>(task.constants[Initial]), static_cast<Real>(task.constants[Modulus]),
                   static_cast<Real>(task.constants[Exponent]), static_cast<Real>(task.constants[Largest]),
                   static_cast<Real>(task.constants[Saturation])},
               RateEffect(task.constants[RateCoefficient], task.constants[ReferenceRate], task.step,
                          task.constants[Viscoplastic] != 0),
               task.constants[Failure]),
          c(task.constants),
          softens(task.constants[Softens] != 0),
          damages(task.constants[Damages] != 0) {
      if constexpr (takes_equation_of_state)
        if (task.equation_of_state != nullptr) this->elasticity.drop_pressure();
    }

    CRUMPLE_INLINE Real number(Place place) const { return static_cast<Real>(c[place]); }
    CRUMPLE_INLINE static Real* temperature(const History& history) {
      return history.at(2 * history.points + history.point);
    }
    CRUMPLE_INLINE Real* damage(const History& history) const {
      return history.at((softens ? 3 : 2) * history.points + history.point);
    }

    CRUMPLE_INLINE bool fails() const { return damages || this->failure > 0; }
    CRUMPLE_INLINE Mask intact(const History& history) const {
      Mask holds = load<Pack>(Base::plastic_strain(history)) <
                   Pack(this->failure > 0 ? this->failure : Base::unreachable);
      if (damages) holds = holds && (load<Pack>(damage(history)) < Pack(Real(1)));
      return holds;
    }

    CRUMPLE_INLINE Trial trial(const Stress& stress, const Strain& strain, const History& history) const {
      const Pack one(Real(1));
      const Pack zero(Real(0));
      Trial t{};
      Pack factor = this->rate.factor(strain);
      t.temperature = zero;
      if (softens) {
        t.temperature = smaller(Pack(number(PerMelting) * load<Pack>(temperature(history))), one);
        const Pack soft = one - math::power(t.temperature, Pack(number(ThermalExponent)));
        // Molten metal keeps a trace of strength, that stresses over it stay numbers.
        factor = factor * larger(soft, Pack(Real(1e-4)));
      }
      t.log_rate =
          damages && this->rate.per_reference > 0 ? this->rate.log_rate(effective_strain(strain)) : zero;
      static_cast<typename Base::Trial&>(t) = this->trial_with(stress, strain, history, factor);
      if (fails()) t.radius = select<Pack>(intact(history), t.radius, Pack(Base::unreachable));
      return t;
    }

    /// In solids.
    CRUMPLE_INLINE void correct(Stress& stress, Trial& t, const Mask& mask, const History& history) const {
      Base::correct(stress, t, mask, history);
      wear(stress, t, history);
    }
    /// In shells.
    template <class Return>
    CRUMPLE_INLINE void correct(Stress& stress, Trial& t, const Mask& mask, const Return& way,
                                const History& history) const {
      Base::correct(stress, t, mask, way, history);
      wear(stress, t, history);
    }

    /// Heat and damage by the flow of the step.
    CRUMPLE_INLINE void wear(const Stress& stress, const Trial& t, const History& history) const {
      if (!softens && !damages) return;
      const Pack flow = t.flow;
      const Pack size = square_root(equivalent_square(stress));
      if (softens && number(RisePerWork) > 0) {
        const Pack rise = number(RisePerWork) * (size * flow);
        store(temperature(history), Pack(load<Pack>(temperature(history)) + rise));
      }
      if (damages) {
        const Pack triaxiality = mean_stress(stress) / larger(size, Pack(Real(1e-30)));
        const Pack strain = fracture_strain(triaxiality, t);
        store(damage(history), Pack(load<Pack>(damage(history)) + flow / strain));
      }
    }

    CRUMPLE_INLINE Pack fracture_strain(const Pack& triaxiality, const Trial& t) const {
      const Pack one(Real(1));
      const Pack per_ln2(Real(1.4426950408889634));
      const Pack shape = multiply_add(
          Pack(number(D2)), math::power_of_two(Pack(per_ln2 * (number(D3) * triaxiality))), Pack(number(D1)));
      const Pack bounded = larger(shape, Pack(number(LeastFracture)));
      const Pack by_rate = multiply_add(Pack(number(D4)), t.log_rate, one);
      const Pack by_heat = multiply_add(Pack(number(D5)), t.temperature, one);
      return larger(Pack(bounded * (by_rate * by_heat)), Pack(number(LeastFracture)));
    }
  };
  template <class Pack>
  using Update = UpdateOf<
      Pack, PlaneStressPlasticity<Pack, JohnsonCookHardening<RealOf<Pack>>, LogarithmicRate<RealOf<Pack>>>>;
  template <class Pack>
  using SolidUpdate =
      UpdateOf<Pack,
               SolidPlasticity<Pack, JohnsonCookHardening<RealOf<Pack>>, LogarithmicRate<RealOf<Pack>>>>;
};

}  // namespace crumple::materials
