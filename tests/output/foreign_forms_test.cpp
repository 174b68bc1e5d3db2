// SPDX-License-Identifier: BSD-3-Clause
// The histories in LS-DYNA's forms: binout and the text files, against the tables.
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <map>
#include <optional>
#include <sstream>

#include "domain/state_snapshot.hpp"
#include "output/files/write_error.hpp"
#include "output/lsda_reader.hpp"
#include "output/recorder.hpp"
#include "output/sample.hpp"

namespace crumple::output::foreign_forms_test {
namespace {

using model::HistoryFile;

constexpr std::array all_files{HistoryFile::Sleout, HistoryFile::Glstat, HistoryFile::Matsum,
                               HistoryFile::Rwforc, HistoryFile::Rcforc, HistoryFile::Nodout,
                               HistoryFile::Rbdout, HistoryFile::Swforc, HistoryFile::Jntforc};

/// Two times of the sample with something of everything; the second one has moved.
class ForeignFormsTest : public SampleTest {
 protected:
  ForeignFormsTest() : SampleTest(with_conditions()) {
    domain_.walls.push_back({.id = 4, .force = {}, .impulse = {}});
    domain_.walls.push_back({.id = 9, .force = {}, .impulse = {}});
    domain_.contacts.push_back({.id = 2, .method = "linked-cell"});
    domain_.contacts.push_back({.id = 5, .method = "linked-cell", .two_sided = true});
    domain_.transducers.push_back({.id = 12, .force = {7, 8, 9}, .mass = 3});
    domain_.welds.push_back({.id = 31, .axial = 1.0 / 3, .shear = 2e-7});
    domain_.welds.push_back({.id = 32, .broken = true, .failure_time = 0.25});
    domain_.joints.push_back({.id = 41,
                              .force = {2, 1.0 / 3, -6},
                              .moment = {0, 3, 4},
                              .energy = 0.125,
                              .damping_energy = 1,
                              .opening = 1e-3});
    domain_.rigid_bodies.resize(3);
    domain_.rigid_bodies[0].id = 8;
    domain_.rigid_bodies[0].part = 0;
    domain_.rigid_bodies[1].id = 10;
    domain_.rigid_bodies[2].id = 31;
  }
  static model::Model with_conditions() {
    model::Model model = sample_model();
    model.title = "a plate";
    model.parts[0].title = "first";
    model.rigid_walls.push_back(
        {.id = 4, .title = "floor", .nodes = {0, 1}, .point = {}, .normal = {0, 0, 1}});
    model.rigid_walls.push_back({.id = 9, .title = "", .nodes = {2}, .point = {}, .normal = {0, 0, 1}});
    model.contacts.push_back(model::self_contact(2, "all", {0}));
    model.force_transducers.push_back({.id = 12, .title = "pelvis", .side = {}});
    model.output.history_nodes = {5, 0};
    model.rigid_bodies.push_back({.id = 8, .title = "", .parts = {0}, .nodes = {0, 1}});
    model.rigid_bodies.push_back({.id = 10, .title = "", .parts = {}, .nodes = {2, 3}});
    return model;
  }

  void ask(HistoryFile file, bool ascii, bool binary) {
    model_.output.of(file) = {.asked = true, .interval = 0.5, .ascii = ascii, .binary = binary};
  }
  void ask_for_all() {
    for (const HistoryFile file : all_files) ask(file, true, true);
  }

  /// What happens between the two times.
  void move() {
    domain_.energy.kinetic = 1.0 / 3;
    domain_.energy.internal = 20;
    domain_.energy.eroded = 4;
    domain_.energy.contact = 0.5;
    domain_.energy.friction = 0.25;
    domain_.energy.initial_total = 30;
    domain_.walls[0].energy = 1.5;
    domain_.walls[0].impulse = {0, 0, -3};
    domain_.walls[0].normal_impulse = 3;
    domain_.contacts[0].energy = 0.5;
    domain_.contacts[1].friction_energy = 0.25;
    domain_.contacts[1].force = {1, -2, 1.0 / 7};
    domain_.contacts[1].mass = {11, 13};
    for (Index node = 0; node < domain_.nodes.count(); ++node) {
      domain_.nodes.mass[node] = 2;
      domain_.nodes.position[node].z += 0.1 * node;
      domain_.nodes.velocity[node] = {1, 0.1 * node, -1e-5};
    }
    domain::RigidBody& body = domain_.rigid_bodies[0];
    body.centre = {3, 4, 0};
    body.velocity = {2, 0, 0};
    body.turn = {std::sqrt(0.5), {0, 0, std::sqrt(0.5)}};
  }

