// SPDX-License-Identifier: BSD-3-Clause
// The deck of the tutorial (docs/tutorial.md): it runs, and the figures told there are those of today.
#include <algorithm>
#include <cstdlib>
#include <string>

#include "app/program_fixture.hpp"

namespace crumple::app::first_deck_test {
namespace {

const std::string deck = "examples/00_first_deck/tube.k";

class FirstDeck : public ProgramTest {
 protected:
  std::vector<double> column(const std::string& name, std::size_t index) const {
    const auto rows = table(name);
    std::vector<double> values;
    for (std::size_t i = 1; i < rows.size(); ++i) values.push_back(std::stod(rows[i][index]));
    return values;
  }
};

class FirstDeckSlow : public FirstDeck {};

TEST_F(FirstDeck, MeshIsWhatItsScriptWrites) {
  ASSERT_EQ(std::system(("python3 examples/00_first_deck/make_mesh.py > " + path("mesh.k")).c_str()), 0);
  std::ostringstream kept;
  kept << std::ifstream("examples/00_first_deck/mesh.k").rdbuf();
  EXPECT_EQ(read("mesh.k"), kept.str());
}

TEST_F(FirstDeck, TextOfTheTutorialIsTheDeck) {
  std::ostringstream tutorial;
  tutorial << std::ifstream("docs/tutorial.md").rdbuf();
  std::ifstream file(deck);
  std::string text;
  for (std::string line; std::getline(file, line);)
    if (!line.starts_with("$ A square tube")) text += line + "\n";
  EXPECT_NE(tutorial.str().find("```\n" + text + "```\n"), std::string::npos);
}

TEST_F(FirstDeck, CanBeRunAndTakenUpAgain) {
  const Result check = run({"check", deck});
  EXPECT_EQ(check.code, ExitCode::Normal);
  EXPECT_NE(check.out.find("The deck can be run, with 2 warnings or notes."), std::string::npos);
  ASSERT_EQ(run({"run", deck, "-o", path("whole"), "--end", "0.4", "-q"}).code, ExitCode::Normal);
  ASSERT_EQ(run({"run", deck, "-o", path("out"), "--end", "0.2", "--restart-every", "100", "-q"}).code,
            ExitCode::Normal);
  ASSERT_EQ(run({"run", "--restart", path("out"), "--end", "0.4", "-q"}).code, ExitCode::Normal);
  EXPECT_EQ(record("out")["state_hash"], record("whole")["state_hash"]);
  ASSERT_EQ(run({"run", deck, "-o", path("thin"), "--end", "0.4", "-P", "thick=1.0", "-q"}).code,
            ExitCode::Normal);
  EXPECT_EQ(run({"compare", path("whole"), path("thin"), "-q"}).code, ExitCode::Normal);
}

TEST_F(FirstDeckSlow, FiguresOfTheTutorial) {
  ASSERT_EQ(run({"run", deck, "-o", path("out"), "-q"}).code, ExitCode::Normal);
  const nlohmann::json results = record("out");
  for (const auto& check : results["checks"]) EXPECT_TRUE(check["pass"]) << check["name"];
  const std::vector<double> force = column("out/rwforc.csv", 2);
  EXPECT_NEAR(*std::max_element(force.begin(), force.end()), 54.1, 0.1);
  const std::vector<double> way = column("out/rwmotion.csv", 4);
  EXPECT_NEAR(-*std::min_element(way.begin(), way.end()) - 1, 64.8, 0.2);
  const std::vector<double> kinetic = column("out/rwmotion.csv", 8);
  EXPECT_NEAR(kinetic.back(), 34, 1);
}

}  // namespace
}  // namespace crumple::app::first_deck_test
