// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include <cellsearch/motion_tracker.hpp>

#include "base/index.hpp"
#include "math/vec3.hpp"

namespace crumple::contact {

using math::Vec3;

/// How far any two of a set of nodes have moved relative to each other along their way: the sum, over legs,
/// of the largest relative displacement within each. A distance between two of them, measured at any time,
/// so has a lower bound ever after. Legs are short, as a bound counts the motion of its own leg twice.
///
/// To measure a displacement all positions must be read. Who knows a bound on the way of each step spares
/// most of that: a leg is measured only when the steps since it was may have exceeded its limit, and where
/// measuring finds hardly less than the steps add up to, as in a crash, steps are legs of their own for a
/// while. Where nodes go to and fro, the legs are measured on.
class Travel {
 public:
  /// `leg_limit`: relative displacement at which a leg ends [length].
  Travel(double leg_limit, int threads) : leg_limit_(leg_limit), tracker_(0, 0, threads) {}

  /// Begins the way of these domain nodes.
  void start(std::span<const Vec3> position, std::span<const Index> nodes);

  /// To be told every step. `step_way`: no two nodes have moved further relative to each other since the last
  /// time, but for rounding; infinite if nobody knows [length]. Throws cellsearch::Error, with the number of
  /// the domain node, if a coordinate is found that is not a finite number, which it always is where the way
  /// is not finite.
  void update(std::span<const Vec3> position, double step_way);

  /// The bound on the way since the start; never shrinks [length].
  double length() const { return earlier_legs_ + leg_; }

  /// Two places that now are `distance` apart cannot meet before length() exceeds this [length].
  double length_to_meet(double distance) const { return earlier_legs_ + distance - leg_; }

 private:
  void measure(std::span<const Vec3> position);
  void end_leg(std::span<const Vec3> position);

  double leg_limit_;
  cellsearch::MotionTracker tracker_;  ///< of the present leg
  double earlier_legs_ = 0;
  double leg_ = 0;       ///< largest of the present leg so far
  double measured_ = 0;  ///< displacement when the leg was last measured
  double since_ = 0;     ///< steps since then, added up
  double steps_ = 0;     ///< steps of the leg, added up; of all since a leg was measured while steps are legs
  int steps_as_legs_ = 0;  ///< how many more
};

}  // namespace crumple::contact
