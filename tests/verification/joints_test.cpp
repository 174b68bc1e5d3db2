// SPDX-License-Identifier: BSD-3-Clause
//
// Joints between rigid bodies in whole runs, against the equations of motion of what they leave free.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "constraints/rigid_motion.hpp"
#include "support/larger.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::joints_test {
namespace {

using math::Vec3;
using model::JointKind;

constexpr std::array<bool, 3> all{true, true, true};

test::Point point(const Vec3& x) {
  return {x.x, x.y, x.z};
}

/// Rigid blocks that joints connect; kg, mm, ms.
struct Machine {
  model::Model model = test::one_solid_part(test::elastic_steel());

  /// A block with these edges along three axes. Returns the index of the body.
  Index add_block(const Vec3& centre, const Vec3& size, const math::Matrix3& axes = math::unit_matrix()) {
    const auto part = static_cast<Index>(model.rigid_bodies.size());
    if (part > 0)
      model.parts.push_back({.id = part + 1, .title = "block", .solid_section = 0, .material = 0});
    test::add_box(model, part, 2, 2, 2, [&](double u, double v, double w) {
      return point(centre + axes * Vec3{(u - 0.5) * size.x, (v - 0.5) * size.y, (w - 0.5) * size.z});
    });
    test::make_rigid(model, part);
    return part;
  }

  /// A block that is held in space.
  Index add_ground(const Vec3& centre) {
    const Index body = add_block(centre, {20, 20, 20});
    model.rigid_bodies[body].fixed_translation = all;
    model.rigid_bodies[body].fixed_rotation = all;
    return body;
  }

  /// A node of a body, without mass.
  Index attach(Index body, const Vec3& place) {
    const Index node = model.nodes.count();
    model.nodes.id.push_back(node + 1);
    model.nodes.position.push_back(point(place));
    model.rigid_bodies[body].nodes.push_back(node);
    return node;
  }

  /// A joint whose pairs of nodes are at these places.
  model::Joint& join(JointKind kind, Index first, Index second, std::initializer_list<Vec3> places) {
    model::Joint joint;
    joint.id = static_cast<UserId>(model.joints.size()) + 1;
    joint.kind = kind;
    std::size_t i = 0;
    for (const Vec3& place : places) {
      joint.node[i++] = attach(first, place);
      joint.node[i++] = attach(second, place);
    }
    model.joints.push_back(joint);
    return model.joints.back();
  }

  /// Sets a body in motion: velocity of a point and angular velocity.
  void throw_body(Index body, const Vec3& through, const Vec3& velocity, const Vec3& spin) {
    for (const Index node : model.rigid_bodies[body].nodes) {
      const auto& x = model.nodes.position[static_cast<std::size_t>(node)];
      const Vec3 v = velocity + cross(spin, Vec3{x[0], x[1], x[2]} - through);
      model.initial_velocities.push_back(
          {.node = node, .velocity = point(v), .angular_velocity = point(spin)});
    }
  }

