// SPDX-License-Identifier: BSD-3-Clause
// Tied contact by penalty (*CONTACT_TIED_..._OFFSET) and its failure (TIEBREAK): gaps stay, no rigid motion
// makes a force, momenta are kept, and a tie breaks at its strength.

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <utility>

#include "support/larger.hpp"
#include "support/rigid.hpp"
#include "support/tied_runs.hpp"
#include "support/verified.hpp"

namespace crumple::tie_springs_test {
namespace {

using math::Vec3;

/// Two rigid blocks that turn as one: the springs pull what the turning needs.
TEST(TieSprings, RigidBodiesTurnAsOne) {
  model::Model model = test::offset_blocks(model::TieMethod::Penalty, 2, 3, 0.5);
  const double spin = 2.0;  // rad/ms
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    model.initial_velocities.push_back(
        {.node = i, .velocity = {-spin * (x[1] - 2), spin * (x[0] - 10), 0.3}, .angular_velocity = {}});
  }
  model.control.end_time = 1.0;
  test::make_rigid(model, 0);
  test::make_rigid(model, 1);
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  const domain::Domain& domain = simulation.domain();
  const Vec3 momentum = test::momentum(domain);
  double opening = 0;
  while (!simulation.finished()) {
    simulation.step();
    opening = test::larger_of(opening, domain.ties[0].opening);
  }
  std::printf("opening %.2e, momentum %.1e, energy %.1e\n", opening,
              norm(test::momentum(domain) - momentum) / norm(momentum),
              domain.energy.imbalance() / domain.energy.initial_total);
  EXPECT_LT(opening, 2e-3);
  EXPECT_GT(opening, 0) << "the springs pull";
  EXPECT_LT(norm(test::momentum(domain) - momentum), 1e-12 * norm(momentum));
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-6 * domain.energy.initial_total);
}

TEST(TieSprings, RigidPlacementIsFreeOfForce) {
  model::Model model = test::offset_blocks(model::TieMethod::Penalty, 2, 3, 0.5);
  model.control.end_time = 1e-6;
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  domain::Domain domain = simulation.domain();
  contact::TieSprings springs(model, domain, 0);
  const double angle = 2.1;
  for (Vec3& x : domain.nodes.position)
    x = {std::cos(angle) * x.x - std::sin(angle) * x.y + 3, std::sin(angle) * x.x + std::cos(angle) * x.y - 8,
         x.z + 5};
  const auto largest_force = [&] {
    for (domain::NodeForce& force : domain.nodes.force) force = {};
    springs.add_forces(domain);
    double largest = 0;
    for (const domain::NodeForce& force : domain.nodes.force)
      for (const double component : force.force) largest = test::larger_of(largest, std::fabs(component));
    return largest;
  };
  ASSERT_FALSE(domain.ties[0].nodes.empty());
  EXPECT_LT(largest_force(), 1e-10);
  EXPECT_LT(domain.ties[0].opening, 1e-13);
  EXPECT_EQ(domain.ties[0].broken, 0);
  EXPECT_EQ(domain.ties[0].released, 0);
  domain.nodes.position[domain.ties[0].nodes[0].node].x += 1e-3;
  EXPECT_GT(largest_force(), 1e-3);
}

TEST(TieSprings, MomentaAndEnergyAreKept) {
  test::expect_kept_when_shaken(test::offset_blocks(model::TieMethod::Penalty, 2, 3, 0.5));
}

TEST(TieSprings, WavesPassTheJoint) {
  const test::Reflection found = test::reflection(test::two_bars(2, 3, model::TieMethod::Penalty));
  std::printf("reflected amplitude %.3f, energy error %.1e\n", found.amplitude, found.energy_error);
  test::verified("pulse through two bars tied by springs, 2 to 3: reflected amplitude", "by constraint 0.6 %")
      .below(found.amplitude, 0.45);
  EXPECT_LT(found.energy_error, 1e-3);
}

/// The shell joint of the constraint.
TEST(TieSprings, RotationsAreTiedWhereAsked) {
  model::Model model = test::shell_joint(true, 6);
  const test::Deflection exact = test::deflection(model);
  model.tied_contacts[0].method = model::TieMethod::Penalty;
  const test::Deflection springs = test::deflection(model);
  model.tied_contacts[0].ties_rotations = false;
  const test::Deflection hinged = test::deflection(model);
  std::printf(
      "largest deflection: constraint %.5f, springs %.5f, without rotations %.5f; energy error %.1e\n",
      exact.largest, springs.largest, hinged.largest, hinged.energy_error);
  EXPECT_NEAR(springs.largest, exact.largest, 0.25 * exact.largest);
  EXPECT_GT(hinged.largest, 2 * exact.largest);
  for (const test::Deflection& found : {exact, springs, hinged}) EXPECT_LT(found.energy_error, 0.01);
}

