// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/line/beam_formulation.hpp"

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

/// The axes of one end: r is the beam's axis at time zero and then turns with the node.
template <class Pack>
struct EndAxes {
  math::PackVec3<Pack> r, s, t;
};

/// v turned by the rotation vector w of a step: v + (sin a / a) w x v + ((1 - cos a) / a^2) w x (w x v),
/// a = |w|, by the series of both factors, exact to the last digit for steps below one radian.
template <class Pack>
struct StepTurn {
  math::PackVec3<Pack> w;
  Pack first, second;

  CRUMPLE_INLINE explicit StepTurn(const math::PackVec3<Pack>& vector) : w(vector) {
    const Pack x = math::dot(w, w);
    first = Pack(1.0);
    second = Pack(1.0);
    for (int k = 9; k >= 1; --k) {
      first = multiply_add(Pack(Pack(-1.0 / (2 * k * (2 * k + 1))) * x), first, Pack(1.0));
      second = multiply_add(Pack(Pack(-1.0 / ((2 * k + 1) * (2 * k + 2))) * x), second, Pack(1.0));
    }
    second = Pack(0.5) * second;
  }
  CRUMPLE_INLINE math::PackVec3<Pack> of(const math::PackVec3<Pack>& v) const {
    const math::PackVec3<Pack> once = math::cross(w, v);
    return math::multiply_add(second, math::cross(w, once), math::multiply_add(first, once, v));
  }
};

/// The axes of an end at time n: those of n-1 turned with the node, and made orthonormal to the last digit.
template <class Pack>
CRUMPLE_INLINE EndAxes<Pack> turned_axes(const BeamPlace& place, int end) {
  using Vec = math::PackVec3<Pack>;
  const Index item = resultant_state::axes + 6 * end;
  const Vec omega = lane_vectors<Pack>(
      [&](int lane) { return place.task.angular_velocity[place.node[end * lanes + lane]]; });
  const StepTurn<Pack> turn(Pack(place.task.step) * omega);
  Vec r = turn.of(beam_vector<Pack>(place, item));
  Vec s = turn.of(beam_vector<Pack>(place, item + 3));
  // Newton's step towards unit length is enough: what is amiss is round-off.
  const Pack half(0.5);
  const Pack three_halves(1.5);
  r = Pack(three_halves - half * math::dot(r, r)) * r;
  s = math::multiply_add(Pack(-math::dot(r, s)), r, s);
  s = Pack(three_halves - half * math::dot(s, s)) * s;
  set_beam_vector(place, item, r);
  set_beam_vector(place, item + 3, s);
  return {r, s, math::cross(r, s)};
}

/// An angle by its sine and cosine, (sin + 4 tan(angle/2)) / 3, whose error is angle^5 / 120, over the sine:
/// and its derivative by the angle.
template <class Pack>
CRUMPLE_INLINE Pack angle_over_sine(const Pack& cosine) {
  return Pack(1.0 / 3.0) * (Pack(1.0) + Pack(4.0) / (Pack(1.0) + cosine));
}
template <class Pack>
CRUMPLE_INLINE Pack angle_slope(const Pack& cosine) {
  return Pack(1.0 / 3.0) * (cosine + Pack(4.0) / (Pack(1.0) + cosine));
}

/// How the chord e leans in the axes of an end.
template <class Pack>
struct Lean {
  Pack cosine;                   ///< e . r
  Pack s, t;                     ///< e . s and e . t
  Pack factor;                   ///< angle over sine
  math::PackVec3<Pack> upright;  ///< s turned by the smallest rotation that takes r onto the chord
};
template <class Pack>
CRUMPLE_INLINE Lean<Pack> lean_of(const EndAxes<Pack>& axes, const math::PackVec3<Pack>& chord) {
  const Pack cosine = math::dot(chord, axes.r);
  const Pack s = math::dot(chord, axes.s);
  const Pack part = s / (Pack(1.0) + cosine);
  return {cosine, s, math::dot(chord, axes.t), angle_over_sine(cosine),
          math::multiply_add(Pack(-part), axes.r + chord, axes.s)};
}

/// A pair of numbers about s and t.
template <class Pack>
struct About {
  Pack s, t;
};
/// Components in axes that are turned by an angle about r.
template <class Pack>
CRUMPLE_INLINE About<Pack> in_turned(const About<Pack>& v, const Pack& cosine, const Pack& sine) {
  return {multiply_add(cosine, v.s, Pack(sine * v.t)), multiply_add(cosine, v.t, Pack(-(sine * v.s)))};
}

/// Derivative of the bending energy by the chord, while the end is held, given the moments in the end's axes.
/// The moment on the end is its cross product with the chord.
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> by_chord(const EndAxes<Pack>& axes, const Lean<Pack>& lean,
                                             const About<Pack>& moment) {
  const Pack whole = Pack(1.0) + lean.cosine;
  const Pack factor_slope = Pack(-4.0 / 3.0) / (whole * whole);
  const Pack along_r = factor_slope * multiply_add(moment.s, lean.t, Pack(-(moment.t * lean.s)));
  const math::PackVec3<Pack> across = Pack(lean.factor * moment.s) * axes.t;
  return math::multiply_add(Pack(-(lean.factor * moment.t)), axes.s,
                            math::multiply_add(along_r, axes.r, across));
}

