// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "cellsearch/distributed/transport.hpp"

namespace cellsearch {

class ThreadHub;

/// Ranks as threads of one process: for tests, and for the thread sanitizer. Messages are copied as a round
/// starts, so ranks share no memory but that of the hub.
///
///     cellsearch::ThreadRanks ranks(4);
///     ranks.run([](cellsearch::Transport& transport) { ... });  // what each rank does
///
/// Deterministic: messages of a round are handed out in the order of its slots or, with a seed, in an order
/// that is drawn from it, another one in each round. A rank that waits for one that has ended, and ranks in
/// different collective calls, are faults instead of endless waits.
class ThreadRanks {
 public:
  /// `ranks`: >= 1, else std::invalid_argument. `shuffle`: seed of the order of arrival.
  explicit ThreadRanks(int ranks, std::optional<std::uint64_t> shuffle = {});
  ~ThreadRanks();
  ThreadRanks(const ThreadRanks&) = delete;
  ThreadRanks& operator=(const ThreadRanks&) = delete;

  /// Calls `work` once for each rank, on a thread of its own, and returns when all have ended. Rethrows what
  /// the first rank at fault threw; the others have then ended by TransportFault. May be called again after
  /// success.
  void run(const std::function<void(Transport&)>& work);

 private:
  std::unique_ptr<ThreadHub> hub_;
};

}  // namespace cellsearch
