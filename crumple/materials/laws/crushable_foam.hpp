// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/common/deformation.hpp"
#include "materials/common/history_view.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/plasticity/principal.hpp"

namespace crumple::materials {

/// Foam whose principal stresses are bounded one by one (docs/theory/crushable_foam.md).
struct CrushableFoamLaw {
  using Model = model::CrushableFoam;
  static constexpr const char* name = "crushable foam";

  static void declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                              Index /*tensor*/) {
    domain::add_item(block, "volume_change", "-", block.points);
    domain::add_item(block, "volume_rest", "-", block.points);
  }
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }
  static double linear_viscosity(const model::ConstitutiveLaw& law) { return std::get<Model>(law).damping; }

  /// After Count: crush, yield stress and slope behind it, point after point.
  enum Place { Youngs, Tension, Points, Count };

  template <class Pack>
  struct SolidUpdate {
    using Real = RealOf<Pack>;
    using Mask = MaskOf<Pack>;
    using History = HistoryView<Real>;
    static constexpr bool can_yield = true;
    static constexpr bool may_fail = false;

    struct Trial {
      Principal<Pack> stress;
      Pack bounded[3];
      Mask outside;
    };

    const double* c;
    SolidElasticity<Real> elasticity;
    Real tension;

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : c(task.constants),
          elasticity(task.constants[Youngs], 0),
          tension(static_cast<Real>(task.constants[Tension])) {}

    CRUMPLE_INLINE void follow(const History& history, const SolidStrain<Pack>& strain,
                               const Turn<Pack>& turn) const {
      Real* const change = history.at(history.point);
      const Pack volume = Pack(Real(1)) + load<Pack>(change);
      add_kept(change, history.at(history.points + history.point),
               Pack(volume * volume_growth(step_gradient(strain, turn))));
    }
    CRUMPLE_INLINE static void turn_history(const History& /*history*/, const Turn<Pack>& /*turn*/) {}

    CRUMPLE_INLINE Pack yield_stress(const Pack& crush) const {
      const int points = static_cast<int>(c[Points]);
      const double* at = c + Count;
      Pack found(static_cast<Real>(at[1]));
      for (int k = 0; k < points; ++k, at += 3) {
        const Pack from(static_cast<Real>(at[0]));
        const Pack stress =
            multiply_add(Pack(static_cast<Real>(at[2])), Pack(crush - from), Pack(static_cast<Real>(at[1])));
        found = select<Pack>(crush > from, stress, found);
      }
      return found;
    }

    CRUMPLE_INLINE Trial trial(const SolidStress<Pack>& stress, const SolidStrain<Pack>& /*strain*/,
                               const History& history) const {
      Trial t{};
      t.stress = principal(stress);
      const Pack least = -yield_stress(Pack(-load<Pack>(history.at(history.point))));
      const Pack largest(tension);
      t.outside = t.stress.value[0] != t.stress.value[0];
      for (int k = 0; k < 3; ++k) {
        const Pack& value = t.stress.value[k];
        t.bounded[k] = smaller(larger(value, least), largest);
        t.outside = t.outside || (value > largest) || (value < least);
      }
      return t;
    }
    CRUMPLE_INLINE Mask yields(const Trial& t) const { return t.outside; }

    CRUMPLE_INLINE void correct(SolidStress<Pack>& stress, Trial& t, const Mask& mask,
                                const History& /*history*/) const {
      const SolidStress<Pack> now = in_axes(t.stress, t.bounded);
      stress = {select<Pack>(mask, now.xx, stress.xx), select<Pack>(mask, now.yy, stress.yy),
                select<Pack>(mask, now.zz, stress.zz), select<Pack>(mask, now.xy, stress.xy),
                select<Pack>(mask, now.yz, stress.yz), select<Pack>(mask, now.zx, stress.zx)};
    }
  };
};

}  // namespace crumple::materials
