// SPDX-License-Identifier: BSD-3-Clause
//
// Ties that soften (OPTION 6, 8, 9, 11 of *CONTACT_..._TIEBREAK): two blocks are pulled apart along rays of
// all modes. The work over the area is the energy that the criterion of mixed modes gives, the largest force
// is the strength.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <tuple>

#include "base/error.hpp"
#include "support/largest.hpp"
#include "support/rigid.hpp"
#include "support/tied_runs.hpp"
#include "support/verified.hpp"

namespace crumple::cohesive_ties_test {
namespace {

using Law = model::TieSoftening::Law;

constexpr double area = 16;
constexpr model::TieFailure strengths{.normal_strength = 0.03, .shear_strength = 0.05};
constexpr double tension_energy = 0.0004;
constexpr double shear_energy = 0.001;
constexpr double normal_stiffness = 10;
constexpr double shear_ratio = 0.4;

model::TieSoftening softening(Law law, double exponent) {
  return {.law = law,
          .normal_energy = tension_energy,
          .shear_energy = shear_energy,
          .exponent = exponent,
          .critical_opening = 0.05,
          .shear_ratio = shear_ratio,
          .stiffness = normal_stiffness};
}

/// Two rigid blocks, 0.3 apart; the first is held, the second is pulled along x and y and does not turn.
model::Model pulled_blocks(const model::TieSoftening& given, double degrees) {
  model::Model model = test::two_blocks(2, 3, 2, model::TieMethod::Penalty, 0.3);
  model.tied_contacts[0].tolerance = 1;
  model.tied_contacts[0].failure = strengths;
  model.tied_contacts[0].softening = given;
  model.rigid_bodies.reserve(2);
  test::make_rigid(model, 0).fixed_translation = {true, true, true};
  test::make_rigid(model, 1);
  for (model::RigidBody& body : model.rigid_bodies) body.fixed_rotation = {true, true, true};
  test::add_constant_curve(model, 1.0);
  const double angle = degrees * M_PI / 180;
  constexpr double pace = 0.5;
  if (degrees < 90)
    model.prescribed_motions.push_back({.body = 1, .axis = 0, .curve = 0, .scale = pace * std::cos(angle)});
  if (degrees > 0)
    model.prescribed_motions.push_back({.body = 1, .axis = 1, .curve = 0, .scale = pace * std::sin(angle)});
  model.control.step_scale = 0.2;
  model.control.end_time = 0.12;
  return model;
}

struct Pulled {
  double work = 0;           ///< over the area
  double largest_force = 0;  ///< likewise
  Index broken = 0;
  double imbalance = 0;  ///< over the work
};

Pulled pull(const model::TieSoftening& given, double degrees) {
  const model::Model model = pulled_blocks(given, degrees);
  timeloop::Simulation simulation(model, test::execution());
  Pulled found;
  test::run(simulation, [&](const domain::Domain& domain) {
    found.largest_force = test::larger_of(found.largest_force, norm(domain.ties[0].force) / area);
  });
  const domain::Domain& domain = simulation.domain();
  found.work = domain.ties[0].energy / area;
  found.broken = domain.ties[0].broken;
  found.imbalance = std::fabs(domain.energy.imbalance()) / domain.ties[0].energy;
  return found;
}

/// Stress at which ties yield on a ray, and the energy until they are gone, by the criteria.
struct Expected {
  double force = 0;
  double energy = 0;
};

Expected expected(const model::TieSoftening& given, double degrees) {
  const double across = std::cos(degrees * M_PI / 180);
  const double along = degrees == 0 ? 0 : std::sin(degrees * M_PI / 180);
  const double normal = normal_stiffness * across;
  const double shear = shear_ratio * normal_stiffness * along;
  const double onset = 1 / std::hypot(normal / strengths.normal_strength, shear / strengths.shear_strength);
  const double share = shear * along / (normal * across + shear * along);  // of mode II in the energy
  const double power = std::pow(
      std::pow((1 - share) / tension_energy, given.exponent) + std::pow(share / shear_energy, given.exponent),
      -1 / given.exponent);
  const double kenane = tension_energy + (shear_energy - tension_energy) * std::pow(share, given.exponent);
  return {onset * std::hypot(normal, shear), given.law == Law::PowerLaw ? power : kenane};
}

TEST(CohesiveTies, TakeTheEnergyOfTheirMode) {
  const std::string blocks = "blocks pulled apart that softening ties hold: ";
  test::Largest opening(blocks + "energy over area in mode I over G_Ic, error", "exact", 1e-3);
  test::Largest sliding(blocks + "energy over area in mode II over G_IIc, error", "exact", 1e-3);
  test::Largest mixed(blocks + "energy over area in mixed modes, error", "power law, Benzeggagh and Kenane",
                      1e-3);
  test::Largest force(blocks + "largest force over strength times area, error", "exact", 5e-3);
  for (const auto& [law, exponent] :
       {std::pair{Law::PowerLaw, 1.0}, {Law::PowerLaw, 1.45}, {Law::BenzeggaghKenane, 2.0}})
    for (const double degrees : {0.0, 35.0, 65.0, 90.0}) {
      const model::TieSoftening given = softening(law, exponent);
      const Pulled found = pull(given, degrees);
      const Expected exact = expected(given, degrees);
      std::printf("exponent %.2f, %2.0f degrees: energy %.6f, force %.5f, broken %d, imbalance %.1e\n",
                  exponent, degrees, found.work / exact.energy, found.largest_force / exact.force,
                  found.broken, found.imbalance);
      (degrees == 0 ? opening : degrees == 90 ? sliding : mixed).compare(found.work / exact.energy, 1);
      force.compare(found.largest_force / exact.force, 1);
      EXPECT_EQ(found.broken, 16);
      EXPECT_LT(found.imbalance, 1e-12);
    }
}

TEST(CohesiveTies, CriticalOpening) {
  const Pulled tension = pull(softening(Law::CriticalOpening, 1), 0);
  const Pulled shear = pull(softening(Law::CriticalOpening, 1), 90);
  test::verified("ties that soften up to a critical opening: energy in tension over S CCRIT / 2",
                 "LS-DYNA Keyword User's Manual")
      .near(tension.work / (0.5 * 0.03 * 0.05), 1, 1e-3);
  test::verified("ties that soften up to a critical opening: energy in shear over S CCRIT / 2",
                 "LS-DYNA Keyword User's Manual")
      .near(shear.work / (0.5 * 0.05 * 0.05), 1, 1e-3);
  EXPECT_EQ(tension.broken, 16);
  EXPECT_EQ(shear.broken, 16);
}

/// The springs bear unlike stiffness across and along, and damage: momenta must be kept all the same.
TEST(CohesiveTies, MomentaAndEnergyAreKept) {
  model::Model model = test::two_blocks(2, 3, 4, model::TieMethod::Penalty, 0.5);
  model.tied_contacts[0].tolerance = 1;
  model.tied_contacts[0].failure = strengths;
  model.tied_contacts[0].softening = softening(Law::PowerLaw, 1.5);
  test::expect_kept_when_shaken(model);
}

/// A small cube beside the blocks gives the step until it erodes, before damage begins. The stiffness that
/// the first step has cut stays, and with it strength and energy: the step grows no further than it allows.
TEST(CohesiveTies, KeepEnergyAndStrengthWhenTheStepGrows) {
  model::TieSoftening given = softening(Law::PowerLaw, 1);
  given.stiffness = 1000;
  model::Model model = pulled_blocks(given, 0);
  model::Material brittle = model.materials[0];
  brittle.id = 9;
  brittle.erosion = model::ErosionCriteria{.time = 0.002};
  model.materials.push_back(brittle);
  const auto eroding = static_cast<Index>(model.materials.size()) - 1;
  for (const auto& [id, material, size] : {std::tuple{3, eroding, 0.5}, {4, Index{0}, 4.0}}) {
    model.parts.push_back({.id = id, .title = "beside", .solid_section = 0, .material = material});
    test::add_box(model, static_cast<Index>(model.parts.size()) - 1, 1, 1, 1,
                  [size = size](double u, double v, double w) {
                    return test::Point{size * u, 50 * size + size * v, size * w};
                  });
  }
  model.control.step_scale = 0.9;
  timeloop::Simulation simulation(model, test::execution());
  double first_step = 0;
  double force = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (first_step == 0) first_step = domain.clock.step;
    force = test::larger_of(force, norm(domain.ties[0].force) / area);
  });
  const domain::Domain& domain = simulation.domain();
  std::printf("energy %.6f, force %.5f, step %.3g, at the end %.3g\n",
              domain.ties[0].energy / area / tension_energy, force / strengths.normal_strength, first_step,
              domain.clock.step);
  EXPECT_GT(domain.clock.element_limit, 3 * first_step) << "so that the step could grow";
  test::verified("ties that soften while the stable step grows: energy over area over G_Ic", "exact")
      .near(domain.ties[0].energy / area / tension_energy, 1, 1e-3);
  test::verified("ties that soften while the stable step grows: largest force over strength", "exact")
      .near(force / strengths.normal_strength, 1, 0.02);
  EXPECT_EQ(domain.ties[0].broken, 16);
}

