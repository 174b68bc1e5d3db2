// SPDX-License-Identifier: BSD-3-Clause
// Free plates in the blast of a kilogram of TNT: what momentum they get, by the impulses that the fits of
// Kingery and Bulmash (1984) give.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "loads/air_blast.hpp"
#include "loads/kingery_bulmash.hpp"
#include "support/imbalance.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::air_blast_plate_test {
namespace {

using math::Vec3;
using Burst = model::AirBlast::Burst;

constexpr double root_of_pounds = 1.301549583;        // of a kilogram
constexpr double distance = 2000;                     // mm
constexpr double area = 4e4;                          // mm^2
constexpr double gigapascals = 6.894757293168361e-6;  // of a psi

/// A kilogram of TNT in kg, mm, ms.
model::AirBlast kilogram(Burst burst) {
  model::AirBlast blast;
  blast.id = 1;
  blast.burst = burst;
  blast.mass = 1;
  blast.units = {.pounds = 1 / 0.45359237, .feet = 1 / 304.8, .milliseconds = 1, .psi = 1 / gigapascals};
  return blast;
}

loads::ScaledWave wave_at_plate(Burst burst) {
  return loads::scaled_wave(burst, distance / 304.8 / root_of_pounds);
}

/// A plate of one element around the origin, so heavy that it hardly moves, turned by an angle from the
/// charge along +z.
model::Model plate(Burst burst, double angle) {
  model::Material heavy = test::elastic_steel();
  heavy.density *= 1e4;
  model::Model model = test::one_part(heavy, test::shell_section(10, 2));
  test::add_grid(model, 0, 1, 1, [&](double u, double v) {
    const double along = 200 * u - 100;
    return test::Point{along * std::cos(angle), 200 * v - 100, along * std::sin(angle)};
  });
  model::AirBlast blast = kilogram(burst);
  blast.centre = {0, 0, distance};
  blast.negative_phase = false;
  model.air_blasts.push_back(blast);
  model.blast_segments.push_back({.blast = 0, .node = model.shells[0].node, .shell = 0});
  model.control.step_curve = test::add_constant_curve(model, 2e-4);
  model.control.end_time = 4.5;  // the positive phase ends before
  return model;
}

/// Runs a model and gives the momentum against the normal of the plate.
double momentum_of(const model::Model& model, double angle, double& imbalance) {
  timeloop::Simulation simulation(model, test::execution());
  test::ImbalanceAfterStart observed;
  test::run(simulation, [&](const domain::Domain& domain) { observed.observe(domain); });
  const domain::Domain& domain = simulation.domain();
  imbalance = observed.largest() / domain.energy.external_work;
  return -dot(test::momentum(domain), Vec3{-std::sin(angle), 0, std::cos(angle)});
}

// A step may be cut by the arrival: half a step of the peak pressure is 3e-4 of the impulse.
TEST(AirBlast, GivesAFreePlateTheImpulseOfTheFits) {
  for (const Burst burst : {Burst::Air, Burst::Surface}) {
    const std::string of = burst == Burst::Air ? "air burst" : "surface burst";
    const loads::ScaledWave wave = wave_at_plate(burst);
    for (const double degrees : {0.0, 40.0}) {
      const double angle = degrees * std::numbers::pi / 180;
      const double c = std::cos(angle);
      const double impulse = (wave.reflected_impulse * c * c + wave.incident_impulse * (1 + c * c - 2 * c)) *
                             root_of_pounds * gigapascals;
      double imbalance = 0;
      const double momentum = momentum_of(plate(burst, angle), angle, imbalance);
      test::verified(of + ", free plate at " + std::to_string(int(degrees)) + " degrees: momentum",
                     "impulses of Kingery and Bulmash 1984, mixed by the angle")
          .within(momentum, impulse * area, 5e-4);
      test::verified(of + ": imbalance over the work", "conservation").below(imbalance, 1e-10);
    }
  }
}

// The integral of Friedlander's pulse without end is p d (b - 1) / b^2.
TEST(AirBlast, TakesBackWhatTheNegativePhaseHas) {
  model::Model model = plate(Burst::Air, 0);
  model.air_blasts[0].negative_phase = true;
  model.control.end_time = 20;
  const loads::ScaledWave wave = wave_at_plate(Burst::Air);
  const double peak = wave.reflected_pressure * wave.duration;
  const double decay = loads::friedlander_decay(peak / wave.reflected_impulse);
  ASSERT_GT(decay, 2);
  double imbalance = 0;
  const double momentum = momentum_of(model, 0, imbalance);
  const double impulse = peak * (decay - 1) / (decay * decay) * root_of_pounds * gigapascals;
  // Ten times what the comparison below may be off.
  EXPECT_LT(impulse, 0.995 * wave.reflected_impulse * root_of_pounds * gigapascals);
  test::verified("air burst with negative phase, free plate: momentum", "Friedlander's pulse")
      .within(momentum, impulse * area, 5e-4);
}

// The charge rides on a node that falls until the detonation.
TEST(AirBlast, StartsWhereItsNodeHasArrived) {
  model::Model model = plate(Burst::Air, 0);
  const double speed = 500;
  const double detonation = 0.4;
  const Index first = test::add_grid(model, 0, 1, 1, [&](double u, double v) {
    return test::Point{10 * u, 10 * v, distance + speed * detonation};
  });
  for (Index node = first; node < first + 4; ++node)
    model.initial_velocities.push_back({.node = node, .velocity = {0, 0, -speed}});
  model.air_blasts[0].node = first;
  model.air_blasts[0].detonation = detonation;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  double momentum = 0;
  for (Index node = 0; node < 4; ++node) {
    const Index own = domain.nodes.domain_node[node];
    momentum -= domain.nodes.mass[own] * domain.nodes.velocity[own].z;
  }
  const double impulse = wave_at_plate(Burst::Air).reflected_impulse * root_of_pounds * gigapascals;
  test::verified("charge on a falling node: momentum of the plate", "impulse at the place of the detonation")
      .within(momentum, impulse * area, 5e-4);
}

}  // namespace
}  // namespace crumple::air_blast_plate_test
