// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/common/deformation.hpp"
#include "materials/laws/ply_update.hpp"

namespace crumple::materials {

/// Numbers of the item "failed_modes" of a point: 0 or 1.
namespace composite_mode {
inline constexpr int fibre_tension = 0;
inline constexpr int fibre_compression = 1;
inline constexpr int matrix_tension = 2;
inline constexpr int matrix_compression = 3;
inline constexpr int gone = 4;  ///< the point carries no stress any more
inline constexpr int count = 5;
}  // namespace composite_mode

/// Unidirectional layers that fail by modes (docs/theory/composite_damage.md): the criteria are those of
/// F.-K. Chang & K.-Y. Chang, J. Composite Materials 21 (1987) 834-855, or for the matrix of S.W. Tsai & E.M.
/// Wu, J. Composite Materials 5 (1971) 58-80.
struct CompositeDamageLaw {
  using Model = model::CompositeDamage;
  static constexpr const char* name = "composite damage";
  static constexpr bool updates_packs = true;

  /// Those of the elastic law go before.
  enum Place {
    FibreTension = OrthotropicElasticLaw::Count,
    FibreCompression,
    MatrixTension,
    MatrixCompression,
    Shear,
    Softening,
    Beta,
    TensionLeft,
    CompressionLeft,
    IsTsaiWu,
    IsByEnergy,
    GoesByTension,
    LimitTension,
    LimitCompression,
    LimitMatrix,
    LimitShear,
    LimitEffective,
    Count
  };

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& law);
  static const char* name_of(const model::ConstitutiveLaw& law);
  static void prepare_element(const model::ConstitutiveLaw& law, const LaminaAxes& axes,
                              domain::ElementBlock& block, Index history, Index place);

  template <class Pack>
  struct Update;
};

template <class Pack>
struct CompositeDamageLaw::Update : OrthotropicElasticLaw::Update<Pack> {
  using Real = RealOf<Pack>;
  using Mask = MaskOf<Pack>;
  using History = HistoryView<Real>;
  using Ply = PlyPlane<Pack>;
  using Axes = PlyAxes<Pack>;
  using Elastic = OrthotropicElasticLaw::Update<Pack>;

  CRUMPLE_INLINE explicit Update(const MaterialTask<Real>& task) : Elastic(task) {}

  CRUMPLE_INLINE Real real(int place) const { return static_cast<Real>(this->c[place]); }
  CRUMPLE_INLINE bool is(int place) const { return this->c[place] != 0; }

  CRUMPLE_INLINE static Real* mode(const History& history, int which) {
    return history.at(2 + composite_mode::count * history.point + which);
  }
  CRUMPLE_INLINE static Real* strain(const History& history, int component) {
    return history.at(2 + composite_mode::count * history.points + 3 * history.point + component);
  }

  /// The shear stress of a strain increment by gamma = tau / G + alpha tau^3: Newton from the linear one, on
  /// the side where the slope is the larger, so that no step passes the root.
  CRUMPLE_INLINE Pack softened(const Pack& old, const Pack& linear, const Pack& increment) const {
    const Pack flexibility(Real(1) / real(OrthotropicElasticLaw::Gab));
    const Pack alpha(real(Softening));
    const auto strain_of = [&](const Pack& tau) { return tau * multiply_add(alpha * tau, tau, flexibility); };
    const Pack target = strain_of(old) + increment;
    Pack tau = linear;
    for (int i = 0; i < 8; ++i) {
      const Pack slope = multiply_add(Pack(Real(3)) * alpha * tau, tau, flexibility);
      tau = tau - (strain_of(tau) - target) / slope;
    }
    return tau;
  }

  /// The shear in the criteria, as parts of second and fourth order of a factor on the stress.
  struct ShearTerm {
    Pack square, fourth;
  };
  CRUMPLE_INLINE ShearTerm shear_term(const Pack& tau) const {
    const Real strength = real(Shear);
    const Pack ratio = tau * Pack(Real(1) / strength);
    if (!is(IsByEnergy)) return {ratio * ratio, Pack(Real(0))};
    // (tau^2 / 2G + 3/4 alpha tau^4) over the same of the strength.
    const Real linear = Real(0.5) / real(OrthotropicElasticLaw::Gab);
    const Real cubic = Real(0.75) * real(Softening) * strength * strength;
    const Pack square = ratio * ratio;
    return {square * Pack(linear / (linear + cubic)), square * square * Pack(cubic / (linear + cubic))};
  }

