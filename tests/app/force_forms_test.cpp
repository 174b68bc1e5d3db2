// SPDX-License-Identifier: BSD-3-Clause
// The histories of forces and stresses in LS-DYNA's forms, of runs, against the tables.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/program_fixture.hpp"
#include "output/lsda_reader.hpp"

namespace crumple::app::force_forms_test {
namespace {

using output::LsdaReader;
using Ids = std::vector<std::int64_t>;
using Names = std::map<std::string, std::string>;

/// Two shells of four points in plane and one of one, a cube with eight points and one with one that yields,
/// a beam, two springs and a torsional one, each pulled or bent. A plate falls on the cubes. `binary` is that
/// of the cards.
std::string deck(int binary) {
  const std::string form = "0.02," + std::to_string(binary) + "\n";
  return "*KEYWORD\n*TITLE\nforces\n*CONTROL_TERMINATION\n0.1\n*CONTROL_TIMESTEP\n0.,0.2\n*CONTROL_"
         "HOURGLASS\n2,0.1\n"
         "*NODE\n"
         "1,0.,0.,0.\n2,10.,0.,0.\n3,10.,10.,1.\n4,0.,10.,0.\n5,20.,0.,0.\n6,20.,10.,0.\n"
         "11,40.,0.,0.\n12,50.,0.,0.\n13,50.,10.,0.\n14,40.,10.,0.\n"
         "15,40.,0.,10.\n16,50.,0.,10.\n17,50.,10.,10.\n18,40.,10.,10.\n"
         "21,40.,0.,20.\n22,50.,0.,20.\n23,50.,10.,20.\n24,40.,10.,20.\n"
         "31,80.,0.,0.\n32,90.,0.,0.\n33,80.,5.,0.\n"
         "41,38.,-2.,22.05\n42,52.,-2.,22.05\n43,52.,12.,22.05\n44,38.,12.,22.05\n"
         "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,4,2,5,6,3\n9,5,41,42,43,44\n"
         "*ELEMENT_SOLID\n5,2,11,12,13,14,15,16,17,18\n6,6,15,16,17,18,21,22,23,24\n"
         "*ELEMENT_BEAM\n7,3,31,32,33\n"
         "*ELEMENT_DISCRETE\n71,7,4,31\n72,8,6,32,8\n"
         "*DEFINE_SD_ORIENTATION\n8,0,1.,0.,0.\n"
         "*PART\nfull\n1,1,1\n*PART\ncube\n2,2,1\n*PART\nbeam\n3,3,1\n*PART\none point\n4,4,1\n"
         "*PART\nfalling\n5,9,1\n*PART\nupper cube\n6,6,4\n*PART\nspring\n7,7,2\n*PART\ntorsion\n8,8,2\n"
         "*SECTION_SHELL\n1,16,1.0,3\n1.,1.,1.,1.\n*SECTION_SHELL\n4,2,1.0,2\n0.5,0.5,0.5,0.5\n"
         "*SECTION_SHELL\n9,2,1.0,2\n4.,4.,4.,4.\n"
         "*SECTION_SOLID\n2,2\n*SECTION_SOLID\n6,1\n*SECTION_BEAM\n3,2\n12.,10.,10.,20.\n"
         "*SECTION_DISCRETE\n7,0\n0.\n*SECTION_DISCRETE\n8,1\n0.\n"
         "*MAT_ELASTIC\n1,7.85e-6,210.,0.3\n*MAT_SPRING_ELASTIC\n2,5.0\n"
         "*MAT_PLASTIC_KINEMATIC\n4,7.85e-6,210.,0.3,0.01,1.\n\n"
         "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n4,0,1,1,1\n11,0,1,1,1\n12,0,1,1,1\n13,0,1,1,1\n14,0,1,1,1\n"
         "31,0,0,0,0,1,1,1\n"
         "*SET_NODE_LIST\n1\n5,6,32\n*SET_NODE_LIST\n2\n41,42,43,44\n"
         "*INITIAL_VELOCITY\n1\n1.,2.,3.,0.1,0.2,0.3\n*INITIAL_VELOCITY\n2\n0.,0.,-5.\n"
         "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n50,falls\n5,6,3,3\n\n\n"
         "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n60,itself\n3,0,2\n\n\n*SET_PART_LIST\n3\n2,5,6\n"
         "*DATABASE_CROSS_SECTION_SET_ID\n17,cut\n6,0,0,7\n*SET_NODE_LIST\n6\n2,3\n*SET_SHELL_LIST\n7\n1\n"
         "*DATABASE_CROSS_SECTION_SET_ID\n18,\n9,0,10\n*SET_NODE_LIST\n9\n31\n*SET_BEAM\n10\n7\n"
         "*DATABASE_HISTORY_SHELL\n2,1,9\n*DATABASE_HISTORY_SOLID\n5,6\n*DATABASE_HISTORY_BEAM\n7\n"
         "*DATABASE_DEFORC\n" +
         form + "*DATABASE_SECFORC\n" + form + "*DATABASE_SPCFORC\n" + form + "*DATABASE_ELOUT\n" + form +
         "*DATABASE_NCFORC\n" + form + "*END\n";
}

class ForceForms : public ProgramTest {
 protected:
  void run_deck(int binary) {
    const Result result = run({"run", write("forces.k", deck(binary)), "-o", path("out"), "-q"});
    ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  }

