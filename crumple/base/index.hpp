// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace crumple {

/// Local number of a node, element or part in its array. 32 bits: a domain holds less than 2^31 of each.
using Index = std::int32_t;

/// "None": no node, no part, no element.
inline constexpr Index no_index = -1;

/// A number that the user gave an item in the deck. Appears in input and output only.
using UserId = std::int64_t;

}  // namespace crumple
