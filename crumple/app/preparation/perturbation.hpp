// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "model/model.hpp"

namespace crumple::app {

/// Moves every node by up to `fraction` of the diagonal of the model's bounding box along each axis. The
/// displacement of a node depends on its place, the axis and the seed alone: studies can be repeated, and
/// nodes at one place (ties, rivets, parts that share an edge) stay together.
void perturb_coordinates(model::Model& model, double fraction, std::uint64_t seed);

}  // namespace crumple::app
