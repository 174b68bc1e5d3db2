// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model/model.hpp"

namespace crumple::golden {

/// A short run in which much acts at once. Between them the cases have every formulation, most materials,
/// contact, erosion, walls, loads and thickness rules.
struct Case {
  const char* name;
  model::Model (*make)();
};

const std::vector<Case>& cases();

}  // namespace crumple::golden
