// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"
#include "contact/surface/inside_outside.hpp"

namespace crumple::contact {

/// Whether a node went through the mid-surface of a segment during the step that led to `now`, in which all
/// nodes moved along straight lines. Returns the side from which it came (+1 or -1), 0 if it did not cross or
/// crossed back again. `step` is the length of the step [time].
int crossed_from(const SurfaceAt& now, Index node, Index segment, double step);

/// The side of the segment's normal on which the node was before the last step; 0 if it was on the
/// mid-surface.
int side_before(const SurfaceAt& now, Index node, Index segment, double step);

/// Bound on the distance that a node moves relative to the nodes of a segment in a step [length].
double relative_motion(const SurfaceAt& now, Index node, Index segment, double step);

}  // namespace crumple::contact
