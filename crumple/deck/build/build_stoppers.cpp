// SPDX-License-Identifier: BSD-3-Clause
// Bounds of the motion of rigid bodies.
#include <fmt/core.h>

#include <cmath>
#include <cstdlib>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

using Bound = model::RigidBodyStopper::Bound;

/// A curve, of the displacement where it is below zero; nothing, with a message, if there is none.
std::optional<Bound> bound_of(Build& build, UserId curve, std::string_view field, const Where& where) {
  Bound bound;
  if (curve == 0) return bound;
  bound.curve = find_points(build, {std::abs(curve), field, where});
  bound.is_displacement = curve < 0;
  if (bound.curve == no_index) return std::nullopt;
  return bound;
}

/// The direction that DIR names, if it is one of the axes in which the body can be held.
std::optional<Vector> direction_of(Build& build, const RawStopper& raw, const model::RigidBody& body) {
  Vector direction{};
  if (raw.direction <= 3) {
    direction[static_cast<std::size_t>(raw.direction) - 1] = 1;
  } else {
    const std::optional<Vector> found = find_vector(build, raw.vector, "VID", raw.where);
    if (!found) return found;
    direction = *found;
  }
  constexpr double along = 1 - 1e-12;
  for (const auto& axis : body.held_axes)
    if (std::fabs(dot(axis, direction)) >= along) return direction;
  build.report.field_unsupported(
      raw.where, {"DIR", std::to_string(raw.direction), "a direction along the axes that hold the body",
                  "these are the global ones, or those of CMO = -1 of *MAT_RIGID", "axes"});
  return std::nullopt;
}

}  // namespace

void build_stoppers(Build& build) {
  for (const RawStopper& raw : build.deck.stoppers) {
    const Index body = build.find(Item::RigidBody, {raw.part, "PID", raw.where});
    if (body == no_index) continue;
    const auto direction = direction_of(build, raw, build.model.rigid_bodies[static_cast<std::size_t>(body)]);
    const auto largest = bound_of(build, raw.largest, "LCMAX", raw.where);
    const auto smallest = bound_of(build, raw.smallest, "LCMIN", raw.where);
    const auto speed = bound_of(build, raw.speed, "LCVMNX", raw.where);
    if (!direction || !largest || !smallest || !speed) continue;
    if (raw.largest == 0 && raw.smallest == 0 && raw.speed == 0) {
      build.report.warning(raw.where, "empty", "it has neither LCMAX, LCMIN nor LCVMNX, and stops nothing");
      continue;
    }
    build.model.rigid_body_stoppers.push_back(
        {body, *direction, *largest, *smallest, speed->curve, raw.birth, raw.death});
  }
}

}  // namespace crumple::deck
