// SPDX-License-Identifier: BSD-3-Clause
//
// Fabric that wrinkles, against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/bags.hpp"
#include "support/discs.hpp"
#include "support/larger.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::fabric_test {
namespace {

using math::Vec3;
using model::ShellFormulation;

constexpr double modulus = 0.5;  // GPa
constexpr double density = 9e-7;

model::Material fabric(double poissons_ratio) {
  model::Fabric law;
  law.sheet.modulus_a = law.sheet.modulus_b = modulus;
  law.sheet.poisson_ba = poissons_ratio;
  law.sheet.shear_ab = 0.5 * modulus / (1 + poissons_ratio);
  law.wrinkles = true;
  set_stand_in(law);
  return {.id = 1, .title = "fabric", .density = density, .law = law};
}

struct Form {
  ShellFormulation formulation;
  const char* name;
};
constexpr Form forms[] = {{ShellFormulation::Membrane, "ELFORM 5"},
                          {ShellFormulation::FullyIntegratedMembrane, "ELFORM 9"}};

// A strip in tension P is bent by a moment M in its plane. From M = P h / 6 on it wrinkles along one edge:
// what bears is h (1 - k), and M / (P h) = 1/6 + k / 3 (M. Stein & J.M. Hedgepeth, NASA TN D-813 (1961)). The
// ends turn as plane sections, so the strain along the strip is that of a beam, e (1 + a y / h).
TEST(Fabric, AStripUnderTensionAndMomentWrinkles) {
  constexpr double length = 200;
  constexpr double height = 80;
  constexpr double thickness = 0.3;
  constexpr double mean = 1e-4;  // the bow makes the strip longer by the square of it
  for (const Form& form : forms)
    for (const double bending : {1.0}) {  // strain of the edges over the mean, less 1
      model::Model model = test::one_part(fabric(0.3), test::shell_section(thickness, 1, form.formulation));
      constexpr Index columns = 20;
      constexpr Index rows = 16;
      test::add_grid(model, 0, columns, rows, [](double u, double v) {
        return test::Point{length * (u - 0.5), height * (v - 0.5), 0};
      });
      const double omega = 2 * 3.14159265 / length * std::sqrt(modulus / density);
      model::Curve ramp;
      ramp.abscissa = {0, 5 / omega, 1e6};
      ramp.ordinate = {0, 1, 1};
      model.curves.push_back(ramp);
      for (Index node = 0; node < model.nodes.count(); ++node) {
        const auto& x = model.nodes.position[static_cast<std::size_t>(node)];
        model.fixed_nodes.push_back({.node = node, .translation = {false, false, true}, .rotation = {}});
        if (std::fabs(x[0]) < 0.4999 * length) continue;
        model.prescribed_motions.push_back({.node = node,
                                            .axis = 0,
                                            .kind = model::PrescribedMotion::Kind::Displacement,
                                            .curve = 0,
                                            .scale = x[0] * mean * (1 + bending * x[1] / (0.5 * height))});
      }
      for (const Index corner : {0, columns})
        model.fixed_nodes.push_back(
            {.node = corner + 8 * (columns + 1), .translation = {false, true, true}, .rotation = {}});
      // The strip bows across, which is slower than it stretches.
      model.mass_damping = model::MassDamping{.constant = 0.8 * omega};
      model.control.end_time = 150 / omega;
      timeloop::Simulation simulation(model, test::execution());
      test::run(simulation);
      const domain::Domain& now = simulation.domain();
      const domain::ShellBlock& block = now.shells[0];
      // Over the middle column: force, and moment about the middle of the height.
      double force = 0;
      double moment = 0;
      for (Index e = 0; e < block.elements; ++e) {
        const Index shell = block.element[e];
        if (shell % columns != columns / 2) continue;
        const Index row = shell / columns;
        const double y = height * ((row + 0.5) / rows - 0.5);
        double stress = 0;
        for (Index p = 0; p < block.points; ++p) stress += block.state(e, 5 * p) / block.points;
        force += stress * thickness * height / rows;
        moment += stress * thickness * y * height / rows;
      }
      const double found = moment / (force * height);
      // Strain 0 at y = -h / (2 bending): k is what lies below.
      const double share = bending > 1 ? 0.5 - 0.5 / bending : 0;
      const double bears = 1 - share;
      const double tension = 0.5 * modulus * mean * (1 + bending) * bears * height * thickness;
      const std::string of = "strip of fabric in tension and bending, edge strain " +
                             std::to_string(1 + static_cast<int>(bending)) + " times the mean, " + form.name +
                             ": ";
      if (bending > 1) {
        test::verified(of + "moment over P h", "Stein & Hedgepeth 1961")
            .within(found, 1.0 / 6 + share / 3, 0.01);
        test::verified(of + "tension over that of the part that bears", "beam without pressure")
            .within(force, tension, 0.01);
      } else {
        test::verified(of + "moment over P h", "beam, about to wrinkle").within(found, 1.0 / 6, 0.01);
      }
    }
}

// Two discs of inextensible fabric, sewn at the rim and inflated: the meridians keep their length, the hoops
// wrinkle (W.H. Paulsen, Amer. Math. Monthly 101 (1994) 953-958). Of the flat radius the inflated one is
// 1 / 1.31103, the thickness twice 0.59907 / 1.31103.
TEST(Fabric, TwoDiscsBecomeAMylarBalloon) {
  constexpr double radius = 200;
  constexpr double thickness = 0.3;
  model::Model model = test::one_part(
      fabric(0.0), test::shell_section(thickness, 1, ShellFormulation::FullyIntegratedMembrane));
  test::DiscBuilder discs(model, 6, radius);
  const auto bulge = [](double r) { return 0.05 * (1 - r * r / (radius * radius)) * radius; };
  discs.add(0, false, bulge);
  discs.add(0, true, [&](double r) { return -bulge(r); });
  const double pressure = 2e-6;
  model::Curve constant;
  constant.abscissa = {0, 1000};
  constant.ordinate = {pressure, pressure};
  model.curves.push_back(constant);
  model.control_volumes.push_back(
      test::bag_of_shells(model, model::PressureOfVolume{.coefficient = 0, .curve = 0}));
  // The bag is a mass on a spring of pressure: w^2 = p / (rho t r) or so.
  const double omega = std::sqrt(pressure / (density * thickness * radius));
  model.mass_damping = model::MassDamping{.constant = 2 * omega};
  model.control.end_time = 20 / omega;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& now = simulation.domain();
  double widest = 0;
  double top = 0;
  Index rim = 0;
  for (Index i = 0; i < now.nodes.count(); ++i) {
    const Vec3& was = now.nodes.reference[i];
    const Vec3& is = now.nodes.position[i];
    if (std::hypot(was.x, was.y) > radius * (1 - 1e-9)) {
      widest += std::hypot(is.x, is.y);
      ++rim;
    }
    if (std::hypot(was.x, was.y) < 1e-6 * radius) top = std::fmax(top, is.z);
  }
  test::verified("bag of two discs, inflated: radius over the flat one", "Paulsen 1994")
      .within(widest / rim / radius, 1 / 1.3110287771, 0.015);
  test::verified("bag of two discs, inflated: half its thickness over the flat radius", "Paulsen 1994")
      .within(top / radius, 0.5990701173 / 1.3110287771, 0.015);
}

}  // namespace
}  // namespace crumple::fabric_test
