// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>

#include "app/program_fixture.hpp"

namespace crumple::app::scatter_test {
namespace {

class ScatterTest : public ProgramTest {
 public:
  ~ScatterTest() override { unsetenv("CRUMPLE_REPORT_TEMPLATE"); }
};

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

TEST_F(ScatterTest, EndsWithAReportOfTheUnperturbedRunWithTheBands) {
  const std::string page = write("page.html", "<!-- crumple-data -->");
  setenv("CRUMPLE_REPORT_TEMPLATE", page.c_str(), 1);
  const std::string deck = write("plate.k", falling_plate());
  const std::vector<std::string> arguments{"scatter", deck, "--runs",   "3",  "--perturb",
                                           "1e-4",    "-q", "--report", "-o", path("s")};
  const Result result = run(arguments);
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  const nlohmann::json json = description("s/report.html");
  EXPECT_EQ(json["run"]["perturbation"], 0);
  EXPECT_EQ(json["scatter"]["runs"], 3);
  EXPECT_EQ(json["scatter"]["perturbation"], 1e-4);
  std::vector<std::string> names;
  for (const auto& history : json["scatter"]["histories"]) names.push_back(history["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"glstat", "matsum", "rwforc"}));
  EXPECT_NE(read("s/report.html").find("id=\"crumple-data-bands2\""), std::string::npos);
  EXPECT_FALSE(exists("s/run_000/report.html"));

  // The same by `crumple report`; a run alone has no bands.
  ASSERT_EQ(run({"report", path("s"), "-q", "-o", path("again.html")}).code, ExitCode::Normal);
  EXPECT_EQ(read("again.html"), read("s/report.html"));
  ASSERT_EQ(run({"report", path("s/run_000"), "-q"}).code, ExitCode::Normal);
  EXPECT_TRUE(description("s/run_000/report.html")["scatter"].is_null());

  // Without a page nothing is run; without the option the report of earlier runs does not stay.
  setenv("CRUMPLE_REPORT_TEMPLATE", path("nothing.html").c_str(), 1);
  EXPECT_EQ(run(arguments).code, ExitCode::Usage);
  EXPECT_EQ(read("s/report.html"), read("again.html"));
  ASSERT_EQ(run({"scatter", deck, "--runs", "2", "-q", "-o", path("s")}).code, ExitCode::Normal);
  EXPECT_FALSE(exists("s/report.html"));
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
