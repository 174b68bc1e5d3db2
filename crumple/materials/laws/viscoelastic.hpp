// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/common/deformation.hpp"
#include "materials/common/history_view.hpp"
#include "materials/common/solid_material.hpp"
#include "math/relaxation.hpp"

namespace crumple::materials {

/// Linear viscoelasticity whose moduli relax by sums of exponentials (docs/theory/viscoelastic.md).
struct ViscoelasticLaw {
  using Model = model::Viscoelastic;
  static constexpr const char* name = "viscoelastic";

  /// Largest number of parts of each modulus.
  static constexpr int most_parts = 19;

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }

  /// After Count: modulus and decay, part after part, those of shear first.
  enum Place { ShearParts, BulkParts, Count };

  template <class Pack>
  struct SolidUpdate {
    using Real = RealOf<Pack>;
    using History = HistoryView<Real>;
    static constexpr bool can_yield = false;
    static constexpr bool may_fail = false;

    struct Part {
      Real lost, gained;
    };

    int shear_parts, bulk_parts;
    Part shear[most_parts];
    Part bulk[most_parts];

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : shear_parts(static_cast<int>(task.constants[ShearParts])),
          bulk_parts(static_cast<int>(task.constants[BulkParts])) {
      const double* at = task.constants + Count;
      const auto step = static_cast<double>(task.step);
      const auto take = [&](Part& part) {
        const math::Relaxation of = math::relaxation(at[0], at[1], step);
        part = {static_cast<Real>(of.lost), static_cast<Real>(of.gained)};
        at += 2;
      };
      for (int k = 0; k < shear_parts; ++k) take(shear[k]);
      for (int k = 0; k < bulk_parts; ++k) take(bulk[k]);
    }

    /// Every part turns, relaxes and grows by itself; the stress is their sum.
    CRUMPLE_INLINE SolidStress<Pack> relaxed(const History& history, const SolidStrain<Pack>& strain,
                                             const Turn<Pack>& turn) const {
      const Pack trace = strain.xx + (strain.yy + strain.zz);
      const Pack mean_strain = Pack(Real(1.0 / 3.0)) * trace;
      Pack mean(Real(0));
      const int pressures = 12 * shear_parts * history.points;
      for (int k = 0; k < bulk_parts; ++k) {
        Real* const place = history.at(pressures + bulk_parts * history.point + k);
        Real* const rest = history.at(pressures + bulk_parts * (history.points + history.point) + k);
        const Pack growth = Pack(bulk[k].gained) * trace - Pack(bulk[k].lost) * load<Pack>(place);
        mean = mean + add_kept(place, rest, growth);
      }
      // Twice the deviator of the strain.
      const SolidStrain<Pack> twice{Real(2) * (strain.xx - mean_strain),
                                    Real(2) * (strain.yy - mean_strain),
                                    Real(2) * (strain.zz - mean_strain),
                                    strain.xy,
                                    strain.yz,
                                    strain.zx};
      SolidStress<Pack> now{mean, mean, mean, Pack(Real(0)), Pack(Real(0)), Pack(Real(0))};
      for (int k = 0; k < shear_parts; ++k) add_part(history, k, twice, turn, now);
      return now;
    }

    CRUMPLE_INLINE void add_part(const History& history, int k, const SolidStrain<Pack>& twice,
                                 const Turn<Pack>& turn, SolidStress<Pack>& now) const {
      const int first = 6 * shear_parts * history.point + 6 * k;
      const int rest = first + 6 * shear_parts * history.points;
      const auto old = load_six<SolidStress<Pack>>(history.at(first), lanes);
      const SolidStress<Pack> change = turn_change(old, turn);
      const Pack lost(shear[k].lost);
      const Pack gained(shear[k].gained);
      const auto advance = [&](int component, const Pack& was, const Pack& turning, const Pack& grown,
                               Pack& sum) {
        const Pack growth = turning + multiply_add(gained, grown, Pack(-(lost * (was + turning))));
        sum = sum + add_kept(history.at(first + component), history.at(rest + component), growth);
      };
      advance(0, old.xx, change.xx, twice.xx, now.xx);
      advance(1, old.yy, change.yy, twice.yy, now.yy);
      advance(2, old.zz, change.zz, twice.zz, now.zz);
      advance(3, old.xy, change.xy, twice.xy, now.xy);
      advance(4, old.yz, change.yz, twice.yz, now.yz);
      advance(5, old.zx, change.zx, twice.zx, now.zx);
    }
  };
};

}  // namespace crumple::materials
