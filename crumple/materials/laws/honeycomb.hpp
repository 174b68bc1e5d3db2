// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>
#include <vector>

#include "materials/laws/total_deformation.hpp"
#include "materials/laws/volume_history.hpp"
#include "materials/plasticity/yield_point.hpp"

namespace crumple::materials {

/// Honeycomb whose six stresses are uncoupled until it is compacted (docs/theory/honeycomb.md).
struct HoneycombLaw {
  using Model = model::Honeycomb;
  static constexpr const char* name = "honeycomb";
  static constexpr bool wave_speed_varies = true;

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static void prepare_solid_element(const model::ConstitutiveLaw& law, const SolidCorners& corners,
                                    UserId solid, domain::ElementBlock& block, Index history, Index place);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law) {
    const auto& own = std::get<Model>(law);
    return own.failure_tension > 0 || own.failure_shear > 0;
  }
  static bool own_viscosity(const model::ConstitutiveLaw& law) {
    return !std::get<Model>(law).standard_viscosity;
  }
  static double linear_viscosity(const model::ConstitutiveLaw& law) {
    return own_viscosity(law) ? std::get<Model>(law).viscosity : 0;
  }
  static double stiffness_share(const model::ConstitutiveLaw& law) {
    return model::stiffness_share(std::get<Model>(law));
  }

  static bool follows_strains(const model::ConstitutiveLaw& law) {
    return can_fail(law) || std::get<Model>(law).over != Model::Abscissa::Volume;
  }

  /// Tables and RateTables have first number and points of a table of each of the six components; they follow
  /// after Count.
  enum Place {
    Youngs,
    Poisson,
    Yield,
    CompactedVolume,
    StiffnessJump,
    PerDensity,
    Tension,
    Shear,
    Over,  ///< a model::Honeycomb::Abscissa
    Moduli,
    Tables = Moduli + 6,
    RateTables = Tables + 12,
    OwnRates = RateTables + 12,  ///< 1 where they are over the rate of their own component
    Count
  };

  template <class Pack>
  struct SolidUpdate {
    using Real = RealOf<Pack>;
    using Mask = MaskOf<Pack>;
    using History = HistoryView<Real>;
    static constexpr bool can_yield = false;
    static constexpr bool may_fail = true;

    /// aa, bb, cc, ab, bc, ca.
    struct Six {
      Pack of[6];
    };

    const double* c;
    SolidElasticity<Real> compacted;
    Real per_step;  ///< 1 / dt; 0 without a step

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : c(task.constants),
          compacted(task.constants[Youngs], task.constants[Poisson]),
          per_step(task.step > 0 ? Real(1) / task.step : Real(0)) {}

    CRUMPLE_INLINE Pack number(int place) const { return Pack(static_cast<Real>(c[place])); }
    CRUMPLE_INLINE static Real* failed(const History& history) {
      return history.at(26 * history.points + history.point);
    }
    CRUMPLE_INLINE bool fails() const { return c[Tension] > 0 || c[Shear] > 0; }
    CRUMPLE_INLINE bool over(Model::Abscissa abscissa) const { return c[Over] == static_cast<int>(abscissa); }
    CRUMPLE_INLINE Mask intact(const History& history) const {
      return load<Pack>(failed(history)) == Pack(Real(0));
    }

