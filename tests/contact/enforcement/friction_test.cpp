// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "contact/bodies.hpp"
#include "support/drawn.hpp"
#include "support/largest.hpp"

namespace crumple::friction_test {
namespace {

using test::at;
using test::Bodies;
using test::Vec3;

constexpr double thickness = 0.1;
constexpr double depth = 0.02;

/// A tip held at a constant depth on a sheet of unit squares; stiffness and normal force in closed form.
struct Slider {
  Slider(double static_friction, double dynamic_friction, double friction_decay, double place = 0.3)
      : bodies(thickness) {
    bodies.contact.static_friction = static_friction;
    bodies.contact.dynamic_friction = dynamic_friction;
    bodies.contact.friction_decay = friction_decay;
    sheet = bodies.sheet(4, 4, [](double u, double v) { return Vec3{4 * u, 4 * v, 0}; });
    tip = bodies.node({place, 1.3, 0.2});
    const Index b = bodies.node({place, 2.3, 2.2});
    const Index c = bodies.node({place, 0.3, 2.2});
    bodies.shell(tip, b, c, c);
  }
  static double stiffness() { return 0.1 * (1000.0 / 1.5) / std::sqrt(2.0); }
  static double normal_force() { return stiffness() * depth; }

  /// Moves the tip and its triangle by `shift` in one step.
  static void shift(contact::Interface& touching, domain::Domain& made, Index tip, const Vec3& by,
                    double step) {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    for (Index n = tip; n < tip + 3; ++n) x[at(made, n)] += by;
    test::move_to(touching, made, x, step);
  }
  Bodies bodies;
  Index sheet = 0;
  Index tip = 0;
};

/// A tip pressed into the sheet to its depth.
struct Pressed {
  explicit Pressed(double friction, double place = 0.3) : slider(friction, friction, 0, place) {
    test::add_forces(touching, made);
    move({0, 0, -0.1 - depth});
  }
  void move(const Vec3& by) { Slider::shift(touching, made, slider.tip, by, 1e-3); }
  Vec3 force() const { return made.contact_force[at(made, slider.tip)]; }

