// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/line/beam_formulation.hpp"
#include "math/power.hpp"

namespace crumple::elements {

/// Two nodes with an axial force between them, uniform stress, constant area; elastic or with linear mixed
/// hardening (docs/theory/beams.md).
struct Truss {
  static constexpr model::BeamFormulation formulation = model::BeamFormulation::Truss;
  static constexpr const char* name = "truss";
  static constexpr bool turns = false;
  static constexpr bool can_fail = true;
  static constexpr Index energy = truss_state::energy;
  static bool fails(const BeamConstants& constants) { return constants.failure_strain > 0; }

  template <class Pack>
  static BeamForces<Pack> forces(const BeamPlace& place);
};

/// Stress of time n from that of n-1 and the strain between; leaves it with the history.
template <class Pack>
CRUMPLE_INLINE Pack truss_stress(const BeamPlace& place, const Pack& strain) {
  const BeamConstants& c = place.task.constants;
  const Pack zero(0.0);
  const Pack trial =
      multiply_add(Pack(c.youngs_modulus), strain, beam_item<Pack>(place, truss_state::stress));
  if (c.plastic == 0) return trial;
  const Pack back = beam_item<Pack>(place, truss_state::back_stress);
  const Pack plastic = beam_item<Pack>(place, truss_state::plastic_strain);
  Pack factor(1.0);
  if (c.rate > 0 && place.task.step > 0)
    factor = factor + math::power(Pack(Pack(1 / (c.rate * place.task.step)) * absolute(strain)),
                                  Pack(c.rate_exponent));
  const Pack shifted = trial - back;
  const Pack yield = factor * multiply_add(Pack(c.isotropic), plastic, Pack(c.yield_stress));
  const Pack beyond = larger(zero, Pack(absolute(shifted) - yield));
  const Pack flow = beyond / multiply_add(factor, Pack(c.isotropic), Pack(c.youngs_modulus + c.kinematic));
  const Pack along = select<Pack>(shifted < zero, Pack(-flow), flow);
  set_beam_item(place, truss_state::plastic_strain, Pack(plastic + flow));
  set_beam_item(place, truss_state::back_stress, multiply_add(Pack(c.kinematic), along, back));
  return multiply_add(Pack(-c.youngs_modulus), along, trial);
}

template <class Pack>
CRUMPLE_INLINE BeamForces<Pack> Truss::forces(const BeamPlace& place) {
  const BeamConstants& c = place.task.constants;
  const Pack zero(0.0);
  const Pack active = beam_item<Pack>(place, beam_state::active);
  const math::PackVec3<Pack> span = beam_span<Pack>(place);
  const Pack length = square_root(math::dot(span, span));
  const Pack before = beam_item<Pack>(place, truss_state::length);
  const Pack longer = length - before;
  const Pack old_stress = beam_item<Pack>(place, truss_state::stress);
  // Strain by the length of the middle of the step: the sum is the logarithmic strain.
  const Pack strain = longer / (Pack(0.5) * (length + before));
  Pack stress = truss_stress(place, strain);
  Pack intact = active;
  if (c.failure_strain > 0)
    intact = select<Pack>(beam_item<Pack>(place, truss_state::plastic_strain) < Pack(c.failure_strain),
                          active, zero);
  stress = intact * stress;
  set_beam_item(place, truss_state::length, length);
  set_beam_item(place, truss_state::stress, stress);
  const Pack half_area(0.5 * c.area);
  keep_beam_row(place, beam_row::internal_energy, Pack(active * half_area * (old_stress + stress) * longer));
  keep_beam_row(place, beam_row::hourglass_energy, zero);
  if (place.task.damping_item > 0) {
    const Pack damping = intact * (damping_share(place, length) * (Pack(c.youngs_modulus) * strain));
    const Pack both = beam_item<Pack>(place, place.task.damping_item) + damping;
    set_beam_item(place, place.task.damping_item, damping);
    keep_beam_row(place, beam_row::damping_energy, Pack(active * half_area * both * longer));
    stress = stress + damping;
  }
  keep_beam_row(place, beam_row::intact, intact);
  keep_stable_step(place, active, length);
  BeamForces<Pack> internal;
  internal.force = Pack(Pack(c.area) * stress / length) * span;
  internal.moment[0] = internal.moment[1] = {zero, zero, zero};
  return internal;
}

}  // namespace crumple::elements
