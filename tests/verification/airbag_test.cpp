// SPDX-License-Identifier: BSD-3-Clause
//
// Control volumes in motion, against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/bags.hpp"
#include "support/larger.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::airbag_test {
namespace {

using math::Vec3;

constexpr double exponent = 1.4;

/// Two rigid plates of side 1 a distance 2 apart, the first one held, the other one moving towards it, with a
/// box between them that is full of gas.
model::Model piston(const model::VolumeFilling& filling, double speed) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.1, 2));
  model.materials[0].density = 10;  // one plate has a mass of 1
  // Rigid plates set the step as if they were not: it stays below 1e-3, a stroke takes about 1.
  model.materials[0].law = model::Elastic{2e7, 0.3};
  model.parts.push_back({.id = 2, .title = "piston", .section = 0, .material = 0});
  const auto plate = [](double x) { return [x](double u, double v) { return test::Point{x, u, v}; }; };
  test::add_grid(model, 0, 1, 1, plate(0));
  test::add_grid(model, 1, 1, 1, plate(2));
  test::make_rigid(model, 0);
  test::make_rigid(model, 1);
  model.rigid_bodies[0].fixed_translation = {true, true, true};
  model.rigid_bodies[0].fixed_rotation = {true, true, true};
  for (Index node = 4; node < 8; ++node)
    model.initial_velocities.push_back({.node = node, .velocity = {-speed, 0, 0}});
  model::ControlVolume box;
  box.id = 3;
  // Nodes 0 to 3 and 4 to 7: (y, z) = (0, 0), (1, 0), (0, 1), (1, 1).
  box.segments = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
  box.filling = filling;
  model.control_volumes.push_back(box);
  return model;
}

/// Volume at which the kinetic energy of the piston is all in the gas, whose absolute pressure at time zero
/// is that around it: by bisection.
double smallest_volume(double kinetic, double ambient) {
  double low = 0.01;
  double high = 2;
  for (int i = 0; i < 100; ++i) {
    const double v = 0.5 * (low + high);
    const double taken =
        ambient * 2 / (exponent - 1) * (std::pow(2 / v, exponent - 1) - 1) - ambient * (2 - v);
    (taken > kinetic ? low : high) = v;
  }
  return low;
}

struct Stroke {
  double smallest = 1e30;
  double imbalance = 0;
  double gas_error = 0;  ///< of the work on the piston against the change of the gas's energy
};

Stroke stroke_of(const model::VolumeFilling& filling, double ambient) {
  model::Model model = piston(filling, 2);
  model.control.end_time = 3;
  timeloop::Simulation simulation(model, test::execution());
  Stroke stroke;
  double first = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    const domain::ControlVolumeReport& gas = now.control_volumes[0];
    if (now.clock.cycle == 0) first = gas.energy;
    stroke.smallest = std::fmin(stroke.smallest, gas.volume);
    stroke.imbalance = test::larger_of(stroke.imbalance, std::fabs(now.energy.imbalance()));
    // The gas does the work of the pressure above the ambient one, and that against the ambient one.
    const double work = now.energy.external_work + ambient * (gas.volume - 2);
    stroke.gas_error = test::larger_of(stroke.gas_error, std::fabs(work + gas.energy - first));
  });
  return stroke;
}

// A piston thrown against a gas spring: the smallest volume follows from the energies.
TEST(Airbags, PistonIsStoppedByAdiabaticGas) {
  const double ambient = 1;
  const double kinetic = 0.5 * 1 * 2 * 2;
  const double expected = smallest_volume(kinetic, ambient);
  const model::VolumeFilling adiabatic =
      model::AdiabaticGas{.exponent = exponent, .pressure = 0, .ambient = ambient, .density = 0.01};
  const model::VolumeFilling inflated = model::InflatedGas{
      .heat_at_volume = 1, .heat_at_pressure = exponent, .ambient = ambient, .density = 0.01};
  for (const model::VolumeFilling& filling : {adiabatic, inflated}) {
    const Stroke stroke = stroke_of(filling, ambient);
    // Times and work are of the second order in the step over the time of the stroke.
    test::verified("piston on gas: smallest volume", "kinetic energy equal to the work of p V^gamma")
        .within(stroke.smallest, expected, 1e-5);
    test::verified("piston on gas: energy balance over the kinetic energy, error", "none")
        .below(stroke.imbalance / kinetic, 1e-12);
    test::verified("piston on gas: work against the gas's energy, error", "first law")
        .below(stroke.gas_error / kinetic, 1e-5);
  }
}

