// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

/// Contact search between nodes and segments of a mesh: for every segment the nodes inside its expanded
/// bounding box. After F. Wang, J. Cheng, Z. Yao, "A contact searching algorithm for contact-impact
/// problems", Acta Mechanica Sinica 16(4), 2000 ("the paper" in all comments of this library).
namespace cellsearch {

/// Number of a node, segment or cell, counted from 0. Negative values mean "none".
using Index = std::int32_t;

/// Position in, or length of, something that may outgrow 32 bits (pairs, visits).
using Offset = std::int64_t;

/// A point: x, y, z [length].
using Point = std::array<double, 3>;

}  // namespace cellsearch
