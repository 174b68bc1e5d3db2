// SPDX-License-Identifier: BSD-3-Clause
// One spot weld beam whose ends are moved: stiffness, yield, failure against closed forms.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "domain/build.hpp"
#include "elements/elements.hpp"
#include "support/largest.hpp"
#include "support/verified.hpp"

namespace crumple::elements::spot_weld_beam_test {
namespace {

using domain::Domain;
using math::Vec3;

constexpr double pi = std::numbers::pi;
constexpr double diameter = 5;
constexpr double length = 2;
constexpr double area = pi * diameter * diameter / 4;
constexpr double inertia = area * diameter * diameter / 16;
constexpr double shear_modulus = 210 / 2.6;

/// kN, mm, ms: stays elastic, never fails.
model::SpotWeldLaw elastic_weld() {
  return {.youngs_modulus = 210, .poissons_ratio = 0.3, .yield_stress = 1e6, .hardening = 0};
}

/// From the origin along x; s is y, t is z.
model::Model weld_along_x(const model::SpotWeldLaw& law, double inner_diameter = 0) {
  model::Model model;
  const double square = diameter * diameter - inner_diameter * inner_diameter;
  const double second = pi / 64 * square * (diameter * diameter + inner_diameter * inner_diameter);
  model.materials.push_back({.id = 1, .title = "", .density = 7.85e-6, .law = law});
  model.beam_sections.push_back({.id = 1,
                                 .title = "",
                                 .formulation = model::BeamFormulation::SpotWeld,
                                 .area = pi / 4 * square,
                                 .inertia_s = second,
                                 .inertia_t = second,
                                 .torsion = 2 * second,
                                 .shear_area = pi / 4 * square});
  model.parts.push_back({.id = 1, .title = "", .beam_section = 0, .material = 0});
  model.nodes.id = {1, 2};
  model.nodes.position = {{{0, 0, 0}, {length, 0, 0}}};
  model.beams.push_back({.id = 1, .part = 0, .node = {0, 1}, .orientation = {0, 1, 0}});
  return model;
}

/// What the ends do in one step, besides the first, which only turns.
struct Move {
  Vec3 second;
  std::array<Vec3, 2> turn;
};

/// Stretch, slides along t and s, twist, bends about s and t, each by one.
Move unit_move(std::size_t mode) {
  switch (mode) {
    case 0:
      return {{1, 0, 0}, {}};
    case 1:
      return {{0, 0, 1}, {}};
    case 2:
      return {{0, 1, 0}, {}};
    case 3:
      return {{}, {Vec3{-0.5, 0, 0}, Vec3{0.5, 0, 0}}};
    case 4:
      return {{}, {Vec3{0, -0.5, 0}, Vec3{0, 0.5, 0}}};
    default:
      return {{}, {Vec3{0, 0, -0.5}, Vec3{0, 0, 0.5}}};
  }
}

using Modes = std::array<double, 6>;

class Weld {
 public:
  explicit Weld(const model::Model& model) : model_(model), domain_(domain::build(model_, {})) {
    prepare_elements(model_, domain_);
    add_element_forces(domain_);
  }

  void move(const Modes& by) {
    domain::NodeFields& nodes = domain_.nodes;
    const auto ends = block().nodes_of(0);
    for (const Index end : ends) {
      nodes.angular_velocity[end] = {};
      nodes.force[end] = {};
    }
    for (std::size_t mode = 0; mode < 6; ++mode) {
      const Move unit = unit_move(mode);
      nodes.position[ends[1]] += by[mode] * unit.second;
      for (std::size_t end = 0; end < 2; ++end)
        nodes.angular_velocity[ends[end]] += by[mode] * unit.turn[end];
    }
    domain_.clock.step = 1;
    domain_.clock.time += 1;
    add_element_forces(domain_);
  }

  /// Axial force, shear along t and s, torsion, mean moments about s and t, all but for their signs.
  Modes resultants() const {
    const auto q = [&](Index i) { return item("resultant", i); };
    return {q(0), (q(2) + q(4)) / length, (q(3) + q(5)) / length,
            q(1), 0.5 * (q(2) - q(4)),    0.5 * (q(3) - q(5))};
  }
  double item(const char* name, Index which = 0) const {
    return block().state(0, block().find(name)->first + which);
  }
  const domain::BeamBlock& block() const { return domain_.beams[0]; }
  const Domain& domain() const { return domain_; }

