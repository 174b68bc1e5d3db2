// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "domain/element_block.hpp"
#include "model/stiffness_damping.hpp"

namespace crumple::domain {

/// Elements that may have damping in proportion to their stiffness. With it shells and solids have an item
/// "damping", the stable step without it and [point][stress], and beams one of their resultants.
struct DampedBlock : ElementBlock {
  std::optional<model::StiffnessDamping> damping;
  std::array<double, 3> damping_moduli{};  ///< elastic: along a strain, across it, of a shear [stress]
};

}  // namespace crumple::domain
