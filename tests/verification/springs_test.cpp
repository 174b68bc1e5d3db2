// SPDX-License-Identifier: BSD-3-Clause
//
// Springs and dampers between masses, against the solutions of one degree of freedom. Central differences
// make a linear oscillator of the frequency omega swing with 2/dt asin(omega dt/2): the closed forms are
// compared at small steps.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/rigid.hpp"
#include "support/verified.hpp"

namespace crumple::springs_test {
namespace {

constexpr double pi = std::numbers::pi;

/// A mass at the origin and, against x from it, the fixed end of a grounded element: it lengthens as the mass
/// moves along x.
model::Model held_mass(const model::SpringLaw& law, double mass, double speed) {
  model::Model model = test::one_spring_part(law);
  const Index node = test::add_mass(model, {0, 0, 0}, mass);
  model.discretes.push_back({.id = 1, .part = 0, .node = {node, node}, .grounded = true, .axis = {-1, 0, 0}});
  model.initial_velocities.push_back({.node = node, .velocity = {speed, 0, 0}});
  return model;
}

struct Peak {
  double value = 0;
  double time = 0;
};

/// The largest displacement of node 0 along x, the parabola through the three highest points.
Peak peak_of(model::Model& model) {
  timeloop::Simulation simulation(model, test::execution());
  Peak best;
  double x[3] = {};
  double t[3] = {};
  test::run(simulation, [&](const domain::Domain& domain) {
    x[0] = x[1];
    x[1] = x[2];
    x[2] = test::displacement(domain, 0).x;
    t[0] = t[1];
    t[1] = t[2];
    t[2] = domain.clock.time;
    if (domain.clock.cycle < 2 || !(x[1] > best.value) || x[1] < x[0] || x[1] < x[2]) return;
    const double curve = x[0] - 2 * x[1] + x[2];
    const double shift = 0.5 * (x[0] - x[2]) / curve;
    best = {x[1] - 0.25 * (x[0] - x[2]) * shift, t[1] + shift * (t[2] - t[1])};
  });
  return best;
}

TEST(Springs, OscillatorKeepsPeriodAmplitudeAndEnergy) {
  constexpr double k = 4.0;
  constexpr double m = 0.25;  // omega = 4
  model::Model model = held_mass(model::LinearSpring{k}, m, 2.0);
  model.control.step_scale = 0.02;
  model.control.end_time = 10.25 * 2 * pi / 4;
  timeloop::Simulation simulation(model, test::execution());
  double last_crossing = 0;
  double before = 0;
  double time_before = 0;
  double imbalance = 0;
  int crossings = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double x = test::displacement(domain, 0).x;
    if (before < 0 && x >= 0) {
      last_crossing = time_before + (domain.clock.time - time_before) * before / (before - x);
      ++crossings;
    }
    before = x;
    time_before = domain.clock.time;
    imbalance = test::larger_of(imbalance, std::fabs(domain.energy.imbalance()));
  });
  ASSERT_EQ(crossings, 10);
  const double dt = simulation.domain().clock.step;
  const double discrete = 2 / dt * std::asin(0.5 * 4 * dt);
  test::verified("oscillator, ten periods: time", "exact").near(last_crossing, 10 * 2 * pi / 4, 1e-3);
  EXPECT_NEAR(last_crossing, 10 * 2 * pi / discrete, 3e-5);
  EXPECT_NEAR(before, 0.5, 1e-3);  // a quarter of a period behind the last crossing: the peak
  EXPECT_LT(imbalance, 1e-4 * 0.5 * m * 4);
}

TEST(Springs, StepIsThatOfHalfTheMass) {
  model::Model model = held_mass(model::LinearSpring{4.0}, 0.25, 2.0);
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  EXPECT_NEAR(simulation.next_step(), 0.9 * 2 * std::sqrt(0.125 / 4), 1e-12);
}

