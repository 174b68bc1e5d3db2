// SPDX-License-Identifier: BSD-3-Clause
// Mass scaling during the run (DT2MS < 0, MS1ST = 0): elements that become shorter keep their step.

#include "elements/mass_scaling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>

#include "elements/elements.hpp"
#include "support/run.hpp"
#include "support/ties.hpp"
#include "support/verified.hpp"

namespace crumple::timeloop::mass_scaling_test {
namespace {

constexpr double speed = 50;  // of the far end against the near one [mm/ms]
constexpr double end = 0.12;  // a bar of 20 mm is shortened by 6 mm

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

/// Both ends are driven along the bar, the near one at the speed `drift`; it is held across, so that it
/// cannot buckle.
void compress(model::Model& model, double length, double drift) {
  const auto far = static_cast<Index>(model.curves.size());
  model.curves.push_back({.id = 8, .abscissa = {0, 1}, .ordinate = {drift - speed, drift - speed}});
  model.curves.push_back({.id = 9, .abscissa = {0, 1}, .ordinate = {drift, drift}});
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const double x = model.nodes.position[i][0];
    model.initial_velocities.push_back(
        {.node = i, .velocity = {drift - speed * x / length, 0, 0}, .angular_velocity = {}});
    model.fixed_nodes.push_back({.node = i, .translation = {false, true, true}, .rotation = {}});
    if (x > length - 1e-9) model.prescribed_motions.push_back({.node = i, .axis = 0, .curve = far});
    if (x < 1e-9) model.prescribed_motions.push_back({.node = i, .axis = 0, .curve = far + 1});
  }
  model.control.end_time = end;
}

struct Result {
  double smallest_step = 1e30;  ///< over the first one allowed
  double added = 0;             ///< over the mass at the start
  double missing = 0;           ///< of the masses at the nodes, over the mass at the start
  double kinetic = 0;           ///< at the start [energy]
  double imbalance = 0;         ///< at the end [energy]
  double absorbed = 0;          ///< at the end [energy]
};

Result result_of(const model::Model& model) {
  Simulation simulation(model, test::execution());
  const double mass = total_mass(simulation.domain());
  const double kept = model.control.step_scale * std::fabs(model.control.mass_scaling_step);
  Result found;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.clock.cycle == 0) found.kinetic = domain.energy.kinetic;
    if (domain.clock.cycle > 1)
      found.smallest_step = std::fmin(found.smallest_step, domain.clock.step / kept);
  });
  const domain::Domain& domain = simulation.domain();
  found.added = domain.added_mass / mass;
  found.missing = std::fabs(total_mass(domain) - mass - domain.added_mass) / mass;
  found.imbalance = domain.energy.imbalance();
  found.absorbed = domain.energy.absorbed();
  return found;
}

/// Without a drift the imbalance is that of work in steps of varying length; the drift must not change it.
/// `make(drift)` gives the model. The work of a driven body is shared between two steps: where these differ,
/// the energy of the drift does for that one step by half of f v (dt' - dt), which `allowed` must hold.
template <class Make>
void expect_balance(const std::string& what, const Make& make, double allowed = 1e-9) {
  const Result still = result_of(make(0));
  const Result moving = result_of(make(1000));
  EXPECT_GE(moving.smallest_step, 1 - 1e-9);
  EXPECT_GT(moving.added, 0.5);
  test::verified("mass scaling, " + what + ": masses at the nodes less those reported, over the mass", "sum")
      .below(moving.missing, 1e-12);
  test::verified("mass scaling, " + what + ": energy that the drift creates over that of the added mass",
                 "conservation")
      .below(std::fabs(moving.imbalance - still.imbalance) / (moving.added * moving.kinetic), allowed);
  test::verified("mass scaling, " + what + ": imbalance over the absorbed energy", "conservation")
      .below(std::fabs(still.imbalance) / still.absorbed, 5e-5);
}

