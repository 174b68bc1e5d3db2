// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "materials/plane_stress_plasticity.hpp"

namespace crumple::materials {

/// Yield stress interpolated in a table, constant beyond its end.
template <class Real>
struct TabulatedHardening {
  const double* rows;  ///< plastic strain, yield stress and slope to the next row, from zero strain on
  int count;
  Real least_stress;

  /// Tables are short and plastic strains small: walking up from the first row is as fast as a search, and
  /// stops where no lane is further.
  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> at(const Pack& strain) const {
    Pack from(static_cast<Real>(rows[0]));
    Pack stress(static_cast<Real>(rows[1]));
    Pack slope(static_cast<Real>(rows[2]));
    for (int k = 1; k < count; ++k) {
      const Pack start(static_cast<Real>(rows[3 * k]));
      const auto beyond = strain >= start;
      if (!any<Pack>(beyond)) break;
      from = select<Pack>(beyond, start, from);
      stress = select<Pack>(beyond, Pack(static_cast<Real>(rows[3 * k + 1])), stress);
      slope = select<Pack>(beyond, Pack(static_cast<Real>(rows[3 * k + 2])), slope);
    }
    return {multiply_add(slope, Pack(strain - from), stress), slope};
  }
  CRUMPLE_INLINE Real least() const { return least_stress; }
};

/// J2 plasticity with tabulated isotropic hardening and the Cowper-Symonds rate effect
/// (docs/theory/plane_stress_plasticity.md).
struct PiecewiseLinearPlasticityLaw {
  using Model = model::PiecewiseLinearPlasticity;
  static constexpr const char* name = "piecewise linear plasticity";

  static void declare_history(const model::ConstitutiveLaw& law, domain::ShellBlock& block);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law) { return std::get<Model>(law).failure_strain > 0; }

  template <class Pack>
  struct Update : PlaneStressPlasticity<Pack, TabulatedHardening<RealOf<Pack>>> {
    using Real = RealOf<Pack>;
    using Hardening = TabulatedHardening<Real>;

    // constants: E, nu, C, p, failure strain, least yield stress, number of rows, rows
    CRUMPLE_INLINE explicit Update(const MaterialTask<Real>& task)
        : PlaneStressPlasticity<Pack, Hardening>(
              task.constants[0], task.constants[1], 0,
              Hardening{task.constants + 7, static_cast<int>(task.constants[6]),
                        static_cast<Real>(task.constants[5])},
              CowperSymonds<Real>(task.constants[2], task.constants[3], task.step), task.constants[4]) {}
  };
};

}  // namespace crumple::materials
