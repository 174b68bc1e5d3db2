// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "cellsearch/distributed/transport.hpp"

namespace cellsearch {

/// The collective calls, which all ranks must make in the same order.
enum class Collective { Allreduce, Allgather, Gather, Barrier };

/// Where the ranks of one process meet: messages that are under way, what ranks give to collective calls,
/// faults. One lock for all: it serves tests, not speed.
class ThreadHub {
 public:
  ThreadHub(int ranks, std::optional<std::uint64_t> shuffle);

  int size() const { return size_; }
  std::optional<std::uint64_t> shuffle() const { return shuffle_; }

  /// Forgets the last run.
  void reset();

  /// Copies a message into the queue of its receiver.
  void send(int from, int channel, const Outgoing& message);

  /// Waits for the next message from `slot.from` and takes it out of the queue.
  void take(int to, int channel, Incoming& slot);

  /// Gives this rank's part of its next collective call.
  void give(int rank, Collective call, std::span<const std::byte> own);

  /// Waits until all ranks have given theirs to the last call of `rank`; what each gave may then be read
  /// until `rank` gives again.
  void meet(int rank);
  std::span<const std::byte> given(int rank, int by) const;

  /// `rank` cannot go on; the first one counts.
  void fault(int rank, std::string_view message) noexcept;

  /// `rank` has ended.
  void end(int rank);

  /// The first rank that reported a fault by itself; -1 if none did.
  int rank_at_fault();

 private:
  using Key = std::tuple<int, int, int>;  // to, from, channel

  struct Queue {
    std::vector<Array<std::byte>> messages;  // a ring
    std::size_t first = 0;
    std::size_t count = 0;
  };

  struct Place {
    std::size_t calls = 0;  // collective calls so far
    Collective call = Collective::Barrier;
    std::array<Array<std::byte>, 2> given;  // by the parity of the call: a rank is at most one call ahead
    bool ended = false;
  };

  void throw_if_fault() const;
  Place& place(int rank) { return places_[static_cast<std::size_t>(rank)]; }
  bool all_have_come(const Place& own) const;
  void throw_if_apart(int rank);

  int size_;
  std::optional<std::uint64_t> shuffle_;
  std::mutex lock_;
  std::condition_variable change_;
  std::map<Key, Queue> queues_;
  std::vector<Place> places_;
  bool faulty_ = false;
  int fault_rank_ = -1;
  std::string fault_message_;
};

}  // namespace cellsearch