model::Model bar(double drift) {
  model::Model model = test::one_solid_part(
      {.id = 1, .title = "steel", .density = test::density, .law = model::Elastic{test::modulus, 0}});
  model.control.bulk_linear = model.control.bulk_quadratic = 0;
  test::add_box(model, 0, 20, 2, 2, [](double u, double v, double w) {
    return test::Point{20 * u, 4 * v, 4 * w};
  });
  compress(model, 20, drift);
  keep_first_step(model, false);
  return model;
}

// All elements of a bar in even compression become as much shorter: mass goes with the inverse square.
TEST(MassScaling, BarInCompressionKeepsItsStep) {
  model::Model once = bar(0);
  once.control.scales_mass_once = true;
  EXPECT_LT(result_of(once).smallest_step, 0.8);
  EXPECT_EQ(result_of(once).added, 0);

  const double shortest = 1 - speed * end / 20;
  const double exact = 1 / (shortest * shortest) - 1;
  // An element that needs mass gets enough for a step that is 2 % longer.
  const double most = 1.02 * 1.02 * (1 + exact) - 1;
  test::verified("mass scaling of a bar in compression: mass added over the initial mass", "l0^2/l^2 - 1")
      .near(result_of(bar(0)).added, 0.5 * (exact + most), 0.51 * (most - exact));
  expect_balance("bar of solids", bar);
}

/// Forces of cross sections are computed on copies of the elements: they must leave masses alone.
TEST(MassScaling, SectionForcesChangeNothing) {
  model::Model model = bar(100);
  const double without = result_of(model).added;
  model::CrossSection section;
  section.id = 1;
  for (Index i = 0; i < model.nodes.count(); ++i)
    if (std::fabs(model.nodes.position[i][0] - 10) < 1e-9) section.nodes.push_back(i);
  for (Index i = 0; i < static_cast<Index>(model.solids.size()); ++i)
    if (model.nodes.position[model.solids[i].node[0]][0] > 10 - 1e-9 &&
        model.nodes.position[model.solids[i].node[0]][0] < 10.9)
      section.solids.push_back(i);
  ASSERT_FALSE(section.solids.empty());
  model.output.cross_sections.push_back(section);
  model.output.of(model::HistoryFile::Secforc).asked = true;
  EXPECT_EQ(result_of(model).added, without);
}

TEST(MassScaling, ShellsKeepTheirStep) {
  expect_balance("shells", [](double drift) {
    model::Model model = test::one_part(
        {.id = 1, .title = "steel", .density = test::density, .law = model::Elastic{test::modulus, 0}},
        test::shell_section(2.0, 2));
    test::add_grid(model, 0, 20, 2, [](double u, double v) { return test::Point{20 * u, 4 * v, 0}; });
    compress(model, 20, drift);
    keep_first_step(model, false);
    return model;
  });
}

/// The far end of a model as one body, driven instead of its nodes.
void make_end_rigid(model::Model& model) {
  model::RigidBody body;
  body.id = 77;
  body.fixed_translation = {false, true, true};
  body.fixed_rotation = {true, true, true};
  for (Index i = 0; i < model.nodes.count(); ++i)
    if (model.nodes.position[i][0] > 20 - 1e-9) body.nodes.push_back(i);
  const auto of_body = [&](const auto& item) { return model.nodes.position[item.node][0] > 20 - 1e-9; };
  std::erase_if(model.prescribed_motions, of_body);
  std::erase_if(model.fixed_nodes, of_body);
  model.rigid_bodies.push_back(body);
  model.prescribed_motions.push_back({.body = 0, .axis = 0, .curve = 0});
}

// Nodes that are tied move what carries them, and bodies have their nodes' new mass.
TEST(MassScaling, TiedNodesAndBodiesTakePart) {
  for (const bool rigid : {false, true}) {
    const auto make = [&](double drift) {
      model::Model model = test::two_blocks(2, 3, 10);
      compress(model, 20, drift);
      if (rigid) make_end_rigid(model);
      keep_first_step(model, false);
      return model;
    };
    expect_balance(rigid ? "tied blocks, one end rigid" : "tied blocks", make, rigid ? 5e-3 : 1e-9);
  }
}

}  // namespace
}  // namespace crumple::timeloop::mass_scaling_test