/// The plate of the shell joint is a rigid body that is held: the strip is clamped, and hangs on hinges where
/// rotations are free.
TEST(TieSprings, RotationsAreTiedToRigidBodies) {
  model::Model clamped = test::shell_joint(false, 6);
  for (Index i = 0; i < clamped.nodes.count(); ++i)
    if (clamped.nodes.position[i][2] == 0)
      clamped.fixed_nodes.push_back(
          {.node = i, .translation = {true, true, true}, .rotation = {true, true, true}});
  const test::Deflection exact = test::deflection(clamped);
  model::Model model = test::shell_joint(true, 6);
  model.tied_contacts[0].method = model::TieMethod::Penalty;
  model.fixed_nodes.clear();
  model::RigidBody& plate = test::make_rigid(model, 0);
  plate.fixed_translation = plate.fixed_rotation = {true, true, true};
  const test::Deflection springs = test::deflection(model);
  model.tied_contacts[0].ties_rotations = false;
  const test::Deflection hinged = test::deflection(model);
  std::printf("largest deflection: clamped %.5f, springs %.5f, without rotations %.5f\n", exact.largest,
              springs.largest, hinged.largest);
  // Springs give way by as much as in the joint above.
  test::verified("strip tied to a rigid plate by springs: deflection over that of a clamped one", "one mesh")
      .near(springs.largest / exact.largest, 1, 0.25);
  EXPECT_GT(hinged.largest, 4 * exact.largest);
  for (const test::Deflection& found : {exact, springs, hinged}) EXPECT_LT(found.energy_error, 0.01);
}

/// Stiffness of all springs of breaking_blocks(): ten times SLSFAC times the bulk modulus over the depth of
/// the elements, times the area.
constexpr double area = 16;
constexpr double stiffness = 10 * 0.1 * (test::modulus / 3) / 5 * area;

/// Two rigid blocks, joined by springs; the first is held, the second may move along x and y but not turn.
model::Model breaking_blocks(const model::TieFailure& failure) {
  model::Model model = test::two_blocks(2, 3, 2, model::TieMethod::Penalty);
  model.tied_contacts[0].failure = failure;
  model.rigid_bodies.reserve(2);
  test::make_rigid(model, 0).fixed_translation = {true, true, true};
  test::make_rigid(model, 1);
  for (model::RigidBody& body : model.rigid_bodies) body.fixed_rotation = {true, true, true};
  return model;
}

struct Break {
  double largest_force = 0;  ///< of the tie
  double opening = 0;        ///< of its springs then
  Index broken = 0;
  domain::EnergyLedger energy;
};

Break run_break(const model::Model& model) {
  timeloop::Simulation simulation(model, test::execution());
  Break found;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double force = norm(domain.ties[0].force);
    if (force <= found.largest_force) return;
    found.largest_force = force;
    found.opening = domain.ties[0].opening;
  });
  found.broken = simulation.domain().ties[0].broken;
  found.energy = simulation.domain().energy;
  return found;
}

/// Pulls the second block with velocities along x, which opens the joint, and along y [length/time].
Break pull(const model::TieFailure& failure, double tension, double shear) {
  model::Model model = breaking_blocks(failure);
  test::add_constant_curve(model, 1.0);
  model.prescribed_motions.push_back({.body = 1, .axis = 0, .curve = 0, .scale = tension});
  model.prescribed_motions.push_back({.body = 1, .axis = 1, .curve = 0, .scale = shear});
  // They break at the end of the step in which they reach their strength.
  model.control.step_scale = 0.09;
  model.control.end_time = 0.2;
  return run_break(model);
}

/// What the springs stored when they broke stays in the contact energy, and the balance closes.
void expect_booked(const Break& found, double stored) {
  std::printf("contact energy %.5g of %.5g, work %.5g, imbalance %.1e\n", found.energy.contact, stored,
              found.energy.external_work, found.energy.imbalance() / stored);
  EXPECT_NEAR(found.energy.contact, stored, 0.004 * stored);
  EXPECT_LT(std::fabs(found.energy.imbalance()), 2e-14 * stored);
}

/// Stresses: all nodes break at once, as the springs are in proportion to their areas.
TEST(Tiebreak, BreaksAtItsStrength) {
  const double normal = 0.3;
  const double shear = 0.2;
  const model::TieFailure failure{.normal_strength = normal, .shear_strength = shear};
  const Break tension = pull(failure, 0.2, 0);
  const Break sliding = pull(failure, 0, 0.2);
  std::printf("force / (strength area): tension %.4f, shear %.4f; stiffness %.6f; broken %d %d\n",
              tension.largest_force / (normal * area), sliding.largest_force / (shear * area),
              tension.largest_force / tension.opening / stiffness, tension.broken, sliding.broken);
  test::verified("tiebreak in tension: largest force over strength times area", "exact")
      .near(tension.largest_force / (normal * area), 1, 0.001);
  test::verified("tiebreak in shear: largest force over strength times area", "exact")
      .near(sliding.largest_force / (shear * area), 1, 0.001);
  EXPECT_NEAR(tension.largest_force / tension.opening, stiffness, 1e-9 * stiffness);
  EXPECT_EQ(tension.broken, 16);
  EXPECT_EQ(sliding.broken, 16);
  expect_booked(tension, std::pow(normal * area, 2) / (2 * stiffness));
  expect_booked(sliding, std::pow(shear * area, 2) / (2 * stiffness));
}

