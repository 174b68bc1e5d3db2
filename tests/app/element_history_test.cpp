// SPDX-License-Identifier: BSD-3-Clause
// elout_*.csv and spcforc.csv of runs whose nodes all move as prescribed, against Hooke's law.
#include <cmath>

#include "app/program_fixture.hpp"
#include "support/larger.hpp"

namespace crumple::app::element_history_test {
namespace {

constexpr double modulus = 210.0;
constexpr double poisson = 0.3;
constexpr double speed = 0.01;  // of the ends, in 1 ms over a length of 10
constexpr double turning = 0.002;

/// A shell in the plane y = 0 that is stretched along x and bent, a cube that is stretched along z, and a
/// beam along x that is stretched.
std::string deck(const std::string& requests) {
  return "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*CONTROL_TIMESTEP\n0.,0.1\n"
         "*NODE\n"
         "1,0.,0.,0.\n2,10.,0.,0.\n3,10.,0.,-10.\n4,0.,0.,-10.\n"
         "11,20.,0.,0.\n12,30.,0.,0.\n13,30.,10.,0.\n14,20.,10.,0.\n"
         "15,20.,0.,10.\n16,30.,0.,10.\n17,30.,10.,10.\n18,20.,10.,10.\n"
         "21,40.,0.,0.\n22,50.,0.,0.\n23,40.,5.,0.\n"
         "*ELEMENT_SHELL\n1,1,1,2,3,4\n"
         "*ELEMENT_SOLID\n5,2,11,12,13,14,15,16,17,18\n"
         "*ELEMENT_BEAM\n7,3,21,22,23\n"
         "*PART\nplate\n1,1,1\n*PART\ncube\n2,2,1\n*PART\nbeam\n3,3,1\n"
         "*SECTION_SHELL\n1,2,1.0,2\n1.,1.,1.,1.\n"
         "*SECTION_SOLID\n2,1\n"
         "*SECTION_BEAM\n3,2\n12.,10.,10.,20.\n"
         "*MAT_ELASTIC\n1,7.85e-6,210.,0.3\n"
         "*SET_NODE_LIST\n1\n1,4\n*SET_NODE_LIST\n2\n2,3\n"
         "*SET_NODE_LIST\n3\n11,12,13,14\n*SET_NODE_LIST\n4\n15,16,17,18\n"
         "*SET_NODE_LIST\n5\n1,2,3,4,11,12,13,14\n15,16,17,18,21,22\n*SET_NODE_LIST\n6\n1,4,21\n"
         "*DEFINE_CURVE\n1\n0.,1.\n10.,1.\n"
         "*BOUNDARY_SPC_SET\n5,0,0,1,0,1,1,0\n6,0,1,1,0,1,1,0\n"
         "*BOUNDARY_PRESCRIBED_MOTION_SET\n2,1,0,1,0.01\n4,3,0,1,0.01\n2,7,0,1,0.002\n1,7,0,1,-0.002\n"
         "*BOUNDARY_SPC_SET\n3,0,1,1,1\n4,0,1,1,0\n"
         "*BOUNDARY_PRESCRIBED_MOTION_NODE\n22,1,0,1,0.01\n"
         "*BOUNDARY_SPC_NODE\n1,0,0,0,1\n4,0,0,0,1\n2,0,0,0,1\n3,0,0,0,1\n22,0,0,1,1,1,1,1\n21,0,1,1,1,1,1,"
         "1\n"
         "*DATABASE_ELOUT\n0.25\n*DATABASE_SPCFORC\n0.25\n" +
         requests + "*END\n";
}

class ElementHistoryRun : public ProgramTest {
 protected:
  void run_deck(const std::string& requests) {
    const std::string file = write("elements.k", deck(requests));
    const Result result = run({"run", file, "-o", path("out"), "-q", "--precision", "double"});
    ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  }
  static double number(const std::vector<std::string>& row, std::size_t column) {
    return std::stod(row.at(column));
  }
};

TEST_F(ElementHistoryRun, ShellsShowEveryPointInGlobalAxes) {
  run_deck("*DATABASE_HISTORY_SHELL\n1\n");
  const auto rows = table("out/elout_shells.csv");
  ASSERT_GE(rows.size(), 11U);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"time", "element", "plane", "point", "xx", "yy", "zz", "xy",
                                               "yz", "zx", "plastic_strain"}));
  double bent = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto& row = rows[i];
    EXPECT_EQ(row[1], "1");
    EXPECT_EQ(row[2], "1");
    EXPECT_EQ(number(row, 3), static_cast<double>(2 - i % 2));
    const double time = number(row, 0);
    // Points count along the normal, which is y; fibres turn about z: the strain is -y times the curvature.
    const double curvature = 2 * turning * time / 10;
    const double y = (row[3] == "1" ? -0.5 : 0.5) / std::sqrt(3.0);
    const double strain = std::log1p(speed * time / 10) - y * curvature;
    const double stress = modulus / (1 - poisson * poisson) * strain;
    const double bound = 1e-3 * modulus * (turning + speed) / 10;
    EXPECT_NEAR(number(row, 4), stress, bound) << "time " << time;
    EXPECT_NEAR(number(row, 6), poisson * stress, bound);
    EXPECT_NEAR(number(row, 5), 0, bound);
    for (const std::size_t shear : {7, 8, 9}) EXPECT_NEAR(number(row, shear), 0, bound);
    bent = test::larger_of(bent, std::fabs(y * curvature * modulus) / bound);
  }
  EXPECT_GT(bent, 10) << "bending is well above the bound";
}

