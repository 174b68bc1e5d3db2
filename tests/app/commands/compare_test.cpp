// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdlib>

#include "app/program_fixture.hpp"
#include "compare/binout_sample.hpp"
#include "support/larger.hpp"

namespace crumple::app::compare_test {
namespace {

using compare::BinoutSample;

class CompareTest : public ProgramTest {
 protected:
  CompareTest() : page_(write("page.html", "<body><!-- crumple-data --></body>")) {}

  void run_plate(const std::string& folder, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"run", write("plate.k", falling_plate()), "-q", "-o", path(folder)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    ASSERT_EQ(run(arguments).code, ExitCode::Normal);
  }

  nlohmann::json scores(const std::vector<std::string>& arguments) {
    std::vector<std::string> all = {"compare", "--json", path("scores.json")};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Result result = run(all);
    EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
    return nlohmann::json::parse(read("scores.json"));
  }

  /// What LS-DYNA would write of the same energies and wall force, `factor` times as large, as text.
  void write_ascii(const std::string& folder, double factor) {
    std::filesystem::create_directories(folder_ / folder);
    std::string energies = " falling plate\n";
    const auto rows = table("out/glstat.csv");
    for (std::size_t row = 1; row < rows.size(); ++row) {
      const auto number = [&](std::size_t column) { return std::stod(rows[row][column]); };
      energies += "\n\n dt of cycle       1 is controlled by shell           1 of part        1\n\n";
      energies += line(" time...........................", number(0));
      energies += line(" time step......................", number(1));
      energies += line(" kinetic energy.................", factor * number(2));
      energies += line(" internal energy................", factor * number(3));
      energies += line(" stonewall energy...............", factor * number(7));
      energies += line(" sliding interface energy.......", factor * (number(5) + number(6)));
      energies += line(" total energy...................", factor * number(11));
      energies += line(" total energy / initial energy..", number(12));
    }
    write(folder + "/glstat", energies);
    std::string forces = "    time       wall#   normal-force    x-force        y-force        z-force\n";
    const auto walls = table("out/rwforc.csv");
    for (std::size_t row = 1; row < walls.size(); ++row) {
      char text[120];
      std::snprintf(text, sizeof(text), "%12.5E%8d%15.6E%15.6E%15.6E%15.6E\n", std::stod(walls[row][0]), 12,
                    factor * std::stod(walls[row][2]), factor * std::stod(walls[row][3]),
                    factor * std::stod(walls[row][4]), factor * std::stod(walls[row][5]));
      forces += text;
    }
    write(folder + "/rwforc", forces);
  }

  static std::string line(const char* label, double value) {
    char text[80];
    std::snprintf(text, sizeof(text), "%s%14.5E\n", label, value);
    return text;
  }

