// SPDX-License-Identifier: BSD-3-Clause
// A run to its half, written as dynain, read by a second deck and run on, against the run in one go; and what
// stays where it is when it begins with its stresses.
#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <string>

#include "app/dynain_runs.hpp"
#include "app/program_fixture.hpp"
#include "support/verified.hpp"

namespace crumple::app::dynain_test {
namespace {

struct Law {
  const char* name;
  const char* card;
};
constexpr Law laws[] = {{"*MAT_024", plastic_mat_24}, {"*MAT_003, BETA 0.3", kinematic_mat_3}};

void expect_below(const Apart& found, const std::string& what, const Apart& bound) {
  test::verified(what + ": displacements over the largest, difference", "run in one go")
      .below(found.displacement, bound.displacement);
  test::verified(what + ": stresses over the largest, difference", "run in one go")
      .below(found.stress, bound.stress);
  test::verified(what + ": plastic strains over the largest, difference", "run in one go")
      .below(found.plastic, bound.plastic);
}

// Solids take along all that counts: the digits of the file are all that is lost.
TEST(Dynain, SolidsGoOnAsInOneGo) {
  for (const Law& law : laws)
    for (const int elform : {1, 2, 10})
      expect_below(continued(squeezed_block(elform, law.card, elform == 10), 40, false),
                   fmt::format("dynain, solids of ELFORM {}, {}", elform, law.name), {1e-11, 1e-10, 1e-10});
}

// In bending nothing turns in the plane of the shell. With the masses and the drilling of the first run only
// the digits are lost.
TEST(Dynain, ShellsThatAreBentGoOnAsInOneGo) {
  for (const Law& law : laws)
    for (const int elform : {2, 10, 16})
      expect_below(continued(bent_plate(elform, law.card, {0, 0, 0.2}), 40, true),
                   fmt::format("dynain, bent shells of ELFORM {}, {}, with masses", elform, law.name),
                   {1e-9, 1e-8, 1e-8});
}

/// Two triangles of each quadrilateral of a mesh of *ELEMENT_SHELL.
std::string split(const std::string& mesh) {
  const std::size_t first = mesh.find("*ELEMENT_SHELL\n") + 15;
  std::string text = mesh.substr(0, first);
  std::istringstream lines(mesh.substr(first));
  char comma = 0;
  int n[6] = {};
  while (lines >> n[0] >> comma >> n[1] >> comma >> n[2] >> comma >> n[3] >> comma >> n[4] >> comma >> n[5])
    text += fmt::format("{},1,{},{},{}\n{},1,{},{},{}\n", 2 * n[0], n[2], n[3], n[4], 2 * n[0] + 1, n[4],
                        n[5], n[2]);
  return text;
}

// The other formulations, triangles, and layers of two laws.
TEST(Dynain, OtherShellsGoOnAsInOneGo) {
  constexpr Apart bound{1e-9, 1e-8, 1e-8};
  for (const int elform : {1, 6})
    expect_below(continued(bent_plate(elform, plastic_mat_24, {0, 0, 0.2}), 60, true),
                 fmt::format("dynain, bent shells of ELFORM {}, with masses", elform), bound);
  Pieces triangles = bent_plate(4, plastic_mat_24, {0, 0, 0.2});
  triangles.mesh = split(triangles.mesh);
  expect_below(continued(triangles, 60, true), "dynain, bent triangles, with masses", bound);
  Pieces layered = bent_plate(2, plastic_mat_24, {0, 0, 0.2});
  const std::size_t part = layered.properties.find("*SECTION_SHELL");
  layered.properties = layered.properties.substr(0, part) +
                       "*PART_COMPOSITE\nlayers\n1,2\n1,0.5,0,,2,0.5,0\n1,0.5,0\n" + plastic_mat_24 +
                       "*MAT_ELASTIC\n2,2.7E-6,70,0.33\n";
  expect_below(continued(layered, 60, true), "dynain, bent layers of two laws, with masses", bound);
}

// Sheared, they begin with axes of another reference: the stress rate differs by the product of the strain so
// far and its rate.
TEST(Dynain, ShellsThatAreShearedGoOnNearly) {
  for (const Law& law : laws)
    for (const int elform : {2, 10, 16})
      expect_below(continued(bent_plate(elform, law.card, {1, 0.5, 0.1}), 40, true),
                   fmt::format("dynain, sheared shells of ELFORM {}, {}, with masses", elform, law.name),
                   {1e-7, 1e-5, 1e-5});
}

// By itself the second run has masses of the present area and thickness, which elastic strain has changed by
// a thousandth.
TEST(Dynain, ShellsHaveTheMassOfTheirPresentVolume) {
  for (const Law& law : laws)
    for (const int elform : {2, 16})
      expect_below(continued(bent_plate(elform, law.card, {1, 0.5, 0.1}), 40, false),
                   fmt::format("dynain, sheared shells of ELFORM {}, {}", elform, law.name),
                   {1e-4, 2e-2, 2e-3});
}

/// Largest distance of a displacement from a value while a model runs.
double largest_departure(const model::Model& model, UserId node, int axis, double from, double moved) {
  timeloop::Simulation simulation(model, test::execution());
  Index at = 0;
  while (model.nodes.id[static_cast<std::size_t>(at)] != node) ++at;
  double most = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    most = test::larger_of(most, std::fabs(moved + test::displacement(now, at)[axis] - from));
  });
  return most;
}

