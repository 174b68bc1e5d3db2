// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/common/history_view.hpp"
#include "materials/common/mixed_mode.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/common/solid_stress.hpp"
#include "math/pack_vec3.hpp"

namespace crumple::materials {

/// Tractions over separations, of cohesive solids alone: docs/theory/cohesive_solids.md. Of the six rows of a
/// point's strain the first three have its separation at the end of the step, along the two tangents and the
/// normal; of its stress xx, yy and zz have the tractions.
struct CohesiveLaw {
  using Model = model::Cohesive;
  static constexpr const char* name = "cohesive";

  enum Place {
    Criterion,
    NormalStiffness,
    ShearStiffness,
    NormalUse,
    ShearUse,
    NormalEnergy,
    ShearEnergy,
    Exponent,
    StiffnessExponent,
    FailedPoints,
    Count
  };

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law);

  template <class Pack>
  struct SolidUpdate {
    using Real = RealOf<Pack>;
    static constexpr bool is_of_separations = true;

    MixedMode<Real> law;
    Real failed_points;

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : failed_points(static_cast<Real>(task.constants[FailedPoints])) {
      const auto number = [&](Place place) { return static_cast<Real>(task.constants[place]); };
      law.criterion =
          static_cast<typename MixedMode<Real>::Criterion>(static_cast<int>(task.constants[Criterion]));
      law.normal_stiffness = number(NormalStiffness);
      law.shear_stiffness = number(ShearStiffness);
      law.normal_use = number(NormalUse);
      law.shear_use = number(ShearUse);
      law.normal_energy = number(NormalEnergy);
      law.shear_energy = number(ShearEnergy);
      law.exponent = number(Exponent);
      law.stiffness_exponent = number(StiffnessExponent);
    }

    /// The tractions at a separation, in xx, yy and zz; brings the damage of the point up to date. Pressure
    /// is borne whatever the damage.
    CRUMPLE_INLINE SolidStress<Pack> traction(const math::PackVec3<Pack>& separation, Real* damage) const {
      const Pack zero(Real(0));
      const Pack opening = larger(separation.z, zero);
      const Pack sliding = multiply_add(separation.x, separation.x, Pack(separation.y * separation.y));
      const Pack now = mixed_mode_damage(law, Pack(opening * opening), sliding, load<Pack>(damage));
      store(damage, now);
      const Pack left = Pack(Real(1)) - now;
      const Pack shear = left * Pack(law.shear_stiffness);
      const Pack normal = select<Pack>(separation.z > zero, left, Pack(Real(1)));
      return {shear * separation.x,
              shear * separation.y,
              normal * (Pack(law.normal_stiffness) * separation.z),
              zero,
              zero,
              zero};
    }

    /// One where an element with so many failed points holds, else zero.
    CRUMPLE_INLINE Pack holds(const Pack& failed) const {
      return select<Pack>(failed < Pack(failed_points), Pack(Real(1)), Pack(Real(0)));
    }
  };
};

}  // namespace crumple::materials
