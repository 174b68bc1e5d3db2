// SPDX-License-Identifier: BSD-3-Clause
// Small decks that once broke the program, most of them at 3b5ed1e: each is run as its user would, with
// nothing set for it.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/program_fixture.hpp"

namespace crumple::app::attacks_test {
namespace {

class Attacks : public ProgramTest {
 protected:
  nlohmann::json survive(const std::string& name, const std::vector<std::string>& options = {}) {
    std::vector<std::string> words{"run", "tests/app/attacks/" + name + ".k", "-o", path(name), "-q"};
    words.insert(words.end(), options.begin(), options.end());
    const Result result = run(words);
    EXPECT_EQ(result.code, ExitCode::Normal) << name << ": " << result.err;
    return record(name);
  }
  static double value(const nlohmann::json& record, const std::string& check) {
    for (const auto& entry : record["checks"])
      if (entry["name"].get<std::string>().starts_with(check)) return entry["value"].get<double>();
    ADD_FAILURE() << "no check " << check;
    return 0;
  }
  /// Column of a table's last row, or of the last but `before`, by its name.
  double last(const std::string& name, const std::string& column, std::size_t before = 0) const {
    const auto rows = table(name);
    for (std::size_t i = 0; i < rows[0].size(); ++i)
      if (rows[0][i] == column) return std::stod(rows[rows.size() - 1 - before][i]);
    ADD_FAILURE() << "no column " << column;
    return 0;
  }
};

TEST_F(Attacks, ModelsAtRestAndFallingBlocksPassEveryCheck) {
  for (const char* name : {"block_onto_plate", "block_onto_wall", "late_gravity", "sheets_in_each_other",
                           "sheets_in_each_other_2"}) {
    const nlohmann::json record = survive(name);
    for (const auto& check : record["checks"]) EXPECT_TRUE(check["pass"]) << name << ": " << check;
  }
}

/// Most of the blow is in hourglass patterns.
TEST_F(Attacks, AStruckBlockGainsNoEnergy) {
  survive("struck_block");
  EXPECT_LE(last("struck_block/glstat.csv", "ratio"), 1 + 1e-6);
  EXPECT_GE(last("struck_block/glstat.csv", "kinetic"), 0);
}

/// Twelve elastic bricks of 4 x 2 x 2 hexahedra that fall on each other and on a wall: the viscous form takes
/// half of their 9.2 J, and leaves 2.1 J of motion. Edges touch, too: without, it is chance whether some are
/// in each other at the end.
TEST_F(Attacks, ThrownBricksKeepTheirEnergy) {
  const nlohmann::json record = survive("thrown_bricks");
  for (const auto& check : record["checks"]) EXPECT_TRUE(check["pass"]) << check;
  EXPECT_LT(last("thrown_bricks/glstat.csv", "hourglass"), 0.02 * 9.216);
  EXPECT_GT(last("thrown_bricks/glstat.csv", "kinetic"), 3);
  EXPECT_NEAR(last("thrown_bricks/glstat.csv", "ratio"), 1, 1e-3);
}

TEST_F(Attacks, SheetsThatMeetFastRebound) {
  for (const char* name : {"rubber_sheets", "steel_sheets"}) {
    const nlohmann::json record = survive(name);
    // The sheets are through each other's middle for some of their two dozen cycles.
    EXPECT_EQ(record["contact"][0]["intersections"], 0) << name;
    EXPECT_EQ(value(record, "nodes on or beyond a mid-surface"), 0) << name;
    EXPECT_EQ(value(record, "negative contact energy"), 0) << name;
  }
}

/// The stable step follows the soft foam, and with it what stiffness contact may have: five nodes were lost,
/// up to 5.8 thicknesses deep, before contact bounded the step.
TEST_F(Attacks, FoamBetweenPlatesIsHeld) {
  const nlohmann::json record = survive("foam_between_plates");
  for (const auto& contact : record["contact"]) {
    EXPECT_EQ(contact["lost_nodes"]["count"], 0) << contact["id"];
    EXPECT_LT(contact["deepest_penetration"]["share"], 0.8) << contact["id"];
  }
  for (const auto& check : record["checks"]) EXPECT_TRUE(check["pass"]) << check;
  EXPECT_LT(value(record, "contact energy without friction"), 0.1);
}

/// AUTOMATIC_SINGLE_SURFACE sees no edges: nothing stops these, and at the end they are apart again.
TEST_F(Attacks, BodiesThatPassThroughEachOtherFailTheirRun) {
  for (const char* name : {"crossing_sheets", "crossing_bars"}) {
    const nlohmann::json record = survive(name);
    EXPECT_EQ(record["contact"][0]["intersections"], 0) << name;
    const auto& worst = record["contact"][0]["worst_intersections"];
    EXPECT_GT(worst["count"], 5) << name;
    EXPECT_LT(worst["time"], 0.5 * record["end_time"].get<double>()) << name;
    EXPECT_LT(worst["segments"][0], worst["segments"][1]) << name;
    EXPECT_EQ(value(record, "mid-surface intersections of the run"), worst["count"]) << name;
    for (const auto& check : record["checks"])
      EXPECT_EQ(check["pass"], !check["name"].get<std::string>().starts_with("mid-surface")) << check;
  }
}

/// What was seen before a restart is not forgotten.
TEST_F(Attacks, BodiesThatHavePassedThroughEachOtherBeforeARestartFailTheRest) {
  const nlohmann::json whole = survive("crossing_bars", {"--restart-every", "400"});
  const Result rest =
      run({"run", "--restart", path("crossing_bars/restart/previous.restart"), "-o", path("rest"), "-q"});
  ASSERT_EQ(rest.code, ExitCode::Normal) << rest.err;
  EXPECT_EQ(record("rest")["contact"][0]["worst_intersections"], whole["contact"][0]["worst_intersections"]);
  EXPECT_NE(rest.err.find("check failed: mid-surface intersections of the run"), std::string::npos)
      << rest.err;
}

/// A ball on its pole, which meets a node of the plate: the largest sideways velocity that it leaves with.
TEST_F(Attacks, ABallThatMeetsAPlateSquarelyReboundsSquarely) {
  survive("ball_bounce");
  EXPECT_LT(std::fabs(last("ball_bounce/matsum.csv", "vx", 1)), 1e-3);
  EXPECT_LT(std::fabs(last("ball_bounce/matsum.csv", "vy", 1)), 1e-3);
  EXPECT_NEAR(last("ball_bounce/matsum.csv", "vz", 1), 10, 0.01);
}

/// Coincident layers of nodes, and layers half way between: listed, held where they are, pushed where they
/// close.
TEST_F(Attacks, BlocksThatOverlapDeeplyAreListedAndHeld) {
  const nlohmann::json at_rest = survive("blocks_in_each_other");
  EXPECT_EQ(at_rest["contact"][0]["initial_penetrations"], 18);
  EXPECT_EQ(last("blocks_in_each_other/glstat.csv", "total"), 0);
  const nlohmann::json closing = survive("blocks_in_each_other_closing");
  EXPECT_GT(closing["contact"][0]["initial_penetrations"], 0);
  // Equal masses change their velocities.
  EXPECT_LT(last("blocks_in_each_other_closing/matsum.csv", "vz", 1), -3.5);
  EXPECT_LT(std::fabs(last("blocks_in_each_other_closing/matsum.csv", "vx", 1)), 0.05);
  // They still overlap, as they did at the start, and the record counts that as initial.
  EXPECT_GT(closing["contact"][0]["intersections"], 0);
  EXPECT_EQ(closing["contact"][0]["initial_intersections"], closing["contact"][0]["intersections"]);
}

TEST_F(Attacks, CrossedEdgesOfCubesAndShellsRebound) {
  for (const char* name : {"cube_edges", "shell_edges"}) {
    const nlohmann::json record = survive(name, {"--ls-dyna-defaults"});
    // Shells at 200 m/s are three thicknesses in each other before they turn round.
    EXPECT_EQ(record["contact"][0]["intersections"], 0) << name;
    EXPECT_EQ(value(record, "negative contact energy"), 0) << name;
    const std::string parts = std::string(name) + "/matsum.csv";
    EXPECT_GT(last(parts, "vz", 1) - last(parts, "vz"), 10) << name;
  }
}

/// With elastic hourglass control nothing is dissipated: the contact gives back what it stored, no more than
/// the trapezoidal rule over its last step.
TEST_F(Attacks, CrossedEdgesOfElasticCubesGetBackWhatTheyStored) {
  const nlohmann::json record = survive("cube_edges");
  EXPECT_EQ(value(record, "mid-surface intersections"), 0);
  EXPECT_GT(last("cube_edges/matsum.csv", "vz", 1) - last("cube_edges/matsum.csv", "vz"), 10);
  double stored = 0;
  const auto rows = table("cube_edges/glstat.csv");
  const auto contact = std::find(rows[0].begin(), rows[0].end(), "contact") - rows[0].begin();
  for (std::size_t i = 1; i < rows.size(); ++i)
    stored = std::max(stored, std::stod(rows[i].at(static_cast<std::size_t>(contact))));
  EXPECT_GT(stored, 50);
  EXPECT_LT(std::fabs(last("cube_edges/glstat.csv", "contact")), 1e-6 * stored);
}

/// Edges of soft foam in the corners of folding sheet: segments beside each other agree about the side.
TEST_F(Attacks, FoamInAFallingBoxStaysInside) {
  const nlohmann::json record = survive("foam_in_a_falling_box");
  EXPECT_EQ(value(record, "nodes lost"), 0);
  EXPECT_EQ(value(record, "mid-surface intersections"), 0);
  EXPECT_EQ(value(record, "nodes on or beyond a mid-surface"), 0);
}

/// Its nodes get deep into the plate before that fails, and pass from face to face. What the contact keeps
/// are the loaded springs of nodes that are squeezed out over the projectile's rim.
TEST_F(Attacks, ABluntProjectileLosesNoContact) {
  const nlohmann::json record = survive("blunt_projectile");
  EXPECT_EQ(value(record, "nodes lost"), 0);
  const double absorbed =
      last("blunt_projectile/glstat.csv", "internal") + last("blunt_projectile/glstat.csv", "eroded");
  EXPECT_LT(last("blunt_projectile/glstat.csv", "contact"), 0.07 * absorbed);
}

}  // namespace
}  // namespace crumple::app::attacks_test