TEST_F(ElementHistoryRun, SolidsShowTheirStresses) {
  run_deck("*DATABASE_HISTORY_SOLID_SET\n9\n*SET_SOLID\n9\n5\n");
  const auto rows = table("out/elout_solids.csv");
  ASSERT_GE(rows.size(), 6U);
  const double lame = modulus * poisson / ((1 + poisson) * (1 - 2 * poisson));
  const double shear = modulus / (2 * (1 + poisson));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][1], "5");
    const double strain = std::log1p(speed * number(rows[i], 0) / 10);
    const double bound = 1e-6 * modulus * speed;
    EXPECT_NEAR(number(rows[i], 3), lame * strain, bound);
    EXPECT_NEAR(number(rows[i], 4), lame * strain, bound);
    EXPECT_NEAR(number(rows[i], 5), (lame + 2 * shear) * strain, bound);
    for (const std::size_t component : {6, 7, 8, 9}) EXPECT_NEAR(number(rows[i], component), 0, bound);
  }
}

TEST_F(ElementHistoryRun, BeamsShowTheirForces) {
  run_deck("*DATABASE_HISTORY_BEAM_ID\n7,the beam\n*DATABASE_HISTORY_BEAM_SET\n2\n*SET_BEAM\n2\n7\n");
  const auto rows = table("out/elout_beams.csv");
  ASSERT_GE(rows.size(), 6U);
  EXPECT_EQ(rows[1][0], "0");
  EXPECT_NE(rows[2][0], "0") << "one row per time";
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][1], "7");
    const double strain = speed * number(rows[i], 0) / 10;
    EXPECT_NEAR(number(rows[i], 2), modulus * 12 * strain, 1e-3 * modulus * 12 * speed / 10);
    for (std::size_t other = 3; other < 9; ++other) EXPECT_EQ(number(rows[i], other), 0);
  }
}

TEST_F(ElementHistoryRun, NothingNamedIsNothingWritten) {
  run_deck("");
  for (const char* name : {"out/elout_shells.csv", "out/elout_solids.csv", "out/elout_beams.csv"})
    EXPECT_FALSE(exists(name)) << name;
  EXPECT_TRUE(exists("out/spcforc.csv"));
}

}  // namespace
}  // namespace crumple::app::element_history_test
