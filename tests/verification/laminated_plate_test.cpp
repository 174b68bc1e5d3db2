// SPDX-License-Identifier: BSD-3-Clause
//
// Free vibration of a simply supported square plate of two plies, whose stretching and bending are coupled.
// The lowest frequency of the exact solution of laminate theory (R.M. Jones, Mechanics of Composite
// Materials, 2nd ed. 1999, sections 5.5.3 and 5.5.4) is lower than that of the uncoupled plate by a third and
// more.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::laminated_plate_test {
namespace {

constexpr double side = 200;     // mm
constexpr double thickness = 2;  // mm
constexpr double density = 1.6e-6;
constexpr double pi = std::numbers::pi;

/// E1 / E2 = 25, G12 = G13 = E2 / 2, G23 = E2 / 5, nu12 = 1/4 (J.N. Reddy, Mechanics of Laminated Composite
/// Plates and Shells, 2nd ed. 2004), GPa.
model::OrthotropicElastic graphite() {
  model::OrthotropicElastic law;
  law.modulus_a = 175;
  law.modulus_b = law.modulus_c = 7;
  law.poisson_ba = 0.25 / 25;
  law.shear_ab = law.shear_ca = 3.5;
  law.shear_bc = 1.4;
  law.axes = model::OrthotropicElastic::Axes::Vector;
  law.direction = {1, 0, 0};
  set_stand_in(law);
  return law;
}

/// Frequency of the lowest mode, and what it would be without the coupling [rad/ms].
struct Frequencies {
  double coupled, uncoupled;
};

/// u = cos sin, v = sin cos, w = sin sin (SS-2): A11, A12, A22 = A11, A66, B11 = -B22, D11 = D22, D12, D66.
Frequencies cross_ply() {
  const model::OrthotropicElastic m = graphite();
  const double ratio = 1 - m.poisson_ba * m.poisson_ba * m.modulus_a / m.modulus_b;
  const double q11 = m.modulus_a / ratio;
  const double q22 = m.modulus_b / ratio;
  const double q12 = m.poisson_ba * q11;
  const double t = thickness;
  const double a11 = 0.5 * (q11 + q22) * t;
  const double a12 = q12 * t;
  const double a66 = m.shear_ab * t;
  const double b11 = (q22 - q11) * t * t / 8;
  const double d = t * t / 12;
  const double k = pi / side;
  const double t11 = k * k * (a11 + a66);
  const double t12 = k * k * (a12 + a66);
  const double t13 = -k * k * k * b11;
  const double t33 = k * k * k * k * (2 * a11 + 2 * (a12 + 2 * a66)) * d;
  // The eigenvector of u and v under (T13, -T13) is (1, -1) with T11 - T12.
  const double reduced = t33 - 2 * t13 * t13 / (t11 - t12);
  return {std::sqrt(reduced / (density * t)), std::sqrt(t33 / (density * t))};
}

/// u = sin cos, v = cos sin, w = sin sin (SS-3) with B16 and B26 of plies at -45 and 45 degrees.
Frequencies angle_ply() {
  const model::OrthotropicElastic m = graphite();
  const double ratio = 1 - m.poisson_ba * m.poisson_ba * m.modulus_a / m.modulus_b;
  const double q11 = m.modulus_a / ratio;
  const double q22 = m.modulus_b / ratio;
  const double q12 = m.poisson_ba * q11;
  const double g = m.shear_ab;
  const double t = thickness;
  const double bar11 = 0.25 * (q11 + q22 + 2 * q12) + g;
  const double bar12 = 0.25 * (q11 + q22 + 2 * q12) - g;
  const double bar66 = 0.25 * (q11 + q22 - 2 * q12);
  const double b16 = 0.25 * (q11 - q22) * t * t / 4;
  const double k = pi / side;
  const double t11 = k * k * (bar11 + bar66) * t;
  const double t12 = k * k * (bar12 + bar66) * t;
  const double t13 = -k * k * k * (3 * b16 + b16);
  const double t33 = k * k * k * k * (2 * bar11 + 2 * (bar12 + 2 * bar66)) * t * t * t / 12;
  const double reduced = t33 - 2 * t13 * t13 / (t11 + t12);
  return {std::sqrt(reduced / (density * t)), std::sqrt(t33 / (density * t))};
}

/// 100 w E2 t^3 / (q a^4) under the pressure q sin sin: the published deflections of these two plates (Reddy
/// 2004, chapter 7, classical theory) hold the closed forms above.
double deflection(const Frequencies& exact) {
  const double stiffness = exact.coupled * exact.coupled * density * thickness;
  return 100 * graphite().modulus_b * std::pow(thickness, 3) / (std::pow(side, 4) * stiffness);
}

TEST(LaminatedPlate, ClosedFormsGiveThePublishedDeflections) {
  test::verified("0/90, simply supported: 100 w E2 t^3 / (q a^4)", "Reddy 2004, 1.0636")
      .near(deflection(cross_ply()), 1.0636, 5e-5);
  test::verified("-45/45, simply supported: 100 w E2 t^3 / (q a^4)", "Reddy 2004, 0.6547")
      .near(deflection(angle_ply()), 0.6547, 5e-5);
}

/// The plate with two points a ply, started in the shape of the mode. Each edge is held across itself and,
/// of cross-ply along, of angle-ply normal to itself.
model::Model plate(bool cross, model::ShellFormulation formulation, double end) {
  model::Model model = test::one_part({.id = 1, .title = "ply", .density = density, .law = graphite()},
                                      test::shell_section(thickness, 2, formulation));
  model::Layup layup;
  const double angle[] = {cross ? 0 : -pi / 4, cross ? pi / 2 : pi / 4};
  for (int i = 0; i < 4; ++i) {
    const double middle = i < 2 ? -0.5 : 0.5;
    const double off = 0.5 / std::sqrt(3.0) * (i % 2 == 0 ? -1 : 1);
    layup.layers.push_back({0, middle + off, 0.25, angle[i / 2]});
  }
  model.materials.push_back(layup_material(model, layup));
  layup.material = 1;
  model.layups.push_back(layup);
  model.parts[0].layup = 0;
  model.parts[0].material = 1;
  constexpr Index n = 20;
  test::add_grid(model, 0, n, n, [](double u, double v) { return test::Point{side * u, side * v, 0}; });
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    const bool along_x = i < n + 1 || i >= n * (n + 1);
    const bool along_y = i % (n + 1) == 0 || i % (n + 1) == n;
    const double w = std::sin(pi * x[0] / side) * std::sin(pi * x[1] / side);
    model.initial_velocities.push_back(
        {.node = i,
         .velocity = {0, 0, 0.01 * w},
         .angular_velocity = {0.01 * pi / side * std::sin(pi * x[0] / side) * std::cos(pi * x[1] / side),
                              -0.01 * pi / side * std::cos(pi * x[0] / side) * std::sin(pi * x[1] / side),
                              0}});
    if (!along_x && !along_y) continue;
    model::FixedNode fixed;
    fixed.node = i;
    fixed.translation = {cross ? along_x : along_y, cross ? along_y : along_x, true};
    // The slope along an edge is zero there.
    fixed.rotation = {along_y, along_x, false};
    model.fixed_nodes.push_back(fixed);
  }
  model.control.end_time = end;
  return model;
}

