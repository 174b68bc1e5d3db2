// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "materials/common/deformation.hpp"
#include "materials/laws/ply_update.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Modes of a LaminatedFabricLaw, each with its damage.
namespace fabric_mode {
inline constexpr int tension_a = 0;
inline constexpr int compression_a = 1;
inline constexpr int tension_b = 2;
inline constexpr int compression_b = 3;
inline constexpr int shear = 4;
inline constexpr int count = 5;
}  // namespace fabric_mode

/// Plies that lose stiffness by damage along, across and in shear, after A. Matzenmiller, J. Lubliner & R.L.
/// Taylor, Mechanics of Materials 20 (1995) 125-152 (docs/theory/laminated_fabric.md).
struct LaminatedFabricLaw {
  using Model = model::LaminatedFabric;
  static constexpr const char* name = "laminated fabric";
  static constexpr bool updates_packs = true;

  /// Numbers of each mode among the constants: Bound is the share of the strength that is left, Peak the
  /// drive at the strength.
  enum OfMode { OverStrength, Exponent, Rate /* -log2(e) / (m e) */, Bound, Peak, PerMode };

  /// Those of the elastic law go before.
  enum Place {
    YoungsA = OrthotropicElasticLaw::Count,
    YoungsB,
    PoissonAb,
    PoissonBa,
    Erosion,
    Surface,      ///< as FS: -1, 0, 1
    FirstShear,   ///< where the shear goes on in a straight line: strain; 0: it does not
    FirstStress,  ///< and stress
    LastShear,    ///< end of the line: strain at the strength
    LineSlope,    ///< of the line [stress]
    LineBound,    ///< stress behind it
    Modes,
    Count = Modes + PerMode * fabric_mode::count
  };

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law) { return std::get<Model>(law).erosion_strain > 0; }
  static void prepare_element(const model::ConstitutiveLaw& law, const LaminaAxes& axes,
                              domain::ElementBlock& block, Index history, Index place);

  template <class Pack>
  struct Update;
};

template <class Pack>
struct LaminatedFabricLaw::Update : OrthotropicElasticLaw::Update<Pack> {
  using Real = RealOf<Pack>;
  using Mask = MaskOf<Pack>;
  using History = HistoryView<Real>;
  using Ply = PlyPlane<Pack>;
  using Elastic = OrthotropicElasticLaw::Update<Pack>;

  CRUMPLE_INLINE explicit Update(const MaterialTask<Real>& task) : Elastic(task) {}

  CRUMPLE_INLINE Real real(int place) const { return static_cast<Real>(this->c[place]); }

  // The history: axis, drives of the modes, damage, whether the point is gone, strains.
  CRUMPLE_INLINE static Real* drive(const History& history, int mode) {
    return history.at(2 + fabric_mode::count * history.point + mode);
  }
  CRUMPLE_INLINE static Real* damage(const History& history, int component) {
    return history.at(2 + fabric_mode::count * history.points + 3 * history.point + component);
  }
  CRUMPLE_INLINE static Real* gone(const History& history) {
    return history.at(2 + (fabric_mode::count + 3) * history.points + history.point);
  }
  CRUMPLE_INLINE static Real* strain(const History& history, int component) {
    return history.at(2 + (fabric_mode::count + 4) * history.points + 3 * history.point + component);
  }

  /// Numbers of a mode, which may differ from element to element.
  struct Mode {
    Pack over_strength, exponent, rate, bound, peak;
  };
  CRUMPLE_INLINE Pack over_strength(int mode) const {
    return Pack(real(Modes + PerMode * mode + OverStrength));
  }
  CRUMPLE_INLINE Mode mode(int which) const {
    const int at = Modes + PerMode * which;
    return {Pack(real(at + OverStrength)), Pack(real(at + Exponent)), Pack(real(at + Rate)),
            Pack(real(at + Bound)), Pack(real(at + Peak))};
  }
  CRUMPLE_INLINE static Mode chosen(const Mask& mask, const Mode& a, const Mode& b) {
    return {select<Pack>(mask, a.over_strength, b.over_strength), select<Pack>(mask, a.exponent, b.exponent),
            select<Pack>(mask, a.rate, b.rate), select<Pack>(mask, a.bound, b.bound),
            select<Pack>(mask, a.peak, b.peak)};
  }