  /// The criterion of the matrix as a polynomial in a factor k on both of its stresses, which is 1 at
  /// failure: quartic k^4 + square k^2 + linear k.
  struct MatrixTerm {
    Pack linear, square, fourth;
  };
  CRUMPLE_INLINE MatrixTerm matrix_term(const Ply& stress) const {
    const Pack zero(Real(0));
    const ShearTerm shear = shear_term(stress.ab);
    const Real yt = real(MatrixTension);
    const Real yc = real(MatrixCompression);
    const Real twice = Real(2) * real(Shear);
    if (is(IsTsaiWu)) {
      const Pack over(Real(1) / (yc * yt));
      return {stress.b * (Pack(yc - yt) * over), multiply_add(stress.b * over, stress.b, shear.square),
              shear.fourth};
    }
    const Mask pulled = stress.b >= zero;
    const Pack by = stress.b * select<Pack>(pulled, Pack(Real(1) / yt), Pack(Real(1) / twice));
    const Real bracket = (yc / twice) * (yc / twice) - Real(1);
    return {select<Pack>(pulled, zero, stress.b * Pack(bracket / yc)), multiply_add(by, by, shear.square),
            shear.fourth};
  }

  /// The factor that brings the stresses of the matrix back to the criterion.
  CRUMPLE_INLINE static Pack matrix_factor(const MatrixTerm& m) {
    const Pack four(Real(4));
    Pack k = Pack(Real(2)) / (m.linear + square_root(multiply_add(m.linear, m.linear, four * m.square)));
    // Without the quartic the factor is too large: Newton comes down from there.
    for (int i = 0; i < 5; ++i) {
      const Pack kk = k * k;
      const Pack value =
          multiply_add(m.fourth * kk, kk, multiply_add(m.square, kk, m.linear * k)) - Pack(Real(1));
      const Pack slope =
          multiply_add(four * m.fourth * kk, k, multiply_add(Pack(m.square + m.square), k, m.linear));
      k = k - value / slope;
    }
    return smaller(k, Pack(Real(1)));
  }

  CRUMPLE_INLINE static void set(const History& history, int which, const Mask& mask) {
    Real* const at = mode(history, which);
    store(at, select<Pack>(mask, Pack(Real(1)), load<Pack>(at)));
  }

  /// Takes the stress of the matrix back; the strain that is left over lies across the fibres and in the
  /// shear alone, so that it takes stress from the fibres by Poisson's ratio.
  CRUMPLE_INLINE void return_matrix(const History& history, Ply& stress) const {
    const Pack zero(Real(0));
    const Pack one(Real(1));
    const MatrixTerm m = matrix_term(stress);
    const Mask fails = (m.linear + m.square) + m.fourth >= one;
    if (!any<Pack>(fails)) return;
    const Mask pulled = stress.b >= zero;
    set(history, composite_mode::matrix_tension, fails && pulled);
    set(history, composite_mode::matrix_compression, fails && !pulled);
    const Pack gone = select<Pack>(fails, one - matrix_factor(m), zero);
    const Pack across = gone * stress.b;
    stress.a =
        stress.a - across * this->number(OrthotropicElasticLaw::Ab) / this->number(OrthotropicElasticLaw::Bb);
    stress.b = stress.b - across;
    stress.ab = stress.ab - gone * stress.ab;
  }

