// SPDX-License-Identifier: BSD-3-Clause
//
// Rigid bodies under forces, prescribed motions, body loads and rigid walls, against exact solutions.

#include <gtest/gtest.h>

#include <cmath>

#include "constraints/rigid_bodies.hpp"
#include "constraints/rigid_motion.hpp"
#include "support/larger.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::rigid_body_test {
namespace {

using math::Vec3;

constexpr double density = 7.85e-6;

/// A steel block of 20 x 10 x 10 mm as a rigid body; kg, mm, ms.
model::Model block() {
  model::Model model = test::one_solid_part(test::elastic_steel());
  test::add_box(model, 0, 4, 2, 2, [](double u, double v, double w) {
    return test::Point{20 * u, 10 * v, 10 * w};
  });
  test::make_rigid(model, 0);
  return model;
}

constexpr double block_mass = density * 2000;

TEST(RigidBody, ConstantForceGivesAParabola) {
  model::Model model = block();
  const Index curve = test::add_constant_curve(model, 1.0);
  model.rigid_body_loads.push_back({.body = 0, .force = {1.5, 0, -0.5}, .moment = {}, .curve = curve});
  model.control.end_time = 1;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double time = domain.clock.time;
  const Vec3 moved = domain.rigid_bodies[0].centre - Vec3{10, 5, 5};
  EXPECT_NEAR(moved.x, 0.5 * 1.5 / block_mass * time * time, 1e-10 * moved.x);
  EXPECT_NEAR(moved.z, -0.5 * 0.5 / block_mass * time * time, 1e-10 * moved.x);
  EXPECT_NEAR(domain.energy.external_work, dot(Vec3{1.5, 0, -0.5}, moved), 1e-9 * domain.energy.kinetic);
  // The kinetic energy of time zero is not in product form: 1/8 F^2 dt^2 / M, once.
  const double at_start = 2.5 * domain.clock.step * domain.clock.step / block_mass / 8;
  EXPECT_NEAR(std::fabs(domain.energy.imbalance()), at_start, 1e-3 * at_start);
}

TEST(RigidBody, ConstantMomentAboutAPrincipalAxisTurnsItByAParabola) {
  model::Model model = block();
  const Index curve = test::add_constant_curve(model, 1.0);
  model.rigid_body_loads.push_back({.body = 0, .force = {}, .moment = {0, 0, 0.3}, .curve = curve});
  model.control.end_time = 4.2;
  timeloop::Simulation simulation(model, test::execution());
  const domain::RigidBody& body = simulation.domain().rigid_bodies[0];
  // Masses lumped at nodes h apart: a bar's m l^2 / 12 becomes m (l^2 + 2 h^2) / 12.
  const double inertia = block_mass * ((400 + 2 * 25) + (100 + 2 * 25)) / 12;
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double angle = 0.5 * 0.3 / inertia * domain.clock.time * domain.clock.time;
  const Index corner = domain.nodes.domain_node[0];
  const Vec3 arm = domain.nodes.position[corner] - body.centre;
  const Vec3 exact{-10 * std::cos(angle) + 5 * std::sin(angle), -10 * std::sin(angle) - 5 * std::cos(angle),
                   -5};
  EXPECT_GT(angle, 3);
  test::verified("rigid block under a moment: error of a corner after 3 rad", "exact")
      .below(norm(arm - exact), 1e-5);
  EXPECT_NEAR(domain.energy.kinetic, 0.3 * angle, 1e-5 * domain.energy.kinetic);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-6 * domain.energy.kinetic);
}

