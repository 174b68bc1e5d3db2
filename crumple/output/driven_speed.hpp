// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/results/view.hpp"

namespace crumple::output {

/// The largest speed that the model is given now: of the nodes that a motion is prescribed to, of rigid
/// bodies, of walls, and the mean speed of the points where forces and pressures act [length/time].
double driven_speed(const View& view);

}  // namespace crumple::output
