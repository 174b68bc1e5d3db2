// SPDX-License-Identifier: BSD-3-Clause
// *CONTACT_INTERIOR: the pressure that keeps squeezed solids from losing their volume.
#include <gtest/gtest.h>

#include "elements/solid_harness.hpp"

namespace crumple::elements::testing::interior_contact_test {
namespace {

constexpr double start = 0.1;  // Fa

/// A material that weighs nothing against the interior pressure, so that this can be seen alone.
model::Model soft_cube(const SolidCase& of, bool interior) {
  model::Model model = solid_cube(of, 1, 0);
  model.control.bulk_linear = model.control.bulk_quadratic = 1e-30;
  if (interior) model.parts[0].interior = model::InteriorContact{.relative_volume = start, .scale = 2};
  return model;
}

/// Work that the element has taken up when it is squeezed along z to `ratio` of its height, and its step
/// there.
struct Squeezed {
  double energy = 0;
  double limit = 0;
  Index steps = 0;
};
Squeezed squeeze(const model::Model& model, const domain::Execution& execution, double ratio, Index steps,
                 bool back = false) {
  Driven body(model, execution);
  const auto to = [&](double factor) {
    body.step(
        1e-3,
        [&](const Vec3& x) {
          return Vec3{x.x, x.y, factor * x.z};
        },
        [](const Vec3&) { return Vec3{}; });
  };
  const double factor = std::pow(ratio, 1.0 / double(steps));
  for (Index i = 0; i < steps; ++i) to(factor);
  if (back)
    for (Index i = 0; i < steps; ++i) to(1 / factor);
  return {body.domain.solids[0].internal_energy, body.domain.clock.element_limit, steps};
}

constexpr double modulus =
    2 * youngs_modulus * (1 - poissons_ratio) / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));

TEST(InteriorContact, PressureAndEnergyInClosedForm) {
  const domain::Execution execution{Precision::Double, available_isas().back(), 1};
  for (const SolidCase& of : solid_cases) {
    constexpr double ratio = 0.04;
    const Squeezed without = squeeze(soft_cube(of, false), execution, ratio, 2000);
    const Squeezed with = squeeze(soft_cube(of, true), execution, ratio, 2000);
    // Integral of K (V* / V - 1) from V to V*, of a cube of side 2.
    const double exact = 8 * modulus * (start * std::log(start / ratio) - (start - ratio));
    EXPECT_NEAR((with.energy - without.energy) / exact, 1, 1e-4) << of.name;
    // c^2 grows from M / rho by 2 M 0.1 / rho.
    EXPECT_NEAR(with.limit / without.limit, 1 / std::sqrt(1.2), 1e-3) << of.name;
    // Above V* nothing is different but the step.
    EXPECT_EQ(squeeze(soft_cube(of, true), execution, 0.11, 500).energy,
              squeeze(soft_cube(of, false), execution, 0.11, 500).energy)
        << of.name;
  }
}

TEST(InteriorContact, GivesItsEnergyBack) {
  const domain::Execution execution{Precision::Double, available_isas().back(), 1};
  for (const SolidCase& of : solid_cases) {
    const Squeezed there = squeeze(soft_cube(of, true), execution, 0.04, 2000);
    const Squeezed back = squeeze(soft_cube(of, true), execution, 0.04, 2000, true);
    EXPECT_LT(std::fabs(back.energy), 1e-3 * there.energy) << of.name;
  }
}

TEST(InteriorContact, IsTheSameForAllInstructionSets) {
  for (const auto& execution : all_executions()) {
    const double energy = squeeze(soft_cube(solid_cases[1], true), execution, 0.04, 500).energy;
    const double plain =
        squeeze(soft_cube(solid_cases[1], true), {execution.precision, Isa::Scalar, 1}, 0.04, 500).energy;
    EXPECT_NEAR(energy / plain, 1, 1e4 * round_off(execution)) << name_of(execution);
  }
}

}  // namespace
}  // namespace crumple::elements::testing::interior_contact_test