    /// Turns the axes with the step. Rows a, b and c, less the unit matrix.
    CRUMPLE_INLINE static Turn<Pack> axes(const History& history, const Turn<Pack>& d) {
      Pack axis[2][3];
      for (int v = 0; v < 2; ++v) {
        const int first = 6 * history.point + 3 * v;
        const int rest = first + 6 * history.points;
        const auto old = [&](int k) { return load<Pack>(history.at(first + k)); };
        const Pack x = old(0);
        const Pack y = old(1);
        const Pack z = old(2);
        const Pack growth[3] = {multiply_add(d.xx, x, multiply_add(d.xy, y, Pack(d.xz * z))),
                                multiply_add(d.yx, x, multiply_add(d.yy, y, Pack(d.yz * z))),
                                multiply_add(d.zx, x, multiply_add(d.zy, y, Pack(d.zz * z)))};
        for (int k = 0; k < 3; ++k)
          axis[v][k] = add_kept(history.at(first + k), history.at(rest + k), growth[k]);
      }
      const auto dot = [](const Pack(&a)[3], const Pack(&b)[3]) {
        return multiply_add(a[0], b[0], multiply_add(a[1], b[1], Pack(a[2] * b[2])));
      };
      // What rounding has left of lengths and of the right angle.
      const Pack one(Real(1));
      const Pack over = one / square_root(dot(axis[0], axis[0]));
      for (Pack& component : axis[0]) component = over * component;
      const Pack lean = dot(axis[0], axis[1]);
      for (int k = 0; k < 3; ++k) axis[1][k] = axis[1][k] - lean * axis[0][k];
      const Pack over_b = one / square_root(dot(axis[1], axis[1]));
      for (Pack& component : axis[1]) component = over_b * component;
      const Pack(&a)[3] = axis[0];
      const Pack(&b)[3] = axis[1];
      return {a[0] - one,
              a[1],
              a[2],
              b[0],
              b[1] - one,
              b[2],
              a[1] * b[2] - a[2] * b[1],
              a[2] * b[0] - a[0] * b[2],
              a[0] * b[1] - a[1] * b[0] - one};
    }
    CRUMPLE_INLINE static Turn<Pack> transposed(const Turn<Pack>& q) {
      return {q.xx, q.yx, q.zx, q.xy, q.yy, q.zy, q.xz, q.yz, q.zz};
    }
    CRUMPLE_INLINE static Six in_material(const SolidStress<Pack>& s, const Turn<Pack>& q) {
      const SolidStress<Pack> local = turned(s, q);
      return {{local.xx, local.yy, local.zz, local.xy, local.yz, local.zx}};
    }

    CRUMPLE_INLINE PointTable<Real> table(int place) const {
      return {c + static_cast<int>(c[place]), static_cast<int>(c[place + 1])};
    }
    CRUMPLE_INLINE Pack rate_factor(int k, const Pack& rate) const {
      const PointTable<Real> factors = table(RateTables + 2 * k);
      if (factors.count == 0) return Pack(Real(1));
      return factors.at(larger(rate, Pack(static_cast<Real>(factors.rows[0])))).stress;
    }
    /// Factors of the six yield stresses; `own` is the step's strain in the material axes.
    CRUMPLE_INLINE Six rate_factors(const SolidStrain<Pack>& strain, const Six& own) const {
      Six found{};
      if (c[OwnRates] > 0) {
        for (int k = 0; k < 6; ++k) found.of[k] = rate_factor(k, Pack(Pack(per_step) * absolute(own.of[k])));
        return found;
      }
      // The norm of the deviator is sqrt(3/2) of the effective strain.
      const Pack rate = Pack(per_step * Real(1.2247448713915890)) * effective_strain(strain);
      const Pack factor = rate_factor(0, rate);
      for (Pack& one : found.of) one = factor;
      return found;
    }

    /// Modulus of a component, `share` of the way from the uncompacted to the compacted one.
    CRUMPLE_INLINE Pack modulus(int k, const Pack& share) const {
      const Pack start = number(Moduli + k);
      const Pack full(k < 3 ? static_cast<Real>(c[Youngs]) : compacted.shear);
      return multiply_add(share, Pack(full - start), start);
    }
    /// No wave is stiffer.
    CRUMPLE_INLINE Pack largest_stiffness(const Pack& share) const {
      Pack direct = modulus(0, share);
      for (int k = 1; k < 6; ++k) {
        const Pack other = modulus(k, share);
        direct = larger(direct, k < 3 ? other : Pack(other + other));
      }
      return multiply_add(share, number(StiffnessJump), direct);
    }

    /// Abscissae of the six curves.
    CRUMPLE_INLINE Six abscissae(const Six& strain, const Pack& crush) const {
      Six found{};
      for (int k = 0; k < 6; ++k)
        found.of[k] = over(Model::Abscissa::Volume) ? crush
                      : k < 3                       ? Pack(-strain.of[k])
                                                    : absolute(strain.of[k]);
      return found;
    }

    CRUMPLE_INLINE Six uncompacted(const Six& old, const Six& strain, const Six& abscissa, const Pack& share,
                                   const Six& factor) const {
      Six found{};
      for (int k = 0; k < 6; ++k) {
        const Pack trial = multiply_add(modulus(k, share), strain.of[k], old.of[k]);
        const Pack yield = table(Tables + 2 * k).at(abscissa.of[k]).stress;
        const Pack bound = factor.of[k] * larger(yield, Pack(Real(0)));
        found.of[k] = smaller(larger(trial, Pack(-bound)), bound);
      }
      return found;
    }

