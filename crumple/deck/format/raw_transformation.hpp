// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"
#include "deck/format/affine.hpp"
#include "deck/format/report.hpp"

namespace crumple::deck {

/// What *DEFINE_TRANSFORMATION says.
struct RawTransformation {
  UserId id = 0;
  Affine map;
  Where where;
};

/// Nodes of a set that a transformation moves before the run.
struct RawNodeTransform {
  UserId transformation = 0;
  UserId node_set = 0;
  Where where;
};

}  // namespace crumple::deck
