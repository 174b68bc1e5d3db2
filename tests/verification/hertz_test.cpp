// SPDX-License-Identifier: BSD-3-Clause
//
// An elastic ball meets a fixed plate, which is half of the meeting of two equal balls. By Hertz's theory
// (S.P. Timoshenko, J.N. Goodier, Theory of Elasticity, chapter on the pressure between two spherical bodies;
// K.L. Johnson, Contact Mechanics, 1985, sections 4.2 and 11.4), which takes the contact as static and small
// against the ball,
//
//   F = 4/3 E* sqrt(R) d^(3/2),   E* = E / (1 - nu^2),   d_max = (15 m v^2 / (16 E* sqrt(R)))^(2/5),
//   duration 2.87 (m^2 / (R E*^2 v))^(1/5) = 2.94 d_max / v.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "support/conservation.hpp"
#include "support/drawn.hpp"
#include "support/larger.hpp"
#include "support/rigid.hpp"
#include "support/shapes.hpp"
#include "support/verified.hpp"

namespace crumple::hertz_test {
namespace {

constexpr double radius = 10;
constexpr double young = 210;
constexpr double poisson = 0.3;
constexpr double density = 7.85e-6;

/// What Hertz says of a quarter of a ball that meets a plane, which has a quarter of its mass and of the
/// force.
struct Hertz {
  double approach = 0;
  double duration = 0;
  double coefficient = 0;  ///< force over d^(3/2)

  Hertz(double mass, double speed) {
    const double modulus = young / (1 - poisson * poisson);
    approach = std::pow(15 * 4 * mass * speed * speed / (16 * modulus * std::sqrt(radius)), 0.4);
    coefficient = 0.25 * 4.0 / 3 * modulus * std::sqrt(radius);
    duration = 2.87 * std::pow(16 * mass * mass / (radius * modulus * modulus * speed), 0.2);
  }
  double force(double at) const { return at > 0 ? coefficient * at * std::sqrt(at) : 0; }
};

constexpr double gap = 1e-3;

/// Adds a quarter of a ball that moves against the plane z = 0 and will touch it with its pole; `side` is 1
/// above and -1 below. The mesh is a cube drawn out to the ball whose elements are gathered at that pole.
void add_quarter_ball(model::Model& model, Index part, Index cells, double side, double speed) {
  // Even and fine beside the pole, coarse at the other end.
  const auto gathered = [](double a) { return 0.15 * a + 0.85 * a * a * a * a * a; };
  const Index first = test::add_box(model, part, cells, cells, 2 * cells, [=](double u, double v, double w) {
    const double up = w < 0.5 ? gathered(2 * w) - 1 : 2 * w - 1;
    const double share = 0.5 * (1 - up);
    const auto spread = [&](double a) { return share * gathered(a) + (1 - share) * a; };
    const test::Point x = test::in_ball(radius, {spread(u), spread(v), up});
    // The lower one is turned about the line x = y, so that its elements are not inside out.
    return side > 0 ? test::Point{x[0], x[1], radius + gap + x[2]}
                    : test::Point{x[1], x[0], -radius - gap - x[2]};
  });
  for (Index i = first; i < model.nodes.count(); ++i) {
    const test::Point& x = model.nodes.position[i];
    if (x[0] == 0 || x[1] == 0)
      model.fixed_nodes.push_back({.node = i, .translation = {x[0] == 0, x[1] == 0, false}});
  }
  test::set_moving(model, first, {0, 0, -side * speed});
}

/// A quarter of a ball of 2 cells^3 elements above a fixed plate or, if `other` is not zero, above another
/// ball. Elastic waves need no bulk viscosity; with it the stable step of the smallest element would change
/// to and fro with its vibration, which adds energy to it.
///
/// Penalty stiffness: a layer of elements of height h bears p = SLSFAC K d / h, which adds d to the approach.
/// The smaller the elements under the pole, the smaller it is; with SLSFAC = 3 it is small enough, for
/// which the step must be smaller than usual (docs/theory/contact.md, stability).
model::Model quarter_ball(Index cells, Index other, double speed) {
  model::Model model = test::one_solid_part(
      {.id = 1, .title = "steel", .density = density, .law = model::Elastic{young, poisson}});
  model.solid_sections[0].formulation = model::SolidFormulation::SelectiveHexahedron;
  add_quarter_ball(model, 0, cells, 1, speed);
  const Index below = model.nodes.count();
  const Index part = test::add_solid_part(model);
  if (other > 0) {
    add_quarter_ball(model, part, other, -1, speed);
  } else {
    test::add_box(model, part, 1, 1, 1, [](double u, double v, double w) {
      return test::Point{8 * u - 4, 8 * v - 4, 4 * w - 4};
    });
    test::hold(model, below, model.nodes.count());
  }
  model.control.contact_stiffness_scale = 3;
  model.control.step_scale = 0.5;
  model.control.bulk_linear = model.control.bulk_quadratic = 0;
  model.control.end_time = 1;
  test::touch_all(model);
  return model;
}

/// The upper ball as a whole, at one time.
struct Motion {
  double mass = 0;
  double approach = 0;
  double momentum = 0;
  double force = 0;

