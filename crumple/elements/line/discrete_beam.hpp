// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/line/beam_resultants.hpp"
#include "elements/line/discrete_beam_law.hpp"

namespace crumple::elements {

/// Springs and dampers between two nodes, which may be at one place: three forces and three moments in axes
/// that turn with the nodes, or one force along their line (docs/theory/discrete_beams.md).
struct DiscreteBeam {
  static constexpr model::BeamFormulation formulation = model::BeamFormulation::Discrete;
  static constexpr const char* name = "discrete beam";
  static constexpr bool turns = true;
  static constexpr bool can_fail = true;
  static constexpr Index energy = discrete_beam_state::energy;
  static bool fails(const BeamConstants& constants) { return constants.section_fails != 0; }

  template <class Pack>
  static BeamForces<Pack> forces(const BeamPlace& place);
};

template <class Pack>
struct DiscreteRows {
  alignas(cache_line) double displacement[discrete_directions][width_of<Pack>];
  alignas(cache_line) double before[discrete_directions][width_of<Pack>];
  alignas(cache_line) double force[discrete_directions][width_of<Pack>];
  alignas(cache_line) double history[discrete_directions * discrete_history][width_of<Pack>];
  alignas(cache_line) double free_length[width_of<Pack>];
  alignas(cache_line) double intact[width_of<Pack>];
};

/// A vector without its parts along the axes that do not turn.
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> without_held(const BeamConstants& c, const EndAxes<Pack>& axes,
                                                 math::PackVec3<Pack> v) {
  const math::PackVec3<Pack>* const axis[] = {&axes.r, &axes.s, &axes.t};
  for (std::size_t i = 0; i < 3; ++i)
    if (c.held_turn[i] != 0) v = math::multiply_add(Pack(-math::dot(v, *axis[i])), *axis[i], v);
  return v;
}

/// The axes at time n: those of n-1 turned as a whole.
template <class Pack>
CRUMPLE_INLINE EndAxes<Pack> followed_axes(const BeamPlace& place, const math::PackVec3<Pack> (&omega)[2]) {
  using Vec = math::PackVec3<Pack>;
  const BeamConstants& c = place.task.constants;
  const Index item = discrete_beam_state::axes;
  const Vec r = beam_vector<Pack>(place, item);
  const Vec s = beam_vector<Pack>(place, item + 3);
  const EndAxes<Pack> old{r, s, math::cross(r, s)};
  const Vec mean = Pack(c.first_share) * omega[0] + Pack(1 - c.first_share) * omega[1];
  const StepTurn<Pack> turn(Pack(place.task.step) * without_held(c, old, mean));
  return keep_axes<Pack>(place, item, turn.of(r), turn.of(s));
}

/// Displacements against time zero, and the sums of the relative turns of the steps.
template <class Pack>
CRUMPLE_INLINE void take_displacements(const BeamPlace& place, const math::PackVec3<Pack>& span,
                                       const EndAxes<Pack>& axes, const math::PackVec3<Pack>& turned,
                                       DiscreteRows<Pack>& rows) {
  const math::PackVec3<Pack>* const axis[] = {&axes.r, &axes.s, &axes.t};
  for (Index i = 0; i < 3; ++i) {
    const Pack now = math::dot(span, *axis[i]) - beam_item<Pack>(place, discrete_beam_state::reference + i);
    const Pack turn =
        beam_item<Pack>(place, discrete_beam_state::deformation + 3 + i) + math::dot(turned, *axis[i]);
    store(rows.displacement[i], now);
    store(rows.displacement[3 + i], turn);
  }
}

/// Of a line its stretch.
template <class Pack>
CRUMPLE_INLINE void take_stretch(const BeamPlace& place, const Pack& length, DiscreteRows<Pack>& rows) {
  const Pack zero(0.0);
  store(rows.displacement[0], Pack(length - beam_item<Pack>(place, discrete_beam_state::reference)));
  for (int i = 1; i < discrete_directions; ++i) store(rows.displacement[i], zero);
}

/// Asks the law; returns the work of the step and keeps displacements and forces.
template <class Pack>
CRUMPLE_INLINE Pack respond(const BeamPlace& place, const DiscreteBeamResponse& law, const Pack& active,
                            DiscreteRows<Pack>& rows) {
  const Pack zero(0.0);
  for (Index i = 0; i < discrete_directions; ++i) {
    // What has failed may be anywhere.
    store(rows.displacement[i], select<Pack>(active > zero, load<Pack>(rows.displacement[i]), zero));
    store(rows.before[i], beam_item<Pack>(place, discrete_beam_state::deformation + i));
  }
  constexpr Index memory = discrete_directions * discrete_history;
  if (law.has_history())
    for (Index i = 0; i < memory; ++i)
      store(rows.history[i], beam_item<Pack>(place, discrete_beam_state::history + i));
  store(rows.free_length, beam_item<Pack>(place, discrete_beam_state::reference));
  law.forces({.width = width_of<Pack>,
              .time = place.task.time,
              .step = place.task.step,
              .displacement = rows.displacement[0],
              .before = rows.before[0],
              .free_length = rows.free_length,
              .history = rows.history[0],
              .force = rows.force[0],
              .intact = rows.intact});
  if (law.has_history())
    for (Index i = 0; i < memory; ++i)
      set_beam_item(place, discrete_beam_state::history + i, load<Pack>(rows.history[i]));
  const Pack intact = active * load<Pack>(rows.intact);
  Pack work = zero;
  for (Index i = 0; i < discrete_directions; ++i) {
    const Pack force = intact * load<Pack>(rows.force[i]);
    store(rows.force[i], force);
    const Index item = discrete_beam_state::resultant + i;
    const Pack change = load<Pack>(rows.displacement[i]) - load<Pack>(rows.before[i]);
    work = multiply_add(Pack(Pack(0.5) * (beam_item<Pack>(place, item) + force)), change, work);
    set_beam_item(place, discrete_beam_state::deformation + i, load<Pack>(rows.displacement[i]));
    set_beam_item(place, item, force);
  }
  keep_beam_row(place, beam_row::intact, intact);
  return work;
}

template <class Pack>
CRUMPLE_INLINE BeamForces<Pack> DiscreteBeam::forces(const BeamPlace& place) {
  using Vec = math::PackVec3<Pack>;
  const BeamConstants& c = place.task.constants;
  const Pack zero(0.0);
  const Pack active = beam_item<Pack>(place, beam_state::active);
  const DiscreteBeamResponse law(place.task.material);
  const Vec span = beam_span<Pack>(place);
  DiscreteRows<Pack> rows;
  BeamForces<Pack> internal;
  Pack work;
  if (law.kind() == model::DiscreteBeamLaw::Kind::Axes) {
    const Vec omega[2] = {angular_velocity_of<Pack>(place, 0), angular_velocity_of<Pack>(place, 1)};
    const EndAxes<Pack> axes = followed_axes(place, omega);
    take_displacements(place, span, axes, Pack(place.task.step) * (omega[1] - omega[0]), rows);
    work = respond(place, law, active, rows);
    const auto along = [&](int first) {
      return math::multiply_add(load<Pack>(rows.force[first]), axes.r,
                                math::multiply_add(load<Pack>(rows.force[first + 1]), axes.s,
                                                   Pack(load<Pack>(rows.force[first + 2])) * axes.t));
    };
    internal.force = along(0);
    const Vec moment = along(3);
    // The axes turn with the nodes: what the forces do on their way is the nodes' moment.
    const Vec arm = without_held(c, axes, math::cross(span, internal.force));
    const Vec zero_vector{zero, zero, zero};
    internal.moment[0] = math::multiply_add(Pack(-c.first_share), arm, zero_vector) - moment;
    internal.moment[1] = math::multiply_add(Pack(c.first_share - 1), arm, zero_vector) + moment;
  } else {
    const Pack length = square_root(math::dot(span, span));
    take_stretch(place, length, rows);
    work = respond(place, law, active, rows);
    internal.force = Pack(load<Pack>(rows.force[0]) / length) * span;
    internal.moment[0] = internal.moment[1] = {zero, zero, zero};
  }
  const Pack intact = load<Pack>(place.rows + beam_row::intact * materials::tile_lanes);
  clear_where_gone(intact, internal);
  keep_beam_row(place, beam_row::internal_energy, Pack(active * work));
  keep_beam_row(place, beam_row::hourglass_energy, zero);
  const Pack limit = beam_item<Pack>(place, beam_state::stable_step);
  keep_beam_row(place, beam_row::shortest_step, select<Pack>(active > zero, limit, Pack(1e30)));
  return internal;
}

}  // namespace crumple::elements
