// SPDX-License-Identifier: BSD-3-Clause
// A cube that lands on its edge, right above a line of nodes, without friction: nothing may throw it
// sideways.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/shapes.hpp"
#include "support/verified.hpp"

namespace crumple::edge_on_mesh_line_test {
namespace {

struct Leaving {
  double sideways = 0;  ///< [mm/ms]
  double upwards = 0;
};

/// A block of steel of 60 x 60 x 15 with nodes every 10, and a cube that stands on its edge over the nodes of
/// x = 0, `shift` along the edge and `beside` across it [mm].
Leaving leaving_of(double shift, double speed, double beside = 0) {
  const double root = std::sqrt(0.5);
  model::Model model =
      test::one_solid_part({.id = 1, .title = "steel", .density = 7.85e-6, .law = model::Elastic{210, 0.3}});
  model.parts.push_back({.id = 2, .title = "cube", .solid_section = 0, .material = 0});
  test::add_box(model, 0, 6, 6, 2, [](double u, double v, double w) {
    return test::Point{60 * u - 30, 60 * v - 30, 15 * w - 15};
  });
  const Index cube = model.nodes.count();
  test::add_box(model, 1, 4, 4, 4, [&](double u, double v, double w) {
    return test::Point{beside + 20 * root * (u - w), 24 * v - 12 + shift, 0.02 + 20 * root * (u + w)};
  });
  for (Index i = cube; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i, .velocity = {0, 0, -speed}, .angular_velocity = {}});
  test::touch_all(model);
  model.control.end_time = 0.2;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::NodeFields& nodes = simulation.domain().nodes;
  Leaving found;
  double mass = 0;
  for (Index i = cube; i < model.nodes.count(); ++i) {
    const Index node = nodes.domain_node[i];
    mass += nodes.mass[node];
    found.sideways += nodes.mass[node] * nodes.velocity[node].x;
    found.upwards += nodes.mass[node] * nodes.velocity[node].z;
  }
  return {std::fabs(found.sideways) / mass, found.upwards / mass};
}

TEST(EdgeOnMeshLine, ThrowsNothingSideways) {
  for (const double shift : {0.0, 2.3}) {
    const Leaving found = leaving_of(shift, 50);
    std::printf("shift %.1f: leaves at %.3f sideways, %.2f upwards\n", shift, found.sideways, found.upwards);
    test::verified("cube on its edge over a line of nodes: speed sideways over that upwards", "symmetry")
        .below(found.sideways / found.upwards, 0.01);
    EXPECT_GT(found.upwards, 25);
  }
  // Stated in docs/theory/contact.md, "Limits".
  for (const double beside : {0.01, 0.1, 1.0}) {
    const Leaving found = leaving_of(0, 50, beside);
    std::printf("%.2f beside the line: leaves at %.3f sideways, %.2f upwards\n", beside, found.sideways,
                found.upwards);
  }
}

}  // namespace
}  // namespace crumple::edge_on_mesh_line_test
