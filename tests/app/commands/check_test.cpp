// SPDX-License-Identifier: BSD-3-Clause
// What `crumple check` and a run say about cards that do not take part.
#include "app/program_fixture.hpp"
#include "deck/small_deck.hpp"

namespace crumple::app::check_test {
namespace {

class Check : public ProgramTest {
 protected:
  std::string deck_with(const std::string& more) const {
    deck::test::SmallDeck deck;
    deck.more = more;
    deck.termination = "*CONTROL_TERMINATION\n    0.0001\n";
    return write("deck.k", deck.text());
  }
};

constexpr const char* harmless = "*DATABASE_ACEOUT\n0.1\n*DATABASE_NODFOR\n0.1\n*DATABASE_NODFOR\n0.1\n";
constexpr const char* lacking =
    "*DAMPING_FREQUENCY_RANGE\n         0       0.1\n*CONTROL_TIMESTEP\n0,0.9,0,1e-9\n";

TEST_F(Check, OfCardsWithoutEffectForPrograms) {
  const Result result = run({"check", "--json", deck_with(harmless)});
  EXPECT_EQ(result.code, ExitCode::Normal);
  EXPECT_TRUE(result.err.empty()) << result.err;
  const nlohmann::json json = nlohmann::json::parse(result.out);
  EXPECT_TRUE(json["can_run"]);
  EXPECT_EQ(json["errors"], 0);
  EXPECT_EQ(json["counts"]["without_effect"], 3);
  EXPECT_EQ(json["counts"]["missing"], 0);
  EXPECT_EQ(json["without_effect"].size(), 2U);
  EXPECT_EQ(json["without_effect"][1]["name"], "*DATABASE_NODFOR");
  EXPECT_EQ(json["without_effect"][1]["count"], 2);
}

TEST_F(Check, OfWhatIsMissingForPrograms) {
  const std::string deck = deck_with(lacking);
  const Result refused = run({"check", "--json", deck});
  EXPECT_EQ(refused.code, ExitCode::Input);
  nlohmann::json json = nlohmann::json::parse(refused.out);
  EXPECT_FALSE(json["can_run"]);
  EXPECT_EQ(json["errors"], 2);
  EXPECT_EQ(json["counts"]["missing"], 2);
  EXPECT_EQ(json["missing"][0]["name"], "*DAMPING_FREQUENCY_RANGE");
  EXPECT_EQ(json["missing"][1]["name"], "*CONTROL_TIMESTEP TSLIMT");
  EXPECT_EQ(json["messages"].size(), 3U);  // with the note on defaults
  const Result allowed = run({"check", "--json", "--allow-unsupported", deck});
  EXPECT_EQ(allowed.code, ExitCode::Normal);
  json = nlohmann::json::parse(allowed.out);
  EXPECT_EQ(json["counts"]["missing"], 0);
  EXPECT_EQ(json["counts"]["left_out"], 2);
}

TEST_F(Check, HeadingsSeparateRefusedFromHarmless) {
  const std::string deck = deck_with(std::string(harmless) + lacking);
  const Result refused = run({"check", deck});
  EXPECT_EQ(refused.code, ExitCode::Input);
  const std::size_t first = refused.out.find("Not supported\n  *DAMPING_FREQUENCY_RANGE (1 time");
  const std::size_t second =
      refused.out.find("Left out, without effect on the result\n  *DATABASE_ACEOUT (1 time");
  EXPECT_TRUE(first != std::string::npos && second != std::string::npos && first < second) << refused.out;
  EXPECT_EQ(refused.out.find("ON REQUEST"), std::string::npos);
  const Result allowed = run({"check", "--allow-unsupported", deck});
  EXPECT_EQ(allowed.code, ExitCode::Normal);
  EXPECT_NE(
      allowed.out.find("LEFT OUT ON REQUEST, although it changes the result\n  *DAMPING_FREQUENCY_RANGE"),
      std::string::npos)
      << allowed.out;
}

TEST_F(Check, ARunListsWhatWasLeftOut) {
  const std::string deck = deck_with(std::string(harmless) + lacking);
  const Result result = run({"run", "--allow-unsupported", deck, "-o", path("out")});
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NE(result.out.rfind("LEFT OUT ON REQUEST"), result.out.find("LEFT OUT ON REQUEST"));
  const nlohmann::json left_out = record(path("out"))["left_out"];
  ASSERT_EQ(left_out.size(), 4U);
  EXPECT_EQ(left_out[0]["name"], "*DAMPING_FREQUENCY_RANGE");
  EXPECT_EQ(left_out[0]["reason"], "on request");
  EXPECT_EQ(left_out[3]["name"], "*DATABASE_NODFOR");
  EXPECT_EQ(left_out[3]["reason"], "without effect");
}

TEST_F(Check, ShellsThatAreInsideOutAtTheEndAreReported) {
  deck::test::SmallDeck deck;
  deck.termination = "*CONTROL_TERMINATION\n    0.0001\n";
  // Node 6 lies behind the line from 5 to 3: shell 12 has a corner inside out, but a positive area.
  const std::string sixth = "       6             2.0             1.0";
  deck.nodes.replace(deck.nodes.find(sixth), sixth.size(), "       6             1.3             0.3");
  deck.more = "*CONTROL_SHELL\n20\n\n\n1,1\n";
  const Result result = run({"run", write("deck.k", deck.text()), "-o", path("out")});
  EXPECT_NE(result.err.find("1 shell of part 1 has a negative Jacobian"), std::string::npos) << result.err;
}

TEST_F(Check, NullShellsWithoutStiffnessRun) {
  deck::test::SmallDeck deck;
  deck.termination = "*CONTROL_TERMINATION\n    0.01\n";
  deck.part = "*PART\nplate\n         1         1         1\n*PART\nskin\n         2         1         2\n";
  deck.shells = "*ELEMENT_SHELL\n11,1,1,2,3,4\n12,2,2,5,6,3\n";
  deck.material += "*MAT_NULL\n2,1.0E-6\n";
  for (const char* contact : {"", "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n\n\n"}) {
    deck.more = std::string("*INITIAL_VELOCITY\n\n0,0,1\n") + contact;
    const Result result = run({"run", write("deck.k", deck.text()), "-o", path("out")});
    EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  }
}

/// DTINIT is the first step alone.
TEST_F(Check, CyclesAreThoseOfTheStepsBehindTheFirst) {
  const auto cycles = [&](const char* cards) {
    const std::string out = run({"check", deck_with(cards)}).out;
    return std::stod(out.substr(out.find("; about ") + 8));
  };
  EXPECT_EQ(cycles("*CONTROL_TIMESTEP\n1e-9,0.9\n"), cycles("*CONTROL_TIMESTEP\n0,0.9\n"));
}

}  // namespace
}  // namespace crumple::app::check_test