  /// A column of a table, of the rows that `use` takes.
  template <class Use>
  std::vector<double> column(const std::string& file, const std::string& name, const Use& use) const {
    const auto rows = table("out/" + file);
    const auto place = std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin();
    std::vector<double> values;
    for (std::size_t i = 1; i < rows.size(); ++i)
      if (use(rows[i])) values.push_back(std::stod(rows[i].at(static_cast<std::size_t>(place))));
    return values;
  }
  std::vector<double> column(const std::string& file, const std::string& name) const {
    return column(file, name, [](const auto&) { return true; });
  }

  /// An array of all states of a branch, one after the other.
  static std::vector<double> history(const LsdaReader& binout, const std::string& branch,
                                     const std::string& name) {
    std::vector<double> values;
    for (int state = 1; state <= binout.states(branch); ++state)
      for (const double value : binout.reals(branch + "/d00000" + std::to_string(state) + "/" + name))
        values.push_back(value);
    return values;
  }

  template <class Use>
  void expect_same(const std::string& branch, const std::string& file, const Names& names,
                   const Use& use) const {
    const LsdaReader binout(path("out/binout0000"));
    for (const auto& [ours, theirs] : names) {
      const std::vector<double> values = history(binout, branch, theirs);
      EXPECT_EQ(values, column(file, ours, use)) << branch << " " << theirs;
      EXPECT_FALSE(values.empty()) << branch << " " << theirs;
    }
  }
  void expect_same(const std::string& branch, const std::string& file, const Names& names) const {
    expect_same(branch, file, names, [](const auto&) { return true; });
  }