TEST(Springs, MassesOnAnObliqueSpringSwingAboutTheirCentre) {
  constexpr double k = 3.0;
  constexpr double m1 = 1.0;
  constexpr double m2 = 2.0;
  model::Model model = test::one_spring_part(model::LinearSpring{k});
  const double a = 1 / std::sqrt(3.0);
  test::add_mass(model, {1, 2, 3}, m1);
  test::add_mass(model, {1 + a, 2 + a, 3 + a}, m2);
  model.discretes.push_back({.id = 1, .part = 0, .node = {0, 1}});
  constexpr double v = 0.1;
  model.initial_velocities.push_back({.node = 0, .velocity = {-v * a, -v * a, -v * a}});
  const double omega = std::sqrt(k * (m1 + m2) / (m1 * m2));
  model.control.step_scale = 0.02;
  model.control.end_time = 0.5 * pi / omega;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const math::Vec3 span =
      domain.nodes.position[domain.nodes.domain_node[1]] - domain.nodes.position[domain.nodes.domain_node[0]];
  EXPECT_NEAR(math::norm(span), 1 + v / omega, 1e-4 * v / omega);
  EXPECT_NEAR(math::norm(test::momentum(domain)), m1 * v, 1e-12);
  EXPECT_NEAR(domain.discretes[0].state(0, domain.discretes[0].find("force")->first), k * v / omega,
              1e-4 * k * v / omega);
}

TEST(Springs, DamperStopsTheMassByItsExponential) {
  constexpr double c = 2.0;
  constexpr double m = 1.0;
  model::Model model = held_mass(model::LinearDamper{c}, m, 3.0);
  model.control.step_scale = 0.002;
  model.control.end_time = 1.0;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double decay = std::exp(-c / m * domain.clock.time);
  test::verified("damper stops a mass: path", "exact")
      .near(test::displacement(domain, 0).x, 3.0 * m / c * (1 - decay), 2e-3);
  EXPECT_NEAR(domain.energy.internal, 0.5 * m * 9 * (1 - decay * decay), 5e-3 * 4.5);
  EXPECT_LT(domain.energy.error(), 1e-3);
}

TEST(Springs, CurvesOfADamperActBothWays) {
  model::Model model = held_mass(model::NonlinearDamper{0}, 1.0, 3.0);
  // Twice the slope beyond the rate 1: force 2 rate - 1 there.
  model.curves.push_back({1, {-2, -1, 0, 1, 2}, {-3, -1, 0, 1, 3}});
  model.control.step_scale = 0.002;
  model.control.end_time = 0.4;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  // v' = -(2 v - 1), v(0) = 3: v = 1/2 + 5/2 exp(-2 t), above 1 until t = 0.80.
  const double time = simulation.domain().clock.time;
  EXPECT_NEAR(test::displacement(simulation.domain(), 0).x, 0.5 * time + 1.25 * (1 - std::exp(-2 * time)),
              2e-3);
}

TEST(Springs, ElastoplasticSpringStopsWhereItsWorkIsTheKineticEnergy) {
  const model::ElastoplasticSpring law{100.0, 10.0, 5.0};
  model::Model model = held_mass(law, 1.0, 4.0);
  model.control.step_scale = 0.02;
  model.control.end_time = 1.0;
  const double yield = law.yield_force / law.stiffness;
  // FY^2 / 2K + FY p + KT p^2 / 2 = m v^2 / 2
  const double energy = 8.0 - 0.5 * law.yield_force * yield;
  const double beyond =
      (-law.yield_force + std::sqrt(law.yield_force * law.yield_force + 2 * law.tangent_stiffness * energy)) /
      law.tangent_stiffness;
  const Peak peak = peak_of(model);
  test::verified("elastoplastic spring: peak", "exact").within(peak.value, yield + beyond, 2e-4);
}