  /// What is left of the stiffness at a drive, that is the stress without damage over the strength:
  /// exp(-drive^m / (m e)), and so much that the stress does not fall below its bound once it has been at the
  /// strength.
  CRUMPLE_INLINE static Pack left(const Pack& at, const Mode& mode) {
    const Pack share = math::power_of_two(Pack(mode.rate * math::power(at, mode.exponent)));
    const Pack bound = mode.bound / larger(at, Pack(Real(1)));
    return select<Pack>(at > mode.peak, larger(share, bound), share);
  }

  /// What is left in shear where FS is -1: as above up to a first point, from there a line to the strength,
  /// then the bound. The drive is the stress without damage over that of the first point.
  CRUMPLE_INLINE Pack left_in_line(const Pack& at) const {
    const Pack first = Pack(real(FirstStress));
    const Pack elastic = at * first;
    const Pack gamma = elastic * Pack(Real(1) / real(OrthotropicElasticLaw::Gab));
    const Real from = real(FirstShear);
    const Pack line = first + Pack(real(LineSlope)) * (gamma - Pack(from));
    const Pack safe = larger(elastic, first);
    const Mask in_line = gamma > Pack(from);
    const Mask beyond = gamma > Pack(real(LastShear));
    const Pack by_line = select<Pack>(beyond, Pack(real(LineBound)), line) / safe;
    return select<Pack>(in_line, by_line, left(at, mode(fabric_mode::shear)));
  }

  CRUMPLE_INLINE static Ply follow(const History& history, const Ply& increment) {
    const Index rest = 3 * lanes * history.points;
    return {add_kept(strain(history, 0), strain(history, 0) + rest, increment.a),
            add_kept(strain(history, 1), strain(history, 1) + rest, increment.b),
            add_kept(strain(history, 2), strain(history, 2) + rest, increment.ab)};
  }

  /// Stresses along and across without damage, of a strain and what is left of both stiffnesses.
  struct Direct {
    Pack a, b;
  };
  CRUMPLE_INLINE Direct undamaged(const Ply& e, const Pack& left_a, const Pack& left_b) const {
    const Real ab = real(PoissonAb);
    const Real ba = real(PoissonBa);
    const Pack own_a = Pack(real(YoungsA)) * e.a;
    const Pack own_b = Pack(real(YoungsB)) * e.b;
    const Pack over = Pack(Real(1)) / (Pack(Real(1)) - Pack(ab * ba) * (left_a * left_b));
    return {over * multiply_add(Pack(ab) * left_b, own_b, own_a),
            over * multiply_add(Pack(ba) * left_a, own_a, own_b)};
  }

  /// A mode that is at work: whether that of tension, its largest drive so far, and what is left.
  struct Active {
    Mask pulled;
    Pack drive, left;
  };
  CRUMPLE_INLINE static Active chosen(const Mask& mask, const Active& one, const Active& other) {
    const Pack zero(Real(0));
    const Pack pulled = select<Pack>(one.pulled, Pack(Real(1)), zero);
    const Pack pulled_else = select<Pack>(other.pulled, Pack(Real(1)), zero);
    return {select<Pack>(mask, pulled, pulled_else) > zero, select<Pack>(mask, one.drive, other.drive),
            select<Pack>(mask, one.left, other.left)};
  }
  /// Of a stress without damage; `beside` is what the shear adds to the square of its drive.
  CRUMPLE_INLINE Active active(const History& history, const Pack& stress, const Pack& beside, int tension,
                               int compression) const {
    const Mask pulled = stress >= Pack(Real(0));
    const Mode own = chosen(pulled, mode(tension), mode(compression));
    const Pack ratio = stress * own.over_strength;
    const Pack now = square_root(multiply_add(ratio, ratio, beside));
    const Pack before =
        select<Pack>(pulled, load<Pack>(drive(history, tension)), load<Pack>(drive(history, compression)));
    const Pack most = larger(before, now);
    return {pulled, most, left(most, own)};
  }
  /// Drives only grow: that of the mode at work is not below the one before.
  CRUMPLE_INLINE static void keep(const History& history, const Active& of, int tension, int compression) {
    Real* const first = drive(history, tension);
    Real* const second = drive(history, compression);
    store(first, select<Pack>(of.pulled, of.drive, load<Pack>(first)));
    store(second, select<Pack>(of.pulled, load<Pack>(second), of.drive));
  }

