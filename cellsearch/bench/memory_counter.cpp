// SPDX-License-Identifier: BSD-3-Clause
#include "memory_counter.hpp"

#include <atomic>
#include <cerrno>
#include <cstddef>

#if defined(__GLIBC__) && !defined(CELLSEARCH_BENCH_NO_COUNTER)
#define CELLSEARCH_BENCH_COUNTS 1
#include <malloc.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace cellsearch::bench {
namespace {

// There is one malloc in a process, and it is called before anything could be constructed.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<bool> counting{false};
std::atomic<std::int64_t> held_bytes{0};
std::atomic<std::int64_t> peak_bytes{0};
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

#ifdef CELLSEARCH_BENCH_COUNTS
void add(std::int64_t bytes) {
  const std::int64_t now = held_bytes.fetch_add(bytes, std::memory_order_relaxed) + bytes;
  std::int64_t peak = peak_bytes.load(std::memory_order_relaxed);
  while (now > peak && !peak_bytes.compare_exchange_weak(peak, now, std::memory_order_relaxed)) {
  }
}

bool is_counting() {
  return counting.load(std::memory_order_relaxed);
}

void* taken(void* block) {
  if (block != nullptr && is_counting()) add(static_cast<std::int64_t>(malloc_usable_size(block)));
  return block;
}

void given_back(void* block) {
  if (block != nullptr && is_counting()) add(-static_cast<std::int64_t>(malloc_usable_size(block)));
}
#endif

}  // namespace

bool MemoryCounter::available() {
#ifdef CELLSEARCH_BENCH_COUNTS
  return true;
#else
  return false;
#endif
}

void MemoryCounter::start() {
  held_bytes = 0;
  peak_bytes = 0;
  counting = true;
}

void MemoryCounter::stop() {
  counting = false;
}

std::int64_t MemoryCounter::held() {
  return held_bytes;
}

std::int64_t MemoryCounter::peak() {
  return peak_bytes;
}

void MemoryCounter::reset_peak() {
  peak_bytes = held_bytes.load();
}

void give_back_free_memory() {
#ifdef CELLSEARCH_BENCH_COUNTS
  malloc_trim(0);
#endif
}

}  // namespace cellsearch::bench

#ifdef CELLSEARCH_BENCH_COUNTS
// The GNU C library lets a program replace these and keeps its own under the names with two underscores.
extern "C" {
// NOLINTBEGIN(readability-identifier-naming,readability-inconsistent-declaration-parameter-name)

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) noexcept {
  return cellsearch::bench::taken(__libc_malloc(size));
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  return cellsearch::bench::taken(__libc_calloc(count, size));
}

void* realloc(void* block, std::size_t size) noexcept {
  cellsearch::bench::given_back(block);
  return cellsearch::bench::taken(__libc_realloc(block, size));
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return cellsearch::bench::taken(__libc_memalign(alignment, size));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return cellsearch::bench::taken(__libc_memalign(alignment, size));
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  void* found = cellsearch::bench::taken(__libc_memalign(alignment, size));
  if (found == nullptr) return ENOMEM;
  *block = found;
  return 0;
}

void free(void* block) noexcept {
  cellsearch::bench::given_back(block);
  __libc_free(block);
}

void* mmap(void* address, std::size_t length, int protection, int flags, int file, off_t offset) noexcept {
  const long result = syscall(SYS_mmap, address, length, protection, flags, file, offset);
  if (result != -1 && cellsearch::bench::is_counting()) {
    cellsearch::bench::add(static_cast<std::int64_t>(length));
  }
  return reinterpret_cast<void*>(result);
}

int munmap(void* address, std::size_t length) noexcept {
  const long result = syscall(SYS_munmap, address, length);
  if (result == 0 && cellsearch::bench::is_counting()) {
    cellsearch::bench::add(-static_cast<std::int64_t>(length));
  }
  return static_cast<int>(result);
}

// NOLINTEND(readability-identifier-naming,readability-inconsistent-declaration-parameter-name)
}  // extern "C"
#endif
