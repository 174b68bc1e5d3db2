// SPDX-License-Identifier: BSD-3-Clause
// ncforc.csv and secforc.csv of runs, against what other tables say.
#include <cmath>
#include <map>

#include "app/program_fixture.hpp"
#include "math/vec3.hpp"
#include "support/larger.hpp"

namespace crumple::app::contact_node_history_test {
namespace {

/// A plate of 2 x 2 shells that flies with 1 mm/ms onto another one, whose mesh is turned and at rest.
std::string plates(const std::string& more) {
  std::string nodes;
  std::string shells;
  for (int plate = 0; plate < 2; ++plate)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const double x = plate == 0 ? 10.0 * i : 12.0 * i + 2.0 * j - 3;
        const double y = plate == 0 ? 10.0 * j : 12.0 * j - 2.0 * i - 1;
        nodes += std::to_string(100 * plate + 3 * j + i + 1) + "," + std::to_string(x) + "," +
                 std::to_string(y) + "," + (plate == 0 ? "1.2\n" : "0.\n");
        if (i == 2 || j == 2) continue;
        const int corner = 100 * plate + 3 * j + i + 1;
        shells += std::to_string(100 * plate + 2 * j + i + 1) + "," + std::to_string(plate + 1) + "," +
                  std::to_string(corner) + "," + std::to_string(corner + 1) + "," +
                  std::to_string(corner + 4) + "," + std::to_string(corner + 3) + "\n";
      }
  return "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*NODE\n" + nodes + "*ELEMENT_SHELL\n" + shells +
         "*PART\nupper\n1,1,1\n*PART\nlower\n2,1,1\n*SECTION_SHELL\n1,2,0.833333,3\n1.,1.,1.,1.\n"
         "*MAT_ELASTIC\n1,7.83e-6,207.,0.3\n"
         "*SET_NODE_LIST_GENERATE\n1\n1,9\n"
         "*INITIAL_VELOCITY\n1\n0.3,0.,-1.\n" +
         more + "*END\n";
}

class ContactNodeHistoryRun : public ProgramTest {
 protected:
  void run_deck(const std::string& deck) {
    const Result result = run({"run", write("plates.k", deck), "-o", path("out"), "-q"});
    ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  }
  static math::Vec3 vector(const std::vector<std::string>& row, std::size_t first) {
    return {std::stod(row.at(first)), std::stod(row.at(first + 1)), std::stod(row.at(first + 2))};
  }
};

TEST_F(ContactNodeHistoryRun, SidesAddUpToTheResultants) {
  run_deck(
      plates("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n5,plates\n1,2,3,3,0,0,1,1\n0.2,0.2\n1.\n"
             "*DATABASE_RCFORC\n0.001\n*DATABASE_NCFORC\n0.001\n"));
  const auto rows = table("out/ncforc.csv");
  const auto resultants = table("out/rcforc.csv");
  ASSERT_GT(rows.size(), 50U);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"time", "interface", "side", "node", "fx", "fy", "fz"}));
  std::map<std::pair<std::string, std::string>, math::Vec3> sums;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][1], "5");
    const bool is_upper = std::stoi(rows[i][3]) < 100;
    EXPECT_EQ(rows[i][2], is_upper ? "first" : "second");
    sums[{rows[i][0], rows[i][2]}] += vector(rows[i], 4);
  }
  double largest = 0;
  double worst = 0;
  for (std::size_t i = 1; i < resultants.size(); ++i) {
    const math::Vec3 force = vector(resultants[i], 3);
    worst = test::larger_of(worst, norm(force - sums[{resultants[i][0], resultants[i][2]}]));
    largest = test::larger_of(largest, norm(force));
  }
  EXPECT_GT(largest, 0.01);
  EXPECT_LT(worst, 2e-15 * largest);
}

