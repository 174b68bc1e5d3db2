// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/switch_file.hpp"

#include <fstream>

#include "app/program_fixture.hpp"

namespace crumple::app::switch_file_test {
namespace {

TEST(SwitchText, IsTheFirstWordInEitherCase) {
  EXPECT_EQ(parse_switch("sw1"), Switch::Stop);
  EXPECT_EQ(parse_switch(" SW1. \n"), Switch::Stop);
  EXPECT_EQ(parse_switch("sw2\n"), Switch::Status);
  EXPECT_EQ(parse_switch("sw3"), Switch::Restart);
  EXPECT_EQ(parse_switch("sw4 please"), Switch::Frame);
  EXPECT_EQ(parse_switch(""), Switch::Unknown);
  EXPECT_EQ(parse_switch("sw11"), Switch::Unknown);
}

class SwitchFileTest : public ProgramTest {};

TEST_F(SwitchFileTest, IsReadOnceAndRemoved) {
  SwitchFile file({folder_ / "other", folder_});
  EXPECT_FALSE(file.look().has_value());
  write("d3kil", "sw4\n");
  EXPECT_EQ(file.look(), Switch::Frame);
  EXPECT_FALSE(exists("d3kil"));
  EXPECT_FALSE(file.look().has_value());
}

TEST_F(SwitchFileTest, AFolderOfThatNameIsLeftAlone) {
  std::filesystem::create_directories(folder_ / "d3kil");
  SwitchFile file({folder_});
  EXPECT_FALSE(file.look().has_value());
  EXPECT_TRUE(exists("d3kil"));
}

}  // namespace
}  // namespace crumple::app::switch_file_test
