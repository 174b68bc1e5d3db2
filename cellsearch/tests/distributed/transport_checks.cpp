// SPDX-License-Identifier: BSD-3-Clause
#include "transport_checks.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace cellsearch::transport_checks {

namespace {

void demand(bool fulfilled, const std::string& what) {
  if (!fulfilled) throw std::runtime_error(what);
}

/// What rank `from` sends to `to` in `round`: its length differs by all three, and may be 0.
std::vector<std::int64_t> letter(int from, int to, int round) {
  const auto length = static_cast<std::size_t>((3 * from + 5 * to + round) % 4) * 700;
  std::vector<std::int64_t> numbers(length);
  for (std::size_t place = 0; place < length; ++place) {
    numbers[place] = 1000000 * from + 10000 * to + 100 * round + static_cast<std::int64_t>(place);
  }
  return numbers;
}

bool is_letter(std::span<const std::byte> bytes, int from, int to, int round) {
  const std::vector<std::int64_t> numbers = letter(from, to, round);
  const std::span<const std::byte> expected = std::as_bytes(std::span(numbers));
  return std::equal(bytes.begin(), bytes.end(), expected.begin(), expected.end());
}

/// A round of letters to all.
struct Round {
  Round(Transport& transport, int round) {
    const int size = transport.size();
    letters.reserve(static_cast<std::size_t>(size));
    for (int other = 0; other < size; ++other) {
      letters.push_back(letter(transport.rank(), other, round));
      sends.push_back({other, std::as_bytes(std::span(letters.back()))});
    }
  }

  std::vector<std::vector<std::int64_t>> letters;
  std::vector<Outgoing> sends;
};

/// Waits for a round and compares; the order of arrival is free.
void finish_round(Transport& transport, Exchange& exchange, std::span<Incoming> receives, int round) {
  std::vector<int> seen(receives.size(), 0);
  for (int slot = exchange.finish_next(); slot >= 0; slot = exchange.finish_next()) {
    const Incoming& arrived = receives[static_cast<std::size_t>(slot)];
    ++seen[static_cast<std::size_t>(slot)];
    demand(is_letter(arrived.message(), arrived.from, transport.rank(), round),
           "round " + std::to_string(round) + ": another message from rank " + std::to_string(arrived.from));
  }
  demand(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }),
         "each message comes once");
}

bool same_bits(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

}  // namespace

void check_exchange(Transport& transport) {
  const auto known = transport.open_exchange();
  const auto unknown = transport.open_exchange();
  const auto size = static_cast<std::size_t>(transport.size());
  std::vector<std::vector<std::byte>> buffers(size, std::vector<std::byte>(3 * 700 * sizeof(std::int64_t)));
  std::vector<Array<std::byte>> grown(size);
  std::vector<Incoming> to_buffers;
  std::vector<Incoming> to_grown;
  for (std::size_t from = 0; from < size; ++from) {
    to_buffers.push_back({.from = static_cast<int>(from), .buffer = buffers[from]});
    to_grown.push_back({.from = static_cast<int>(from), .grown = &grown[from]});
  }
  for (int round = 0; round < 12; round += 2) {
    const Round first(transport, round);
    const Round second(transport, round + 1);
    known->start(first.sends, to_buffers);
    unknown->start(second.sends, to_grown);
    finish_round(transport, *unknown, to_grown, round + 1);
    finish_round(transport, *known, to_buffers, round);
  }
  demand(transport.traffic().messages >= 12 * transport.size(), "messages are counted");
}

void check_reductions(Transport& transport) {
  const double rank = transport.rank();
  const int last = transport.size() - 1;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  // The middle one gives the zero of the other sign, the last one NaN.
  const double zero = transport.rank() == last / 2 ? -0.0 : 0.0;
  std::array<double, 5> low{rank, -rank, zero, transport.rank() == last ? -nan : rank, 1e300};
  std::array<double, 5> high{rank, -rank, -zero, transport.rank() == last ? nan : rank, -1e300};
  transport.allreduce(Reduction::Min, low);
  transport.allreduce(Reduction::Max, high);
  demand(low[0] == 0.0 && low[1] == -last && same_bits(low[2], -0.0) && low[4] == 1e300, "minima of reals");
  demand(high[0] == last && high[1] == 0.0 && same_bits(high[2], 0.0) && high[4] == -1e300,
         "maxima of reals");
  demand(same_bits(low[3], std::nan("")) && same_bits(high[3], std::nan("")),
         "NaN is kept, with the same bits");

  std::array<double, 2> sum{std::ldexp(1.0, -60) * (1.0 + rank),
                            transport.rank() == 0 ? 1.0 : std::ldexp(1.0, -53)};
  transport.allreduce(Reduction::Sum, sum);
  const double ranks = transport.size();
  demand(sum[0] == std::ldexp(1.0, -60) * ranks * (ranks + 1.0) / 2.0, "the sum of reals");
  demand(sum[1] == 1.0, "reals are added in the order of ranks: each half unit is rounded away");

  std::array<std::int64_t, 2> whole{transport.rank(),
                                    std::numeric_limits<std::int64_t>::max() - transport.rank()};
  std::array<std::int64_t, 2> copy = whole;
  transport.start_allreduce(Reduction::Sum, whole);
  transport.finish_allreduce();
  demand(whole[0] == std::int64_t{last} * (last + 1) / 2, "the sum of integers");
  transport.allreduce(Reduction::Min, copy);
  demand(copy[0] == 0 && copy[1] == std::numeric_limits<std::int64_t>::max() - last, "minima of integers");
}

void check_gathers(Transport& transport) {
  Gathered all;
  for (int round = 0; round < 5; ++round) {
    const std::vector<std::int64_t> own = letter(transport.rank(), 0, round);
    transport.allgather(std::as_bytes(std::span(own)), all);
    for (int from = 0; from < transport.size(); ++from) {
      demand(is_letter(all.of(from), from, 0, round), "a gather to all");
    }
    const int root = round % transport.size();
    transport.gather(root, std::as_bytes(std::span(own)), all);
    demand(all.first.empty() == (transport.rank() != root), "a gather to one");
    for (int from = 0; from < transport.size() && !all.first.empty(); ++from) {
      demand(is_letter(all.of(from), from, 0, round), "a gather to one");
    }
    transport.barrier();
  }
}

void check_ahead(Transport& transport) {
  const auto exchange = transport.open_exchange();
  const int rank = transport.rank();
  Array<std::byte> grown;
  for (int round = 0; round < 50; ++round) {
    const std::vector<std::int64_t> numbers = letter(rank, rank + 1, round);
    std::vector<Outgoing> sends;
    std::vector<Incoming> receives;
    if (rank + 1 < transport.size()) sends.push_back({rank + 1, std::as_bytes(std::span(numbers))});
    if (rank > 0) receives.push_back({.from = rank - 1, .grown = &grown});
    exchange->start(sends, receives);
    exchange->finish();
    if (rank > 0) demand(is_letter(receives[0].message(), rank - 1, rank, round), "rounds keep their order");
  }
}

void check_all(Transport& transport) {
  check_exchange(transport);
  check_reductions(transport);
  check_gathers(transport);
  check_ahead(transport);
  check_exchange(transport);
}

}  // namespace cellsearch::transport_checks