  void add_gravity(int axis, double size) {
    model.body_loads.push_back({.axis = axis, .curve = test::add_constant_curve(model, size)});
  }
};

/// Moment of inertia of a body about an axis through its centre.
double inertia_about(const domain::RigidBody& body, const Vec3& axis) {
  return dot(axis, constraints::inertia_tensor(body, body.turn) * axis);
}

/// Angle of a pendulum that starts at rest, by the Runge-Kutta method in steps without error here:
/// angle'' = -factor sin(angle).
double pendulum_angle(double factor, double start, double time) {
  constexpr int steps = 4000;
  const double h = time / steps;
  double angle = start;
  double speed = 0;
  const auto slope = [&](double at) { return -factor * std::sin(at); };
  for (int i = 0; i < steps; ++i) {
    const double k1 = slope(angle);
    const double k2 = slope(angle + 0.5 * h * speed);
    const double k3 = slope(angle + 0.5 * h * (speed + 0.5 * h * k1));
    const double k4 = slope(angle + h * (speed + 0.5 * h * k2));
    angle += h * speed + h * h / 6 * (k1 + k2 + k3);
    speed += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return angle;
}

constexpr double arm = 50;

/// A block on an arm that starts horizontally and falls along -y about the z axis.
Machine pendulum(JointKind kind, double stiffness_scale) {
  Machine machine;
  const Index ground = machine.add_ground({-arm, 0, 0});
  const Index block = machine.add_block({arm, 0, 0}, {20, 10, 10});
  const Vec3 next{0, 0, 40};
  model::Joint& joint = kind == JointKind::Spherical ? machine.join(kind, ground, block, {Vec3{}})
                                                     : machine.join(kind, ground, block, {Vec3{}, next});
  joint.stiffness_scale = stiffness_scale;
  machine.add_gravity(1, 1.0);
  machine.model.control.end_time = 20;
  return machine;
}

class Pendulum : public ::testing::TestWithParam<std::pair<JointKind, double>> {};

TEST_P(Pendulum, SwingsAsItsEquationSays) {
  const auto [kind, scale] = GetParam();
  const Machine machine = pendulum(kind, scale);
  timeloop::Simulation simulation(machine.model, test::execution());
  const domain::Domain& domain = simulation.domain();
  const domain::RigidBody& body = domain.rigid_bodies[1];
  const double inertia = inertia_about(body, {0, 0, 1}) + body.mass * arm * arm;
  double imbalance = 0;
  double first = 0;
  double opening = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    opening = test::larger_of(opening, now.joints[0].opening);
    if (now.clock.cycle == 1) first = now.energy.imbalance();
    if (now.clock.cycle > 1)
      imbalance = test::larger_of(imbalance, std::fabs(now.energy.imbalance() - first));
  });
  // From the vertical, which is -y.
  const double exact = pendulum_angle(body.mass * arm / inertia, 0.5 * std::numbers::pi, domain.clock.time);
  const double angle = std::atan2(body.centre.x, -body.centre.y);
  EXPECT_LT(exact, -0.5) << "it has swung to the other side";
  const std::string name = std::string(kind == JointKind::Spherical ? "spherical" : "revolute") +
                           " joint, pendulum, RPS " + test::figure(scale) + ": ";
  test::verified(name + "angle after half a swing [rad]", "equation of the compound pendulum")
      .near(angle, exact, scale > 1 ? 2e-5 : 4e-4);
  test::verified(name + "change of the energy balance over the energy", "conservation")
      .below(imbalance / (body.mass * arm), 1e-12);
  // The points of a revolute joint are at one side of the block: it tilts as they give way.
  constexpr double apart = 40;
  EXPECT_LT(std::fabs(body.centre.z), kind == JointKind::Spherical ? 1e-9 : 2 * opening * arm / apart);
  EXPECT_GT(domain.joints[0].opening, 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Pendulum,
                         ::testing::Values(std::pair{JointKind::Spherical, 1.0},
                                           std::pair{JointKind::Spherical, 20.0},
                                           std::pair{JointKind::Revolute, 1.0}));

TEST(SphericalJoint, ATopPrecessesSteadily) {
  Machine machine;
  const double tilt = 0.6;
  const Vec3 axis{std::sin(tilt), 0, std::cos(tilt)};
  const Vec3 across{std::cos(tilt), 0, -std::sin(tilt)};
  const Index ground = machine.add_ground({0, 0, -40});
  const double height = 30;
  const Index top = machine.add_block(height * axis, {20, 20, 10}, {{across, cross(axis, across), axis}});
  machine.join(JointKind::Spherical, ground, top, {Vec3{}}).stiffness_scale = 20;
  const double gravity = 1;
  machine.add_gravity(2, gravity);
  double own = 0;
  double transverse = 0;
  double mass = 0;
  {
    const timeloop::Simulation trial(machine.model, test::execution());
    const domain::RigidBody& body = trial.domain().rigid_bodies[1];
    mass = body.mass;
    own = inertia_about(body, axis);
    transverse = inertia_about(body, across) + mass * height * height;
  }
  // H. Goldstein, Classical Mechanics, section 5.7: m g l = W (I3 w3 - I1 W cos tilt).
  const double precession = 0.4;
  const double spin = (mass * gravity * height / precession + transverse * precession * std::cos(tilt)) / own;
  machine.throw_body(top, {}, {}, precession * Vec3{0, 0, 1} + (spin - precession * std::cos(tilt)) * axis);
  machine.model.control.end_time = 20;
  timeloop::Simulation simulation(machine.model, test::execution());
  const domain::RigidBody& body = simulation.domain().rigid_bodies[1];
  double nodding = 0;
  test::run(simulation, [&](const domain::Domain&) {
    nodding = test::larger_of(
        nodding, std::fabs(std::atan2(std::hypot(body.centre.x, body.centre.y), body.centre.z) - tilt));
  });
  const double turned = precession * simulation.domain().clock.time - 2 * std::numbers::pi;
  test::verified("spherical joint, spinning top: precession after 8 rad [rad]", "Goldstein, 5.7")
      .near(std::atan2(body.centre.y, body.centre.x), turned, 2e-4);
  test::verified("spherical joint, spinning top: largest change of its tilt [rad]", "Goldstein, 5.7")
      .below(nodding, 1e-5);
}

/// Momentum, and its moment about the origin.
std::array<Vec3, 2> momenta(const domain::Domain& domain) {
  std::array<Vec3, 2> sum{};
  for (const domain::RigidBody& body : domain.rigid_bodies) {
    const Vec3 momentum = body.mass * body.velocity;
    sum[0] += momentum;
    sum[1] += cross(body.centre, momentum) + body.angular_momentum;
  }
  return sum;
}

class FlyingPair : public ::testing::TestWithParam<JointKind> {};

TEST_P(FlyingPair, KeepsItsMomentaAndItsEnergy) {
  Machine machine;
  const Index first = machine.add_block({-30, 0, 0}, {40, 10, 20});
  const Index second = machine.add_block({30, 10, 0}, {40, 20, 10});
  const Vec3 at{0, 5, 0};
  model::Joint& joint =
      machine.join(GetParam(), first, second, {at, at + Vec3{10, 20, 5}, at + Vec3{0, 0, 20}});
  if (GetParam() == JointKind::Universal)
    machine.model.nodes.position[static_cast<std::size_t>(joint.node[3])] = point(at + Vec3{-20, 10, 0});
  // Both with the same velocity at the joint; what it leaves free they turn against each other.
  const Vec3 spin{0.3, 0.1, -0.2};
  const Vec3 relative = GetParam() == JointKind::Spherical ? Vec3{0.2, -0.3, 0.1}
                        : GetParam() == JointKind::Revolute || GetParam() == JointKind::Cylindrical
                            ? 0.01 * Vec3{10, 20, 5}
                            : Vec3{};
  const Vec3 sliding = GetParam() == JointKind::Cylindrical || GetParam() == JointKind::Translational
                           ? 0.05 * Vec3{10, 20, 5}
                           : Vec3{};
  machine.throw_body(first, at, {1, -2, 0.5}, spin);
  machine.throw_body(second, at, Vec3{1, -2, 0.5} + sliding, spin + relative);
  machine.model.control.end_time = 10;
  timeloop::Simulation simulation(machine.model, test::execution());
  std::array<Vec3, 2> start{};
  double change = 0;
  double imbalance = 0;
  double offset = 0;
  double opening = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    const std::array<Vec3, 2> sum = momenta(now);
    if (now.clock.cycle == 0) start = sum;
    if (now.clock.cycle == 1) offset = now.energy.imbalance();
    for (std::size_t i = 0; i < 2; ++i)
      change = test::larger_of(change, norm(sum[i] - start[i]) / norm(start[i]));
    if (now.clock.cycle > 0)
      imbalance = test::larger_of(imbalance, std::fabs(now.energy.imbalance() - offset));
    opening = test::larger_of(opening, now.joints[0].opening);
  });
  constexpr const char* names[] = {"spherical",     "revolute",  "cylindrical",
                                   "translational", "universal", "locking"};
  const domain::Domain& domain = simulation.domain();
  const std::string name = std::string(names[static_cast<int>(GetParam())]) + " joint of two flying bodies: ";
  test::verified(name + "change of both momenta", "conservation").below(change, 1e-12);
  test::verified(name + "change of the energy balance over the energy", "conservation")
      .below(imbalance / domain.energy.initial_total, 1e-12);
  // m omega^2 r over k, with omega^2 = 0.14, r = 30, 0.64e-6 for dt^2 and w* below 186 / m.
  test::verified(name + "largest opening [mm]", "none").below(opening, 0.0125);
  // What remains free goes on: the damping acts on the penalty alone.
  EXPECT_LT(domain.joints[0].damping_energy, 1e-4 * domain.energy.initial_total);
  EXPECT_GT(domain.energy.kinetic, 0.999 * domain.energy.initial_total);
}

