// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "model/model.hpp"

namespace crumple::app {

struct BoundingBox {
  std::array<double, 3> lowest{};   ///< [length]
  std::array<double, 3> highest{};  ///< [length]

  double diagonal() const;  ///< [length]
};

/// Of all nodes; all zero for a model without nodes.
BoundingBox bounding_box(const model::Model& model);

}  // namespace crumple::app
