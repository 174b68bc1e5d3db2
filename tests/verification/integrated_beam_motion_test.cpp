// SPDX-License-Identifier: BSD-3-Clause
//
// Beams integrated over their cross section in motion: conservation, waves, steps, cycles, failure, bits.

#include <gtest/gtest.h>

#include <cmath>
#include <exception>
#include <numbers>
#include <string>

#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/verified.hpp"

namespace crumple::integrated_beam_motion_test {
namespace {

constexpr double pi = std::numbers::pi;
using model::SectionRule;
using test::Point;

const model::Material elastic{.id = 1, .title = "m", .density = 1.0, .law = model::Elastic{1e4, 0.25}};

math::Vec3 angular_momentum(const domain::Domain& domain) {
  const domain::NodeFields& nodes = domain.nodes;
  math::Vec3 sum;
  for (Index i = 0; i < nodes.count(); ++i)
    sum += nodes.mass[i] * cross(nodes.position[i], nodes.velocity[i]) +
           nodes.inertia[i] * nodes.angular_velocity[i];
  return sum;
}

TEST(IntegratedBeamMotion, TumblingBeamKeepsEnergyAndAngularMomentum) {
  const auto section = test::integrated(model::rectangle_points(0.4, 0.2, SectionRule::Gauss3), 5.0 / 6);
  model::Model model = test::one_beam_part(elastic, section);
  test::add_line(model, 6, {0, 1, 0}, [](double u) { return Point{4 * u - 2, 0, 0}; });
  const math::Vec3 spin{0.5, 0.3, 1.0};
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const Point& p = model.nodes.position[i];
    const math::Vec3 v = cross(spin, math::Vec3{p[0], p[1], p[2]});
    model.initial_velocities.push_back(
        {.node = i, .velocity = {v.x, v.y, v.z}, .angular_velocity = {spin.x, spin.y, spin.z}});
  }
  model.control.end_time = 20 * 2 * pi;  // about twenty turns
  timeloop::Simulation simulation(model, test::execution());
  math::Vec3 initial;
  double worst = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.clock.cycle == 0) initial = angular_momentum(domain);
    worst = test::larger_of(worst, std::fabs(domain.energy.imbalance()));
  });
  test::verified("integrated beam tumbles twenty turns: energy over the kinetic one", "conservation")
      .below(worst / simulation.domain().energy.initial_total, 1e-3);
  const math::Vec3 end = angular_momentum(simulation.domain());
  EXPECT_LT(math::norm(end - initial), 5e-3 * math::norm(initial));
  EXPECT_LT(math::norm(test::momentum(simulation.domain())), 1e-10);
}

TEST(IntegratedBeamMotion, BendOf45DegreesGoesWhereOthersFoundIt) {
  // As beams_test.cpp has it: J.C. Simo and L. Vu-Quoc, CMAME 58 (1986) 79-116. The torsional stiffness of a
  // square of plane sections is 1/6, what they use.
  const auto section = test::integrated(model::rectangle_points(1, 1, SectionRule::Gauss2));
  model::Model model =
      test::one_beam_part({.id = 1, .title = "m", .density = 1.0, .law = model::Elastic{1e7, 0.0}}, section);
  test::add_line(model, 16, {0, 0, 1}, [](double u) {
    const double angle = u * pi / 4;
    return Point{100 * (1 - std::cos(angle)), 100 * std::sin(angle), 0};
  });
  model.fixed_nodes.push_back({.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
  model.control.end_time = 200;
  model.curves.push_back({1, {0, 60, 1e9}, {0, 1, 1}});
  model.nodal_loads.push_back({.node = 16, .force = {0, 0, 600}, .curve = 0});
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 1e-3);
  const domain::NodeFields& nodes = simulation.domain().nodes;
  const math::Vec3 tip = nodes.position[nodes.domain_node[16]];
  const char* const source = "Simo and Vu-Quoc 1986";
  test::verified("bend of 45 degrees, 16 integrated beams: tip, x", source).near(tip.x, 15.79, 0.25);
  test::verified("bend of 45 degrees, 16 integrated beams: tip, y", source).near(tip.y, 47.23, 0.25);
  test::verified("bend of 45 degrees, 16 integrated beams: tip, z", source).near(tip.z, 53.37, 0.25);
}

TEST(IntegratedBeamMotion, FrontTravelsWithTheSpeedOfTheBar) {
  // A bar whose end is pulled at a constant velocity: stress rho c v behind the front, c = sqrt(E / rho) =
  // 100.
  const auto section = test::integrated(model::tube_points(0.2, 0, SectionRule::Gauss2));
  model::Model model = test::one_beam_part(elastic, section);
  test::add_line(model, 200, {0, 1, 0}, [](double u) { return Point{20 * u, 0, 0}; });
  model.curves.push_back({1, {0, 1e9}, {1, 1}});
  model.prescribed_motions.push_back(
      {.node = 0, .axis = 0, .kind = model::PrescribedMotion::Kind::Velocity, .curve = 0, .scale = -1e-2});
  model.control.end_time = 0.15;
  timeloop::Simulation simulation(model, test::execution());
  double arrival = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double v = domain.nodes.velocity[domain.nodes.domain_node[100]].x;
    if (arrival == 0 && v < -0.5e-2) arrival = domain.clock.time;
  });
  test::verified("front in a bar of integrated beams: speed over exact", "sqrt(E / rho)")
      .near(10 / arrival / 100, 1, 0.01);
  const domain::BeamBlock& block = simulation.domain().beams[0];
  double mean = 0;
  for (Index place = 0; place < block.elements; ++place)
    if (const Index element = block.element[place]; element >= 40 && element < 100)
      mean += block.state(place, block.find("stress")->first) / 60;
  EXPECT_NEAR(mean, 1.0, 0.02);
}

