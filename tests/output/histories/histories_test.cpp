// SPDX-License-Identifier: BSD-3-Clause
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <sstream>

#include "output/files/write_error.hpp"
#include "output/histories/history.hpp"
#include "output/recorder.hpp"
#include "output/results/part_masses.hpp"
#include "output/sample.hpp"

namespace crumple::output::histories_test {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
  return result;
}

/// The sample with a wall, a contact, a history node, a rigid body, a broken weld and a tied contact.
class HistoriesTest : public SampleTest {
 protected:
  HistoriesTest() : SampleTest(with_conditions()) {
    domain_.walls.push_back({.id = 4, .force = {}, .impulse = {}});
    domain_.contacts.push_back({.id = 2, .method = "linked-cell"});
    domain_.welds.push_back({.id = 31, .axial = 0, .shear = 0, .broken = true, .failure_time = 0.5});
    domain::Tie& tie = domain_.ties.emplace_back();
    tie.id = 6;
    tie.nodes.resize(5);
    tie.released = 2;
    tie.broken = 1;
    tie.force = {1, 2, 3};
    tie.energy = 0.5;
    domain_.rigid_bodies.resize(2);
    domain_.rigid_bodies[0].id = 8;
    domain_.rigid_bodies[1].id = 31;
  }
  static model::Model with_conditions() {
    model::Model model = sample_model();
    model.rigid_walls.push_back({.id = 4, .title = "", .nodes = {0, 1}, .point = {}, .normal = {0, 0, 1}});
    model.contacts.push_back(model::self_contact(2, "", {0}));
    model.output.history_nodes = {5, 0};
    model.rigid_bodies.push_back({.id = 8, .title = "", .parts = {}, .nodes = {0, 1}});
    return model;
  }
  void record(Recorder& recorder, double time, long cycle) {
    go_to(time, cycle);
    recorder.write_due(view());
  }
};

TEST_F(HistoriesTest, HeadersAreTheDocumentedOnes) {
  Recorder recorder(folder_, "run", view());
  EXPECT_EQ(
      lines(folder_ / "glstat.csv")[0],
      "time,dt,kinetic,internal,hourglass,contact,friction,rigidwall,damping,external_work,eroded,total,"
      "ratio,added_mass");
  EXPECT_EQ(lines(folder_ / "matsum.csv")[0], "time,part,internal,kinetic,hourglass,vx,vy,vz,mass");
  EXPECT_EQ(lines(folder_ / "rwforc.csv")[0], "time,wall,normal,fx,fy,fz");
  EXPECT_EQ(lines(folder_ / "rcforc.csv")[0], "time,interface,side,fx,fy,fz,mass");
  EXPECT_EQ(lines(folder_ / "nodout.csv")[0], "time,node,ux,uy,uz,vx,vy,vz,ax,ay,az,x,y,z");
  EXPECT_EQ(lines(folder_ / "rbdout.csv")[0], "time,body,x,y,z,vx,vy,vz,wx,wy,wz,kinetic,fx,fy,fz");
  EXPECT_EQ(lines(folder_ / "swforc.csv")[0], "time,weld,axial,shear,broken");
  EXPECT_EQ(lines(folder_ / "ties.csv")[0], "time,interface,tied,broken,fx,fy,fz,energy");
}

TEST_F(HistoriesTest, TiesCountWhatIsStillTied) {
  Recorder recorder(folder_, "run", view());
  record(recorder, 0, 0);
  EXPECT_EQ(lines(folder_ / "ties.csv").at(1), "0,6,3,1,1,2,3,0.5");
}

TEST_F(HistoriesTest, WeldsHaveRowsOfTheirOwnAndNoneOfBodies) {
  domain_.welds.push_back({.id = 32, .axial = 2, .shear = 3});
  Recorder recorder(folder_, "run", view());
  record(recorder, 0, 0);
  const auto welds = lines(folder_ / "swforc.csv");
  ASSERT_EQ(welds.size(), 3U);
  EXPECT_EQ(cells(welds[1]), (std::vector<std::string>{"0", "31", "0", "0", "1"}));
  EXPECT_EQ(cells(welds[2]), (std::vector<std::string>{"0", "32", "2", "3", "0"}));
  const auto bodies = lines(folder_ / "rbdout.csv");
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(cells(bodies[1])[1], "8");
}

TEST_F(HistoriesTest, EveryRowHasAsManyCellsAsTheHeader) {
  Recorder recorder(folder_, "run", view());
  record(recorder, 0, 0);
  for (const auto& file : recorder.files()) {
    if (file.extension() != ".csv") continue;
    const auto rows = lines(file);
    EXPECT_GE(rows.size(), 2U) << file;
    for (const auto& row : rows) EXPECT_EQ(cells(row).size(), cells(rows[0]).size()) << file << ": " << row;
  }
}

