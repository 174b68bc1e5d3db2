// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/index.hpp"
#include "contact/surface/segment_shape.hpp"
#include "contact/surface/surface.hpp"
#include "math/vec3.hpp"

// Pinballs: balls that are embedded in the segments and touch in their place (T. Belytschko & M.O. Neal,
// Int. J. Numer. Meth. Engng 31 (1991) 547-572). As in the splitting method (T. Belytschko & I.S. Yeh,
// Comput. Methods Appl. Mech. Engng 105 (1993) 375-393) each segment holds a tree of them: a ball around the
// whole, four around its quarters, and so on down to the ones that touch. docs/theory/contact.md says what is
// ours.

namespace crumple::contact {

/// The pinballs of the segments of a surface. The smallest are a lattice of 2^level x 2^level balls over each
/// segment, so dense that nothing passes between them; those of shells have the contact thickness, where that
/// is not too thin for it; those of faces lie below the face, which they touch from inside.
struct Pinballs {
  std::vector<double> radius;       ///< of the smallest, by segment [length]
  std::vector<std::int32_t> level;  ///< by segment
};

/// Chooses radius and level of all segments from the geometry at `x`.
Pinballs embed_pinballs(const Surface& surface, const Configuration& x);

/// Of the centres of the smallest balls above the segment, mostly below zero; zero for shells. A face with a
/// thickness of its own, as SLDTHK gives it, has its balls that much higher [length].
double ball_height(const Surface& surface, const Pinballs& pinballs, Index segment);

/// A segment with its pinballs, where it is now.
struct PinballShape {
  SegmentShape segment;
  double radius = 0;  ///< of the smallest balls [length]
  int level = 0;
  double half_diagonal =
      0;      ///< bound on the way from the middle to any place; of a part on level n, over 2^n
  Vec3 sunk;  ///< from the face to the centres below it; zero for shells [length]
};

PinballShape pinball_shape(const Surface& surface, const Pinballs& pinballs, const Configuration& x,
                           Index segment);

/// Where the smallest balls of two segments overlap most.
struct PinballOverlap {
  std::array<double, 4> first{};   ///< weights of the nodes of the first segment at its ball's centre
  std::array<double, 4> second{};  ///< likewise
  Vec3 away;                       ///< from the second centre to the first [length]
  double depth = 0;                ///< sum of the radii less the distance of the centres [length]
};

/// The deepest overlap that exceeds `least`, if there is any; of equal ones the first by the order of the
/// lattices. With a negative `least` the balls may be apart by that, and the depth is negative [length].
std::optional<PinballOverlap> deepest_overlap(const PinballShape& first, const PinballShape& second,
                                              double least = 0);

/// Sets the half diagonal of a shape whose corners are known.
void measure_diagonal(PinballShape& shape);

/// Lower bound on the distance between the balls of two segments, from the ball around each; 0 if these
/// overlap [length].
double distance_at_least(const PinballShape& first, const PinballShape& second);

}  // namespace crumple::contact
