// SPDX-License-Identifier: BSD-3-Clause
//
// Cylindrical panel loaded by an impulse: experiment of H.A. Balmer and E.A. Witmer (AFFDL-TDR-64-108, 1964),
// computed by J.W. Leech (1966), L. Morino, J.W. Leech and E.A. Witmer (J. Appl. Mech. 38, 1971) and many
// since, such as T. Belytschko, J.I. Lin and C.S. Tsay (CMAME 42 (1984) 225-251). A panel of 120 degrees,
// clamped along the straight sides and hinged at the curved ends, gets a velocity of 5650 in/s towards the
// axis over its middle, 10.205 in long and 60 degrees wide. Aluminium, ideally plastic. Units: inch, pound,
// second. The greatest deflection at the middle of the crown was 1.28 in; published codes give 1.16 to 1.28.
//
// None of these papers was at hand: the set-up is that of secondary accounts, and the loaded area is
// inferred. It must be 60 degrees wide and not 90, as the first account had it: 60 degrees are 3.08 in of
// circumference, 10.205 in are 26/32 of the length, and only so does the deflection come near to the
// published ones (with 90 degrees the hoop takes up the impulse, the peak is 0.5 to 0.7 in). That it lies in
// the middle of the length is an assumption. docs/verification.md has convergence and sensitivities.
// impulsive_arch_test.cpp and impulsive_ring_test.cpp verify shells and law in such motion without these
// doubts.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/drawn.hpp"
#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::cylindrical_panel_test {
namespace {

constexpr double radius = 2.9375;
constexpr double length = 12.56;
constexpr double thickness = 0.125;
constexpr double loaded_length = 10.205;
constexpr double degree = std::numbers::pi / 180;
constexpr double span = 60 * degree;  // half the panel, by symmetry about the crown
constexpr double loaded_span = 30 * degree;
constexpr double speed = 5650.0;
constexpr Index around = 16;
constexpr Index along = 32;

/// Share of the velocity that a node gets: that of its neighbourhood which is loaded, so that the impulse
/// does not depend on the mesh. `inside` is the node's distance from the edge of the load, inwards.
double loaded_share(double inside, double spacing) {
  return std::clamp(inside / spacing + 0.5, 0.0, 1.0);
}

model::Model panel(model::ShellFormulation formulation) {
  model::PlasticKinematic aluminium;
  aluminium.youngs_modulus = 10.5e6;
  aluminium.poissons_ratio = 0.33;
  aluminium.yield_stress = 44000;
  aluminium.isotropic_fraction = 1;
  model::Model model = test::one_part({.id = 1, .title = "6061-T6", .density = 2.5e-4, .law = aluminium},
                                      test::shell_section(thickness, 5, formulation));
  test::add_grid(model, 0, around, along, [&](double u, double v) {
    return test::Point{radius * std::sin(u * span), v * length, radius * std::cos(u * span)};
  });
  for (Index j = 0; j <= along; ++j)
    for (Index i = 0; i <= around; ++i) {
      const Index node = j * (around + 1) + i;
      const double y = length * j / along;
      const double angle = span * i / around;
      if (i == 0)
        model.fixed_nodes.push_back(
            {.node = node, .translation = {true, false, false}, .rotation = {false, true, true}});
      if (i == around)
        model.fixed_nodes.push_back(
            {.node = node, .translation = {true, true, true}, .rotation = {true, true, true}});
      else if (j == 0 || j == along)
        model.fixed_nodes.push_back({.node = node, .translation = {true, true, true}, .rotation = {}});
      const double v = speed * loaded_share(loaded_span - angle, span / around) *
                       loaded_share(0.5 * loaded_length - std::fabs(y - 0.5 * length), length / along);
      if (v > 0 && i < around)
        model.initial_velocities.push_back({.node = node,
                                            .velocity = {-v * std::sin(angle), 0, -v * std::cos(angle)},
                                            .angular_velocity = {}});
    }
  model.control.end_time = 1e-3;
  return model;
}

class CylindricalPanel : public ::testing::TestWithParam<model::ShellFormulation> {};

TEST_P(CylindricalPanel, GreatestDeflectionIsThatOfTheExperiment) {
  const model::Model model = panel(GetParam());
  timeloop::Simulation simulation(model, test::execution());
  double peak = 0;
  double peak_off_middle = 0;  // at y = 9.42 in
  test::Points history;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double deflection = -test::displacement(domain, along / 2 * (around + 1)).z;
    peak = test::larger_of(peak, deflection);
    history.push_back({1e3 * domain.clock.time, deflection});
    peak_off_middle =
        test::larger_of(peak_off_middle, -test::displacement(domain, 3 * along / 4 * (around + 1)).z);
  });
  const domain::EnergyLedger& energy = simulation.domain().energy;
  RecordProperty("peak_off_middle_inch", std::to_string(peak_off_middle));
  RecordProperty("hourglass_over_internal", std::to_string(energy.hourglass / energy.internal));
  // Half of what separates the published codes.
  test::verified("cylindrical panel under an impulse: peak, inch", "experiment, by secondary accounts")
      .near(peak, 1.28, 0.06);
  EXPECT_LT(energy.error(), 0.01);
  EXPECT_LT(energy.hourglass, 0.1 * energy.internal);
  if (GetParam() != model::ShellFormulation::BelytschkoTsay) return;
  test::drawn("Cylindrical panel under an impulse", "time [ms]", "deflection of the crown [inch]")
      .accepted("largest of the experiment", {{0, 1.28}, {history.back()[0], 1.28}})
      .found("Belytschko-Tsay shells", history)
      .note();
}

INSTANTIATE_TEST_SUITE_P(BothShells, CylindricalPanel,
                         ::testing::Values(model::ShellFormulation::BelytschkoTsay,
                                           model::ShellFormulation::HughesLiu),
                         [](const auto& which) {
                           return which.param == model::ShellFormulation::HughesLiu ? "HughesLiu"
                                                                                    : "BelytschkoTsay";
                         });

}  // namespace
}  // namespace crumple::cylindrical_panel_test
