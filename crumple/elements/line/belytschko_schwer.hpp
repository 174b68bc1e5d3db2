// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/line/beam_resultants.hpp"

namespace crumple::elements {

/// The beam of resultants in axes that move with it, each end with axes of its own (Belytschko, Schwer &
/// Klein, IJNME 11 (1977) 65-84). Our forces are the exact derivatives of the energy by the motion:
/// docs/theory/beams.md.
struct BelytschkoSchwer {
  static constexpr model::BeamFormulation formulation = model::BeamFormulation::BelytschkoSchwer;
  static constexpr const char* name = "Belytschko-Schwer beam";
  static constexpr bool turns = true;
  static constexpr bool can_fail = false;

  template <class Pack>
  static BeamForces<Pack> forces(const BeamPlace& place);
};

/// All stiffnesses of the beams of a pack, of their length at time zero.
template <class Pack>
struct BeamStiffness {
  Pack axial;
  BendingStiffness<Pack> about_s, about_t;

  CRUMPLE_INLINE BeamStiffness(const BeamConstants& c, const Pack& length)
      : axial(Pack(c.youngs_modulus * c.area) / length),
        about_s(c.bending_s, c.shear_stiffness, length),
        about_t(c.bending_t, c.shear_stiffness, length) {}
  /// Moments on one end by the elastic turns of both.
  CRUMPLE_INLINE About<Pack> moment(const About<Pack> (&turn)[2], int end) const {
    const About<Pack>& own = turn[end];
    const About<Pack>& other = turn[1 - end];
    return {multiply_add(about_s.same, own.s, Pack(about_s.other * other.s)),
            multiply_add(about_t.same, own.t, Pack(about_t.other * other.t))};
  }
};

/// The elastic parts of the deformations.
template <class Pack>
struct BeamElastic {
  Pack stretch;
  About<Pack> turn[2];
};

/// Takes the plastic parts off the deformations, and brings them up to date: the axial force stays within its
/// limit, then the moments of each end within theirs, (Ms / Mps)^2 + (Mt / Mpt)^2 <= (1 - (N / Np)^2)^2. An
/// end that yields unloads the other by half at most, so that taking turns ends soon.
template <class Pack>
CRUMPLE_INLINE BeamElastic<Pack> less_plastic(const BeamPlace& place, const BeamStiffness<Pack>& k,
                                              BeamElastic<Pack> e) {
  const BeamConstants& c = place.task.constants;
  const Pack one(1.0);
  const Index item = resultant_state::plastic;
  const Pack limit(c.plastic_force);
  const Pack before = beam_item<Pack>(place, item);
  const Pack trial = k.axial * (e.stretch - before);
  const Pack force = larger(Pack(-limit), smaller(limit, trial));
  const Pack plastic = before + (trial - force) / k.axial;
  set_beam_item(place, item, plastic);
  e.stretch = e.stretch - plastic;
  const Pack ratio = force / limit;
  const Pack room = larger(Pack(0.0), Pack(one - ratio * ratio));
  About<Pack> flow[2];
  for (int end = 0; end < 2; ++end) {
    flow[end] = {beam_item<Pack>(place, item + 1 + 2 * end), beam_item<Pack>(place, item + 2 + 2 * end)};
    e.turn[end] = {e.turn[end].s - flow[end].s, e.turn[end].t - flow[end].t};
  }
  constexpr int rounds = 16;  // each leaves a quarter of the error
  for (int round = 0; round < rounds; ++round)
    for (int end = 0; end < 2; ++end) {
      const About<Pack> m = k.moment(e.turn, end);
      const Pack s = Pack(1 / c.plastic_moment_s) * m.s;
      const Pack t = Pack(1 / c.plastic_moment_t) * m.t;
      const Pack size = square_root(multiply_add(s, s, Pack(t * t)));
      const Pack excess = select<Pack>(size > room, Pack(one - room / size), Pack(0.0));
      const About<Pack> change{excess * m.s / k.about_s.same, excess * m.t / k.about_t.same};
      flow[end] = {flow[end].s + change.s, flow[end].t + change.t};
      e.turn[end] = {e.turn[end].s - change.s, e.turn[end].t - change.t};
    }
  for (int end = 0; end < 2; ++end) {
    set_beam_item(place, item + 1 + 2 * end, flow[end].s);
    set_beam_item(place, item + 2 + 2 * end, flow[end].t);
  }
  return e;
}

template <class Pack>
CRUMPLE_INLINE BeamForces<Pack> BelytschkoSchwer::forces(const BeamPlace& place) {
  const BeamConstants& c = place.task.constants;
  const Pack active = beam_item<Pack>(place, beam_state::active);
  const Pack l0 = beam_item<Pack>(place, beam_state::reference_length);
  const BeamMotion<Pack> motion = beam_motion<Pack>(place);
  const BeamStiffness<Pack> stiffness(c, l0);
  const Pack torsion = Pack(c.twisting) / l0 * motion.twist;
  BeamElastic<Pack> elastic{motion.stretch, {motion.turn[0], motion.turn[1]}};
  if (c.plastic != 0) elastic = less_plastic(place, stiffness, elastic);
  const Pack axial = stiffness.axial * elastic.stretch;
  const BeamResultants<Pack> q{
      axial, torsion, {stiffness.moment(elastic.turn, 0), stiffness.moment(elastic.turn, 1)}};
  const BeamResultants<Pack> on_nodes = with_damping(place, motion, q, active);
  const Pack work = keep_work(place, motion, q);
  keep_beam_row(place, beam_row::internal_energy, Pack(active * work));
  keep_beam_row(place, beam_row::hourglass_energy, Pack(0.0));
  keep_stable_step(place, active, motion.length);
  return beam_forces(motion, on_nodes, active);
}

}  // namespace crumple::elements