  View full_view() const {
    View seen = view();
    seen.controlling = [] { return domain::ControllingElement{"shell", 99, 7}; };
    return seen;
  }

  /// Both times, read back without the program having ended.
  void record_two() {
    const View seen = full_view();
    recorder_.emplace(folder_, "run", seen);
    recorder_->write_due(seen);
    move();
    go_to(0.5, 40);
    recorder_->write_due(seen);
  }

  /// What a restart file would hold of the histories.
  domain::StateSnapshot progress() {
    domain::StateList list;
    recorder_->declare(list);
    return domain::StateSnapshot(list);
  }

  /// Another recorder goes on with the files from there.
  void take_up(const domain::StateSnapshot& snapshot) {
    recorder_.emplace(folder_, "run", full_view(), ExtraFiles{.opening = Opening::Continued});
    domain::StateList list;
    recorder_->declare(list);
    snapshot.put_back_known(list);
    recorder_->resume(domain_.clock);
  }

  /// A column of one of our tables.
  std::vector<double> column(const std::string& file, const std::string& name) const {
    const std::vector<std::string> rows = lines(folder_ / file);
    std::size_t place = 0;
    std::istringstream header(rows[0]);
    for (std::string cell; std::getline(header, cell, ',') && cell != name;) ++place;
    std::vector<double> values;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      std::istringstream row(rows[i]);
      std::string cell;
      for (std::size_t k = 0; k <= place; ++k) std::getline(row, cell, ',');
      values.push_back(std::stod(cell));
    }
    return values;
  }

  /// An array of all states of binout, one state after the other.
  static std::vector<double> history(const LsdaReader& binout, const std::string& branch,
                                     const std::string& name) {
    std::vector<double> values;
    for (int state = 1; state <= binout.states(branch); ++state) {
      const std::string path = branch + "/d00000" + std::to_string(state) + "/" + name;
      if (binout.array(path).type == 10) {
        for (const double value : binout.reals(path)) values.push_back(value);
      } else {
        for (const std::int64_t value : binout.integers(path)) values.push_back(static_cast<double>(value));
      }
    }
    return values;
  }

  std::optional<Recorder> recorder_;
};

TEST_F(ForeignFormsTest, NothingComesUnasked) {
  const Recorder recorder(folder_, "run", view());
  for (const char* name :
       {"binout0000", "glstat", "matsum", "nodout", "rwforc", "rcforc", "rbdout", "swforc"})
    EXPECT_FALSE(std::filesystem::exists(folder_ / name)) << name;
}

TEST_F(ForeignFormsTest, TheCardChoosesTheForm) {
  ask(HistoryFile::Glstat, true, false);
  ask(HistoryFile::Nodout, false, true);
  record_two();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "glstat"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "nodout"));
  const LsdaReader binout(folder_ / "binout0000");
  EXPECT_EQ(binout.below("/"), std::set<std::string>{"nodout"});
  const auto files = recorder_->files();
  for (const char* name : {"glstat", "binout0000", "nodout.csv"})
    EXPECT_NE(std::find(files.begin(), files.end(), folder_ / name), files.end()) << name;
}

TEST_F(ForeignFormsTest, BinoutHasTheNumbersOfTheTables) {
  ask_for_all();
  record_two();
  const LsdaReader binout(folder_ / "binout0000");
  using Names = std::map<std::string, std::string>;
  const std::map<std::string, std::pair<std::string, Names>> tables{
      {"/glstat",
       {"glstat.csv",
        {{"time", "time"},
         {"dt", "time_step"},
         {"kinetic", "kinetic_energy"},
         {"hourglass", "hourglass_energy"},
         {"eroded", "eroded_internal_energy"},
         {"total", "total_energy"},
         {"ratio", "energy_ratio"}}}},
      {"/matsum",
       {"matsum.csv",
        {{"internal", "internal_energy"}, {"kinetic", "kinetic_energy"}, {"vy", "y_rbvelocity"}}}},
      {"/rwforc/forces",
       {"rwforc.csv", {{"normal", "normal_force"}, {"fx", "x_force"}, {"fy", "y_force"}, {"fz", "z_force"}}}},
      {"/rcforc",
       {"rcforc.csv", {{"fx", "x_force"}, {"fy", "y_force"}, {"fz", "z_force"}, {"mass", "mass"}}}},
      {"/sleout", {"sleout.csv", {{"friction", "friction_energy"}}}},
      {"/nodout",
       {"nodout.csv",
        {{"uz", "z_displacement"}, {"vy", "y_velocity"}, {"ax", "x_acceleration"}, {"z", "z_coordinate"}}}},
      {"/rbdout", {"rbdout.csv", {{"x", "global_x"}, {"vx", "global_vx"}, {"wz", "global_rvz"}}}},
      {"/swforc", {"swforc.csv", {{"axial", "axial"}, {"shear", "shear"}, {"broken", "failure_flag"}}}},
      {"/jntforc/joints",
       {"jntforc.csv",
        {{"fx", "x_force"},
         {"fy", "y_force"},
         {"mz", "z_moment"},
         {"force", "resultant_force"},
         {"moment", "resultant_moment"},
         {"energy", "joint_energy"}}}},
  };
  for (const auto& [branch, table] : tables) {
    EXPECT_EQ(binout.states(branch), 2) << branch;
    for (const auto& [ours, theirs] : table.second)
      EXPECT_EQ(history(binout, branch, theirs), column(table.first, ours)) << branch << " " << theirs;
    EXPECT_EQ(history(binout, branch, "cycle"), (std::vector<double>{0, 40})) << branch;
    EXPECT_EQ(binout.below(branch + "/d000001/"), binout.below(branch + "/d000002/")) << branch;
    EXPECT_EQ(binout.characters(branch + "/metadata/title").substr(0, 8), "a plate ") << branch;
    EXPECT_EQ(binout.characters(branch + "/metadata/title").size(), 80U) << branch;
  }
}