TEST(RigidBody, NodalLoadGivesItsImpulseAndItsMoment) {
  model::Model model = block();
  model.curves.push_back({1, {0, 0.1, 0.2}, {0, 2, 0}});  // impulse 0.2
  const Index corner = 0;
  model.nodal_loads.push_back({.node = corner, .force = {0, 1, 0}, .moment = {}, .curve = 0});
  model.control.end_time = 0.5;
  timeloop::Simulation simulation(model, test::execution());
  double impulse = 0;
  Vec3 angular;
  const domain::Domain& domain = simulation.domain();
  const domain::RigidBody& body = domain.rigid_bodies[0];
  test::run(simulation, [&](const domain::Domain& now) {
    const double interval = 0.5 * (now.clock.step + simulation.next_step());
    const double force = model.curves[0].at(now.clock.time);
    impulse += interval * force;
    const Vec3 arm = now.nodes.position[now.nodes.domain_node[corner]] - body.centre;
    angular += interval * cross(arm, Vec3{0, force, 0});
  });
  EXPECT_NEAR(impulse, 0.2, 1e-4);
  EXPECT_NEAR(body.mass * body.velocity.y, impulse, 1e-12);
  EXPECT_NEAR(body.mass * norm(Vec3{body.velocity.x, 0, body.velocity.z}), 0, 1e-14);
  EXPECT_LT(norm(body.angular_momentum - angular), 1e-12 * norm(angular));
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 2e-6 * domain.energy.kinetic);
}

/// A bar of steel without lateral contraction, 100 x 4 x 4 mm, that a rigid block at its end pulls from t = 0
/// on.
struct PulledBar {
  model::Model model;
  double area = 16;
  double wave_speed = std::sqrt(210.0 / density);
};

PulledBar pulled_bar(double velocity) {
  PulledBar bar;
  model::Model& model = bar.model;
  model = test::one_solid_part(test::elastic_steel());
  model.materials[0].law = model::Elastic{210.0, 0.0};
  model.parts.push_back({.id = 2, .title = "rigid", .solid_section = 0, .material = 0});
  test::add_box(model, 0, 50, 1, 1, [](double u, double v, double w) {
    return test::Point{104 * u, 4 * v, 4 * w};
  });
  for (std::size_t i = 48; i < 50; ++i) model.solids[i].part = 1;
  test::make_rigid(model, 1);
  const Index curve = test::add_constant_curve(model, velocity);
  model.prescribed_motions.push_back({.body = 0, .axis = 0, .curve = curve});
  for (Index node = 0; node < model.nodes.count(); node += 51)
    model.fixed_nodes.push_back({.node = node, .translation = {true, true, true}});
  return bar;
}

TEST(RigidBody, PrescribedVelocityPullsABarWithTheForceOfItsWave) {
  const double velocity = 0.1;
  PulledBar bar = pulled_bar(velocity);
  const double length = 99.84;
  const double there = length / bar.wave_speed;
  bar.model.control.end_time = 1.9 * there;
  timeloop::Simulation simulation(bar.model, test::execution());
  double sum = 0;
  double time = 0;
  const domain::Domain& domain = simulation.domain();
  const double centre = domain.rigid_bodies[0].centre.x;
  test::run(simulation, [&](const domain::Domain& now) {
    if (now.clock.time < 0.4 * there || now.clock.time > 1.8 * there) return;
    sum += now.clock.step * now.rigid_bodies[0].reaction.x;
    time += now.clock.step;
  });
  // Until the wave is back: impedance times velocity (J.D. Achenbach, Wave Propagation in Elastic
  // Solids, 1.3).
  const double force = density * bar.wave_speed * velocity * bar.area;
  RecordProperty("imbalance_over_work",
                 test::figure(domain.energy.imbalance() / domain.energy.external_work));
  test::verified("rigid block pulls a bar: reaction over exact", "wave equation, exact")
      .near(sum / time / force, 1, 1e-3);
  const double start = 0.5 * domain.rigid_bodies[0].mass * velocity * velocity;  // to set the block going
  EXPECT_NEAR(domain.energy.external_work, force * velocity * domain.clock.time + start,
              0.02 * domain.energy.external_work);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-4 * domain.energy.external_work);
  EXPECT_NEAR(domain.rigid_bodies[0].centre.x, centre + velocity * domain.clock.time, 1e-9);
}

