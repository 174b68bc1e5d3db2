// SPDX-License-Identifier: BSD-3-Clause
//
// Discrete beams against closed forms: oscillators, cables, rigid motion, failure.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/verified.hpp"

namespace crumple::discrete_beams_test {
namespace {

constexpr double pi = std::numbers::pi;
using model::DiscreteBeamLaw;
using test::Point;

model::Model one_part(const DiscreteBeamLaw& law, const model::DiscreteBeamData& data) {
  model::BeamSection section;
  section.id = 1;
  section.formulation = model::BeamFormulation::Discrete;
  section.discrete = data;
  return test::one_beam_part({.id = 1, .title = "m", .density = 2.0, .law = law}, section);
}

/// One beam between two nodes at these places, mass 1 and inertia 0.3 of each node.
model::Model pair(const DiscreteBeamLaw& law, const Point& first, const Point& second,
                  model::DiscreteBeamData data = {}) {
  data.volume = 1.0;
  data.inertia = 0.6;
  model::Model model = one_part(law, data);
  model.nodes.id = {1, 2};
  model.nodes.position = {first, second};
  model.beams.push_back({.id = 1, .part = 0, .node = {0, 1}});
  return model;
}

/// Period of a component of the relative velocity by its crossings.
double period(const model::Model& model, int component) {
  timeloop::Simulation simulation(model, test::execution());
  double before = 0;
  double time_before = 0;
  double first = 0;
  double last = 0;
  int crossings = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const domain::NodeFields& nodes = domain.nodes;
    const auto& field = component < 3 ? nodes.velocity : nodes.angular_velocity;
    const double v = field[nodes.domain_node[1]][component % 3];
    const double time = domain.clock.time;
    if (before < 0 && v >= 0) {
      const double at = time_before + (time - time_before) * before / (before - v);
      if (crossings++ == 0) first = at;
      last = at;
    }
    before = v;
    time_before = time;
  });
  EXPECT_GT(crossings, 3);
  EXPECT_LT(std::fabs(simulation.domain().energy.imbalance()),
            0.01 * simulation.domain().energy.initial_total);
  return (last - first) / (crossings - 1);
}

TEST(DiscreteBeams, OscillateInEveryDirectionWithTheirStiffness) {
  DiscreteBeamLaw law;
  const double stiffness[] = {1, 2, 3, 0.5, 0.7, 0.9};
  for (std::size_t i = 0; i < 6; ++i) law.direction[i].stiffness = stiffness[i];
  double worst = 0;
  for (int i = 0; i < 6; ++i) {
    model::Model model = pair(law, {1, 2, 3}, {1, 2, 3});
    for (const Index node : {0, 1}) {
      model::InitialVelocity start{.node = node};
      (i < 3 ? start.velocity : start.angular_velocity)[static_cast<std::size_t>(i % 3)] =
          node == 0 ? -0.01 : 0.01;
      model.initial_velocities.push_back(start);
    }
    model.control.step_scale = 0.05;
    model.control.end_time = 40;
    // Both nodes move against each other: half the mass, 1/2 or 0.3/2.
    const double mass = i < 3 ? 0.5 : 0.15;
    const double exact = 2 * pi * std::sqrt(mass / stiffness[i]);
    worst = test::larger_of(worst, std::fabs(period(model, i) / exact - 1));
  }
  test::verified("discrete beam of no length in six directions: period, error over exact", "2 pi sqrt(m / k)")
      .below(worst, 1e-3);
}