TEST(IntegratedBeamMotion, ShakenBeamsOfAnyProportionsStayStable) {
  for (const double slenderness : {0.2, 1.0, 5.0, 50.0})
    for (const double offset : {0.0, 0.5}) {
      auto points = model::rectangle_points(1.0, 0.7, SectionRule::Gauss2);
      model::move_nodes(points, offset, 0.5 * offset);
      model::Model model = test::one_beam_part(
          {.id = 1, .title = "m", .density = 1.0, .law = model::Elastic{1e4, 0.3}}, test::integrated(points));
      const double length = 5 * slenderness;
      test::add_line(model, 5, {0, 1, 0}, [&](double u) { return Point{length * u, 0, 0}; });
      for (Index i = 0; i < 6; ++i)
        model.initial_velocities.push_back(
            {.node = i,
             .velocity = {1e-3 * std::sin(7.0 * i), 1e-3 * std::cos(5.0 * i), 1e-3 * std::sin(3.0 * i + 1)},
             .angular_velocity = {1e-3 * std::cos(2.0 * i), 1e-3 * std::sin(4.0 * i), 1e-3}});
      model.control.end_cycle = 20000;
      model.control.end_time = 1e9;
      timeloop::Simulation simulation(model, test::execution());
      double worst = 0;
      test::run(simulation, [&](const domain::Domain& domain) {
        worst = test::larger_of(worst, std::fabs(domain.energy.imbalance()));
      });
      EXPECT_LT(worst, 0.02 * simulation.domain().energy.initial_total) << slenderness << " " << offset;
    }
}

/// Largest velocity of one free beam that starts in the pattern of its highest frequency, over the first one.
double growth(double step_scale) {
  const auto section = test::integrated(model::rectangle_points(0.5, 0.5, SectionRule::Gauss2));
  model::Model model = test::one_beam_part(elastic, section);
  test::add_line(model, 1, {0, 1, 0}, [](double u) { return Point{u, 0, 0}; });
  for (const Index i : {0, 1})
    model.initial_velocities.push_back(
        {.node = i, .velocity = {0, i == 0 ? 1e-9 : -1e-9, 0}, .angular_velocity = {0, 0, 2e-9}});
  model.control.step_scale = step_scale;
  model.control.end_cycle = 3000;
  model.control.end_time = 1e9;
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  double most = 0;
  while (!simulation.finished()) {
    simulation.step();
    most = test::larger_of(most, std::fabs(simulation.domain().nodes.velocity[0].y));
  }
  return most / 1e-9;
}

TEST(IntegratedBeamMotion, OneElementIsStableUpToItsStepAndNotBeyond) {
  // The step of a single free beam is that of its highest frequency: with 2 percent more it runs away, which
  // the run notices.
  EXPECT_LT(growth(0.95), 10);
  EXPECT_THROW(growth(1.02), std::exception);
}

