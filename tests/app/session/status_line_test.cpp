// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/status_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace crumple::app::status_line_test {
namespace {

TEST(StatusLineTest, Durations) {
  EXPECT_EQ(format_duration(0), "0.0 s");
  EXPECT_EQ(format_duration(9.94), "9.9 s");
  EXPECT_EQ(format_duration(9.96), "10 s");
  EXPECT_EQ(format_duration(59.4), "59 s");
  EXPECT_EQ(format_duration(59.6), "1:00") << "rounded first: never 60 s";
  EXPECT_EQ(format_duration(185), "3:05");
  EXPECT_EQ(format_duration(3599.7), "1:00:00");
  EXPECT_EQ(format_duration(3765), "1:02:45");
  EXPECT_EQ(format_duration(std::nan("")), "?");
  EXPECT_EQ(format_duration(HUGE_VAL), "?");
}

class StatusDomain : public ::testing::Test {
 protected:
  StatusDomain() {
    domain_.shells.resize(1);
    domain_.shells[0].elements = 1000;
    domain_.clock.time = 0.3;
    domain_.clock.cycle = 200;
    domain_.energy.kinetic = domain_.energy.initial_total = 5;
    progress_.end_time = 1.2;
    progress_.next_step = 1e-3;
    progress_.seconds_to_go = 90;
    progress_.seconds = 4;
    progress_.controlling = {"shell", 12345678, 99};
  }
  domain::Domain domain_;
  Progress progress_;
};

TEST_F(StatusDomain, TimeToGoIsAQuestionMarkUntilItIsKnown) {
  progress_.seconds_to_go = -1;
  EXPECT_TRUE(status_line(domain_, progress_).ends_with("       ?"));
}

TEST_F(StatusDomain, TheLineHoldsWhatTheHeaderNames) {
  const std::string line = status_line(domain_, progress_);
  for (const char* word :
       {"200", "3.0000e-01", "1.000e-03", "shell 12345678 p99", "5.0000e+00", "1.00000", "20000.0", "1:30"})
    EXPECT_NE(line.find(word), std::string::npos) << word << " in " << line;
  for (const char* word : {"cycle", "time", "step", "controlled by", "kinetic", "ratio", "to go"})
    EXPECT_NE(status_header().find(word), std::string::npos) << word;
}

TEST_F(StatusDomain, TheBarFillsAndFitsALine) {
  const std::string quarter = progress_bar(domain_, progress_);
  EXPECT_NE(quarter.find("[#######...................", 0), std::string::npos) << quarter;
  EXPECT_NE(quarter.find(" 25 %"), std::string::npos) << quarter;
  EXPECT_LE(quarter.size(), 79U);
  domain_.clock.time = 1.3;
  EXPECT_NE(progress_bar(domain_, progress_).find("100 %"), std::string::npos) << "and no more";
  progress_.end_time = 0;
  EXPECT_NE(progress_bar(domain_, progress_).find("  0 %"), std::string::npos);
}

}  // namespace
}  // namespace crumple::app::status_line_test