    /// Elastic and perfectly plastic, of von Mises: the deviator is scaled back to the yield stress.
    CRUMPLE_INLINE Six solid(const SolidStress<Pack>& old, const SolidStrain<Pack>& strain) const {
      const SolidStress<Pack> trial = compacted.stress(old, strain);
      const Pack yield = number(Yield);
      const Pack size = square_root(equivalent_square(trial));
      const Pack scale = select<Pack>(size > yield, Pack(yield / larger(size, yield)), Pack(Real(1)));
      const Pack mean = mean_stress(trial);
      return {{multiply_add(scale, Pack(trial.xx - mean), mean),
               multiply_add(scale, Pack(trial.yy - mean), mean),
               multiply_add(scale, Pack(trial.zz - mean), mean), scale * trial.xy, scale * trial.yz,
               scale * trial.zx}};
    }

    /// Adds the step's strains to those of the six components.
    CRUMPLE_INLINE Six follow_strains(const Six& step, const History& history) const {
      Six now{};
      for (int k = 0; k < 6; ++k) {
        Real* const sum = history.at(14 * history.points + 6 * history.point + k);
        Real* const rest = history.at(20 * history.points + 6 * history.point + k);
        Pack growth = step.of[k];
        // The step's strain is its change of length over the length in its middle.
        if (k < 3 && over(Model::Abscissa::NominalStrain))
          growth = growth * (Pack(Real(1)) + load<Pack>(sum)) / (Pack(Real(1)) - Pack(Real(0.5)) * growth);
        now.of[k] = add_kept(sum, rest, growth);
      }
      return now;
    }

    CRUMPLE_INLINE void fail(const Six& strain, const History& history) const {
      Pack tension(Real(0));
      Pack shear(Real(0));
      for (int k = 0; k < 3; ++k) tension = larger(tension, strain.of[k]);
      for (int k = 3; k < 6; ++k) shear = larger(shear, absolute(strain.of[k]));
      Pack mark = load<Pack>(failed(history));
      if (c[Tension] > 0) mark = select<Pack>(tension > number(Tension), Pack(Real(1)), mark);
      if (c[Shear] > 0) mark = select<Pack>(shear > number(Shear), Pack(Real(1)), mark);
      store(failed(history), mark);
    }

    /// `old` has been turned to the end of the step.
    CRUMPLE_INLINE TotalStress<Pack> updated(const SolidStress<Pack>& old, const SolidStrain<Pack>& strain,
                                             const Turn<Pack>& turn, const History& history) const {
      const Pack zero(Real(0));
      const Pack one(Real(1));
      const Pack half(Real(0.5));
      const Pack two(Real(2));
      const Volumes<Pack> volume = follow_volume(history, 12, strain, turn);
      const Turn<Pack> q = axes(history, turn);
      const Six old_stress = in_material(old, q);
      const Six tensor = in_material(
          {strain.xx, strain.yy, strain.zz, half * strain.xy, half * strain.yz, half * strain.zx}, q);
      const Six e{{tensor.of[0], tensor.of[1], tensor.of[2], two * tensor.of[3], two * tensor.of[4],
                   two * tensor.of[5]}};
      const Pack crush = one - volume.now;
      const Pack limit = number(CompactedVolume);
      const auto share_at = [&](const Pack& at) {
        return smaller(larger(Pack(at / (one - limit)), zero), one);
      };
      // The moduli are those of the middle of the step, as its strains are.
      const Pack middle = one - half * (volume.old + volume.now);
      Six sum{};
      if (fails() || !over(Model::Abscissa::Volume)) sum = follow_strains(e, history);
      const Six open =
          uncompacted(old_stress, e, abscissae(sum, crush), share_at(middle), rate_factors(strain, e));
      const auto& o = old_stress.of;
      const Six closed =
          solid({o[0], o[1], o[2], o[3], o[4], o[5]}, {e.of[0], e.of[1], e.of[2], e.of[3], e.of[4], e.of[5]});
      if (fails()) fail(sum, history);
      const Mask is_closed = volume.now <= limit;
      const auto pick = [&](int k) { return select<Pack>(is_closed, closed.of[k], open.of[k]); };
      TotalStress<Pack> found;
      found.stress =
          turned(SolidStress<Pack>{pick(0), pick(1), pick(2), pick(3), pick(4), pick(5)}, transposed(q));
      found.wave_square = number(PerDensity) * (volume.now * largest_stiffness(share_at(crush)));
      return found;
    }
  };
};

}  // namespace crumple::materials
