// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/array.hpp"

#include <cstdlib>
#include <limits>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace cellsearch {
namespace {

constexpr std::size_t line = 64;
constexpr std::size_t huge_page = std::size_t{1} << 21;

}  // namespace

void* allocate_memory(std::size_t bytes) {
  const std::size_t alignment = bytes < 2 * huge_page ? line : huge_page;
  if (bytes > std::numeric_limits<std::size_t>::max() - alignment) throw std::bad_alloc();
  const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, whole == 0 ? alignment : whole);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
  // A wish, not a need: the result does not matter.
  if (alignment == huge_page) static_cast<void>(madvise(memory, whole, MADV_HUGEPAGE));
#endif
  return memory;
}

void release_memory(void* memory) noexcept {
  std::free(memory);
}

}  // namespace cellsearch
