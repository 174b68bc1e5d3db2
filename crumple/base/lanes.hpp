// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"

namespace crumple {

/// Elements per group of the state layout: state[group][component][lane]. The same for every instruction set,
/// so that a state written by one can be read by another; a kernel walks a group in packs of its own width.
/// Apart from base/pack.hpp, whose <experimental/simd> takes every compiler more than a second to read.
inline constexpr Index lanes = 16;

}  // namespace crumple
