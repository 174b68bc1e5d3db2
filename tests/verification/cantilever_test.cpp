// SPDX-License-Identifier: BSD-3-Clause
//
// A cantilever under a step force at its tip, against the modal series of the Euler-Bernoulli beam
// (L. Meirovitch, Analytical Methods in Vibrations, 1967, chapter 5):
//   w(L, t) = (P L^3 / E I) sum_n 4 / lambda_n^4 (1 - cos omega_n t),  omega_n = lambda_n^2 sqrt(E I / rho A
//   L^4),
// with cos(lambda) cosh(lambda) = -1. Mesh: 24 x 2 shells of 5 mm, 2 mm thick, nu = 0.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::cantilever_test {
namespace {

constexpr double length = 120.0;
constexpr double width = 10.0;
constexpr double thickness = 2.0;
constexpr double young = 210.0;
constexpr double density = 7.85e-6;
constexpr double force = 1e-4;  // a tip deflection of about 4 % of the thickness: linear

constexpr double inertia = width * thickness * thickness * thickness / 12;

double static_deflection() {
  return force * length * length * length / (3 * young * inertia);
}

double frequency(double lambda) {
  return lambda * lambda * std::sqrt(young * inertia / (density * width * thickness * std::pow(length, 4)));
}

double exact_tip(double time) {
  constexpr std::array<double, 6> lambda{1.875104068711961,  4.694091132974174,  7.854757438237613,
                                         10.995540734875467, 14.137168391046470, 17.278759532088237};
  double sum = 0;
  for (const double l : lambda) sum += 4 / std::pow(l, 4) * (1 - std::cos(frequency(l) * time));
  return 3 * static_deflection() * sum;
}

model::Model cantilever(model::ShellFormulation formulation) {
  model::Model model =
      test::one_part({.id = 1, .title = "beam", .density = density, .law = model::Elastic{young, 0.0}},
                     test::shell_section(thickness, 2, formulation));
  constexpr Index columns = 24;
  constexpr Index rows = 2;
  test::add_grid(model, 0, columns, rows, [](double u, double v) {
    return test::Point{u * length, v * width, 0};
  });
  const std::array<double, 3> share{0.25, 0.5, 0.25};
  for (Index j = 0; j <= rows; ++j) {
    model.fixed_nodes.push_back(
        {.node = j * (columns + 1), .translation = {true, true, true}, .rotation = {true, true, true}});
    model.nodal_loads.push_back({.node = j * (columns + 1) + columns, .force = {0, 0, share[j] * force}});
  }
  return model;
}

class Cantilever : public ::testing::TestWithParam<model::ShellFormulation> {};

TEST_P(Cantilever, AmplitudeAndPeriodFollowBeamTheory) {
  model::Model model = cantilever(GetParam());
  const double period = 2 * std::numbers::pi / frequency(1.875104068711961);
  model.control.end_time = 2.2 * period;
  timeloop::Simulation simulation(model, test::execution());
  double peak = 0;
  double exact_peak = 0;
  double peak_time = 0;
  double exact_peak_time = 0;
  double work_error = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double tip = test::displacement(domain, 24).z;
    const double time = domain.clock.time;
    // The second peak of the first mode: amplitude and, being later, a sharper measure of the period.
    if (time > period && tip > peak) {
      peak = tip;
      peak_time = time;
    }
    if (time > period && exact_tip(time) > exact_peak) {
      exact_peak = exact_tip(time);
      exact_peak_time = time;
    }
    work_error = test::larger_of(work_error, std::fabs(domain.energy.imbalance()));
  });
  const char* const series = "modal series of Euler and Bernoulli's beam";
  test::verified("cantilever under a step force: amplitude over exact", series)
      .near(peak / exact_peak, 1, 0.02);
  test::verified("cantilever under a step force: period over exact", series)
      .near(peak_time / exact_peak_time, 1, 0.02);
  EXPECT_LT(work_error, 1e-3 * force * exact_peak);
}

std::string name_of(const ::testing::TestParamInfo<model::ShellFormulation>& which) {
  using enum model::ShellFormulation;
  switch (which.param) {
    case HughesLiu:
      return "HughesLiu";
    case HughesLiuSelectiveReduced:
      return "HughesLiuSelectiveReduced";
    case FullyIntegrated:
      return "FullyIntegrated";
    default:
      return "BelytschkoTsay";
  }
}
INSTANTIATE_TEST_SUITE_P(Shells, Cantilever,
                         ::testing::Values(model::ShellFormulation::BelytschkoTsay,
                                           model::ShellFormulation::HughesLiu,
                                           model::ShellFormulation::HughesLiuSelectiveReduced,
                                           model::ShellFormulation::FullyIntegrated),
                         name_of);

}  // namespace
}  // namespace crumple::cantilever_test
