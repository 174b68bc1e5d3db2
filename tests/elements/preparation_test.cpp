// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numeric>

#include "base/error.hpp"
#include "elements/lone_elements.hpp"
#include "shell_harness.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"
#include "support/rigid.hpp"

namespace crumple::elements::testing::preparation_test {
namespace {

using model::ShellFormulation;

double total_mass(const Driven& body) {
  return std::accumulate(body.domain.nodes.mass.begin(), body.domain.nodes.mass.end(), 0.0);
}

TEST(Preparation, MassIsThatOfThePlate) {
  test::Largest off("five shells, plate of 4 x 4: mass, relative error", "density times volume", 1e-12);
  for (const Kind& kind : kinds) {
    const Driven body(plate(kind.formulation, 4, 0), {});
    off.compare(total_mass(body), density * thickness * 400, density * 600, kind.name);
    for (Index i = 0; i < body.domain.nodes.count(); ++i)
      EXPECT_GE(body.domain.nodes.inertia[i], body.domain.nodes.mass[i] * 25 / 8 * (1 - 1e-12));
  }
}

TEST(Preparation, ATriangleGivesEachCornerAThird) {
  model::Model model = test::one_part(elastic(), test::shell_section(thickness, 2));
  model.nodes.id = {1, 2, 3};
  model.nodes.position = {{0, 0, 0}, {6, 0, 0}, {0, 4, 0}};
  model.shells.push_back({.id = 1, .part = 0, .node = {0, 1, 2, 2}});
  Driven body(model, {});
  for (Index i = 0; i < 3; ++i)
    EXPECT_NEAR(body.domain.nodes.mass[i], density * thickness * 4, 1e-12 * density * 6);
  // Twice the area over the longest side, the height, times the factor of a triangle alone.
  const double speed = std::sqrt(youngs_modulus / (density * (1 - poissons_ratio * poissons_ratio)));
  const double lone = LoneElements(model, body.domain).factor(body.domain, body.block(), 0);
  EXPECT_NEAR(lone, 1 / std::sqrt(1 + poissons_ratio), 1e-12);
  test::verified("triangle alone: step times wave speed over its factor",
                 "twice the area over the longest side")
      .near(stable_step(body.domain, body.block()) * speed / lone, 24 / std::sqrt(52.0), 1e-12);
}

TEST(Preparation, StepIsAreaOverLongestSide) {
  test::Largest off("five shells, distorted mesh: step, relative error in units of round-off",
                    "area over the longest side over the wave speed", 10);
  for (const Kind& kind : kinds)
    for (const auto& execution : all_executions()) {
      model::Model model = plate(kind.formulation, 3, 0.2);
      Driven body(model, execution);
      body.update(0);
      double shortest = 1e30;
      UserId slowest = 0;
      const double speed = std::sqrt(youngs_modulus / (density * (1 - poissons_ratio * poissons_ratio)));
      for (const auto& shell : model.shells) {
        const auto at = [&](std::size_t k) {
          const auto& p = model.nodes.position[shell.node[k % 4]];
          return Vec3{p[0], p[1], p[2]};
        };
        double side = 0;
        for (std::size_t k = 0; k < 4; ++k) side = test::larger_of(side, norm(at(k + 1) - at(k)));
        const double step = 0.5 * norm(cross(at(2) - at(0), at(3) - at(1))) / side / speed;
        if (step < shortest) {
          shortest = step;
          slowest = shell.id;
        }
      }
      const double tolerance = 10 * round_off(execution) * shortest;
      off.compare(body.domain.clock.element_limit, shortest, round_off(execution) * shortest,
                  name_of(execution));
      EXPECT_NEAR(stable_step(body.domain, body.block()), shortest, tolerance);
      EXPECT_EQ(controlling_element(model, body.domain).element, slowest);
      EXPECT_EQ(controlling_element(model, body.domain).part, 1);
    }
}

/// A negative DT2MS lifts the short steps to its size and leaves the others alone; a positive one makes all
/// steps equal.
TEST(Preparation, MassScaling) {
  model::Model model = plate(ShellFormulation::BelytschkoTsay, 3, 0.2);
  const Driven plain(model, {});
  const double shortest = stable_step(plain.domain, plain.block());
  model.control.mass_scaling_step = -1.05 * shortest;
  Driven scaled(model, {});
  EXPECT_NEAR(stable_step(scaled.domain, scaled.block()), 1.05 * shortest, 1e-12 * shortest);
  EXPECT_GT(scaled.domain.added_mass, 0);
  test::verified("mass scaling of shells: mass added less that reported, over that of the plate",
                 "sum over the nodes")
      .below(std::fabs(total_mass(scaled) - total_mass(plain) - scaled.domain.added_mass) / total_mass(plain),
             1e-12);
  scaled.update(0);
  test::verified("mass scaling of shells: step over the shortest one", "the step asked for")
      .near(scaled.domain.clock.element_limit / shortest, 1.05, 1e-12);
  model.control.mass_scaling_step = 3 * shortest;
  Driven uniform(model, {});
  double square = 0;
  for (Index e = 0; e < uniform.block().elements; ++e) square += uniform.item("step_scale", e);
  EXPECT_NEAR(stable_step(uniform.domain, uniform.block()), 3 * shortest, 1e-12 * shortest);
  EXPECT_GT(square, 9 * 1.5);
}

TEST(Preparation, ErrorsNameThePartOrTheShell) {
  const auto message = [](const model::Model& model) -> std::string {
    try {
      Driven body(model, {});
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  model::Model model = plate(ShellFormulation::HughesLiu, 2, 0, 11);
  EXPECT_NE(message(model).find("Part 1: 11 integration points"), std::string::npos) << message(model);
  model = plate(ShellFormulation::BelytschkoTsay, 2, 0, 1);
  model.shell_sections[0].thickness_rule = model::ThicknessRule::Lobatto;
  EXPECT_NE(message(model).find("Part 1"), std::string::npos);
  model = plate(ShellFormulation::BelytschkoTsay, 2, 0);
  model.nodes.position[4] = model.nodes.position[0];
  model.nodes.position[1] = model.nodes.position[0];
  model.nodes.position[3] = model.nodes.position[0];
  EXPECT_NE(message(model).find("has no area"), std::string::npos) << message(model);
}

/// Before the first step there is no strain, whatever the velocities.
TEST(Preparation, AStepOfZeroMakesNoStress) {
  for (const Kind& kind : kinds)
    for (const auto& execution : all_executions()) {
      Driven body(plate(kind.formulation, 3, 0.1), execution);
      for (Index i = 0; i < body.domain.nodes.count(); ++i) {
        body.domain.nodes.velocity[i] = {100.0 * i, -3, 2};
        body.domain.nodes.angular_velocity[i] = {1, 2.0 * i, 3};
      }
      body.update(0);
      EXPECT_EQ(body.largest_stress(), 0);
      EXPECT_EQ(body.block().internal_energy, 0);
      EXPECT_EQ(body.block().hourglass_energy, 0);
    }
}

/// Stretching thins the shell: elastic by nu / (1 - nu) of the biaxial strain, logarithmic in large strain.
TEST(Preparation, ThicknessFollowsTheStretchIfAsked) {
  for (const Kind& kind : kinds) {
    model::Model model = plate(kind.formulation, 2, 0.1);
    model.control.thickness_change = true;
    Driven body(model, {Precision::Double, available_isas().back(), 1});
    const double factor = std::exp(1e-4);
    for (int i = 0; i < 1000; ++i)
      body.step(
          1e-7,
          [&](const Vec3& x) {
            return Vec3{factor * x.x, factor * x.y, 0};
          },
          [](const Vec3&) { return Vec3{}; });
    // ln(t / t0) = -2 nu / (1 - nu) * 0.1; one Euler step of thickness errs by half its square.
    const double expected = thickness * std::exp(-2 * poissons_ratio / (1 - poissons_ratio) * 0.1);
    test::verified(std::string(kind.name) + ", stretched by 10 %: thickness over that at first",
                   "exp(-2 nu / (1 - nu) e)")
        .near(body.item("thickness", 0) / thickness, expected / thickness, 1e-5);
    model.control.thickness_change = false;
    Driven rigid(model, {Precision::Double, available_isas().back(), 1});
    rigid.step(
        1e-7,
        [&](const Vec3& x) {
          return Vec3{1.01 * x.x, x.y, 0};
        },
        [](const Vec3&) { return Vec3{}; });
    EXPECT_EQ(rigid.item("thickness", 0), thickness);
  }
}

/// A fluid has no stiffness of its own; its equation of state sets the step, and small rigid elements do not.
TEST(Preparation, RigidElementsBesideAFluidDoNotLimitTheStep) {
  model::Model model =
      test::one_solid_part({.id = 1, .title = "water", .density = 1e-6, .law = model::NullMaterial{}});
  model.equations_of_state.push_back(
      {.id = 1, .title = "water", .law = model::LinearPolynomial{{0, 2.2, 0, 0, 0, 0, 0}}});
  model.parts[0].equation_of_state = 0;
  model.materials.push_back(elastic());
  model.parts.push_back({.id = 2, .title = "rigid", .solid_section = 0, .material = 1});
  const auto box = [](double side, double x) {
    return [=](double u, double v, double w) { return test::Point{x + side * u, side * v, side * w}; };
  };
  test::add_box(model, 0, 1, 1, 1, box(2, 0));
  test::add_box(model, 1, 1, 1, 1, box(0.01, 5));
  test::make_rigid(model, 1);
  Driven body(model, {});
  body.update(0);
  // 2 / omega of the cube that breathes, with the linear bulk viscosity of 0.06.
  test::verified("hexahedron of water: step", "edge over sqrt(3 K / rho), with bulk viscosity")
      .near(body.domain.clock.element_limit, 2 / std::sqrt(3 * 2.2 / 1e-6) / (0.06 + std::hypot(0.06, 1)),
            1e-12);
}

}  // namespace
}  // namespace crumple::elements::testing::preparation_test
