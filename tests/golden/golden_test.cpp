// SPDX-License-Identifier: BSD-3-Clause
//
// Fingerprints of the whole state after short runs: equal for 1, 2, 3 and 4 threads and for all instruction
// sets of a family, and equal to the golden ones of the golden compiler (docs/determinism.md). To renew them
// after a change that is meant to change bits: CRUMPLE_UPDATE_GOLDEN=1 ctest -L golden, then look at the
// difference and commit it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <tuple>

#include "golden/cases.hpp"
#include "support/run.hpp"

namespace crumple::golden::golden_test {
namespace {

constexpr const char* golden_file = "tests/golden/hashes.txt";

std::uint64_t hash_after_run(const model::Model& model, const domain::Execution& execution) {
  timeloop::Simulation simulation(model, execution);
  test::run(simulation);
  return simulation.state_hash();
}

std::string family(Isa isa) {
  return isa == Isa::Avx2 || isa == Isa::Avx512 ? "fma" : "plain";
}

std::string precision_name(Precision precision) {
  return precision == Precision::Mixed ? "Mixed" : "Double";
}

bool golden_compiler() {
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ == 12 && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  return true;
#else
  return false;
#endif
}

std::map<std::string, std::string> read_golden() {
  std::map<std::string, std::string> hashes;
  std::ifstream in(golden_file);
  std::string name;
  std::string hash;
  while (in >> name >> hash) hashes[name] = hash;
  return hashes;
}

void write_golden(const std::map<std::string, std::string>& hashes) {
  std::ofstream out(golden_file);
  for (const auto& [name, hash] : hashes) out << name << ' ' << hash << '\n';
}

void check_golden(const std::string& name, std::uint64_t value) {
  if (!golden_compiler()) GTEST_SKIP() << "golden hashes hold for g++ 12 in the release preset";
  std::ostringstream text;
  text << std::hex << value;
  std::map<std::string, std::string> hashes = read_golden();
  if (std::getenv("CRUMPLE_UPDATE_GOLDEN") != nullptr) {
    hashes[name] = text.str();
    write_golden(hashes);
  }
  EXPECT_EQ(text.str(), hashes[name]) << name;
}

class Golden : public ::testing::TestWithParam<std::tuple<Case, Precision>> {};

TEST_P(Golden, HashIsTheSameForAllThreadsAndAFamilyOfInstructionSets) {
  const auto& [one_case, precision] = GetParam();
  const model::Model model = one_case.make();
  std::map<std::string, std::uint64_t> by_family;
  for (const Isa isa : available_isas()) {
    const std::uint64_t one = hash_after_run(model, {precision, isa, 1});
    if (isa == default_isa()) {
      for (const int threads : {2, 3, 4})
        ASSERT_EQ(hash_after_run(model, {precision, isa, threads}), one)
            << isa_name(isa) << ", " << threads << " threads";
    }
    const auto [entry, first] = by_family.emplace(family(isa), one);
    ASSERT_TRUE(first || entry->second == one) << isa_name(isa) << " differs from its family " << family(isa);
  }
  for (const auto& [name, hash] : by_family)
    check_golden(std::string(one_case.name) + precision_name(precision) + "_" + name, hash);
}

/// A hash says nothing of a run in which nothing happens.
TEST(GoldenCases, DoWhatTheyAreFor) {
  for (const Case& one_case : cases()) {
    const model::Model model = one_case.make();
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    const domain::Domain& domain = simulation.domain();
    EXPECT_GT(domain.clock.cycle, 100) << one_case.name;
    EXPECT_GT(domain.energy.internal, 0) << one_case.name;
    EXPECT_LT(domain.energy.error(), 0.01) << one_case.name;
    if (!domain.contacts.empty()) {
      EXPECT_NE(domain.contacts[0].energy, 0) << one_case.name;
    }
    Index eroded = 0;
    for (const domain::ElementBlock* block : domain.blocks()) eroded += block->eroded;
    const auto broken = std::count_if(domain.rigid_bodies.begin(), domain.rigid_bodies.end(),
                                      [](const domain::RigidBody& body) { return !body.active; });
    EXPECT_EQ(broken, model.spot_welds.size()) << one_case.name;
    EXPECT_EQ(eroded > 0, one_case.erodes) << one_case.name << ' ' << eroded;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Golden,
                         ::testing::Combine(::testing::ValuesIn(cases()),
                                            ::testing::Values(Precision::Double, Precision::Mixed)),
                         [](const auto& which) {
                           return std::string(std::get<0>(which.param).name) +
                                  precision_name(std::get<1>(which.param));
                         });

}  // namespace
}  // namespace crumple::golden::golden_test
