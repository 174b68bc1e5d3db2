// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>

#include "app/program_fixture.hpp"

namespace crumple::app::picture_test {
namespace {

class PictureTest : public ProgramTest {};

TEST_F(PictureTest, ShowsTheModelOnWhite) {
  if (std::system("/usr/bin/python3 -c 'import vtkmodules.vtkRenderingOpenGL2, matplotlib' 2>/dev/null && "
                  "which Xvfb > /dev/null") != 0)
    GTEST_SKIP() << "what pictures need is not installed: tools/setup picture";
  const std::string deck = write("plate.k", falling_plate());
  ASSERT_EQ(run({"run", deck, "-o", path("out"), "-q"}).code, ExitCode::Normal);
  const std::string python = "/usr/bin/python3 ";
  const std::string draw = python + "tools/picture " + path("out");
  ASSERT_EQ(std::system((draw + " --field von_mises --mirror x --mirror y=-5 --size 400x300 --time "
                                "0.5 --time 1 > /dev/null")
                            .c_str()),
            0);
  const std::string check = python + "tests/app/picture_check.py ";
  for (const char* name : {"out/plate_von_mises_1.png", "out/plate_von_mises_2.png"})
    EXPECT_EQ(std::system((check + path(name)).c_str()), 0) << name;
  EXPECT_TRUE(exists("out/glstat.png"));
  EXPECT_TRUE(exists("out/rwforc.png"));
  EXPECT_NE(std::system((draw + " --field absent > /dev/null 2>&1").c_str()), 0);
}

}  // namespace
}  // namespace crumple::app::picture_test