TEST_F(ForeignFormsTest, BinoutTellsWhatTheNumbersBelongTo) {
  ask_for_all();
  record_two();
  const LsdaReader binout(folder_ / "binout0000");
  using Ids = std::vector<std::int64_t>;
  EXPECT_EQ(binout.integers("/matsum/metadata/ids"), (Ids{7, 3}));
  EXPECT_EQ(binout.integers("/matsum/metadata/legend_ids"), (Ids{7, 3}));
  EXPECT_EQ(binout.characters("/matsum/metadata/legend").substr(70, 7), "second ");
  EXPECT_EQ(binout.integers("/nodout/metadata/ids"), (Ids{10, 60}));
  EXPECT_EQ(binout.integers("/rwforc/forces/metadata/ids"), (Ids{4, 9}));
  EXPECT_EQ(binout.integers("/rwforc/forces/metadata/legend_ids"), (Ids{4}));
  EXPECT_EQ(binout.integers("/rcforc/metadata/ids"), (Ids{2, 5, 5, 12}));
  EXPECT_EQ(binout.integers("/rcforc/metadata/side"), (Ids{0, 0, 1, 0}));
  EXPECT_EQ(binout.integers("/rcforc/metadata/legend_ids"), (Ids{2, 12}));
  EXPECT_EQ(binout.characters("/rcforc/metadata/legend").substr(70, 7), "pelvis ");
  EXPECT_EQ(binout.integers("/rbdout/metadata/ids"), (Ids{8, 10}));
  EXPECT_EQ(binout.integers("/rbdout/metadata/num_nodal"), (Ids{1}));
  EXPECT_EQ(binout.integers("/swforc/metadata/types"), (Ids{0, 0}));
  EXPECT_EQ(binout.characters("/glstat/metadata/element_types"), "solid,beam,shell,discrete");
  EXPECT_EQ(binout.integers("/glstat/d000002/ts_eltype"), (Ids{3}));
  EXPECT_EQ(binout.integers("/glstat/d000002/ts_element"), (Ids{99}));
}