  Slider slider;
  domain::Domain made = slider.bodies.build();
  contact::Interface touching = slider.bodies.attach(made);
};

/// Friction of Coulomb with an elastic stick, against a drag.
struct Drag {
  double mu;
  double limit() const { return mu * Slider::normal_force(); }
  double slip_starts() const { return limit() / Slider::stiffness(); }
  double forth(double way) const { return std::min(Slider::stiffness() * way, limit()); }
  /// After a way forth on which it slipped, and then this way back.
  double back(double way) const { return std::max(limit() - Slider::stiffness() * way, -limit()); }
  /// Steps until it slips the other way.
  int steps_back(double pace) const { return static_cast<int>(2 * slip_starts() / pace) + 2; }
};

// Dragged at constant speed across elements: f = k s until mu N, then mu N; the energy is the area below.
TEST(Friction, SticksThenSlips) {
  const Drag drag{0.3};
  Pressed tip(drag.mu);
  const double pace = 2.5e-4;
  double work = 0;
  double before = 0;
  const std::string dragged = "tip dragged over a sheet, sticking and slipping: ";
  test::Largest across(dragged + "friction over mu N, error", "Coulomb with an elastic stick", 1e-10);
  test::Largest normal(dragged + "normal force, change", "constant depth", 1e-11);
  for (int i = 1; i <= 6000; ++i) {
    tip.move({pace, 0, 0});
    const double expected = drag.forth(pace * i);
    across.compare(tip.force().x, -expected, drag.limit(), "distance " + std::to_string(pace * i));
    normal.compare(tip.force().z, Slider::normal_force());
    work += 0.5 * (before + expected) * pace;
    before = expected;
  }
  test::verified(dragged + "energy of friction over the work", "area below the force")
      .near(tip.made.contacts[0].friction_energy / work, 1, 1e-9);
  EXPECT_LT(norm(test::total_force(tip.made)), 1e-13);
  // Back again: the spring lets go over twice its stretch, then slips the other way.
  for (int i = 1; i <= drag.steps_back(pace); ++i) {
    tip.move({-pace, 0, 0});
    across.compare(tip.force().x, -drag.back(pace * i), drag.limit(), "back " + std::to_string(pace * i));
    normal.compare(tip.force().z, Slider::normal_force());
  }
  test::verified(dragged + "friction over mu N after the way back", "Coulomb")
      .near(tip.force().x / drag.limit(), 1, 1e-9);
}

TEST(Friction, ForceOverAShortWayForthAndBackIsDrawn) {
  const Drag drag{0.3};
  Pressed tip(drag.mu);
  const double pace = 2.5e-4;
  constexpr int forth = 120;
  test::Points exact;
  test::Points found;
  const auto point = [&](int i, double way, double expected) {
    exact.push_back({way, expected});
    if (i % 5 == 0) found.push_back({way, -tip.force().x});
  };
  for (int i = 1; i <= forth; ++i) {
    tip.move({pace, 0, 0});
    point(i, pace * i, drag.forth(pace * i));
  }
  for (int i = 1; i <= drag.steps_back(pace); ++i) {
    tip.move({-pace, 0, 0});
    point(i, pace * (forth - i), drag.back(pace * i));
  }
  test::drawn("Friction of a tip dragged forth and back", "way", "friction force")
      .accepted("Coulomb with an elastic stick", exact)
      .found("contact", found)
      .note();
}

// Friction acts at the node and a contact distance below it: the segment bears the couple, sticking or
// slipping.
TEST(Friction, KeepsTheMomentOfMomentum) {
  Slider slider(0.3, 0.3, 0);
  domain::Domain made = slider.bodies.build();
  made.nodes.position[at(made, slider.sheet + 7)].z += 0.05;
  contact::Interface touching = slider.bodies.attach(made);
  test::add_forces(touching, made);
  Slider::shift(touching, made, slider.tip, {0, 0, -0.09 - depth}, 1e-3);
  const std::string dragged = "tip dragged over a bent sheet with friction: ";
  test::Largest forces(dragged + "sum of all forces", "conservation of momentum", 1e-13);
  test::Largest moments(dragged + "sum of all moments", "conservation of moment of momentum", 1e-13);
  for (int i = 1; i <= 500; ++i) {
    Slider::shift(touching, made, slider.tip, {2e-4, 1e-3, 0}, 1e-3);
    const Vec3 force = made.contact_force[at(made, slider.tip)];
    ASSERT_GT(std::hypot(force.x, force.y), 1e-3 * force.z);
    forces.add(norm(test::total_force(made)));
    moments.add(norm(test::total_moment(made)));
  }
}

/// A tip that sticks to the sheet with a stretched spring.
struct Stuck : Pressed {
  explicit Stuck(double place = 0.3) : Pressed(0.6, place) { move({0.005, 0.002, 0}); }
};

// A pair that sticks while both turn together: no work is done.
TEST(Friction, DoesNoWorkInARigidRotation) {
  Stuck stuck;
  const double stored = stuck.made.contacts[0].friction_energy;
  ASSERT_GT(stored, 0);
  test::turn(stuck.touching, stuck.made, {0, 1, 0}, 1.5, 2000);
  test::verified("sticking pair turned by 1.5 rad: energy of friction over that before", "no work")
      .near(stuck.made.contacts[0].friction_energy / stored, 1, 1e-9);
}

// mu = FD + (FS - FD) exp(-DC v).
TEST(Friction, DecaysWithSpeed) {
  test::Largest off("friction at three speeds: force, error", "mu = FD + (FS - FD) exp(-DC v)", 1e-12);
  for (const double speed : {0.25, 2.5, 10.0}) {
    Slider slider(0.5, 0.1, 0.8);
    domain::Domain made = slider.bodies.build();
    contact::Interface touching = slider.bodies.attach(made);
    test::add_forces(touching, made);
    Slider::shift(touching, made, slider.tip, {0, 0, -0.1 - depth}, 1e-3);
    for (int i = 0; i < 100; ++i) Slider::shift(touching, made, slider.tip, {0, 4e-3, 0}, 4e-3 / speed);
    const double mu = 0.1 + 0.4 * std::exp(-0.8 * speed);
    off.compare(made.contact_force[at(made, slider.tip)].y, -mu * Slider::normal_force());
  }
}

// VC limits the stress: the friction force ends at VC times the area of the segment, two here.
TEST(Friction, IsLimitedByAStress) {
  Bodies bodies(thickness);
  bodies.contact.static_friction = bodies.contact.dynamic_friction = 0.5;
  bodies.contact.friction_stress = 0.05;
  bodies.sheet(4, 2, [](double u, double v) { return Vec3{4 * u, 4 * v, 0}; });
  const Index tip = bodies.node({0.3, 1.3, 0.2});
  const Index b = bodies.node({0.3, 2.3, 2.2});
  const Index c = bodies.node({0.3, 0.3, 2.2});
  bodies.shell(tip, b, c, c);
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  Slider::shift(touching, made, tip, {0, 0, -0.1 - depth}, 1e-3);
  for (int i = 0; i < 100; ++i) Slider::shift(touching, made, tip, {0, 4e-3, 0}, 1e-3);
  const Vec3 force = made.contact_force[at(made, tip)];
  EXPECT_GT(0.5 * force.z, 0.15) << "it is the stress that limits";
  test::verified("friction limited by a stress of 0.05 on an area of 2: force", "VC times area")
      .near(force.y, -0.1, 1e-12);
}

// SOFT = 1: a stiffness of 1/2 SOFSCL m* / dt^2, unless the material's is larger and still stable.
TEST(Contact, StiffnessByMassAndStep) {
  enum Governs { MassesAndStep, Material, StabilityLimit };
  constexpr const char* names[] = {"masses and step", "material", "stability limit"};
  for (const auto& [step, governs] :
       {std::pair{1e-3, MassesAndStep}, std::pair{0.05, Material}, std::pair{1.0, StabilityLimit}}) {
    Slider slider(0, 0, 0);
    slider.bodies.contact.soft_scale = 0.1;
    domain::Domain made = slider.bodies.build(2.0);
    contact::Interface touching = slider.bodies.attach(made);
    test::add_forces(touching, made);
    // To the middle of a segment, whose nodes bear a quarter each.
    Slider::shift(touching, made, slider.tip, {0.2, 0.2, -0.1 - depth}, step);
    test::settle(touching, made);
    const double by_mass = 0.5 * 0.1 * 2.0 / 1.25 / (step * step);
    const double limit = 0.35 * 2.0 / 1.25 / (step * step);
    const double expected = std::array{by_mass, Slider::stiffness(), limit}[governs];
    // It is the one that governs, and none of the others.
    ASSERT_EQ(expected, std::min(limit, std::max(by_mass, Slider::stiffness())));
    ASSERT_NE(by_mass, Slider::stiffness());
    test::verified(std::string("SOFT 1, governed by the ") + names[governs] + ": stiffness over exact",
                   "closed form")
        .near(made.contact_force[at(made, slider.tip)].z / (expected * depth), 1, 1e-9);
  }
}

// SOFT = 2: 1/2 SLSFAC SFS m1 m2 / (m1 + m2) / dt^2, whatever the material, and the same while it lasts.
TEST(Contact, StiffnessByMassesOfSegments) {
  for (const double step : {1e-3, 1.0}) {
    Slider slider(0, 0, 0);
    slider.bodies.contact.mass_stiffness = true;
    slider.bodies.contact.side[0].stiffness_scale = 0.5;
    domain::Domain made = slider.bodies.build(2.0);
    contact::Interface touching = slider.bodies.attach(made);
    test::add_forces(touching, made);
    Slider::shift(touching, made, slider.tip, {0, 0, -0.1 - depth}, step);
    test::settle(touching, made);
    const double expected = 0.5 * 0.1 * 0.5 * 1.0 / (step * step);
    test::verified(
        std::string("SOFT 2, ") + (step < 1 ? "short step" : "long step") + ": stiffness over exact",
        "masses of the segments and step")
        .near(made.contact_force[at(made, slider.tip)].z / (expected * depth), 1, 1e-9);
    Slider::shift(touching, made, slider.tip, {0, 0, 0}, 0.9 * step);
    EXPECT_NEAR(made.contact_force[at(made, slider.tip)].z, expected * depth, 1e-9 * expected);
  }
}

// PENMAX: a node that overlaps more than that of the thickness is let go; on its way back it is not thrown.
TEST(Contact, LetsGoOfNodesThatAreTooDeep) {
  Slider slider(0, 0, 0);
  slider.bodies.contact.release_depth = 0.3;
  domain::Domain made = slider.bodies.build();
  contact::Interface touching = slider.bodies.attach(made);
  test::add_forces(touching, made);
  const auto force_at = [&](double overlap) {
    const double height = made.nodes.position[at(made, slider.tip)].z;
    Slider::shift(touching, made, slider.tip, {0, 0, thickness - overlap - height}, 1e-3);
    test::settle(touching, made);
    return made.contact_force[at(made, slider.tip)].z;
  };
  EXPECT_NEAR(force_at(0.02), Slider::stiffness() * 0.02, 1e-10);
  EXPECT_NEAR(force_at(0.029), Slider::stiffness() * 0.029, 1e-10);
  EXPECT_EQ(force_at(0.031), 0);
  EXPECT_EQ(force_at(0.06), 0);
  EXPECT_EQ(force_at(0.031), 0);
  EXPECT_EQ(force_at(0.01), 0);
  EXPECT_EQ(force_at(-0.01), 0);
  EXPECT_NEAR(force_at(0.02), Slider::stiffness() * 0.02, 1e-10);
}

// A rigid rotation of both bodies together is no slip, and the friction force turns with them.
void expect_turned(double place, int steps, test::Largest& off) {
  Stuck stuck(place);
  const Vec3 start = stuck.force();
  ASSERT_LT(start.x, -0.1);
  // 120 degrees about (1, 1, 1): x -> y -> z -> x at the end.
  test::turn(stuck.touching, stuck.made, {1, 1, 1}, 2.0943951023931953, steps);
  const Vec3 end = stuck.force();
  off.compare(end.y, start.x);
  off.compare(end.z, start.y);
  off.compare(end.x, start.z);
}

TEST(Friction, RigidRotationIsNoSlip) {
  test::Largest off("sticking pair turned by 120 degrees: force, difference", "the force at first, turned",
                    1e-11);
  expect_turned(0.3, 500, off);
}

// Beyond the edge the contact point stays there, and the slip is that of the node.
TEST(Friction, RigidRotationIsNoSlipBeyondAnEdge) {
  test::Largest off("the same beyond the edge of a sheet, turned in 500 steps", "the force at first, turned",
                    1e-5);
  expect_turned(-0.01, 500, off);
}

TEST(Friction, SticksThenSlipsBeyondAnEdge) {
  Pressed beyond(0.2, -0.01);
  for (int i = 0; i < 300; ++i) beyond.move({0, 0.002, 0});
  // It slides along the edge, in the plane of which the force lies across.
  test::verified("node drawn along an edge that it is beyond: force over mu N", "Coulomb")
      .near(-beyond.force().y / std::hypot(beyond.force().x, beyond.force().z), 0.2, 1e-9);
}

// A block of one node thrown along a fixed sheet stops after v^2 / (2 mu N / m).
TEST(Friction, SlidesToRest) {
  Slider slider(0.2, 0.2, 0);
  domain::Domain made = slider.bodies.build(1.0);
  contact::Interface touching = slider.bodies.attach(made);
  test::add_forces(touching, made);
  Slider::shift(touching, made, slider.tip, {0, 0, -0.1 - depth}, 1e-3);
  const Index tip = at(made, slider.tip);
  const double speed = 0.5;
  const double step = 1e-3;
  const double force = 0.2 * Slider::normal_force();
  const double start = made.nodes.position[tip].x;
  made.nodes.velocity[tip] = {speed, 0, 0};
  for (int i = 0; i < 20000; ++i) {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    // The mass slides along x; its height is held, so that the normal force is constant.
    const double v = made.nodes.velocity[tip].x + step * made.contact_force[tip].x;
    for (Index n = slider.tip; n < slider.tip + 3; ++n) x[at(made, n)].x += step * v;
    test::move_to(touching, made, x, step);
  }
  const double travelled = made.nodes.position[tip].x - start;
  const double expected = speed * speed / (2 * force);
  // It ends in a swing on the friction spring, within the stretch at which that gives way.
  test::verified("mass thrown along a sheet with friction: way to rest", "v^2 / (2 mu N / m)")
      .near(travelled, expected, 0.005 * expected + 0.2 * depth);
}

}  // namespace
}  // namespace crumple::friction_test
