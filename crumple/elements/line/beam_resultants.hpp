// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What beams of resultants share, whatever their law: how far the ends of a beam have moved against its
// chord, and the forces at its nodes, the exact derivatives of those deformations (docs/theory/beams.md).
// Order of calls: beam_motion(), the law, with_damping(), keep_work(), beam_forces().

#include "elements/line/beam_formulation.hpp"

namespace crumple::elements {

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

/// Of one end of each beam of the pack [1/time].
template <class Pack>
CRUMPLE_INLINE math::PackVec3<Pack> angular_velocity_of(const BeamPlace& place, int end) {
  return lane_vectors<Pack>(
      [&](int lane) { return place.task.angular_velocity[place.node[end * lanes + lane]]; });
}

/// Makes r and s orthonormal to the last digit and keeps them as items of the state from `item` on. Newton's
/// step towards unit length is enough: what is amiss is round-off.
template <class Pack>
CRUMPLE_INLINE EndAxes<Pack> keep_axes(const BeamPlace& place, Index item, math::PackVec3<Pack> r,
                                       math::PackVec3<Pack> s) {
  const Pack half(0.5);
  const Pack three_halves(1.5);
  r = Pack(three_halves - half * math::dot(r, r)) * r;
  s = math::multiply_add(Pack(-math::dot(r, s)), r, s);
  s = Pack(three_halves - half * math::dot(s, s)) * s;
  set_beam_vector(place, item, r);
  set_beam_vector(place, item + 3, s);
  return {r, s, math::cross(r, s)};
}

/// The axes of an end at time n: those of n-1 turned with the node.
template <class Pack>
CRUMPLE_INLINE EndAxes<Pack> turned_axes(const BeamPlace& place, int end) {
  const Index item = resultant_state::axes + 6 * end;
  const StepTurn<Pack> turn(Pack(place.task.step) * angular_velocity_of<Pack>(place, end));
  return keep_axes<Pack>(place, item, turn.of(beam_vector<Pack>(place, item)),
                         turn.of(beam_vector<Pack>(place, item + 3)));
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

/// Deformations of the beams of a pack, and what its forces need of their geometry.
template <class Pack>
struct BeamMotion {
  Pack length;
  math::PackVec3<Pack> e;  ///< along the chord
  EndAxes<Pack> axes[2];
  Lean<Pack> lean[2];
  Pack cosine;                  ///< of the twist
  Pack half_cosine, half_sine;  ///< of half of it
  Pack stretch, twist;
  About<Pack> turn[2];  ///< of the ends against the chord, in the axes half way between
};

/// What there is of an intact beam. What has failed may have any shape, and numbers that are none.
template <class Pack>
CRUMPLE_INLINE void clear_where_gone(const Pack& active, BeamMotion<Pack>& motion) {
  const auto clear = [&](Pack& number) { number = select<Pack>(active > Pack(0.0), number, Pack(0.0)); };
  clear(motion.stretch);
  clear(motion.twist);
  for (About<Pack>& turn : motion.turn) {
    clear(turn.s);
    clear(turn.t);
  }
}

/// Brings the axes of the ends up to time n, and finds the deformations there.
template <class Pack>
CRUMPLE_INLINE BeamMotion<Pack> beam_motion(const BeamPlace& place) {
  using Vec = math::PackVec3<Pack>;
  const Pack one(1.0);
  const Pack half(0.5);
  const Vec span = beam_span<Pack>(place);
  BeamMotion<Pack> motion;
  motion.length = square_root(math::dot(span, span));
  const Vec e = Pack(one / motion.length) * span;
  motion.e = e;
  for (int end = 0; end < 2; ++end) {
    motion.axes[end] = turned_axes<Pack>(place, end);
    motion.lean[end] = lean_of(motion.axes[end], e);
  }
  const Lean<Pack>(&lean)[2] = motion.lean;

  // Twist from the first end to the second, and the turns of both in the axes half way between.
  motion.cosine = math::dot(lean[0].upright, lean[1].upright);
  const Pack sine = math::dot(e, math::cross(lean[0].upright, lean[1].upright));
  motion.twist = sine * angle_over_sine(motion.cosine);
  motion.half_cosine = square_root(larger(Pack(0.0), Pack(half * (one + motion.cosine))));
  motion.half_sine = half * sine / motion.half_cosine;
  const auto turn_of = [&](int end) {
    return About<Pack>{lean[end].factor * lean[end].t, -(lean[end].factor * lean[end].s)};
  };
  motion.turn[0] = in_turned(turn_of(0), motion.half_cosine, motion.half_sine);
  motion.turn[1] = in_turned(turn_of(1), motion.half_cosine, Pack(-motion.half_sine));
  motion.stretch = motion.length - beam_item<Pack>(place, beam_state::reference_length);
  return motion;
}

/// What is conjugate to the deformations: axial force, torsion, moments on the ends in the axes half way.
template <class Pack>
struct BeamResultants {
  Pack axial, torsion;
  About<Pack> moment[2];
};

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

/// Brings deformations and resultants of the state up to date; returns the work of the step.
template <class Pack>
CRUMPLE_INLINE Pack keep_work(const BeamPlace& place, const BeamMotion<Pack>& motion,
                              const BeamResultants<Pack>& q) {
  Pack work(0.0);
  add_work(place, 0, motion.stretch, q.axial, work);
  add_work(place, 1, motion.twist, q.torsion, work);
  add_work(place, 2, motion.turn[0].s, q.moment[0].s, work);
  add_work(place, 3, motion.turn[0].t, q.moment[0].t, work);
  add_work(place, 4, motion.turn[1].s, q.moment[1].s, work);
  add_work(place, 5, motion.turn[1].t, q.moment[1].t, work);
  return work;
}

/// Resultants with those of damping in proportion to the elastic stiffness, which is none where `intact` is
/// zero. Leaves its work; to be called before keep_work().
template <class Pack>
CRUMPLE_INLINE BeamResultants<Pack> with_damping(const BeamPlace& place, const BeamMotion<Pack>& motion,
                                                 const BeamResultants<Pack>& q, const Pack& intact) {
  if (place.task.damping_item == 0) return q;
  const BeamConstants& c = place.task.constants;
  const Pack l0 = beam_item<Pack>(place, beam_state::reference_length);
  const Pack share = intact * damping_share(place, motion.length);
  const Pack deformation[6] = {motion.stretch,   motion.twist,     motion.turn[0].s,
                               motion.turn[0].t, motion.turn[1].s, motion.turn[1].t};
  Pack change[6];
  for (int i = 0; i < 6; ++i)
    change[i] = deformation[i] - beam_item<Pack>(place, resultant_state::deformation + i);
  const BendingStiffness<Pack> about_s(c.bending_s, c.shear_stiffness, l0);
  const BendingStiffness<Pack> about_t(c.bending_t, c.shear_stiffness, l0);
  const auto moment = [&](const BendingStiffness<Pack>& k, int own, int other) {
    return multiply_add(k.same, change[own], Pack(k.other * change[other]));
  };
  Pack more[6] = {Pack(c.youngs_modulus * c.area) / l0 * change[0],
                  Pack(c.twisting) / l0 * change[1],
                  moment(about_s, 2, 4),
                  moment(about_t, 3, 5),
                  moment(about_s, 4, 2),
                  moment(about_t, 5, 3)};
  Pack work(0.0);
  for (int i = 0; i < 6; ++i) {
    more[i] = share * more[i];
    const Index item = place.task.damping_item + i;
    work = multiply_add(Pack(Pack(0.5) * (beam_item<Pack>(place, item) + more[i])), change[i], work);
    set_beam_item(place, item, more[i]);
  }
  const Pack active = beam_item<Pack>(place, beam_state::active);
  keep_beam_row(place, beam_row::damping_energy, Pack(active * work));
  return {q.axial + more[0],
          q.torsion + more[1],
          {{q.moment[0].s + more[2], q.moment[0].t + more[3]},
           {q.moment[1].s + more[4], q.moment[1].t + more[5]}}};
}

/// Forces and moments on the nodes; none where `active` is zero.
template <class Pack>
CRUMPLE_INLINE BeamForces<Pack> beam_forces(const BeamMotion<Pack>& motion, const BeamResultants<Pack>& q,
                                            const Pack& active) {
  using Vec = math::PackVec3<Pack>;
  const Pack one(1.0);
  const Pack half(0.5);
  const Vec& e = motion.e;
  const EndAxes<Pack>(&axes)[2] = motion.axes;
  const Lean<Pack>(&lean)[2] = motion.lean;
  const About<Pack>& m1 = q.moment[0];
  const About<Pack>& m2 = q.moment[1];

  // Derivative of the energy by the twist; the axes half way turn with it.
  const Pack swing = multiply_add(m1.s, motion.turn[0].t, Pack(-(m1.t * motion.turn[0].s))) -
                     multiply_add(m2.s, motion.turn[1].t, Pack(-(m2.t * motion.turn[1].s)));
  const Pack t = active * multiply_add(angle_slope(motion.cosine), q.torsion, Pack(half * swing));
  const auto back = [&](const About<Pack>& m, const Pack& s) {
    const About<Pack> own = in_turned(m, motion.half_cosine, s);
    return About<Pack>{active * own.s, active * own.t};
  };
  const Vec h[2] = {by_chord(axes[0], lean[0], back(m1, Pack(-motion.half_sine))),
                    by_chord(axes[1], lean[1], back(m2, motion.half_sine))};
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
  internal.force = math::multiply_add(Pack(active * q.axial), e, Pack(one / motion.length) * across);
  internal.moment[0] = math::cross(h[0], e) - torque[0];
  internal.moment[1] = math::cross(h[1], e) + torque[1];
  return internal;
}

}  // namespace crumple::elements