INSTANTIATE_TEST_SUITE_P(Kinds, FlyingPair,
                         ::testing::Values(JointKind::Spherical, JointKind::Revolute, JointKind::Cylindrical,
                                           JointKind::Translational, JointKind::Universal,
                                           JointKind::Locking));

TEST(CylindricalJoint, SlidesAndTurnsFreelyAndCarriesTheWeight) {
  Machine machine;
  const Index ground = machine.add_ground({-40, 0, 0});
  const Index block = machine.add_block({20, 0, 0}, {20, 10, 10});
  machine.join(JointKind::Cylindrical, ground, block, {Vec3{}, Vec3{40, 0, 0}});
  machine.throw_body(block, {20, 0, 0}, {2, 0, 0}, {0.5, 0, 0});
  machine.add_gravity(1, 1.0);
  machine.model.control.end_time = 5;
  timeloop::Simulation simulation(machine.model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const domain::RigidBody& body = domain.rigid_bodies[1];
  test::verified("cylindrical joint: displacement along the axis over velocity times time", "exact")
      .near((body.centre.x - 20) / (2 * domain.clock.time), 1, 1e-9);
  EXPECT_NEAR(body.spin.x, 0.5, 1e-6);
  EXPECT_LT(std::hypot(body.centre.y, body.centre.z), 1e-2);
  // Pulls the ground down, about its first node with the arm that the block has slid to.
  test::verified("cylindrical joint: force over the weight", "equilibrium")
      .near(domain.joints[0].force.y / -body.mass, 1, 1e-3);
  test::verified("cylindrical joint: moment over weight times arm", "equilibrium")
      .near(domain.joints[0].moment.z / (-body.mass * body.centre.x), 1, 1e-3);
  EXPECT_NEAR(domain.joints[0].force.x, 0, 1e-3 * body.mass);
}

TEST(TranslationalJoint, FallsAlongItsAxisAndDoesNotTurn) {
  Machine machine;
  const Index ground = machine.add_ground({0, -40, 0});
  const Index block = machine.add_block({0, 30, 0}, {20, 10, 10});
  const Vec3 axis{0, 0.6, 0.8};
  machine.join(JointKind::Translational, ground, block, {Vec3{}, 40 * axis, Vec3{30, 0, 0}});
  machine.add_gravity(1, 1.0);
  machine.model.control.end_time = 5;
  timeloop::Simulation simulation(machine.model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const domain::RigidBody& body = domain.rigid_bodies[1];
  const double way = dot(body.centre - Vec3{0, 30, 0}, axis);
  test::verified("translational joint: way down a slope over g sin / 2 t^2", "exact")
      .near(way / (-0.5 * 0.6 * domain.clock.time * domain.clock.time), 1, 1e-4);
  EXPECT_LT(norm(body.centre - Vec3{0, 30, 0} - way * axis), 2e-2);
  EXPECT_LT(norm(body.spin), 1e-3);
}

TEST(UniversalJoint, TurnsAsCardanShaftsDo) {
  Machine machine;
  const double bend = 0.5;
  const Vec3 along{std::cos(bend), std::sin(bend), 0};
  const Vec3 across{-std::sin(bend), std::cos(bend), 0};
  const Index first = machine.add_block({-40, 0, 0}, {40, 10, 10});
  const Index second = machine.add_block(40 * along, {40, 10, 10}, {{along, across, Vec3{0, 0, 1}}});
  for (const Index shaft : {first, second}) {
    model::RigidBody& body = machine.model.rigid_bodies[shaft];
    body.fixed_translation = all;
    body.fixed_rotation = {false, true, true};
  }
  machine.model.rigid_bodies[second].held_axes = {point(along), point(across), point({0, 0, 1})};
  model::Joint& joint = machine.join(JointKind::Universal, first, second, {Vec3{}, Vec3{0, 0, 20}});
  machine.model.nodes.position[static_cast<std::size_t>(joint.node[3])] = point(20 * across);
  joint.stiffness_scale = 20;
  const double speed = 0.5;
  const Index curve = test::add_constant_curve(machine.model, speed);
  machine.model.prescribed_motions.push_back({.body = first, .axis = 0, .rotation = true, .curve = curve});
  machine.throw_body(first, {}, {}, {speed, 0, 0});
  machine.throw_body(second, {}, {}, speed * std::cos(bend) * along);
  machine.model.control.end_time = 15;
  timeloop::Simulation simulation(machine.model, test::execution());
  const domain::Domain& domain = simulation.domain();
  double error = 0;
  double least = 10;
  double largest = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    // H.H. Mabie, C.F. Reinholtz, Mechanisms and Dynamics of Machinery, section 4.12.
    const double angle = speed * (now.clock.time + 0.5 * simulation.next_step());
    const double sine = std::sin(bend) * std::sin(angle);
    const double ratio = std::cos(bend) / (1 - sine * sine);
    const double found = dot(now.rigid_bodies[1].angular_velocity, along) / speed;
    error = test::larger_of(error, std::fabs(found - ratio));
    least = std::min(least, found);
    largest = test::larger_of(largest, found);
  });
  test::verified("universal joint: ratio of the angular velocities, largest error", "Cardan")
      .below(error, 1e-5);
  test::verified("universal joint: smallest ratio", "cos of the bend").near(least, std::cos(bend), 1e-5);
  test::verified("universal joint: largest ratio", "1 / cos of the bend")
      .near(largest, 1 / std::cos(bend), 1e-5);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-4 * domain.energy.initial_total);
}

