// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace crumple {

/// Arrays from this size on begin where a huge page may, in bytes.
inline constexpr std::size_t huge_page = std::size_t{2} << 20;

/// Asks the system to back memory that nobody has touched yet with huge pages: a step walks through all
/// arrays, and with pages of 4 KiB the processor has forgotten where they are each time. A hint; nothing
/// where it does not exist.
void ask_for_huge_pages(void* start, std::size_t bytes);

}  // namespace crumple
