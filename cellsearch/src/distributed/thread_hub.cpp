// SPDX-License-Identifier: BSD-3-Clause
#include "thread_hub.hpp"

#include <algorithm>
#include <utility>

#include "receive.hpp"

namespace cellsearch {

namespace {

std::string name_of_rank(int rank) {
  return "Rank " + std::to_string(rank);
}

}  // namespace

ThreadHub::ThreadHub(int ranks, std::optional<std::uint64_t> shuffle)
    : size_(ranks), shuffle_(shuffle), places_(static_cast<std::size_t>(ranks)) {}

void ThreadHub::reset() {
  const std::scoped_lock guard(lock_);
  queues_.clear();
  places_.assign(places_.size(), Place{});
  faulty_ = false;
  fault_rank_ = -1;
  fault_message_.clear();
}

void ThreadHub::send(int from, int channel, const Outgoing& message) {
  if (message.to < 0 || message.to >= size_) throw std::out_of_range("A message goes to no rank.");
  {
    const std::scoped_lock guard(lock_);
    throw_if_fault();
    Queue& queue = queues_[Key{message.to, from, channel}];
    if (queue.count == queue.messages.size()) {
      std::rotate(queue.messages.begin(), queue.messages.begin() + static_cast<std::ptrdiff_t>(queue.first),
                  queue.messages.end());
      queue.first = 0;
      queue.messages.emplace_back();
    }
    Array<std::byte>& place = queue.messages[(queue.first + queue.count) % queue.messages.size()];
    place.assign(message.bytes.begin(), message.bytes.end());
    ++queue.count;
  }
  change_.notify_all();
}

void ThreadHub::take(int to, int channel, Incoming& slot) {
  if (slot.from < 0 || slot.from >= size_) throw std::out_of_range("A message comes from no rank.");
  std::unique_lock guard(lock_);
  Queue& queue = queues_[Key{to, slot.from, channel}];
  const Place& sender = place(slot.from);
  change_.wait(guard, [&] { return queue.count > 0 || faulty_ || sender.ended; });
  throw_if_fault();
  if (queue.count == 0) {
    throw TransportFault(slot.from, name_of_rank(slot.from) + " has ended while rank " + std::to_string(to) +
                                        " waits for a message from it.");
  }
  receive(slot, queue.messages[queue.first]);
  queue.first = (queue.first + 1) % queue.messages.size();
  --queue.count;
}

void ThreadHub::give(int rank, Collective call, std::span<const std::byte> own) {
  {
    const std::scoped_lock guard(lock_);
    throw_if_fault();
    Place& mine = place(rank);
    ++mine.calls;
    mine.call = call;
    mine.given[mine.calls % 2].assign(own.begin(), own.end());
  }
  change_.notify_all();
}

bool ThreadHub::all_have_come(const Place& own) const {
  return std::all_of(places_.begin(), places_.end(),
                     [&](const Place& other) { return other.calls >= own.calls; });
}

/// Ranks in different calls will never meet, and neither will one that waits for one that has ended.
void ThreadHub::throw_if_apart(int rank) {
  const Place& own = place(rank);
  for (int other = 0; other < size_; ++other) {
    const Place& its = place(other);
    if (its.calls == own.calls && its.call != own.call) {
      throw TransportFault(other, name_of_rank(other) + " and rank " + std::to_string(rank) +
                                      " are in different collective calls.");
    }
    if (its.calls < own.calls && its.ended) {
      throw TransportFault(other, name_of_rank(other) + " has ended while rank " + std::to_string(rank) +
                                      " waits in a collective call.");
    }
  }
}

void ThreadHub::meet(int rank) {
  std::unique_lock guard(lock_);
  change_.wait(guard, [&] {
    if (faulty_) return true;
    throw_if_apart(rank);
    return all_have_come(place(rank));
  });
  throw_if_fault();
}

// Without the lock: a rank writes the half that belongs to the parity of its own call, and comes to the next
// but one only after `rank` has given to the next.
std::span<const std::byte> ThreadHub::given(int rank, int by) const {
  const Place& own = places_[static_cast<std::size_t>(rank)];
  return places_[static_cast<std::size_t>(by)].given[own.calls % 2];
}

void ThreadHub::fault(int rank, std::string_view message) noexcept {
  {
    const std::scoped_lock guard(lock_);
    if (faulty_) return;
    faulty_ = true;
    fault_rank_ = rank;
    try {
      fault_message_ = message;
    } catch (...) {
      fault_message_.clear();  // no memory for the sentence
    }
  }
  change_.notify_all();
}

void ThreadHub::end(int rank) {
  {
    const std::scoped_lock guard(lock_);
    place(rank).ended = true;
  }
  change_.notify_all();
}

int ThreadHub::rank_at_fault() {
  const std::scoped_lock guard(lock_);
  return fault_rank_;
}

void ThreadHub::throw_if_fault() const {
  if (faulty_) {
    throw TransportFault(fault_rank_, name_of_rank(fault_rank_) + " is at fault: " + fault_message_);
  }
}

}  // namespace cellsearch
