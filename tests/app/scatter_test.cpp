// SPDX-License-Identifier: BSD-3-Clause
#include "app/program_fixture.hpp"

namespace crumple::app::scatter_test {
namespace {

using ScatterTest = ProgramTest;

TEST_F(ScatterTest, RunsPerturbedCopiesAndWritesTheirBands) {
  const std::string deck = write("plate.k", falling_plate());
  const Result result =
      run({"scatter", deck, "--runs", "3", "-t", "2", "--perturb", "1e-4", "-o", path("s")});
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  ASSERT_EQ(run({"run", deck, "-q", "-o", path("alone")}).code, ExitCode::Normal);
  EXPECT_EQ(read("s/run_000/glstat.csv"), read("alone/glstat.csv")) << "run 0 is the deck itself";
  EXPECT_NE(read("s/run_001/glstat.csv"), read("alone/glstat.csv"));
  EXPECT_NE(read("s/run_001/glstat.csv"), read("s/run_002/glstat.csv"));
  const auto rows = table("s/bands.csv");
  ASSERT_GT(rows.size(), 100U);
  for (std::size_t row = 1; row < rows.size(); ++row) {
    ASSERT_EQ(rows[row].size(), 7U);
    EXPECT_EQ(rows[row][2], "3");
    EXPECT_LE(std::stod(rows[row][5]), std::stod(rows[row][4]));
    EXPECT_LE(std::stod(rows[row][4]), std::stod(rows[row][6]));
  }
}

TEST_F(ScatterTest, CompareUsesTheBand) {
  const std::string deck = write("plate.k", falling_plate());
  ASSERT_EQ(run({"scatter", deck, "--runs", "3", "--perturb", "1e-4", "-o", path("s")}).code,
            ExitCode::Normal);
  const Result same = run({"compare", path("s"), path("s/run_000"), "--json", path("same.json")});
  ASSERT_EQ(same.code, ExitCode::Normal) << same.err;
  EXPECT_NE(same.out.find("of the time in the band"), std::string::npos) << same.out;
  EXPECT_NE(read("same.json").find("\"inside_band\""), std::string::npos);
}

TEST_F(ScatterTest, AForeignTableIsLeftAsItIs) {
  const std::string deck = write("plate.k", falling_plate());
  std::filesystem::create_directory(path("s"));
  write("s/bands.csv", "mine\n");
  EXPECT_EQ(run({"scatter", deck, "--runs", "2", "-o", path("s")}).code, ExitCode::Output);
  EXPECT_EQ(read("s/bands.csv"), "mine\n");
  EXPECT_FALSE(exists("s/run_000"));
}

TEST_F(ScatterTest, AFaultyDeckLeavesNothing) {
  const std::string deck = write("bad.k", "*KEYWORD\n*NO_SUCH_KEYWORD\n*END\n");
  EXPECT_EQ(run({"scatter", deck, "-o", path("s")}).code, ExitCode::Input);
  EXPECT_FALSE(exists("s"));
}

}  // namespace
}  // namespace crumple::app::scatter_test