/// A bar of one element between a fixed and a heavy node: an oscillator far beyond yield. Stress and plastic
/// strain at the end.
std::array<double, 2> oscillated(const model::BeamSection& section, double beta) {
  model::Model model = test::one_beam_part({.id = 1,
                                            .title = "m",
                                            .density = 1e-3,
                                            .law = model::PlasticKinematic{.youngs_modulus = 1e4,
                                                                           .poissons_ratio = 0.25,
                                                                           .yield_stress = 10,
                                                                           .tangent_modulus = 1000,
                                                                           .isotropic_fraction = beta}},
                                           section);
  test::add_line(model, 1, {0, 1, 0}, [](double u) { return Point{u, 0, 0}; });
  model.fixed_nodes.push_back({.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
  // Held across: with its tangent modulus the bar would buckle at a third of the stress that it gets.
  model.fixed_nodes.push_back(
      {.node = 1, .translation = {false, true, true}, .rotation = {true, true, true}});
  model.curves.push_back({1, {0, 1, 3, 5, 7, 1e9}, {0, 0.01, -0.008, 0.012, -0.015, -0.015}});
  model.prescribed_motions.push_back(
      {.node = 1, .axis = 0, .kind = model::PrescribedMotion::Kind::Displacement, .curve = 0});
  model.control.end_time = 7;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::BeamBlock& block = simulation.domain().beams[0];
  return {block.state(0, block.find("stress")->first), block.state(0, block.find("plastic_strain")->first)};
}

TEST(IntegratedBeamMotion, CyclesOfABarAreThoseOfATruss) {
  model::BeamSection truss;
  truss.id = 1;
  truss.formulation = model::BeamFormulation::Truss;
  truss.area = 0.08;
  const auto integrated = test::integrated(model::rectangle_points(0.4, 0.2, SectionRule::Gauss2));
  for (const double beta : {0.0, 0.4, 1.0}) {
    const auto expected = oscillated(truss, beta);
    const auto found = oscillated(integrated, beta);
    EXPECT_NEAR(found[0], expected[0], 1e-4 * std::fabs(expected[0])) << beta;
    EXPECT_NEAR(found[1], expected[1], 1e-4 * expected[1]) << beta;
    EXPECT_GT(expected[1], 0.04);
  }
}

TEST(IntegratedBeamMotion, PulledBarErodesAtItsFailureStrain) {
  model::PiecewiseLinearPlasticity law;
  law.youngs_modulus = 1e4;
  law.poissons_ratio = 0.25;
  law.plastic_strain = {0, 1};
  law.yield_stress = {10, 20};
  law.failure_strain = 0.1;
  const auto section = test::integrated(model::rectangle_points(0.4, 0.2, SectionRule::Gauss2));
  model::Model model = test::one_beam_part({.id = 1, .title = "m", .density = 1e-3, .law = law}, section);
  test::add_line(model, 1, {0, 1, 0}, [](double u) { return Point{u, 0, 0}; });
  model.fixed_nodes.push_back({.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
  model.curves.push_back({1, {0, 1e9}, {1, 1}});
  model.prescribed_motions.push_back(
      {.node = 1, .axis = 0, .kind = model::PrescribedMotion::Kind::Velocity, .curve = 0, .scale = 0.1});
  model.control.end_time = 2;
  timeloop::Simulation simulation(model, test::execution());
  double stretch = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.beams[0].eroded == 0) stretch = test::displacement(domain, 1).x;
  });
  const domain::Domain& domain = simulation.domain();
  EXPECT_EQ(domain.beams[0].eroded, 1);
  // Plastic strain 0.1 at the stress 11: logarithmic strain 0.1011.
  EXPECT_NEAR(stretch, std::exp(0.1011) - 1, 1e-4);
  // Work of 10.5 over 0.1, and the elastic part.
  const double work = 0.08 * (10.5 * 0.1 + 0.5 * 11 * 11 / 1e4);
  // Per volume of the moment: the axial force is area times stress over a length that grows.
  EXPECT_GT(domain.energy.eroded, work);
  EXPECT_LT(domain.energy.eroded, 1.11 * work);
  EXPECT_LT(domain.energy.error(), 1e-3);
  EXPECT_EQ(domain.energy.internal, 0);
}

TEST(IntegratedBeamMotion, SameBitsForThreadsAndInstructionSets) {
  const auto hash = [](int threads, Isa isa, Precision precision) {
    model::Model model =
        test::one_beam_part({.id = 1,
                             .title = "m",
                             .density = 1.0,
                             .law = model::PlasticKinematic{.youngs_modulus = 1e4,
                                                            .poissons_ratio = 0.25,
                                                            .yield_stress = 10,
                                                            .tangent_modulus = 500,
                                                            .isotropic_fraction = 0.5}},
                            test::integrated(model::rectangle_points(0.4, 0.2, SectionRule::Gauss3)));
    test::add_line(model, 600, {0, 1, 0}, [](double u) { return Point{10 * u, 0, 0}; });
    for (Index i = 1; i < 600; ++i)
      model.initial_velocities.push_back({.node = i,
                                          .velocity = {std::sin(7.0 * i), std::cos(5.0 * i), 0.1},
                                          .angular_velocity = {std::cos(2.0 * i), std::sin(4.0 * i), 1}});
    model.control.end_cycle = 50;
    timeloop::Simulation simulation(model, {precision, isa, threads});
    test::run(simulation);
    return simulation.state_hash();
  };
  for (const Precision precision : {Precision::Double, Precision::Mixed}) {
    const Isa best = default_isa();
    EXPECT_EQ(hash(1, best, precision), hash(3, best, precision));
    EXPECT_EQ(hash(1, Isa::Scalar, precision), hash(1, Isa::Baseline, precision));
    const std::vector<Isa> isas = available_isas();
    if (isas.size() == 4) {
      EXPECT_EQ(hash(1, isas[2], precision), hash(1, isas[3], precision));
    }
  }
}

}  // namespace
}  // namespace crumple::integrated_beam_motion_test