TEST(RigidBody, PrescribedDisplacementIsMetAtEveryStep) {
  PulledBar bar = pulled_bar(0);
  model::Model& model = bar.model;
  model.curves.push_back({9, {0, 0.01, 0.02, 0.05}, {0, 0.01, 0.04, 0.1}});
  model.prescribed_motions = {{.body = 0,
                               .axis = 0,
                               .kind = model::PrescribedMotion::Kind::Displacement,
                               .curve = 1,
                               .scale = 0.5,
                               .birth = 0.005}};
  model.control.end_time = 0.05;
  timeloop::Simulation simulation(model, test::execution());
  const double start = simulation.domain().rigid_bodies[0].centre.x;
  double at_birth = -1;
  double birth = 0;
  double worst = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    const double moved = now.rigid_bodies[0].centre.x - start;
    if (now.clock.time < 0.005) return;
    if (at_birth < 0) {
      at_birth = moved;
      birth = now.clock.time;
    }
    const auto curve = [&](double t) { return 0.5 * model.curves[1].at(t - 0.005); };
    worst = test::larger_of(worst, std::fabs(moved - at_birth - (curve(now.clock.time) - curve(birth))));
  });
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(std::fabs(simulation.domain().energy.imbalance()),
            1e-3 * simulation.domain().energy.external_work);
}

TEST(RigidBody, PrescribedMotionOfNodesBalances) {
  PulledBar bar = pulled_bar(0);
  model::Model& model = bar.model;
  model.prescribed_motions.clear();
  model.curves.push_back({9, {0, 1}, {20, 20}});
  // The held end, pulled the other way with a constant acceleration.
  model.fixed_nodes.clear();
  for (Index node = 0; node < model.nodes.count(); node += 51)
    model.prescribed_motions.push_back({.node = node,
                                        .axis = 0,
                                        .kind = model::PrescribedMotion::Kind::Acceleration,
                                        .curve = 1,
                                        .scale = -1});
  model.control.end_time = 0.1;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  EXPECT_NEAR(test::displacement(domain, 0).x, -0.5 * 20 * domain.clock.time * domain.clock.time, 1e-10);
  RecordProperty("imbalance_over_work",
                 test::figure(domain.energy.imbalance() / domain.energy.external_work));
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-4 * domain.energy.external_work);
}

TEST(RigidBody, PrescribedRotationTurnsByTheAngleOfItsCurve) {
  model::Model model = block();
  model.rigid_bodies[0].fixed_translation = {true, true, true};
  model.rigid_bodies[0].fixed_rotation = {true, true, false};
  const Index curve = test::add_constant_curve(model, 2.0);
  model.prescribed_motions.push_back({.body = 0, .axis = 2, .rotation = true, .curve = curve});
  model.control.end_time = 1.5;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double angle = 2 * domain.clock.time;
  const Vec3 arm = domain.nodes.position[domain.nodes.domain_node[0]] - domain.rigid_bodies[0].centre;
  EXPECT_NEAR(arm.x, -10 * std::cos(angle) + 5 * std::sin(angle), 1e-10);
  EXPECT_NEAR(arm.y, -10 * std::sin(angle) - 5 * std::cos(angle), 1e-10);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-10 * domain.energy.kinetic);
  EXPECT_NEAR(domain.energy.external_work, domain.energy.kinetic, 1e-10 * domain.energy.kinetic);
}

TEST(RigidBody, FallsWithWhatIsDeformable) {
  model::Model model = block();
  model.parts.push_back({.id = 2, .title = "soft", .solid_section = 0, .material = 0});
  test::add_box(model, 1, 2, 2, 2, [](double u, double v, double w) {
    return test::Point{50 + 10 * u, 10 * v, 10 * w};
  });
  const double gravity = 9.81e-3;
  const Index curve = test::add_constant_curve(model, gravity);
  // As in LS-DYNA the frame accelerates upwards: everything falls.
  model.body_loads.push_back({.axis = 2, .curve = curve});
  model.control.end_time = 1;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double fall = -0.5 * gravity * domain.clock.time * domain.clock.time;
  for (const Index node : {0, 30, 50, 60}) EXPECT_NEAR(test::displacement(domain, node).z, fall, 1e-10);
  EXPECT_NEAR(domain.energy.external_work, domain.energy.kinetic, 1e-6 * domain.energy.kinetic);
}

/// A tilted block that flies at a wall.
model::Model thrown_block(double friction) {
  model::Model model = block();
  const double c = std::cos(0.3);
  const double s = std::sin(0.3);
  for (auto& x : model.nodes.position) x = {c * x[0] + s * x[2], x[1], c * x[2] - s * x[0] + 8};
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i, .velocity = {1, 0.5, -10}});
  model::RigidWall wall;
  wall.id = 1;
  wall.normal = {0, 0, 1};
  wall.friction = friction;
  for (Index i = 0; i < model.nodes.count(); ++i) wall.nodes.push_back(i);
  model.rigid_walls.push_back(wall);
  model.control.end_time = 3;
  return model;
}