/// What *INTERFACE_SPRINGBACK_LSDYNA of a deck writes at its end, and where a node is then.
struct Settled {
  output::Dynain dynain;
  double moved = 0;
};
Settled settled(const std::string& text, UserId node, int axis) {
  const model::Model model = model_of(text);
  timeloop::Simulation simulation(model, test::execution());
  output::DynainRequest request;
  request.springback = model.output.springback;
  Settled result;
  result.dynain = run_to_dynain(simulation, request);
  Index at = 0;
  while (model.nodes.id[static_cast<std::size_t>(at)] != node) ++at;
  result.moved = test::displacement(simulation.domain(), at)[axis];
  return result;
}

constexpr const char* constant_curve = "*DEFINE_CURVE\n1\n0,1\n1000,1\n";

// A cantilever of 10 shells with a load at its tip: P L^3 / (3 E I) of a beam, less 1 / (4 n^2) of it for n
// elements of constant curvature, and P L / (kappa G A) by shear. It settles under damping; the second run,
// without damping and with the supports of the file, stays there.
TEST(Dynain, ACantileverStaysBent) {
  constexpr double length = 100;
  constexpr double width = 10;
  constexpr double thickness = 5;
  constexpr double load = 0.06;
  constexpr double modulus = 210;
  const std::string properties = fmt::format(
      "{}*SECTION_SHELL\n1,16,0.8333333333333333,3\n{}\n*PART\nbeam\n1,1,1\n*MAT_ELASTIC\n1,7.85E-6,{},0\n"
      "*LOAD_NODE_POINT\n11,3,1,{}\n22,3,1,{}\n",
      constant_curve, thickness, modulus, 0.5 * load, 0.5 * load);
  std::string mesh = "*NODE\n";
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i <= 10; ++i)
      mesh += fmt::format("{},{},{},0\n", 11 * j + i + 1, 0.1 * length * i, width * j);
  mesh += "*ELEMENT_SHELL\n";
  for (int i = 1; i <= 10; ++i) mesh += fmt::format("{},1,{},{},{},{}\n", i, i, i + 1, i + 12, i + 11);
  const std::string first =
      "*KEYWORD\n*CONTROL_TERMINATION\n12\n" + properties + mesh +
      "*SET_NODE_LIST\n1\n1,12\n*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n*SET_PART_LIST\n1\n1\n"
      "*DAMPING_GLOBAL\n0,5.2\n*INTERFACE_SPRINGBACK_LSDYNA\n1\n1,7,7\n12,7,7\n*END\n";
  const Settled rest = settled(first, 11, 2);
  EXPECT_TRUE(rest.dynain.notes.empty());
  EXPECT_EQ(rest.dynain.text.find("VELOCITY"), std::string::npos);
  const double inertia = width * thickness * thickness * thickness / 12;
  const double closed = load * std::pow(length, 3) / (3 * modulus * inertia) * (1 - 0.25 / 100) +
                        load * length / (5.0 / 6 * 0.5 * modulus * width * thickness);
  test::verified("cantilever that settles: deflection at the tip", "beam theory, 10 elements")
      .within(rest.moved, closed, 1e-3);
  const model::Model second =
      model_of("*KEYWORD\n*CONTROL_TERMINATION\n5\n" + properties + "*INCLUDE\ndynain\n*END\n",
               {{"dynain", rest.dynain.text}});
  test::verified("cantilever that begins bent: largest departure over the deflection", "static equilibrium")
      .below(largest_departure(second, 11, 2, rest.moved, rest.moved) / closed, 1e-6);
}

