// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/laws/total_deformation.hpp"
#include "materials/laws/volume_history.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Foam whose stiffness and viscosity grow with compression (docs/theory/viscous_foam.md).
struct ViscousFoamLaw {
  using Model = model::ViscousFoam;
  static constexpr const char* name = "viscous foam";
  static constexpr bool wave_speed_varies = true;

  static void declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                              Index /*tensor*/) {
    declare_volume(block);
    domain::add_item(block, "elastic_stress", "stress", 6 * block.points);
  }
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }

  enum Place {
    Modulus,
    Poisson,
    Exponent,
    Viscosity,
    ViscosityExponent,
    LeastModulus,
    Confined,
    PerDensity,
    Count
  };

  template <class Pack>
  struct SolidUpdate {
    using Real = RealOf<Pack>;
    using History = HistoryView<Real>;
    static constexpr bool can_yield = false;
    static constexpr bool may_fail = false;

    const double* c;
    SolidElasticity<Real> unit;  ///< of a modulus of 1
    Real per_step;               ///< 1 / dt; 0 without a step

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : c(task.constants),
          unit(1, task.constants[Poisson]),
          per_step(task.step > 0 ? Real(1) / task.step : Real(0)) {}

    CRUMPLE_INLINE Pack number(Place place) const { return Pack(static_cast<Real>(c[place])); }

    /// V2 |1 - V|^n2.
    CRUMPLE_INLINE Pack viscosity(const Pack& volume) const {
      if (c[ViscosityExponent] == 0) return number(Viscosity);
      return number(Viscosity) *
             math::power(absolute(Pack(Pack(Real(1)) - volume)), number(ViscosityExponent));
    }

    CRUMPLE_INLINE TotalStress<Pack> updated(const SolidStress<Pack>& /*old*/,
                                             const SolidStrain<Pack>& strain, const Turn<Pack>& turn,
                                             const History& history) const {
      const Pack zero(Real(0));
      const Volumes<Pack> volume = follow_volume(history, 0, strain, turn);
      const Pack middle = Pack(Real(0.5)) * (volume.old + volume.now);
      const Pack modulus = number(Modulus) * math::power(Pack(Pack(Real(1)) / middle), number(Exponent));
      Real* const kept = history.at(2 * history.points + 6 * history.point);
      const auto before = turned(load_six<SolidStress<Pack>>(kept, lanes), turn);
      const SolidStress<Pack> growth = unit.stress({zero, zero, zero, zero, zero, zero}, strain);
      const auto add = [](const Pack& factor, const SolidStress<Pack>& more, const SolidStress<Pack>& to) {
        return SolidStress<Pack>{multiply_add(factor, more.xx, to.xx), multiply_add(factor, more.yy, to.yy),
                                 multiply_add(factor, more.zz, to.zz), multiply_add(factor, more.xy, to.xy),
                                 multiply_add(factor, more.yz, to.yz), multiply_add(factor, more.zx, to.zx)};
      };
      const SolidStress<Pack> elastic = add(modulus, growth, before);
      store_six(kept, lanes, elastic);
      const Pack eta = viscosity(middle);
      const Pack mean = Pack(Real(1.0 / 3.0)) * (strain.xx + (strain.yy + strain.zz));
      const Pack two(Real(2));
      const SolidStress<Pack> rate{two * (strain.xx - mean),
                                   two * (strain.yy - mean),
                                   two * (strain.zz - mean),
                                   strain.xy,
                                   strain.yz,
                                   strain.zx};
      TotalStress<Pack> found;
      found.stress = add(Pack(eta * Pack(per_step)), rate, elastic);
      // A viscosity acts as a stiffness over the step: central differences with forces of the last half step
      // are stable up to M dt^2 / 4 + eta_1 dt / 2 of the element's bound, eta_1 = 4/3 eta.
      const Pack stiffness = multiply_add(Pack(Real(8.0 / 3.0)), Pack(eta * Pack(per_step)),
                                          Pack(number(Confined) * larger(modulus, number(LeastModulus))));
      found.wave_square = number(PerDensity) * (volume.now * stiffness);
      return found;
    }
  };
};

}  // namespace crumple::materials