/// test::run takes the run up again halfway with another number of threads and compares the bits: here in the
/// middle of the softening, with more springs than a thread takes at a time.
TEST(CohesiveTies, AreTakenUpHalfDamaged) {
  model::Model model = test::two_blocks(2, 9, 1, model::TieMethod::Penalty, 0.3);
  const model::Model pulled = pulled_blocks(softening(Law::PowerLaw, 1), 35);
  model.tied_contacts = pulled.tied_contacts;
  model.rigid_bodies.reserve(2);
  for (Index part = 0; part < 2; ++part) {
    test::make_rigid(model, part);
    model.rigid_bodies.back().fixed_rotation = {true, true, true};
  }
  model.rigid_bodies[0].fixed_translation = {true, true, true};
  model.curves = pulled.curves;
  model.prescribed_motions = pulled.prescribed_motions;
  model.control.step_scale = 0.2;
  model.control.end_time = 0.05;
  timeloop::Simulation simulation(model, test::execution());
  double halfway = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.clock.time < 0.5 * model.control.end_time) halfway = domain.ties[0].energy;
  });
  const domain::Tie& tie = simulation.domain().ties[0];
  EXPECT_EQ(tie.nodes.size(), 100U);
  EXPECT_GT(halfway, 0.3 * tie.energy);
  EXPECT_LT(halfway, 0.95 * tie.energy);
}

TEST(CohesiveTies, SaysWhereTheyCannotSoften) {
  model::TieSoftening given = softening(Law::PowerLaw, 1);
  given.stiffness = 0.5;
  const model::Model model = pulled_blocks(given, 0);
  timeloop::Simulation simulation(model, test::execution());
  try {
    test::run(simulation);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot soften in tension"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace crumple::cohesive_ties_test
