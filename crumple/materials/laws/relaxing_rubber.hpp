// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/common/checks.hpp"
#include "materials/laws/ogden_rubber.hpp"
#include "materials/laws/polynomial_rubber.hpp"
#include "materials/laws/viscoelastic.hpp"

namespace crumple::materials {

/// A rubber with a stress beside its own that relaxes, by a Prony series of shear moduli
/// (docs/theory/rubber.md).
template <class Rubber>
struct RelaxingRubberLaw : Rubber {
  using Model = typename Rubber::Model;

  static bool takes(const model::ConstitutiveLaw& law) { return !std::get<Model>(law).relaxing.empty(); }
  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor) {
    Rubber::declare_history(law, block, tensor);
    const auto terms = static_cast<Index>(std::get<Model>(law).relaxing.size());
    domain::add_item(block, "relaxing_stress", "stress", 6 * terms * block.points);
    domain::add_item(block, "relaxing_stress_rest", "stress", 6 * terms * block.points);
  }
  /// The number of those of the series; the series as of ViscoelasticLaw; the rubber's.
  static std::vector<double> constants(const model::Material& material) {
    const auto& series = std::get<Model>(material.law).relaxing;
    require(series.size() <= ViscoelasticLaw::most_parts, material, "its series has too many terms");
    std::vector<double> numbers{0, static_cast<double>(series.size()), 0};
    for (const model::Relaxation& term : series) {
      require(term.modulus > 0 && term.decay >= 0, material,
              "the moduli of its series must be above zero, the decay constants not below");
      numbers.insert(numbers.end(), {term.modulus, term.decay});
    }
    numbers[0] = static_cast<double>(numbers.size());
    const std::vector<double> rest = Rubber::constants(material);
    numbers.insert(numbers.end(), rest.begin(), rest.end());
    return numbers;
  }

  template <class Pack>
  struct SolidUpdate : Rubber::template SolidUpdate<Pack> {
    using Base = typename Rubber::template SolidUpdate<Pack>;
    using Real = RealOf<Pack>;
    using Series = ViscoelasticLaw::SolidUpdate<Pack>;

    Series series;
    Real stiffness;  ///< 4/3 of the sum of the moduli, over the density at rest

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : Base(shifted(task, static_cast<int>(task.constants[0]))), series(shifted(task, 1)), stiffness(0) {
      for (int k = 0; k < series.shear_parts; ++k)
        stiffness += static_cast<Real>(4.0 / 3.0 * task.constants[3 + 2 * k]);
      stiffness *= static_cast<Real>(this->c[Rubber::PerDensity]);
    }
    CRUMPLE_INLINE static SolidMaterialTask<Real> shifted(SolidMaterialTask<Real> task, int by) {
      task.constants += by;
      return task;
    }

    using Base::total;
    CRUMPLE_INLINE TotalStress<Pack> total(const Turn<Pack>& deformation, const HistoryView<Real>& history,
                                           const SolidStrain<Pack>& strain, const Turn<Pack>& turn) const {
      TotalStress<Pack> sum = Base::total(deformation);
      const HistoryView<Real> own{history.at(18 * history.points), history.points, history.point};
      const SolidStress<Pack> more = series.relaxed(own, turned_on(strain, turn), turn);
      sum.stress = {sum.stress.xx + more.xx, sum.stress.yy + more.yy, sum.stress.zz + more.zz,
                    sum.stress.xy + more.xy, sum.stress.yz + more.yz, sum.stress.zx + more.zx};
      const Pack volume = Pack(Real(1)) + volume_excess(deformation);
      sum.wave_square = multiply_add(Pack(stiffness), volume, sum.wave_square);
      return sum;
    }
  };
};

using RelaxingOgdenLaw = RelaxingRubberLaw<OgdenRubberLaw>;
using RelaxingPolynomialLaw = RelaxingRubberLaw<PolynomialRubberLaw>;

}  // namespace crumple::materials
