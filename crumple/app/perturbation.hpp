// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "model/model.hpp"

namespace crumple::app {

/// Moves every node by up to `fraction` of the diagonal of the model's bounding box along each axis. The
/// displacement of a node depends on its id, the axis and the seed alone, so that studies can be repeated.
void perturb_coordinates(model::Model& model, double fraction, std::uint64_t seed);

}  // namespace crumple::app
