// SPDX-License-Identifier: BSD-3-Clause
//
// Cohesive solids (ELFORM 19 with *MAT_138 and *MAT_184): one element along rays of all modes against the
// closed form of its law, rigid turns, momenta of shaken bodies, the stable step, contact.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "support/cohesive.hpp"
#include "support/conservation.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"
#include "support/meshes.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::cohesive_solids_test {
namespace {

using Failure = model::Cohesive::Failure;

/// kN, mm, ms, kg.
model::Cohesive glue(Failure failure = Failure::PowerLaw, double exponent = 1) {
  return {.youngs_modulus = 10,
          .shear_stiffness = 4,
          .failure = failure,
          .normal_strength = 0.03,
          .shear_strength = 0.05,
          .normal_energy = 0.0004,
          .shear_energy = 0.001,
          .exponent = exponent,
          .mass_by_area = true,
          .failed_points = 1};
}

constexpr double area = 4;

/// One element of 2 x 2 and a thickness in a plane across (1, 2, 2) / 3, so that no axis is special. The
/// lower face is held, the upper one moves along the ray.
struct Pull {
  model::Cohesive law;
  double degrees = 0;  ///< from the normal
  double thickness = 0;
  double travel = 0.08;
  Precision precision = Precision::Double;
};

constexpr std::array<double, 3> normal{1.0 / 3, 2.0 / 3, 2.0 / 3};
constexpr std::array<double, 3> first{2.0 / 3, 1.0 / 3, -2.0 / 3};
constexpr std::array<double, 3> second{-2.0 / 3, 2.0 / 3, -1.0 / 3};

model::Model one_element(const Pull& pull) {
  model::Model model;
  const Index part = test::add_layer(model, pull.law, 1e-6);
  test::add_box(model, part, 1, 1, 1, [&](double u, double v, double w) {
    test::Point x{};
    for (std::size_t i = 0; i < 3; ++i)
      x[i] = 2 * u * first[i] + 2 * v * second[i] + pull.thickness * w * normal[i];
    return x;
  });
  const double angle = pull.degrees * M_PI / 180;
  const Index curve = test::add_constant_curve(model, 1.0);
  for (Index node = 0; node < 4; ++node) {
    model.fixed_nodes.push_back({.node = node, .translation = {true, true, true}, .rotation = {}});
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      // Along both tangents alike.
      const double along = (first[i] + second[i]) / std::sqrt(2.0);
      model.prescribed_motions.push_back({.node = node + 4,
                                          .axis = axis,
                                          .curve = curve,
                                          .scale = std::cos(angle) * normal[i] + std::sin(angle) * along});
    }
  }
  model.control.end_time = pull.travel;
  model.control.step_scale = 0.05;
  return model;
}

/// What the criteria give on the ray.
struct Expected {
  double onset = 0;    ///< separation where damage begins
  double failure = 0;  ///< where it is complete
  double normal = 0;   ///< stiffness along the ray's normal part
  double shear = 0;
  double energy = 0;  ///< over the area
};

Expected expected(const model::Cohesive& law, double degrees) {
  const double across = degrees == 90 ? 0 : std::cos(degrees * M_PI / 180);
  const double along = std::sin(degrees * M_PI / 180);
  Expected found;
  found.normal = law.youngs_modulus * across;
  found.shear = law.shear_stiffness * along;
  found.onset = 1 / std::hypot(found.normal / law.normal_strength, found.shear / law.shear_strength);
  const double of_normal = found.normal * across;
  const double of_shear = found.shear * along;
  const double share = of_shear / (of_normal + of_shear);
  found.energy =
      law.failure == Failure::PowerLaw
          ? std::pow(std::pow((1 - share) / law.normal_energy, law.exponent) +
                         std::pow(share / law.shear_energy, law.exponent),
                     -1 / law.exponent)
          : law.normal_energy + (law.shear_energy - law.normal_energy) * std::pow(share, law.exponent);
  found.failure = 2 * found.energy / (found.onset * (of_normal + of_shear));
  return found;
}

