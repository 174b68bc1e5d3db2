// SPDX-License-Identifier: BSD-3-Clause
// Solids whose points have failed.
#include <gtest/gtest.h>

#include "elements/solid_harness.hpp"

namespace crumple::elements::testing::solid_erosion_test {
namespace {

/// Two cubes of side 2 in a row along x; the second is stretched until it fails.
struct TornBar {
  TornBar(const domain::Execution& execution, const SolidCase& of) : body(bar(of), execution) {}

  static model::Model bar(const SolidCase& of) {
    model::Material material = plastic();
    std::get<model::PlasticKinematic>(material.law).failure_strain = 0.05;
    model::Model model = solid_model(of, material);
    test::add_box(model, 0, 2, 1, 1, [](double u, double v, double w) {
      return test::Point{4 * u, 2 * v, 2 * w};
    });
    split_for(of, model);
    return model;
  }
  void stretch(double factor) {
    body.step(
        1e-6,
        [&](const Vec3& x) {
          return Vec3{x.x > 2 ? 2 + factor * (x.x - 2) : x.x, x.y, x.z};
        },
        [](const Vec3&) { return Vec3{}; });
  }
  const domain::SolidBlock& block() const { return body.domain.solids[0]; }

  Driven body;
};

TEST(SolidErosion, TakesForceEnergyAndStepOfTheElement) {
  for (const SolidCase& of : solid_cases)
    for (const auto& execution : all_executions()) {
      TornBar torn(execution, of);
      const domain::SolidBlock& block = torn.block();
      double energy = 0;
      for (int step = 0; step < 200 && block.eroded == 0; ++step) {
        energy = block.internal_energy;
        torn.stretch(1.001);
      }
      const std::string name = name_of(of, execution);
      ASSERT_EQ(block.eroded, block.elements / 2) << name;
      // The step of failure adds the last trapezoid, half of a whole step's work.
      EXPECT_GT(block.eroded_energy + block.internal_energy, energy) << name;
      EXPECT_LT(block.eroded_energy, 1.03 * energy) << name;
      // The mean at the nodes strains the neighbours as well.
      const bool averages = of.formulation == model::SolidFormulation::NodalPressureTetrahedron;
      if (!averages) {
        EXPECT_NEAR(block.internal_energy, 0, 1e-5 * energy) << name;
      }
      const double eroded = block.eroded_energy;
      torn.stretch(1.01);
      EXPECT_LT(torn.body.domain.clock.element_limit, 1e29) << "the other still limits the step";
      // The nodes of what has failed go where they will, to one place as well.
      torn.stretch(0);
      torn.stretch(0);
      EXPECT_EQ(block.eroded_energy, eroded) << name;
      for (Index i = 0; i < torn.body.domain.nodes.count(); ++i)
        if (!averages || torn.body.domain.nodes.reference[i].x > 2) {
          EXPECT_EQ(norm(torn.body.force(i)), 0) << name;
        }
    }
}

}  // namespace
}  // namespace crumple::elements::testing::solid_erosion_test
