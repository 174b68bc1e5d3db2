// SPDX-License-Identifier: BSD-3-Clause
// What a run of the whole program writes in LS-DYNA's forms.
#include <algorithm>
#include <cstdlib>

#include "app/program_fixture.hpp"

namespace crumple::app::foreign_forms_test {
namespace {

class ForeignForms : public ProgramTest {
 protected:
  std::string deck_that_asks() const {
    std::string text = falling_plate();
    const std::string end = "*END\n";
    text.replace(text.find(end), end.size(),
                 "*DATABASE_GLSTAT\n0.1\n*DATABASE_MATSUM\n0.1,1\n*DATABASE_RWFORC\n0.05,3\n"
                 "*DATABASE_NODOUT\n0.1,2\n*DATABASE_HISTORY_NODE\n1,2\n*END\n");
    return write("plate.k", text);
  }
};

TEST_F(ForeignForms, ComeAsTheCardsAskAndStandInTheRecord) {
  const Result result = run({"run", deck_that_asks(), "-o", path("out"), "-q"});
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  const auto files = record("out")["files"].get<std::vector<std::string>>();
  for (const char* name : {"binout0000", "glstat", "matsum", "rwforc"}) {
    EXPECT_TRUE(exists(std::string("out/") + name)) << name;
    EXPECT_EQ(std::count(files.begin(), files.end(), name), 1) << name;
  }
  EXPECT_FALSE(exists("out/nodout")) << "binout alone was asked for";
  EXPECT_NE(read("out/glstat").find(" dt of cycle       0 is controlled by shell "), std::string::npos);
}

TEST_F(ForeignForms, AnotherReaderFindsTheNumbersOfTheTables) {
  ASSERT_EQ(run({"run", deck_that_asks(), "-o", path("out"), "-q"}).code, ExitCode::Normal);
  EXPECT_EQ(
      std::system(
          ("/usr/bin/python3 tests/output/read_binout.py " + path("out") + " > " + path("said.txt")).c_str()),
      0);
  EXPECT_TRUE(read("said.txt").ends_with("glstat rwforc nodout\n")) << read("said.txt");
}

TEST_F(ForeignForms, DoNotOutliveADeckThatAskedForThem) {
  ASSERT_EQ(run({"run", deck_that_asks(), "-o", path("out"), "-q"}).code, ExitCode::Normal);
  ASSERT_EQ(run({"run", write("plate.k", falling_plate()), "-o", path("out"), "-q"}).code, ExitCode::Normal);
  for (const char* name : {"out/binout0000", "out/glstat", "out/matsum", "out/rwforc"})
    EXPECT_FALSE(exists(name)) << name;
}

}  // namespace
}  // namespace crumple::app::foreign_forms_test
