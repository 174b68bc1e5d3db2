// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The pressure of solids from an equation of state; only kernels include it. The law brings the deviator,
// this adds the pressure: docs/theory/equations_of_state.md.

#include "materials/common/deformation.hpp"
#include "materials/common/history_view.hpp"
#include "materials/list.hpp"
#include "materials/plasticity/principal.hpp"

namespace crumple::materials {

/// Of the equation of state at place `kind` of the list: the same branch for all lanes.
template <class Pack, class... Equations>
CRUMPLE_INLINE EosPoint<Pack> eos_point(const double* c, const Pack& mu, LawList<Equations...> /*list*/) {
  const int wanted = static_cast<int>(c[eos_place::kind]);
  EosPoint<Pack> found{};
  int kind = 0;
  const auto try_one = [&]<class Equation>(Equation) {
    if (kind++ == wanted) found = Equation::template at<Pack>(c + eos_place::own, mu);
  };
  (try_one(Equations{}), ...);
  return found;
}

template <class Pack>
CRUMPLE_INLINE SolidStress<Pack> with_pressure(const SolidStress<Pack>& deviator, const Pack& pressure) {
  return {deviator.xx - pressure,
          deviator.yy - pressure,
          deviator.zz - pressure,
          deviator.xy,
          deviator.yz,
          deviator.zx};
}

/// One step of one pack of points with an equation of state.
template <class Pack>
struct EosUpdate {
  using Real = RealOf<Pack>;

  const double* c;  ///< the constants from eos_place::kind on
  HistoryView<Real> history;

  CRUMPLE_INLINE Pack number(int place) const { return Pack(static_cast<Real>(c[place])); }
  CRUMPLE_INLINE Real* item(int which) const {
    return history.at(static_cast<int>(c[eos_place::history]) + which * history.points + history.point);
  }
  /// Relative volume less 1.
  CRUMPLE_INLINE Pack excess() const {
    return number(eos_place::initial_excess) + load<Pack>(item(eos_item::volume_change));
  }

  struct Result {
    SolidStress<Pack> stress;
    Pack wave_square;  ///< of the speed of longitudinal waves
  };

  /// `old` is the turned old stress, `now` the new one, of whose mean nothing is kept; `viscosity` the mean
  /// over the step of the pressure of bulk viscosity.
  CRUMPLE_INLINE Result apply(const SolidStress<Pack>& old, const SolidStress<Pack>& now,
                              const SolidStrain<Pack>& strain, const Turn<Pack>& turn,
                              const Pack& viscosity) const {
    const Pack one(Real(1));
    const Pack half(Real(0.5));
    const Pack old_volume = one + excess();
    const Pack change = old_volume * volume_growth(step_gradient(strain, turn));
    add_kept(item(eos_item::volume_change), item(eos_item::volume_rest), change);
    const Pack over = excess();
    const Pack volume = one + over;
    const Pack old_pressure = -mean_stress(old);
    const SolidStress<Pack> old_deviator = with_pressure(old, Pack(-old_pressure));
    SolidStress<Pack> deviator = with_pressure(now, mean_stress(now));
    const Pack middle = multiply_add(half, change, old_volume);
    const Pack work = middle * mean_work(old_deviator, deviator, strain) -
                      multiply_add(half, old_pressure, viscosity) * change;
    const Pack known = number(eos_place::initial_energy) + (load<Pack>(item(eos_item::energy)) +
                                                            (load<Pack>(item(eos_item::energy_rest)) + work));
    const EosPoint<Pack> at = eos_point(c, Pack(-over / volume), EquationsOfState{});
    // p = cold + thermal E with E = known - p change / 2.
    Pack pressure =
        multiply_add(at.thermal, known, at.cold) / multiply_add(Pack(half * at.thermal), change, one);
    const Pack energy = known - half * pressure * change;
    Pack slope = multiply_add(at.thermal_slope, energy, at.cold_slope);
    slope = multiply_add(Pack(pressure * at.thermal), Pack(volume * volume), slope);
    const Pack square =
        number(eos_place::per_density) * multiply_add(number(eos_place::shear), volume, slope);
    bound(deviator, pressure);
    add_kept(item(eos_item::energy), item(eos_item::energy_rest), Pack(work - half * pressure * change));
    return {with_pressure(deviator, pressure), larger(square, number(eos_place::least_square))};
  }

  /// Pressure cut-off and spall.
  CRUMPLE_INLINE void bound(SolidStress<Pack>& deviator, Pack& pressure) const {
    using model::Spall;
    const Pack least = number(eos_place::least_pressure);
    const auto kind = static_cast<Spall>(static_cast<int>(c[eos_place::spall]));
    if (kind == Spall::None) {
      pressure = larger(pressure, least);
      return;
    }
    const Pack zero(Real(0));
    Pack rubble = load<Pack>(item(eos_item::rubble));
    const Pack tension =
        kind == Spall::Stress ? Pack(largest_principal(deviator) - pressure) : Pack(-pressure);
    rubble = select<Pack>(tension >= Pack(-least), Pack(Real(1)), rubble);
    store(item(eos_item::rubble), rubble);
    const auto loose = rubble > zero;
    deviator = {select<Pack>(loose, zero, deviator.xx), select<Pack>(loose, zero, deviator.yy),
                select<Pack>(loose, zero, deviator.zz), select<Pack>(loose, zero, deviator.xy),
                select<Pack>(loose, zero, deviator.yz), select<Pack>(loose, zero, deviator.zx)};
    pressure = select<Pack>(loose, larger(pressure, zero), pressure);
  }
};

}  // namespace crumple::materials
