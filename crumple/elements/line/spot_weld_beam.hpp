// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/line/beam_resultants.hpp"

namespace crumple::elements {

/// A spot weld as one beam: deformations and forces are those of the beam of resultants; the law is
/// elastic-plastic in the resultants of its middle, and the beam fails by them
/// (docs/theory/spot_weld_beams.md).
struct SpotWeldBeam {
  static constexpr model::BeamFormulation formulation = model::BeamFormulation::SpotWeld;
  static constexpr const char* name = "spot weld beam";
  static constexpr bool turns = true;
  static constexpr bool can_fail = true;
  static constexpr Index energy = weld_state::energy;
  static bool fails(const BeamConstants& /*constants*/) { return true; }

  template <class Pack>
  static BeamForces<Pack> forces(const BeamPlace& place);
};

/// Numbers of a weld's middle, in the order of BeamConstants::strength: axial, shear along t and s, torsion,
/// bending about s and t. They are independent of each other where the beam is elastic.
template <class Pack>
struct WeldMiddle {
  Pack of[weld_modes];
};

/// Deformations: stretch, how far the ends slide against each other, twist, how far they bend.
template <class Pack>
CRUMPLE_INLINE WeldMiddle<Pack> weld_deformation(const BeamMotion<Pack>& motion, const Pack& length) {
  const About<Pack>& first = motion.turn[0];
  const About<Pack>& second = motion.turn[1];
  const Pack half_length = Pack(0.5) * length;
  return {{motion.stretch, half_length * (first.s + second.s), half_length * (first.t + second.t),
           motion.twist, first.s - second.s, first.t - second.t}};
}

/// What is conjugate to the deformations, on the ends.
template <class Pack>
CRUMPLE_INLINE BeamResultants<Pack> on_ends(const WeldMiddle<Pack>& q, const Pack& length) {
  const Pack half_length = Pack(0.5) * length;
  const About<Pack> shear{half_length * q.of[1], half_length * q.of[2]};
  return {q.of[0], q.of[3], {{shear.s + q.of[4], shear.t + q.of[5]}, {shear.s - q.of[4], shear.t - q.of[5]}}};
}

template <class Pack>
CRUMPLE_INLINE WeldMiddle<Pack> weld_stiffness(const BeamConstants& c, const Pack& length) {
  const Pack sliding = Pack(1.0) / (length * length * length * Pack(1 / (12 * c.bending_s)) +
                                    length * Pack(1 / c.shear_stiffness));
  return {{Pack(c.youngs_modulus * c.area) / length, sliding, sliding, Pack(c.twisting) / length,
           Pack(c.bending_s) / length, Pack(c.bending_t) / length}};
}

/// Brings resultants outside of the yield surface sum of (q_i / Q_i)^2 = s^2 back onto it, Q_i the resultant
/// at which the whole section yields by it alone under a yield stress of one, s the yield stress; the plastic
/// strain hardens. Flow is along the normal of the surface: q_i = trial_i / (1 + x c_i), c_i = k_i V / Q_i^2,
/// with V the volume and x the growth of the plastic strain over the new yield stress. In x one over the size
/// of q is concave and nearly straight, so Newton's steps from zero come from one side and are few.
template <class Pack>
CRUMPLE_INLINE void flow_of_weld(const BeamPlace& place, const WeldMiddle<Pack>& stiffness,
                                 const Pack& length, WeldMiddle<Pack>& q) {
  const BeamConstants& c = place.task.constants;
  const Pack one(1.0);
  const Pack zero(0.0);
  const Pack strain = beam_item<Pack>(place, weld_state::plastic_strain);
  const Pack yield = multiply_add(Pack(c.isotropic), strain, Pack(c.yield_stress));
  const Pack volume = Pack(c.area) * length;
  Pack softness[weld_modes];
  Pack square[weld_modes];
  Pack sum = zero;
  for (int i = 0; i < weld_modes; ++i) {
    const Pack per_stress(1 / (c.capacity[i] * c.capacity[i]));
    softness[i] = stiffness.of[i] * volume * per_stress;
    square[i] = q.of[i] * q.of[i] * per_stress;
    sum = sum + square[i];
  }
  const Pack outside = square_root(sum) - yield;
  Pack x = zero;
  constexpr int most_steps = 10;
  for (int step = 0; step < most_steps; ++step) {
    Pack size = zero;
    Pack slope = zero;
    for (int i = 0; i < weld_modes; ++i) {
      const Pack less = one / multiply_add(x, softness[i], one);
      const Pack part = square[i] * less * less;
      size = size + part;
      slope = multiply_add(Pack(part * less), softness[i], slope);
    }
    const Pack root = one / square_root(size);
    const Pack beyond = root - (one - Pack(c.isotropic) * x) / yield;
    const Pack rise = multiply_add(Pack(root * root * root), slope, Pack(Pack(c.isotropic) / yield));
    x = select<Pack>(outside > zero, Pack(x - beyond / rise), zero);
  }
  for (int i = 0; i < weld_modes; ++i) {
    const Pack trial = q.of[i];
    q.of[i] = trial / multiply_add(x, softness[i], one);
    const Index item = weld_state::plastic + i;
    const Pack flown = (trial - q.of[i]) / stiffness.of[i];
    set_beam_item(place, item, Pack(beam_item<Pack>(place, item) + flown));
  }
  set_beam_item(place, weld_state::plastic_strain, Pack(strain + x * yield / (one - Pack(c.isotropic) * x)));
}

/// One for welds that hold at time n, else zero.
template <class Pack>
CRUMPLE_INLINE Pack weld_holds(const BeamPlace& place, const WeldMiddle<Pack>& q, const Pack& active) {
  const BeamConstants& c = place.task.constants;
  const Pack zero(0.0);
  if (place.task.time >= c.failure_time) return zero;
  Pack load = zero;
  for (int i = 0; i < weld_modes; ++i) {
    if (!(c.strength[i] > 0)) continue;
    const Pack bearing = i == 0 ? larger(zero, q.of[i]) : q.of[i];
    const Pack ratio = Pack(1 / c.strength[i]) * bearing;
    load = multiply_add(ratio, ratio, load);
  }
  Pack holds = select<Pack>(load < Pack(1.0), active, zero);
  if (c.failure_strain > 0)
    holds = select<Pack>(beam_item<Pack>(place, weld_state::plastic_strain) < Pack(c.failure_strain), holds,
                         zero);
  return holds;
}

/// What there is of an intact weld. What has failed may have any shape, and numbers that are none.
template <class Pack>
CRUMPLE_INLINE void clear_where_failed(const Pack& active, BeamMotion<Pack>& motion,
                                       WeldMiddle<Pack>& trial) {
  const Pack zero(0.0);
  clear_where_gone(active, motion);
  for (Pack& number : trial.of) number = select<Pack>(active > zero, number, zero);
}

template <class Pack>
CRUMPLE_INLINE BeamForces<Pack> SpotWeldBeam::forces(const BeamPlace& place) {
  const Pack zero(0.0);
  const Pack active = beam_item<Pack>(place, beam_state::active);
  const Pack l0 = beam_item<Pack>(place, beam_state::reference_length);
  BeamMotion<Pack> motion = beam_motion<Pack>(place);
  const WeldMiddle<Pack> stiffness = weld_stiffness(place.task.constants, l0);
  WeldMiddle<Pack> q = weld_deformation(motion, l0);
  for (int i = 0; i < weld_modes; ++i)
    q.of[i] = stiffness.of[i] * (q.of[i] - beam_item<Pack>(place, weld_state::plastic + i));
  clear_where_failed(active, motion, q);
  flow_of_weld(place, stiffness, l0, q);
  const Pack intact = weld_holds(place, q, active);
  for (Pack& resultant : q.of) resultant = intact * resultant;
  set_beam_item(
      place, weld_state::failure_time,
      select<Pack>(active > intact, Pack(place.task.time), beam_item<Pack>(place, weld_state::failure_time)));
  const BeamResultants<Pack> resultants = on_ends(q, l0);
  const BeamResultants<Pack> on_nodes = with_damping(place, motion, resultants, intact);
  const Pack work = keep_work(place, motion, resultants);
  keep_beam_row(place, beam_row::internal_energy, Pack(active * work));
  keep_beam_row(place, beam_row::hourglass_energy, zero);
  keep_beam_row(place, beam_row::intact, intact);
  keep_stable_step(place, active, motion.length);
  BeamForces<Pack> internal = beam_forces(motion, on_nodes, intact);
  clear_where_gone(intact, internal);
  return internal;
}

}  // namespace crumple::elements
