// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace crumple::deck {

/// Letters to insert, remove or replace to make one text of another (Levenshtein's distance).
std::size_t edit_distance(std::string_view one, std::string_view other);

}  // namespace crumple::deck
