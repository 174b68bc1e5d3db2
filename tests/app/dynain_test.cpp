// SPDX-License-Identifier: BSD-3-Clause
// A run to its half, written as dynain, read by a second deck and run on, against the run in one go; and what
// stays where it is when it begins with its stresses.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>

#include "app/program_fixture.hpp"
#include "deck/reader.hpp"
#include "domain/earlier_velocities.hpp"
#include "output/lsdyna/dynain.hpp"
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

constexpr const char* plastic_mat_24 =
    "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.85E-6,210,0.3,0.25,2.0\n\n\n\n";
constexpr const char* kinematic_mat_3 = "*MAT_PLASTIC_KINEMATIC\n1,7.85E-6,210,0.3,0.25,5.0,0.3\n\n";

/// Without what acts on hourglass modes alone and on the rate of the volume: hourglass stresses are not
/// written, and viscosities at the first moment have the velocity of another half step.
constexpr const char* no_viscosity =
    "*CONTROL_BULK_VISCOSITY\n1E-20,1E-20\n*CONTROL_HOURGLASS\n1,1E-20\n";

/// A block that is squeezed, sheared and yields.
Pieces squeezed_block(int elform, const std::string& material, bool tetrahedra) {
  Pieces pieces;
  pieces.properties = fmt::format("{}*SECTION_SOLID\n1,{}\n*PART\nblock\n1,1,1\n{}", no_viscosity, elform,
                                  material);
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
        velocities += fmt::format("{},{},{},{}\n", node(i, j, k), -0.8 * x, 0.2 * y + 0.3 * x, x * z / 120);
      }
  pieces.mesh += "*ELEMENT_SOLID\n";
  int id = 0;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        const int c[8] = {node(i, j, k),         node(i + 1, j, k),         node(i + 1, j + 1, k),
                          node(i, j + 1, k),     node(i, j, k + 1),         node(i + 1, j, k + 1),
                          node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
        if (!tetrahedra) {
          pieces.mesh += fmt::format("{},1,{},{},{},{},{},{},{},{}\n", ++id, c[0], c[1], c[2], c[3], c[4],
                                     c[5], c[6], c[7]);
          continue;
        }
        constexpr int paths[6][2] = {{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}};
        for (const auto& path : paths)
          pieces.mesh += fmt::format("{},1,{},{},{},{},{},{},{},{}\n", ++id, c[0], c[path[0]], c[path[1]], c[6],
                                     c[6], c[6], c[6], c[6]);
      }
  pieces.motion = velocities;
  return pieces;
}