TEST(LockingJoint, MakesOneBodyOfTwo) {
  const auto thrown = [](bool locked) {
    Machine machine;
    const Index first = machine.add_block({-30, 0, 0}, {40, 10, 20});
    const Index second = machine.add_block({30, 10, 0}, {40, 20, 10});
    for (const Index body : {first, second}) machine.throw_body(body, {}, {1, 0, 0}, {0.3, 0.1, -0.2});
    if (locked) {
      machine.join(JointKind::Locking, first, second, {Vec3{}, Vec3{0, 30, 0}, Vec3{0, 0, 30}})
          .stiffness_scale = 20;
    } else {
      model::RigidBody& one = machine.model.rigid_bodies[0];
      const model::RigidBody other = machine.model.rigid_bodies[1];
      one.parts.push_back(1);
      one.nodes.insert(one.nodes.end(), other.nodes.begin(), other.nodes.end());
      machine.model.rigid_bodies.pop_back();
    }
    machine.model.control.end_time = 20;
    return machine.model;
  };
  const model::Model joined = thrown(true);
  const model::Model merged = thrown(false);
  timeloop::Simulation with_joint(joined, test::execution());
  timeloop::Simulation as_one(merged, test::execution());
  test::run(with_joint);
  test::run(as_one);
  double away = 0;
  for (Index node = 0; node < merged.nodes.count(); ++node)
    away = test::larger_of(away, norm(test::displacement(with_joint.domain(), node) -
                                      test::displacement(as_one.domain(), node)));
  EXPECT_GT(norm(test::displacement(as_one.domain(), 0)), 20);
  test::verified("locking joint: distance from where one body would be after 7 rad [mm]", "merged bodies")
      .below(away, 2e-3);
}

