// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Decks whose runs go on from a dynain file, and how far apart two runs of a mesh are.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "deck/reader.hpp"
#include "domain/earlier_velocities.hpp"
#include "output/lsdyna/dynain.hpp"
#include "output/results/point_results.hpp"
#include "output/results/shell_axes.hpp"
#include "support/larger.hpp"
#include "support/run.hpp"

namespace crumple::app::dynain_test {

using math::Vec3;

/// A deck in the parts that a second run replaces: the mesh, and what acts.
struct Pieces {
  std::string properties;  ///< of both runs
  std::string mesh;
  std::string motion;  ///< of the first run alone
};

inline constexpr const char* plastic_mat_24 =
    "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.85E-6,210,0.3,0.25,2.0\n\n\n\n";
inline constexpr const char* kinematic_mat_3 = "*MAT_PLASTIC_KINEMATIC\n1,7.85E-6,210,0.3,0.25,5.0,0.3\n\n";

/// Without what acts on hourglass modes alone and on the rate of the volume: hourglass stresses are not
/// written, and viscosities at the first moment have the velocity of another half step. The step is a given
/// one: its own goes by what it was before.
inline constexpr const char* no_viscosity =
    "*CONTROL_BULK_VISCOSITY\n1E-20,1E-20\n*CONTROL_HOURGLASS\n1,1E-20\n"
    "*CONTROL_TIMESTEP\n0,0.9,0,0,0,99\n*DEFINE_CURVE\n99\n0,5E-4\n1000,5E-4\n";

/// A block that is squeezed, sheared and yields.
inline Pieces squeezed_block(int elform, const std::string& material, bool tetrahedra) {
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
inline Pieces bent_plate(int elform, const std::string& material, const Motion& motion) {
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

inline model::Model model_of(const std::string& text, const std::map<std::string, std::string>& files = {}) {
  const deck::ReadResult result = deck::read_deck_text(text, {}, files);
  for (const deck::Diagnostic& diagnostic : result.diagnostics)
    EXPECT_EQ(diagnostic.severity, deck::Severity::Note) << to_string(diagnostic);
  EXPECT_TRUE(result.model.has_value()) << text;
  return result.model.value_or(model::Model{});
}

inline std::string termination(long cycles) {
  return fmt::format("*CONTROL_TERMINATION\n1000,{}\n", cycles);
}

inline model::Model first_model(const Pieces& pieces, long cycles) {
  return model_of("*KEYWORD\n" + termination(cycles) + pieces.properties + pieces.mesh + pieces.motion +
                  "*END\n");
}

inline model::Model second_model(const Pieces& pieces, long cycles, const std::string& dynain) {
  return model_of("*KEYWORD\n" + termination(cycles) + pieces.properties + "*INCLUDE\ndynain\n*END\n",
                  {{"dynain", dynain}});
}

/// Runs to the end; what the dynain file holds then.
inline output::Dynain run_to_dynain(timeloop::Simulation& simulation, const output::DynainRequest& request) {
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

inline constexpr auto all_with_velocities = [] {
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
inline std::vector<double> listed(const domain::Domain& domain, std::size_t elements, const Take& take) {
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

inline std::vector<double> stresses(const domain::Domain& domain, std::size_t elements) {
  return listed(domain, elements, [&](const auto& block, Index place, Index point) {
    if constexpr (std::is_same_v<decltype(block), const domain::ShellBlock&>)
      return output::in_global_axes(output::shell_axes(block, domain.nodes, place),
                                    output::stress_of<5>(block, place, point));
    else
      return output::stress_of<6>(block, place, point);
  });
}

inline std::vector<double> plastic_strains(const domain::Domain& domain, std::size_t elements) {
  return listed(domain, elements, [](const auto& block, Index place, Index point) {
    return std::array<double, 1>{output::plastic_strain_of(block, place, point)};
  });
}

inline double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = test::larger_of(largest, std::fabs(value));
  return largest;
}

inline double relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference = test::larger_of(difference, std::fabs(a[i] - b[i]));
  return difference / largest_of(a);
}

inline Apart apart(const timeloop::Simulation& one, const timeloop::Simulation& other) {
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
inline void take_unwritten(const domain::Domain& from, domain::Domain& to) {
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

inline Apart continued(const Pieces& pieces, long half, bool with_unwritten) {
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
  EXPECT_GT(most, 0.001) << "it has to yield";
  return result;
}

}  // namespace crumple::app::dynain_test
