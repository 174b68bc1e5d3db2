// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "materials/plasticity/plane_stress_plasticity.hpp"
#include "materials/plasticity/solid_plasticity.hpp"

namespace crumple::materials {

/// A table of compression and one of tension over the plastic strain.
template <class Real>
struct CompressionTensionHardening {
  static constexpr bool rough = false;

  PointTable<Real> compression;
  PointTable<Real> tension;
  Real least_stress;  ///< of both

  template <class Strain, class Pack>
  CRUMPLE_INLINE Pack aside(const Strain& /*strain*/, const Pack& /*factor*/) const {
    return Pack(Real(0));
  }
  /// `share` of the tension.
  template <class Pack>
  CRUMPLE_INLINE YieldPoint<Pack> at(const Pack& strain, const Pack& share) const {
    const YieldPoint<Pack> c = compression.at(strain);
    const YieldPoint<Pack> t = tension.at(strain);
    return {multiply_add(share, Pack(t.stress - c.stress), c.stress),
            multiply_add(share, Pack(t.slope - c.slope), c.slope)};
  }
  CRUMPLE_INLINE bool viscoplastic() const { return false; }
  template <class Pack>
  CRUMPLE_INLINE Pack least(const Pack& /*share*/) const {
    return Pack(least_stress);
  }
};

/// J2 plasticity whose yield stress is that of one curve in compression and of another in tension
/// (docs/theory/compression_tension.md).
struct CompressionTensionLaw {
  using Model = model::CompressionTension;
  static constexpr const char* name = "compression-tension plasticity";

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law) { return std::get<Model>(law).failure_strain > 0; }

  /// Places of the constants; the rows of compression follow, then those of tension.
  enum Place {
    Youngs,
    Poissons,
    Start,     ///< mean stress from which on tension has a share
    PerRange,  ///< share over mean stress
    Rate,
    Exponent,
    Failure,
    Least,
    CompressionRows,
    TensionRows,
    Tables
  };

  template <class Pack, class Base>
  struct UpdateOf : Base {
    using typename Base::History;
    using typename Base::Real;
    using typename Base::Strain;
    using typename Base::Stress;
    using typename Base::Task;
    using typename Base::Trial;

    /// The return of shells changes the mean stress, that of solids does not.
    static constexpr bool moves_mean = !requires(Task task) { task.equation_of_state; };

    Real start;
    Real per_range;

    CRUMPLE_INLINE explicit UpdateOf(const Task& task)
        : Base(task.constants[Youngs], task.constants[Poissons], 0, hardening_of(task.constants),
               CowperSymonds<Real>(task.constants[Rate], task.constants[Exponent], task.step, true),
               task.constants[Failure]),
          start(static_cast<Real>(task.constants[Start])),
          per_range(static_cast<Real>(task.constants[PerRange])) {}

    CRUMPLE_INLINE static CompressionTensionHardening<Real> hardening_of(const double* c) {
      const int rows = static_cast<int>(c[CompressionRows]);
      return {{c + Tables, rows},
              {c + Tables + 3 * rows, static_cast<int>(c[TensionRows])},
              static_cast<Real>(c[Least])};
    }

    CRUMPLE_INLINE Pack share_of_tension(const Pack& mean) const {
      const Pack share = Pack(per_range) * (mean - Pack(start));
      return larger(smaller(share, Pack(Real(1))), Pack(Real(0)));
    }

    CRUMPLE_INLINE Trial trial(const Stress& stress, const Strain& strain, const History& history) const {
      Trial t = Base::trial(stress, strain, history);
      const Pack plastic = load<Pack>(Base::plastic_strain(history));
      const Pack mean = mean_stress(stress);
      Pack share = share_of_tension(mean);
      YieldPoint<Pack> yield = this->hardening.at(plastic, share);
      if constexpr (moves_mean) {
        // As if the whole stress were put back along its radius.
        const Pack size = square_root(equivalent_square(stress));
        const Pack left = smaller(Pack(yield.stress / larger(size, Pack(Real(1e-30)))), Pack(Real(1)));
        share = share_of_tension(Pack(left * mean));
        yield = this->hardening.at(plastic, share);
      }
      t.aside = share;
      t.slope = yield.slope;
      t.radius = yield.stress;
      if (this->fails()) t.radius = select<Pack>(this->intact(history), t.radius, Pack(Base::unreachable));
      return t;
    }
  };
  template <class Pack>
  using Update = UpdateOf<Pack, PlaneStressPlasticity<Pack, CompressionTensionHardening<RealOf<Pack>>>>;
  template <class Pack>
  using SolidUpdate = UpdateOf<Pack, SolidPlasticity<Pack, CompressionTensionHardening<RealOf<Pack>>>>;
};

}  // namespace crumple::materials
