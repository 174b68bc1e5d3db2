// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"

#if defined(CRUMPLE_THREADS_STD)
#include <thread>
#include <vector>
#endif

namespace crumple {

/// Calls body(i) once for every i in [0, count), on up to `threads` threads; returns when all are done.
/// The only place in crumple that starts threads. Bodies write to places of their own and throw nothing;
/// what they leave must not depend on who runs which i, so that results are the same for any thread count.
template <class Body>
void parallel_for(Index count, int threads, const Body& body) {
  if (threads <= 1 || count <= 1) {
    for (Index i = 0; i < count; ++i) body(i);
    return;
  }
#if defined(CRUMPLE_THREADS_STD)
  std::vector<std::jthread> workers;
  for (int t = 0; t < threads; ++t)
    workers.emplace_back([&, t] {
      for (Index i = t; i < count; i += threads) body(i);
    });
#else
#pragma omp parallel for num_threads(threads) schedule(static)
  for (Index i = 0; i < count; ++i) body(i);
#endif
}

/// Number of pieces of `piece` items that cover `count` items. Pieces never depend on the thread count.
constexpr Index pieces(Index count, Index piece) {
  return (count + piece - 1) / piece;
}

}  // namespace crumple
