// SPDX-License-Identifier: BSD-3-Clause
// Tied contact beside what else moves nodes: prescribed motion, walls, erosion, contact after a break; and
// the same bits for any number of threads.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/larger.hpp"
#include "support/run.hpp"
#include "support/ties.hpp"
#include "support/verified.hpp"

namespace crumple::tied_motion_test {
namespace {

using math::Vec3;

/// Shakes the nodes of the segments themselves: the work must include what they carry.
TEST(TiedMotion, PrescribedMotionOfASegmentMovesWhatItCarries) {
  model::Model model = test::two_blocks(2, 3, 3);
  model::Curve curve{.id = 1, .abscissa = {}, .ordinate = {}};
  for (int i = 0; i <= 200; ++i) {
    const double time = 0.2 * i / 200;
    curve.abscissa.push_back(time);
    curve.ordinate.push_back(std::sin(2 * M_PI * time / 0.05));
  }
  model.curves.push_back(curve);
  for (Index i = 0; i < model.nodes.count(); ++i)
    if (std::fabs(model.nodes.position[i][0] - 10) < 1e-9 && i < 4 * 9)
      model.prescribed_motions.push_back({.node = i, .axis = 1, .curve = 0, .scale = 2});
  ASSERT_EQ(model.prescribed_motions.size(), 9U);
  model.control.end_time = 0.2;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::EnergyLedger& energy = simulation.domain().energy;
  std::printf("work %.4g, imbalance over it %.2e\n", energy.external_work,
              energy.imbalance() / energy.external_work);
  EXPECT_GT(energy.external_work, 0);
  test::verified("tied segment shaken: imbalance over the external work", "conservation")
      .below(std::fabs(energy.imbalance()) / energy.external_work, 2e-6);
}

/// The joint runs through the place of the impact: the wall stops segments with what is tied to them.
TEST(TiedMotion, WallTakesTheMomentumOfWhatIsTied) {
  model::Model model = test::two_blocks(2, 3, 3);
  model::RigidWall wall;
  wall.id = 1;
  wall.point = {0, 0, -0.01};
  wall.normal = {0, 0, 1};
  double mass = 0;
  for (Index i = 0; i < model.nodes.count(); ++i) {
    wall.nodes.push_back(i);
    model.initial_velocities.push_back({.node = i, .velocity = {0, 0, -1}, .angular_velocity = {}});
  }
  model.rigid_walls.push_back(wall);
  model.control.end_time = 0.02;
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  for (const double nodal : domain.nodes.mass) mass += nodal;
  test::run(simulation);
  const Vec3 change = test::momentum(domain) - Vec3{0, 0, -mass};
  std::printf("momentum %.4g of %.4g, wall %.2e off, imbalance over initial %.2e\n", change.z, mass,
              norm(change + domain.walls[0].impulse) / norm(change),
              domain.energy.imbalance() / domain.energy.initial_total);
  EXPECT_GT(change.z, mass);
  test::verified("tied blocks meet a wall: momentum less the wall's impulse, relative error", "conservation")
      .below(norm(change + domain.walls[0].impulse) / norm(change), 1e-12);
  // That of the impact itself: twice as much without the tie.
  test::verified("tied blocks meet a wall: imbalance over the energy at first", "conservation")
      .below(std::fabs(domain.energy.imbalance()) / domain.energy.initial_total, 2e-3);
  for (const Vec3& x : domain.nodes.position) EXPECT_GT(x.z, -0.01 - 1e-9);
}

/// The same with a wall that has a mass of its own and flies at the blocks.
TEST(TiedMotion, WallWithMassSharesItsMomentumWithWhatIsTied) {
  model::Model model = test::two_blocks(2, 3, 3);
  model::RigidWall wall;
  wall.id = 1;
  wall.point = {0, 0, -0.01};
  wall.normal = {0, 0, 1};
  wall.mass = 0.01;
  wall.initial_velocity = 1;
  for (Index i = 0; i < model.nodes.count(); ++i) wall.nodes.push_back(i);
  model.rigid_walls.push_back(wall);
  model.control.end_time = 0.02;
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  test::run(simulation);
  const domain::WallReport& report = domain.walls[0];
  const Vec3 now = test::momentum(domain) + report.mass * report.velocity;
  std::printf("wall's velocity %.4f, momentum %.2e off, imbalance over initial %.2e\n", report.velocity.z,
              norm(now - Vec3{0, 0, 0.01}) / 0.01, domain.energy.imbalance() / domain.energy.initial_total);
  EXPECT_LT(report.velocity.z, 0.8) << "the wall has struck";
  test::verified("wall with mass meets tied blocks: momentum, relative change", "conservation")
      .below(norm(now - Vec3{0, 0, 0.01}) / 0.01, 1e-12);
  test::verified("wall with mass meets tied blocks: imbalance over the energy at first", "conservation")
      .below(std::fabs(domain.energy.imbalance()) / domain.energy.initial_total, 2e-3);
  const double plane = -0.01 + report.displacement.z;
  for (const Vec3& x : domain.nodes.position) EXPECT_GT(x.z, plane - 1e-9);
}

/// The strip of the joint is pulled off: the shells of the plate beside it fail.
TEST(TiedMotion, ErosionOfTheSegmentFreesTheNode) {
  for (const model::TieMethod method : {model::TieMethod::Constraint, model::TieMethod::Penalty}) {
    model::Model model = test::shell_joint(true, 4);
    model.tied_contacts[0].method = method;
    model::PlasticKinematic law;
    law.youngs_modulus = 210;
    law.poissons_ratio = 0.3;
    law.yield_stress = 0.3;
    law.tangent_modulus = 0.5;
    law.failure_strain = 0.02;
    model.materials.push_back({.id = 2, .title = "weak", .density = 7.85e-6, .law = law});
    model.parts[0].material = 1;
    for (model::NodalLoad& load : model.nodal_loads) load.force = {0, 0, 0.6};
    model.control.end_time = 0.4;
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    const domain::Domain& domain = simulation.domain();
    const domain::Tie& tie = domain.ties[0];
    std::printf("released %d of %zu, energy of the tie %.2e, energy error %.2e\n", tie.released,
                tie.nodes.size(), tie.energy, domain.energy.error());
    EXPECT_EQ(tie.released, static_cast<Index>(tie.nodes.size()));
    EXPECT_EQ(tie.broken, 0);
    test::verified(std::string("tied joint whose shells erode, ") +
                       (method == model::TieMethod::Penalty ? "penalty" : "constraint") +
                       ": error of the energy balance",
                   "conservation")
        .below(domain.energy.error(), 4e-3);
  }
}

/// Pulled apart until the tie breaks, and pushed together again.
TEST(TiedMotion, AfterTheBreakTheSurfacesTouch) {
  model::Model model = test::two_blocks(2, 3, 2, model::TieMethod::Penalty);
  model.tied_contacts[0].failure = model::TieFailure{.normal_strength = 0.1, .shear_strength = 0.1};
  model::Contact contact;
  contact.id = 7;
  contact.kind = model::ContactKind::SurfaceToSurface;
  contact.side = model.tied_contacts[0].side;
  model.contacts.push_back(contact);
  model.curves.push_back({1, {0, 0.1, 0.3, 10}, {0.5, 0.5, -1.0, -1.0}});
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const double x = model.nodes.position[i][0];
    if (x < 1e-9) model.fixed_nodes.push_back({.node = i, .translation = {true, true, true}});
    if (x > 20 - 1e-9) model.prescribed_motions.push_back({.node = i, .axis = 0, .curve = 0, .scale = 0.5});
  }
  model.control.end_time = 0.5;
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  const domain::Domain& domain = simulation.domain();
  double widest = 0;
  double deepest = 0;
  while (!simulation.finished()) {
    simulation.step();
    double mean = 0;
    for (const domain::TiedNode& tied : domain.ties[0].nodes) {
      double gap = domain.nodes.position[tied.node].x;
      for (std::size_t k = 0; k < 4; ++k) gap -= tied.weight[k] * domain.nodes.position[tied.corner[k]].x;
      mean += gap / static_cast<double>(domain.ties[0].nodes.size());
    }
    widest = test::larger_of(widest, mean);
    deepest = std::min(deepest, mean);
  }
  std::printf("broken %d, opened to %.4f, pressed in by %.4f, energy error %.2e\n", domain.ties[0].broken,
              widest, -deepest, domain.energy.error());
  EXPECT_EQ(domain.ties[0].broken, 16);
  EXPECT_GT(widest, 0.02);
  // Without contact it would be the whole way of 0.1; the penalty is as soft as a bar of 75 mm, which would
  // take 0.079 of it, and softer at the rims.
  EXPECT_GT(deepest, -0.085);
  EXPECT_LT(deepest, -0.01);
  test::verified("tie that breaks and closes again: error of the energy balance", "conservation")
      .below(domain.energy.error(), 4e-4);
}

TEST(TiedMotion, SameBitsForAnyNumberOfThreads) {
  const auto hash = [](model::TieMethod method, Precision precision, int threads) {
    model::Model model = test::two_blocks(4, 6, 6, method);
    model.tied_contacts[0].ties_rotations = true;
    if (method == model::TieMethod::Penalty)
      model.tied_contacts[0].failure = model::TieFailure{.normal_strength = 0.5, .shear_strength = 0.5};
    test::shake(model);
    model.control.end_time = 0.01;
    timeloop::Simulation simulation(model, {precision, default_isa(), threads});
    test::run(simulation);
    const domain::EnergyLedger& energy = simulation.domain().energy;
    EXPECT_LT(std::fabs(energy.imbalance()), 4e-4 * energy.initial_total);
    return simulation.state_hash();
  };
  for (const model::TieMethod method : {model::TieMethod::Constraint, model::TieMethod::Penalty})
    for (const Precision precision : {Precision::Double, Precision::Mixed}) {
      const std::uint64_t one = hash(method, precision, 1);
      for (const int threads : {2, 3}) EXPECT_EQ(hash(method, precision, threads), one);
    }
}

}  // namespace
}  // namespace crumple::tied_motion_test
