// SPDX-License-Identifier: BSD-3-Clause
// A run to its half, written as dynain, read by a second deck and run on, against the run in one go; and what
// stays where it is when it begins with its stresses.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "app/program_fixture.hpp"
#include "deck/reader.hpp"
#include "domain/earlier_velocities.hpp"
#include "output/lsdyna/dynain.hpp"
#include "output/results/point_results.hpp"
#include "output/results/shell_axes.hpp"
#include "support/larger.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::app::dynain_test {
namespace {

using math::Vec3;

/// A deck in the parts that a second run replaces: the mesh, and what acts.
struct Pieces {
  std::string properties;  ///< of both runs
  std::string mesh;
  std::string motion;  ///< of the first run alone
};

constexpr const char* plastic_mat_24 = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.85E-6,210,0.3,0.25,2.0\n\n\n\n";
constexpr const char* kinematic_mat_3 = "*MAT_PLASTIC_KINEMATIC\n1,7.85E-6,210,0.3,0.25,5.0,0.3\n\n";

/// Without what acts on hourglass modes alone and on the rate of the volume: hourglass stresses are not
/// written, and viscosities at the first moment have the velocity of another half step.
constexpr const char* no_viscosity = "*CONTROL_BULK_VISCOSITY\n1E-20,1E-20\n*CONTROL_HOURGLASS\n1,1E-20\n";

/// A block that is squeezed, sheared and yields.
Pieces squeezed_block(int elform, const std::string& material, bool tetrahedra) {
  Pieces pieces;
  pieces.properties =
      fmt::format("{}*SECTION_SOLID\n1,{}\n*PART\nblock\n1,1,1\n{}", no_viscosity, elform, material);
  pieces.mesh = "*NODE\n";
  constexpr int n[3] = {3, 2, 2};
  const auto node = [&](int i, int j, int k) { return 1 + i + (n[0] + 1) * (j + (n[1] + 1) * k); };
  std::string velocities = "*INITIAL_VELOCITY_NODE\n";
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        const double x = 10.0 * i;
        const double y = 10.0 * j + i * k / 3.0;
        const double z = 10.0 * k;
        pieces.mesh += fmt::format("{},{},{},{}\n", node(i, j, k), x, y, z);
        velocities += fmt::format("{},{},{},{}\n", node(i, j, k), -1.2 * x, 0.3 * y + 0.4 * x, x * z / 100);
      }
  pieces.mesh += "*ELEMENT_SOLID\n";
  int id = 0;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        const int c[8] = {
            node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
        if (!tetrahedra) {
          pieces.mesh += fmt::format("{},1,{},{},{},{},{},{},{},{}\n", ++id, c[0], c[1], c[2], c[3], c[4],
                                     c[5], c[6], c[7]);
          continue;
        }
        constexpr int paths[6][2] = {{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}};
        for (const auto& path : paths)
          pieces.mesh += fmt::format("{},1,{},{},{},{},{},{},{},{}\n", ++id, c[0], c[path[0]], c[path[1]],
                                     c[6], c[6], c[6], c[6], c[6]);
      }
  pieces.motion = velocities;
  return pieces;
}

struct Motion {
  double stretching = 0;  ///< rates [1/time]
  double shearing = 0;
  double bending = 0;  ///< [1/(length time)]
};

