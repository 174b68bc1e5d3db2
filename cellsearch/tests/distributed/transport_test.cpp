// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cellsearch/distributed/solo_transport.hpp"
#include "cellsearch/distributed/thread_transport.hpp"
#include "transport_checks.hpp"

namespace cellsearch::transport_test {
namespace {

TEST(Transport, SoloDoesWhatAnyTransportMustDo) {
  SoloTransport transport;
  EXPECT_NO_THROW(transport_checks::check_all(transport));
}

TEST(Transport, ThreadsDoWhatAnyTransportMustDo) {
  for (const int ranks : {1, 2, 3, 4, 7}) {
    for (const std::optional<std::uint64_t> seed :
         {std::optional<std::uint64_t>{}, std::optional<std::uint64_t>{1}, std::optional<std::uint64_t>{2}}) {
      ThreadRanks hub(ranks, seed);
      EXPECT_NO_THROW(hub.run(transport_checks::check_all)) << ranks << " ranks";
    }
  }
}

/// The order in which rank 0 of four gets the messages of ten rounds.
std::vector<int> order_of_arrival(std::optional<std::uint64_t> seed) {
  std::vector<int> order;
  ThreadRanks hub(4, seed);
  hub.run([&](Transport& transport) {
    const auto exchange = transport.open_exchange();
    std::array<Array<std::byte>, 3> grown;
    std::vector<Outgoing> sends;
    std::vector<Incoming> receives;
    if (transport.rank() > 0) sends.push_back({.to = 0});
    for (int from = 1; from < 4 && transport.rank() == 0; ++from) {
      receives.push_back({.from = from, .grown = &grown[static_cast<std::size_t>(from) - 1]});
    }
    for (int round = 0; round < 10; ++round) {
      exchange->start(sends, receives);
      for (int slot = exchange->finish_next(); slot >= 0; slot = exchange->finish_next())
        order.push_back(slot);
    }
  });
  return order;
}

TEST(Transport, ShufflesTheOrderOfArrivalBySeed) {
  const std::vector<int> plain = order_of_arrival({});
  ASSERT_EQ(plain.size(), 30U);
  for (std::size_t place = 0; place < plain.size(); ++place)
    EXPECT_EQ(plain[place], static_cast<int>(place % 3));
  EXPECT_NE(order_of_arrival(1), plain);
  EXPECT_EQ(order_of_arrival(1), order_of_arrival(1)) << "the same seed gives the same order";
  EXPECT_NE(order_of_arrival(1), order_of_arrival(2));
}

/// What each rank of three threw when rank 1 did `fault` and the others wait by `wait`.
template <class Wait>
std::vector<std::string> thrown_by_all(const Wait& wait) {
  std::vector<std::string> thrown(3);
  ThreadRanks hub(3);
  EXPECT_THROW(hub.run([&](Transport& transport) {
    std::string& own = thrown[static_cast<std::size_t>(transport.rank())];
    try {
      if (transport.rank() == 1) throw std::domain_error("a wheel came off");
      wait(transport);
    } catch (const TransportFault& fault) {
      EXPECT_EQ(fault.rank(), 1);
      own = fault.what();
      throw;
    }
  }),
               std::domain_error)
      << "what the rank at fault threw";
  return thrown;
}

TEST(Transport, AFaultOfOneRankEndsTheWaitsOfAll) {
  const std::vector<std::string> expected{"Rank 1 is at fault: a wheel came off", "",
                                          "Rank 1 is at fault: a wheel came off"};
  EXPECT_EQ(thrown_by_all([](Transport& transport) { transport.barrier(); }), expected);
  EXPECT_EQ(thrown_by_all([](Transport& transport) {
              std::array<double, 1> value{};
              transport.allreduce(Reduction::Min, value);
            }),
            expected);
  EXPECT_EQ(thrown_by_all([](Transport& transport) {
              const auto exchange = transport.open_exchange();
              Array<std::byte> grown;
              std::array<Incoming, 1> receives{Incoming{.from = 2 - transport.rank(), .grown = &grown}};
              exchange->start({}, receives);
              exchange->finish();
            }),
            expected)
      << "a rank that itself is well, but waits";
}

TEST(Transport, RanksThatCannotMeetAreAFault) {
  ThreadRanks hub(2);
  EXPECT_THROW(hub.run([](Transport& transport) {
    if (transport.rank() == 0) transport.barrier();
  }),
               TransportFault)
      << "rank 1 has ended";
  EXPECT_THROW(hub.run([](Transport& transport) {
    Gathered all;
    if (transport.rank() == 0) {
      transport.barrier();
    } else {
      transport.allgather({}, all);
    }
  }),
               TransportFault)
      << "different calls";
  EXPECT_THROW(hub.run([](Transport& transport) {
    if (transport.rank() == 1) return;
    const auto exchange = transport.open_exchange();
    std::array<Incoming, 1> receives{Incoming{.from = 1}};
    exchange->start({}, receives);
    exchange->finish();
  }),
               TransportFault)
      << "the sender has ended";
  EXPECT_NO_THROW(hub.run(transport_checks::check_all)) << "the ranks can run again";
}

TEST(Transport, RefusesWhatItCannotDo) {
  EXPECT_THROW(ThreadRanks(0), std::invalid_argument);
  ThreadRanks hub(2);
  EXPECT_THROW(hub.run([](Transport& transport) {
    const auto exchange = transport.open_exchange();
    const std::array<std::byte, 8> long_message{};
    std::array<std::byte, 4> short_buffer{};
    const std::array<Outgoing, 1> sends{Outgoing{1 - transport.rank(), long_message}};
    std::array<Incoming, 1> receives{Incoming{.from = 1 - transport.rank(), .buffer = short_buffer}};
    exchange->start(sends, receives);
    exchange->finish();
  }),
               std::length_error);
  EXPECT_THROW(hub.run([](Transport& transport) {
    const auto exchange = transport.open_exchange();
    exchange->start({}, {});
    exchange->start({}, {});
  }),
               std::logic_error);
}

TEST(Transport, CountsItsTraffic) {
  ThreadRanks hub(3);
  hub.run([](Transport& transport) {
    const auto exchange = transport.open_exchange();
    const std::array<std::byte, 40> message{};
    Array<std::byte> grown;
    const std::array<Outgoing, 1> sends{Outgoing{(transport.rank() + 1) % 3, message}};
    std::array<Incoming, 1> receives{Incoming{.from = (transport.rank() + 2) % 3, .grown = &grown}};
    exchange->start(sends, receives);
    exchange->finish();
    Gathered all;
    transport.allgather(message, all);
    transport.barrier();
    const Traffic& traffic = transport.traffic();
    EXPECT_EQ(traffic.messages, 1);
    EXPECT_EQ(traffic.bytes, 40);
    EXPECT_EQ(traffic.gathers, 1);
    EXPECT_EQ(traffic.bytes_given, 40);
    EXPECT_EQ(traffic.bytes_gathered, 120);
    EXPECT_EQ(traffic.reductions, 1);
  });
}

}  // namespace
}  // namespace cellsearch::transport_test