TEST(DiscreteBeams, TurnWithTheirAxes) {
  // Axes turned by 30 degrees about z: a force along x meets the springs along r and s.
  DiscreteBeamLaw law;
  law.direction[0].stiffness = 4;
  law.direction[1].stiffness = 1;
  const double c = std::cos(pi / 6);
  const double s = std::sin(pi / 6);
  model::DiscreteBeamData data;
  data.axes = {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
  model::Model model = pair(law, {0, 0, 0}, {0, 0, 0}, data);
  model.fixed_nodes.push_back({.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
  model.fixed_nodes.push_back(
      {.node = 1, .translation = {false, false, true}, .rotation = {true, true, true}});
  model.control.end_time = 200;
  model.curves.push_back({1, {0, 60, 1e9}, {0, 1, 1}});
  model.nodal_loads.push_back({.node = 1, .force = {1e-3, 0, 0}, .curve = 0});
  model.control.step_scale = 0.1;
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 2e-2);
  const math::Vec3 u = test::displacement(simulation.domain(), 1);
  EXPECT_NEAR(u.x, 1e-3 * (c * c / 4 + s * s), 1e-7);
  EXPECT_NEAR(u.y, 1e-3 * (c * s / 4 - c * s), 1e-7);
}

math::Vec3 angular_momentum(const domain::Domain& domain) {
  const domain::NodeFields& nodes = domain.nodes;
  math::Vec3 sum;
  for (Index i = 0; i < nodes.count(); ++i)
    sum += nodes.mass[i] * cross(nodes.position[i], nodes.velocity[i]) +
           nodes.inertia[i] * nodes.angular_velocity[i];
  return sum;
}

TEST(DiscreteBeams, TumblingPairsKeepEnergyAndAngularMomentum) {
  DiscreteBeamLaw law;
  for (auto& direction : law.direction) direction.stiffness = 50;
  for (const double place : {-1.0, 0.0, 1.0}) {
    model::DiscreteBeamData data;
    data.place = place;
    model::Model model = pair(law, {-0.5, 0.2, -0.05}, {0.5, -0.2, 0.05}, data);
    const math::Vec3 spin{0.5, 0.3, 1.0};
    for (Index i = 0; i < 2; ++i) {
      const Point& p = model.nodes.position[i];
      const math::Vec3 v = cross(spin, math::Vec3{p[0], p[1], p[2]});
      model.initial_velocities.push_back(
          {.node = i, .velocity = {v.x, v.y, v.z}, .angular_velocity = {spin.x, spin.y, spin.z}});
    }
    model.control.end_time = 10 * 2 * pi;
    model.control.step_scale = 0.2;
    timeloop::Simulation simulation(model, test::execution());
    math::Vec3 initial;
    double worst = 0;
    test::run(simulation, [&](const domain::Domain& domain) {
      if (domain.clock.cycle == 0) initial = angular_momentum(domain);
      worst = test::larger_of(worst, std::fabs(domain.energy.imbalance()));
    });
    test::verified("pair with a discrete beam tumbles ten turns: energy over the kinetic one", "conservation")
        .below(worst / simulation.domain().energy.initial_total, 5e-3);
    const math::Vec3 end = angular_momentum(simulation.domain());
    EXPECT_LT(math::norm(end - initial), 5e-3 * math::norm(initial)) << place;
    EXPECT_LT(math::norm(test::momentum(simulation.domain())), 1e-12);
  }
}

/// A mass of 1 that hangs on a line with gravity g = 0.1 along -z: how far it is down in the end.
double hung(const DiscreteBeamLaw& law, model::DiscreteBeamData data) {
  model::Model model = pair(law, {0, 0, 0}, {0, 0, -2}, data);
  model.fixed_nodes.push_back({.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
  model.control.end_time = 400;
  model.curves.push_back({1, {0, 100, 1e9}, {0, 1, 1}});
  model.nodal_loads.push_back({.node = 1, .force = {0, 0, -0.1}, .curve = 0});
  model.control.step_scale = 0.1;
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 2e-2);
  return -test::displacement(simulation.domain(), 1).z;
}

TEST(DiscreteBeams, CablesStretchBySectionAndOffset) {
  DiscreteBeamLaw cable;
  cable.kind = DiscreteBeamLaw::Kind::Cable;
  cable.youngs_modulus = 100;
  model::DiscreteBeamData data;
  data.cable_area = 0.05;
  EXPECT_NEAR(hung(cable, data), 0.1 * 2 / 5, 1e-5);
  // A cable that is 0.1 too long holds nothing before that.
  data.cable_offset = -0.1;
  EXPECT_NEAR(hung(cable, data), 0.1 + 0.1 * 2.1 / 5, 1e-5);
  data.cable_offset = 0;
  cable.direction[0].preload = 0.06;
  EXPECT_NEAR(hung(cable, data), 0.04 * 2 / 5, 1e-5);
  DiscreteBeamLaw spring;
  spring.kind = DiscreteBeamLaw::Kind::Line;
  spring.direction[0].stiffness = 2;
  test::verified("mass on a spring of a discrete beam: deflection over exact", "m g / k")
      .near(hung(spring, {}) / 0.05, 1, 1e-4);
}

TEST(DiscreteBeams, CablesDoNotPush) {
  DiscreteBeamLaw cable;
  cable.kind = DiscreteBeamLaw::Kind::Cable;
  cable.youngs_modulus = 100;
  model::DiscreteBeamData data;
  data.cable_area = 0.05;
  model::Model model = pair(cable, {0, 0, 0}, {2, 0, 0}, data);
  model.initial_velocities.push_back({.node = 1, .velocity = {-0.1, 0, 0}});
  model.control.end_time = 5;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  EXPECT_NEAR(test::displacement(simulation.domain(), 1).x, -0.1 * simulation.domain().clock.time, 1e-12);
  EXPECT_EQ(simulation.domain().energy.internal, 0);
}

TEST(DiscreteBeams, DampersTakeTheVelocityExponentially) {
  DiscreteBeamLaw law;
  law.direction[0].damping = 0.4;
  model::Model model = pair(law, {0, 0, 0}, {0, 0, 0});
  model.initial_velocities.push_back({.node = 0, .velocity = {-0.1, 0, 0}});
  model.initial_velocities.push_back({.node = 1, .velocity = {0.1, 0, 0}});
  model.control.step_scale = 0.02;
  model.control.end_time = 3;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  // Relative velocity: 0.2 exp(-c t 2 / m).
  const domain::NodeFields& nodes = simulation.domain().nodes;
  const double v = nodes.velocity[nodes.domain_node[1]].x;
  EXPECT_NEAR(v / (0.1 * std::exp(-0.4 * 2 * 3)), 1, 0.02);
}

TEST(DiscreteBeams, CurvesOfOneSignHoldForBoth) {
  for (const double sign : {1.0, -1.0}) {
    DiscreteBeamLaw law;
    law.direction[1].curve = 0;
    model::Model model = pair(law, {0, 0, 0}, {0, 0, 0});
    model.curves.push_back({1, {0, 0.1, 1}, {0, 1, 1.9}});
    model.curves.push_back({2, {0, 1, 1e9}, {0, 0.3, 0.3}});
    model.fixed_nodes.push_back(
        {.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
    model.prescribed_motions.push_back({.node = 1,
                                        .axis = 1,
                                        .kind = model::PrescribedMotion::Kind::Displacement,
                                        .curve = 1,
                                        .scale = sign});
    model.control.end_time = 1;
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    const domain::BeamBlock& block = simulation.domain().beams[0];
    EXPECT_NEAR(block.state(0, block.find("resultant")->first + 1), sign * 1.2, 5e-3);
  }
}

TEST(DiscreteBeams, SpringsBreakAtTheirLimit) {
  DiscreteBeamLaw spring;
  spring.kind = DiscreteBeamLaw::Kind::Line;
  spring.direction[0].stiffness = 2;
  spring.direction[0].tensile_limit = 0.1;
  model::Model model = pair(spring, {0, 0, 0}, {1, 0, 0});
  model.fixed_nodes.push_back({.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
  model.initial_velocities.push_back({.node = 1, .velocity = {0.2, 0, 0}});
  model.control.step_scale = 0.02;
  model.control.end_time = 4;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  EXPECT_EQ(domain.beams[0].eroded, 1);
  // 1/2 m v^2 less 1/2 k u^2.
  const double left = std::sqrt(0.04 - 2 * 0.01);
  EXPECT_NEAR(domain.nodes.velocity[domain.nodes.domain_node[1]].x, left, 2e-3);
  EXPECT_NEAR(domain.energy.eroded, 0.01, 3e-4);
  EXPECT_LT(domain.energy.error(), 0.01);
}

/// Force of direction s over its displacement, in every step on the path 0 - 0.3 - 0 - 0.3 - 0.4.
struct Path {
  std::vector<double> time, displacement, force, energy;
  double peak = 0;  ///< largest displacement before time 1.5
};

Path path_of(const DiscreteBeamLaw& law, std::vector<model::Curve> curves, double sign) {
  model::Model model = pair(law, {0, 0, 0}, {0, 0, 0});
  model.curves = std::move(curves);
  const auto motion = static_cast<Index>(model.curves.size());
  model.curves.push_back({9, {0, 1, 2, 3, 4, 1e9}, {0, 0.3, 0, 0.3, 0.4, 0.4}});
  model.fixed_nodes.push_back({.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
  model.prescribed_motions.push_back({.node = 1,
                                      .axis = 1,
                                      .kind = model::PrescribedMotion::Kind::Displacement,
                                      .curve = motion,
                                      .scale = sign});
  model.control.step_scale = 0.02;
  model.control.end_time = 4;
  timeloop::Simulation simulation(model, test::execution());
  Path path;
  test::run(simulation, [&](const domain::Domain& domain) {
    const domain::BeamBlock& block = domain.beams[0];
    path.time.push_back(domain.clock.time);
    path.displacement.push_back(sign * block.state(0, block.find("deformation")->first + 1));
    path.force.push_back(sign * block.state(0, block.find("resultant")->first + 1));
    path.energy.push_back(domain.energy.internal);
    if (domain.clock.time < 1.5) path.peak = test::larger_of(path.peak, path.displacement.back());
  });
  return path;
}

double loading(double u) {
  return u < 0.1 ? 10 * u : 1 + (u - 0.1);
}
/// Work of loading up to a displacement above 0.1.
double loading_work(double u) {
  return 0.05 + 0.5 * (1 + loading(u)) * (u - 0.1);
}
const model::Curve loading_curve{1, {-1, -0.1, 0, 0.1, 1}, {-1.9, -1, 0, 1, 1.9}};

/// Loading follows its curve, unloading and reloading `back(u, peak)`; `left` is the work that stays.
template <class Back>
void expect_path(const DiscreteBeamLaw& law, const std::vector<model::Curve>& curves, const Back& back,
                 double (*left)(double), const std::string& kind) {
  for (const double sign : {1.0, -1.0}) {
    const Path path = path_of(law, curves, sign);
    double worst = 0;
    double energy = 0;
    for (std::size_t i = 1; i < path.time.size(); ++i) {
      const double u = path.displacement[i];
      const bool rises = path.time[i] < 1 || (path.time[i] > 3 && u >= path.peak);
      const double expected = rises ? loading(u) : back(u, path.peak);
      // The way back up differs with a stiffness, and is not compared.
      const bool again = path.time[i] > 2 && path.time[i] < 3.2;
      const bool compared = !(again && law.unloading == DiscreteBeamLaw::Unloading::Stiffness);
      if (compared) worst = test::larger_of(worst, std::fabs(path.force[i] - expected));
      if (path.time[i] < 2) energy = path.energy[i];
    }
    test::verified("discrete beam, " + kind + ": force on its path, error over the largest", "closed form")
        .below(worst / 1.2, 1e-9);
    test::verified("discrete beam, " + kind + ": work that stays", "closed form")
        .within(energy, left(path.peak), 5e-3);
  }
}

TEST(DiscreteBeams, UnloadAlongAShiftedCurve) {
  DiscreteBeamLaw law;
  law.unloading = DiscreteBeamLaw::Unloading::Curve;
  law.direction[1].curve = 0;
  law.direction[1].unloading_curve = 1;
  expect_path(
      law, {loading_curve, {2, {-1, 0, 1}, {-20, 0, 20}}},
      [](double u, double peak) { return std::max(0.0, loading(peak) - 20 * (peak - u)); },
      [](double peak) { return loading_work(peak) - loading(peak) * loading(peak) / 40; }, "unloading curve");
}

TEST(DiscreteBeams, UnloadWithAStiffnessToALowerCurve) {
  DiscreteBeamLaw law;
  law.unloading = DiscreteBeamLaw::Unloading::Stiffness;
  law.direction[1].curve = 0;
  law.direction[1].unloading_curve = 1;
  law.direction[1].unloading_stiffness = 40;
  expect_path(
      law, {loading_curve, {2, {-1, 0, 1}, {-2, 0, 2}}},
      [](double u, double peak) { return std::max(2 * u, loading(peak) - 40 * (peak - u)); },
      [](double peak) {
        const double meets = (40 * peak - loading(peak)) / 38;
        return loading_work(peak) - 0.5 * (loading(peak) + 2 * meets) * (peak - meets) - meets * meets;
      },
      "unloading stiffness");
}

// A curve of unloading below that of loading, as users give both branches of a measured loop.
TEST(DiscreteBeams, UnloadAlongALowerCurve) {
  DiscreteBeamLaw law;
  law.unloading = DiscreteBeamLaw::Unloading::Curve;
  law.direction[1].curve = 0;
  law.direction[1].unloading_curve = 1;
  const Path path = path_of(law, {loading_curve, {2, {0, 0.2, 0.4}, {0, 0.2, 1.3}}}, 1);
  const auto lower = [](double u) { return u < 0.2 ? u : 0.2 + 5.5 * (u - 0.2); };
  double worst = 0;
  for (std::size_t i = 1; i < path.time.size(); ++i) {
    const double u = path.displacement[i];
    if (path.time[i] > 2 && path.time[i] < 3) continue;  // up from the lower curve to that of loading
    const bool rises = path.time[i] < 1 || path.time[i] > 3;
    // With the steepest slope of both, 10, from where it turns back.
    const double expected =
        rises ? loading(u) : test::larger_of(lower(u), loading(path.peak) - 10 * (path.peak - u));
    worst = test::larger_of(worst, std::fabs(path.force[i] - expected));
  }
  test::verified("discrete beam, lower unloading curve: force on its path, error over the largest",
                 "closed form")
      .below(worst / 1.3, 1e-9);
}

TEST(DiscreteBeams, UnloadAlongAParabola) {
  DiscreteBeamLaw law;
  law.unloading = DiscreteBeamLaw::Unloading::Quadratic;
  law.permanent_share = 0.5;
  law.direction[1].curve = 0;
  expect_path(
      law, {loading_curve},
      [](double u, double peak) {
        const double share = std::max(0.0, u - 0.5 * peak) / (0.5 * peak);
        return share * share * loading(peak);
      },
      [](double peak) { return loading_work(peak) - loading(peak) * 0.5 * peak / 3; }, "parabola");
}

/// Failure by two directions at once.
TEST(DiscreteBeams, FailByAllDirectionsTogether) {
  for (const bool joint : {false, true}) {
    DiscreteBeamLaw law;
    law.joint_failure = joint;
    for (std::size_t i = 0; i < 2; ++i) law.direction[i].stiffness = 1;
    law.direction[0].tensile_limit = 0.1;
    law.direction[1].compressive_limit = 0.2;
    model::Model model = pair(law, {0, 0, 0}, {0, 0, 0});
    model.curves.push_back({1, {0, 1, 1e9}, {0, 0.3, 0.3}});
    model.fixed_nodes.push_back(
        {.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
    for (const int axis : {0, 1})
      model.prescribed_motions.push_back({.node = 1,
                                          .axis = axis,
                                          .kind = model::PrescribedMotion::Kind::Displacement,
                                          .curve = 0,
                                          .scale = axis == 0 ? 1.0 : -1.5});
    model.control.step_scale = 0.001;
    model.control.end_time = 1;
    timeloop::Simulation simulation(model, test::execution());
    double last = 0;
    test::run(simulation, [&](const domain::Domain& domain) {
      const domain::BeamBlock& block = domain.beams[0];
      if (block.eroded == 0) last = block.state(0, block.find("deformation")->first);
    });
    // u along r, -1.5 u along s: (u / 0.1)^2 + (1.5 u / 0.2)^2 = 1, or the first part alone.
    EXPECT_NEAR(last, joint ? 0.08 : 0.1, 1e-3);
  }
}

/// A factor over the displacement scales the damper.
TEST(DiscreteBeams, DampersMayDependOnTheDisplacement) {
  DiscreteBeamLaw law;
  law.direction[1].damping_curve = 0;
  law.direction[1].damping_factor = 1;
  const Path path = path_of(law, {{1, {-1, 0, 1}, {-2, 0, 2}}, {2, {0, 0.3}, {1, 4}}}, 1.0);
  for (std::size_t i = 2; i < path.time.size(); ++i) {
    if (path.time[i] > 0.9) break;
    EXPECT_NEAR(path.force[i], 0.6 * (1 + 10 * path.displacement[i]), 1e-6);
  }
}

}  // namespace
}  // namespace crumple::discrete_beams_test
