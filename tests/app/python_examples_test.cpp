// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdlib>

#include "app/program_fixture.hpp"

namespace crumple::app::python_examples_test {
namespace {

class PythonExamples : public ProgramTest {
 protected:
  PythonExamples() {
    EXPECT_EQ(run({"run", write("plate.k", falling_plate()), "-o", path("out"), "-q"}).code,
              ExitCode::Normal);
  }
  static bool python(const std::string& arguments) {
    return std::system(("/usr/bin/python3 " + arguments).c_str()) == 0;
  }
};

TEST_F(PythonExamples, DrawCurves) {
  if (!python("-c 'import matplotlib, numpy' 2>/dev/null"))
    GTEST_SKIP() << "matplotlib is not installed (Debian: python3-matplotlib)";
  EXPECT_TRUE(python("examples/python/curves.py " + path("out")));
  EXPECT_GT(std::filesystem::file_size(path("out/curves.png")), 10000U);
}

TEST_F(PythonExamples, ReadFrames) {
  if (!python("-c 'import meshio' 2>/dev/null"))
    GTEST_SKIP() << "meshio is not installed (Debian: python3-meshio)";
  ASSERT_TRUE(python("examples/python/frames.py " + path("out") + " > " + path("frames.txt")));
  const std::string text = read("frames.txt");
  // A line of names and 101 frames.
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 102);
}

}  // namespace
}  // namespace crumple::app::python_examples_test
