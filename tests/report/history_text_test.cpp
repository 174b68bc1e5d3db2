// SPDX-License-Identifier: BSD-3-Clause
#include "report/history_text.hpp"

#include <gtest/gtest.h>

namespace crumple::report::history_text_test {
namespace {

TEST(HistoryText, ShortOnesAreKept) {
  const ThinnedHistory history = thin_history("time,a\n0,1\n1,2\n", 100);
  EXPECT_EQ(history.every, 1);
  EXPECT_EQ(history.text, "time,a\n0,1\n1,2\n");
}

TEST(HistoryText, LongOnesKeepWholeMomentsAndTheLast) {
  std::string text = "time,part,a\n";
  for (int moment = 0; moment < 8; ++moment)
    for (int part = 1; part < 3; ++part) text += std::to_string(moment) + "," + std::to_string(part) + ",0\n";
  const ThinnedHistory history = thin_history(text, text.size() / 4 + 1);
  EXPECT_EQ(history.every, 4);
  EXPECT_EQ(history.text, "time,part,a\n0,1,0\n0,2,0\n4,1,0\n4,2,0\n7,1,0\n7,2,0\n");
}

TEST(HistoryText, TheRowThatIsBeingWrittenIsLeftOut) {
  EXPECT_EQ(whole_rows("time,a\n0,1\n1,2\n"), "time,a\n0,1\n1,2\n");
  EXPECT_EQ(whole_rows("time,a\n0,1\n1,"), "time,a\n0,1\n");
  EXPECT_EQ(whole_rows("time"), "");
  EXPECT_EQ(whole_rows(""), "");
}

}  // namespace
}  // namespace crumple::report::history_text_test