struct Pulled {
  double worst_traction = 0;  ///< error over the largest traction
  double energy = 0;          ///< taken, over the area
  double work = 0;            ///< of the motion, likewise
  Index eroded = 0;
};

/// Compares the force on the held face with the closed form at every step.
Pulled pull(const Pull& given) {
  const model::Model model = one_element(given);
  timeloop::Simulation simulation(model, {given.precision, default_isa(), 1});
  const Expected exact = expected(given.law, given.degrees);
  const double peak = exact.onset * std::hypot(exact.normal, exact.shear);
  Pulled found;
  test::run(simulation, [&](const domain::Domain& domain) {
    const domain::SolidBlock& block = domain.solids[0];
    if (block.eroded > 0) return;
    const Index apart = block.find("separation")->first;
    const auto separation = [&](Index c) { return block.state(0, apart + c); };
    const double d = std::hypot(separation(0), separation(1), separation(2));
    double left = 1;
    if (d > exact.onset)
      left = exact.onset / d * std::max(0.0, exact.failure - d) / (exact.failure - exact.onset);
    const Index stress = block.find("stress")->first;
    for (Index point = 0; point < 4; ++point) {
      const auto t = [&](Index c) { return block.state(0, stress + 6 * point + c); };
      const double error =
          std::hypot(t(2) - left * exact.normal * d, std::hypot(t(0), t(1)) - left * exact.shear * d);
      found.worst_traction = test::larger_of(found.worst_traction, error / peak);
    }
  });
  const domain::Domain& domain = simulation.domain();
  found.energy = (domain.energy.internal + domain.energy.eroded) / area;
  found.work = domain.energy.external_work / area;
  found.eroded = domain.solids[0].eroded;
  return found;
}

TEST(CohesiveSolids, FollowTheirLawAndTakeItsEnergy) {
  const std::string element = "one cohesive solid: ";
  test::Largest traction(element + "tractions over their peak, error", "closed form", 1e-9);
  test::Largest opening(element + "energy over area in mode I over GIC, error", "exact", 1e-5);
  test::Largest sliding(element + "energy over area in mode II over GIIC, error", "exact", 1e-5);
  test::Largest mixed(element + "energy over area in mixed modes, error", "power law, Benzeggagh and Kenane",
                      1e-5);
  for (const auto& [failure, exponent] :
       {std::pair{Failure::PowerLaw, 1.0}, {Failure::PowerLaw, 1.45}, {Failure::BenzeggaghKenane, 2.0}})
    for (const double degrees : {0.0, 35.0, 65.0, 90.0})
      for (const bool at_corners : {false, true})
        for (const double thickness : {0.0, 0.3}) {
          Pull given{.law = glue(failure, exponent), .degrees = degrees, .thickness = thickness};
          given.law.at_corners = at_corners;
          const Pulled found = pull(given);
          const double exact = expected(given.law, degrees).energy;
          std::printf("exponent %.2f, %2.0f degrees: energy %.6f, work %.6f, traction %.1e\n", exponent,
                      degrees, found.energy / exact, found.work / exact, found.worst_traction);
          traction.add(found.worst_traction);
          (degrees == 0 ? opening : degrees == 90 ? sliding : mixed).compare(found.energy / exact, 1);
          EXPECT_NEAR(found.work / exact, 1, 1e-2);
          EXPECT_EQ(found.eroded, 1);
        }
}

/// GAMMA of Benzeggagh & Kenane: the mean stiffness of the mode is not the arithmetic one.
TEST(CohesiveSolids, StiffnessExponentScalesTheEnergyOfMixedModes) {
  Pull given{.law = glue(Failure::BenzeggaghKenane, 2), .degrees = 45};
  const double plain = pull(given).energy;
  given.law.stiffness_exponent = 2;
  const double found = pull(given).energy;
  test::verified("one cohesive solid, GAMMA = 2 at 45 degrees: energy over that with GAMMA = 1",
                 "LS-DYNA Keyword User's Manual")
      .near(found / plain, 7 / std::sqrt(58.0), 2e-3);
}