TEST(Joint, NodesApartMakeNoForce) {
  Machine machine;
  const Index first = machine.add_block({-30, 0, 0}, {40, 10, 20});
  const Index second = machine.add_block({30, 10, 0}, {40, 20, 10});
  model::Joint& joint = machine.join(JointKind::Revolute, first, second, {Vec3{}, Vec3{0, 30, 0}});
  machine.model.nodes.position[static_cast<std::size_t>(joint.node[1])] = {1, 0, 0};
  machine.model.control.end_time = 0.1;
  timeloop::Simulation simulation(machine.model, test::execution());
  test::run(simulation);
  // But for the last digits of places, times a penalty of some 1e3.
  EXPECT_LT(norm(simulation.domain().joints[0].force), 1e-9);
  EXPECT_LT(simulation.domain().energy.kinetic, 1e-18);
}

TEST(Joint, NeedsRigidBodies) {
  Machine machine;
  const Index first = machine.add_block({-30, 0, 0}, {40, 10, 20});
  const Index second = machine.add_block({30, 10, 0}, {40, 20, 10});
  machine.join(JointKind::Spherical, first, second, {Vec3{}});
  machine.model.rigid_bodies[second].nodes.pop_back();
  EXPECT_THROW(timeloop::Simulation(machine.model, test::execution()), Error);
}

}  // namespace
}  // namespace crumple::joints_test