class ThrownBlock : public ::testing::TestWithParam<double> {};

TEST_P(ThrownBlock, WallTakesItsMomentumAndNothingPasses) {
  const model::Model model = thrown_block(GetParam());
  timeloop::Simulation simulation(model, test::execution());
  const Vec3 start = block_mass * Vec3{1, 0.5, -10};
  double lowest = 0;
  double worst = 0;
  double energy = 1e30;
  double gain = 0;
  const domain::Domain& domain = simulation.domain();
  test::run(simulation, [&](const domain::Domain& now) {
    for (const Vec3& x : now.nodes.position) lowest = std::min(lowest, x.z);
    const Vec3 momentum = now.rigid_bodies[0].mass * now.rigid_bodies[0].velocity;
    worst = test::larger_of(worst, norm(momentum + now.walls[0].impulse - start) / norm(start));
    gain = test::larger_of(gain, now.energy.kinetic - energy);
    energy = now.energy.kinetic;
  });
  RecordProperty("lowest_node", test::figure(lowest));
  RecordProperty("energy_left", test::figure(domain.energy.kinetic / domain.energy.initial_total));
  test::verified("tilted rigid block thrown at a wall, friction " + test::figure(GetParam()) +
                     ": impulse less change of momentum",
                 "conservation")
      .below(worst, 1e-12);
  EXPECT_GT(lowest, -1e-3);
  EXPECT_GT(domain.walls[0].impulse.z, -2 * norm(start));
  EXPECT_LT(domain.walls[0].impulse.z, 0) << "the wall is pushed away";
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-9 * domain.energy.initial_total);
  EXPECT_LT(gain, 1e-3 * domain.energy.initial_total) << "an impact is plastic";
  EXPECT_LT(domain.energy.kinetic, 0.6 * domain.energy.initial_total);
}

INSTANTIATE_TEST_SUITE_P(Friction, ThrownBlock, ::testing::Values(0.0, 0.3, 1.0));

/// Two plates of shells that share an edge, one of them rigid and of many nodes.
model::Model half_rigid_plate() {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1.0, 3));
  model.parts.push_back({.id = 2, .title = "rigid", .section = 0, .material = 0});
  test::add_grid(model, 0, 80, 40, [](double u, double v) { return test::Point{80 * u, 40 * v, 0}; });
  for (std::size_t i = 0; i < model.shells.size(); ++i)
    if (i % 80 >= 20) model.shells[i].part = 1;
  test::make_rigid(model, 1);
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    model.initial_velocities.push_back(
        {.node = i, .velocity = {0, 0.1 * x[0], 3 - 0.05 * x[1]}, .angular_velocity = {0, 0, 0}});
  }
  model.control.end_time = 0.01;
  return model;
}

TEST(RigidBody, ThreadsDoNotChangeABit) {
  const model::Model model = half_rigid_plate();
  std::uint64_t first = 0;
  for (int threads = 1; threads <= 4; ++threads) {
    domain::Execution execution = test::execution();
    execution.threads = threads;
    timeloop::Simulation simulation(model, execution);
    test::run(simulation);
    if (threads == 1) first = simulation.state_hash();
    EXPECT_EQ(simulation.state_hash(), first) << threads;
  }
}

TEST(RigidBody, SharedNodesBelongToTheBodyAndTheEnergyBalances) {
  const model::Model model = half_rigid_plate();
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  const Vec3 start = test::momentum(domain);
  test::run(simulation);
  EXPECT_LT(norm(test::momentum(domain) - start), 1e-6 * norm(start));
  test::verified("plate half of which is rigid: energy error", "conservation")
      .below(domain.energy.error(), 1e-4);
  EXPECT_TRUE(std::any_of(domain.shells.begin(), domain.shells.end(),
                          [](const domain::ShellBlock& block) { return block.rigid; }));
}

