// SPDX-License-Identifier: BSD-3-Clause
// Runs with --d3plot, read back by a reader that is not ours.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/program_fixture.hpp"
#include "output/d3plot_reader.hpp"

namespace crumple::app::d3plot_test {
namespace {

/// Shells of two parts, one of which tears, a solid, a beam and a spring, in free flight or on a wall.
constexpr const char* mixed_deck =
    "*KEYWORD\n"
    "*TITLE\n"
    "shells, solids, a beam and a spring\n"
    "*CONTROL_TERMINATION\n"
    "0.2\n"
    "*CONTROL_TIMESTEP\n"
    "0.,0.5\n"
    "*DATABASE_BINARY_D3PLOT\n"
    "0.05\n"
    "*NODE\n"
    "1,0.,0.,0.5\n"
    "2,10.,0.,0.6\n"
    "3,20.,0.,0.5\n"
    "4,0.,10.,0.5\n"
    "5,10.,10.,0.7\n"
    "6,20.,10.,0.5\n"
    "7,0.,20.,0.5\n"
    "8,10.,20.,0.6\n"
    "9,20.,20.,0.5\n"
    "101,30.,0.,0.\n"
    "102,40.,0.,0.\n"
    "103,40.,10.,0.\n"
    "104,30.,10.,0.\n"
    "105,30.,0.,10.\n"
    "106,40.,0.,10.\n"
    "107,40.,10.,10.\n"
    "108,30.,10.,10.\n"
    "201,50.,0.,5.\n"
    "202,60.,0.,5.\n"
    "203,70.,0.,5.\n"
    "*ELEMENT_SHELL\n"
    "21,7,1,2,5,4\n"
    "12,7,2,3,6,5\n"
    "13,3,4,5,8,7\n"
    "14,7,5,6,9,9\n"
    "*ELEMENT_SOLID\n"
    "21,5,101,102,103,104,105,106,107,108\n"
    "*ELEMENT_BEAM\n"
    "3,2,201,202,101\n"
    "*ELEMENT_DISCRETE\n"
    "3,9,202,203\n"
    "*PART\n"
    "plate (7)\n"
    "7,1,1\n"
    "*PART\n"
    "weak (3)\n"
    "3,1,2\n"
    "*PART\n"
    "block (5)\n"
    "5,3,1\n"
    "*PART\n"
    "beam (2)\n"
    "2,4,1\n"
    "*PART\n"
    "spring (9)\n"
    "9,5,5\n"
    "*SECTION_SHELL\n"
    "1,2,0.833333,5\n"
    "1.,1.,1.,1.\n"
    "*SECTION_SOLID\n"
    "3,1\n"
    "*SECTION_BEAM\n"
    "4,2\n"
    "12.,10.,10.,20.\n"
    "*SECTION_DISCRETE\n"
    "5,0\n"
    "0,0\n"
    "*MAT_ELASTIC\n"
    "1,7.83e-6,207.,0.3\n"
    "*MAT_PIECEWISE_LINEAR_PLASTICITY\n"
    "2,7.83e-6,207.,0.3,0.2,1.0,0.002\n"
    "0,0\n"
    "0\n"
    "0\n"
    "*MAT_SPRING_ELASTIC\n"
    "5,1.\n"
    "*ELEMENT_MASS\n"
    "1,203,0.01\n"
    "*INITIAL_VELOCITY\n"
    "0\n"
    "0.,0.,-1.\n"
    "*INITIAL_VELOCITY_NODE\n"
    "7,-20.,20.,0.\n"
    "202,1.,2.,3.\n"
    "*RIGIDWALL_PLANAR_ID\n"
    "12\n"
    "0\n"
    "0.,0.,0.,0.,0.,1.,0.\n"
    "*END\n";

class D3plotTest : public ProgramTest {};

TEST_F(D3plotTest, VtkReadsWhatParaviewIsShown) {
  if (std::system("/usr/bin/python3 -c 'import vtkmodules.vtkIOLSDyna' 2>/dev/null") != 0)
    GTEST_SKIP() << "VTK's Python is not installed (Debian: python3-vtk9)";
  const std::string deck = write("mixed.k", mixed_deck);
  const Result result = run({"run", deck, "-o", path("out"), "--d3plot"});
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NE(result.out.find("out/d3plot\n"), std::string::npos);
  const std::string python = "/usr/bin/python3 tests/app/read_d3plot_with_vtk.py ";
  ASSERT_EQ(std::system((python + path("out") + " mixed > " + path("log")).c_str()), 0);
  EXPECT_EQ(read("log"), "5 states, 7 elements, 1 deleted\n");
}

/// A square that is stretched along (0.8, 0.6, 0), without Poisson's effect; its first side lies across.
TEST_F(D3plotTest, StressesOfAShellAreThoseAlongGlobalAxes) {
  const std::string deck =
      write("turned.k",
            "*KEYWORD\n*CONTROL_TERMINATION\n0.01\n"
            "*NODE\n1,8.,6.,0.\n2,2.,14.,0.\n3,-6.,8.,0.\n4,0.,0.,0.\n"
            "*ELEMENT_SHELL\n1,1,1,2,3,4\n*PART\nsquare\n1,1,1\n"
            "*SECTION_SHELL\n1,2,1.,3\n1.,1.,1.,1.\n*MAT_ELASTIC\n1,7.83e-6,200.,0.\n"
            "*INITIAL_VELOCITY_NODE\n1,0.08,0.06,0.\n2,0.08,0.06,0.\n3,0.,0.,0.\n4,0.,0.,0.\n"
            "*END\n");
  ASSERT_EQ(run({"run", deck, "-o", path("out"), "-q", "--d3plot", "--end", "0.002"}).code, ExitCode::Normal);
  const output::ReadState state = output::D3plotReader(folder_ / "out").states.back();
  const float stress = state.shells[0] + state.shells[1];
  ASSERT_GT(std::fabs(stress), 1e-4F) << "it swings, so that there may be pressure";
  const std::vector<float> expected{0.64F, 0.36F, 0, 0.48F, 0, 0};
  for (std::size_t layer = 0; layer < 3; ++layer)
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(state.shells[7 * layer + i] / stress, expected[i], 1e-4) << layer << " " << i;
  EXPECT_NEAR(state.shells[26] / stress, 0, 1e-4) << "along the first side";
  EXPECT_NEAR(state.shells[27] / stress, 1, 1e-4) << "across it, per length; the thickness is 1";
}

TEST_F(D3plotTest, ChangesNothingElse) {
  const std::string deck = write("mixed.k", mixed_deck);
  ASSERT_EQ(run({"run", deck, "-o", path("with"), "-q", "--d3plot"}).code, ExitCode::Normal);
  ASSERT_EQ(run({"run", deck, "-o", path("without"), "-q"}).code, ExitCode::Normal);
  EXPECT_EQ(record("with")["state_hash"], record("without")["state_hash"]);
  EXPECT_TRUE(exists("with/d3plot01"));
  EXPECT_FALSE(exists("without/d3plot"));
}

/// Accelerations are not kept unless someone asks; a deck that asks for the motion of nodes shows what they
/// are.
TEST_F(D3plotTest, AccelerationsAreKeptForIt) {
  std::string text = mixed_deck;
  const std::string block = "block (5)\n5,3,1\n";
  text.replace(text.find(block), block.size(), "block (5)\n5,3,6\n*MAT_RIGID\n6,7.83e-6,207.,0.3\n\n\n");
  ASSERT_EQ(run({"run", write("asks_not.k", text), "-o", path("d3plot"), "-q", "--d3plot"}).code,
            ExitCode::Normal);
  text.replace(text.find("*END"), 4, "*DATABASE_HISTORY_NODE\n5,9,107\n*END");
  ASSERT_EQ(run({"run", write("asks.k", text), "-o", path("nodout"), "-q"}).code, ExitCode::Normal);
  const output::D3plotReader file(folder_ / "d3plot");
  const auto numbers = file.numbers(0);
  const auto rows = table("nodout/nodout.csv");
  for (std::size_t row = rows.size() - 3; row < rows.size(); ++row) {
    const auto node = std::find(numbers.begin(), numbers.end(), std::stoi(rows[row][1])) - numbers.begin();
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_EQ(file.states.back().accelerations[3 * static_cast<std::size_t>(node) + axis],
                static_cast<float>(std::stod(rows[row][8 + axis])))
          << rows[row][1];
  }
  EXPECT_NE(std::stod(rows[rows.size() - 3][10]), 0);
  EXPECT_NE(std::stod(rows.back()[10]), 0) << "of the rigid block, which the wall slows down";
}

TEST_F(D3plotTest, AFileThatCannotBeWrittenEndsTheRunAsForOtherResults) {
  const std::string deck = write("plate.k", falling_plate());
  std::filesystem::create_directories(folder_ / "out/d3plot/full");
  const Result result = run({"run", deck, "-o", path("out"), "-q", "--d3plot"});
  EXPECT_EQ(result.code, ExitCode::Output);
  EXPECT_NE(result.err.find("out/d3plot: "), std::string::npos) << result.err;
}

}  // namespace
}  // namespace crumple::app::d3plot_test
