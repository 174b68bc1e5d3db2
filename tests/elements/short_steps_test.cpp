// SPDX-License-Identifier: BSD-3-Clause
// TDEL: elements go in the step after that in which their stable step has fallen below the limit, and keep
// the energy balanced.
#include <gtest/gtest.h>

#include "elements/common/short_steps.hpp"
#include "elements/solid_harness.hpp"

namespace crumple::elements::testing::short_steps_test {
namespace {

constexpr double dt = 1e-7;
constexpr int steps = 30;

/// A body that is pressed along x, every step by one percent.
class Pressed {
 public:
  Pressed(const model::Model& model, const domain::Execution& execution) : body_(model, execution) {}
  void step() {
    body_.step(
        dt,
        [](const Vec3& x) {
          return Vec3{0.99 * x.x, x.y, x.z};
        },
        [](const Vec3&) { return Vec3{}; });
  }
  double limit() const { return body_.domain.clock.element_limit; }
  Index eroded() const { return body_.domain.blocks()[0]->eroded; }
  const domain::ElementBlock& block() const { return *body_.domain.blocks()[0]; }
  double largest_force() const {
    double largest = 0;
    for (Index node = 0; node < body_.domain.nodes.count(); ++node)
      largest = test::larger_of(largest, norm(body_.force(node)));
    return largest;
  }

 private:
  mutable Driven body_;
};

void expect_end(const std::function<model::Model(const model::Material&)>& make,
                const domain::Execution& execution) {
  model::Material material = elastic();
  std::vector<double> limits;
  std::vector<double> energies;
  Pressed lasting(make(material), execution);
  for (int k = 0; k < steps; ++k) {
    lasting.step();
    limits.push_back(lasting.limit());
    energies.push_back(lasting.block().internal_energy);
  }
  // The step falls with the length; of shells it is area over the longest side.
  ASSERT_LT(limits.back(), 0.9 * limits[9]);
  material.least_step = 0.5 * (limits[9] + limits[10]);
  Pressed ending(make(material), execution);
  for (int k = 0; k <= 10; ++k) {
    ending.step();
    EXPECT_EQ(ending.eroded(), 0) << k;
  }
  EXPECT_EQ(ending.block().internal_energy, energies[10]);
  ending.step();
  EXPECT_EQ(ending.eroded(), ending.block().elements);
  ending.step();
  EXPECT_EQ(ending.limit(), 1e30);
  EXPECT_LT(ending.largest_force(), 1e-9 * lasting.largest_force());
  EXPECT_NEAR(ending.block().internal_energy, 0, 1e-6 * energies[10]);
  // The last step has half of the old stress's work: between none and that of a full step.
  EXPECT_GT(ending.block().eroded_energy, energies[10]);
  EXPECT_LT(ending.block().eroded_energy, energies[11]);
}

TEST(ShortSteps, EndSolids) {
  for (const auto& execution : all_executions())
    for (const SolidCase& solid : solid_cases) {
      if (model::is_tetrahedral(solid.formulation)) continue;  // six of several steps make a cube
      SCOPED_TRACE(name_of(solid, execution));
      expect_end(
          [&](const model::Material& material) {
            model::Model model = solid_cube(solid, 1, 0, material);
            model.control.bulk_linear = model.control.bulk_quadratic = 0;
            model.control.hourglass.coefficient = 0;
            return model;
          },
          execution);
    }
}

TEST(ShortSteps, EndShells) {
  for (const auto& execution : all_executions())
    for (const Kind& kind : all_kinds) {
      SCOPED_TRACE(std::string(kind.name) + " " + name_of(execution));
      expect_end([&](const model::Material& material) { return plate(kind.formulation, 1, 0, 3, material); },
                 execution);
    }
}

}  // namespace
}  // namespace crumple::elements::testing::short_steps_test