/// A plate of 4 x 3 shells, tilted, that is bent, stretched and sheared, and yields.
Pieces bent_plate(int elform, const std::string& material) {
  Pieces pieces;
  pieces.properties = fmt::format(
      "{}*CONTROL_SHELL\n20,,,1\n*SECTION_SHELL\n1,{},,3\n1.5\n*PART\nplate\n1,1,1\n{}", no_viscosity, elform,
      material);
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
      const Vec3 velocity = 0.15 * u * along + 0.06 * u * across + 0.02 * (u - 10) * (u - 10) * normal;
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
  return model_of(
      "*KEYWORD\n" + termination(cycles) + pieces.properties + "*INCLUDE\ndynain\n*END\n",
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

/// Over all elements of two runs of the same mesh.
void compare_items(const domain::ElementBlock& a, const domain::ElementBlock& b, const char* name,
                   double& apart) {
  const domain::StateItem* const of_a = a.find(name);
  const domain::StateItem* const of_b = b.find(name);
  if (of_a == nullptr || of_b == nullptr) return;
  double largest = 0;
  double difference = 0;
  for (Index place = 0; place < a.elements; ++place) {
    Index other = 0;
    while (b.element[other] != a.element[place]) ++other;
    for (Index k = 0; k < of_a->count; ++k) {
      const double value = a.state(place, of_a->first + k);
      largest = test::larger_of(largest, std::fabs(value));
      difference = test::larger_of(difference, std::fabs(value - b.state(other, of_b->first + k)));
    }
  }
  apart = test::larger_of(apart, difference / largest);
}

Apart apart(const domain::Domain& a, const domain::Domain& b) {
  Apart result;
  double largest = 0;
  for (Index i = 0; i < a.nodes.count(); ++i) {
    const Index at_a = a.nodes.domain_node[static_cast<std::size_t>(i)];
    const Index at_b = b.nodes.domain_node[static_cast<std::size_t>(i)];
    largest = test::larger_of(largest, norm(a.nodes.position[at_a] - a.nodes.reference[at_a]));
    result.displacement =
        test::larger_of(result.displacement, norm(a.nodes.position[at_a] - b.nodes.position[at_b]));
  }
  result.displacement /= largest;
  const auto blocks_a = a.blocks();
  const auto blocks_b = b.blocks();
  for (std::size_t k = 0; k < blocks_a.size(); ++k) {
    compare_items(*blocks_a[k], *blocks_b[k], "stress", result.stress);
    compare_items(*blocks_a[k], *blocks_b[k], "plastic_strain", result.plastic);
  }
  return result;
}

/// Gives the nodes of one run the masses of another.
void take_masses(const domain::Domain& from, domain::Domain& to) {
  for (Index i = 0; i < from.nodes.count(); ++i) {
    const Index source = from.nodes.domain_node[static_cast<std::size_t>(i)];
    const Index target = to.nodes.domain_node[static_cast<std::size_t>(i)];
    to.nodes.mass[target] = from.nodes.mass[source];
    to.nodes.inertia[target] = from.nodes.inertia[source];
  }
}

Apart continued(const Pieces& pieces, long half, bool same_masses) {
  const model::Model whole = first_model(pieces, 2 * half);
  timeloop::Simulation one_go(whole, test::execution());
  test::run(one_go);
  const model::Model first = first_model(pieces, half);
  timeloop::Simulation stopped(first, test::execution());
  const output::Dynain dynain = run_to_dynain(stopped, all_with_velocities());
  EXPECT_TRUE(dynain.notes.empty());
  const model::Model second = second_model(pieces, half, dynain.text);
  timeloop::Simulation again(second, test::execution());
  if (same_masses) take_masses(stopped.domain(), again.domain());
  test::run(again);
  const Apart result = apart(one_go.domain(), again.domain());
  double most = 0;
  for (const auto* block : one_go.domain().blocks())
    for (Index place = 0; place < block->elements; ++place)
      most = test::larger_of(most, block->state(place, block->find("plastic_strain")->first));
  EXPECT_GT(most, 0.002) << "it has to yield";
  std::printf("u %.3g s %.3g p %.3g, plastic strain %.3g time %.4g\n", result.displacement, result.stress,
              result.plastic, most, one_go.domain().clock.time);
  return result;
}

TEST(Dynain, SolidsGoOnAsInOneGo) {
  for (const auto& [name, material] : {std::pair{"*MAT_024", plastic_mat_24}, std::pair{"*MAT_003", kinematic_mat_3}})
    for (const int elform : {1, 2, 10}) {
      std::printf("%s %d\n", name, elform);
      const Apart result = continued(squeezed_block(elform, material, elform == 10), 40, false);
      (void)result;
    }
}

TEST(Dynain, ShellsGoOnAsInOneGo) {
  for (const auto& [name, material] : {std::pair{"*MAT_024", plastic_mat_24}, std::pair{"*MAT_003", kinematic_mat_3}})
    for (const int elform : {2, 10, 16}) {
      for (const bool same : {true, false}) {
        std::printf("%s %d %d\n", name, elform, same);
        const Apart result = continued(bent_plate(elform, material), 40, same);
        (void)result;
      }
    }
}

}  // namespace
}  // namespace crumple::app::dynain_test