TEST_F(ContactNodeHistoryRun, ContactWithItselfHasNoResultant) {
  run_deck(plates("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n0.2,0.2\n1.\n*DATABASE_NCFORC\n0.001\n"));
  const auto rows = table("out/ncforc.csv");
  ASSERT_GT(rows.size(), 50U);
  std::map<std::string, math::Vec3> sums;
  double largest = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][2], "single");
    sums[rows[i][0]] += vector(rows[i], 4);
    largest = test::larger_of(largest, norm(vector(rows[i], 4)));
  }
  for (const auto& [time, sum] : sums) EXPECT_LT(norm(sum), 4e-15 * largest) << time;
}

TEST_F(ContactNodeHistoryRun, IsWrittenOnlyWhenItsCardAsks) {
  run_deck(plates("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n0.\n1.\n"));
  EXPECT_TRUE(exists("out/rcforc.csv"));
  EXPECT_FALSE(exists("out/ncforc.csv"));
  EXPECT_FALSE(exists("out/secforc.csv"));
}

TEST_F(ContactNodeHistoryRun, ARunThatIsTakenUpWritesTheSameRows) {
  const std::string deck = write(
      "plates.k", plates("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n0.2,0.2\n1.\n*DATABASE_NCFORC\n0.001\n"
                         "*DATABASE_SECFORC\n0.001\n*DATABASE_SPCFORC\n0.001\n*DATABASE_ELOUT\n0.001\n"
                         "*DATABASE_HISTORY_SHELL\n2,102\n*BOUNDARY_SPC_NODE\n101,0,1,1,1,1,1,1\n"
                         "*DATABASE_CROSS_SECTION_PLANE\n0,5.,0.,0.,6.,0.,0.\n0.\n"));
  const auto run_whole = [&](const char* folder) {
    return run({"run", deck, "-o", path(folder), "-q", "--restart-every", "100"}).code;
  };
  ASSERT_EQ(run_whole("whole"), ExitCode::Normal);
  ASSERT_EQ(run_whole("out"), ExitCode::Normal);
  const Result result = run({"run", "--restart", path("out/restart/previous.restart"), "-q"});
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  for (const char* name : {"ncforc.csv", "secforc.csv", "spcforc.csv", "elout_shells.csv"}) {
    const std::string whole = read(std::string("whole/") + name);
    EXPECT_GT(whole.size(), 1000U) << name;
    EXPECT_EQ(whole, read(std::string("out/") + name)) << name;
  }
}

TEST_F(ContactNodeHistoryRun, SectionsOfPlanesAndOfTheSameSetsAreEqual) {
  run_deck(
      plates("*DATABASE_SECFORC\n0.1\n"
             "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,3,1.\n*DEFINE_CURVE\n3\n0.,0.\n1.,-3.\n"
             "*DATABASE_CROSS_SECTION_PLANE_ID\n31,plane\n4,5.,0.,0.,6.,0.,0.\n0.\n"
             "*SET_PART_LIST\n4\n1\n"
             "*DATABASE_CROSS_SECTION_SET_ID\n32,sets\n6,0,0,7\n"
             "*SET_NODE_LIST\n6\n1,4,7\n*SET_SHELL_LIST\n7\n1,3\n"));
  const auto rows = table("out/secforc.csv");
  ASSERT_GE(rows.size(), 21U);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"time", "section", "fx", "fy", "fz", "mx", "my", "mz", "force",
                                               "x", "y", "z"}));
  double largest = 0;
  for (std::size_t i = 1; i + 1 < rows.size(); i += 2) {
    EXPECT_EQ(rows[i][1], "31");
    EXPECT_EQ(rows[i + 1][1], "32");
    for (std::size_t k = 2; k < 12; ++k)
      EXPECT_NEAR(std::stod(rows[i][k]), std::stod(rows[i + 1][k]), 1e-12) << k;
    EXPECT_NEAR(std::stod(rows[i][8]), norm(vector(rows[i], 2)), 1e-12);
    largest = test::larger_of(largest, std::stod(rows[i][8]));
  }
  EXPECT_GT(largest, 0.01);
}

}  // namespace
}  // namespace crumple::app::contact_node_history_test