TEST(CohesiveSolids, FloatFollowsDouble) {
  for (const double degrees : {0.0, 35.0, 90.0}) {
    Pull given{.law = glue(Failure::BenzeggaghKenane, 2), .degrees = degrees, .thickness = 0.3};
    const double exact = expected(given.law, degrees).energy;
    given.precision = Precision::Mixed;
    const Pulled found = pull(given);
    EXPECT_NEAR(found.energy / exact, 1, 1e-3) << degrees;
    EXPECT_LT(found.worst_traction, 1e-4) << degrees;
    EXPECT_EQ(found.eroded, 1) << degrees;
  }
}

TEST(CohesiveSolids, PressureIsBorneWhateverTheDamage) {
  Pull given{.law = glue(), .degrees = 180, .travel = 0.01};
  given.law.failed_points = 0;
  const Pulled found = pull(given);
  EXPECT_NEAR(found.energy, 0.5 * 10 * 0.01 * 0.01, 1e-5);
  EXPECT_EQ(found.eroded, 0);
  // Torn first: without INTFAIL the element stays.
  given.degrees = 0;
  given.travel = 0.08;
  const Pulled torn = pull(given);
  EXPECT_EQ(torn.eroded, 0);
  EXPECT_NEAR(torn.energy / given.law.normal_energy, 1, 1e-3);
}

TEST(CohesiveSolids, ElasticOnesBreakAtTheirStrength) {
  Pull given{.law = glue(Failure::Brittle), .degrees = 0};
  for (const auto& [degrees, strength, stiffness] :
       {std::array{0.0, 0.03, 10.0}, std::array{90.0, 0.05, 4.0}}) {
    given.degrees = degrees;
    const Pulled found = pull(given);
    EXPECT_EQ(found.eroded, 1);
    EXPECT_NEAR(found.energy / (0.5 * strength * strength / stiffness), 1, 2e-2) << degrees;
  }
  given.law.normal_strength = 0;
  given.law.shear_strength = 0;
  EXPECT_EQ(pull(given).eroded, 0);
}

/// A free element that turns once about a skew axis, thick or not: no traction, no energy.
TEST(CohesiveSolids, RigidTurnsMakeNoForce) {
  test::Largest energy("cohesive solid that turns once: internal over kinetic energy", "exact", 1e-5);
  for (const double thickness : {0.0, 0.5}) {
    Pull given{.law = glue(), .thickness = thickness};
    model::Model model = one_element(given);
    model.fixed_nodes.clear();
    model.prescribed_motions.clear();
    const std::array<double, 3> spin{2, -1, 3};
    for (Index node = 0; node < 8; ++node) {
      const auto& x = model.nodes.position[node];
      model.initial_velocities.push_back(
          {.node = node,
           .velocity = {spin[1] * x[2] - spin[2] * x[1], spin[2] * x[0] - spin[0] * x[2],
                        spin[0] * x[1] - spin[1] * x[0]},
           .angular_velocity = spin});
    }
    // The faces would fly apart: a plate of shells holds each.
    model.control.end_time = 2;
    model.control.step_scale = 0.9;
    model.materials.push_back(test::elastic_steel());
    model.shell_sections.push_back(test::shell_section(0.2, 2));
    model.parts.push_back(
        {.id = 2, .title = "skin", .section = 0, .material = static_cast<Index>(model.materials.size()) - 1});
    model.shells.push_back({.id = 101, .part = 1, .node = {0, 1, 3, 2}});
    model.shells.push_back({.id = 102, .part = 1, .node = {4, 5, 7, 6}});
    timeloop::Simulation simulation(model, test::execution());
    double largest = 0;
    test::run(simulation, [&](const domain::Domain& domain) {
      largest = test::larger_of(largest, std::fabs(domain.solids[0].internal_energy));
    });
    energy.add(largest / simulation.domain().energy.initial_total);
  }
}