 private:
  model::Model model_;
  Domain domain_;
};

Modes only(std::size_t mode, double by) {
  Modes modes{};
  modes[mode] = by;
  return modes;
}

Modes stiffnesses() {
  const double sliding =
      1 / (length * length * length / (12 * 210 * inertia) + length / (shear_modulus * area));
  const double bending = 210 * inertia / length;
  return {210 * area / length, sliding, sliding, shear_modulus * 2 * inertia / length, bending, bending};
}

/// At which the whole section yields, over the yield stress: those of a tube are differences.
Modes capacities(double inner = 0) {
  const double cubes = diameter * diameter * diameter - inner * inner * inner;
  const double a = pi / 4 * (diameter * diameter - inner * inner);
  const double root = std::numbers::sqrt3;
  return {a, a / root, a / root, pi * cubes / 12 / root, cubes / 6, cubes / 6};
}

TEST(SpotWeldBeam, IsAsStiffAsTimoshenkosBeam) {
  test::Largest off("spot weld beam: stiffnesses of its six modes, error", "Timoshenko beam", 1e-8);
  const Modes exact = stiffnesses();
  for (std::size_t mode = 0; mode < 6; ++mode) {
    Weld weld(weld_along_x(elastic_weld()));
    constexpr double size = 1e-7;
    weld.move(only(mode, size));
    off.compare(std::fabs(weld.resultants()[mode]) / size, exact[mode], exact[mode], std::to_string(mode));
  }
}

TEST(SpotWeldBeam, YieldsInEveryModeAsItsWholeSectionDoes) {
  test::Largest off("spot weld beam: resultant beyond yield, error", "closed form of each mode", 1e-5);
  for (const double inner : {0.0, 3.0})
    for (std::size_t mode = 0; mode < 6; ++mode) {
      model::SpotWeldLaw law = elastic_weld();
      law.yield_stress = 0.01;  // small: slides also stretch, with their square
      law.hardening = 2;
      Weld weld(weld_along_x(law, inner));
      const double q = capacities(inner)[mode];
      const double square = diameter * diameter - inner * inner;
      const double a = pi / 4 * square;
      const double second = pi / 64 * square * (diameter * diameter + inner * inner);
      const double sliding =
          1 / (length * length * length / (12 * 210 * second) + length / (shear_modulus * a));
      const Modes k{
          210 * a / length,     sliding, sliding, shear_modulus * 2 * second / length, 210 * second / length,
          210 * second / length};
      const double volume = a * length;
      // Five times the deformation at yield, small enough for chord and axes to stay where they are.
      const double deformation = 5 * law.yield_stress * q / k[mode];
      constexpr int steps = 50;
      for (int step = 0; step < steps; ++step) weld.move(only(mode, deformation / steps));
      const double strain =
          (k[mode] * deformation / q - law.yield_stress) / (law.hardening + k[mode] * volume / (q * q));
      const double exact = q * (law.yield_stress + law.hardening * strain);
      off.compare(std::fabs(weld.resultants()[mode]), exact, exact, std::to_string(mode));
      EXPECT_NEAR(weld.item("plastic_strain"), strain, 3e-3 * strain) << mode;
    }
}

TEST(SpotWeldBeam, StaysOnItsYieldSurfaceAndDissipatesWhatTheStressDoes) {
  model::SpotWeldLaw law = elastic_weld();
  law.yield_stress = 0.3;
  law.hardening = 1;
  Weld weld(weld_along_x(law));
  const Modes q_of = capacities();
  const Modes k = stiffnesses();
  // All modes at once, in a way that turns: from stretch and twist to slide and bend.
  constexpr int steps = 400;
  double off_surface = 0;
  for (int step = 0; step < steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    Modes by{};
    for (std::size_t mode = 0; mode < 6; ++mode)
      by[mode] =
          6 * law.yield_stress * q_of[mode] / k[mode] / steps * (mode % 2 == 0 ? 1 - share : 2 * share - 0.5);
    weld.move(by);
    const double yield = law.yield_stress + law.hardening * weld.item("plastic_strain");
    double square = 0;
    for (std::size_t mode = 0; mode < 6; ++mode) square += std::pow(weld.resultants()[mode] / q_of[mode], 2);
    EXPECT_LT(std::sqrt(square), yield * (1 + 1e-12));
    if (step > steps / 2) off_surface = std::fmax(off_surface, std::fabs(std::sqrt(square) / yield - 1));
  }
  test::verified("spot weld beam loaded in turning directions: distance from the yield surface", "exact")
      .below(off_surface, 1e-12);
  double energy = 0;
  for (std::size_t mode = 0; mode < 6; ++mode)
    energy += 0.5 * weld.resultants()[mode] * weld.resultants()[mode] / k[mode];
  const double strain = weld.item("plastic_strain");
  energy += area * length * strain * (law.yield_stress + 0.5 * law.hardening * strain);
  // The trapezoidal rule over 400 steps, most of them plastic.
  test::verified("spot weld beam loaded in turning directions: work over elastic and plastic energy",
                 "own derivation")
      .near(weld.block().internal_energy / energy, 1, 1e-3);
}

TEST(SpotWeldBeam, FailsWhereTheCriterionOfItsResultantsSays) {
  model::SpotWeldLaw law = elastic_weld();
  law.tension_strength = 0.6;
  law.shear_strength_s = 0.4;
  law.shear_strength_t = 0.3;
  law.torsion_strength = 0.8;
  law.bending_strength_s = 0.7;
  law.bending_strength_t = 0.5;
  const Modes strength{0.6, 0.3, 0.4, 0.8, 0.7, 0.5};
  const Modes k = stiffnesses();
  const auto steps_to_failure = [&](const Modes& share, bool tension) {
    constexpr double per_step = 1e-3;
    Weld weld(weld_along_x(law));
    Modes by{};
    double square = 0;
    for (std::size_t mode = 0; mode < 6; ++mode) {
      by[mode] = per_step * share[mode] * strength[mode] / k[mode];
      if (mode > 0 || tension) square += share[mode] * share[mode];
    }
    if (!tension) by[0] = -by[0];
    int step = 0;
    while (weld.item("active") != 0 && step < 3000) {
      weld.move(by);
      ++step;
    }
    EXPECT_EQ(weld.block().eroded, square > 0 ? 1 : 0);
    EXPECT_EQ(weld.resultants()[0] == 0, square > 0);
    return std::pair{step * per_step, square > 0 ? 1 / std::sqrt(square) : 3.0};
  };
  // A step is a thousandth of a strength, and the least load at failure about half of one.
  test::Largest off("spot weld beam: load at failure over that of the criterion", "exact", 2.1e-3);
  for (std::size_t mode = 0; mode < 6; ++mode) {
    const auto [found, exact] = steps_to_failure(only(mode, 1), true);
    off.compare(found, exact, exact, std::to_string(mode));
  }
  const auto [pull_and_shear, exact] = steps_to_failure({0.8, 0.6, 0.3, 0, 0, 0}, true);
  off.compare(pull_and_shear, exact, exact, "pull and shear");
  const auto [peel, exact_peel] = steps_to_failure({0.7, 0, 0, 0, 0, 0.7}, true);
  off.compare(peel, exact_peel, exact_peel, "peel");
  const auto [all, exact_all] = steps_to_failure({0.5, 0.5, 0.5, 0.5, 0.5, 0.5}, true);
  off.compare(all, exact_all, exact_all, "all");
  const auto [pressed, exact_pressed] = steps_to_failure({1, 0, 0.5, 0, 0, 0}, false);
  off.compare(pressed, exact_pressed, exact_pressed, "pressure does not count");
  EXPECT_EQ(steps_to_failure({1, 0, 0, 0, 0, 0}, false).first, 3.0) << "pressure alone breaks nothing";
}

TEST(SpotWeldBeam, FailsByPlasticStrainAndAtATime) {
  model::SpotWeldLaw law = elastic_weld();
  law.yield_stress = 0.3;
  law.failure_strain = 0.02;
  Weld weld(weld_along_x(law));
  int step = 0;
  for (; weld.item("active") != 0 && step < 1000; ++step) weld.move(only(0, length * 1e-4));
  // Perfectly plastic: the strain is the plastic one and that at yield, 0.3 / 210.
  EXPECT_EQ(step, static_cast<int>(std::ceil((0.02 + 0.3 / 210) / 1e-4)));
  EXPECT_EQ(weld.item("failure_time"), step);
  EXPECT_EQ(weld.block().internal_energy, 0) << "all of it has eroded";
  EXPECT_GT(weld.block().eroded_energy, 0);

  law = elastic_weld();
  law.failure_time = 7;
  Weld timed(weld_along_x(law));
  for (int i = 1; i <= 10; ++i) {
    timed.move(only(1, 1e-6));
    EXPECT_EQ(timed.item("active") != 0, i < 7) << i;
  }
  EXPECT_EQ(timed.item("failure_time"), 7);
}

TEST(SpotWeldBeam, NoNumbersComeFromAFailedWeldOfAnyShape) {
  model::SpotWeldLaw law = elastic_weld();
  law.failure_time = 1;
  Weld weld(weld_along_x(law));
  weld.move({});
  weld.move(only(0, -length));      // no length
  weld.move(only(0, -3 * length));  // turned round
  for (const Index node : weld.block().nodes_of(0)) {
    const domain::NodeForce& force = weld.domain().nodes.force[node];
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(force.force[axis], 0);
      EXPECT_EQ(force.moment[axis], 0);
    }
  }
  EXPECT_EQ(weld.block().internal_energy, 0);
  for (Index i = 0; i < 6; ++i) EXPECT_EQ(weld.item("deformation", i), 0);
}

TEST(SpotWeldBeam, MassIsAddedForTheStepThatItsMaterialAsksFor) {
  model::SpotWeldLaw law = elastic_weld();
  const Weld weld(weld_along_x(law));
  const double own = stable_step(weld.domain(), weld.block());
  EXPECT_EQ(weld.domain().added_mass, 0);
  law.least_step = 4 * own;
  const Weld heavy(weld_along_x(law));
  const double mass = 7.85e-6 * area * length;
  test::verified("spot weld beam with DT four times its step: added mass over its own", "exact")
      .near(heavy.domain().added_mass / mass, 15, 1e-9);
  EXPECT_NEAR(stable_step(heavy.domain(), heavy.block()), 4 * own, 1e-12 * own);
  law.least_step = 0.5 * own;
  EXPECT_EQ(Weld(weld_along_x(law)).domain().added_mass, 0);
}

}  // namespace
}  // namespace crumple::elements::spot_weld_beam_test