/// From the times at which the deflection of the middle passes zero.
double frequency_of(const model::Model& model) {
  timeloop::Simulation simulation(model, test::execution());
  const Index middle = simulation.domain().nodes.domain_node[220];
  double before = 0;
  double time_before = 0;
  std::vector<double> passages;
  double worst = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double now = domain.nodes.position[middle].z;
    if (before * now < 0)
      passages.push_back(time_before + (domain.clock.time - time_before) * before / (before - now));
    before = now;
    time_before = domain.clock.time;
    worst = std::max(worst, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
  });
  EXPECT_LT(worst, 0.01);
  EXPECT_GE(passages.size(), 3U);
  return pi * static_cast<double>(passages.size() - 1) / (passages.back() - passages.front());
}

TEST(LaminatedPlate, FrequencyWithCouplingOfStretchAndBending) {
  for (const model::ShellFormulation formulation :
       {model::ShellFormulation::BelytschkoTsay, model::ShellFormulation::FullyIntegrated}) {
    const bool full = formulation == model::ShellFormulation::FullyIntegrated;
    const std::string name = full ? "ELFORM 16, " : "ELFORM 2, ";
    for (const bool cross : {true, false}) {
      const Frequencies exact = cross ? cross_ply() : angle_ply();
      EXPECT_LT(exact.coupled, 0.75 * exact.uncoupled);
      const double found = frequency_of(plate(cross, formulation, 2.2 * 2 * pi / exact.coupled));
      test::verified(
          name + (cross ? "0/90" : "-45/45") + ", simply supported, t / a = 1/100: lowest frequency [rad/ms]",
          "Jones 1999, laminate theory")
          .within(found, exact.coupled, 0.015);
    }
  }
}

}  // namespace
}  // namespace crumple::laminated_plate_test
