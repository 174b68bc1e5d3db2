// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/plane_stress.hpp"
#include "materials/shell_material.hpp"

namespace crumple::materials {

/// Mass and a surface for contact, no stress: docs/theory/null.md.
struct NullLaw {
  using Model = model::NullMaterial;
  static constexpr const char* name = "null";

  static void declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& /*block*/,
                              Index /*tensor*/) {}
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }
  static constexpr bool has_stiffness = false;

  template <class Pack>
  struct Update {
    using Real = RealOf<Pack>;
    struct Trial {};
    static constexpr bool can_yield = false;
    static constexpr bool may_fail = false;

    struct NoElasticity {
      Real lateral = 0;
      CRUMPLE_INLINE PlaneStress<Pack> stress(const PlaneStress<Pack>& old,
                                              const PlaneStrain<Pack>& /*strain*/) const {
        return old;
      }
    };
    NoElasticity elasticity;

    CRUMPLE_INLINE explicit Update(const MaterialTask<Real>& /*task*/) {}
  };
};

}  // namespace crumple::materials
