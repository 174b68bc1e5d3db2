// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/line/beam_resultants.hpp"

namespace crumple::elements {

/// A beam with one point along its length and stresses at the points of its cross section there: the strains
/// of T.J.R. Hughes & W.K. Liu (CMAME 27 (1981) 331-362), stretch, curvatures, twist and two shears constant
/// along the beam, counted in the axes of the beam of resultants (docs/theory/integrated_beams.md).
struct IntegratedBeam {
  static constexpr model::BeamFormulation formulation = model::BeamFormulation::Integrated;
  static constexpr const char* name = "integrated beam";
  static constexpr bool turns = true;
  static constexpr bool can_fail = true;
  static constexpr Index energy = integrated_state::energy;
  static bool fails(const BeamConstants& constants) { return constants.section_fails != 0; }

  template <class Pack>
  static BeamForces<Pack> forces(const BeamPlace& place);
};

/// Strain increments of the middle, and the resultants there.
template <class Pack>
struct SectionRows {
  alignas(cache_line) double strain[materials::section_row::count][width_of<Pack>];
  alignas(cache_line) double resultant[materials::section_row::count][width_of<Pack>];
  alignas(cache_line) double intact[width_of<Pack>];

  CRUMPLE_INLINE Pack result(int row) const { return load<Pack>(resultant[row]); }
};

/// Strains of the step by the length in its middle: the sum of the stretches is the logarithmic strain. The
/// cross section stays plane, and turns against the chord by the mean of both ends.
template <class Pack>
CRUMPLE_INLINE void take_strains(const BeamPlace& place, const BeamMotion<Pack>& motion,
                                 SectionRows<Pack>& rows) {
  using namespace materials::section_row;
  const auto change = [&](Index which, const Pack& now) {
    return Pack(now - beam_item<Pack>(place, resultant_state::deformation + which));
  };
  const Pack stretched = change(0, motion.stretch);
  const Pack length = beam_item<Pack>(place, beam_state::reference_length) + motion.stretch;
  const Pack per_length = Pack(1.0) / (length - Pack(0.5) * stretched);
  const About<Pack> first{change(2, motion.turn[0].s), change(3, motion.turn[0].t)};
  const About<Pack> second{change(4, motion.turn[1].s), change(5, motion.turn[1].t)};
  const Pack half_root(0.5 * place.task.constants.shear_root);
  store(rows.strain[stretch], Pack(per_length * stretched));
  store(rows.strain[curvature_s], Pack(per_length * (second.s - first.s)));
  store(rows.strain[curvature_t], Pack(per_length * (second.t - first.t)));
  store(rows.strain[twist], Pack(per_length * change(1, motion.twist)));
  store(rows.strain[shear_s], Pack(-(half_root * (first.t + second.t))));
  store(rows.strain[shear_t], Pack(half_root * (first.s + second.s)));
}

template <class Pack>
CRUMPLE_INLINE BeamForces<Pack> IntegratedBeam::forces(const BeamPlace& place) {
  using namespace materials::section_row;
  const BeamTask& task = place.task;
  const BeamConstants& c = task.constants;
  const Pack zero(0.0);
  const Pack active = beam_item<Pack>(place, beam_state::active);
  BeamMotion<Pack> motion = beam_motion<Pack>(place);
  clear_where_gone(active, motion);
  SectionRows<Pack> rows;
  take_strains(place, motion, rows);
  task.section(materials::SectionTask{.state = place.state,
                                      .stress = static_cast<Index>(c.stress),
                                      .history = static_cast<Index>(c.history),
                                      .points = static_cast<int>(c.section_points),
                                      .place = task.section_places,
                                      .constants = task.material,
                                      .step = task.step,
                                      .strain = rows.strain[0],
                                      .resultant = rows.resultant[0],
                                      .intact = rows.intact});
  const Pack intact = active * load<Pack>(rows.intact);
  // Conjugate to stretch, twist and the turns of the ends.
  const Pack l0 = beam_item<Pack>(place, beam_state::reference_length);
  const Pack half_length = intact * (Pack(0.5 * c.shear_root) * (l0 + motion.stretch));
  const About<Pack> shear{half_length * rows.result(shear_t), -(half_length * rows.result(shear_s))};
  const About<Pack> bending{intact * rows.result(curvature_s), intact * rows.result(curvature_t)};
  const BeamResultants<Pack> q{
      intact * rows.result(stretch),
      intact * rows.result(twist),
      {{shear.s - bending.s, shear.t - bending.t}, {shear.s + bending.s, shear.t + bending.t}}};
  const Pack work = keep_work(place, motion, q);
  keep_beam_row(place, beam_row::internal_energy, Pack(active * work));
  keep_beam_row(place, beam_row::hourglass_energy, zero);
  keep_beam_row(place, beam_row::intact, intact);
  // Of the present length l the mode of stretch has a stiffness of 1 / l, that of transverse shear grows with
  // l.
  const Pack longer = square_root(smaller(Pack(1.0), Pack(l0 / motion.length)));
  keep_stable_step(place, active, motion.length);
  const Pack limit = load<Pack>(place.rows + beam_row::shortest_step * materials::tile_lanes);
  keep_beam_row(place, beam_row::shortest_step, select<Pack>(active > zero, Pack(limit * longer), limit));
  BeamForces<Pack> internal = beam_forces(motion, q, intact);
  clear_where_gone(intact, internal);
  return internal;
}

}  // namespace crumple::elements
