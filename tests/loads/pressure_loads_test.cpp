// SPDX-License-Identifier: BSD-3-Clause
#include "loads/pressure_loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "domain/build.hpp"
#include "loads/nodal_loads.hpp"
#include "support/meshes.hpp"
#include "support/verified.hpp"

namespace crumple::pressure_loads_test {
namespace {

using math::Vec3;

/// A closed box of n x n squares a face, normals outwards, pushed out of shape so that nothing is flat.
model::Model closed_box(Index n) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.1, 2));
  const auto bulge = [](double x, double y, double z) {
    return test::Point{x + 0.1 * y * z, y + 0.2 * x * x, z - 0.1 * x * y};
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true})
      test::add_grid(model, 0, n, n, [&](double u, double v) {
        // u, v and the outward normal make a right-handed frame.
        const double a = upper ? u : v;
        const double b = upper ? v : u;
        const double c = upper ? 1 : 0;
        const double x[3] = {axis == 0   ? c
                             : axis == 1 ? b
                                         : a,
                             axis == 1   ? c
                             : axis == 2 ? b
                                         : a,
                             axis == 2   ? c
                             : axis == 0 ? b
                                         : a};
        return bulge(x[0], x[1], x[2]);
      });
  for (const model::ShellElement& shell : model.shells)
    model.pressure_loads.push_back({.node = shell.node, .pressure = -3, .curve = no_index, .arrival = 0});
  return model;
}

Vec3 sum_of_forces(const domain::Domain& domain) {
  Vec3 sum;
  for (Index i = 0; i < domain.nodes.count(); ++i) {
    const auto& f = domain.nodes.force[i].force;
    sum += Vec3{f[0], f[1], f[2]};
  }
  return sum;
}

/// Pressure inside a closed surface has no resultant, and its power is pressure times the growth of the
/// volume: for a velocity field v = x that is three times the volume.
TEST(PressureLoads, InsideAClosedSurfaceDoTheWorkOfItsVolume) {
  const model::Model model = closed_box(3);
  domain::Domain domain = domain::build(model, {});
  loads::PressureLoads loads(model, domain);
  double volume = 0;
  for (const model::ShellElement& shell : model.shells) {
    Vec3 x[4];
    for (int k = 0; k < 4; ++k) {
      const auto& p = model.nodes.position[shell.node[k]];
      x[k] = {p[0], p[1], p[2]};
    }
    // The divergence theorem with the same quadrature: centre times vector area.
    volume += dot(0.25 * (x[0] + x[1] + x[2] + x[3]), 0.5 * cross(x[2] - x[0], x[3] - x[1])) / 3;
  }
  EXPECT_NEAR(volume, 1, 0.1);
  domain.nodes.velocity = domain.nodes.position;
  loads.add_forces(domain);
  test::verified("pressure in a closed warped box: resultant", "none")
      .below(norm(sum_of_forces(domain)), 1e-13);
  domain.clock.step = 0.5;
  loads.add_forces(domain);
  // Half a step each of the forces before and after, which are the same.
  test::verified("pressure in a closed warped box: work", "pressure times growth of the volume")
      .near(domain.energy.external_work, 0.5 * 3 * 3 * volume, 1e-12);
}

TEST(PressureLoads, PushATriangleAgainstItsNormalWhenTheyHaveArrived) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.1, 2));
  test::add_grid(model, 0, 1, 1, [](double u, double v) { return test::Point{2 * u, 3 * v, 0}; });
  model::Curve curve;
  curve.abscissa = {0, 1};
  curve.ordinate = {1, 3};
  model.curves.push_back(curve);
  model.pressure_loads.push_back({.node = {0, 1, 3, 3}, .pressure = 2, .curve = 0, .arrival = 0.5});
  domain::Domain domain = domain::build(model, {});
  loads::PressureLoads loads(model, domain);
  domain.clock.time = 0.4;
  loads.add_forces(domain);
  EXPECT_EQ(norm(sum_of_forces(domain)), 0);
  domain.clock.time = 1;  // half a unit after arrival: the factor is 2
  loads.add_forces(domain);
  test::verified("pressure on a triangle after its arrival: resultant", "pressure times area")
      .near(sum_of_forces(domain).z, -2 * 2 * 3, 1e-14);
  for (const Index node : {0, 1, 3})
    EXPECT_NEAR(domain.nodes.force[domain.nodes.domain_node[node]].force[2], -4, 1e-14);
  EXPECT_EQ(domain.nodes.force[domain.nodes.domain_node[2]].force[2], 0);
}

TEST(PressureLoads, EndWithTheirShell) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.1, 2));
  test::add_grid(model, 0, 2, 1, [](double u, double v) { return test::Point{2 * u, v, 0}; });
  for (Index shell = 0; shell < 2; ++shell)
    model.pressure_loads.push_back(
        {.node = model.shells[shell].node, .pressure = 2, .curve = no_index, .arrival = 0, .shell = shell});
  domain::Domain domain = domain::build(model, {});
  domain::ShellBlock& block = domain.shells[0];
  const Index active = domain::add_item(block, "active", "-", 1);
  block.double_state.assign(lanes, 1.0);
  loads::PressureLoads loads(model, domain);
  loads.add_forces(domain);
  EXPECT_NEAR(sum_of_forces(domain).z, -4, 1e-14);
  const Index place = block.element[0] == 0 ? 0 : 1;
  block.set_state(place, active, 0);
  block.eroded = 1;
  for (domain::NodeForce& force : domain.nodes.force) force = {};
  loads.add_forces(domain);
  EXPECT_NEAR(sum_of_forces(domain).z, -2, 1e-14);
  EXPECT_EQ(domain.nodes.force[domain.nodes.domain_node[0]].force[2], 0);
}

TEST(NodalLoads, DoTheWorkOfForcesAndMoments) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.1, 2));
  test::add_grid(model, 0, 1, 1, [](double u, double v) { return test::Point{u, v, 0}; });
  model.nodal_loads.push_back({.node = 2, .force = {1, 2, 3}, .moment = {4, 5, 6}});
  domain::Domain domain = domain::build(model, {});
  loads::NodalLoads loads(model, domain);
  const Index node = domain.nodes.domain_node[2];
  domain.nodes.velocity[node] = {1, 0.5, 2};
  domain.nodes.angular_velocity[node] = {0.5, 1, 2};
  domain.clock.step = 0.1;
  loads.add_forces(domain);
  EXPECT_NEAR(domain.energy.external_work, 0.5 * 0.1 * (8 + 19), 1e-14);  // the force was zero before
  loads.add_forces(domain);
  test::verified("force and moment on a moving node: work", "power times time, trapezoid")
      .near(domain.energy.external_work, 1.5 * 0.1 * (8 + 19), 1e-14);
  EXPECT_EQ(domain.nodes.force[node].moment[1], 10);
}

}  // namespace
}  // namespace crumple::pressure_loads_test
