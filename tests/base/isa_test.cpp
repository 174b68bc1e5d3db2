// SPDX-License-Identifier: BSD-3-Clause
#include "base/isa.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/state_hash.hpp"

namespace crumple::isa_test {
namespace {

TEST(InstructionSets, NamesAreReadBack) {
  for (const Isa isa : available_isas()) EXPECT_EQ(parse_isa(isa_name(isa)), isa);
  ASSERT_FALSE(available_isas().empty());
  EXPECT_EQ(available_isas().front(), Isa::Scalar) << "the reference";
}

TEST(InstructionSets, UnknownNameListsTheChoices) {
  try {
    parse_isa("altivec");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("\"altivec\" is unknown"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("the choices here are scalar"), std::string::npos)
        << error.what();
  }
}

TEST(Parallel, EveryIndexOnceForAnyThreadCount) {
  for (const int threads : {1, 2, 3, 7}) {
    std::vector<int> visits(1000, 0);
    parallel_for(1000, threads, [&](Index i) { ++visits[i]; });
    for (const int count : visits) ASSERT_EQ(count, 1);
  }
  EXPECT_EQ(pieces(0, 8), 0);
  EXPECT_EQ(pieces(1, 8), 1);
  EXPECT_EQ(pieces(16, 8), 2);
  EXPECT_EQ(pieces(17, 8), 3);
}

TEST(StateHash, SeesEveryBitAndTheLength) {
  std::array<std::byte, 21> bytes{};
  const auto hash = [&](std::size_t count) {
    StateHash h;
    h.add(std::span(bytes).first(count));
    return h.value();
  };
  const std::uint64_t zero = hash(21);
  EXPECT_NE(zero, hash(20));
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      bytes[i] = std::byte(1U << bit);
      EXPECT_NE(hash(21), zero);
      bytes[i] = std::byte{0};
    }
}

}  // namespace
}  // namespace crumple::isa_test