// Oil behind a piston of a rigid body sets the step, though no element does: the piston comes back as fast as
// it came. omega^2 = gamma p A^2 / (V M).
TEST(Airbags, StiffGasBehindARigidPistonIsStable) {
  constexpr double pressure = 1e8;
  const double omega = std::sqrt(exponent * pressure / 2);
  model::Model model = piston(
      model::AdiabaticGas{.exponent = exponent, .pressure = 0, .ambient = pressure, .density = 0.01}, 2);
  model.control.end_time = 0.9 * std::numbers::pi / omega + 1e-9;
  timeloop::Simulation simulation(model, test::execution());
  double longest = 0;
  test::run(simulation, [&](const domain::Domain& now) { longest = std::fmax(longest, now.clock.step); });
  test::verified("stiff gas behind a rigid piston: step times omega", "2, the stable limit")
      .below(longest * omega, 2);
  test::verified("stiff gas behind a rigid piston: energy balance over the kinetic energy, error", "none")
      .below(std::fabs(simulation.domain().energy.imbalance()) / 2, 1e-3);
}

/// A ball of n x n shells for each face of a cube.
model::Model ball(int n, double radius, double thickness) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(thickness, 2));
  test::add_closed_box(model, 0, n, [&](double x, double y, double z) {
    const auto angle = [](double u) { return std::tan(0.25 * std::numbers::pi * u); };
    const double a = angle(x);
    const double b = angle(y);
    const double c = angle(z);
    const double size = radius / std::sqrt(a * a + b * b + c * c);
    return test::Point{size * a, size * b, size * c};
  });
  return model;
}

// Mean radius of an inflated ball at rest: p r^2 (1 - nu) / (2 E t). Flat segments of angle h have an error
// of the second order in h.
TEST(Airbags, BallIsInflatedAsAThinSphere) {
  const double radius = 100;
  const double thickness = 1;
  const double pressure = 0.01;
  double error[2] = {};
  for (const int fine : {0, 1}) {
    model::Model model = ball(fine == 0 ? 6 : 12, radius, thickness);
    model.control_volumes.push_back(
        test::bag_of_shells(model, model::PressureOfVolume{.coefficient = pressure, .curve = no_index}));
    // The period of breathing is 2 pi r sqrt(rho (1 - nu) / (2 E)): 0.072 ms, damped critically.
    const double omega = std::sqrt(2 * 210.0 / (7.85e-6 * 0.7)) / radius;
    model.mass_damping = model::MassDamping{.constant = 2 * omega};
    model.control.end_time = 15 / omega;
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    double growth = 0;
    const domain::NodeFields& nodes = simulation.domain().nodes;
    for (Index i = 0; i < nodes.count(); ++i) growth += norm(nodes.position[i]) - norm(nodes.reference[i]);
    growth /= nodes.count();
    const double expected = pressure * radius * radius * 0.7 / (2 * 210 * thickness);
    error[fine] = std::fabs(growth / expected - 1);
  }
  test::verified("inflated ball of 864 shells: growth of the radius, relative error", "thin sphere")
      .below(error[1], 0.01);
  EXPECT_LT(error[1], 0.5 * error[0]);
}

/// A soft ball full of gas that is thrown against a smooth wall and comes back.
model::Model thrown_ball(double step_scale) {
  model::Model model = ball(8, 100, 1);
  model.materials[0].law = model::Elastic{2.0, 0.4};
  model.control_volumes.push_back(test::bag_of_shells(
      model, model::AdiabaticGas{.exponent = exponent, .pressure = 2e-4, .ambient = 1e-4, .density = 1e-9}));
  model::RigidWall wall;
  wall.id = 1;
  wall.point = {0, 0, -101};
  wall.normal = {0, 0, 1};
  for (Index node = 0; node < model.nodes.count(); ++node) {
    model.initial_velocities.push_back({.node = node, .velocity = {1, 0, -20}});
    wall.nodes.push_back(node);
  }
  model.rigid_walls.push_back(wall);
  model.control.end_time = 25;
  model.control.step_scale = step_scale;
  return model;
}

// The step changes with the elements, so energy is kept to the square of the step.
TEST(Airbags, BallOnAWallKeepsItsEnergy) {
  double error[2] = {};
  for (const int fine : {0, 1}) {
    const model::Model model = thrown_ball(fine == 0 ? 0.8 : 0.4);
    timeloop::Simulation simulation(model, test::execution());
    double first = 0;
    double smallest = 1e30;
    Vec3 start;
    test::run(simulation, [&](const domain::Domain& now) {
      if (now.clock.cycle == 0) {
        start = test::momentum(now);
        first = now.control_volumes[0].volume;
      }
      smallest = std::fmin(smallest, now.control_volumes[0].volume);
      error[fine] = test::larger_of(error[fine], std::fabs(now.energy.imbalance()));
    });
    const domain::Domain& now = simulation.domain();
    error[fine] /= now.energy.initial_total;
    EXPECT_LT(smallest, 0.98 * first);
    const Vec3 change = test::momentum(now) - start;
    EXPECT_GT(change.z, -start.z);
    // The wall is smooth and the pressure inside has no resultant.
    test::verified("ball full of gas on a wall: change of momentum along it, relative", "none")
        .below(std::fabs(change.x / start.x), 1e-10);
  }
  test::verified("ball full of gas on a wall: energy error over the kinetic energy", "none")
      .below(error[1], 1e-3);
  EXPECT_GT(error[0] / error[1], 2.5);
}

}  // namespace
}  // namespace crumple::airbag_test