TEST(Springs, NonlinearSpringStopsWhereItsIntegralSays) {
  model::Model model = held_mass(model::NonlinearSpring{0}, 1.0, 4.0);
  model.curves.push_back({1, {-1, 0, 0.5, 1}, {-20, 0, 2, 22}});
  model.control.step_scale = 0.02;
  model.control.end_time = 1.0;
  // Energy 8: work up to 0.5 is 0.5, up to 1 it is 6.5; beyond with the last slope of 40.
  const double rest = 1.5;
  const double exact = 1 + (-22 + std::sqrt(22 * 22 + 2 * 40 * rest)) / 40;
  const auto work = [&](double x) {
    const double a = std::min(x, 0.5);
    const double b = std::max(0.0, x - 0.5);
    return 2 * a * a + 2 * b + 20 * b * b;
  };
  // Time to the peak: integral of dx / v with x = exact sin(q).
  double time = 0;
  constexpr int points = 4000;
  for (int i = 0; i < points; ++i) {
    const double q = (i + 0.5) * pi / 2 / points;
    const double speed = std::sqrt(2 * (8 - work(exact * std::sin(q))));
    time += exact * std::cos(q) / speed * pi / 2 / points;
  }
  const Peak peak = peak_of(model);
  test::verified("nonlinear spring: peak over exact", "its integrals").near(peak.value / exact, 1, 2e-4);
  test::verified("nonlinear spring: time to the peak over exact", "its integrals")
      .near(peak.time / time, 1, 1e-3);
}

/// A node that moves at a constant speed until a time and then stands still.
model::Model pulled(const model::SpringLaw& law, double speed, double until) {
  model::Model model = held_mass(law, 1.0, 0.0);
  model.initial_velocities.clear();
  const auto curve = static_cast<Index>(model.curves.size());
  model.curves.push_back({9, {0, until, 1e3}, {0, speed * until, speed * until}});
  model.prescribed_motions.push_back(
      {.node = 0, .axis = 0, .kind = model::PrescribedMotion::Kind::Displacement, .curve = curve});
  model.control.step_scale = 0.001;
  return model;
}

double spring_force(const domain::Domain& domain) {
  return domain.discretes[0].state(0, domain.discretes[0].find("force")->first);
}

TEST(Springs, MaxwellSpringRelaxesByItsExponential) {
  constexpr double k0 = 5.0;
  constexpr double ki = 2.0;
  constexpr double beta = 3.0;
  constexpr double speed = 2.0;
  constexpr double until = 0.4;
  model::Model model =
      pulled(model::MaxwellSpring{.stiffness = k0, .final_stiffness = ki, .decay = beta}, speed, until);
  model.control.end_time = 1.5;
  timeloop::Simulation simulation(model, test::execution());
  double worst = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double t = domain.clock.time;
    const double pull = std::min(t, until);
    // The integral of K(t - s) v over the pull, K = KI + (K0 - KI) exp(-beta s).
    const double exact =
        ki * speed * pull + (k0 - ki) * speed / beta * (std::exp(-beta * (t - pull)) - std::exp(-beta * t));
    worst = test::larger_of(worst, std::fabs(spring_force(domain) - exact));
  });
  test::verified("Maxwell spring pulled, then held: force, error over K0 times the pull", "its exponentials")
      .below(worst / (k0 * speed * until), simulation.domain().clock.step / until);
  // All but what the lasting spring holds is gone in the end but exp(-3.3).
  EXPECT_LT(spring_force(simulation.domain()), ki * speed * until + 0.05 * (k0 - ki));
}

TEST(Springs, MaxwellSpringWithoutDecayIsElasticAndEndsAtItsTime) {
  model::Model model =
      pulled(model::MaxwellSpring{.stiffness = 4, .final_stiffness = 1, .cut_off = 1.0, .cut_off_force = 0.7},
             1.0, 0.5);
  model.control.end_time = 0.9;
  timeloop::Simulation elastic(model, test::execution());
  test::run(elastic);
  EXPECT_NEAR(spring_force(elastic.domain()), 4 * 0.5, 1e-9);
  model.control.end_time = 1.1;
  timeloop::Simulation cut(model, test::execution());
  test::run(cut);
  EXPECT_EQ(spring_force(cut.domain()), 0.7);
}

