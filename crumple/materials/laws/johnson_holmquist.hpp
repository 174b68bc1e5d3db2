// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/common/history_view.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/laws/johnson_cook.hpp"
#include "materials/laws/volume_history.hpp"

namespace crumple::materials {

/// What the laws of Johnson & Holmquist for ceramics and for concrete have in common: pressure by the volume,
/// a strength that falls with the damage, erosion (docs/theory/johnson_holmquist.md).
template <class Pack>
struct BrittlePoint {
  using Real = RealOf<Pack>;
  using Mask = MaskOf<Pack>;
  using History = HistoryView<Real>;

  /// Items of the history, one number a point each. Memory is that of the pressure.
  enum Item { Volume, VolumeRest, PlasticStrain, PlasticRest, Damage, Memory, Failed };

  /// The first constants of both laws.
  enum Constant {
    Shear,
    Tension,
    RateCoefficient,
    ReferenceRate,
    PerDensity,
    FailsInTension,
    FailsByDamage,
    FailureStrain,
    FractureFactor,
    FracturePower,
    Bulk,
    BulkQuadratic,
    BulkCubic,
    OwnConstants
  };

  const double* c;
  LogarithmicRate<Real> rate;

  CRUMPLE_INLINE explicit BrittlePoint(const SolidMaterialTask<Real>& task)
      : c(task.constants), rate(c[RateCoefficient], c[ReferenceRate], task.step, false) {}

  CRUMPLE_INLINE Pack number(int place) const { return Pack(static_cast<Real>(c[place])); }
  CRUMPLE_INLINE static Real* one(const History& history, int item) {
    return history.at(item * history.points + history.point);
  }
  CRUMPLE_INLINE bool fails() const { return c[FailsInTension] != 0 || c[FailureStrain] > 0; }
  CRUMPLE_INLINE static Mask intact(const History& history) {
    return load<Pack>(one(history, Failed)) == Pack(Real(0));
  }

  struct Compression {
    Pack volume;  ///< relative
    Pack mu;      ///< 1/volume - 1
  };
  CRUMPLE_INLINE static Compression compress(const History& history, const SolidStrain<Pack>& strain,
                                             const Turn<Pack>& turn) {
    const Pack volume = follow_volume(history, 0, strain, turn).now;
    // From the change itself, that single precision keeps its digits.
    return {volume, -load<Pack>(one(history, Volume)) / volume};
  }

  struct Flow {
    SolidStress<Pack> stress;
    Pack strain;  ///< effective plastic, of the step
  };
  /// The deviator goes back to the strength along its radius; `p` is positive in compression.
  CRUMPLE_INLINE Flow flow(const SolidStress<Pack>& old, const SolidStrain<Pack>& strain, const Pack& p,
                           const Pack& strength, const History& history) const {
    const Pack g = number(Shear);
    const Pack g2 = g + g;
    const Pack mean = mean_stress(old) + g2 * (Pack(Real(1.0 / 3.0)) * (strain.xx + (strain.yy + strain.zz)));
    const SolidStress<Pack> trial{multiply_add(g2, strain.xx, Pack(old.xx)) - mean,
                                  multiply_add(g2, strain.yy, Pack(old.yy)) - mean,
                                  multiply_add(g2, strain.zz, Pack(old.zz)) - mean,
                                  multiply_add(g, strain.xy, old.xy),
                                  multiply_add(g, strain.yz, old.yz),
                                  multiply_add(g, strain.zx, old.zx)};
    const Pack size = square_root(equivalent_square(trial));
    const Mask yields = size > strength;
    const Pack scale = select<Pack>(yields, Pack(strength / size), Pack(Real(1)));
    const Pack over = select<Pack>(yields, Pack((size - strength) / (Pack(Real(3)) * g)), Pack(Real(0)));
    add_kept(one(history, PlasticStrain), one(history, PlasticRest), over);
    return {{multiply_add(scale, trial.xx, Pack(-p)), multiply_add(scale, trial.yy, Pack(-p)),
             multiply_add(scale, trial.zz, Pack(-p)), scale * trial.xy, scale * trial.yz, scale * trial.zx},
            over};
  }

  struct Polynomial {
    Pack value, slope;  ///< the slope over mu is at least K1
  };
  /// K1 mu + K2 mu^2 + K3 mu^3 in compression, K1 mu in tension.
  CRUMPLE_INLINE Polynomial polynomial(const Pack& mu) const {
    const Pack k1 = number(Bulk);
    const Pack k2 = number(BulkQuadratic);
    const Pack k3 = number(BulkCubic);
    const Pack squeezed = larger(mu, Pack(Real(0)));
    const Pack more = squeezed * (squeezed * multiply_add(k3, squeezed, k2));
    const Pack slope =
        multiply_add(squeezed, multiply_add(Pack(Real(3)) * k3, squeezed, Pack(Pack(Real(2)) * k2)), k1);
    return {multiply_add(k1, mu, more), larger(slope, k1)};
  }

  /// Damage by a plastic strain, at most 1.
  CRUMPLE_INLINE static Pack worn(const Pack& damage, const Pack& strain, const Pack& fracture_strain) {
    const Pack least(Real(1e-30));
    return smaller(Pack(damage + strain / larger(fracture_strain, least)), Pack(Real(1)));
  }

  /// Marks the points that fail; `pressure` is the one that there would be without a limit in tension.
  CRUMPLE_INLINE void judge(const Pack& pressure, const Pack& damage, const History& history) const {
    if (!fails()) return;
    const Pack whole(Real(1));
    Mask gone = load<Pack>(one(history, Failed)) > Pack(Real(0));
    if (c[FailsInTension] != 0) {
      const Pack left = c[FailsByDamage] != 0 ? Pack(whole - damage) : whole;
      gone = gone || (pressure < Pack(-(number(Tension) * left)));
    }
    if (c[FailureStrain] > 0)
      gone = gone || (load<Pack>(one(history, PlasticStrain)) > number(FailureStrain));
    store(one(history, Failed), select<Pack>(gone, whole, Pack(Real(0))));
  }

  /// Square of the wave speed, of the slope of the pressure over mu.
  CRUMPLE_INLINE Pack wave_square(const Pack& slope, const Pack& volume) const {
    return number(PerDensity) * multiply_add(Pack(Real(4.0 / 3.0)) * number(Shear), volume, slope);
  }
};

/// Items of the history; `memory` names that of the pressure.
void declare_brittle_history(domain::ElementBlock& block, const char* memory, bool fails);

/// Whether points of this erosion fail.
bool erodes(const model::BrittleErosion& erosion);

/// Throw InputError where the numbers that both laws have are wrong.
void check_brittle(const model::Material& material, const model::BrittleSolid& law);

/// The constants of BrittlePoint, in `count` places.
std::vector<double> brittle_constants(double density, const model::BrittleSolid& law, int count);

/// A limit that no strength reaches, for laws that have none.
constexpr double without_limit = 1e15;

}  // namespace crumple::materials