/// Two blocks of steel of 10 x 4 x 4 with a layer between them.
model::Model glued_blocks(const model::Cohesive& law, double density, double thickness) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  model.solid_sections[0].formulation = model::SolidFormulation::SelectiveHexahedron;
  model.parts.push_back({.id = 2, .title = "second", .solid_section = 0, .material = 0});
  std::array<Index, 2> start{};
  for (const Index part : {0, 1})
    start[static_cast<std::size_t>(part)] =
        test::add_box(model, part, 2, 2, 3, [&](double u, double v, double w) {
          return test::Point{4 * u, 4 * v, part * (10 + thickness) + 10 * w};
        });
  const Index layer = test::add_layer(model, law, density);
  const Index upper = start[1];
  const Index lower = start[0] + 27;
  for (Index j = 0; j < 2; ++j)
    for (Index i = 0; i < 2; ++i) {
      const auto corners = [&](Index from) {
        const Index corner = from + 3 * j + i;
        return std::array<Index, 4>{corner, corner + 1, corner + 4, corner + 3};
      };
      const auto a = corners(lower);
      const auto b = corners(upper);
      model.solids.push_back({.id = static_cast<UserId>(model.solids.size()) + 1,
                              .part = layer,
                              .node = {a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]}});
    }
  return model;
}

/// With damage, unlike stiffnesses and a thick layer, momenta and energy are kept all the same.
TEST(CohesiveSolids, MomentaAndEnergyAreKept) {
  for (const double thickness : {0.0, 0.5}) {
    model::Model model = glued_blocks(glue(), 1e-6, thickness);
    for (Index i = 0; i < model.nodes.count(); ++i)
      model.initial_velocities.push_back(
          {.node = i,
           .velocity = {10 * std::sin(1.0 * i), 10 * std::sin(2.0 * i), 10 * std::sin(3.0 * i)},
           .angular_velocity = {}});
    model.control.end_time = 0.05;
    timeloop::Simulation simulation(model, test::execution());
    test::Conservation kept;
    test::run(simulation, [&](const domain::Domain& domain) { kept.watch(domain); });
    std::printf("thickness %.1f: moment of momentum %.1e, momentum %.1e, energy %.1e, gone %d\n", thickness,
                kept.turning_drift, kept.momentum_drift, kept.worst_imbalance,
                simulation.domain().solids[2].eroded);
    EXPECT_GT(simulation.domain().solids[2].eroded, 0);
    EXPECT_LT(kept.momentum_drift, 1e-13);
    EXPECT_LT(kept.turning_drift, 1e-12);
    EXPECT_LT(kept.worst_imbalance, 5e-4);
  }
}

/// The largest energy of glued blocks that are struck, over that of the blow; `scale` is TSSFAC.
double largest_energy(double stiffness, double density, double thickness, double scale, long cycles) {
  model::Cohesive law = glue(Failure::Brittle);
  law.youngs_modulus = stiffness;
  law.shear_stiffness = 0.7 * stiffness;
  law.normal_strength = 0;
  law.shear_strength = 0;
  model::Model model = glued_blocks(law, density, thickness);
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back(
        {.node = i,
         .velocity = {1e-4 * std::sin(1.0 * i), 1e-4 * std::sin(2.0 * i), 1e-4 * std::sin(3.0 * i)},
         .angular_velocity = {}});
  model.control.end_time = 1e6;
  model.control.step_scale = scale;
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  const domain::EnergyLedger& energy = simulation.domain().energy;
  double largest = 0;
  for (long cycle = 0; cycle < cycles; ++cycle) {
    simulation.step();
    largest = test::larger_of(largest, (energy.kinetic + energy.internal) / energy.initial_total);
  }
  return largest;
}

