// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>

#ifdef _OPENMP
#include <omp.h>
#else
#include <atomic>
#include <thread>
#include <vector>
#endif

#include "cellsearch/types.hpp"

namespace cellsearch {

/// Half-open range of the block `block` out of `blocks` equal ones over 0..count-1.
struct BlockRange {
  Index begin;
  Index end;

  BlockRange(Index count, int block, int blocks)
      : begin(static_cast<Index>(Offset{count} * block / blocks)),
        end(static_cast<Index>(Offset{count} * (block + 1) / blocks)) {}
};

/// Calls work(block) once for each block 0..blocks-1, on up to `threads` threads in any order; returns when
/// all are done. What a call throws (memory running out) is rethrown here, that of the lowest block kept.
/// Uses OpenMP if compiled with it, else threads of the standard library.
template <class Work>
void for_blocks(int threads, int blocks, const Work& work) {
  if (threads <= 1 || blocks <= 1) {
    for (int block = 0; block < blocks; ++block) work(block);
    return;
  }
  std::exception_ptr failure;
  int failed_block = blocks;
#ifdef _OPENMP
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (int block = 0; block < blocks; ++block) {
    try {
      work(block);
    } catch (...) {
#pragma omp critical(cellsearch_for_blocks)
      if (block < failed_block) {
        failed_block = block;
        failure = std::current_exception();
      }
    }
  }
#else
  std::atomic<int> next_block{0};
  std::atomic_flag keeping = ATOMIC_FLAG_INIT;
  const auto run = [&] {
    for (int block = next_block++; block < blocks; block = next_block++) {
      try {
        work(block);
      } catch (...) {
        while (keeping.test_and_set(std::memory_order_acquire)) std::this_thread::yield();
        if (block < failed_block) {
          failed_block = block;
          failure = std::current_exception();
        }
        keeping.clear(std::memory_order_release);
      }
    }
  };
  {
    std::vector<std::jthread> helpers;
    const int wanted = threads < blocks ? threads : blocks;
    for (int helper = 1; helper < wanted; ++helper) helpers.emplace_back(run);
    run();
  }
#endif
  if (failure) std::rethrow_exception(failure);
}

}  // namespace cellsearch
