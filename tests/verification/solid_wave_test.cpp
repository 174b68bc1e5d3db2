// SPDX-License-Identifier: BSD-3-Clause
//
// A long elastic bar of solids (nu = 0) flies with velocity v and is stopped at one end. Exact solution of
// the one-dimensional wave equation (e.g. K.F. Graff, Wave Motion in Elastic Solids, 1975, section 2.4):
// behind a front that runs at c = sqrt(E / rho) the bar is at rest under the stress rho c v.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::solid_wave_test {
namespace {

constexpr double length = 100;
constexpr double young = 210;
constexpr double density = 7.85e-6;
constexpr double velocity = 0.01;
constexpr Index along = 100;

struct Wave {
  double stress = 0;  ///< mean behind the front over rho c v
  double front = 0;   ///< where the particles have half their velocity, over c t
  double energy = 0;  ///< error over the initial energy
};

Wave stopped_bar(model::SolidFormulation formulation, model::SolidHourglassForm form, Precision precision) {
  model::Model model =
      test::one_solid_part({.id = 1, .title = "bar", .density = density, .law = model::Elastic{young, 0.0}});
  model.solid_sections[0].formulation = formulation;
  model.control.hourglass.solid_form = form;
  test::add_box(model, 0, along, 1, 1, [](double u, double v, double w) {
    return test::Point{length * u, v, w};
  });
  if (model::is_tetrahedral(formulation)) test::split_into_tetrahedra(model);
  for (Index node = 0; node < model.nodes.count(); ++node)
    if (model.nodes.position[node][0] == 0)
      model.fixed_nodes.push_back({.node = node, .translation = {true, true, true}});
    else
      model.initial_velocities.push_back({.node = node, .velocity = {-velocity, 0, 0}});
  const double c = std::sqrt(young / density);
  model.control.end_time = 0.6 * length / c;
  timeloop::Simulation simulation(model, {precision, default_isa(), 1});
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double reached = c * domain.clock.time;
  Wave wave;
  double elements = 0;
  const domain::SolidBlock& block = domain.solids[0];
  for (Index e = 0; e < block.elements; ++e) {
    const double x = domain.nodes.reference[block.node_of(e, 0)].x;
    if (x < 0.1 * length || x > 0.5 * length) continue;
    for (Index point = 0; point < block.points; ++point)
      wave.stress -= block.state(e, 6 * point) / static_cast<double>(block.points) / (density * c * velocity);
    elements += 1;
  }
  wave.stress /= elements;
  // The mean over the first corners' row, from the fixed end on.
  for (Index i = 0; i < along; ++i) {
    const auto speed = [&](Index node) { return -domain.nodes.velocity[domain.nodes.domain_node[node]].x; };
    if (speed(i) > 0.5 * velocity || speed(i + 1) < 0.5 * velocity) continue;
    const double share = (0.5 * velocity - speed(i)) / (speed(i + 1) - speed(i));
    wave.front = (static_cast<double>(i) + share) * length / along / reached;
  }
  wave.energy = std::fabs(domain.energy.imbalance()) / domain.energy.initial_total;
  return wave;
}

TEST(SolidWave, StressAndSpeedAreThoseOfTheWaveEquation) {
  using model::SolidFormulation;
  using model::SolidHourglassForm;
  struct Case {
    SolidFormulation formulation;
    SolidHourglassForm form;
    const char* name;
  };
  constexpr auto viscous = SolidHourglassForm::FlanaganBelytschkoViscous;
  for (const Case& of :
       {Case{SolidFormulation::OnePointHexahedron, viscous, "IHQ 2"},
        Case{SolidFormulation::OnePointHexahedron, SolidHourglassForm::AssumedStrain, "IHQ 6"},
        Case{SolidFormulation::SelectiveHexahedron, viscous, "ELFORM 2"},
        Case{SolidFormulation::Tetrahedron, viscous, "ELFORM 10"},
        Case{SolidFormulation::NodalPressureTetrahedron, viscous, "ELFORM 13"}})
    for (const Precision precision : {Precision::Double, Precision::Mixed}) {
      const Wave wave = stopped_bar(of.formulation, of.form, precision);
      std::printf("%s %s: stress behind the front / rho c v %.4f, front / c t %.4f, energy error %.1e\n",
                  of.name, precision == Precision::Double ? "double" : "mixed", wave.stress, wave.front,
                  wave.energy);
      const std::string bar = std::string("bar of solids stopped at one end, ") + of.name +
                              (precision == Precision::Double ? ", double" : ", mixed");
      test::verified(bar + ": stress behind the front over rho c v", "wave equation, exact")
          .near(wave.stress, 1, 0.01);
      test::verified(bar + ": place of the front over c t", "wave equation, exact").near(wave.front, 1, 0.01);
      test::verified(bar + ": energy error over the initial energy", "conservation").below(wave.energy, 1e-3);
    }
}

}  // namespace
}  // namespace crumple::solid_wave_test
