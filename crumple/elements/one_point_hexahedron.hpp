// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/solid_formulation.hpp"
#include "math/power.hpp"

namespace crumple::elements {

/// The eight-node hexahedron with one point and hourglass control (Flanagan & Belytschko, IJNME 17 (1981)
/// 679-706; Goudreau & Hallquist, CMAME 33 (1982) 725-757): docs/theory/one_point_hexahedron.md.
struct OnePointHexahedron {
  static constexpr model::SolidFormulation formulation = model::SolidFormulation::OnePointHexahedron;
  static constexpr const char* name = "one-point hexahedron";
  static constexpr int points = 1;

  static constexpr int row_volume = solid_scratch::own;
  static constexpr int row_dilatation = row_volume + 1;  ///< rate
  static constexpr int row_rates = row_dilatation + 1;   ///< of the four hourglass modes, vectors
  static constexpr int rows = row_rates + 12;

  template <class Pack>
  static void strains(const SolidPlace<RealOf<Pack>>& place);
  template <class Pack>
  static SolidForces<Pack> forces(const SolidPlace<RealOf<Pack>>& place);
};

// Strains and rotation are those of the geometry at the middle of the step (Hughes & Winget 1980).
template <class Pack>
CRUMPLE_INLINE void OnePointHexahedron::strains(const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const SolidConstants<Real>& constants = place.task.constants;
  SolidPatterns<Pack> x = gathered_patterns<Pack>(place.nodes);
  const SolidPatterns<Pack> v = gathered_patterns<Pack>(place.nodes + solid_row::velocity * width_of<Pack>);
  const Pack back(-(Real(0.5) * place.task.step));
  for (int p = 0; p < pattern::count; ++p) x.of[p] = math::multiply_add(back, v.of[p], x.of[p]);
  const SolidGeometry<Pack> g = solid_geometry(x, constants.exact_volume);
  const PackMatrix<Pack> l = velocity_gradient(g, v, constants.exact_volume);
  leave_strains(place, 0, l);
  keep_row(place, row_volume, g.volume);
  keep_row(place, row_dilatation, Pack((l.x.x + l.y.y) + l.z.z));
  for (int mode = 0; mode < 4; ++mode) {
    const int p = pattern::hourglass + mode;
    const math::PackVec3<Pack> rate = constants.without_linear_part ? v.of[p] - l * x.of[p] : v.of[p];
    keep_vector(place, row_rates + 3 * mode, rate);
  }
}

/// Pressure against compression, rho l (Q1 l d^2 - Q2 c d) of a dilatation rate d below zero (von Neumann &
/// Richtmyer 1950; Landshoff 1955), and what it takes from the stable step.
template <class Pack>
struct BulkViscosity {
  Pack pressure;
  Pack speed;  ///< Q2 c - Q1 l d, to be added to the wave speed
};
template <class Pack>
CRUMPLE_INLINE BulkViscosity<Pack> bulk_viscosity(const SolidConstants<RealOf<Pack>>& constants,
                                                  const Pack& density, const Pack& length,
                                                  const Pack& dilatation_rate) {
  const Pack zero(RealOf<Pack>(0));
  const Pack closing = larger(zero, Pack(-dilatation_rate));
  const Pack linear(constants.bulk_linear * constants.wave_speed);
  const Pack speed = select<Pack>(
      closing > zero, multiply_add(Pack(constants.bulk_quadratic) * length, closing, linear), zero);
  return {density * length * closing * speed, speed};
}

/// Generalised hourglass forces from those of the last step and the rates between, and their work.
template <class Pack>
struct HourglassForces {
  math::PackVec3<Pack> of[4];
  Pack work;
};
template <class Pack>
CRUMPLE_INLINE HourglassForces<Pack> hourglass_forces(const SolidPlace<RealOf<Pack>>& place, int row_rates,
                                                      const Pack& modulus) {
  using Vec = math::PackVec3<Pack>;
  using Real = RealOf<Pack>;
  const Pack step(place.task.step);
  const PackMatrix<Pack> turned = left_rotation<Pack>(place, 0);
  HourglassForces<Pack> found;
  found.work = Pack(Real(0));
  for (int mode = 0; mode < 4; ++mode) {
    const Vec rate = kept_vector<Pack>(place, row_rates + 3 * mode);
    const Vec before = own_vector<Pack>(place, solid_state::hourglass + 3 * mode);
    const Vec old = before + turned * before;
    Vec now =
        place.task.constants.viscous ? modulus * rate : math::multiply_add(Pack(modulus * step), rate, old);
    // What has failed does not hold its last force.
    if (place.task.constants.can_fail) now = own_item<Pack>(place, solid_state::active) * now;
    set_own_vector(place, solid_state::hourglass + 3 * mode, now);
    found.of[mode] = now;
    found.work = multiply_add(Pack(Real(0.5)), math::dot(old + now, rate), found.work);
  }
  found.work = step * found.work;
  return found;
}

/// Force per rate (viscous) or per displacement (stiffness) of a mode's coefficient. Viscous: 16 Q rho c
/// V^(2/3) (Goudreau & Hallquist 1982: Q rho c V^(2/3) / 4 at a node for the sum over the nodes); stiffness:
/// 1/2 Q (lambda + 2 mu) G.G / V, G the derivatives of the volume (Flanagan & Belytschko 1981).
template <class Pack>
CRUMPLE_INLINE Pack hourglass_modulus(const SolidConstants<RealOf<Pack>>& constants,
                                      const SolidGeometry<Pack>& g, const Pack& density, const Pack& length) {
  const Pack factor(constants.hourglass);
  if (constants.viscous) return factor * density * (length * length);
  Pack squares = math::dot(g.gradient[0], g.gradient[0]);
  for (int p = 1; p < 6; ++p) squares = squares + math::dot(g.gradient[p], g.gradient[p]);
  return factor * squares / g.volume;
}

template <class Pack>
CRUMPLE_INLINE SolidForces<Pack> OnePointHexahedron::forces(const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  const SolidConstants<Real>& constants = place.task.constants;
  const SolidPatterns<Pack> x = gathered_patterns<Pack>(place.nodes);
  const SolidGeometry<Pack> g = solid_geometry(x, constants.exact_volume);
  const Pack active = own_item<Pack>(place, solid_state::active);
  const Pack density =
      Pack(constants.density) * own_item<Pack>(place, solid_state::reference_volume) / g.volume;
  const Pack length = math::power(g.volume, Pack(Real(1.0 / 3.0)));
  const Pack dilatation = kept_row<Pack>(place, row_dilatation);
  const BulkViscosity<Pack> bulk = bulk_viscosity(constants, density, length, dilatation);
  const Pack old_pressure = own_item<Pack>(place, solid_state::bulk_viscosity);
  const Pack pressure = active * bulk.pressure;
  set_own_item(place, solid_state::bulk_viscosity, pressure);

  const Pack viscous_work =
      Pack(Real(-0.5)) * (old_pressure + pressure) * (Pack(place.task.step) * dilatation);
  const Pack work = multiply_add(active, kept_row<Pack>(place, solid_scratch::material_energy), viscous_work);
  keep_row(place, solid_scratch::internal_energy, Pack(work * kept_row<Pack>(place, row_volume)));

  PackMatrix<Pack> stress = stress_of<Pack>(place, 0);
  stress.x.x = stress.x.x - pressure;
  stress.y.y = stress.y.y - pressure;
  stress.z.z = stress.z.z - pressure;
  const Pack modulus = active * hourglass_modulus(constants, g, density, length);
  const HourglassForces<Pack> q = hourglass_forces(place, row_rates, modulus);
  keep_row(place, solid_scratch::hourglass_energy, q.work);

  SolidPatterns<Pack> conjugate;
  for (int p = 0; p < 6; ++p) conjugate.of[p] = active * (stress * g.gradient[p]);
  if (constants.without_linear_part) {
    const Pack per_volume = Pack(Real(1)) / g.volume;
    for (int p = 0; p < 6; ++p) {
      Vec less = math::dot(g.gradient[p], x.of[pattern::hourglass]) * q.of[0];
      for (int mode = 1; mode < 4; ++mode)
        less =
            math::multiply_add(math::dot(g.gradient[p], x.of[pattern::hourglass + mode]), q.of[mode], less);
      conjugate.of[p] = math::multiply_add(Pack(-per_volume), less, conjugate.of[p]);
    }
  }
  for (int mode = 0; mode < 3; ++mode)
    conjugate.of[pattern::hourglass + mode] = conjugate.of[pattern::hourglass + mode] + q.of[mode];
  conjugate.of[pattern::xi_eta_zeta] = q.of[3];

  const Pack thin = g.volume / square_root(largest_face_squared(x));
  const Pack speed(constants.wave_speed);
  const Pack limit = own_item<Pack>(place, solid_state::step_scale) * thin /
                     (bulk.speed + square_root(multiply_add(bulk.speed, bulk.speed, Pack(speed * speed))));
  keep_row(place, solid_scratch::shortest_step,
           select<Pack>(active > Pack(Real(0)), limit, Pack(Real(1e30))));
  return nodal_forces(conjugate);
}

}  // namespace crumple::elements