  /// Takes the stress of the fibres back to their strength, which depends on what the matrix has been
  /// through; the strain that is left over lies along them.
  CRUMPLE_INLINE void return_fibres(const History& history, Ply& stress) const {
    const Pack zero(Real(0));
    const Pack one(Real(1));
    const Mask crushed = load<Pack>(mode(history, composite_mode::matrix_compression)) > zero;
    const ShearTerm shear = shear_term(stress.ab);
    const Pack share = larger(one - Pack(real(Beta)) * (shear.square + shear.fourth), zero);
    const Pack strength = Pack(real(FibreTension)) * select<Pack>(crushed, Pack(real(TensionLeft)), one);
    const Pack most = strength * square_root(share);
    const Pack least = -select<Pack>(crushed, Pack(real(CompressionLeft)), Pack(real(FibreCompression)));
    const Mask torn = stress.a >= most;
    const Mask buckled = stress.a <= least;
    if (!any<Pack>(torn || buckled)) return;
    set(history, composite_mode::fibre_tension, torn);
    set(history, composite_mode::fibre_compression, buckled);
    const Pack along = stress.a - smaller(larger(stress.a, least), most);
    stress.b =
        stress.b - along * this->number(OrthotropicElasticLaw::Ab) / this->number(OrthotropicElasticLaw::Aa);
    stress.a = stress.a - along;
  }

  CRUMPLE_INLINE void follow(const History& history, const Ply& increment) const {
    const Index rest = 3 * lanes * history.points;
    add_kept(strain(history, 0), strain(history, 0) + rest, increment.a);
    add_kept(strain(history, 1), strain(history, 1) + rest, increment.b);
    add_kept(strain(history, 2), strain(history, 2) + rest, increment.ab);
  }

  /// Marks points that go.
  CRUMPLE_INLINE void judge(const History& history) const {
    const Pack zero(Real(0));
    const Pack one(Real(1));
    const Pack a = load<Pack>(strain(history, 0));
    const Pack b = load<Pack>(strain(history, 1));
    const Pack shear = Pack(Real(0.5)) * load<Pack>(strain(history, 2));
    Pack mark = load<Pack>(mode(history, composite_mode::gone));
    const auto beyond = [&](const Pack& value, int limit) {
      if (is(limit)) mark = select<Pack>(value > Pack(real(limit)), one, mark);
    };
    beyond(a, LimitTension);
    if (is(LimitCompression)) mark = select<Pack>(a < Pack(real(LimitCompression)), one, mark);
    beyond(absolute(b), LimitMatrix);
    beyond(absolute(shear), LimitShear);
    if (is(LimitEffective)) {
      const Pack square = multiply_add(a, Pack(a + b), multiply_add(b, b, Pack(shear * shear)));
      beyond(square_root(Pack(Real(4.0 / 3.0)) * square), LimitEffective);
    }
    if (is(GoesByTension))
      mark = select<Pack>(load<Pack>(mode(history, composite_mode::fibre_tension)) > zero, one, mark);
    store(mode(history, composite_mode::gone), mark);
  }

  /// The stress of a point at the end of the step.
  CRUMPLE_INLINE PlaneStress<Pack> stress_of(const TurnedStiffness<Pack>& stiffness, const Axes& axes,
                                             const History& history, const PlaneStress<Pack>& old,
                                             const PlaneStrain<Pack>& increment) const {
    PlaneStress<Pack> now = stiffness.stress(old, increment);
    const Ply own = axes.strain(increment);
    follow(history, own);
    const Ply trial = axes.stress(now);
    Ply ply = trial;
    if (is(Softening)) ply.ab = softened(axes.stress(old).ab, trial.ab, own.ab);
    return_matrix(history, ply);
    return_fibres(history, ply);
    // Only what has changed is turned back: turning all there and back would lose digits in every step.
    axes.add({ply.a - trial.a, ply.b - trial.b, ply.ab - trial.ab}, now);
    judge(history);
    const Pack zero(Real(0));
    const Mask stays = load<Pack>(mode(history, composite_mode::gone)) == zero;
    return {select<Pack>(stays, now.xx, zero), select<Pack>(stays, now.yy, zero),
            select<Pack>(stays, now.xy, zero), select<Pack>(stays, now.yz, zero),
            select<Pack>(stays, now.zx, zero)};
  }

  CRUMPLE_INLINE static Real* gone(const History& history) { return mode(history, composite_mode::gone); }
  CRUMPLE_INLINE void update(const MaterialTask<Real>& task, Index group, Index lane) const {
    update_plies<Update, Pack>(*this, task, group, lane);
  }
};

}  // namespace crumple::materials