/// A plate of 4 x 3 shells, tilted, that is bent, stretched and sheared, and yields.
Pieces bent_plate(int elform, const std::string& material, const Motion& motion) {
  Pieces pieces;
  pieces.properties =
      fmt::format("{}*CONTROL_SHELL\n20,,,1\n*SECTION_SHELL\n1,{},,3\n1.5\n*PART\nplate\n1,1,1\n{}",
                  no_viscosity, elform, material);
  pieces.mesh = "*NODE\n";
  std::string velocities = "*INITIAL_VELOCITY_NODE\n";
  constexpr int columns = 4;
  constexpr int rows = 3;
  const auto node = [&](int i, int j) { return 1 + i + (columns + 1) * j; };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double u = 5.0 * i + 0.4 * (j % 2);
      const double v = 5.0 * j + 0.3 * (i % 2);
      // In a plane that is none of the global ones.
      const Vec3 along = math::normalised({1, 0.4, 0.2});
      const Vec3 normal = math::normalised(cross(along, {-0.3, 1, 0.5}));
      const Vec3 across = cross(normal, along);
      const Vec3 x = u * along + v * across;
      const Vec3 velocity = motion.stretching * u * along + motion.shearing * u * across +
                            motion.bending * (u - 10) * (u - 10) * normal;
      pieces.mesh += fmt::format("{},{},{},{}\n", node(i, j), x.x, x.y, x.z);
      velocities += fmt::format("{},{},{},{}\n", node(i, j), velocity.x, velocity.y, velocity.z);
    }
  pieces.mesh += "*ELEMENT_SHELL\n";
  int id = 0;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      pieces.mesh += fmt::format("{},1,{},{},{},{}\n", ++id, node(i, j), node(i + 1, j), node(i + 1, j + 1),
                                 node(i, j + 1));
  pieces.motion = velocities;
  return pieces;
}

model::Model model_of(const std::string& text, const std::map<std::string, std::string>& files = {}) {
  const deck::ReadResult result = deck::read_deck_text(text, {}, files);
  for (const deck::Diagnostic& diagnostic : result.diagnostics)
    EXPECT_EQ(diagnostic.severity, deck::Severity::Note) << to_string(diagnostic);
  EXPECT_TRUE(result.model.has_value()) << text;
  return result.model.value_or(model::Model{});
}

std::string termination(long cycles) {
  return fmt::format("*CONTROL_TERMINATION\n1000,{}\n", cycles);
}

model::Model first_model(const Pieces& pieces, long cycles) {
  return model_of("*KEYWORD\n" + termination(cycles) + pieces.properties + pieces.mesh + pieces.motion +
                  "*END\n");
}

model::Model second_model(const Pieces& pieces, long cycles, const std::string& dynain) {
  return model_of("*KEYWORD\n" + termination(cycles) + pieces.properties + "*INCLUDE\ndynain\n*END\n",
                  {{"dynain", dynain}});
}

/// Runs to the end; what the dynain file holds then.
output::Dynain run_to_dynain(timeloop::Simulation& simulation, const output::DynainRequest& request) {
  domain::EarlierVelocities earlier;
  earlier.keep(simulation.domain().nodes);
  simulation.start();
  while (!simulation.finished()) {
    earlier.keep(simulation.domain().nodes);
    simulation.step();
  }
  output::View view{simulation.model(), simulation.domain(), simulation.next_step()};
  view.earlier_velocity = earlier.velocity;
  view.earlier_angular_velocity = earlier.angular_velocity;
  return output::dynain_of(view, request);
}

constexpr auto all_with_velocities = [] {
  output::DynainRequest request;
  request.all = request.velocities = true;
  return request;
};

/// Largest differences, each over the largest value.
struct Apart {
  double displacement = 0;
  double stress = 0;
  double plastic = 0;
};

/// Of all elements in the order of the model: stresses in global axes, or plastic strains, of all points.
template <class Take>
std::vector<double> listed(const domain::Domain& domain, std::size_t elements, const Take& take) {
  std::vector<std::vector<double>> by_element(elements);
  const auto look = [&](const auto& blocks) {
    for (const auto& block : blocks)
      for (Index place = 0; place < block.elements; ++place)
        for (Index point = 0; point < block.points; ++point)
          for (const double number : take(block, place, point))
            by_element[static_cast<std::size_t>(block.element[place])].push_back(number);
  };
  look(domain.shells);
  look(domain.solids);
  std::vector<double> all;
  for (const auto& numbers : by_element) all.insert(all.end(), numbers.begin(), numbers.end());
  return all;
}

