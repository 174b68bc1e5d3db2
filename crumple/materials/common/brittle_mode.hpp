// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/mixed_mode.hpp"

namespace crumple::materials {

/// The mode, "tension", "shear" or "mixed modes" (of rays a degree apart), in which a bond would store more
/// up to its strength than it may take in all, so that its traction could not fall over a separation; empty
/// if there is none.
const char* brittle_mode(const MixedMode<double>& law);

}  // namespace crumple::materials
