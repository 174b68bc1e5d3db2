// SPDX-License-Identifier: BSD-3-Clause
#include "output/checks.hpp"

#include <algorithm>
#include <cmath>

#include "output/sample.hpp"

namespace crumple::output::checks_test {
namespace {

/// A run that is good in every respect; each test spoils one.
class ChecksTest : public SampleTest {
 protected:
  ChecksTest() {
    domain_.contacts.push_back({.id = 2, .method = "linked-cell"});
    domain_.nodes.mass.assign(6, 1.0);
    domain::EnergyLedger& energy = domain_.energy;
    energy.initial_total = 100;
    energy.kinetic = 40;
    energy.internal = 57;
    energy.hourglass = 2;
    energy.contact = 1;
    for (domain::ShellBlock& block : domain_.shells) {
      block.internal_energy = 28.5;
      block.hourglass_energy = 1;
    }
    for (math::Vec3& velocity : domain_.nodes.velocity) velocity = {0, 15, 0};
    peaks_.observe(view());
  }
  Check find(const std::string& part_of_name) const {
    for (const Check& check : acceptance_checks(view(), peaks_))
      if (check.name.find(part_of_name) != std::string::npos) return check;
    ADD_FAILURE() << "no check named " << part_of_name;
    return {};
  }
  PeakValues peaks_;
};

TEST_F(ChecksTest, AGoodRunPassesEveryCheckAndHasNoWarning) {
  for (const Check& check : acceptance_checks(view(), peaks_))
    EXPECT_TRUE(check.pass) << check.name << " = " << check.value;
  EXPECT_TRUE(energy_warnings(view(), peaks_).empty());
}

TEST_F(ChecksTest, EnergyThatAppearsFails) {
  domain_.energy.kinetic = 43;
  EXPECT_DOUBLE_EQ(find("total energy change").value, 0.03);
  EXPECT_FALSE(find("total energy change").pass);
  EXPECT_DOUBLE_EQ(find("energy error").value, 3.0 / 60);
  EXPECT_FALSE(find("energy error").pass);
}

TEST_F(ChecksTest, ExternalWorkIsNoError) {
  domain_.energy.kinetic = 43;
  domain_.energy.external_work = 3;
  EXPECT_TRUE(find("total energy change").pass);
  EXPECT_TRUE(find("energy error").pass);
}

/// A spring that a load has wound up drives the load back: in the end there is no energy to compare with.
TEST_F(ChecksTest, EnergyThatHasLeftAgainIsHeldAgainstTheMostThatThereWas) {
  domain_.energy.external_work = 100;
  peaks_.observe(view());
  domain_.energy.kinetic = 0.5;
  domain_.energy.internal = domain_.energy.hourglass = domain_.energy.contact = 0;
  domain_.energy.external_work = -100;
  EXPECT_DOUBLE_EQ(find("total energy change").value, 0.5 / 200);
  EXPECT_TRUE(find("total energy change").pass);
}

/// Stresses of the start that loads let out: work is negative from the first step on.
TEST_F(ChecksTest, WorkThatLoadsOnlyTakeOutIsWhatTheBalanceIsHeldAgainst) {
  PeakValues peaks;
  domain::EnergyLedger& energy = domain_.energy;
  energy.initial_total = energy.kinetic = energy.hourglass = energy.contact = 0;
  energy.external_work = -100;
  energy.internal = -99.5;
  peaks.observe(view());
  peaks_ = peaks;
  EXPECT_NEAR(find("total energy change").value, 0.005, 1e-12);
}

TEST_F(ChecksTest, HourglassIsHeldAgainstInitialAndInternalEnergy) {
  domain_.energy.hourglass = 6;
  EXPECT_DOUBLE_EQ(find("hourglass / initial").value, 0.06);
  EXPECT_FALSE(find("hourglass / initial").pass);
  EXPECT_FALSE(find("hourglass / internal energy").pass);
  EXPECT_EQ(energy_warnings(view(), peaks_).size(), 1U);
}

TEST_F(ChecksTest, TheWorstPartIsNamed) {
  for (domain::ShellBlock& block : domain_.shells)
    if (model_.parts[block.part].id == 3) block.hourglass_energy = 5.7;
  EXPECT_DOUBLE_EQ(find("part 3").value, 0.2);
  EXPECT_FALSE(find("part 3").pass);
  ASSERT_EQ(energy_warnings(view(), peaks_).size(), 1U);
  EXPECT_NE(energy_warnings(view(), peaks_)[0].find("part 3 is 20.0 %"), std::string::npos);
}

/// That of shells with the stiffness of their material is strain energy; where it is much, the mesh is
/// coarse.
TEST_F(ChecksTest, HourglassEnergyOfTheMaterialIsNotLimitedButTold) {
  for (domain::ShellBlock& block : domain_.shells)
    if (model_.parts[block.part].id == 3) block.hourglass_energy = 20;
  domain_.energy.hourglass = 21;
  EXPECT_FALSE(find("hourglass / internal energy").pass);
  EXPECT_EQ(find("hourglass / internal energy").name, "hourglass / internal energy");
  EXPECT_EQ(material_hourglass_energy(view()), 0);
  model_.control.hourglass.form = model::HourglassForm::Material;
  EXPECT_DOUBLE_EQ(material_hourglass_energy(view()), 21);
  EXPECT_DOUBLE_EQ(find("hourglass / initial").value, 0);
  EXPECT_EQ(find("hourglass / initial").name, "artificial hourglass / initial total energy");
  EXPECT_EQ(find("hourglass / internal energy").name, "artificial hourglass / internal energy");
  EXPECT_EQ(find("energy, part").name.substr(0, 45), "artificial hourglass / internal energy, part ");
  EXPECT_TRUE(find("hourglass / internal energy").pass);
  EXPECT_TRUE(find("hourglass / internal energy, part").pass);
  EXPECT_TRUE(energy_warnings(view(), peaks_).empty()) << "of elastic parts it is their bending";
  for (model::Material& material : model_.materials)
    material.law = model::PlasticKinematic{.youngs_modulus = 210, .poissons_ratio = 0.3, .yield_stress = 0.3};
  ASSERT_EQ(energy_warnings(view(), peaks_).size(), 1U);
  EXPECT_NE(energy_warnings(view(), peaks_)[0].find("its elements are too large"), std::string::npos);
}

TEST_F(ChecksTest, AddedMassCountsAgainstTheMassWithoutIt) {
  domain_.added_mass = 1;
  EXPECT_DOUBLE_EQ(find("added mass").value, 0.2);
  EXPECT_FALSE(find("added mass").pass);
}

TEST_F(ChecksTest, ContactEnergyIsNeitherNegativeNorLarge) {
  domain_.energy.contact = domain_.contacts[0].energy = 6;
  EXPECT_TRUE(find("negative contact").pass);
  EXPECT_FALSE(find("without friction").pass);
  domain_.energy.contact = domain_.contacts[0].energy = -1;
  peaks_.observe(domain_.energy);
  EXPECT_NEAR(find("negative contact").value, 1.0 / 57, 1e-15);
  EXPECT_FALSE(find("negative contact").pass);
  EXPECT_EQ(energy_warnings(view(), peaks_).size(), 1U);
  domain_.energy.contact = domain_.contacts[0].energy = 0;
  EXPECT_FALSE(find("negative contact").pass) << "it was negative";
}

/// Bodies that have rebounded hold next to nothing of what they absorbed.
TEST_F(ChecksTest, ContactEnergyIsHeldAgainstTheLargestInternalEnergy) {
  domain_.energy.internal = 0.1;
  domain_.energy.contact = domain_.contacts[0].energy = -0.05;
  peaks_.observe(domain_.energy);
  EXPECT_NEAR(find("negative contact").value, 0.05 / 57, 1e-15);
  EXPECT_TRUE(find("negative contact").pass);
}

/// The springs of bodies that have just met hold all that has been taken from the motion.
TEST_F(ChecksTest, ContactThatHasJustBegunIsHeldAgainstTheEnergyAround) {
  PeakValues peaks;
  domain_.energy.internal = 0;
  domain_.energy.kinetic = 99.8;
  domain_.energy.contact = domain_.contacts[0].energy = 0.2;
  peaks.observe(view());
  peaks_ = peaks;
  EXPECT_NEAR(find("without friction").value, 0.02, 1e-15);
  domain_.energy.contact = domain_.contacts[0].energy = -0.2;
  peaks_.observe(domain_.energy);
  EXPECT_NEAR(find("negative contact").value, 0.02, 1e-15);
  EXPECT_FALSE(find("negative contact").pass);
}

/// A clamp holds energy in its penalties that it gives back: that is no fault.
TEST_F(ChecksTest, WhatThePenaltiesHoldIsNoFault) {
  domain_.energy.contact = domain_.contacts[0].energy = 30;
  EXPECT_FALSE(find("without friction").pass);
  domain_.contacts[0].stored_energy = 29;
  EXPECT_NEAR(find("without friction").value, 1.0 / 57, 1e-15);
  EXPECT_TRUE(find("without friction").pass);
  domain_.contacts[0].stored_energy = 20;
  EXPECT_FALSE(find("without friction").pass) << "the rest is lost";
}

/// Nor is what the springs of ties hold, but what ties lose is.
TEST_F(ChecksTest, WhatTheSpringsOfTiesHoldIsNoFault) {
  domain_.energy.contact = 30;
  domain_.ties.push_back({});
  domain_.ties[0].energy = 29;
  EXPECT_NEAR(find("without friction").value, 1.0 / 57, 1e-15);
  EXPECT_TRUE(find("without friction").pass);
  domain_.ties[0].dissipated = 20;
  EXPECT_FALSE(find("without friction").pass);
}

/// The warning and the check have one figure.
TEST_F(ChecksTest, NegativeContactEnergyIsWarnedOfByTheMeasureOfTheCheck) {
  PeakValues peaks;
  domain_.energy.internal = 1;
  domain_.energy.hourglass = 0;
  for (domain::ShellBlock& block : domain_.shells) block.hourglass_energy = 0;
  domain_.energy.kinetic = 99;
  domain_.energy.contact = domain_.contacts[0].energy = -0.05;
  peaks.observe(view());
  peaks_ = peaks;
  EXPECT_NEAR(find("negative contact").value, 0.005, 1e-15);
  EXPECT_EQ(energy_warnings(view(), peaks_).size(), 0U) << "5 % of the internal energy";
  domain_.energy.contact = domain_.contacts[0].energy = -0.2;
  peaks_.observe(domain_.energy);
  EXPECT_NEAR(find("negative contact").value, 0.02, 1e-15);
  ASSERT_EQ(energy_warnings(view(), peaks_).size(), 1U);
  EXPECT_NE(energy_warnings(view(), peaks_)[0].find("-2.00 % of a tenth"), std::string::npos);
}

/// Damping and ties that broke take energy by their rule. It hides no springs that give some away.
TEST_F(ChecksTest, WhatContactDissipatesIsNoFault) {
  domain_.energy.contact = 30;
  domain_.energy.contact_dissipated = 29;
  EXPECT_TRUE(find("without friction").pass);
  domain_.energy.contact_dissipated = 31;
  peaks_.observe(domain_.energy);
  EXPECT_FALSE(find("negative contact").pass);
}

/// Rigid bodies absorb nothing: their balance is held against a hundredth of what moves.
TEST_F(ChecksTest, RigidBodiesPassByTheDigitsOfTheirBalance) {
  PeakValues peaks;
  domain_.energy = domain::EnergyLedger{};
  domain_.energy.external_work = 100;
  domain_.energy.kinetic = 100 + 1e-5;
  peaks.observe(view());
  peaks_ = peaks;
  EXPECT_NEAR(find("energy error").value, 1e-5, 1e-7);
  EXPECT_TRUE(find("energy error").pass);
  domain_.energy.kinetic = 100.02;
  EXPECT_FALSE(find("energy error").pass);
}

/// A motion that has taken back at the end what it had supplied.
TEST_F(ChecksTest, ABodyThatIsDrivenAndStoppedPassesByWhatItHad) {
  PeakValues peaks;
  domain_.energy = domain::EnergyLedger{};
  domain_.energy.external_work = domain_.energy.kinetic = 100;
  peaks.observe(view());
  domain_.energy.external_work = 1e-6;
  domain_.energy.kinetic = 0;
  peaks.observe(view());
  peaks_ = peaks;
  EXPECT_NEAR(find("energy error").value, 1e-6, 1e-12);
  domain_.energy.external_work = 0.02;
  EXPECT_FALSE(find("energy error").pass);
}

TEST_F(ChecksTest, RoundOffAtRestIsNoError) {
  PeakValues peaks;
  domain_.energy = domain::EnergyLedger{};
  domain_.clock.step = 1e-6;
  domain_.energy.kinetic = 1e-22;
  peaks.observe(view());
  peaks_ = peaks;
  EXPECT_TRUE(find("energy error").pass);
  EXPECT_TRUE(find("total energy change").pass);
}

/// A node that has been behind a surface counts, though it has come back by the end.
TEST_F(ChecksTest, TheDeepestPenetrationOfTheRunCounts) {
  EXPECT_TRUE(find("deepest penetration").pass);
  domain_.contacts[0].deepest = {.share = 1.5, .cycle = 7, .node = 40, .segment = 1};
  EXPECT_DOUBLE_EQ(find("deepest penetration").value, 1.5);
  EXPECT_FALSE(find("deepest penetration").pass);
}

/// Bodies that have passed through each other are apart at the end.
TEST_F(ChecksTest, TheMostIntersectionsOfTheRunCount) {
  domain_.contacts[0].inspection.made = true;
  EXPECT_TRUE(find("mid-surface intersections of the run").pass);
  domain_.contacts[0].worst_intersections = {
      .count = 3, .first_segment = 1, .second_segment = 2, .cycle = 7, .time = 0.5};
  EXPECT_EQ(find("mid-surface intersections of the run").value, 3);
  EXPECT_FALSE(find("mid-surface intersections of the run").pass);
}

TEST_F(ChecksTest, AShootingNodeIsFoundAndNamed) {
  domain_.nodes.velocity[domain_.nodes.domain_node[2]] = {0, 0, 1500};
  peaks_.observe(view());
  EXPECT_DOUBLE_EQ(find("fastest node (node 40)").value, 100);
  EXPECT_FALSE(find("fastest node").pass);
}

TEST_F(ChecksTest, AModelThatStartsAtRestIsHeldAgainstWhatDrivesIt) {
  PeakValues peaks;
  domain_.energy = domain::EnergyLedger{};
  const auto observe = [&](double speed) {
    for (math::Vec3& velocity : domain_.nodes.velocity) velocity = {0, speed, 0};
    peaks.observe(view());
  };
  observe(1e-6);  // half a step of a load
  EXPECT_EQ(peaks.reference_speed(), 0);
  domain_.clock.cycle = 64;
  domain_.energy.external_work = 0.5 * 6 * 9;  // 6 nodes of unit mass at 3
  observe(3);
  EXPECT_DOUBLE_EQ(peaks.reference_speed(), 3);
  domain_.energy.external_work = 0;
  model_.prescribed_motions.push_back({.node = 2, .axis = 1});
  observe(5);
  EXPECT_DOUBLE_EQ(peaks.reference_speed(), 5);
  domain_.walls.push_back({.id = 1, .velocity = {-7, 0, 0}});
  observe(5);
  EXPECT_DOUBLE_EQ(peaks.reference_speed(), 7);
  domain_.rigid_bodies.emplace_back();
  domain_.rigid_bodies[0].arm = {{0, 2, 0}};
  domain_.rigid_bodies[0].velocity = {0, 0, 6};
  domain_.rigid_bodies[0].angular_velocity = {1.5, 0, 0};
  observe(5);
  EXPECT_DOUBLE_EQ(peaks.reference_speed(), 9);
  EXPECT_DOUBLE_EQ(peaks.fastest(), 5);
}

/// A force on a small piece of a heavy body: the energy that it supplies stays there for the time of the run.
TEST_F(ChecksTest, ForcesOnAFewNodesAreMeasuredByTheSpeedOfThese) {
  PeakValues peaks;
  domain_.energy = domain::EnergyLedger{};
  domain_.nodes.velocity.assign(6, math::Vec3{});
  peaks.observe(view());
  model_.curves.push_back({.id = 1, .abscissa = {0, 1, 1.1, 9}, .ordinate = {1, 1, 0, 0}});
  model_.nodal_loads.push_back({.node = 0, .force = {0, 0, -3}, .curve = 0});
  model_.nodal_loads.push_back({.node = 1, .force = {0, 0, -1}, .curve = 0});
  go_to(2, 64);  // the pulse has ended
  domain_.nodes.mass[5] = 1e6;
  domain_.nodes.velocity[domain_.nodes.domain_node[0]] = {50, 0, -20};
  domain_.nodes.velocity[domain_.nodes.domain_node[1]] = {0, 0, -4};
  domain_.energy.external_work = 200;
  peaks.observe(view());
  EXPECT_DOUBLE_EQ(peaks.reference_speed(), (3.0 * 20 + 1.0 * 4) / 4) << "along the forces alone";
  peaks_ = peaks;
  EXPECT_TRUE(find("fastest node").pass);
  domain_.nodes.velocity[domain_.nodes.domain_node[3]] = {0, 0, 400};
  peaks_.observe(view());
  EXPECT_FALSE(find("fastest node (node 30)").pass) << "without a load";
}

/// A node with a load that shoots off is no measure of itself where the load acts on others as well.
TEST_F(ChecksTest, ALoadedNodeThatShootsOffIsFound) {
  for (Index node = 0; node < 6; ++node) model_.nodal_loads.push_back({.node = node, .force = {0, 1, 0}});
  for (int i = 0; i < 24; ++i) model_.nodal_loads.push_back({.node = i % 5, .force = {0, 1, 0}});
  domain_.nodes.velocity[domain_.nodes.domain_node[5]] = {0, 1500, 0};
  peaks_.observe(view());
  EXPECT_FALSE(find("fastest node").pass);
}

/// A load whose curve has been zero drives nothing.
TEST_F(ChecksTest, ForcesThatHaveNotBegunAreNoMeasure) {
  PeakValues peaks;
  domain_.energy = domain::EnergyLedger{};
  domain_.clock.step = 1e-6;
  for (math::Vec3& velocity : domain_.nodes.velocity) velocity = {0, 7, 0};
  model_.curves.push_back({.id = 1, .abscissa = {0, 3, 4}, .ordinate = {0, 0, 1}});
  model_.nodal_loads.push_back({.node = 0, .force = {0, 2, 0}, .curve = 0});
  model_.pressure_loads.push_back({.node = {0, 1, 4, 3}, .pressure = 2, .curve = 0, .arrival = 1});
  peaks.observe(view());  // the start
  go_to(2.5, 64);
  peaks.observe(view());
  EXPECT_EQ(peaks.reference_speed(), 0);
  go_to(3.5, 128);
  peaks.observe(view());
  EXPECT_DOUBLE_EQ(peaks.reference_speed(), 7);
}

/// So are pressures, along the normal of their segments.
TEST_F(ChecksTest, PressuresOnASmallPieceAreMeasuredByItsSpeed) {
  PeakValues peaks;
  domain_.energy = domain::EnergyLedger{};
  for (math::Vec3& velocity : domain_.nodes.velocity) velocity = {30, 0, 8};
  model_.pressure_loads.push_back({.node = {0, 1, 4, 3}, .pressure = 2});
  model_.pressure_loads.push_back({.node = {0, 1, 4, 4}, .pressure = 2, .arrival = 5});
  peaks.observe(view());  // the start
  go_to(1, 64);
  peaks.observe(view());
  EXPECT_DOUBLE_EQ(peaks.reference_speed(), 8);
}

/// A force that follows a plane acts along its normal.
TEST_F(ChecksTest, ForcesThatFollowAPlaneAreMeasuredAlongItsNormal) {
  PeakValues peaks;
  domain_.energy = domain::EnergyLedger{};
  for (math::Vec3& velocity : domain_.nodes.velocity) velocity = {30, 0, 8};
  model_.nodal_loads.push_back({.node = 0, .force = {-5, 0, 0}, .plane = {.node = {0, 1, 4}}});
  peaks.observe(view());  // the start
  go_to(1, 64);
  peaks.observe(view());
  EXPECT_DOUBLE_EQ(peaks.reference_speed(), 8);
}

TEST_F(ChecksTest, NotANumberFails) {
  domain_.energy.kinetic = std::nan("");
  EXPECT_FALSE(find("total energy change").pass);
  EXPECT_FALSE(find("energy error").pass);
}

TEST_F(ChecksTest, RoundOffInAModelThatOnlyFliesIsNoFault) {
  domain_.energy = domain::EnergyLedger{};
  domain_.energy.initial_total = domain_.energy.kinetic = 100;
  domain_.energy.internal = 1e-14;
  domain_.energy.hourglass = 1e-13;
  domain_.energy.contact = -1e-13;
  EXPECT_TRUE(find("hourglass / internal energy").pass);
  EXPECT_TRUE(find("negative contact").pass);
}

}  // namespace
}  // namespace crumple::output::checks_test