std::vector<double> stresses(const domain::Domain& domain, std::size_t elements) {
  return listed(domain, elements, [&](const auto& block, Index place, Index point) {
    if constexpr (std::is_same_v<decltype(block), const domain::ShellBlock&>)
      return output::in_global_axes(output::shell_axes(block, domain.nodes, place),
                                    output::stress_of<5>(block, place, point));
    else
      return output::stress_of<6>(block, place, point);
  });
}

std::vector<double> plastic_strains(const domain::Domain& domain, std::size_t elements) {
  return listed(domain, elements, [](const auto& block, Index place, Index point) {
    return std::array<double, 1>{output::plastic_strain_of(block, place, point)};
  });
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = test::larger_of(largest, std::fabs(value));
  return largest;
}

double relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference = test::larger_of(difference, std::fabs(a[i] - b[i]));
  return difference / largest_of(a);
}

Apart apart(const timeloop::Simulation& one, const timeloop::Simulation& other) {
  const domain::Domain& a = one.domain();
  const domain::Domain& b = other.domain();
  std::vector<double> moved;
  std::vector<double> moved_too;
  for (Index i = 0; i < a.nodes.count(); ++i) {
    const Index at_a = a.nodes.domain_node[static_cast<std::size_t>(i)];
    const Index at_b = b.nodes.domain_node[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < 3; ++axis) {
      moved.push_back(a.nodes.position[at_a][axis] - a.nodes.reference[at_a][axis]);
      moved_too.push_back(b.nodes.position[at_b][axis] - a.nodes.reference[at_a][axis]);
    }
  }
  const std::size_t elements = one.model().shells.size() + one.model().solids.size();
  return {relative_difference(moved, moved_too),
          relative_difference(stresses(a, elements), stresses(b, elements)),
          relative_difference(plastic_strains(a, elements), plastic_strains(b, elements))};
}

/// Gives one run what the file does not hold of another: masses and hourglass stresses (of ELFORM 16 those
/// that resist drilling).
void take_unwritten(const domain::Domain& from, domain::Domain& to) {
  for (Index i = 0; i < from.nodes.count(); ++i) {
    const Index source = from.nodes.domain_node[static_cast<std::size_t>(i)];
    const Index target = to.nodes.domain_node[static_cast<std::size_t>(i)];
    to.nodes.mass[target] = from.nodes.mass[source];
    to.nodes.inertia[target] = from.nodes.inertia[source];
  }
  for (std::size_t b = 0; b < from.shells.size(); ++b) {
    const domain::ShellBlock& source = from.shells[b];
    domain::ShellBlock& target = to.shells[b];
    for (Index place = 0; place < source.elements; ++place) {
      Index other = 0;
      while (source.element[other] != target.element[place]) ++other;
      for (Index k = 0; k < 5; ++k)
        target.set_state(place, target.find("hourglass")->first + k,
                         source.state(other, source.find("hourglass")->first + k));
    }
  }
}

Apart continued(const Pieces& pieces, long half, bool with_unwritten) {
  const model::Model whole = first_model(pieces, 2 * half);
  timeloop::Simulation one_go(whole, test::execution());
  test::run(one_go);
  const model::Model first = first_model(pieces, half);
  timeloop::Simulation stopped(first, test::execution());
  const output::Dynain dynain = run_to_dynain(stopped, all_with_velocities());
  EXPECT_TRUE(dynain.notes.empty());
  const model::Model second = second_model(pieces, half, dynain.text);
  timeloop::Simulation again(second, test::execution());
  if (with_unwritten) take_unwritten(stopped.domain(), again.domain());
  test::run(again);
  const Apart result = apart(one_go, again);
  const double most = largest_of(plastic_strains(one_go.domain(), whole.shells.size() + whole.solids.size()));
  EXPECT_GT(most, 0.002) << "it has to yield";
  return result;
}

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
