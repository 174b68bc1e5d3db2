// SPDX-License-Identifier: BSD-3-Clause
#include "app/preparation/bounding_box.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::app {

double BoundingBox::diagonal() const {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    sum += (highest[axis] - lowest[axis]) * (highest[axis] - lowest[axis]);
  return std::sqrt(sum);
}

BoundingBox bounding_box(const model::Model& model) {
  BoundingBox box;
  if (model.nodes.count() == 0) return box;
  box.lowest = box.highest = model.nodes.position[0];
  for (const auto& position : model.nodes.position)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lowest[axis] = std::min(box.lowest[axis], position[axis]);
      box.highest[axis] = std::max(box.highest[axis], position[axis]);
    }
  return box;
}

}  // namespace crumple::app
