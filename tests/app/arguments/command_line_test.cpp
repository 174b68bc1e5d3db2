// SPDX-License-Identifier: BSD-3-Clause
#include "app/arguments/command_line.hpp"

#include <gtest/gtest.h>

namespace crumple::app::command_line_test {
namespace {

TEST(CommandLineTest, TakesEveryOptionOfRun) {
  const CommandLine line = parse_command_line({"run",
                                               "deck.k",
                                               "-o",
                                               "out",
                                               "-t",
                                               "3",
                                               "--precision",
                                               "mixed",
                                               "--isa",
                                               "scalar",
                                               "--search",
                                               "brute-force",
                                               "--contact",
                                               "auto",
                                               "--allow-unsupported",
                                               "--allow-negative-contact-energy",
                                               "--verify-search",
                                               "7",
                                               "--quiet",
                                               "--d3plot",
                                               "--end",
                                               "0.5",
                                               "--perturb",
                                               "1e-9",
                                               "--seed",
                                               "4"});
  ASSERT_EQ(line.command, Command::Run) << line.text;
  EXPECT_EQ(line.options.deck, "deck.k");
  EXPECT_EQ(line.options.folder, "out");
  EXPECT_EQ(line.options.threads, 3);
  EXPECT_EQ(line.options.precision, "mixed");
  EXPECT_EQ(line.options.isa, "scalar");
  EXPECT_EQ(line.options.search, "brute-force");
  EXPECT_TRUE(line.options.automatic_contact);
  EXPECT_TRUE(line.options.allow_unsupported);
  EXPECT_TRUE(line.options.allow_negative_contact_energy);
  EXPECT_TRUE(line.options.quiet);
  EXPECT_TRUE(line.options.d3plot);
  EXPECT_EQ(line.options.verify_search, 7);
  EXPECT_EQ(line.options.end_time, 0.5);
  EXPECT_EQ(line.options.perturbation, 1e-9);
  EXPECT_EQ(line.options.seed, 4U);
}

TEST(CommandLineTest, MeasuresWithoutADeck) {
  const CommandLine line = parse_command_line({"bench", "-t", "2", "--isa", "scalar"});
  ASSERT_EQ(line.command, Command::Bench) << line.text;
  EXPECT_EQ(line.options.threads, 2);
  EXPECT_EQ(line.options.isa, "scalar");
  EXPECT_EQ(parse_command_line({"bench", "deck.k"}).command, Command::Mistake);
}

TEST(CommandLineTest, WhatIsNotGivenIsLeftOpen) {
  const CommandLine line = parse_command_line({"run", "deck.k"});
  ASSERT_EQ(line.command, Command::Run) << line.text;
  EXPECT_FALSE(line.options.threads.has_value());
  EXPECT_FALSE(line.options.precision.has_value());
  EXPECT_FALSE(line.options.end_time.has_value());
  EXPECT_FALSE(line.options.automatic_contact);
  EXPECT_TRUE(line.options.folder.empty());
}

TEST(CommandLineTest, Check) {
  const CommandLine line = parse_command_line({"check", "deck.k", "--allow-unsupported"});
  ASSERT_EQ(line.command, Command::Check) << line.text;
  EXPECT_TRUE(line.options.allow_unsupported);
}

TEST(CommandLineTest, LsDynaSpelling) {
  const CommandLine line =
      parse_command_line({"I=a/deck.k", "NCPU=-2", "memory=200m", "endtime=0.25", "--quiet"});
  ASSERT_EQ(line.command, Command::Run) << line.text;
  EXPECT_EQ(line.options.deck, "a/deck.k");
  EXPECT_EQ(line.options.threads, 2);
  EXPECT_EQ(line.options.end_time, 0.25);
  EXPECT_TRUE(line.options.quiet);
  ASSERT_EQ(line.options.notes.size(), 1U);
  EXPECT_NE(line.options.notes[0].find("memory=200m"), std::string::npos);
}

TEST(CommandLineTest, OpenRadiossSpelling) {
  const CommandLine line = parse_command_line({"-i", "deck.k", "-nt", "2"});
  ASSERT_EQ(line.command, Command::Run) << line.text;
  EXPECT_EQ(line.options.deck, "deck.k");
  EXPECT_EQ(line.options.threads, 2);
}

TEST(CommandLineTest, HelpAndVersionAreNoMistakes) {
  const CommandLine help = parse_command_line({"--help"});
  EXPECT_EQ(help.command, Command::Help);
  EXPECT_NE(help.text.find("crumple run deck.k"), std::string::npos) << "examples";
  EXPECT_NE(help.text.find("Exit codes"), std::string::npos);
  EXPECT_EQ(parse_command_line({"run", "--help"}).command, Command::Help);
  const CommandLine version = parse_command_line({"--version"});
  EXPECT_EQ(version.command, Command::Help);
  EXPECT_EQ(version.text, program_version() + "\n");
}

TEST(CommandLineTest, ADeckWithoutACommandIsToldHowToRun) {
  const CommandLine line = parse_command_line({"deck.k", "-t", "2"});
  EXPECT_EQ(line.command, Command::Mistake);
  EXPECT_NE(line.text.find("To run the deck: crumple run deck.k -t 2\n"), std::string::npos) << line.text;
  for (const std::vector<std::string>& other :
       {std::vector<std::string>{"run"}, {"walk", "deck.k"}, {"run", "a.k", "b.k"}})
    EXPECT_EQ(parse_command_line(other).text.find("To run the deck"), std::string::npos);
}

class Mistakes : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(Mistakes, AreToldWithAHintAndNeverRun) {
  const CommandLine line = parse_command_line(GetParam());
  EXPECT_EQ(line.command, Command::Mistake);
  EXPECT_NE(line.text.find("--help"), std::string::npos) << line.text;
}

INSTANTIATE_TEST_SUITE_P(CommandLine, Mistakes,
                         ::testing::Values(std::vector<std::string>{}, std::vector<std::string>{"run"},
                                           std::vector<std::string>{"walk", "deck.k"},
                                           std::vector<std::string>{"run", "a.k", "b.k"},
                                           std::vector<std::string>{"run", "a.k", "-t", "0"},
                                           std::vector<std::string>{"run", "a.k", "-t", "two"},
                                           std::vector<std::string>{"run", "a.k", "--precision", "half"},
                                           std::vector<std::string>{"run", "a.k", "--isa", "z80"},
                                           std::vector<std::string>{"run", "a.k", "--search", "magic"},
                                           std::vector<std::string>{"run", "a.k", "--contact", "all"},
                                           std::vector<std::string>{"run", "a.k", "--end", "-1"},
                                           std::vector<std::string>{"run", "a.k", "--perturb", "nan"},
                                           std::vector<std::string>{"run", "a.k", "--end", "nan"},
                                           std::vector<std::string>{"run", "a.k", "--unknown"},
                                           std::vector<std::string>{"i=a.k", "speed=fast"},
                                           std::vector<std::string>{"i=a.k", "ncpu=many"}));

}  // namespace
}  // namespace crumple::app::command_line_test
