// SPDX-License-Identifier: BSD-3-Clause
// Elements whose points have all failed.
#include <gtest/gtest.h>

#include <numeric>

#include "elements/shell_harness.hpp"
#include "support/verified.hpp"

namespace crumple::elements::testing::erosion_test {
namespace {

constexpr double failure_strain = 0.05;

model::Material failing() {
  model::Material material = plastic();
  std::get<model::PlasticKinematic>(material.law).failure_strain = failure_strain;
  return material;
}

/// Two by two elements; the two of greater x are stretched until they fail, the others are not.
struct Torn {
  explicit Torn(const domain::Execution& execution, model::ShellFormulation formulation, bool stiff_hourglass)
      : body(model_of(formulation, stiff_hourglass), execution) {}

  static model::Model model_of(model::ShellFormulation formulation, bool stiff_hourglass) {
    model::Model model = plate(formulation, 2, 0, 3, failing());
    if (stiff_hourglass) model.control.hourglass = {model::HourglassForm::Stiffness, 0.05, 0.05, 0.05};
    return model;
  }
  void stretch(double factor) {
    body.step(
        1e-6,
        [&](const Vec3& x) {
          return Vec3{x.x > 5 ? 5 + factor * (x.x - 5) : x.x, x.y, 0};
        },
        [](const Vec3&) { return Vec3{}; });
  }

  Driven body;
};

TEST(Erosion, TakesForceEnergyAndStepOfTheElement) {
  for (const Kind& kind : kinds)
    for (const auto& execution : all_executions()) {
      Torn torn(execution, kind.formulation, false);
      Driven& body = torn.body;
      const double mass = std::accumulate(body.domain.nodes.mass.begin(), body.domain.nodes.mass.end(), 0.0);
      double work = 0;  // of one element, from its stresses and the strain that is put on it
      int steps = 0;
      while (body.block().eroded == 0 && steps < 200) {
        const double before = body.block().internal_energy;
        torn.stretch(1.001);
        ++steps;
        if (body.block().eroded == 0)
          work = body.block().internal_energy;
        else
          work = before;
      }
      const std::string name = name_of(execution) + " " + kind.name;
      ASSERT_EQ(body.block().eroded, 2) << name;
      EXPECT_EQ(body.block().hourglass_energy, 0);
      // All energy was in the two; the step of failure adds the last trapezoid, half of a whole step's work.
      EXPECT_GT(work, 0);
      EXPECT_GT(body.block().eroded_energy, work);
      EXPECT_LT(body.block().eroded_energy, 1.03 * work);
      EXPECT_NEAR(body.block().internal_energy, 0, 1e-5 * work);
      EXPECT_EQ(std::accumulate(body.domain.nodes.mass.begin(), body.domain.nodes.mass.end(), 0.0), mass);

      const double eroded = body.block().eroded_energy;
      torn.stretch(1.01);
      for (Index i = 0; i < body.domain.nodes.count(); ++i) {
        EXPECT_EQ(norm(body.force(i)), 0) << name;
        EXPECT_EQ(norm(body.moment(i)), 0) << name;
      }
      EXPECT_EQ(body.block().eroded_energy, eroded);
      EXPECT_EQ(body.block().eroded, 2);
      EXPECT_LT(body.domain.clock.element_limit, 1e29) << "the two others still limit the step";
      int active = 0;
      for (Index e = 0; e < 4; ++e) active += body.item("active", e) == 1 ? 1 : 0;
      EXPECT_EQ(active, 2);
    }
}

/// The energy that leaves is the work of stress on strain, added up here from the stresses themselves.
TEST(Erosion, ErodedEnergyIsTheWorkDoneOnTheElement) {
  for (const Kind& kind : kinds) {
    Torn torn({Precision::Double, available_isas().back(), 1}, kind.formulation, false);
    Driven& body = torn.body;
    Index stretched = 0;
    double work = 0;
    double length = 5;
    std::array<double, 3> stress{};
    for (int step = 0; step < 200 && body.block().eroded == 0; ++step) {
      torn.stretch(1.001);
      if (step == 0)
        for (Index e = 0; e < 4; ++e)
          if (body.stress(e, 0, 0) > 1) stretched = e;
      // Strain and area at the middle of the step.
      const double next = 1.001 * length;
      const double volume = thickness * 5 * 0.5 * (length + next);
      const double strain = (next - length) / (0.5 * (length + next));
      constexpr std::array<double, 3> weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
      for (std::size_t p = 0; p < 3; ++p) {
        const double now = body.stress(stretched, Index(p), 0);
        work += weight[p] * 0.5 * (stress[p] + now) * strain * volume;
        stress[p] = now;
      }
      length = next;
    }
    EXPECT_EQ(body.item("active", stretched), 0);
    EXPECT_EQ(stress[0], 0);
    EXPECT_GT(work, 0);
    // Strain rates are taken at the middle of the step, the area is that of its end: second order.
    test::verified(std::string(kind.name) + ", torn until it erodes: eroded energy over the work",
                   "stress on strain")
        .near(body.block().eroded_energy / (2 * work), 1, 1e-5);
  }
}

/// A hourglass stress that stays behind would pull at the nodes for ever.
TEST(Erosion, HourglassStressGoesWithTheElement) {
  for (const Kind& kind : one_point_kinds)
    for (const auto& execution : all_executions()) {
      Torn torn(execution, kind.formulation, true);
      Driven& body = torn.body;
      const auto hourglass = [&](double size) {
        body.step(
            1e-6,
            [&](const Vec3& x) {
              const bool moves = x.x > 6 && x.y > 4 && x.y < 6;
              return Vec3{x.x, x.y, x.z + (moves ? size : 0)};
            },
            [](const Vec3&) { return Vec3{}; });
      };
      hourglass(0.01);
      EXPECT_GT(body.block().hourglass_energy, 0) << name_of(execution);
      for (int step = 0; step < 200 && body.block().eroded == 0; ++step) torn.stretch(1.001);
      ASSERT_EQ(body.block().eroded, 2);
      torn.stretch(1.001);
      for (Index e = 0; e < 4; ++e)
        for (Index mode = 0; mode < 5; ++mode)
          if (body.item("active", e) == 0) {
            EXPECT_EQ(body.item("hourglass", e, mode), 0);
          }
    }
}

/// Nodes of failed elements go where they will, to one place as well.
TEST(Erosion, FailedElementsMayLoseTheirArea) {
  for (const Kind& kind : kinds)
    for (const auto& execution : all_executions()) {
      Torn torn(execution, kind.formulation, false);
      Driven& body = torn.body;
      for (int step = 0; step < 200 && body.block().eroded == 0; ++step) torn.stretch(1.001);
      ASSERT_EQ(body.block().eroded, 2);
      torn.stretch(1.0);
      const double eroded = body.block().eroded_energy;
      torn.stretch(0.0);
      torn.stretch(0.0);
      const std::string name = name_of(execution) + " " + kind.name;
      EXPECT_EQ(body.block().eroded_energy, eroded) << name;
      EXPECT_NEAR(body.block().internal_energy, 0, 1e-5 * eroded) << name;
      EXPECT_EQ(body.block().hourglass_energy, 0) << name;
      for (Index i = 0; i < body.domain.nodes.count(); ++i) EXPECT_EQ(norm(body.force(i)), 0) << name;
    }
}

}  // namespace
}  // namespace crumple::elements::testing::erosion_test