  /// What both directions are given: strains, and what the shear adds to the squares of their drives.
  struct Load {
    Ply strain;
    Pack on_a, on_b;
  };
  CRUMPLE_INLINE Active active_a(const History& history, const Direct& stress, const Load& given) const {
    return active(history, stress.a, given.on_a, fabric_mode::tension_a, fabric_mode::compression_a);
  }
  CRUMPLE_INLINE Active active_b(const History& history, const Direct& stress, const Load& given) const {
    return active(history, stress.b, given.on_b, fabric_mode::tension_b, fabric_mode::compression_b);
  }

  /// Modes at work along both directions, with the stresses without damage by what they leave.
  struct Both {
    Active a, b;
    Direct stress;
  };

  /// Where a stress has not the sign of its mode, the other mode takes its place. That sign follows from the
  /// strains and what is left of the other direction, which stays as it is; and of strains of which one may
  /// leave its direction with either sign, the other cannot. So no stress changes its sign by this.
  CRUMPLE_INLINE void match_signs(const History& history, const Load& given, Both& at) const {
    const Active a = active_a(history, at.stress, given);
    const Active b = active_b(history, at.stress, given);
    at.a = chosen(a.pulled != at.a.pulled, a, at.a);
    at.b = chosen(b.pulled != at.b.pulled, b, at.b);
    at.stress = undamaged(given.strain, at.a.left, at.b.left);
  }

  /// By bisection of what is left along b, and for each of that along a: the more is left, the larger is the
  /// drive and the less leaves it, and all is continuous. For curves so steep that passes do not converge.
  [[gnu::noinline, gnu::cold]] Both bisected(const History& history, const Load& given) const {
    constexpr int halvings = 30;
    const Pack half(Real(0.5));
    Pack low_b(Real(0));
    Pack high_b(Real(1));
    Direct stress = undamaged(given.strain, low_b, low_b);
    for (int i = 0; i < halvings; ++i) {
      const Pack middle_b = half * (low_b + high_b);
      Pack low_a(Real(0));
      Pack high_a(Real(1));
      for (int k = 0; k < halvings; ++k) {
        const Pack middle_a = half * (low_a + high_a);
        stress = undamaged(given.strain, middle_a, middle_b);
        const Mask above = active_a(history, stress, given).left > middle_a;
        low_a = select<Pack>(above, middle_a, low_a);
        high_a = select<Pack>(above, high_a, middle_a);
      }
      const Mask above = active_b(history, stress, given).left > middle_b;
      low_b = select<Pack>(above, middle_b, low_b);
      high_b = select<Pack>(above, high_b, middle_b);
    }
    const Active a = active_a(history, stress, given);
    const Active b = active_b(history, stress, given);
    return {a, b, undamaged(given.strain, a.left, b.left)};
  }

  /// Damage of one direction depends a little on the stress of the other by Poisson's ratios: each pass makes
  /// the error smaller by their product and the slope of the curve.
  CRUMPLE_INLINE Both settled(const History& history, const Load& given) const {
    constexpr int passes = 6;
    const Pack one(Real(1));
    Both at{};
    Pack before_a = one - load<Pack>(damage(history, 0));
    Pack before_b = one - load<Pack>(damage(history, 1));
    at.stress = undamaged(given.strain, before_a, before_b);
    for (int i = 0; i < passes; ++i) {
      if (i > 0) before_a = at.a.left;
      if (i > 0) before_b = at.b.left;
      at.a = active_a(history, at.stress, given);
      at.b = active_b(history, at.stress, given);
      at.stress = undamaged(given.strain, at.a.left, at.b.left);
    }
    const Pack change = larger(absolute(at.a.left - before_a), absolute(at.b.left - before_b));
    const Mask open = change > Pack(Real(1e-5));
    if (any<Pack>(open)) {
      const Both found = bisected(history, given);
      at.a = chosen(open, found.a, at.a);
      at.b = chosen(open, found.b, at.b);
      at.stress = undamaged(given.strain, at.a.left, at.b.left);
    }
    match_signs(history, given, at);
    return at;
  }

