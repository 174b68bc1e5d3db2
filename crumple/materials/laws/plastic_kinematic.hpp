// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "materials/plasticity/plane_stress_plasticity.hpp"
#include "materials/plasticity/solid_plasticity.hpp"

namespace crumple::materials {

/// sigma_0 + H strain.
template <class Real>
struct LinearHardening {
  Real initial;
  Real modulus;

  static constexpr bool rough = false;
  static constexpr bool is_linear = true;  ///< for the return of solids, which then has a closed form

  template <class Strain, class Pack>
  CRUMPLE_INLINE Pack aside(const Strain& /*strain*/, const Pack& factor) const {
    return factor;
  }
  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> at(const Pack& strain, const Pack& /*aside*/) const {
    return {multiply_add(Pack(modulus), strain, Pack(initial)), Pack(modulus)};
  }
  CRUMPLE_INLINE bool viscoplastic() const { return false; }
  template <class Pack>
  CRUMPLE_INLINE Pack least(const Pack& /*aside*/) const {
    return Pack(initial);
  }
};

/// J2 plasticity with linear hardening, isotropic by a share beta of the plastic modulus and kinematic by the
/// rest, and the Cowper-Symonds rate effect (docs/theory/plane_stress_plasticity.md,
/// solid_plasticity.md).
struct PlasticKinematicLaw {
  using Model = model::PlasticKinematic;
  static constexpr const char* name = "plastic kinematic";

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law) { return std::get<Model>(law).failure_strain > 0; }

  template <class Plasticity>
  struct UpdateOf : Plasticity {
    using typename Plasticity::Real;

    // constants: E, nu, sigma_0, isotropic modulus, kinematic modulus, C, p, failure strain
    CRUMPLE_INLINE explicit UpdateOf(const typename Plasticity::Task& task)
        : Plasticity(task.constants[0], task.constants[1], task.constants[4],
                     LinearHardening<Real>{static_cast<Real>(task.constants[2]),
                                           static_cast<Real>(task.constants[3])},
                     CowperSymonds<Real>(task.constants[5], task.constants[6], task.step, true),
                     task.constants[7]) {}
  };
  template <class Pack>
  using Update = UpdateOf<PlaneStressPlasticity<Pack, LinearHardening<RealOf<Pack>>>>;
  template <class Pack>
  using SolidUpdate = UpdateOf<SolidPlasticity<Pack, LinearHardening<RealOf<Pack>>>>;
};

}  // namespace crumple::materials