TEST_F(HistoriesTest, StepsHaveTheElementThatControlsThem) {
  View seen = view();
  seen.controlling = [] { return domain::ControllingElement{"discrete element", 12, 3}; };
  Recorder recorder(folder_, "run", seen);
  recorder.write_due(seen);
  EXPECT_EQ(lines(folder_ / "timestep.csv")[0], "time,dt,kind,element,part");
  EXPECT_EQ(lines(folder_ / "timestep.csv")[1], "0,0.001,discrete,12,3");
}

TEST_F(HistoriesTest, NumbersReadBackToTheSameDouble) {
  domain_.energy.kinetic = 1.0 / 3;
  domain_.energy.internal = -1e-300 / 7;
  Recorder recorder(folder_, "run", view());
  record(recorder, 0.1, 3);
  const auto row = cells(lines(folder_ / "glstat.csv")[1]);
  EXPECT_EQ(std::stod(row[0]), 0.1);
  EXPECT_EQ(std::stod(row[2]), 1.0 / 3);
  EXPECT_EQ(std::stod(row[3]), -1e-300 / 7);
}

TEST_F(HistoriesTest, TheLastStateIsWrittenOnce) {
  Recorder recorder(folder_, "run", view());
  record(recorder, 0, 0);
  record(recorder, 0.0105, 1);
  record(recorder, 0.01051, 2);
  EXPECT_EQ(lines(folder_ / "glstat.csv").size(), 3U) << "cycle 2 comes before the next multiple";
  EXPECT_EQ(recorder.frames(), 2);
  recorder.write_last(view());
  recorder.write_last(view());
  EXPECT_EQ(lines(folder_ / "glstat.csv").size(), 4U);
  EXPECT_EQ(cells(lines(folder_ / "nodout.csv").back())[0], "0.01051");
  EXPECT_EQ(recorder.frames(), 3);
}

TEST_F(HistoriesTest, IntervalsOfTheDeckHoldAndTheRestTakesDefaults) {
  model_.output.of(model::HistoryFile::Glstat).interval = 0.25;
  model_.output.state_interval = 0.5;
  Recorder recorder(folder_, "run", view());
  for (long cycle = 0; cycle <= 4000; ++cycle) record(recorder, static_cast<double>(cycle) / 4000, cycle);
  EXPECT_EQ(lines(folder_ / "glstat.csv").size(), 1U + 5);
  EXPECT_EQ(lines(folder_ / "rwforc.csv").size(), 1U + 1001);
  EXPECT_EQ(recorder.frames(), 3);
}

TEST_F(HistoriesTest, WallForceTimesTimeSumsToTheImpulse) {
  Recorder recorder(folder_, "run", view());
  record(recorder, 0, 0);
  double time = 0;
  for (long cycle = 1; cycle <= 1000; ++cycle) {
    time += 1e-3 * (1 + 0.5 * std::sin(static_cast<double>(cycle)));
    const double impulse = std::fabs(std::sin(0.7 * static_cast<double>(cycle)));
    domain_.walls[0].impulse.z -= impulse;
    domain_.walls[0].normal_impulse += impulse;
    record(recorder, time, cycle);
  }
  recorder.write_last(view());
  const auto rows = lines(folder_ / "rwforc.csv");
  double impulse = 0;
  double normal_impulse = 0;
  for (std::size_t i = 2; i < rows.size(); ++i) {
    const double interval = std::stod(cells(rows[i])[0]) - std::stod(cells(rows[i - 1])[0]);
    impulse += std::stod(cells(rows[i])[5]) * interval;
    normal_impulse += std::stod(cells(rows[i])[2]) * interval;
  }
  EXPECT_NEAR(impulse, domain_.walls[0].impulse.z, 1e-10);
  EXPECT_NEAR(normal_impulse, domain_.walls[0].normal_impulse, 1e-10);
  EXPECT_GT(std::stod(cells(rows[2])[2]), 0) << "nodes press on the wall: its normal force is positive";
}

TEST_F(HistoriesTest, WallsThatMoveHaveRowsOfTheirMotion) {
  {
    const Recorder recorder(folder_, "run", view());
    EXPECT_FALSE(std::filesystem::exists(folder_ / "rwmotion.csv")) << "the only wall is at rest";
  }
  model_.rigid_walls.push_back(
      {.id = 9, .title = "", .nodes = {0, 1}, .point = {}, .normal = {0, 0, 1}, .mass = 2});
  domain_.walls.push_back(
      {.id = 9, .displacement_now = {0, 0, 0.25}, .velocity = {0, 0, -3}, .mass = 2, .kinetic_energy = 9.5});
  Recorder recorder(folder_, "run", view());
  record(recorder, 0, 0);
  recorder.write_last(view());
  const auto rows = lines(folder_ / "rwmotion.csv");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0], "time,wall,ux,uy,uz,vx,vy,vz,kinetic");
  EXPECT_EQ(rows[1], "0,9,0,0,0.25,0,0,-3,9.5");
}