/// Two blocks of the same mesh, held at one end and pulled at the other to a stress that grows to `most`
/// times the strength of the tie over twenty periods, at the step that the elements allow.
Break pull_slowly(double most) {
  constexpr double strength = 0.3;
  model::Model model = test::two_blocks(2, 2, 2, model::TieMethod::Penalty);
  model.tied_contacts[0].failure = model::TieFailure{.normal_strength = strength, .shear_strength = strength};
  const double length = 20;
  model.control.end_time = 20 * 4 * length / std::sqrt(test::modulus / test::density);
  model.curves.push_back({.id = 1, .abscissa = {0, model.control.end_time}, .ordinate = {0, most}});
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    if (x[0] == 0)
      model.fixed_nodes.push_back({.node = i, .translation = {true, true, true}, .rotation = {}});
    if (x[0] != length) continue;
    const double share = (x[1] == 2 ? 0.5 : 0.25) * (x[2] == 2 ? 0.5 : 0.25);
    model.nodal_loads.push_back(
        {.node = i, .force = {share * strength * area, 0, 0}, .moment = {}, .curve = 0});
  }
  Break found = run_break(model);
  found.largest_force /= strength * area;
  return found;
}

/// Stability limits the springs, by the masses of nodes at the rim and inside, and must leave them in
/// proportion to their areas.
TEST(Tiebreak, HoldsUntilTheUniformStressIsItsStrength) {
  const Break below = pull_slowly(0.95);
  EXPECT_EQ(below.broken, 0);
  const Break beyond = pull_slowly(1.1);
  EXPECT_EQ(beyond.broken, 9);
  test::verified("tiebreak of matching meshes at the elements' step: largest stress over the strength",
                 "uniform stress")
      .near(beyond.largest_force, 1, 0.01);
}

/// q with q^a + (2 q)^b = 1.
double share_of_normal_strength(double a, double b) {
  double low = 0;
  double high = 1;
  while (high - low > 1e-14) {
    const double middle = 0.5 * (low + high);
    (std::pow(middle, a) + std::pow(2 * middle, b) < 1 ? low : high) = middle;
  }
  return low;
}

/// Forces with their exponents: every node breaks by itself. Springs inside of the surface have 1/9 of the
/// stiffness, those at its rim half of that, at its corners a quarter. So 4 break first, at the force F of a
/// spring, 8 at twice and 4 at four times that stretch; the joint bears 9 F, 10 F and 4 F then, and takes the
/// energy F^2 / (2 K) (4 9 + 8 18 + 4 36). The pull is that of the tensile and of twice the shear strength.
TEST(Tiebreak, ForcesOnNodes) {
  const double normal = 0.06;
  const double shear = 0.04;
  for (const auto& [normal_exponent, shear_exponent] :
       std::initializer_list<std::pair<double, double>>{{1, 1}, {2, 2}, {1, 3}, {3, 1}, {2.5, 1.5}, {4, 4}}) {
    const Break found = pull({.normal_strength = normal,
                              .shear_strength = shear,
                              .normal_exponent = normal_exponent,
                              .shear_exponent = shear_exponent,
                              .by_stress = false},
                             0.12, 0.16);
    const double force =
        share_of_normal_strength(normal_exponent, shear_exponent) * std::hypot(normal, 2 * shear);
    std::printf("NEN %.1f, MES %.1f: force over that of a spring %.3f\n", normal_exponent, shear_exponent,
                found.largest_force / force);
    EXPECT_EQ(found.broken, 16);
    EXPECT_NEAR(found.largest_force, 10 * force, 0.003 * 10 * force);
    expect_booked(found, 162 * force * force / stiffness);
  }
}

/// The second block flies off: it loses what the springs took.
TEST(Tiebreak, BlockThatTearsItselfOffLosesTheEnergyOfTheSprings) {
  const double normal = 0.3;
  model::Model model = breaking_blocks({.normal_strength = normal});
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i, .velocity = {20, 0, 0}, .angular_velocity = {}});
  model.control.end_time = 0.01;
  model.control.step_scale = 0.02;
  const Break found = run_break(model);
  const double stored = std::pow(normal * area, 2) / (2 * stiffness);
  const double lost = found.energy.initial_total - found.energy.kinetic;
  std::printf("force / (strength area) %.4f, kinetic energy lost over stored %.4f of %.4g\n",
              found.largest_force / (normal * area), lost / stored, found.energy.initial_total / stored);
  EXPECT_EQ(found.broken, 16);
  EXPECT_NEAR(lost, stored, 0.004 * stored);
  expect_booked(found, stored);
}

}  // namespace
}  // namespace crumple::tie_springs_test