/// A mass runs into a spring that bears compression alone: it leaves with the elastic energy of unloading.
TEST(Springs, InelasticSpringGivesBackItsElasticEnergyAlone) {
  for (const bool tension : {false, true}) {
    constexpr double unloading = 50.0;
    // Away from the fixed end the element lengthens.
    model::Model model = held_mass(model::InelasticSpring{0, unloading, tension}, 1.0, tension ? 4.0 : -4.0);
    model.curves.push_back({1, {0, 0.5, 1}, {0, 10, 12}});
    model.control.step_scale = 0.02;
    model.control.end_time = 1.5;
    timeloop::Simulation simulation(model, test::execution());
    double deepest = 0;
    double largest = 0;
    test::run(simulation, [&](const domain::Domain& domain) {
      const double along = (tension ? 1 : -1) * test::displacement(domain, 0).x;
      deepest = test::larger_of(deepest, along);
      largest = test::larger_of(largest, (tension ? 1 : -1) * spring_force(domain));
    });
    // Energy 8: the curve takes 2.5 up to 0.5, then 10 x + 2 x^2.
    const double beyond = (-10 + std::sqrt(100 + 8 * 5.5)) / 4;
    const double force = 10 + 4 * beyond;
    const double back = force * force / (2 * unloading);
    const domain::Domain& domain = simulation.domain();
    const double v = domain.nodes.velocity[domain.nodes.domain_node[0]][0];
    test::verified("inelastic spring: depth", "energy").within(deepest, 0.5 + beyond, 1e-3);
    EXPECT_NEAR(largest, force, 1e-2);
    test::verified("inelastic spring: energy given back", "F^2 / 2 KU").within(0.5 * v * v, back, 1e-2);
    EXPECT_EQ(spring_force(domain), 0);
    EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-2);
  }
}

TEST(Springs, RateScalesTheForceOfANonlinearSpring) {
  // With a factor of 3 at any rate: a spring of three times the stiffness.
  model::Model model = held_mass(model::NonlinearSpring{0, 1}, 1.0, 4.0);
  model.curves.push_back({1, {-1, 0, 1}, {-20, 0, 20}});
  model.curves.push_back({2, {-1, 1}, {3, 3}});
  model.control.step_scale = 0.02;
  model.control.end_time = 0.5;
  EXPECT_NEAR(peak_of(model).value, 4 / std::sqrt(60.0), 2e-4);
}

TEST(Springs, TorsionalSpringTurnsAnInertia) {
  constexpr double k = 5.0;
  constexpr double inertia = 0.2;  // omega = 5
  model::Model model = test::one_spring_part(model::LinearSpring{k}, true);
  test::add_mass(model, {0, 0, 0}, 1.0, inertia);
  test::add_mass(model, {0, 0, 1}, 1.0, inertia);
  model.discretes.push_back({.id = 1, .part = 0, .node = {0, 1}});
  model.fixed_nodes.push_back({.node = 0, .translation = {}, .rotation = {true, true, true}});
  model.initial_velocities.push_back({.node = 1, .velocity = {}, .angular_velocity = {0, 0, 1}});
  model.control.step_scale = 0.02;
  model.control.end_time = 0.5 * pi / 5;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::DiscreteBlock& block = simulation.domain().discretes[0];
  EXPECT_NEAR(block.state(0, block.find("deformation")->first), 0.2, 1e-4);
  EXPECT_NEAR(block.state(0, block.find("force")->first), 1.0, 5e-4);
  EXPECT_LT(simulation.domain().energy.error(), 1e-3);
}

