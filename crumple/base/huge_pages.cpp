// SPDX-License-Identifier: BSD-3-Clause
#include "base/huge_pages.hpp"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace crumple {

void ask_for_huge_pages([[maybe_unused]] void* start, [[maybe_unused]] std::size_t bytes) {
#if defined(MADV_HUGEPAGE)
  // Whole ones only: the next array's pages are none of ours.
  madvise(start, bytes / huge_page * huge_page, MADV_HUGEPAGE);
#endif
}

}  // namespace crumple
