// SPDX-License-Identifier: BSD-3-Clause
// Laws that depend on the element: orthotropic axes that turn with it, and shells without stiffness.
#include <gtest/gtest.h>

#include <numeric>

#include "elements/shell_harness.hpp"
#include "support/largest.hpp"

namespace crumple::elements::testing::material_axes_test {
namespace {

model::Material fibre(double angle) {
  model::OrthotropicElastic law;
  law.modulus_a = 138000;
  law.modulus_b = law.modulus_c = 9000;
  law.poisson_ba = law.poisson_ca = 0.02;
  law.poisson_cb = 0.4;
  law.shear_ab = law.shear_ca = 7000;
  law.shear_bc = 3500;
  law.axes = model::OrthotropicElastic::Axes::Vector;
  law.direction = {1, 0, 0};
  law.angle = angle;
  set_stand_in(law);
  return {.id = 1, .title = "fibre", .density = density, .law = law};
}

/// Force along x on the right edge of a distorted patch that is stretched along x.
double edge_force(double angle, model::ShellFormulation formulation, const domain::Execution& execution) {
  model::Model model = plate(formulation, 3, 0.15, 3, fibre(angle));
  // A regular outline: the shear stress on the other two edges then cancels at the corners.
  for (std::size_t i = 0; i < model.nodes.position.size(); ++i) {
    auto& p = model.nodes.position[i];
    const std::size_t column = i % 4;
    const std::size_t row = i / 4;
    if (column % 3 == 0 || row % 3 == 0)
      p = {5.0 * static_cast<double>(column), 5.0 * static_cast<double>(row), 0};
  }
  Driven body(model, execution);
  body.step(
      1e-6,
      [](const Vec3& x) {
        return Vec3{(1 + 1e-6) * x.x, x.y, x.z};
      },
      [](const Vec3&) { return Vec3{}; });
  double force = 0;
  for (Index i = 0; i < body.domain.nodes.count(); ++i)
    if (model.nodes.position[body.domain.nodes.model_node[i]][0] > 14.9) force += body.force(i).x;
  return std::fabs(force);
}

/// Stretched without lateral strain the patch carries Q_xx of the turned stiffness, whatever the mesh.
TEST(MaterialAxes, PatchIsExactAtEveryAngle) {
  constexpr double determinant = 1 - 0.02 * 0.02 * 138000 / 9000;
  const double aa = 138000 / determinant;
  const double bb = 9000 / determinant;
  const double ab = 0.02 * aa;
  for (const Kind& kind : kinds) {
    const std::string patched =
        std::string(kind.name) + ", carbon fibre at four angles: force, relative error, ";
    test::Largest doubles(patched + "double precision", "turned stiffness", 1e-5);
    test::Largest singles(patched + "mixed precision", "turned stiffness", 2e-5);
    for (const auto& execution : all_executions())
      for (const double angle : {0.0, 0.5, 1.5707963267948966, -0.9}) {
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const double q = aa * c * c * c * c + bb * s * s * s * s + 2 * (ab + 2 * 7000) * s * s * c * c;
        const double expected = q * 1e-6 * 15 * thickness;
        test::Largest& off = execution.precision == Precision::Mixed ? singles : doubles;
        off.compare(edge_force(angle, kind.formulation, execution), expected, expected,
                    name_of(execution) + " " + std::to_string(angle));
      }
  }
}

/// With AOPT = 0 the first axis follows the first side in the deck, whichever entry a triangle repeats.
TEST(MaterialAxes, FollowTheFirstSideOfATriangle) {
  model::Material material = fibre(0);
  std::get<model::OrthotropicElastic>(material.law).axes = model::OrthotropicElastic::Axes::Side;
  std::vector<double> forces;
  for (const std::array<Index, 4>& node :
       {std::array<Index, 4>{0, 1, 2, 2}, {0, 1, 1, 2}, {0, 1, 2, 0}, {0, 0, 1, 2}}) {
    model::Model model = plate(model::ShellFormulation::BelytschkoTsay, 1, 0, 3, material);
    model.shells.push_back(model.shells.front());
    model.shells.back().id = 2;
    model.shells.back().node = node;
    model.shells.front().node = {1, 3, 2, 2};
    Driven body(model, {Precision::Double, available_isas().back(), 1});
    body.step(
        1e-6,
        [](const Vec3& x) {
          return Vec3{(1 + 1e-6) * x.x, x.y, 0};
        },
        [](const Vec3&) { return Vec3{}; });
    forces.push_back(body.force(body.domain.nodes.domain_node[0]).x);
  }
  for (const double force : forces) EXPECT_NEAR(force, forces[0], 1e-9 * std::fabs(forces[0]));
}

/// Stretched, turned by a quarter in many steps, stretched again: the fibre has turned with the element, and
/// the stress in the lamina's axes is what it was before.
TEST(MaterialAxes, TurnWithTheElement) {
  for (const Kind& kind : kinds) {
    const model::Model model = plate(kind.formulation, 2, 0.1, 3, fibre(0.3));
    Driven body(model, {Precision::Double, available_isas().back(), 1});
    const auto no_turn = [](const Vec3&) { return Vec3{}; };
    body.step(
        1e-6,
        [](const Vec3& x) {
          return Vec3{(1 + 1e-5) * x.x, x.y, 0};
        },
        no_turn);
    const double first = body.stress(0, 1, 0);
    constexpr int steps = 2000;
    const double angle = std::acos(0.0) / steps;
    const Vec3 axis{0, 0, 1};
    for (int i = 0; i < steps; ++i)
      body.step(
          1e-6, [&](const Vec3& x) { return rotated(x, axis, angle); },
          [&](const Vec3&) { return angle * axis; });
    test::verified(std::string(kind.name) + ", carbon fibre, turned by a quarter: stress over that before",
                   "invariance")
        .near(body.stress(0, 1, 0) / first, 1, 1e-5);
    body.step(
        1e-6,
        [](const Vec3& x) {
          return Vec3{x.x, (1 + 1e-5) * x.y, 0};
        },
        no_turn);
    EXPECT_NEAR(body.stress(0, 1, 0), 2 * first, 1e-3 * first) << kind.name;
  }
}

TEST(NullShell, HasMassAndNothingElse) {
  model::Material null = elastic();
  null.law = model::NullMaterial{youngs_modulus, poissons_ratio};
  for (const Kind& kind : kinds)
    for (const auto& execution : all_executions()) {
      model::Model model = plate(kind.formulation, 2, 0.1, 3, null);
      model.control.hourglass = {model::HourglassForm::Stiffness, 0.1, 0.1, 0.1};
      model.control.mass_scaling_step = 1;  // would make it very heavy
      Driven body(model, execution);
      const double mass = std::accumulate(body.domain.nodes.mass.begin(), body.domain.nodes.mass.end(), 0.0);
      Driven same(plate(kind.formulation, 2, 0.1), execution);
      EXPECT_EQ(mass, std::accumulate(same.domain.nodes.mass.begin(), same.domain.nodes.mass.end(), 0.0));
      body.step(
          1e-6,
          [](const Vec3& x) {
            return Vec3{1.1 * x.x, x.y - 0.1 * x.x, 0.1 * x.x * x.y};
          },
          [](const Vec3& x) {
            return Vec3{0.1, 0.01 * x.y, 0};
          });
      for (Index i = 0; i < body.domain.nodes.count(); ++i) {
        EXPECT_EQ(norm(body.force(i)), 0) << kind.name << " " << name_of(execution);
        EXPECT_EQ(norm(body.moment(i)), 0);
      }
      same.update(0);
      EXPECT_GT(body.domain.clock.element_limit, 1e6 * same.domain.clock.element_limit);
    }
}

}  // namespace
}  // namespace crumple::elements::testing::material_axes_test
