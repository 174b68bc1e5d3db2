// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "materials/plasticity/plane_stress_plasticity.hpp"
#include "materials/plasticity/solid_plasticity.hpp"

namespace crumple::materials {

/// k (e_y + p)^n.
template <class Real>
struct PowerHardening {
  static constexpr bool rough = true;

  Real strength;
  Real exponent;
  Real yield_strain;
  Real initial;  ///< k e_y^n

  template <class Strain, class Pack>
  CRUMPLE_INLINE Pack aside(const Strain& /*strain*/, const Pack& factor) const {
    return factor;
  }
  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> at(const Pack& strain, const Pack& /*aside*/) const {
    return power_point(strength, exponent, yield_strain, strain);
  }
  CRUMPLE_INLINE bool viscoplastic() const { return false; }
  template <class Pack>
  CRUMPLE_INLINE Pack least(const Pack& /*aside*/) const {
    return Pack(initial);
  }
};

/// J2 plasticity with a power of the strain as yield stress and the Cowper-Symonds rate effect
/// (docs/theory/plane_stress_plasticity.md).
struct PowerLawPlasticityLaw {
  using Model = model::PowerLawPlasticity;
  static constexpr const char* name = "power law plasticity";

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law) { return std::get<Model>(law).failure_strain > 0; }

  template <class Plasticity>
  struct UpdateOf : Plasticity {
    using typename Plasticity::Real;
    using Hardening = PowerHardening<Real>;

    // constants: E, nu, k, n, e_y, initial yield stress, C, p, failure strain
    CRUMPLE_INLINE explicit UpdateOf(const typename Plasticity::Task& task)
        : Plasticity(task.constants[0], task.constants[1], 0,
                     Hardening{static_cast<Real>(task.constants[2]), static_cast<Real>(task.constants[3]),
                               static_cast<Real>(task.constants[4]), static_cast<Real>(task.constants[5])},
                     CowperSymonds<Real>(task.constants[6], task.constants[7], task.step, true),
                     task.constants[8]) {}
  };
  template <class Pack>
  using Update = UpdateOf<PlaneStressPlasticity<Pack, PowerHardening<RealOf<Pack>>>>;
  template <class Pack>
  using SolidUpdate = UpdateOf<SolidPlasticity<Pack, PowerHardening<RealOf<Pack>>>>;
};

}  // namespace crumple::materials