  std::vector<std::string> lines(const std::string& name) const {
    std::vector<std::string> result;
    std::istringstream text(read("out/" + name));
    for (std::string line; std::getline(text, line);) result.push_back(line);
    return result;
  }
};

const Names forces{{"fx", "x_force"}, {"fy", "y_force"}, {"fz", "z_force"}};

TEST_F(ForceForms, OfSpringsAndSectionsHaveTheNumbersOfTheTables) {
  run_deck(2);
  expect_same("/deforc", "deforc.csv", forces);
  expect_same("/deforc", "deforc.csv", {{"resultant", "resultant_force"}, {"displacement", "displacement"}});
  expect_same("/secforc", "secforc.csv", forces);
  expect_same("/secforc", "secforc.csv",
              {{"force", "total_force"},
               {"mx", "x_moment"},
               {"my", "y_moment"},
               {"mz", "z_moment"},
               {"x", "x_centroid"},
               {"y", "y_centroid"},
               {"z", "z_centroid"}});
  const LsdaReader binout(path("out/binout0000"));
  EXPECT_EQ(binout.integers("/deforc/metadata/ids"), (Ids{71, 72}));
  EXPECT_EQ(binout.integers("/deforc/metadata/irot"), (Ids{0, 1}));
  EXPECT_EQ(binout.integers("/secforc/metadata/ids"), (Ids{17, 18}));
  EXPECT_EQ(binout.integers("/secforc/metadata/rigidbody"), (Ids{0, 0}));
  EXPECT_EQ(binout.integers("/secforc/metadata/legend_ids"), (Ids{17}));
  EXPECT_EQ(binout.characters("/secforc/metadata/legend").substr(0, 4), "cut ");
  const auto moment = binout.reals("/secforc/d000003/total_moment");
  EXPECT_GT(moment[0], 0);
  EXPECT_DOUBLE_EQ(moment[0], std::hypot(binout.reals("/secforc/d000003/x_moment")[0],
                                         binout.reals("/secforc/d000003/y_moment")[0],
                                         binout.reals("/secforc/d000003/z_moment")[0]));
}

TEST_F(ForceForms, OfSupportsHaveTheSumsApart) {
  run_deck(2);
  const auto of_any = [](const std::set<std::string>& nodes) {
    return [nodes](const std::vector<std::string>& row) { return nodes.contains(row[1]); };
  };
  expect_same("/spcforc", "spcforc.csv", forces, of_any({"1", "4", "11", "12", "13", "14"}));
  expect_same("/spcforc", "spcforc.csv", {{"mx", "x_moment"}, {"my", "y_moment"}, {"mz", "z_moment"}},
              of_any({"1", "31"}));
  expect_same("/spcforc", "spcforc.csv",
              {{"fx", "x_resultant"}, {"fy", "y_resultant"}, {"fz", "z_resultant"}}, of_any({"0"}));
  const LsdaReader binout(path("out/binout0000"));
  EXPECT_EQ(binout.integers("/spcforc/metadata/force_ids"), (Ids{1, 4, 11, 12, 13, 14}));
  EXPECT_EQ(binout.integers("/spcforc/metadata/moment_ids"), (Ids{1, 31}));
  EXPECT_FALSE(binout.has("/spcforc/metadata/ids"));
}

const Names stresses{{"xx", "sig_xx"}, {"yy", "sig_yy"}, {"zz", "sig_zz"},
                     {"xy", "sig_xy"}, {"yz", "sig_yz"}, {"zx", "sig_zx"}};

TEST_F(ForceForms, OfShellsAreTheMeansOfThePointsInPlane) {
  run_deck(2);
  const LsdaReader binout(path("out/binout0000"));
  EXPECT_EQ(binout.states("/elout/shell"), 6);
  EXPECT_EQ(binout.integers("/elout/shell/d000002/ids"), (Ids{2, 1, 9}));
  EXPECT_EQ(binout.integers("/elout/shell/d000002/mat"), (Ids{4, 1, 5}));
  EXPECT_EQ(binout.integers("/elout/shell/d000002/nip"), (Ids{2, 3, 2}));
  EXPECT_EQ(binout.integers("/elout/shell/d000002/iop"), (Ids{2, 16, 2}));
  EXPECT_EQ(binout.integers("/elout/shell/d000002/state"), Ids(7, 1));
  EXPECT_EQ(binout.characters("/elout/shell/metadata/states"), "elastic,plastic");
  EXPECT_EQ(binout.characters("/elout/shell/metadata/system"), "global");
  EXPECT_FALSE(binout.has("/elout/shell/metadata/ids"));
  for (const auto& [ours, theirs] : stresses) {
    const auto found = history(binout, "/elout/shell", theirs);
    const auto of_two = column("elout_shells.csv", ours, [](const auto& row) { return row[1] == "2"; });
    const auto of_one = column("elout_shells.csv", ours, [](const auto& row) { return row[1] == "1"; });
    ASSERT_EQ(found.size(), 6U * 7);
    ASSERT_EQ(of_two.size(), 6U * 2);
    ASSERT_EQ(of_one.size(), 6U * 12);
    for (std::size_t state = 0; state < 6; ++state) {
      for (std::size_t layer = 0; layer < 2; ++layer)
        EXPECT_EQ(found[7 * state + layer], of_two[2 * state + layer]);
      for (std::size_t layer = 0; layer < 3; ++layer) {
        const double* const first = &of_one[12 * state + layer];
        EXPECT_DOUBLE_EQ(found[7 * state + 2 + layer], (first[0] + first[3] + first[6] + first[9]) / 4);
      }
    }
  }
}

TEST_F(ForceForms, OfSolidsAreTheMeansOfTheElements) {
  run_deck(2);
  const LsdaReader binout(path("out/binout0000"));
  EXPECT_EQ(binout.integers("/elout/solid/d000006/ids"), (Ids{5, 6}));
  EXPECT_EQ(binout.integers("/elout/solid/d000006/mtype"), (Ids{2, 6}));
  EXPECT_EQ(binout.integers("/elout/solid/d000006/state"), (Ids{1, 2})) << "the upper one has yielded";
  Names all = stresses;
  all["plastic_strain"] = "yield";
  for (const auto& [ours, theirs] : all) {
    const auto found = history(binout, "/elout/solid", theirs);
    const auto eight = column("elout_solids.csv", ours, [](const auto& row) { return row[1] == "5"; });
    const auto one = column("elout_solids.csv", ours, [](const auto& row) { return row[1] == "6"; });
    ASSERT_EQ(found.size(), 12U);
    ASSERT_EQ(eight.size(), 48U);
    ASSERT_EQ(one.size(), 6U);
    for (std::size_t state = 0; state < 6; ++state) {
      double sum = 0;
      for (std::size_t point = 0; point < 8; ++point) sum += eight[8 * state + point] / 8;
      EXPECT_DOUBLE_EQ(found[2 * state], sum) << theirs;
      EXPECT_EQ(found[2 * state + 1], one[state]) << theirs;
    }
  }
  const auto last = [&](const char* name) {
    return binout.reals(std::string("/elout/solid/d000006/") + name)[1];
  };
  const double mises = std::sqrt(
      0.5 * (std::pow(last("sig_xx") - last("sig_yy"), 2) + std::pow(last("sig_yy") - last("sig_zz"), 2) +
             std::pow(last("sig_zz") - last("sig_xx"), 2)) +
      3 * (std::pow(last("sig_xy"), 2) + std::pow(last("sig_yz"), 2) + std::pow(last("sig_zx"), 2)));
  EXPECT_NEAR(last("effsg"), mises, 1e-14 * mises);
}

TEST_F(ForceForms, OfBeamsHaveTheNumbersOfTheTable) {
  run_deck(2);
  expect_same("/elout/beam", "elout_beams.csv",
              {{"axial", "axial"},
               {"shear_s", "shear_s"},
               {"shear_t", "shear_t"},
               {"moment_s", "moment_s"},
               {"moment_t", "moment_t"},
               {"torsion", "torsion"}});
  const LsdaReader binout(path("out/binout0000"));
  EXPECT_EQ(binout.integers("/elout/beam/d000001/ids"), (Ids{7}));
  EXPECT_EQ(binout.integers("/elout/beam/d000001/mat"), (Ids{3}));
  EXPECT_EQ(binout.integers("/elout/beam/d000001/nip"), (Ids{0}));
}

TEST_F(ForceForms, OfContactsHaveAllNodesOfASide) {
  run_deck(2);
  const LsdaReader binout(path("out/binout0000"));
  EXPECT_EQ(binout.below("/ncforc/"), (std::set<std::string>{"master_50", "slave_50", "slave_60"}));
  EXPECT_EQ(binout.integers("/ncforc/slave_50/metadata/ids"), (Ids{41, 42, 43, 44}));
  EXPECT_EQ(binout.integers("/ncforc/master_50/metadata/ids"), (Ids{15, 16, 17, 18, 21, 22, 23, 24}));
  EXPECT_EQ(binout.integers("/ncforc/slave_60/metadata/ids").size(), 16U);
  // What the table has, and zero elsewhere.
  const auto rows = table("out/ncforc.csv");
  ASSERT_GT(rows.size(), 10U);
  std::map<std::string, std::map<std::string, std::map<std::int64_t, std::array<double, 3>>>> given;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::string side = rows[i][2] == "second" ? "master_" : "slave_";
    given[side + rows[i][1]][rows[i][0]][std::stoll(rows[i][3])] = {
        std::stod(rows[i][4]), std::stod(rows[i][5]), std::stod(rows[i][6])};
  }
  EXPECT_EQ(given.size(), 3U) << "every side is touched";
  std::size_t found = 0;
  for (const std::string branch : {"slave_50", "master_50", "slave_60"}) {
    const Ids nodes = binout.integers("/ncforc/" + branch + "/metadata/ids");
    std::map<double, std::map<std::int64_t, std::array<double, 3>>> at;
    for (const auto& [time, all] : given[branch]) at[std::stod(time)] = all;
    for (int state = 1; state <= binout.states("/ncforc/" + branch); ++state) {
      const std::string folder = "/ncforc/" + branch + "/d00000" + std::to_string(state) + "/";
      auto& forces_now = at[binout.reals(folder + "time")[0]];
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        found += forces_now.contains(nodes[i]) ? 1 : 0;
        const std::array<double, 3> force{binout.reals(folder + "x_force")[i],
                                          binout.reals(folder + "y_force")[i],
                                          binout.reals(folder + "z_force")[i]};
        EXPECT_EQ(force, forces_now[nodes[i]]) << folder << nodes[i];
      }
    }
  }
  EXPECT_EQ(found, rows.size() - 1) << "no force is lost";
  EXPECT_EQ(binout.reals("/ncforc/slave_50/d000001/z"), std::vector<double>(4, 22.05));
}