TEST(RigidBody, ReleasedNodesGoOnAsTheyWere) {
  model::Model model = half_rigid_plate();
  model.control.end_time = 0.005;
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  for (int i = 0; i < 5; ++i) simulation.step();
  domain::Domain& domain = simulation.domain();
  const AlignedArray<Vec3> before = domain.nodes.velocity;
  const double kinetic = domain.energy.kinetic;
  constraints::release_body(domain, 0);
  for (Index i = 0; i < domain.nodes.count(); ++i) {
    EXPECT_TRUE(domain.nodes.is_free(i));
    EXPECT_EQ(norm(domain.nodes.velocity[i] - before[i]), 0);
  }
  simulation.step();
  EXPECT_NEAR(domain.energy.kinetic, kinetic, 1e-3 * kinetic);
}

TEST(RigidBody, HeldAxesStay) {
  model::Model model = block();
  model.rigid_bodies[0].fixed_translation = {true, false, true};
  model.rigid_bodies[0].fixed_rotation = {true, true, true};
  const Index curve = test::add_constant_curve(model, 1.0);
  model.nodal_loads.push_back({.node = 3, .force = {1, 2, 3}, .moment = {}, .curve = curve});
  model.control.end_time = 0.2;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const Vec3 moved = test::displacement(domain, 11);
  EXPECT_NEAR(moved.x, 0, 1e-13);
  EXPECT_NEAR(moved.z, 0, 1e-13);
  EXPECT_NEAR(moved.y, 0.5 * 2 / block_mass * domain.clock.time * domain.clock.time, 1e-9 * moved.y);
  EXPECT_NEAR(domain.rigid_bodies[0].reaction.x, -1, 1e-12);
  EXPECT_NEAR(domain.rigid_bodies[0].reaction.z, -3, 1e-12);
}