  std::string page_;
};

TEST_F(CompareTest, AResultAgreesWithItself) {
  run_plate("out");
  const Result result = run({"compare", path("out"), path("out"), "--tolerance", "0"});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NE(result.out.find("glstat.kinetic"), std::string::npos);
  EXPECT_NE(result.out.find("all within 0 % of the peak"), std::string::npos);
  EXPECT_EQ(result.err, "");
  const nlohmann::json same = scores({path("out"), path("out")});
  for (const auto& curve : same["curves"]) {
    EXPECT_EQ(curve["relative"], 0) << curve["name"];
    EXPECT_EQ(curve["iso_18571"]["rating"], 1) << curve["name"];
    EXPECT_EQ(curve["iso_18571"]["grade"], "excellent");
    EXPECT_NEAR(curve["sprague_geers"]["combined"].get<double>(), 0, 1e-7);
  }
}

TEST_F(CompareTest, AnotherPrecisionDiffersByRounding) {
  run_plate("out");
  run_plate("mixed", {"--precision", "mixed"});
  const nlohmann::json json = scores({path("out"), path("mixed"), "-q"});
  double worst = 0;
  for (const auto& curve : json["curves"]) worst = test::larger_of(worst, curve["relative"].get<double>());
  EXPECT_GT(worst, 0);
  EXPECT_LT(worst, 1e-2);
  EXPECT_EQ(run({"compare", path("out"), path("mixed"), "--tolerance", "0.01", "-q"}).code, ExitCode::Normal);
  const Result strict = run({"compare", path("out"), path("mixed"), "--tolerance", "1e-12"});
  EXPECT_EQ(strict.code, ExitCode::Input);
  EXPECT_NE(strict.out.find("beyond"), std::string::npos);
}

TEST_F(CompareTest, TextOfLsDyna) {
  run_plate("out");
  write_ascii("dyna", 1.0);
  // Six digits are written, and the times have as many.
  const nlohmann::json written = scores({path("dyna"), path("out")});
  for (const auto& curve : written["curves"])
    EXPECT_LT(curve["relative"].get<double>(), 1e-3) << curve["name"];
  write_ascii("larger", 1.2);
  const nlohmann::json json = scores({path("out"), path("larger"), "--quantity", "glstat.kinetic"});
  ASSERT_EQ(json["curves"].size(), 1U);
  EXPECT_NEAR(json["curves"][0]["sprague_geers"]["magnitude"].get<double>(), 0.2, 1e-4);
  EXPECT_NEAR(json["curves"][0]["relative"].get<double>(), 0.2, 1e-4);
}

TEST_F(CompareTest, BinoutOfLsDyna) {
  run_plate("out");
  const auto rows = table("out/glstat.csv");
  BinoutSample sample;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    std::string number = std::to_string(row);
    number.insert(0, 6 - number.size(), '0');
    sample.folder("/glstat/d" + number);
    sample.write("time", BinoutSample::R8, {std::stod(rows[row][0])});
    sample.write("kinetic_energy", BinoutSample::R8, {std::stod(rows[row][2])});
    sample.write("internal_energy", BinoutSample::R4, {std::stod(rows[row][3])});
  }
  sample.table();
  std::filesystem::create_directories(folder_ / "dyna");
  write("dyna/binout0000", sample.bytes());
  const nlohmann::json json = scores({path("dyna"), path("out")});
  ASSERT_EQ(json["curves"].size(), 2U);
  for (const auto& curve : json["curves"]) EXPECT_LT(curve["relative"].get<double>(), 1e-6) << curve["name"];
}

TEST_F(CompareTest, APageHoldsTheCurves) {
  run_plate("out");
  const Result result =
      run({"compare", path("out"), path("out"), "--html", path("page_out.html"), "--template", page_});
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  const std::string text = read("page_out.html");
  EXPECT_TRUE(text.starts_with("<body><script type=\"application/json\" id=\"crumple-comparison\">"));
  EXPECT_NE(text.find("rwforc.normal[12]"), std::string::npos);
  EXPECT_TRUE(text.ends_with("</body>"));
}

TEST_F(CompareTest, APageThatWasNotBuiltIsSaidBeforeTheWork) {
  setenv("CRUMPLE_COMPARE_TEMPLATE", path("nothing.html").c_str(), 1);
  run_plate("out");
  const Result result = run({"compare", path("out"), path("out"), "--html", path("page_out.html")});
  unsetenv("CRUMPLE_COMPARE_TEMPLATE");
  EXPECT_EQ(result.code, ExitCode::Usage);
  EXPECT_NE(result.err.find("nothing.html"), std::string::npos);
  EXPECT_FALSE(exists("page_out.html"));
}

TEST_F(CompareTest, NothingInCommonIsADifference) {
  write("a.csv", "time,force\n0,1\n1,2\n");
  write("b.csv", "time,depth\n0,1\n1,2\n");
  const Result result = run({"compare", path("a.csv"), path("b.csv")});
  EXPECT_EQ(result.code, ExitCode::Input);
  EXPECT_NE(result.err.find("no curve in common"), std::string::npos);
  const Result paired =
      run({"compare", path("a.csv"), path("b.csv"), "--pair", "a.force=b.depth", "--tolerance", "0"});
  EXPECT_EQ(paired.code, ExitCode::Normal) << paired.err;
}

TEST_F(CompareTest, ListNamesTheCurves) {
  run_plate("out");
  const Result result = run({"compare", path("out"), path("out"), "--list"});
  EXPECT_EQ(result.code, ExitCode::Normal);
  EXPECT_NE(result.out.find("rwforc."), std::string::npos);
  EXPECT_NE(result.out.find("normal"), std::string::npos);
  EXPECT_NE(result.out.find("[12]"), std::string::npos);
}

TEST_F(CompareTest, QuietSaysNothing) {
  run_plate("out");
  const Result result = run({"compare", path("out"), path("out"), "-q"});
  EXPECT_EQ(result.out + result.err, "");
}

TEST_F(CompareTest, TheFilterWantsTheUnitOfTime) {
  write("a.csv", "time,force\n0,1\n1,2\n");
  const Result result = run({"compare", path("a.csv"), path("a.csv"), "--cfc", "60"});
  EXPECT_EQ(result.code, ExitCode::Usage);
  EXPECT_NE(result.err.find("--time-unit"), std::string::npos);
  EXPECT_EQ(run({"compare", path("a.csv"), path("a.csv"), "--cfc", "60", "--time-unit", "ms"}).code,
            ExitCode::Normal);
}

TEST_F(CompareTest, WrongCommandLines) {
  run_plate("out");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"compare", path("out")},
        {"compare", path("out"), path("nowhere")},
        {"compare", path("out"), path("out"), "--cfc", "100"},
        {"compare", path("out"), path("out"), "--tolerance", "-1"},
        {"compare", path("out"), path("out"), "--tolerance", "nan"},
        {"compare", path("out"), path("out"), "--pair", "a"},
        {"compare", path("out"), path("out"), "--pair", "a=b"},
        {"compare", path("out"), path("out"), "--interval", "0"},
        {"compare", path("out"), path("out"), "--interval", "10"}}) {
    const Result result = run(arguments);
    EXPECT_EQ(result.code, ExitCode::Usage) << arguments.back();
    EXPECT_NE(result.err, "") << arguments.back();
  }
  EXPECT_EQ(run({"compare", path("out"), path("out"), "--json", path("no/such/folder.json")}).code,
            ExitCode::Output);
  EXPECT_NE(run({"compare", "--help"}).out.find("Examples:"), std::string::npos);
}

TEST_F(CompareTest, ADamagedBinoutIsAWarning) {
  write("glstat.csv", "time,kinetic\n0,1\n1,2\n");
  std::filesystem::create_directories(folder_ / "dyna");
  write("dyna/glstat.csv", "time,kinetic\n0,1\n1,2\n");
  write("dyna/binout0000", "not one");
  const Result result = run({"compare", path("dyna"), path("dyna")});
  EXPECT_EQ(result.code, ExitCode::Normal);
  EXPECT_NE(result.err.find("binout0000"), std::string::npos);
}

}  // namespace
}  // namespace crumple::app::compare_test
