// SPDX-License-Identifier: BSD-3-Clause
// Foam that is crushed to a fraction of its height between hard faces: the penalty of the undeformed mesh is
// far too soft for it, by masses and steps of the start as well.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <string>

#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/shapes.hpp"
#include "support/verified.hpp"

namespace crumple::pressed_foam_test {
namespace {

constexpr double side = 60;  // kg, mm, ms
constexpr double speed = 10;
constexpr Index of_cube = 7 * 7 * 7;  ///< nodes
constexpr Index of_plate = 3 * 3 * 2;

model::CrushableFoam dense_foam() {
  model::CrushableFoam law;
  law.youngs_modulus = 2e-3;
  law.crush = {0, 0.05, 0.6, 0.8, 0.9, 0.95};
  law.yield_stress = {0, 0.1e-3, 0.2e-3, 0.5e-3, 1.2e-3, 2e-3};
  law.tensile_stress = 0.1e-3;
  law.damping = 0.1;
  return law;
}

/// Stress of the foam's curve.
double stress_at(const model::CrushableFoam& law, double crush) {
  std::size_t k = 1;
  while (law.crush[k] < crush) ++k;
  const double share = (crush - law.crush[k - 1]) / (law.crush[k] - law.crush[k - 1]);
  return law.yield_stress[k - 1] + share * (law.yield_stress[k] - law.yield_stress[k - 1]);
}

/// A cube of foam between two plates of solids whose nodes are held and driven: their own stiffness is as
/// good as nothing to the step.
model::Model pressed_cube(const model::CrushableFoam& law) {
  model::Model model = test::one_solid_part({.id = 1, .title = "foam", .density = 1e-7, .law = law});
  model.materials.push_back({.id = 2, .title = "plates", .density = 1e-3, .law = model::Elastic{0.2, 0.3}});
  const auto cube = [](double u, double v, double w) { return test::Point{side * u, side * v, side * w}; };
  test::add_box(model, 0, 6, 6, 6, cube);
  const Index plates = test::add_solid_part(model);
  model.parts[plates].material = 1;
  const auto add_plate = [&](double bottom) {
    return test::add_box(model, plates, 2, 2, 1, [=](double u, double v, double w) {
      return test::Point{side * (1.6 * u - 0.3), side * (1.6 * v - 0.3), bottom + 20 * w};
    });
  };
  const Index below = add_plate(-20);
  const Index above = add_plate(side);
  test::hold(model, below, above);
  model.curves.push_back({1, {0, 1e9}, {-speed, -speed}});
  for (Index i = above; i < model.nodes.count(); ++i) {
    model.fixed_nodes.push_back({.node = i, .translation = {true, true, false}});
    model.prescribed_motions.push_back({.node = i, .axis = 2, .curve = 0});
  }
  test::touch_all(model);
  model.control.end_time = 0.89 * side / speed;
  return model;
}

struct Pressed {
  double force_over_exact = 0;  ///< mean between 70 and 88 % of crush
  double energy_error = 0;
};

Pressed press(const model::Model& model, const model::CrushableFoam& law) {
  timeloop::Simulation simulation(model, {Precision::Double, default_isa(), 1});
  double found = 0;
  double exact = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double crush = domain.clock.time * speed / side;
    if (crush < 0.7 || crush > 0.88) return;
    // The lower plate is pushed down.
    for (Index i = of_cube; i < of_cube + of_plate; ++i)
      found -= domain.contact_force[domain.nodes.domain_node[i]].z * domain.clock.step;
    exact += stress_at(law, crush) * side * side * domain.clock.step;
  });
  return {found / exact, simulation.domain().energy.error()};
}

/// With the stiffness of the undeformed mesh the force was a third of this.
TEST(PressedFoam, HasTheForceOfItsCurve) {
  const model::CrushableFoam law = dense_foam();
  for (const int soft : {0, 1, 2}) {
    model::Model model = pressed_cube(law);
    model.contacts[0].soft_scale = soft == 1 ? 0.1 : 0;
    model.contacts[0].mass_stiffness = soft == 2;
    const Pressed found = press(model, law);
    std::printf("SOFT %d: force over exact %.3f, energy error %.1e\n", soft, found.force_over_exact,
                found.energy_error);
    test::verified(
        "foam crushed between hard faces, SOFT " + std::to_string(soft) + ": force over that of its curve",
        "exact")
        .near(found.force_over_exact, 1, 0.1);
    EXPECT_LT(found.energy_error, 1e-3);
  }
}

}  // namespace
}  // namespace crumple::pressed_foam_test
