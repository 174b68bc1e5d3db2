// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "contestant.hpp"
#include "measurement.hpp"
#include "memory_counter.hpp"
#include "options.hpp"
#include "plot.hpp"
#include "report.hpp"

namespace cellsearch::bench {
namespace {

/// Answers with what it is given, whatever the question.
class Parrot : public Contestant {
 public:
  explicit Parrot(Candidates answer) : answer_(std::move(answer)) {}
  void build(const Scene&) override {}
  const Candidates& query() override { return answer_; }

 private:
  Candidates answer_;
};

ContestantKind parrot(const std::string& name, const Candidates& answer) {
  return {.name = name, .setup = "", .make = [answer](int) { return std::make_unique<Parrot>(answer); }};
}

const Protocol quick{.repeats = 1, .progress = [](const std::string&) {}};

TEST(Options, ReadsListsAndPowersOfTen) {
  const Options options =
      parse_options({"--scenes", "1,3", "--nodes=1e4,200", "--methods", "a,b", "--order", "shuffled"});
  EXPECT_EQ(options.scenes, (std::vector<int>{1, 3}));
  EXPECT_EQ(options.nodes, (std::vector<int>{10000, 200}));
  EXPECT_EQ(options.methods, (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(options.shuffled);
}

TEST(Options, RefusesWhatItDoesNotUnderstand) {
  const std::vector<std::vector<std::string>> wrong{
      {"--node", "5"},     {"--nodes", "0"},    {"--nodes", "1e99"},  {"--nodes", "12x"},
      {"--nodes", "1.5"},  {"--nodes", "1,,2"}, {"--nodes", "1,"},    {"--nodes"},
      {"--order", "best"}, {"--repeats", "-1"}, {"--threads", "nan"}, {"scenes"}};
  for (const auto& arguments : wrong) EXPECT_THROW(parse_options(arguments), UsageError) << arguments.back();
}

TEST(Hash, DependsOnThePairsOnly) {
  const Candidates rows{{0, 2, 2, 3}, {4, 7, 1}};
  const std::uint64_t hash = hash_of(rows, "rows");
  EXPECT_EQ(hash_of({{0, 2, 2, 3}, {4, 7, 1}}, "rows"), hash);
  EXPECT_NE(hash_of({{0, 2, 2, 3}, {4, 7, 2}}, "rows"), hash);
  EXPECT_NE(hash_of({{0, 2, 3, 3}, {4, 7, 1}}, "rows"), hash);
  EXPECT_NE(hash_of({{0, 1, 2, 3}, {4, 7, 1}}, "rows"), hash);
  EXPECT_THROW(hash_of({{0, 2, 2, 3}, {7, 4, 1}}, "rows"), WrongAnswer);
  EXPECT_THROW(hash_of({{0, 2, 2, 3}, {4, 4, 1}}, "rows"), WrongAnswer);
}

TEST(Measure, EndsWhenMethodsDiffer) {
  const scenes::Mesh mesh = scenes::folded_sheets(1000, 1);
  const Candidates one{{0, 1}, {4}};
  const Candidates other{{0, 1}, {5}};
  EXPECT_NO_THROW(measure(mesh, 1, {parrot("a", one), parrot("b", one)}, quick));
  try {
    measure(mesh, 1, {parrot("polly", one), parrot("jack", other)}, quick);
    FAIL() << "a difference was not noticed";
  } catch (const WrongAnswer& error) {
    EXPECT_NE(std::string(error.what()).find("polly"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("jack"), std::string::npos) << error.what();
  }
}

TEST(Measure, FindsThatAllContestantsAgreeOnEveryScene) {
  for (const scenes::Family& family : scenes::families()) {
    for (const bool shuffled : {false, true}) {
      scenes::Mesh mesh = family.make(1500, 3);
      if (shuffled) mesh.shuffle(1);
      const Results results = measure(mesh, family.number, contestants(), quick);
      EXPECT_EQ(results.measurements.size() + results.refusals.size(), contestants().size());
      for (const Refusal& refusal : results.refusals) EXPECT_EQ(refusal.method, "nbs") << refusal.reason;
      for (const Measurement& measurement : results.measurements) {
        EXPECT_GT(measurement.pairs, 0);
        EXPECT_GT(measurement.total_ns(), 0.0);
      }
    }
  }
}

TEST(MemoryCounter, CountsWhatIsHeldAndItsPeak) {
  if (!MemoryCounter::available()) GTEST_SKIP() << "this build cannot count memory";
  MemoryCounter::start();
  {
    const std::vector<double> block(1000000, 1.0);
    // A compiler may leave out memory that nobody looks at.
    const volatile double* looked_at = block.data();
    EXPECT_EQ(*looked_at, 1.0);
    EXPECT_NEAR(static_cast<double>(MemoryCounter::held()), 8e6, 1e5);
  }
  EXPECT_NEAR(static_cast<double>(MemoryCounter::held()), 0.0, 1e5);
  EXPECT_NEAR(static_cast<double>(MemoryCounter::peak()), 8e6, 1e5);
  MemoryCounter::reset_peak();
  EXPECT_NEAR(static_cast<double>(MemoryCounter::peak()), 0.0, 1e5);
  MemoryCounter::stop();
}

TEST(Exponent, IsThatOfAPowerLaw) {
  EXPECT_NEAR(fitted_exponent({10, 1000, 1e6}, {3 * 10, 3 * 1000, 3 * 1e6}), 1.0, 1e-12);
  EXPECT_NEAR(fitted_exponent({10, 1000}, {std::pow(10, 1.5), std::pow(1000, 1.5)}), 1.5, 1e-12);
}

std::vector<Measurement> two_sizes() {
  std::vector<Measurement> result;
  for (const int nodes : {1000, 100000}) {
    for (const char* method : {"linked-cell", "production"}) {
      Measurement m;
      m.scene = 2;
      m.nodes = nodes;
      m.segments = nodes / 2;
      m.method = method;
      m.build_ns = 10;
      m.query_ns = 30;
      m.bytes_per_node = 12;
      result.push_back(m);
    }
  }
  return result;
}

TEST(Report, SortsMeasurementsIntoCurves) {
  const std::vector<Curve> found = curves(two_sizes(), 2, 1);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].method, "production");
  EXPECT_EQ(found[1].nodes, (std::vector<double>{1000, 100000}));
  EXPECT_NEAR(found[1].seconds[1], 40e-9 * 50000, 1e-12);
  EXPECT_NEAR(found[1].exponent(), 1.0, 1e-12);
  EXPECT_TRUE(curves(two_sizes(), 3, 1).empty());
}

TEST(Plot, ShowsEveryMethodInBothChartsAndTheLegend) {
  const std::string svg = plot("Title", curves(two_sizes(), 2, 1), {});
  const auto count = [&](const std::string& what) {
    int found = 0;
    for (std::size_t at = svg.find(what); at != std::string::npos; at = svg.find(what, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("<polyline"), 4);
  EXPECT_EQ(count(">production</text>"), 1);
  EXPECT_EQ(count("ns per segment"), 1);
  EXPECT_EQ(count("bytes per node"), 1);
  EXPECT_EQ(count("nan"), 0);
  EXPECT_EQ(count("inf"), 0);
}

}  // namespace
}  // namespace cellsearch::bench
