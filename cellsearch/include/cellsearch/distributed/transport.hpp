// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cellsearch/array.hpp"
#include "cellsearch/types.hpp"

/// What the ranks of a parallel program say to each other: rounds of messages between neighbours, reductions
/// of a few numbers, gathers, and faults. Three forms: SoloTransport (one rank), ThreadTransport (ranks as
/// threads of one process, for tests), MpiTransport (target cellsearch::mpi). A step of a solver uses it so:
///
///     const std::unique_ptr<Exchange> exchange = transport.open_exchange();  // once, on all ranks alike
///     ...
///     exchange->start(sends, receives);     // in each step: what leaves is ready
///     compute_inner_elements();             // messages travel meanwhile
///     for (int slot; (slot = exchange->finish_next()) >= 0;) unpack(receives[slot]);
///
/// All buffers belong to the caller. Once the longest messages have been seen, nothing is allocated.
namespace cellsearch {

/// Thrown by every wait on a rank when another rank has reported a fault, has ended, or cannot be reached:
/// the ranks no longer agree on where they are, and the transport is of no further use.
class TransportFault : public std::runtime_error {
 public:
  TransportFault(int rank, const std::string& message) : std::runtime_error(message), rank_(rank) {}

  /// The rank at fault; -1 if unknown.
  int rank() const noexcept { return rank_; }

 private:
  int rank_;
};

/// A message that leaves.
struct Outgoing {
  int to = 0;  ///< rank that receives it; the own rank is allowed
  std::span<const std::byte>
      bytes{};  ///< must stay alive and unchanged until the round is finished; may be empty
};

/// A message that is expected. Either its largest length is known, then it goes into `buffer`; or not, then
/// it goes into `grown`, which is resized to its length (memory is re-used).
struct Incoming {
  int from = 0;                       ///< rank that sends it
  std::span<std::byte> buffer{};      ///< where it goes; a longer message is a fault, a shorter one is not
  Array<std::byte>* grown = nullptr;  ///< if set, where it goes instead
  std::size_t received = 0;           ///< its length [bytes], once it is there

  /// The message, once it is there.
  std::span<const std::byte> message() const {
    return {grown != nullptr ? grown->data() : buffer.data(), received};
  }
};

/// Rounds of messages, one after another, between ranks that know who sends to whom. Opened by all ranks in
/// the same order, whether they take part in its rounds or not. Rounds of different exchanges may overlap;
/// messages from one rank to another in the same exchange arrive in the order in which they were sent.
class Exchange {
 public:
  virtual ~Exchange() = default;
  Exchange() = default;
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  /// Begins a round. At most one message to each rank and one from each. Returns at once; `receives` and all
  /// buffers are the exchange's until the round is finished. Throws std::logic_error if the last round is
  /// not.
  virtual void start(std::span<const Outgoing> sends, std::span<Incoming> receives) = 0;

  /// Waits for one more message, whichever comes first, and returns its place in `receives`; -1 when all have
  /// arrived and all that was sent has left: the round is finished. Sums that must not depend on the order of
  /// arrival are made after all messages are there, or into a place for each. Throws TransportFault.
  virtual int finish_next() = 0;

  /// Waits for the whole round. Throws TransportFault.
  void finish() {
    while (finish_next() >= 0) {
    }
  }
};

/// How a reduction joins the values of two ranks.
enum class Reduction {
  Min,  ///< NaN if one is NaN; -0 is below +0, so that the bits do not depend on the order of the ranks
  Max,  ///< likewise
  Sum,  ///< of integers: wraps; of reals: added in the order of the ranks, hence bits depend on their number
};

/// What every rank has given, in the order of the ranks. Keep the object: its memory is re-used.
struct Gathered {
  Array<std::byte> bytes;  ///< one rank after another
  Array<Offset> first;     ///< ranks + 1 places in `bytes`; empty on a rank that receives nothing

  /// What `rank` gave.
  std::span<const std::byte> of(int rank) const {
    const auto at = static_cast<std::size_t>(rank);
    const auto begin = static_cast<std::size_t>(first[at]);
    return {bytes.data() + begin, static_cast<std::size_t>(first[at + 1]) - begin};
  }
};

/// What one rank has sent so far.
struct Traffic {
  Offset messages = 0;        ///< of exchanges
  Offset bytes = 0;           ///< in them
  Offset reductions = 0;      ///< and barriers
  Offset gathers = 0;         ///< to all or to one
  Offset bytes_given = 0;     ///< by this rank to gathers
  Offset bytes_gathered = 0;  ///< received by gathers, from all ranks
};

/// One rank's end of the connection. Used by one thread at a time. Reductions, gathers and barriers are
/// collective: every rank calls the same ones in the same order, one at a time; exchanges may be under way
/// meanwhile.
class Transport {
 public:
  virtual ~Transport() = default;
  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  /// The number of this rank, 0 <= rank() < size().
  virtual int rank() const noexcept = 0;
  /// How many ranks there are, >= 1.
  virtual int size() const noexcept = 0;

  /// A new exchange. Every rank opens the same ones in the same order; nothing travels. It must end before
  /// the transport does.
  virtual std::unique_ptr<Exchange> open_exchange() = 0;

  /// Begins to join the values of all ranks, place by place; every rank gives as many. They belong to the
  /// transport until finish_allreduce(), which puts the result in their place, the same bits on all ranks.
  virtual void start_allreduce(Reduction how, std::span<double> values) = 0;
  virtual void start_allreduce(Reduction how, std::span<std::int64_t> values) = 0;
  virtual void finish_allreduce() = 0;

  void allreduce(Reduction how, std::span<double> values) {
    start_allreduce(how, values);
    finish_allreduce();
  }
  void allreduce(Reduction how, std::span<std::int64_t> values) {
    start_allreduce(how, values);
    finish_allreduce();
  }

  /// Every rank gets what every rank gives; lengths may differ, and none has to know those of others. At most
  /// 2^31 - 1 bytes in all.
  virtual void allgather(std::span<const std::byte> own, Gathered& all) = 0;

  /// The rank `root` gets what every rank gives; `all` becomes empty on others. At most 2^31 - 1 bytes by
  /// each rank.
  virtual void gather(int root, std::span<const std::byte> own, Gathered& all) = 0;

  /// Returns when all ranks have come to it.
  virtual void barrier() = 0;

  /// Says that this rank cannot go on: every wait of another rank, present or future, throws TransportFault
  /// with this message. Does not wait.
  virtual void fault(std::string_view message) noexcept = 0;

  /// What this rank has sent since the transport was made.
  const Traffic& traffic() const noexcept { return traffic_; }

 protected:
  Traffic traffic_;
};

/// Runs `work` and reports what it throws to the other ranks before it goes on up: put it around all that a
/// rank does, so that no other waits for a rank that will not come.
template <class Work>
void run_rank(Transport& transport, const Work& work) {
  try {
    work(transport);
  } catch (const TransportFault&) {
    throw;
  } catch (const std::exception& error) {
    transport.fault(error.what());
    throw;
  } catch (...) {
    transport.fault("Something unknown was thrown.");
    throw;
  }
}

}  // namespace cellsearch
