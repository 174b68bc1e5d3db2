// SPDX-License-Identifier: BSD-3-Clause
//
// Bars whose yield stress grows with the strain rate (Cowper & Symonds), pulled at a speed at which the rate
// makes far more of a small change of velocity than elasticity does. With the yield stress of the total
// strain rate, vibrations of the mesh raised it and were fed by it: the bars took up 44 % (shells) and 30 %
// (solids) too much.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::strain_rate_test {
namespace {

constexpr double length = 12;   ///< [mm]
constexpr double width = 3;     ///< [mm]
constexpr double speed = 0.12;  ///< 10 per s [mm/ms]
constexpr double duration = 5;  ///< to 5 % [ms]
constexpr double ramp = 0.25;   ///< until the speed is there [ms]
constexpr double youngs_modulus = 200;
constexpr double yield_stress = 0.3;
constexpr double tangent_modulus = 1;
constexpr double c = 0.04;  ///< C = 40 per s [1/ms]
constexpr double p = 5;

model::Material rated_steel() {
  return {.id = 1,
          .title = "steel",
          .density = 7.8e-6,
          .law = model::PlasticKinematic{.youngs_modulus = youngs_modulus,
                                         .poissons_ratio = 0.3,
                                         .yield_stress = yield_stress,
                                         .tangent_modulus = tangent_modulus,
                                         .isotropic_fraction = 1,
                                         .cowper_symonds_rate = c,
                                         .cowper_symonds_exponent = p}};
}

/// Work of uniaxial stress at the rate of the strain, all of it plastic beyond the yield stress; the volume
/// stays what it was [kN mm].
double work_of_the_law(double area) {
  constexpr int steps = 100000;
  const double hardening = youngs_modulus * tangent_modulus / (youngs_modulus - tangent_modulus);
  double work = 0;
  double stretched = length;
  double plastic = 0;
  for (int i = 0; i < steps; ++i) {
    const double time = (i + 0.5) * duration / steps;
    const double velocity = speed * std::min(1.0, time / ramp);
    const double rate = velocity / stretched;
    const double stress = (yield_stress + hardening * plastic) * (1 + std::pow(rate / c, 1 / p));
    plastic = std::max(0.0, std::log(stretched / length) - stress / youngs_modulus);
    const double acting = std::min(stress, youngs_modulus * std::log(stretched / length));
    work += acting * area * length / stretched * velocity * duration / steps;
    stretched += velocity * duration / steps;
  }
  return work;
}

/// One end is held, the other pulled; the sides may move.
void pull(model::Model& model) {
  model::Curve curve{.id = 1, .abscissa = {0, ramp, 100}, .ordinate = {0, speed, speed}};
  model.curves.push_back(curve);
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    if (x[0] == 0)
      model.fixed_nodes.push_back({.node = i, .translation = {true, x[1] == 0, x[2] == 0}});
    else if (x[0] == length)
      model.prescribed_motions.push_back({.node = i, .axis = 0, .curve = 0});
  }
  model.control.end_time = duration;
}

void expect_work_of_the_law(const model::Model& model, double area, const std::string& bar) {
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::EnergyLedger& energy = simulation.domain().energy;
  test::verified(bar + " pulled at 10 per s, Cowper & Symonds with VP = 0: internal energy over the law's",
                 "work of uniaxial stress")
      .near(energy.internal / work_of_the_law(area), 1, 0.02);
  // Of an even stretch: m v^2 / 6.
  const double even = 7.8e-6 * area * length * speed * speed / 6;
  test::verified(
      bar + " pulled at 10 per s, Cowper & Symonds with VP = 0: kinetic energy over an even stretch's",
      "no vibrations")
      .near(energy.kinetic / even, 1, 0.05);
}

TEST(StrainRate, VibrationsOfShellsDoNotRaiseTheYieldStress) {
  model::Model model = test::one_part(rated_steel(), test::shell_section(1, 3));
  test::add_grid(model, 0, 12, 3, [](double u, double v) { return test::Point{length * u, width * v, 0}; });
  pull(model);
  expect_work_of_the_law(model, width, "bar of shells");
}

TEST(StrainRate, VibrationsOfSolidsDoNotRaiseTheYieldStress) {
  model::Model model = test::one_solid_part(rated_steel());
  test::add_box(model, 0, 12, 3, 3, [](double u, double v, double w) {
    return test::Point{length * u, width * v, width * w};
  });
  pull(model);
  expect_work_of_the_law(model, width * width, "bar of solids");
}

}  // namespace
}  // namespace crumple::strain_rate_test