  /// Stress of a ply by its whole strain; brings damage up to date.
  CRUMPLE_INLINE Ply damaged(const History& history, const Ply& e) const {
    const Pack zero(Real(0));
    const Pack one(Real(1));
    const double surface = this->c[Surface];
    const Pack shear = Pack(real(OrthotropicElasticLaw::Gab)) * e.ab;
    const Pack ratio = shear * over_strength(fabric_mode::shear);
    const Pack square = ratio * ratio;
    const Load given{e, surface > 0 ? square : zero, surface >= 0 ? square : zero};
    const Both at = settled(history, given);
    keep(history, at.a, fabric_mode::tension_a, fabric_mode::compression_a);
    keep(history, at.b, fabric_mode::tension_b, fabric_mode::compression_b);
    const Pack left_s = shear_left(history, shear, at.a.drive, at.b.drive);
    store(damage(history, 0), Pack(one - at.a.left));
    store(damage(history, 1), Pack(one - at.b.left));
    store(damage(history, 2), Pack(one - left_s));
    return {at.a.left * at.stress.a, at.b.left * at.stress.b, left_s * shear};
  }

  /// In shear alone where the surface has facets, else by the modes that the shear takes part in.
  CRUMPLE_INLINE Pack shear_left(const History& history, const Pack& shear, const Pack& drive_a,
                                 const Pack& drive_b) const {
    Real* const place = drive(history, fabric_mode::shear);
    const bool has_line = real(FirstShear) > 0;
    Pack now =
        absolute(shear) * (has_line ? Pack(Real(1) / real(FirstStress)) : over_strength(fabric_mode::shear));
    if (this->c[Surface] >= 0) now = larger(now, drive_b);
    if (this->c[Surface] > 0) now = larger(now, drive_a);
    const Pack most = larger(now, load<Pack>(place));
    store(place, most);
    return has_line ? left_in_line(most) : left(most, mode(fabric_mode::shear));
  }

  /// Marks points whose effective strain, at constant volume, is beyond its bound.
  CRUMPLE_INLINE void judge(const History& history, const Ply& e) const {
    if (this->c[Erosion] == 0) return;
    const Pack shear = Pack(Real(0.5)) * e.ab;
    const Pack square = multiply_add(e.a, Pack(e.a + e.b), multiply_add(e.b, e.b, Pack(shear * shear)));
    const Pack effective = square_root(Pack(Real(4.0 / 3.0)) * square);
    store(gone(history),
          select<Pack>(effective > Pack(real(Erosion)), Pack(Real(1)), load<Pack>(gone(history))));
  }

  CRUMPLE_INLINE PlaneStress<Pack> stress_of(const TurnedStiffness<Pack>& stiffness,
                                             const PlyAxes<Pack>& axes, const History& history,
                                             const PlaneStress<Pack>& old,
                                             const PlaneStrain<Pack>& increment) const {
    const Pack zero(Real(0));
    const Ply e = follow(history, axes.strain(increment));
    const Ply ply = damaged(history, e);
    judge(history, e);
    const PlaneStress<Pack> elastic = stiffness.stress(old, increment);
    PlaneStress<Pack> now{zero, zero, zero, elastic.yz, elastic.zx};
    axes.add(ply, now);
    const Mask stays = load<Pack>(gone(history)) == zero;
    return {select<Pack>(stays, now.xx, zero), select<Pack>(stays, now.yy, zero),
            select<Pack>(stays, now.xy, zero), select<Pack>(stays, now.yz, zero),
            select<Pack>(stays, now.zx, zero)};
  }

  CRUMPLE_INLINE void update(const MaterialTask<Real>& task, Index group, Index lane) const {
    update_plies<Update, Pack>(*this, task, group, lane);
  }
};

}  // namespace crumple::materials