// A bar of 10 solids that is pulled: F L / (E A).
TEST(Dynain, ABarStaysStretched) {
  constexpr double length = 100;
  constexpr double side = 10;
  constexpr double load = 12;
  constexpr double modulus = 210;
  for (const int elform : {1, 2}) {
    std::string properties = fmt::format(
        "{}*SECTION_SOLID\n1,{}\n*PART\nbar\n1,1,1\n*MAT_ELASTIC\n1,7.85E-6,{},0.3\n*LOAD_NODE_POINT\n",
        constant_curve, elform, modulus);
    for (int k = 0; k < 4; ++k) properties += fmt::format("{},1,1,{}\n", 100 * k + 11, 0.25 * load);
    std::string mesh = "*NODE\n";
    std::string supports;
    constexpr int codes[2][2][2] = {{{0, 3}, {2, 5}}, {{1, 6}, {4, 7}}};  // x, y, z held
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i <= 10; ++i) {
        const int y = k == 1 || k == 2 ? 1 : 0;
        const int z = k / 2;
        mesh += fmt::format("{},{},{},{},{}\n", 100 * k + i + 1, 0.1 * length * i, side * y, side * z,
                            codes[i == 0 ? 1 : 0][1 - y][1 - z]);
        supports += fmt::format("{},{}\n", 100 * k + i + 1, codes[i == 0 ? 1 : 0][1 - y][1 - z]);
      }
    mesh += "*ELEMENT_SOLID\n";
    for (int i = 1; i <= 10; ++i)
      mesh += fmt::format("{},1,{},{},{},{},{},{},{},{}\n", i, i, i + 1, 101 + i, 100 + i, 300 + i, 301 + i,
                          201 + i, 200 + i);
    const Settled rest = settled("*KEYWORD\n*CONTROL_TERMINATION\n2\n" + properties + mesh +
                                     "*SET_PART_LIST\n1\n1\n*DAMPING_GLOBAL\n0,160\n"
                                     "*INTERFACE_SPRINGBACK_LSDYNA\n1\n" +
                                     supports + "*END\n",
                                 11, 0);
    EXPECT_TRUE(rest.dynain.notes.empty());
    const double closed = load * length / (modulus * side * side);
    test::verified(fmt::format("bar of ELFORM {} that settles: elongation", elform), "F L / (E A)")
        .within(rest.moved, closed, 2e-3);
    const model::Model second =
        model_of("*KEYWORD\n*CONTROL_TERMINATION\n0.5\n" + properties + "*INCLUDE\ndynain\n*END\n",
                 {{"dynain", rest.dynain.text}});
    test::verified(
        fmt::format("bar of ELFORM {} that begins stretched: largest departure over the elongation", elform),
        "static equilibrium")
        .below(largest_departure(second, 11, 0, rest.moved, rest.moved) / closed, 1e-6);
  }
}

class DynainProgram : public ProgramTest {};

TEST_F(DynainProgram, WritesTheFileAndRemovesTheEarlierOne) {
  const Pieces pieces = bent_plate(2, plastic_mat_24, {1, 0.5, 0.1});
  const std::string deck = write(
      "plate.k", "*KEYWORD\n" + termination(10) + pieces.properties + pieces.mesh + pieces.motion + "*END\n");
  const Result first = run({"run", deck, "-o", path("out"), "--dynain"});
  EXPECT_EQ(first.code, ExitCode::Normal) << first.err;
  EXPECT_NE(first.out.find("dynain"), std::string::npos);
  const std::string text = read("out/dynain");
  EXPECT_TRUE(text.starts_with(output::dynain_mark)) << text.substr(0, 100);
  for (const char* keyword : {"*ELEMENT_SHELL_THICKNESS", "*NODE\n", "*INITIAL_STRESS_SHELL\n",
                              "*INITIAL_VELOCITY_NODE+\n", "*END\n"})
    EXPECT_NE(text.find(keyword), std::string::npos) << keyword;
  write("second.k", "*KEYWORD\n" + termination(10) + pieces.properties + "*INCLUDE\nout/dynain\n*END\n");
  EXPECT_EQ(run({"run", path("second.k"), "-o", path("again"), "-q"}).code, ExitCode::Normal);
  EXPECT_EQ(run({"run", deck, "-o", path("out"), "-q"}).code, ExitCode::Normal);
  EXPECT_FALSE(exists("out/dynain"));
}

TEST(Dynain, NumbersFillTheirColumns) {
  EXPECT_EQ(output::number_in_columns(0, 10), "         0");
  EXPECT_EQ(output::number_in_columns(-1.0 / 3, 10), "-0.3333333");
  EXPECT_EQ(output::number_in_columns(1e300 / 3, 10), "3.333e+299");
  EXPECT_EQ(output::number_in_columns(-2e-7 / 3, 12), "-6.66667e-08");
}

}  // namespace
}  // namespace crumple::app::dynain_test
