// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/distributed/thread_transport.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "reduce.hpp"
#include "thread_hub.hpp"

namespace cellsearch {

namespace {

class ThreadExchange final : public Exchange {
 public:
  ThreadExchange(ThreadHub& hub, int rank, int channel, Traffic& traffic)
      : hub_(hub), rank_(rank), channel_(channel), traffic_(traffic) {
    if (hub.shuffle()) {
      std::seed_seq seed{*hub.shuffle(), static_cast<std::uint64_t>(rank),
                         static_cast<std::uint64_t>(channel)};
      random_.emplace(seed);
    }
  }

  void start(std::span<const Outgoing> sends, std::span<Incoming> receives) override {
    if (under_way_) throw std::logic_error("The last round of this exchange is not finished.");
    for (const Outgoing& message : sends) {
      hub_.send(rank_, channel_, message);
      ++traffic_.messages;
      traffic_.bytes += static_cast<Offset>(message.bytes.size());
    }
    receives_ = receives;
    order_.resize(receives.size());
    std::iota(order_.begin(), order_.end(), 0);
    if (random_) {
      for (std::size_t left = order_.size(); left > 1; --left) {
        std::swap(order_[left - 1], order_[(*random_)() % left]);
      }
    }
    next_ = 0;
    under_way_ = true;
  }

  int finish_next() override {
    if (next_ == order_.size()) {
      under_way_ = false;
      return -1;
    }
    const int slot = order_[next_++];
    hub_.take(rank_, channel_, receives_[static_cast<std::size_t>(slot)]);
    return slot;
  }

 private:
  ThreadHub& hub_;
  int rank_;
  int channel_;
  Traffic& traffic_;
  std::optional<std::mt19937_64> random_;
  std::span<Incoming> receives_;
  std::vector<int> order_;  // in which the slots are handed out
  std::size_t next_ = 0;
  bool under_way_ = false;
};

/// One rank's end.
class ThreadTransport final : public Transport {
 public:
  ThreadTransport(ThreadHub& hub, int rank) : hub_(hub), rank_(rank) {}

  int rank() const noexcept override { return rank_; }
  int size() const noexcept override { return hub_.size(); }

  std::unique_ptr<Exchange> open_exchange() override {
    return std::make_unique<ThreadExchange>(hub_, rank_, channels_++, traffic_);
  }

  void start_allreduce(Reduction how, std::span<double> values) override {
    hub_.give(rank_, Collective::Allreduce, std::as_bytes(values));
    how_ = how;
    reals_ = values;
    integers_ = {};
    ++traffic_.reductions;
  }

  void start_allreduce(Reduction how, std::span<std::int64_t> values) override {
    hub_.give(rank_, Collective::Allreduce, std::as_bytes(values));
    how_ = how;
    integers_ = values;
    reals_ = {};
    ++traffic_.reductions;
  }

  void finish_allreduce() override {
    hub_.meet(rank_);
    join_all(reals_);
    join_all(integers_);
  }

  void allgather(std::span<const std::byte> own, Gathered& all) override {
    hub_.give(rank_, Collective::Allgather, own);
    hub_.meet(rank_);
    collect(own, all);
  }

  void gather(int root, std::span<const std::byte> own, Gathered& all) override {
    hub_.give(rank_, Collective::Gather, own);
    hub_.meet(rank_);
    if (rank_ == root) {
      collect(own, all);
      return;
    }
    all.bytes.clear();
    all.first.clear();
    ++traffic_.gathers;
    traffic_.bytes_given += static_cast<Offset>(own.size());
  }

  void barrier() override {
    hub_.give(rank_, Collective::Barrier, {});
    hub_.meet(rank_);
    ++traffic_.reductions;
  }

  void fault(std::string_view message) noexcept override { hub_.fault(rank_, message); }

 private:
  template <class Number>
  void join_all(std::span<Number> values) {
    if (values.empty()) return;
    for (int by = 0; by < size(); ++by) {
      const std::span<const std::byte> given = hub_.given(rank_, by);
      if (given.size() != values.size_bytes()) {
        throw std::length_error("The ranks give different numbers of values to a reduction.");
      }
      // The bytes lie in memory aligned for any number.
      const Number* more = reinterpret_cast<const Number*>(given.data());
      if (by == 0) std::copy(more, more + values.size(), values.data());
      // The first one is joined to itself, too, which turns every NaN into the same.
      if (by > 0 || how_ != Reduction::Sum) join(how_, more, values.data(), values.size());
    }
  }

  void collect(std::span<const std::byte> own, Gathered& all) {
    all.bytes.clear();
    all.first.resize(static_cast<std::size_t>(size()) + 1);
    all.first[0] = 0;
    for (int by = 0; by < size(); ++by) {
      const std::span<const std::byte> given = hub_.given(rank_, by);
      all.bytes.insert(all.bytes.end(), given.begin(), given.end());
      all.first[static_cast<std::size_t>(by) + 1] = static_cast<Offset>(all.bytes.size());
    }
    ++traffic_.gathers;
    traffic_.bytes_given += static_cast<Offset>(own.size());
    traffic_.bytes_gathered += static_cast<Offset>(all.bytes.size());
  }

  ThreadHub& hub_;
  int rank_;
  int channels_ = 0;
  Reduction how_ = Reduction::Min;
  std::span<double> reals_;
  std::span<std::int64_t> integers_;
};

}  // namespace

ThreadRanks::ThreadRanks(int ranks, std::optional<std::uint64_t> shuffle) {
  if (ranks < 1) throw std::invalid_argument("There must be at least one rank.");
  hub_ = std::make_unique<ThreadHub>(ranks, shuffle);
}

ThreadRanks::~ThreadRanks() = default;

void ThreadRanks::run(const std::function<void(Transport&)>& work) {
  hub_->reset();
  const auto size = static_cast<std::size_t>(hub_->size());
  std::vector<std::exception_ptr> thrown(size);
  {
    std::vector<std::jthread> threads;
    for (std::size_t place = 0; place < size; ++place) {
      threads.emplace_back([&, place] {
        const int rank = static_cast<int>(place);
        ThreadTransport transport(*hub_, rank);
        try {
          run_rank(transport, work);
        } catch (...) {
          thrown[place] = std::current_exception();
        }
        hub_->end(rank);
      });
    }
  }
  const int first = hub_->rank_at_fault();
  if (first >= 0 && thrown[static_cast<std::size_t>(first)]) {
    std::rethrow_exception(thrown[static_cast<std::size_t>(first)]);
  }
  for (const std::exception_ptr& failure : thrown) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace cellsearch
