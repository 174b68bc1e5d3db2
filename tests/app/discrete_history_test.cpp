// SPDX-License-Identifier: BSD-3-Clause
// deforc.csv of runs, against what the motion of the nodes says.
#include <cmath>

#include "app/program_fixture.hpp"
#include "math/vec3.hpp"
#include "support/larger.hpp"

namespace crumple::app::discrete_history_test {
namespace {

/// Two springs in a row along (3, 4, 0) between a held node, a mass and a mass that flies off, a damper to
/// the ground along z and a torsional spring about x. `more` is put before the end.
std::string springs(const std::string& more) {
  return "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*CONTROL_TIMESTEP\n0.,0.05\n"
         "*NODE\n1,0.,0.,0.,7,7\n2,3.,4.,0.\n3,6.,8.,0.\n4,1.,0.,0.,7,7\n"
         "*ELEMENT_DISCRETE\n"
         "11,1,1,2\n"
         "12,1,2,3\n"
         "13,2,3,0,9\n"
         "14,3,1,2,8\n"
         "*ELEMENT_INERTIA\n1,2\n0.5,,,0.5,,0.5,2.0\n"
         "*ELEMENT_MASS\n2,3,2.0\n"
         "*DEFINE_SD_ORIENTATION\n9,0,0.,0.,1.\n8,0,1.,0.,0.\n"
         "*PART\nsprings\n1,1,1\n*PART\ndamper\n2,1,2\n*PART\ntorsion\n3,2,1\n"
         "*SECTION_DISCRETE\n1,0\n0.\n"
         "*SECTION_DISCRETE\n2,1\n0.\n"
         "*MAT_SPRING_ELASTIC\n1,5.0\n"
         "*MAT_DAMPER_VISCOUS\n2,0.25\n"
         "*INITIAL_VELOCITY_NODE\n3,0.6,0.8,0.5\n2,0.,0.,0.,0.3\n"
         "*DATABASE_NODOUT\n0.1\n*DATABASE_HISTORY_NODE\n2,3\n"
         "*DATABASE_DEFORC\n0.1\n" +
         more + "*END\n";
}

class DiscreteHistoryRun : public ProgramTest {
 protected:
  std::vector<std::vector<std::string>> rows_of(const std::string& deck) {
    const std::string file = write("springs.k", deck);
    const Result result = run({"run", file, "-o", path("out"), "-q"});
    EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
    return table("out/deforc.csv");
  }
};

TEST_F(DiscreteHistoryRun, FollowsTheLawAndTheNodes) {
  const auto rows = rows_of(springs(""));
  const auto nodes = table("out/nodout.csv");
  ASSERT_EQ(rows.size(), nodes.size() / 2 * 4 + 1);
  ASSERT_GE(rows.size(), 41U);
  EXPECT_EQ(rows[0],
            (std::vector<std::string>{"time", "element", "resultant", "fx", "fy", "fz", "displacement"}));
  const auto number = [](const std::string& cell) { return std::stod(cell); };
  double largest = 0;
  for (std::size_t time = 0; 4 * time + 4 < rows.size(); ++time) {
    const auto* const row = &rows[4 * time + 1];
    const auto* const node = &nodes[2 * time + 1];
    ASSERT_EQ(row[1][1], "12");
    ASSERT_EQ(node[1][1], "3");
    ASSERT_EQ(row[1][0], node[1][0]);
    const math::Vec3 x2{number(node[0][11]), number(node[0][12]), number(node[0][13])};
    const math::Vec3 x3{number(node[1][11]), number(node[1][12]), number(node[1][13])};
    const double stretch = norm(x3 - x2) - 5;
    const math::Vec3 force = (5 * stretch / norm(x3 - x2)) * (x3 - x2);
    EXPECT_NEAR(number(row[1][2]), 5 * stretch, 1e-12);
    EXPECT_NEAR(number(row[1][6]), stretch, 1e-12);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(number(row[1][3 + axis]), force[axis], 1e-12);
    largest = test::larger_of(largest, std::fabs(stretch));
    // The damper to the ground has a displacement along its axis alone; the torsional spring turns.
    EXPECT_NEAR(number(row[2][6]), -number(node[1][4]), 1e-12);
    EXPECT_EQ(number(row[2][3]), 0);
    EXPECT_EQ(number(row[2][5]), number(row[2][2]));
    EXPECT_NEAR(number(row[3][2]), 5 * number(row[3][6]), 1e-12);
    EXPECT_EQ(number(row[3][4]), 0);
  }
  EXPECT_GT(largest, 0.1) << "the springs were stretched";
  EXPECT_GT(std::fabs(number(rows.back()[6])), 0.002) << "the torsional spring was turned";
}

TEST_F(DiscreteHistoryRun, HoldsWhatIsNamedIfAnythingIs) {
  const auto rows = rows_of(
      springs("*DATABASE_HISTORY_DISCRETE_SET\n3\n*SET_DISCRETE\n3\n13,11\n*DATABASE_HISTORY_DISCRETE\n14\n"
              "*DATABASE_HISTORY_DISCRETE_ID\n11,again\n"));
  ASSERT_GE(rows.size(), 4U);
  EXPECT_EQ(rows[1][1], "13");
  EXPECT_EQ(rows[2][1], "11");
  EXPECT_EQ(rows[3][1], "14");
  EXPECT_EQ((rows.size() - 1) % 3, 0U);
}

}  // namespace
}  // namespace crumple::app::discrete_history_test
