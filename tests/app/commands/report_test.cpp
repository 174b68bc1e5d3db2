// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>

#include "app/program_fixture.hpp"

namespace crumple::app::report_test {
namespace {

class ReportTest : public ProgramTest {
 public:
  ~ReportTest() override { unsetenv("CRUMPLE_REPORT_TEMPLATE"); }

 protected:
  ReportTest() : page_(write("page.html", "<body><!-- crumple-data --></body>")) {}

  Result run_plate(const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"run", write("plate.k", falling_plate()), "-q", "-o", path("out")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  std::string page_;
};

TEST_F(ReportTest, HoldsARun) {
  ASSERT_EQ(run_plate().code, ExitCode::Normal);
  const Result result = run({"report", path("out"), "--template", page_});
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NE(result.out.find("out/report.html"), std::string::npos);
  const nlohmann::json json = description("out/report.html");
  EXPECT_EQ(json["name"], "plate");
  EXPECT_EQ(json["run"]["termination"], "normal");
  EXPECT_EQ(json["run"]["plane_walls"][0]["id"], 12);
  EXPECT_EQ(json["run"]["parts"][0]["title"], "plate");
  EXPECT_EQ(json["times"].size(), 101U);
  EXPECT_EQ(json["times"][0], 0);
  EXPECT_EQ(json["nodes"], 9);
  EXPECT_EQ(json["faces"], 4);
  // The plate starts between 0.5 and 0.7 and falls to the wall at 0.
  EXPECT_NEAR(json["box"]["low"][2], 0, 1e-6);
  EXPECT_NEAR(json["box"]["high"][2], 0.7, 1e-6);
  std::vector<std::string> fields;
  for (const auto& field : json["fields"]) fields.push_back(field["name"]);
  EXPECT_EQ(fields, (std::vector<std::string>{"velocity", "contact_force", "plastic_strain", "von_mises",
                                              "von_mises_mid", "thickness"}));
  const std::string text = read("out/report.html");
  EXPECT_TRUE(text.starts_with("<body><script"));
  EXPECT_TRUE(text.ends_with("</body>"));
  for (const char* name :
       {"node_id", "faces", "position_0", "position_100", "field0_0", "field5_100", "table0"})
    EXPECT_NE(text.find("id=\"crumple-data-" + std::string(name) + "\""), std::string::npos) << name;
}

TEST_F(ReportTest, TheSameResultGivesTheSameReport) {
  ASSERT_EQ(run_plate().code, ExitCode::Normal);
  ASSERT_EQ(run({"report", path("out"), "--template", page_, "-o", path("a.html")}).code, ExitCode::Normal);
  ASSERT_EQ(run({"report", path("out"), "--template", page_, "-o", path("b.html")}).code, ExitCode::Normal);
  EXPECT_EQ(read("a.html"), read("b.html"));
}

TEST_F(ReportTest, ARunMakesItAtItsEnd) {
  setenv("CRUMPLE_REPORT_TEMPLATE", page_.c_str(), 1);
  const Result result = run_plate({"--report"});
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_EQ(description("out/report.html")["run"]["termination"], "normal");
}

TEST_F(ReportTest, ARunThatCannotMakeItDoesNotStart) {
  setenv("CRUMPLE_REPORT_TEMPLATE", path("nothing.html").c_str(), 1);
  const Result result = run_plate({"--report"});
  EXPECT_EQ(result.code, ExitCode::Usage);
  EXPECT_NE(result.err.find("nothing.html"), std::string::npos);
  EXPECT_FALSE(exists("out"));
}

TEST_F(ReportTest, AResultOfARunThatGoesOnNeedsNoRecord) {
  ASSERT_EQ(run_plate().code, ExitCode::Normal);
  std::filesystem::remove(folder_ / "out/run.json");
  ASSERT_EQ(run({"report", path("out"), "--template", page_}).code, ExitCode::Normal);
  EXPECT_TRUE(description("out/report.html")["run"].is_null());
}

TEST_F(ReportTest, SaysWhatIsWrongWithAFolder) {
  const auto complaint = [&](const std::string& folder) {
    const Result result = run({"report", path(folder), "--template", page_});
    EXPECT_EQ(result.code, ExitCode::Input) << folder;
    return result.err;
  };
  EXPECT_NE(complaint("nowhere").find("is no folder"), std::string::npos);
  EXPECT_NE(complaint(".").find("holds no result"), std::string::npos);
  ASSERT_EQ(run_plate().code, ExitCode::Normal);
  write("out/other.pvd", read("out/plate.pvd"));
  // run.json says which of the two is meant.
  EXPECT_EQ(run({"report", path("out"), "--template", page_}).code, ExitCode::Normal);
  std::filesystem::remove(folder_ / "out/run.json");
  EXPECT_NE(complaint("out").find("frames of 2 runs"), std::string::npos);
  std::filesystem::remove(folder_ / "out/other.pvd");
  write("out/vtu/plate_000007.vtu", "cut off");
  EXPECT_NE(complaint("out").find("plate_000007.vtu"), std::string::npos);
}

TEST_F(ReportTest, APageWithoutItsMarkIsRefused) {
  ASSERT_EQ(run_plate().code, ExitCode::Normal);
  const Result result = run({"report", path("out"), "--template", write("other.html", "<body></body>")});
  EXPECT_EQ(result.code, ExitCode::Input);
  EXPECT_NE(result.err.find("no template of a report"), std::string::npos);
}

}  // namespace
}  // namespace crumple::app::report_test
