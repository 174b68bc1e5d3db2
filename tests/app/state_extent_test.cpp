// SPDX-License-Identifier: BSD-3-Clause
// *DATABASE_EXTENT_BINARY in the d3plot files of runs.
#include <cmath>
#include <cstdlib>

#include "app/program_fixture.hpp"
#include "output/d3plot_reader.hpp"

namespace crumple::app::state_extent_test {
namespace {

constexpr double yield_stress = 0.2;

/// A square shell of five points that is stretched along x and bent, and a cube that is stretched along z:
/// both yield, with kinematic hardening.
std::string yielding(const std::string& extent) {
  return "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*CONTROL_TIMESTEP\n0.,0.2\n*CONTROL_SHELL\n\n" + extent +
         "*NODE\n"
         "1,0.,0.,0.\n2,10.,0.,0.\n3,10.,10.,0.\n4,0.,10.,0.\n"
         "11,20.,0.,0.\n12,30.,0.,0.\n13,30.,10.,0.\n14,20.,10.,0.\n"
         "15,20.,0.,10.\n16,30.,0.,10.\n17,30.,10.,10.\n18,20.,10.,10.\n"
         "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_SOLID\n5,2,11,12,13,14,15,16,17,18\n"
         "*PART\nplate (1)\n1,1,1\n*PART\ncube (2)\n2,2,1\n"
         "*SECTION_SHELL\n1,2,1.0,5\n1.,1.,1.,1.\n*SECTION_SOLID\n2,1\n"
         "*MAT_PLASTIC_KINEMATIC\n1,7.85e-6,210.,0.3,0.2,10.0,0.\n0.,0.,0.\n"
         "*SET_NODE_LIST\n1\n1,4\n*SET_NODE_LIST\n2\n2,3\n*SET_NODE_LIST\n3\n11,12,13,14\n"
         "*SET_NODE_LIST\n4\n15,16,17,18\n*DEFINE_CURVE\n1\n0.,1.\n10.,1.\n"
         "*BOUNDARY_PRESCRIBED_MOTION_SET\n1,1,0,1,-0.1\n2,1,0,1,0.1\n1,6,0,1,-0.05\n2,6,0,1,0.05\n"
         "3,3,0,1,-0.1\n4,3,0,1,0.1\n"
         "*DATABASE_ELOUT\n0.5\n*DATABASE_HISTORY_SHELL\n1\n*DATABASE_BINARY_D3PLOT\n0.5\n*END\n";
}

/// Of the difference of a stress and a back stress.
double relative_von_mises(const std::array<double, 6>& s) {
  const double a = s[0] - s[1];
  const double b = s[1] - s[2];
  const double c = s[2] - s[0];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

class StateExtentRun : public ProgramTest {
 protected:
  output::D3plotReader run_deck(const std::string& extent) {
    const Result result =
        run({"run", write("extent.k", yielding(extent)), "-o", path("out"), "-q", "--d3plot"});
    EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
    EXPECT_EQ(result.err.find("EXTENT"), std::string::npos) << result.err;
    return output::D3plotReader(folder_ / "out");
  }
};

TEST_F(StateExtentRun, PointsThroughTheThicknessAreThoseOfElout) {
  // Five of six that are asked for, with two further variables.
  const auto file = run_deck("*DATABASE_EXTENT_BINARY\n0,2,6\n");
  EXPECT_EQ(file.root.integer(33), 6 * (7 + 2) + 8 + 4);
  EXPECT_EQ(file.root.integers(34, 3), (std::vector<std::int32_t>{0, 2, -10006}));
  const auto rows = table("out/elout_shells.csv");
  ASSERT_EQ(rows.size(), 1 + 5 * file.states.size());
  const std::vector<float>& last = file.states.back().shells;
  for (std::size_t layer = 0; layer < 5; ++layer) {
    const auto& row = rows[rows.size() - 5 + layer];
    for (std::size_t i = 0; i < 7; ++i)
      EXPECT_FLOAT_EQ(last.at(9 * layer + i), static_cast<float>(std::stod(row.at(4 + i)))) << layer << i;
  }
  EXPECT_GT(last[6], 0.01F) << "it yields";
  EXPECT_NE(last[6], last[9 * 4 + 6]) << "it is bent";
  for (std::size_t i = 9 * 5; i < 9 * 6; ++i) EXPECT_EQ(last[i], 0) << "there is no sixth point";
  EXPECT_FLOAT_EQ(last.at(9 * 6 + 8), 1.0F) << "the thickness comes behind the resultants";
}

TEST_F(StateExtentRun, FurtherVariablesAreTheMaterials) {
  const auto file = run_deck("*DATABASE_EXTENT_BINARY\n7,5,3\n");
  EXPECT_EQ(file.root.integer(27), 7 + 7);
  EXPECT_EQ(file.root.integer(33), 3 * (7 + 5) + 8 + 4);
  const auto at = [](const std::vector<float>& values, std::size_t i) {
    return static_cast<double>(values.at(i));
  };
  const std::vector<float>& shell = file.states.back().shells;
  // With kinematic hardening the stress lies as far from the back stress as it has always done. The back
  // stress has xx, yy, xy, yz, zx of the element, whose axes here are the global ones, and zz = 0 for shells.
  for (const std::size_t layer : {1, 2}) {
    const std::size_t s = 12 * layer;
    const std::size_t b = s + 7;
    const std::array<double, 6> relative{at(shell, s) - at(shell, b),
                                         at(shell, s + 1) - at(shell, b + 1),
                                         at(shell, s + 2),
                                         at(shell, s + 3) - at(shell, b + 2),
                                         at(shell, s + 4) - at(shell, b + 3),
                                         at(shell, s + 5) - at(shell, b + 4)};
    EXPECT_NEAR(relative_von_mises(relative), yield_stress, 1e-5) << layer;
    EXPECT_GT(std::fabs(at(shell, b)), 0.02) << "it has hardened";
  }
  const std::vector<float>& solid = file.states.back().solids;
  std::array<double, 6> relative{};
  for (std::size_t i = 0; i < 6; ++i) relative[i] = at(solid, i) - at(solid, 7 + i);
  EXPECT_NEAR(relative_von_mises(relative), yield_stress, 1e-5);
  EXPECT_GT(std::fabs(at(solid, 9)), 0.02);
  EXPECT_EQ(solid.at(13), 0) << "a seventh variable is not there";
}

TEST_F(StateExtentRun, GroupsCanBeLeftOut) {
  const auto file = run_deck("*DATABASE_EXTENT_BINARY\n0,0,3,0,2,1,2,1\n");
  EXPECT_EQ(file.root.integer(33), 3 + 4);
  EXPECT_EQ(file.root.integers(43, 4), (std::vector<std::int32_t>{999, 1000, 999, 1000}));
  const std::vector<float>& shell = file.states.back().shells;
  const auto rows = table("out/elout_shells.csv");
  EXPECT_FLOAT_EQ(shell.at(1), static_cast<float>(std::stod(rows[rows.size() - 5].at(10))));
  EXPECT_FLOAT_EQ(shell.at(3), 1.0F) << "the thickness";
}

TEST_F(StateExtentRun, VtkReadsWhatParaviewIsShown) {
  if (std::system("/usr/bin/python3 -c 'import vtkmodules.vtkIOLSDyna' 2>/dev/null") != 0)
    GTEST_SKIP() << "VTK's Python is not installed (Debian: python3-vtk9)";
  run_deck("*DATABASE_EXTENT_BINARY\n4,5,3\n");
  const std::string python = "/usr/bin/python3 tests/app/read_d3plot_with_vtk.py ";
  ASSERT_EQ(std::system((python + path("out") + " extent > " + path("log") + " 2>&1").c_str()), 0)
      << read("log");
}

}  // namespace
}  // namespace crumple::app::state_extent_test
