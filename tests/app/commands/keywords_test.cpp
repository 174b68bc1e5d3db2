// SPDX-License-Identifier: BSD-3-Clause
#include "app/program_fixture.hpp"

namespace crumple::app::keywords_test {
namespace {

class Keywords : public ProgramTest {};

TEST_F(Keywords, ListsAllNames) {
  const Result result = run({"keywords"});
  EXPECT_EQ(result.code, ExitCode::Normal);
  EXPECT_NE(result.out.find("\nMAT_ELASTIC\n"), std::string::npos);
}

TEST_F(Keywords, ShowsCardsInAnySpelling) {
  const Result result = run({"keywords", "*mat_24_TITLE"});
  EXPECT_EQ(result.code, ExitCode::Normal);
  EXPECT_NE(result.out.find("*MAT_024\n"), std::string::npos);
  EXPECT_NE(result.out.find("SIGY"), std::string::npos);
  EXPECT_NE(result.out.find("only values supported"), std::string::npos);
}

TEST_F(Keywords, SaysWhyOneIsLeftOutAndWhichAreNearToAnUnknownOne) {
  const Result known = run({"keywords", "CONTROL_CPU"});
  EXPECT_EQ(known.code, ExitCode::Normal);
  EXPECT_NE(known.out.find("is left out with a warning"), std::string::npos);
  const Result unknown = run({"keywords", "SECTION_SEATBELT"});
  EXPECT_EQ(unknown.code, ExitCode::Input);
  EXPECT_NE(unknown.err.find("nearest is *SECTION_DISCRETE: "), std::string::npos) << unknown.err;
}

TEST_F(Keywords, KnowsThoseOfTheFormat) {
  for (const char* name : {"PARAMETER", "PARAMETER_EXPRESSION", "INCLUDE", "END", "*keyword"}) {
    const Result result = run({"keywords", name});
    EXPECT_EQ(result.code, ExitCode::Normal) << name;
    EXPECT_TRUE(result.err.empty()) << result.err;
  }
}

TEST_F(Keywords, TellsProgramsEverything) {
  const nlohmann::json known = nlohmann::json::parse(run({"keywords", "--json"}).out);
  for (const auto& keyword : known["keywords"]) {
    if (keyword["name"] != "CONTROL_TIMESTEP") continue;
    const auto& field = keyword["cards"][0]["fields"][1];
    EXPECT_EQ(field["name"], "TSSFAC");
    EXPECT_EQ(field["default"], 0.9);
    EXPECT_EQ(field["effect"], "used");
    EXPECT_FALSE(keyword["several"]);
    return;
  }
  FAIL() << "CONTROL_TIMESTEP is missing";
}

}  // namespace
}  // namespace crumple::app::keywords_test