TEST_F(ForceForms, SprAndMprChooseTheSidesOfContacts) {
  std::string text = deck(2);
  const std::string without = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n50,falls\n5,6,3,3\n";
  ASSERT_NE(text.find(without), std::string::npos);
  text.replace(text.find(without), without.size(),
               "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n50,falls\n5,6,3,3,0,0,0,1\n");
  ASSERT_EQ(run({"run", write("sides.k", text), "-o", path("sides"), "-q"}).code, ExitCode::Normal);
  const LsdaReader binout(path("sides/binout0000"));
  EXPECT_EQ(binout.below("/ncforc/"), (std::set<std::string>{"master_50"}));
  run_deck(2);
  EXPECT_EQ(binout.reals("/ncforc/master_50/d000002/z_force"),
            LsdaReader(path("out/binout0000")).reals("/ncforc/master_50/d000002/z_force"));
}

TEST_F(ForceForms, CardsChooseTheForm) {
  run_deck(1);
  EXPECT_FALSE(exists("out/binout0000"));
  const auto files = record("out")["files"].get<std::vector<std::string>>();
  for (const std::string name : {"deforc", "secforc", "spcforc", "elout", "ncforc"}) {
    EXPECT_EQ(std::count(files.begin(), files.end(), name), 1) << name;
    EXPECT_EQ(lines(name).at(0), " forces") << name;
    EXPECT_EQ(lines(name).at(1).substr(0, 41), "                         crumple (version") << name;
  }
  run_deck(2);
  for (const char* name : {"deforc", "secforc", "spcforc", "elout", "ncforc"})
    EXPECT_FALSE(exists(std::string("out/") + name)) << name;
}

TEST_F(ForceForms, ARunThatIsTakenUpWritesTheSame) {
  const std::string file = write("forces.k", deck(0));
  const auto run_whole = [&](const char* folder) {
    return run({"run", file, "-o", path(folder), "-q", "--restart-every", "20"}).code;
  };
  ASSERT_EQ(run_whole("whole"), ExitCode::Normal);
  ASSERT_EQ(run_whole("out"), ExitCode::Normal);
  const Result result = run({"run", "--restart", path("out/restart/previous.restart"), "-q"});
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  for (const char* name : {"binout0000", "deforc", "secforc", "spcforc", "elout", "ncforc", "deforc.csv",
                           "ncforc.csv", "elout_shells.csv"}) {
    const std::string whole = read(std::string("whole/") + name);
    EXPECT_GT(whole.size(), 500U) << name;
    EXPECT_TRUE(whole == read(std::string("out/") + name)) << name;
  }
}

}  // namespace
}  // namespace crumple::app::force_forms_test