/// Stiffness from far below to far above that of the blocks, mass from nothing to more than theirs.
TEST(CohesiveSolids, AreStableAtTheDefaultStep) {
  test::Largest gain("glued blocks that are struck: energy gained, over that of the blow", "stability", 1e-3);
  for (const double stiffness : {1.0, 100.0, 1e4})
    for (const double density : {1e-10, 1e-6, 1e-4})
      for (const double thickness : {0.0, 0.5, 2.0}) {
        const double found = largest_energy(stiffness, density, thickness, 0.9, 3000);
        std::printf("stiffness %.0f, density %.0e, thickness %.1f: %.4f\n", stiffness, density, thickness,
                    found);
        gain.add(std::max(0.0, found - 1));
      }
  // Nor is the step a fraction of what it could be.
  EXPECT_THROW(largest_energy(1e4, 1e-6, 0, 1.6, 3000), Error);
}

TEST(CohesiveSolids, RefuseWhatCannotSoftenAndWhatHasNoArea) {
  model::Cohesive law = glue();
  law.youngs_modulus = 1;  // stores 0.03^2 / 2 before it softens
  EXPECT_THROW(pull({.law = law}), Error);
  model::Model model = one_element({.law = glue()});
  std::swap(model.solids[0].node[1], model.solids[0].node[2]);
  std::swap(model.solids[0].node[5], model.solids[0].node[6]);
  EXPECT_THROW(timeloop::Simulation(model, test::execution()), Error);
  model = one_element({.law = glue(), .thickness = 0.1});
  std::swap_ranges(model.solids[0].node.begin(), model.solids[0].node.begin() + 4,
                   model.solids[0].node.begin() + 4);
  EXPECT_THROW(timeloop::Simulation(model, test::execution()), Error);
  model = one_element({.law = glue()});
  model.solid_sections[0].formulation = model::SolidFormulation::OnePointHexahedron;
  EXPECT_THROW(timeloop::Simulation(model, test::execution()), Error);
}

/// The faces that a layer holds together are hidden from contact until it goes; its own never are surfaces.
/// The blocks are drawn apart until it has gone, and pressed together after.
TEST(CohesiveSolids, HideFacesFromContactUntilTheyGo) {
  model::Model model = glued_blocks(glue(), 1e-6, 0);
  model.contacts.push_back(model::self_contact(1, "all", {0, 1, 2}));
  // With a factor of 1 the contact would give as much as the blocks do.
  model.contacts[0].side[0].stiffness_scale = 10;
  constexpr double apart = 0.1;
  constexpr double together = -0.02;
  model.curves.push_back({1, {0, 0.2, 0.5, 1e6}, {0, apart, together, together}});
  std::vector<Index> lower;
  std::vector<Index> upper;
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const double z = model.nodes.position[node][2];
    if (z < 1e-9)
      model.fixed_nodes.push_back({.node = node, .translation = {true, true, true}, .rotation = {}});
    if (z > 20 - 1e-9)
      for (int axis = 0; axis < 3; ++axis)
        model.prescribed_motions.push_back({.node = node,
                                            .axis = axis,
                                            .kind = model::PrescribedMotion::Kind::Displacement,
                                            .curve = 0,
                                            .scale = axis == 2 ? 1.0 : 0.0});
    if (std::fabs(z - 10) < 1e-9) (node < 36 ? lower : upper).push_back(node);
  }
  model.control.end_time = 0.55;
  timeloop::Simulation simulation(model, test::execution());
  double deepest = 0;
  double contact_before = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.solids[2].eroded < domain.solids[2].elements)
      contact_before = test::larger_of(contact_before, std::fabs(domain.energy.contact));
    for (std::size_t k = 0; k < lower.size(); ++k)
      deepest = test::larger_of(
          deepest, test::displacement(domain, lower[k]).z - test::displacement(domain, upper[k]).z);
  });
  const domain::Domain& domain = simulation.domain();
  std::printf("deepest %.4f, contact before %.1e, at the end %.1e\n", deepest, contact_before,
              domain.energy.contact);
  EXPECT_EQ(domain.solids[2].eroded, 4);
  EXPECT_EQ(contact_before, 0);
  EXPECT_LT(deepest, 0.25 * std::fabs(together));
}

}  // namespace
}  // namespace crumple::cohesive_solids_test
