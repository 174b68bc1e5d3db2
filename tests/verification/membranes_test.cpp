// SPDX-License-Identifier: BSD-3-Clause
//
// Membranes under pressure, against closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "support/bags.hpp"
#include "support/discs.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::membranes_test {
namespace {

using math::Vec3;
using model::ShellFormulation;

constexpr double youngs_modulus = 210;
constexpr double poissons_ratio = 0.3;
constexpr double density = 7.85e-6;

struct Form {
  ShellFormulation formulation;
  const char* name;
};
constexpr Form forms[] = {{ShellFormulation::Membrane, "ELFORM 5"},
                          {ShellFormulation::FullyIntegratedMembrane, "ELFORM 9"}};

void split_into_triangles(model::Model& model) {
  std::vector<model::ShellElement> halves;
  for (const model::ShellElement& shell : model.shells) {
    model::ShellElement half = shell;
    half.node = {shell.node[0], shell.node[1], shell.node[2], shell.node[2]};
    halves.push_back(half);
    half.node = {shell.node[0], shell.node[2], shell.node[3], shell.node[3]};
    half.id += 100000;
    halves.push_back(half);
  }
  model.shells = halves;
}

/// A ball of n x n shells for each face of a cube.
model::Model ball(ShellFormulation formulation, int n, double radius, double thickness) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(thickness, 1, formulation));
  test::add_closed_box(model, 0, n, [&](double x, double y, double z) {
    const auto angle = [](double u) { return std::tan(0.25 * std::numbers::pi * u); };
    const Vec3 at{angle(x), angle(y), angle(z)};
    const double size = radius / norm(at);
    return test::Point{size * at.x, size * at.y, size * at.z};
  });
  return model;
}

/// Growth of the mean radius over p r^2 (1 - nu) / (2 E t).
double growth_of_ball(ShellFormulation formulation, int n, bool triangles) {
  const double radius = 100;
  const double thickness = 1;
  const double pressure = 0.01;
  model::Model model = ball(formulation, n, radius, thickness);
  if (triangles) split_into_triangles(model);
  model.control_volumes.push_back(
      test::bag_of_shells(model, model::PressureOfVolume{.coefficient = pressure, .curve = no_index}));
  // The period of breathing, damped critically.
  const double omega = std::sqrt(2 * youngs_modulus / (density * (1 - poissons_ratio))) / radius;
  model.mass_damping = model::MassDamping{.constant = 2 * omega};
  model.control.end_time = 15 / omega;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  double growth = 0;
  const domain::NodeFields& nodes = simulation.domain().nodes;
  for (Index i = 0; i < nodes.count(); ++i) growth += norm(nodes.position[i]) - norm(nodes.reference[i]);
  return growth / nodes.count() /
         (pressure * radius * radius * (1 - poissons_ratio) / (2 * youngs_modulus * thickness));
}

// A ball of membranes has no bending: what is off is the mesh, of second order.
TEST(Membranes, BallIsInflatedAsAThinSphere) {
  for (const Form& form : forms) {
    const double coarse = std::fabs(growth_of_ball(form.formulation, 6, false) - 1);
    const double fine = std::fabs(growth_of_ball(form.formulation, 12, false) - 1);
    test::verified(
        std::string("ball of 864 membranes, ") + form.name + ": growth of the radius, relative error",
        "thin sphere")
        .below(fine, 0.01);
    EXPECT_LT(fine, 0.4 * coarse) << form.name;
  }
  test::verified("ball of 1728 triangles of membranes: growth of the radius, relative error", "thin sphere")
      .below(std::fabs(growth_of_ball(ShellFormulation::Membrane, 12, true) - 1), 0.01);
}

/// A plane disc held at its edge.
model::Model disc(ShellFormulation formulation, int n, double radius, double thickness) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(thickness, 1, formulation));
  test::DiscBuilder(model, n, radius).add(0, false, [](double) { return 0.0; });
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const auto& x = model.nodes.position[static_cast<std::size_t>(node)];
    if (std::hypot(x[0], x[1]) > radius * (1 - 1e-9))
      model.fixed_nodes.push_back({.node = node, .translation = {true, true, true}, .rotation = {}});
  }
  return model;
}

