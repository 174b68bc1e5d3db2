// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/touch_notes.hpp"

namespace crumple::contact {

void TouchNotes::note_withheld(const Touch& touch, UserId node, UserId segment) const {
  domain::WithheldForces& withheld = report.withheld;
  ++withheld.count;
  if (touch.withheld <= withheld.largest) return;
  withheld.largest = touch.withheld;
  withheld.cycle = cycle;
  withheld.node = node;
  withheld.segment = segment;
}

void TouchNotes::note_force(const Touch& touch, UserId node, double offset) const {
  const double force = norm(touch.normal_force);
  if (force == 0) return;
  domain::OverlapForces& found = report.overlap_forces;
  found.impulse += step * force;
  if (offset <= 0) return;
  found.overlap_impulse += step * force;
  if (force <= found.largest) return;
  found.largest = force;
  found.node = node;
}

}  // namespace crumple::contact