  explicit Motion(const domain::Domain& domain) {
    const domain::NodeFields& nodes = domain.nodes;
    for (Index i = 0; i < nodes.count(); ++i) {
      if (nodes.reference[i].z <= 0) continue;
      mass += nodes.mass[i];
      approach -= nodes.mass[i] * (nodes.position[i].z - nodes.reference[i].z);
      momentum += nodes.mass[i] * nodes.velocity[i].z;
      force += domain.contact_force[i].z;
    }
    approach /= mass;
  }
};

/// All over what Hertz says.
struct Impact {
  double duration = 0;
  double approach = 0;   ///< largest
  double force = 0;      ///< largest
  double deviation = 0;  ///< of the force from that at the approach, largest, over the largest force
  double mean_deviation = 0;
  double rebound = 0;              ///< velocity over that before
  double imbalance = 0;            ///< of energy, largest, over the initial one
  double pressed = 0;              ///< largest penetration over the largest approach
  test::Points force_at_approach;  ///< of the whole ball [micrometre, kN]
  test::Points exact;
};

/// Mean force and approach over a twentieth of the duration: nodes come into contact one after the other, and
/// each rings when it does.
class Curve {
 public:
  Curve(const Hertz& exact, Impact& found) : exact_(&exact), found_(&found) {}

  void add(const Motion& motion, double step) {
    time_ += step;
    force_ += motion.force * step;
    accepted_ += exact_->force(motion.approach - gap) * step;
    approach_ += (motion.approach - gap) * step;
    if (time_ < exact_->duration / 20) return;
    const double largest = exact_->force(exact_->approach);
    const double deviation = std::fabs(force_ - accepted_) / time_ / largest;
    found_->force = test::larger_of(found_->force, force_ / time_ / largest);
    found_->deviation = test::larger_of(found_->deviation, deviation);
    found_->mean_deviation += 0.05 * deviation;
    found_->force_at_approach.push_back({1e3 * approach_ / time_, 4 * force_ / time_});
    time_ = force_ = accepted_ = approach_ = 0;
  }

 private:
  const Hertz* exact_;
  Impact* found_;
  double time_ = 0;
  double force_ = 0;
  double accepted_ = 0;
  double approach_ = 0;
};

Impact strike(Index cells, Index other, double speed) {
  const model::Model model = quarter_ball(cells, other, speed);
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  const Hertz exact(Motion(domain).mass, speed);
  Impact found;
  Curve curve(exact, found);
  test::Conservation kept;
  double began = 0;
  double ended = 0;
  simulation.start();
  while (domain.clock.time < 1.2 * exact.duration) {
    simulation.step();
    kept.watch(domain);
    const Motion motion(domain);
    curve.add(motion, domain.clock.step);
    if (motion.force > 0) ended = domain.clock.time;
    if (began == 0) began = ended;
    found.approach = test::larger_of(found.approach, (motion.approach - gap) / exact.approach);
    found.pressed = test::larger_of(found.pressed, domain.contacts[0].penetration / exact.approach);
    found.rebound = motion.momentum / motion.mass / speed;
  }
  for (int i = 0; i <= 50; ++i) {
    const double at = exact.approach * i / 50;
    found.exact.push_back({1e3 * at, 4 * exact.force(at)});
  }
  found.duration = (ended - began) / exact.duration;
  found.imbalance = kept.worst_imbalance;
  std::printf(
      "%d cells on %d, a / R %.3f: duration %.4f, approach %.4f, force %.4f, curve off by %.4f (mean %.4f), "
      "rebound %.4f, "
      "energy %.1e, penetration / approach %.3f, %ld cycles\n",
      cells, other, std::sqrt(exact.approach / radius), found.duration, found.approach, found.force,
      found.deviation, found.mean_deviation, found.rebound, found.imbalance, found.pressed,
      domain.clock.cycle);
  return found;
}

void expect_hertz(const std::string& mesh, const Impact& found, double curve) {
  const char* const hertz = "Hertz";
  const std::string ball = "steel ball of " + mesh + " elements on a plate: ";
  test::verified(ball + "duration over exact", hertz).near(found.duration, 1, 0.03);
  test::verified(ball + "largest approach over exact", hertz).near(found.approach, 1, 0.03);
  test::verified(ball + "largest force over exact", hertz).near(found.force, 1, 0.03);
  test::verified(ball + "force at the approach, worst deviation", hertz).below(found.deviation, curve);
  EXPECT_NEAR(found.rebound, 1, 0.001);
  EXPECT_LT(found.imbalance, 1e-4);
}

constexpr double speed = 7;

/// Four elements over the radius of contact.
TEST(HertzSlow, BallOnPlate) {
  const Impact found = strike(8, 0, speed);
  expect_hertz("8 x 8 x 16", found, 0.03);
  test::drawn("Steel ball on a plate, loading and unloading", "approach [micrometre]", "force [kN]")
      .accepted("Hertz", found.exact)
      .found("8 x 8 x 16 elements", found.force_at_approach)
      .note();
}

/// Six elements over the radius of contact. What is left is of the order of a / R: Hertz's half-space is no
/// ball.
TEST(HertzNightly, BallOnPlateOfAFinerMesh) {
  expect_hertz("12 x 12 x 24", strike(12, 0, speed), 0.035);
}

/// Two balls whose meshes do not match. Nodes of each press on the other's facets, which lie inside of its
/// sphere: the force is a little larger than Hertz's.
TEST(HertzSlow, BallOnBall) {
  const Impact found = strike(8, 7, speed);
  const char* const hertz = "Hertz";
  test::verified("steel ball on a ball: duration over exact", hertz).near(found.duration, 1, 0.03);
  test::verified("steel ball on a ball: largest approach over exact", hertz).near(found.approach, 1, 0.03);
  test::verified("steel ball on a ball: largest force over exact", hertz).near(found.force, 1, 0.05);
  test::verified("steel ball on a ball: force at the approach, worst deviation", hertz)
      .below(found.deviation, 0.08);
  // The masses of the two differ by 0.4 %.
  EXPECT_NEAR(found.rebound, 1, 0.006);
  EXPECT_LT(found.imbalance, 1e-4);
}

}  // namespace
}  // namespace crumple::hertz_test