/// Hencky's series for a clamped circular membrane under uniform pressure (H. Hencky, Zeitschrift fuer
/// Mathematik und Physik 63 (1915) 311-317; coefficients corrected in W.B. Fichter, NASA TP-3658 (1997)):
/// deflection of the middle a q^(1/3) sum of a_2n, stress there E q^(2/3) b0 / 4, q = p a / (E t).
struct Hencky {
  double deflection;  ///< over a q^(1/3)
  double stress;      ///< over E q^(2/3)
};
constexpr double b0 = 1.7244;  // for nu = 0.3
Hencky hencky() {
  const double cube = 1 / (b0 * b0 * b0);
  const double coefficient[] = {1, 1.0 / 2, 5.0 / 9, 55.0 / 72, 7.0 / 6, 205.0 / 108, 17051.0 / 5292};
  double sum = 0;
  double power = 1 / b0;
  for (const double c : coefficient) {
    sum += c * power;
    power *= cube;
  }
  return {sum, b0 / 4};
}

// The plane of the membrane has no stiffness against the first deflection: tension alone carries the load.
TEST(Membranes, CircularMembraneFollowsHencky) {
  const double radius = 100;
  const double thickness = 0.1;
  const double pressure = 1e-5;
  const double q = pressure * radius / (youngs_modulus * thickness);
  const Hencky exact = hencky();
  for (const Form& form : forms) {
    model::Model model = disc(form.formulation, 8, radius, thickness);
    model::Curve curve;
    curve.abscissa = {0, 1e6};
    curve.ordinate = {1, 1};
    model.curves.push_back(curve);
    for (const model::ShellElement& shell : model.shells)
      model.pressure_loads.push_back({.node = shell.node, .pressure = -pressure, .curve = 0, .arrival = 0});
    const double tension = youngs_modulus * std::cbrt(q * q) * exact.stress * thickness;
    // The lowest frequency of a membrane of constant tension, damped critically.
    const double omega = 2.405 / radius * std::sqrt(tension / (density * thickness));
    model.mass_damping = model::MassDamping{.constant = 2 * omega};
    model.control.end_time = 9 / omega;
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    const domain::Domain& now = simulation.domain();
    double deflection = 0;
    for (Index i = 0; i < now.nodes.count(); ++i)
      if (norm(now.nodes.reference[i]) < 1e-6 * radius) deflection = std::fabs(now.nodes.position[i].z);
    const std::string of = std::string("clamped circular membrane, ") + form.name + ": ";
    test::verified(of + "deflection of the middle over a (p a / (E t))^(1/3)", "Hencky 1915, Fichter 1997")
        .within(deflection / (radius * std::cbrt(q)), exact.deflection, 0.005);
    // The first element has a corner a seventh of the way from the middle.
    double sum = 0;
    Index count = 0;
    for (Index e = 0; e < now.shells[0].elements; ++e) {
      const auto& shell = model.shells[static_cast<std::size_t>(now.shells[0].element[e])];
      if (std::none_of(shell.node.begin(), shell.node.end(), [&](Index node) {
            const auto& x = model.nodes.position[static_cast<std::size_t>(node)];
            return std::hypot(x[0], x[1]) < 1e-6 * radius;
          }))
        continue;
      for (Index plane = 0; plane < now.shells[0].plane_points; ++plane, ++count)
        sum += 0.5 * (now.shells[0].state(e, 5 * plane) + now.shells[0].state(e, 5 * plane + 1));
    }
    ASSERT_GT(count, 0);
    test::verified(of + "stress in the middle over E (p a / (E t))^(2/3)", "Hencky 1915, Fichter 1997")
        .within(sum / count / (youngs_modulus * std::cbrt(q * q)), exact.stress, 0.01);
  }
}

}  // namespace
}  // namespace crumple::membranes_test
