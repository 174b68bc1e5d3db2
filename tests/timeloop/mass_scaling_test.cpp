// SPDX-License-Identifier: BSD-3-Clause
// Mass scaling during the run (DT2MS < 0, MS1ST = 0): elements that become shorter keep their step.

#include "elements/mass_scaling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "elements/elements.hpp"
#include "support/imbalance.hpp"
#include "support/run.hpp"
#include "support/ties.hpp"
#include "support/verified.hpp"

namespace crumple::timeloop::mass_scaling_test {
namespace {

constexpr double speed = 50;   // of the far end [mm/ms]
constexpr double end = 0.12;   // a bar of 20 mm is shortened by 6 mm
constexpr double drift = 100;  // across, of the whole bar [mm/ms]

double total_mass(const domain::Domain& domain) {
  return std::accumulate(domain.nodes.mass.begin(), domain.nodes.mass.end(), 0.0);
}

/// Kept at its present shortest step, which is that along the bar.
void keep_first_step(model::Model& model, bool once) {
  const Simulation plain(model, test::execution());
  double shortest = 1e30;
  for (const domain::SolidBlock& block : plain.domain().solids)
    shortest = std::fmin(shortest, elements::stable_step(plain.domain(), block));
  for (const domain::ShellBlock& block : plain.domain().shells)
    shortest = std::fmin(shortest, elements::stable_step(plain.domain(), block));
  model.control.mass_scaling_step = -shortest;
  model.control.scales_mass_once = once;
}

/// One end held along the bar, the other driven; all of it drifts across.
void compress(model::Model& model, double length) {
  model.curves.push_back({.id = 9, .abscissa = {0, 1}, .ordinate = {-speed, -speed}});
  const auto curve = static_cast<Index>(model.curves.size()) - 1;
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const double x = model.nodes.position[i][0];
    model.initial_velocities.push_back(
        {.node = i, .velocity = {-speed * x / length, drift, 0}, .angular_velocity = {}});
    if (x < 1e-9)
      model.fixed_nodes.push_back({.node = i, .translation = {true, false, false}, .rotation = {}});
    if (x > length - 1e-9) model.prescribed_motions.push_back({.node = i, .axis = 0, .curve = curve});
  }
  model.control.end_time = end;
}

struct Result {
  double smallest_step = 1e30;  ///< over the first one allowed
  double added = 0;             ///< over the mass at the start
  double missing = 0;           ///< of the masses at the nodes, over the mass at the start
  double imbalance = 0;         ///< over the kinetic energy at the start
};

Result result_of(const model::Model& model) {
  Simulation simulation(model, test::execution());
  const double mass = total_mass(simulation.domain());
  const double kept = model.control.step_scale * std::fabs(model.control.mass_scaling_step);
  Result found;
  test::ImbalanceAfterStart imbalance;
  double kinetic = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    imbalance.observe(domain);
    if (domain.clock.cycle == 0) kinetic = domain.energy.kinetic;
    if (domain.clock.cycle > 1)
      found.smallest_step = std::fmin(found.smallest_step, domain.clock.step / kept);
  });
  const domain::Domain& domain = simulation.domain();
  found.added = domain.added_mass / mass;
  found.missing = std::fabs(total_mass(domain) - mass - domain.added_mass) / mass;
  found.imbalance = imbalance.largest() / kinetic;
  return found;
}

model::Model bar() {
  model::Model model = test::one_solid_part(
      {.id = 1, .title = "steel", .density = test::density, .law = model::Elastic{test::modulus, 0}});
  test::add_box(model, 0, 20, 2, 2, [](double u, double v, double w) {
    return test::Point{20 * u, 4 * v, 4 * w};
  });
  compress(model, 20);
  return model;
}

// All elements of a bar in even compression become as much shorter: mass goes with the inverse square.
TEST(MassScaling, BarInCompressionKeepsItsStep) {
  model::Model model = bar();
  keep_first_step(model, true);
  const Result once = result_of(model);
  EXPECT_LT(once.smallest_step, 0.8);
  EXPECT_EQ(once.added, 0);

  model.control.scales_mass_once = false;
  const Result kept = result_of(model);
  EXPECT_GE(kept.smallest_step, 1 - 1e-9);
  const double shortest = 1 - speed * end / 20;
  const double exact = 1 / (shortest * shortest) - 1;
  // An element that needs mass gets enough for a step that is 2 % longer.
  const double most = 1.02 * 1.02 * (1 + exact) - 1;
  test::verified("mass scaling of a bar in compression: mass added over the initial mass", "l0^2/l^2 - 1")
      .near(kept.added, 0.5 * (exact + most), 0.51 * (most - exact));
  test::verified("mass scaling of a bar in compression: masses at the nodes less those reported", "sum")
      .below(kept.missing, 1e-12);
  test::verified("mass scaling of a bar that drifts: imbalance over the kinetic energy, as without",
                 "conservation")
      .below(kept.imbalance, std::fmax(3 * once.imbalance, 1e-9));
}

TEST(MassScaling, ShellsKeepTheirStep) {
  model::Model model = test::one_part(
      {.id = 1, .title = "steel", .density = test::density, .law = model::Elastic{test::modulus, 0}},
      test::shell_section(2.0, 2, model::ShellFormulation::BelytschkoTsay));
  test::add_grid(model, 0, 20, 2, [](double u, double v) { return test::Point{20 * u, 4 * v, 0}; });
  compress(model, 20);
  keep_first_step(model, false);
  const Result kept = result_of(model);
  EXPECT_GE(kept.smallest_step, 1 - 1e-9);
  EXPECT_GT(kept.added, 0.5);
  EXPECT_LT(kept.missing, 1e-12);
  test::verified("mass scaling of shells that drift: imbalance over the kinetic energy", "conservation")
      .below(kept.imbalance, 1e-4);
}

/// Nodes that are tied move what carries them, and bodies have their nodes' new mass.
TEST(MassScaling, TiedNodesAndBodiesTakePart) {
  for (const bool rigid : {false, true}) {
    SCOPED_TRACE(rigid);
    model::Model model = test::two_blocks(2, 3, 10);
    if (rigid) {
      model::RigidBody body;
      body.id = 77;
      for (Index i = 0; i < model.nodes.count(); ++i)
        if (std::fabs(model.nodes.position[i][0] - 20) < 1e-9) body.nodes.push_back(i);
      model.rigid_bodies.push_back(body);
    }
    compress(model, 20);
    if (rigid) {
      model.prescribed_motions.clear();
      model.prescribed_motions.push_back({.body = 0, .axis = 0, .curve = 0});
    }
    keep_first_step(model, false);
    const Result kept = result_of(model);
    EXPECT_GE(kept.smallest_step, 1 - 1e-9);
    EXPECT_GT(kept.added, 0.5);
    EXPECT_LT(kept.missing, 1e-12);
    model.control.scales_mass_once = true;
    const Result once = result_of(model);
    std::printf("imbalance over the kinetic energy: %.2e, without %.2e\n", kept.imbalance, once.imbalance);
    EXPECT_LT(kept.imbalance, 3 * once.imbalance + 1e-6);
  }
}

}  // namespace
}  // namespace crumple::timeloop::mass_scaling_test