TEST_F(ForeignFormsTest, EnergiesAddUpAsInLsDyna) {
  ask_for_all();
  record_two();
  const LsdaReader binout(folder_ / "binout0000");
  const auto last = [&](const char* name) { return binout.reals(std::string("/glstat/d000002/") + name); };
  EXPECT_EQ(last("internal_energy")[0], 24);
  EXPECT_EQ(last("sliding_interface_energy")[0], 0.75);
  EXPECT_EQ(binout.reals("/sleout/d000002/slave"), (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(binout.reals("/sleout/d000002/master"), (std::vector<double>{0}));
  EXPECT_EQ(binout.reals("/sleout/d000002/total_energy"), last("sliding_interface_energy"));
  EXPECT_EQ(last("stonewall_energy"), (std::vector<double>{1.5, 0}));
  EXPECT_DOUBLE_EQ(last("energy_ratio_wo_eroded")[0], (domain_.energy.total() - 4) / 30);
  EXPECT_DOUBLE_EQ(last("global_x_velocity")[0], 1);
}

TEST_F(ForeignFormsTest, BodiesTellTheirDisplacementAndTurn) {
  ask_for_all();
  record_two();
  const LsdaReader binout(folder_ / "binout0000");
  const auto first = [&](const char* name) {
    return binout.reals(std::string("/rbdout/d000002/") + name)[0];
  };
  EXPECT_EQ(first("global_dx"), 3);
  EXPECT_DOUBLE_EQ(first("global_rdz"), 0.5 * std::acos(-1.0));
  // A quarter turn about z takes the body's x to y: what points along x lies against its own y.
  EXPECT_DOUBLE_EQ(first("local_vy"), -2);
  EXPECT_DOUBLE_EQ(first("dircos_21"), 1);
  EXPECT_DOUBLE_EQ(first("dircos_12"), -1);
}

TEST_F(ForeignFormsTest, GlstatIsLaidOutInBlocks) {
  ask_for_all();
  record_two();
  const auto rows = lines(folder_ / "glstat");
  EXPECT_EQ(rows[0], " a plate");
  EXPECT_EQ(rows[1].substr(0, 41), "                         crumple (version");
  EXPECT_EQ(rows[4], " dt of cycle       0 is controlled by shell        99 of part         7");
  EXPECT_EQ(rows[6], " time...........................   0.00000E+00");
  const auto second = std::find_if(rows.begin() + 10, rows.end(),
                                   [](const std::string& row) { return row.starts_with(" dt of cycle"); });
  ASSERT_NE(second, rows.end());
  const std::vector<std::string> expected{
      " dt of cycle      40 is controlled by shell        99 of part         7",
      "",
      " time...........................   5.00000E-01",
      " time step......................   1.00000E-03",
      " kinetic energy.................   3.33333E-01",
      " internal energy................   2.40000E+01",
      " stonewall energy...............   1.50000E+00 wall# 1",
      " stonewall energy...............   0.00000E+00 wall# 2",
      " spring and damper energy.......   0.00000E+00",
      " hourglass energy ..............   0.00000E+00",
      " system damping energy..........   0.00000E+00",
      " sliding interface energy.......   7.50000E-01",
      " external work..................   0.00000E+00",
      " eroded kinetic energy..........   0.00000E+00",
      " eroded internal energy.........   4.00000E+00",
      " eroded hourglass energy........   0.00000E+00",
      " total energy...................   2.50833E+01",
      " total energy / initial energy..   8.36111E-01",
      " energy ratio w/o eroded energy.   7.02778E-01",
      " global x velocity..............   1.00000E+00",
  };
  EXPECT_EQ(std::vector<std::string>(second, second + static_cast<std::ptrdiff_t>(expected.size())),
            expected);
}

TEST_F(ForeignFormsTest, TablesOfLsDynaHaveFixedColumns) {
  ask_for_all();
  record_two();
  const auto last = [&](const char* name, std::size_t from_end = 1) {
    const auto rows = lines(folder_ / name);
    return rows[rows.size() - from_end];
  };
  EXPECT_EQ(last("rwforc", 2),
            " 5.00000E-01       4   6.000000E+00   0.000000E+00   0.000000E+00  -6.000000E+00");
  EXPECT_EQ(last("nodout"),
            "       60   0.0000E+00  0.0000E+00  0.0000E+00  1.0000E+00  0.0000E+00 -1.0000E-05"
            "  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00");
  EXPECT_EQ(last("nodout", 3),
            " nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel      x-accl      "
            "y-accl      z-accl      x-coor      y-coor      z-coor");
  EXPECT_EQ(
      last("nodout", 5),
      " n o d a l   p r i n t   o u t   f o r   t i m e  s t e p      40                              ( at "
      "time 5.00000E-01 )");
  EXPECT_EQ(last("rcforc", 3),
            "  slave           5 time 5.00000E-01  x  1.00000E+00  y -2.00000E+00  z  1.42857E-01 mass  "
            "1.10000E+01");
  EXPECT_EQ(last("rcforc", 2),
            "  master          5 time 5.00000E-01  x -1.00000E+00  y  2.00000E+00  z -1.42857E-01 mass  "
            "1.30000E+01");
  EXPECT_EQ(last("swforc", 2),
            "          1  3.33333E-01  2.00000E-07  5.00000E-01             constraint/weld  ID       31");
  EXPECT_EQ(last("swforc"),
            "          2  0.00000E+00  0.00000E+00  5.00000E-01  failure    constraint/weld  ID       32");
  EXPECT_EQ(last("jntforc", 10), " time............................   5.00000E-01");
  EXPECT_EQ(last("jntforc", 9), " joint ID........................            41");
  EXPECT_EQ(last("jntforc", 8), " x-force.........................    2.0000E+00");
  EXPECT_EQ(last("jntforc"), " resultant moment................    5.0000E+00");
  const auto parts = lines(folder_ / "matsum");
  EXPECT_EQ(parts[5], "        7     first");
  EXPECT_EQ(parts[parts.size() - 9], " time =   5.0000E-01");
  EXPECT_EQ(parts[parts.size() - 8].substr(0, 55), " mat.#=    7             inten=   0.0000E+00     kinen=");
  EXPECT_EQ(parts[parts.size() - 8].substr(68, 28), "     eroded_ie=   0.0000E+00");
  EXPECT_EQ(last("matsum"), "                         hgeng=   0.0000E+00     +mass=   0.0000E+00");
  EXPECT_EQ(last("sleout", 9), "         5   2.5000E-01   0.0000E+00");
  EXPECT_EQ(last("sleout", 5), "           total energy    = 7.5000000E-01");
  const auto bodies = lines(folder_ / "rbdout");
  EXPECT_NE(std::find(bodies.begin(), bodies.end(), " nodal rigid body      10"), bodies.end());
  EXPECT_NE(
      std::find(bodies.begin(), bodies.end(),
                " displacements:    3.0000E+00  4.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  1.5708E+00"),
      bodies.end());
}

TEST_F(ForeignFormsTest, ALaterRunGoesOnWithItsFiles) {
  ask_for_all();
  record_two();
  const domain::StateSnapshot snapshot = progress();
  const auto files = recorder_->files();
  const auto record_third = [&](Recorder& recorder) {
    domain_.rigid_bodies[0].centre = {5, 5, 5};
    go_to(1, 80);
    recorder.write_due(full_view());
  };
  record_third(*recorder_);
  std::map<std::string, std::string> whole;
  for (const auto& file : files)
    if (file.extension() == ".csv" || !file.has_extension()) whole[file] = read(file);
  EXPECT_EQ(whole.size(), 20U);

  go_to(0.5, 40);
  take_up(snapshot);
  EXPECT_EQ(LsdaReader(folder_ / "binout0000").states("/rbdout"), 2);
  record_third(*recorder_);
  for (const auto& [file, content] : whole) EXPECT_EQ(read(file), content) << file;
}

TEST_F(ForeignFormsTest, NodesThatARestartAddsAreNamed) {
  ask_for_all();
  record_two();
  const domain::StateSnapshot snapshot = progress();
  model_.output.history_nodes.push_back(3);
  take_up(snapshot);
  go_to(1, 80);
  recorder_->write_due(full_view());
  const LsdaReader binout(folder_ / "binout0000");
  EXPECT_EQ(binout.integers("/nodout/metadata/ids"), (std::vector<std::int64_t>{10, 60, 30}));
  EXPECT_EQ(binout.reals("/nodout/d000002/x_velocity").size(), 2U);
  EXPECT_EQ(binout.reals("/nodout/d000003/x_velocity").size(), 3U);
}

TEST_F(ForeignFormsTest, FilesThatAreGoneBeginAnew) {
  ask_for_all();
  record_two();
  const domain::StateSnapshot snapshot = progress();
  for (const char* name : {"binout0000", "nodout"}) std::filesystem::remove(folder_ / name);
  take_up(snapshot);
  go_to(1, 80);
  recorder_->write_due(full_view());
  const LsdaReader binout(folder_ / "binout0000");
  EXPECT_EQ(binout.states("/nodout"), 1);
  EXPECT_TRUE(binout.has("/nodout/metadata/ids"));
  EXPECT_EQ(lines(folder_ / "nodout")[0], " a plate");
}

TEST_F(ForeignFormsTest, AFullDiskLeavesWholeStates) {
  ask_for_all();
  record_two();
  const std::string text = read(folder_ / "rcforc");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto former = std::signal(SIGXFSZ, SIG_IGN);
  const std::uintmax_t size = std::filesystem::file_size(folder_ / "binout0000");
  const rlimit limit{.rlim_cur = size + 100, .rlim_max = before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  go_to(1, 80);
  EXPECT_THROW(recorder_->write_due(full_view()), WriteError);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, former);
  EXPECT_EQ(LsdaReader(folder_ / "binout0000").states("/rcforc"), 2);
  go_to(1.5, 90);
  recorder_->write_due(full_view());
  EXPECT_EQ(LsdaReader(folder_ / "binout0000").states("/rcforc"), 3);
  EXPECT_TRUE(read(folder_ / "rcforc").starts_with(text));
}

}  // namespace
}  // namespace crumple::output::foreign_forms_test
