// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "materials/plasticity/solid_plasticity.hpp"

namespace crumple::materials {

/// A table over the plastic strain, raised by the pressure.
template <class Real>
struct HydroHardening {
  static constexpr bool rough = false;

  PointTable<Real> table;
  Real least_stress;  ///< of the table
  Real floor;         ///< lower bound of the yield stress, that stresses over it stay numbers

  template <class Strain, class Pack>
  CRUMPLE_INLINE Pack aside(const Strain& /*strain*/, const Pack& /*factor*/) const {
    return Pack(Real(0));
  }
  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> at(const Pack& strain, const Pack& raise) const {
    const YieldPoint<Pack> found = table.at(strain);
    const Pack stress = found.stress + raise;
    const Pack bound(floor);
    return {larger(stress, bound), select<Pack>(stress > bound, found.slope, Pack(Real(0)))};
  }
  CRUMPLE_INLINE bool viscoplastic() const { return false; }
  template <class Pack>
  CRUMPLE_INLINE Pack least(const Pack& raise) const {
    return larger(Pack(Pack(least_stress) + raise), Pack(floor));
  }
};

/// J2 plasticity of solids whose pressure is that of an equation of state, with a yield stress that may rise
/// with it (docs/theory/elastic_plastic_hydro.md).
struct HydroPlasticityLaw {
  using Model = model::HydroPlasticity;
  static constexpr const char* name = "elastic-plastic hydrodynamic";

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law) { return std::get<Model>(law).failure_strain > 0; }

  /// Places of the constants; the rows of the table follow.
  enum Place { Youngs, Poissons, PressureFactor, PressureSquare, Failure, Least, Floor, Rows, Table };

  template <class Pack>
  struct SolidUpdate : SolidPlasticity<Pack, HydroHardening<RealOf<Pack>>> {
    using Base = SolidPlasticity<Pack, HydroHardening<RealOf<Pack>>>;
    using typename Base::History;
    using typename Base::Real;
    using typename Base::Strain;
    using typename Base::Stress;
    using typename Base::Task;
    using typename Base::Trial;

    static constexpr bool takes_equation_of_state = true;

    Real pressure_factor;
    Real pressure_square;

    CRUMPLE_INLINE explicit SolidUpdate(const Task& task)
        : Base(task.constants[Youngs], task.constants[Poissons], 0, hardening_of(task.constants),
               CowperSymonds<Real>(0, 0, task.step, false), task.constants[Failure]),
          pressure_factor(static_cast<Real>(task.constants[PressureFactor])),
          pressure_square(static_cast<Real>(task.constants[PressureSquare])) {
      if (task.equation_of_state != nullptr) this->elasticity.drop_pressure();
    }

    CRUMPLE_INLINE static HydroHardening<Real> hardening_of(const double* c) {
      return {
          {c + Table, static_cast<int>(c[Rows])}, static_cast<Real>(c[Least]), static_cast<Real>(c[Floor])};
    }

    /// The pressure is that of the start of the step: the equation of state needs the deviator first.
    CRUMPLE_INLINE Trial trial(const Stress& stress, const Strain& strain, const History& history) const {
      Trial t = Base::trial(stress, strain, history);
      if (pressure_factor == 0 && pressure_square == 0) return t;
      const Pack pressure = larger(Pack(-mean_stress(stress)), Pack(Real(0)));
      t.aside = pressure * multiply_add(Pack(pressure_square), pressure, Pack(pressure_factor));
      t.radius = larger(Pack(t.radius + t.aside), Pack(this->hardening.floor));
      return t;
    }
  };
};

}  // namespace crumple::materials
