// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace crumple::contact {

/// Force between a node and a segment over their penetration d [length]. Linear with the penalty stiffness k
/// until half of the reach is used up; from there on the slope grows linearly, to 10 k at the mid-surface and
/// further behind it. It never exceeds the limit that stability sets. The force has a potential as long as
/// the limit does not change.
struct PenaltyLaw {
  double stiffness = 0;  ///< k [force/length]
  double limit = 0;      ///< largest slope [force/length]
  double reach = 0;      ///< penetration at which the node is on the mid-surface [length]

  /// Repelling force [force], zero for d <= 0.
  double force(double penetration) const;
  /// Work that it takes to get to d [energy].
  double energy(double penetration) const;
  /// Penetration that takes that work, `most` if that takes less [length].
  double penetration_of(double work, double most) const;
  /// True if the slope at d would be larger without the limit.
  bool is_limited_at(double penetration) const;

 private:
  double growth() const;
  double even_slope() const;
  bool grows() const;
};

/// What the penalty remembers of a touch from one step to the next.
struct PenaltyMemory {
  double stiffness = 0;    ///< by masses and step, or of a node of solids; 0 if there was none [force/length]
  double raised = 0;       ///< to hold the depth, at least this; 0 if it never was [force/length]
  double slope_limit = 0;  ///< largest slope of the force by stability; 0 if there was none [force/length]
  double rest_depth = 0;  ///< penetration at which the force begins, where the slope grew under load [length]
  double depth = 0;       ///< penetration beyond that [length]
  double speed = 0;       ///< at which the two points part [length/time]
  double force = 0;       ///< of the spring, without damping [force]
  double energy = 0;      ///< absorbed by the spring and not yet returned [energy]
  double most_energy = 0;  ///< largest value of that since the touch began [energy]
};

/// Largest force of a passive spring between two points: one that returns no more energy than it has
/// absorbed. Central differences keep speed^2 + omega^2 x(n) x(n+1) in a spring; with `energy`, what the
/// spring holds after the movement at `speed` with the force of the step before, k x(n-1) x(n) / 2, that
/// speed is the largest with which the points may part in the next step:
///
///     speed' = speed + force dt / m* <= sqrt(speed^2 + 2 energy / m*)
///
/// A linear spring with omega dt < 1 never reaches it (own derivation, docs/theory/contact.md). `speed`: at
/// which the points part, negative where they approach [length/time]; `inverse_mass`: 1/m* [1/mass].
double passive_force(double energy, double speed, double inverse_mass, double step);

/// (omega dt)^2 that contact may add in a step that uses the share `step_scale` (TSSFAC) of the stable step
/// of the elements: 4 - 4 TSSFAC^2 is left of the stability bound 4 of central differences, of which 0.9 is
/// used; never more than 1, and never less than 0.1. Nor more than 3.5 times the scale of the penalty
/// stiffness (SLSFAC SFS): with the usual 0.1 an impact takes five steps or more, by which its energy is kept
/// to a per cent.
double stability_budget(double step_scale, double stiffness_scale = 1);

/// Factor on the force in the first step of a contact. Central differences take the node into the surface by
/// a part of a step, and with the full force of that depth they lose (omega dt)^2 a (1 - a) of the kinetic
/// energy, with a the depth over the approach in the step. With this factor the first step keeps the
/// invariant of the scheme, v(n+1/2)^2 + omega^2 x(n) x(n+1) (own derivation). `depth`: a; 1 if that is 1 or
/// more. `square`: (omega dt)^2 of the contact, below 1. `next`: the next step over this one.
double landing_factor(double depth, double square, double next = 1);

/// The same for the last step, mirrored in time. `depth`: penetration over the movement outwards in the last
/// step; returns 1 if the node will still be inside after the next.
double leaving_factor(double depth, double square);

/// Factor on the stiffness limit with viscous damping of `fraction` of critical, computed with velocities
/// half a step old: the stable step shrinks by sqrt(1 + x^2) - x.
double damping_factor(double fraction);

/// exp(-x) for x >= 0 without libm, whose last bits differ between processors. Relative error below 5e-13
/// for x < 690.
double decay(double x);

}  // namespace crumple::contact
