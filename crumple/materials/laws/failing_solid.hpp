// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "materials/laws/plastic_kinematic.hpp"
#include "materials/plasticity/solid_plasticity.hpp"

namespace crumple::materials {

/// J2 plasticity with linear hardening of points that fail by plastic strain or tension, and then are gone or
/// bear pressure alone (docs/theory/failing_solid.md).
struct FailingSolidLaw {
  using Model = model::FailingSolid;
  static constexpr const char* name = "elastic-plastic with failure";

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law);

  enum Place { Youngs, Poissons, Yield, Hardening, Failure, Tension, Keeps, Count };

  template <class Pack>
  struct SolidUpdate : SolidPlasticity<Pack, LinearHardening<RealOf<Pack>>> {
    using Base = SolidPlasticity<Pack, LinearHardening<RealOf<Pack>>>;
    using typename Base::History;
    using typename Base::Mask;
    using typename Base::Real;
    using typename Base::Strain;
    using typename Base::Stress;
    using typename Base::Task;

    struct Trial : Base::Trial {
      Mask failed;
    };

    Real tension;  ///< mean stress at which a point fails
    bool keeps;

    CRUMPLE_INLINE explicit SolidUpdate(const Task& task)
        : Base(task.constants[Youngs], task.constants[Poissons], 0,
               LinearHardening<Real>{static_cast<Real>(task.constants[Yield]),
                                     static_cast<Real>(task.constants[Hardening])},
               CowperSymonds<Real>(0, 0, task.step, false), task.constants[Failure]),
          tension(static_cast<Real>(task.constants[Tension])),
          keeps(task.constants[Keeps] != 0) {}

    /// 1 where a point has failed.
    CRUMPLE_INLINE static Real* mark(const History& history) {
      return history.at(2 * history.points + history.point);
    }
    CRUMPLE_INLINE static Mask marked(const History& history) {
      return load<Pack>(mark(history)) > Pack(Real(0));
    }
    CRUMPLE_INLINE static void add_mark(const Mask& failed, const History& history) {
      store(mark(history), select<Pack>(failed, Pack(Real(1)), load<Pack>(mark(history))));
    }

    CRUMPLE_INLINE bool fails() const { return !keeps; }
    CRUMPLE_INLINE Mask intact(const History& history) const {
      return load<Pack>(mark(history)) < Pack(Real(0.5));
    }

    /// The return leaves the mean stress alone, so tension is known before it.
    CRUMPLE_INLINE Trial trial(const Stress& stress, const Strain& strain, const History& history) const {
      add_mark(mean_stress(stress) >= Pack(tension), history);
      const Pack one(Real(1));
      return {Base::trial_with(stress, strain, history, one), marked(history)};
    }

    CRUMPLE_INLINE Mask yields(const Trial& t) const { return Base::yields(t) || t.failed; }

    CRUMPLE_INLINE void correct(Stress& stress, Trial& t, const Mask& mask, const History& history) const {
      const Mask flows = mask && Base::yields(t) && intact(history);
      if (any<Pack>(flows)) Base::correct(stress, t, flows, history);
      if (this->failure > 0)
        add_mark(load<Pack>(Base::plastic_strain(history)) >= Pack(this->failure), history);
      const Mask failed = marked(history);
      if (any<Pack>(failed)) stress = fluid(stress, failed);
    }

    /// Pressure alone where points have failed.
    CRUMPLE_INLINE static Stress fluid(const Stress& stress, const Mask& failed) {
      const Pack zero(Real(0));
      const Pack mean = smaller(mean_stress(stress), zero);
      return {select<Pack>(failed, mean, stress.xx), select<Pack>(failed, mean, stress.yy),
              select<Pack>(failed, mean, stress.zz), select<Pack>(failed, zero, stress.xy),
              select<Pack>(failed, zero, stress.yz), select<Pack>(failed, zero, stress.zx)};
    }
  };
};

}  // namespace crumple::materials
