// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"
#include "domain/element_block.hpp"
#include "elements/common/point_tile.hpp"

namespace crumple::elements {

// Elements go whose own stable step falls below a limit of their material (TDEL, DTMIN of *MAT_ADD_EROSION):
// docs/theory/erosion.md. The step is known when the forces of the old stress have been made, so the stress
// is taken in the next one, as that of other failed points is.

/// Elements of one block that their step makes go.
struct ShortSteps {
  double least = 0;  ///< stable step [time]; 0: none goes
  Index item = 0;    ///< component of the item "short_step": 1 once the step was too short
};

/// What the block says.
ShortSteps short_steps(const domain::ElementBlock& block);

/// Adds the item to a block under construction, if it has a limit.
void declare_short_steps(domain::ElementBlock& block);

/// After the law: takes the stress from elements that were marked, with its share in the work of the step,
/// and leaves in `intact` that they go.
template <class Real>
void end_short_elements(const ShortSteps& steps, const PointTile<Real>& tile);

/// After the forces: marks those whose stable step, a row of the scratch, is below the least one. Elements
/// that have gone set no step.
template <class Real>
void mark_short_elements(const ShortSteps& steps, const PointTile<Real>& tile, const Real* limit);

}  // namespace crumple::elements