TEST_F(HistoriesTest, PartRowsHoldMassMotionAndEnergies) {
  // Part 7 is 2 x 1 by 0.5 thick; it flies at 3 along x and its energies are set by hand.
  for (math::Vec3& velocity : domain_.nodes.velocity) velocity = {3, 0, 0};
  for (domain::ShellBlock& block : domain_.shells)
    if (model_.parts[block.part].id == 7) {
      block.internal_energy = 11;
      block.hourglass_energy = 0.5;
    }
  Recorder recorder(folder_, "run", view());
  record(recorder, 0, 0);
  const auto rows = lines(folder_ / "matsum.csv");
  ASSERT_EQ(rows.size(), 3U);
  const auto row = cells(rows[1]);
  const double mass = 7.85e-6 * 2 * 0.5;
  EXPECT_EQ(row[1], "7");
  EXPECT_EQ(row[2], "11");
  EXPECT_NEAR(std::stod(row[3]), 0.5 * mass * 9, 1e-18);
  EXPECT_EQ(row[4], "0.5");
  EXPECT_NEAR(std::stod(row[5]), 3, 1e-14);
  EXPECT_NEAR(std::stod(row[8]), mass, 1e-20);
  EXPECT_EQ(cells(rows[2])[1], "3");
  EXPECT_NEAR(std::stod(cells(rows[2])[8]), 7.85e-6 * 0.5 * 0.5, 1e-20) << "the triangle";
}

TEST_F(HistoriesTest, NodeRowsFollowTheDecksListAndIds) {
  const Index node = domain_.nodes.domain_node[5];
  domain_.nodes.position[node] += math::Vec3{0.5, 0, 0};
  domain_.nodes.acceleration[node] = {0, 9, 0};
  Recorder recorder(folder_, "run", view());
  record(recorder, 0, 0);
  EXPECT_EQ(lines(folder_ / "nodout.csv")[1], "0,10,0.5,0,0,0,0,0,0,9,0,2.5,1,0");
  EXPECT_EQ(cells(lines(folder_ / "nodout.csv")[2])[1], "60");
}

// Displacements, velocities and accelerations are along local axes, coordinates are not.
TEST_F(HistoriesTest, NodesHaveAxesOfTheirOwn) {
  model_.output.history_axes = {{.node = 5, .axes = {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}}};
  const Index node = domain_.nodes.domain_node[5];
  domain_.nodes.position[node] += math::Vec3{0.5, 0, 0};
  domain_.nodes.velocity[node] = {1, 2, 3};
  domain_.nodes.acceleration[node] = {0, 9, 0};
  Recorder recorder(folder_, "run", view());
  record(recorder, 0, 0);
  EXPECT_EQ(lines(folder_ / "nodout.csv")[1], "0,10,0,-0.5,0,2,-1,3,9,0,0,2.5,1,0");
  EXPECT_EQ(cells(lines(folder_ / "nodout.csv")[2])[1], "60");
}

TEST_F(HistoriesTest, AxesMoveWithThreeNodes) {
  model_.output.history_axes = {
      {.node = 5, .axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, .moving = {0, 1, 3}}};
  const auto place = [&](Index node, const math::Vec3& x) {
    domain_.nodes.position[domain_.nodes.domain_node[static_cast<std::size_t>(node)]] = x;
  };
  // A quarter turn about z.
  place(0, {7, 7, 0});
  place(1, {7, 9, 0});
  place(3, {6, 7.5, 0});
  const Index node = domain_.nodes.domain_node[5];
  domain_.nodes.position[node] += math::Vec3{0.5, 0, 0};
  domain_.nodes.velocity[node] = {1, 2, 3};
  Recorder recorder(folder_, "run", view());
  record(recorder, 0, 0);
  EXPECT_EQ(lines(folder_ / "nodout.csv")[1], "0,10,0,-0.5,0,2,-1,3,0,0,0,2.5,1,0");
}

TEST_F(SampleTest, AModelWithoutWallsContactsAndHistoryNodesHasNoSuchFiles) {
  const Recorder recorder(folder_, "run", view());
  EXPECT_TRUE(std::filesystem::exists(folder_ / "glstat.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "matsum.csv"));
  for (const char* name : {"rwforc.csv", "rcforc.csv", "nodout.csv"})
    EXPECT_FALSE(std::filesystem::exists(folder_ / name)) << name;
}

TEST_F(SampleTest, ATableThatCannotGrowIsAnErrorThatNamesItAndKeepsItsRows) {
  CsvFile table(folder_ / "t.csv", "a,b");
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{6, limit.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string message;
  try {
    table.add_row(1, 2);
    table.flush();
  } catch (const WriteError& fault) {
    message = fault.what();
  }
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("t.csv: File too large"), std::string::npos) << message;
  EXPECT_EQ(std::filesystem::file_size(folder_ / "t.csv"), 4U);
}

}  // namespace
}  // namespace crumple::output::histories_test
