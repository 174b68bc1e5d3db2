// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "materials/common/history_view.hpp"
#include "materials/common/plane_stress.hpp"
#include "materials/common/shell_material.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/common/solid_stress.hpp"
#include "materials/eos/eos_point.hpp"

namespace crumple::materials {

/// Of shells mass and a surface for contact, no stress; of solids a fluid: docs/theory/null.md.
struct NullLaw {
  using Model = model::NullMaterial;
  static constexpr const char* name = "null";

  static void declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& /*block*/,
                              Index /*tensor*/) {}
  static std::vector<double> constants(const model::Material& material);
  static std::vector<double> solid_constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }
  static bool solid_can_fail(const model::ConstitutiveLaw& law);
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

  enum Place { Viscosity, Largest, Smallest, Count };

  template <class Pack>
  struct SolidUpdate {
    using Real = RealOf<Pack>;
    using Mask = MaskOf<Pack>;
    static constexpr bool can_yield = false;
    static constexpr bool may_fail = true;
    static constexpr bool takes_equation_of_state = true;
    static constexpr bool has_no_memory = true;

    /// Deviator 2 mu of the strain rate; the equation of state brings the pressure.
    struct Newtonian {
      Real twice;  ///< 2 mu over the step

      CRUMPLE_INLINE SolidStress<Pack> stress(const SolidStress<Pack>& /*old*/,
                                              const SolidStrain<Pack>& strain) const {
        const Pack two(twice);
        const Pack one(Real(0.5) * twice);
        const Pack mean = Pack(Real(1.0 / 3.0)) * (strain.xx + (strain.yy + strain.zz));
        return {two * (strain.xx - mean), two * (strain.yy - mean), two * (strain.zz - mean),
                one * strain.xy,          one * strain.yz,          one * strain.zx};
      }
    };
    Newtonian elasticity;
    const double* eos;
    Real largest;   ///< relative volume
    Real smallest;  ///< relative volume

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : elasticity{task.step > 0 ? static_cast<Real>(2 * task.constants[Viscosity]) / task.step : Real(0)},
          eos(task.equation_of_state),
          largest(static_cast<Real>(task.constants[Largest])),
          smallest(static_cast<Real>(task.constants[Smallest])) {}

    CRUMPLE_INLINE bool fails() const { return largest > 0 || smallest > 0; }
    CRUMPLE_INLINE Mask intact(const HistoryView<Real>& history) const {
      const int at = static_cast<int>(eos[eos_place::history]) + eos_item::volume_change * history.points;
      const Pack volume = Pack(static_cast<Real>(1 + eos[eos_place::initial_excess])) +
                          load<Pack>(history.at(at + history.point));
      const Pack most(largest > 0 ? largest : Real(1e30));
      return (volume < most) && (volume > Pack(smallest));
    }
  };
};

}  // namespace crumple::materials
