// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/common/plane_stress.hpp"
#include "materials/common/shell_material.hpp"
#include "materials/common/tile_update.hpp"

namespace crumple::materials {

/// Stiffness of an orthotropic sheet in lamina axes, for a pack of elements.
template <class Pack>
struct TurnedStiffness {
  Pack xx, yy, xy, shear, x_shear, y_shear;  ///< direct, cross, shear, direct to shear
  Pack yz, zx, cross_shear;
  Pack zz_x, zz_y, zz_shear;  ///< strain zz over the stresses, negative

  CRUMPLE_INLINE PlaneStress<Pack> stress(const PlaneStress<Pack>& old,
                                          const PlaneStrain<Pack>& strain) const {
    const auto sum = [](const Pack& a, const Pack& ea, const Pack& b, const Pack& eb, const Pack& c,
                        const Pack& ec, const Pack& start) {
      return multiply_add(a, ea, multiply_add(b, eb, multiply_add(c, ec, start)));
    };
    return {sum(xx, strain.xx, xy, strain.yy, x_shear, strain.xy, old.xx),
            sum(yy, strain.yy, xy, strain.xx, y_shear, strain.xy, old.yy),
            sum(shear, strain.xy, x_shear, strain.xx, y_shear, strain.yy, old.xy),
            multiply_add(yz, strain.yz, multiply_add(cross_shear, strain.zx, old.yz)),
            multiply_add(zx, strain.zx, multiply_add(cross_shear, strain.yz, old.zx))};
  }
  CRUMPLE_INLINE Pack lateral_strain(const PlaneStress<Pack>& old, const PlaneStress<Pack>& now) const {
    Pack zz = zz_shear * (now.xy - old.xy);
    zz = multiply_add(zz_y, Pack(now.yy - old.yy), zz);
    return multiply_add(zz_x, Pack(now.xx - old.xx), zz);
  }
};

/// Linear orthotropic elasticity in plane stress; the material axes turn with the element
/// (docs/theory/orthotropic_elastic.md).
struct OrthotropicElasticLaw {
  using Model = model::OrthotropicElastic;
  static constexpr const char* name = "orthotropic elastic";
  static constexpr bool is_turned = true;

  enum Place { Aa, Bb, Ab, Gab, Gbc, Gca, LateralA, LateralB, Count };

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }
  /// Cosine and sine of the angle from the lamina's first axis to the material's.
  static void prepare_element(const model::ConstitutiveLaw& law, const LaminaAxes& axes,
                              domain::ElementBlock& block, Index history, Index place);
  /// The same two of a law that has these constants among others.
  static std::vector<double> constants_of(const model::OrthotropicElastic& law,
                                          const model::Material& material);
  static void set_axes(const model::OrthotropicElastic& law, const LaminaAxes& axes,
                       domain::ElementBlock& block, Index history, Index place);

  template <class Pack>
  struct Update {
    using Real = RealOf<Pack>;
    const double* c;

    CRUMPLE_INLINE explicit Update(const MaterialTask<Real>& task) : c(task.constants) {}

    CRUMPLE_INLINE Pack number(Place place) const { return Pack(static_cast<Real>(c[place])); }

    /// `history` holds cosine and sine; the formulas are the usual ones of laminates.
    CRUMPLE_INLINE TurnedStiffness<Pack> turned(const HistoryView<Real>& history) const {
      const Pack two(Real(2));
      const Pack cosine = load<Pack>(history.at(0));
      const Pack sine = load<Pack>(history.at(1));
      const Pack cc = cosine * cosine;
      const Pack ss = sine * sine;
      const Pack sc = sine * cosine;
      const Pack aa = number(Aa);
      const Pack bb = number(Bb);
      const Pack ab = number(Ab);
      const Pack g = number(Gab);
      const Pack mixed = two * (ab + two * g) * (ss * cc);
      const Pack fourth = ss * ss + cc * cc;
      const Pack along = aa - ab - two * g;
      const Pack across = ab - bb + two * g;
      TurnedStiffness<Pack> q;
      q.xx = aa * (cc * cc) + bb * (ss * ss) + mixed;
      q.yy = aa * (ss * ss) + bb * (cc * cc) + mixed;
      q.xy = (aa + bb - two * (two * g)) * (ss * cc) + ab * fourth;
      q.shear = (aa + bb - two * (ab + g)) * (ss * cc) + g * fourth;
      q.x_shear = sc * (along * cc + across * ss);
      q.y_shear = sc * (along * ss + across * cc);
      q.zx = number(Gca) * cc + number(Gbc) * ss;
      q.yz = number(Gca) * ss + number(Gbc) * cc;
      q.cross_shear = (number(Gca) - number(Gbc)) * sc;
      q.zz_x = -(number(LateralA) * cc + number(LateralB) * ss);
      q.zz_y = -(number(LateralA) * ss + number(LateralB) * cc);
      q.zz_shear = two * sc * (number(LateralB) - number(LateralA));
      return q;
    }
  };
};

/// The update of one pack by a law whose stiffness differs from element to element; it neither yields nor
/// fails.
template <class Law, class Pack>
CRUMPLE_INLINE void update_turned_pack(const Law& law, const MaterialTask<RealOf<Pack>>& task, Index group,
                                       Index lane) {
  using Real = RealOf<Pack>;
  Real* const state = task.state + group * task.group_stride + lane;
  const auto stiffness =
      law.turned(HistoryView<Real>{state + task.history * lanes, task.all_points, task.first_point});
  Pack energy(Real(0));
  Pack thickness(Real(0));
  for (int p = 0; p < task.points; ++p) {
    Real* const stress_state = state + (task.stress + components * (task.first_point + p)) * lanes;
    const Real* const strains = task.strain + p * components * tile_lanes + group * lanes + lane;
    const auto old = load_five<PlaneStress<Pack>>(stress_state, lanes);
    const auto strain = load_five<PlaneStrain<Pack>>(strains, tile_lanes);
    const auto now = stiffness.stress(old, strain);
    const Pack weight(task.weight[p]);
    Pack share = weight;
    if (task.area != nullptr) share = weight * load<Pack>(task.area + p * tile_lanes + group * lanes + lane);
    energy = multiply_add(share, mean_work(old, now, strain), energy);
    thickness = multiply_add(weight, stiffness.lateral_strain(old, now), thickness);
    store_five(stress_state, lanes, now);
  }
  store(task.energy + group * lanes + lane, energy);
  store(task.thickness_strain + group * lanes + lane, thickness);
  if (task.yield == nullptr) return;
  Real* const yield = task.yield + group * lanes + lane;
  store(yield + yield_row::stress * tile_lanes, Pack(static_cast<Real>(unlimited)));
  store(yield + yield_row::left * tile_lanes, Pack(Real(1)));
}

template <class Law, class Pack>
void update_turned_tile(const MaterialTask<RealOf<Pack>>& task) {
  const Law law(task);
  for (Index group = 0; group < task.groups; ++group)
    for (Index lane = 0; lane < lanes; lane += width_of<Pack>)
      update_turned_pack<Law, Pack>(law, task, group, lane);
}

}  // namespace crumple::materials