/// A point that slides along a line in space, and a turn about it.
TEST(RigidBody, AxesHeldInSpaceLeaveALineAndATurnAboutIt) {
  model::Model model = block();
  model::RigidBody& body = model.rigid_bodies[0];
  const double c = std::cos(0.6);
  const double s = std::sin(0.6);
  body.held_axes = {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
  body.fixed_translation = {false, true, true};
  body.fixed_rotation = {false, true, true};
  const Index curve = test::add_constant_curve(model, 1.0);
  const Vec3 force{1, 2, 3};
  const Vec3 moment{4, -3, 2};
  model.rigid_body_loads.push_back({.body = 0,
                                    .force = {force.x, force.y, force.z},
                                    .moment = {moment.x, moment.y, moment.z},
                                    .curve = curve});
  model.control.end_time = 0.2;
  timeloop::Simulation simulation(model, test::execution());
  const Vec3 start = simulation.domain().rigid_bodies[0].centre;
  const Vec3 line{c, s, 0};
  // The body turns about the line: its inertia about the line stays what it is.
  const double inertia = dot(line, constraints::inertia_tensor(simulation.domain().rigid_bodies[0],
                                                               simulation.domain().rigid_bodies[0].turn) *
                                       line);
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const domain::RigidBody& moved = domain.rigid_bodies[0];
  const double time = domain.clock.time;
  const Vec3 path = moved.centre - start;
  const double expected = 0.5 * dot(force, line) / block_mass * time * time;
  EXPECT_NEAR(dot(path, line), expected, 1e-9 * expected);
  EXPECT_LT(norm(path - dot(path, line) * line), 1e-12 * expected);
  const double spin = dot(moment, line) / inertia * (time + 0.5 * simulation.next_step());
  EXPECT_LT(norm(moved.spin - spin * line), 1e-9 * std::fabs(spin));
  EXPECT_LT(norm(moved.reaction + force - dot(force, line) * line), 1e-12);
  // The kinetic energy of time zero is not in product form, once (as under a constant force).
  const double step = domain.clock.step;
  const double at_start =
      step * step / 8 *
      (dot(force, line) * dot(force, line) / block_mass + dot(moment, line) * dot(moment, line) / inertia);
  EXPECT_NEAR(std::fabs(domain.energy.imbalance()), at_start, 1e-3 * at_start);
}

TEST(RigidBody, GivenInertiaGoesBeforeThatOfTheNodes) {
  model::Model model = block();
  model::RigidInertia inertia;
  inertia.mass = 2;
  inertia.centre = {1, 2, 3};
  inertia.tensor = {5, 1, 0, 6, 0, 7};
  inertia.velocity = {4, 0, 0};
  inertia.angular_velocity = {0, 0, 0.1};
  model.rigid_bodies[0].inertia = inertia;
  timeloop::Simulation simulation(model, test::execution());
  const domain::RigidBody& body = simulation.domain().rigid_bodies[0];
  EXPECT_EQ(body.mass, 2);
  EXPECT_EQ(norm(body.centre - Vec3{1, 2, 3}), 0);
  const double root = std::sqrt(0.25 + 1);
  Vec3 moments = body.principal_inertia;
  double sorted[3] = {moments.x, moments.y, moments.z};
  std::sort(sorted, sorted + 3);
  EXPECT_NEAR(sorted[0], 5.5 - root, 1e-13);
  EXPECT_NEAR(sorted[1], 5.5 + root, 1e-13);
  EXPECT_NEAR(sorted[2], 7, 1e-13);
  EXPECT_NEAR(body.spin.z, 0.1, 1e-15);
  EXPECT_NEAR(body.kinetic_energy, 0.5 * (2 * 16 + 7 * 0.01), 1e-12);
  double mass = 0;
  for (const double nodal : simulation.domain().nodes.mass) mass += nodal;
  EXPECT_NEAR(mass, 2, 1e-12);
}

TEST(RigidBody, InitialMotionGoesBeforeThatOfItsNodesAndOfItsInertia) {
  for (const bool given : {false, true}) {
    model::Model model = block();
    if (given) {
      model::RigidInertia inertia;
      inertia.mass = 2;
      inertia.centre = {1, 2, 3};
      inertia.tensor = {5, 1, 0, 6, 0, 7};
      inertia.velocity = {4, 0, 0};
      model.rigid_bodies[0].inertia = inertia;
    }
    for (Index i = 0; i < model.nodes.count(); ++i)
      model.initial_velocities.push_back({.node = i, .velocity = {9, 8, 7}});
    model.rigid_bodies[0].initial_motion = model::RigidMotion{{1, 2, 3}, {0.1, -0.2, 0.3}};
    timeloop::Simulation simulation(model, test::execution());
    const domain::Domain& domain = simulation.domain();
    const domain::RigidBody& body = domain.rigid_bodies[0];
    EXPECT_LT(norm(body.velocity - Vec3{1, 2, 3}), 1e-14);
    EXPECT_LT(norm(body.spin - Vec3{0.1, -0.2, 0.3}), 1e-14);
    const Vec3 at_corner = Vec3{1, 2, 3} + cross(body.spin, domain.nodes.position[0] - body.centre);
    EXPECT_LT(norm(domain.nodes.velocity[0] - at_corner), 1e-13);
    const double energy = 0.5 * (body.mass * 14 + dot(body.spin, body.angular_momentum));
    EXPECT_NEAR(body.kinetic_energy, energy, 1e-12 * energy);
  }
}

TEST(RigidBody, GivenInertiaMayMoveAsItsNodesDo) {
  model::Model model = block();
  model::RigidInertia inertia;
  inertia.mass = 2;
  inertia.centre = {1, 2, 3};
  inertia.tensor = {5, 1, 0, 6, 0, 7};
  inertia.velocity = {4, 0, 0};
  inertia.velocity_from_nodes = true;
  model.rigid_bodies[0].inertia = inertia;
  const Vec3 spin{0.1, -0.2, 0.3};
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    const Vec3 v = Vec3{0, 5, 0} + cross(spin, Vec3{x[0], x[1], x[2]});
    model.initial_velocities.push_back({.node = i, .velocity = {v.x, v.y, v.z}});
  }
  timeloop::Simulation simulation(model, test::execution());
  const domain::RigidBody& body = simulation.domain().rigid_bodies[0];
  EXPECT_LT(norm(body.spin - spin), 1e-14);
  EXPECT_LT(norm(body.velocity - (Vec3{0, 5, 0} + cross(spin, Vec3{1, 2, 3}))), 1e-13);
}

}  // namespace
}  // namespace crumple::rigid_body_test