TEST(Springs, OffsetPullsAtTimeZeroAndCounts) {
  model::Model model = held_mass(model::LinearSpring{4.0}, 0.25, 0.0);
  model.discretes[0].offset = 0.5;
  model.discretes[0].scale = 2.0;  // omega = sqrt(32)
  model.control.step_scale = 0.02;
  model.control.end_time = pi / std::sqrt(32.0);
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  EXPECT_NEAR(domain.energy.initial_total, 0.5 * 8 * 0.25, 1e-9);
  // A spring that is too long pulls its node along the axis, by twice the offset until it rests again.
  EXPECT_NEAR(test::displacement(domain, 0).x, -1.0, 1e-3);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-3);
}

/// A rigid block of mass 2 and, without mass of its own, a node that belongs to it.
model::Model rigid_block(const model::SpringLaw& law, const test::Point& massless) {
  model::Model model = test::one_spring_part(law);
  model.materials.push_back({.id = 2, .title = "", .density = 2.0, .law = model::Elastic{1e3, 0.3}});
  model.solid_sections.emplace_back().id = 2;
  model.parts.push_back({.id = 2, .title = "block", .solid_section = 0, .material = 0});
  test::add_box(model, 1, 1, 1, 1, [](double u, double v, double w) {
    return test::Point{u - 0.5, v - 0.5, w - 0.5};
  });
  model.nodes.id.push_back(9);
  model.nodes.position.push_back(massless);
  test::make_rigid(model, 1).nodes.push_back(8);
  return model;
}

TEST(Springs, OnAMasslessNodeOfARigidBodyMoveTheBody) {
  constexpr double k = 8.0;  // omega = 2
  model::Model model = rigid_block(model::LinearSpring{k}, {3, 0, 0});
  model.discretes.push_back({.id = 1, .part = 0, .node = {8, 8}, .grounded = true, .axis = {-1, 0, 0}});
  for (Index node = 0; node < 8; ++node)
    model.initial_velocities.push_back({.node = node, .velocity = {0.5, 0, 0}});
  model.control.step_scale = 0.02;
  model.control.end_time = 0.25 * pi;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  EXPECT_NEAR(test::displacement(simulation.domain(), 8).x, 0.5 / 2, 1e-4);
  EXPECT_LT(std::fabs(simulation.domain().energy.imbalance()), 1e-4 * 0.25);
}

TEST(Springs, OnAnArmOfARigidBodyHaveAStableStep) {
  model::Model model = rigid_block(model::LinearSpring{8.0}, {20, 0, 0});
  for (const Index id : {1, 2})
    model.discretes.push_back({.id = id, .part = 0, .node = {8, 8}, .grounded = true, .axis = {0, 1, 0}});
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  // Masses at the corners of the cube: inertia 2 * (0.25 + 0.25). Two springs, half of the mass.
  EXPECT_NEAR(simulation.next_step(), 0.9 * 2 / std::sqrt(2 * 16 * (0.5 + 400)), 1e-12);
  model.initial_velocities.push_back({.node = 0, .velocity = {0, 1, 0}});
  model.control.end_time = 5;
  timeloop::Simulation shaken(model, test::execution());
  test::run(shaken);
  const domain::EnergyLedger& energy = shaken.domain().energy;
  RecordProperty("imbalance_over_initial", test::figure(energy.imbalance() / energy.initial_total));
  EXPECT_LT(std::fabs(energy.imbalance()), 1e-3 * energy.initial_total);
}

TEST(Springs, MassesThatAreMissingAreNamed) {
  model::Model model = test::one_spring_part(model::LinearSpring{1.0});
  test::add_mass(model, {0, 0, 0}, 1.0);
  test::add_mass(model, {1, 0, 0}, 0.0);
  model.discretes.push_back({.id = 7, .part = 0, .node = {0, 1}});
  try {
    const timeloop::Simulation simulation(model, test::execution());
    FAIL() << "a node without mass went through";
  } catch (const std::exception& fault) {
    EXPECT_NE(std::string(fault.what()).find("Node 2 of discrete element 7 has no mass"), std::string::npos)
        << fault.what();
  }
}

}  // namespace
}  // namespace crumple::springs_test
