// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/common/plane_stress.hpp"
#include "materials/common/shell_material.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/common/solid_stress.hpp"

namespace crumple::materials {

/// Linear isotropic elasticity, in plane stress and in three dimensions (docs/theory/elastic.md).
struct ElasticLaw {
  using Model = model::Elastic;
  static constexpr const char* name = "elastic";

  static void declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& /*block*/,
                              Index /*tensor*/) {}
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }

  template <class Pack>
  struct Update {
    using Real = RealOf<Pack>;
    struct Trial {};
    static constexpr bool can_yield = false;
    static constexpr bool may_fail = false;

    PlaneStressElasticity<Real> elasticity;

    CRUMPLE_INLINE explicit Update(const MaterialTask<Real>& task)
        : elasticity(task.constants[0], task.constants[1]) {}
  };

  template <class Pack>
  struct SolidUpdate {
    using Real = RealOf<Pack>;
    static constexpr bool can_yield = false;
    static constexpr bool may_fail = false;

    SolidElasticity<Real> elasticity;

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : elasticity(task.constants[0], task.constants[1]) {}
  };
};

}  // namespace crumple::materials