/// Bending moments of both ends about one axis: E I / (l (1 + f)) (4 + f, 2 - f; 2 - f, 4 + f), f = 12 E I /
/// (G A_s l^2).
template <class Pack>
struct BendingStiffness {
  Pack same, other;

  CRUMPLE_INLINE BendingStiffness(double bending, double shear, const Pack& length) {
    Pack f(0.0);
    if (shear > 0) f = Pack(12 * bending / shear) / (length * length);
    const Pack k = Pack(bending) / (length * (Pack(1.0) + f));
    same = k * (Pack(4.0) + f);
    other = k * (Pack(2.0) - f);
  }
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

/// Work of the step of one pair of conjugate numbers, added to `work`; keeps the new ones.
template <class Pack>
CRUMPLE_INLINE void add_work(const BeamPlace& place, Index which, const Pack& deformation,
                             const Pack& resultant, Pack& work) {
  const Index d = resultant_state::deformation + which;
  const Index q = resultant_state::resultant + which;
  const Pack change = deformation - beam_item<Pack>(place, d);
  work = multiply_add(Pack(Pack(0.5) * (beam_item<Pack>(place, q) + resultant)), change, work);
  set_beam_item(place, d, deformation);
  set_beam_item(place, q, resultant);
}

template <class Pack>
CRUMPLE_INLINE BeamForces<Pack> BelytschkoSchwer::forces(const BeamPlace& place) {
  using Vec = math::PackVec3<Pack>;
  const BeamConstants& c = place.task.constants;
  const Pack one(1.0);
  const Pack half(0.5);
  const Pack active = beam_item<Pack>(place, beam_state::active);
  const Pack l0 = beam_item<Pack>(place, beam_state::reference_length);
  const Vec span = beam_span<Pack>(place);
  const Pack length = square_root(math::dot(span, span));
  const Vec e = Pack(one / length) * span;
  const EndAxes<Pack> axes[2] = {turned_axes<Pack>(place, 0), turned_axes<Pack>(place, 1)};
  const Lean<Pack> lean[2] = {lean_of(axes[0], e), lean_of(axes[1], e)};

  // Twist from the first end to the second, and the turns of both in the axes half way between.
  const Pack cosine = math::dot(lean[0].upright, lean[1].upright);
  const Pack sine = math::dot(e, math::cross(lean[0].upright, lean[1].upright));
  const Pack twist = sine * angle_over_sine(cosine);
  const Pack half_cosine = square_root(larger(Pack(0.0), Pack(half * (one + cosine))));
  const Pack half_sine = half * sine / half_cosine;
  const auto turn_of = [&](int end) {
    return About<Pack>{lean[end].factor * lean[end].t, -(lean[end].factor * lean[end].s)};
  };
  const About<Pack> first = in_turned(turn_of(0), half_cosine, half_sine);
  const About<Pack> second = in_turned(turn_of(1), half_cosine, Pack(-half_sine));

  const Pack stretch = length - l0;
  const BeamStiffness<Pack> stiffness(c, l0);
  const Pack torsion = Pack(c.twisting) / l0 * twist;
  BeamElastic<Pack> elastic{stretch, {first, second}};
  if (c.plastic != 0) elastic = less_plastic(place, stiffness, elastic);
  const Pack axial = stiffness.axial * elastic.stretch;
  const About<Pack> m1 = stiffness.moment(elastic.turn, 0);
  const About<Pack> m2 = stiffness.moment(elastic.turn, 1);

  Pack work(0.0);
  add_work(place, 0, stretch, axial, work);
  add_work(place, 1, twist, torsion, work);
  add_work(place, 2, first.s, m1.s, work);
  add_work(place, 3, first.t, m1.t, work);
  add_work(place, 4, second.s, m2.s, work);
  add_work(place, 5, second.t, m2.t, work);
  keep_beam_row(place, beam_row::internal_energy, Pack(active * work));
  keep_beam_row(place, beam_row::hourglass_energy, Pack(0.0));
  keep_stable_step(place, active, length);

  // Derivative of the energy by the twist; the axes half way turn with it.
  const Pack swing = multiply_add(m1.s, first.t, Pack(-(m1.t * first.s))) -
                     multiply_add(m2.s, second.t, Pack(-(m2.t * second.s)));
  const Pack t = active * multiply_add(angle_slope(cosine), torsion, Pack(half * swing));
  const auto back = [&](const About<Pack>& m, const Pack& s) {
    const About<Pack> own = in_turned(m, half_cosine, s);
    return About<Pack>{active * own.s, active * own.t};
  };
  const Vec h[2] = {by_chord(axes[0], lean[0], back(m1, Pack(-half_sine))),
                    by_chord(axes[1], lean[1], back(m2, half_sine))};
  Vec torque[2];
  Vec sweep[2];
  for (int end = 0; end < 2; ++end) {
    const Pack share = t / (one + lean[end].cosine);
    torque[end] = share * (axes[end].r + e);
    sweep[end] = share * math::cross(axes[end].r, e);
  }
  const Vec slope = ((h[0] + h[1]) - sweep[1]) + sweep[0];
  const Vec across = math::multiply_add(Pack(-math::dot(slope, e)), e, slope);
  BeamForces<Pack> internal;
  internal.force = math::multiply_add(Pack(active * axial), e, Pack(one / length) * across);
  internal.moment[0] = math::cross(h[0], e) - torque[0];
  internal.moment[1] = math::cross(h[1], e) + torque[1];
  return internal;
}

}  // namespace crumple::elements
