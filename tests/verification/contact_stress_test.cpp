// SPDX-License-Identifier: BSD-3-Clause
//
// Contact where it is hardest: tubes that fold onto themselves, tubes that cross at speed, a sheet crumpled
// by a ball, thin strips, a shot. In every cycle, where the case does not say otherwise, the candidates of
// the search are compared with those of brute force, which stops the run at the first that was missed; at the
// end no mid-surface cuts another and no node is beyond one. Momentum is kept where nothing holds the bodies,
// and energy is in all of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "support/conservation.hpp"
#include "support/shapes.hpp"
#include "support/verified.hpp"

namespace crumple::contact_stress_test {
namespace {

struct Ordeal {
  Index cuts = 0;
  Index beyond = 0;
  double drift = 0;
  double turning = 0;
  domain::EnergyLedger energy;
  domain::ContactReport contact;
  long cycles = 0;
};

/// Runs with the search verified in each `every`th cycle.
Ordeal endure(const char* name, const model::Model& model, long every = 1) {
  timeloop::Simulation simulation(model, test::execution());
  simulation.verify_search_every(every);
  test::Conservation kept;
  test::run(simulation, [&](const domain::Domain& now) { kept.watch(now); });
  simulation.inspect_contacts();
  const domain::Domain& domain = simulation.domain();
  Ordeal found;
  found.contact = domain.contacts[0];
  found.cuts = found.contact.inspection.intersections;
  found.beyond = found.contact.inspection.nodes_beyond;
  found.drift = kept.momentum_drift;
  found.turning = kept.turning_drift;
  found.energy = domain.energy;
  found.cycles = domain.clock.cycle;
  const domain::EnergyLedger& energy = found.energy;
  const double first = energy.initial_total;
  std::printf(
      "%s: %ld cycles, %ld searches, worst penetration %.3f, deepest now %.2f, cuts %d, beyond %d; "
      "over the energy at first: kinetic %.3f, internal %.3f, hourglass %.3f, contact %.4f, friction %.4f; "
      "contact over internal %.1e, energy error %.1e, momentum %.1e, moment %.1e\n",
      name, found.cycles, found.contact.searches, found.contact.worst_penetration,
      found.contact.inspection.largest_depth, found.cuts, found.beyond, energy.kinetic / first,
      energy.internal / first, energy.hourglass / first, energy.contact / first, energy.friction / first,
      energy.contact / energy.internal, energy.error(), found.drift, found.turning);
  return found;
}

void expect_kept(const std::string& name, const Ordeal& found) {
  test::verified(name + ": drift of the momentum", "conservation").below(found.drift, 1e-13);
  test::verified(name + ": drift of the moment of momentum", "conservation").below(found.turning, 1e-13);
}

/// `energy_error` is the bound of the case on the error of the balance.
void expect_sound(const std::string& name, const Ordeal& found, double energy_error) {
  test::verified(name + ": error of the energy balance", "conservation")
      .below(found.energy.error(), energy_error);
  EXPECT_EQ(found.cuts, 0);
  EXPECT_EQ(found.beyond, 0);
  EXPECT_GT(found.contact.worst_penetration, 0) << "there must have been contact";
  EXPECT_GT(found.energy.contact, -0.004 * found.energy.internal);
}

/// A square tube, 40 mm wide and 1.2 mm thick, thrown onto a rigid wall with a mass at its far end.
model::Model box_tube(Index cells_of_side, double length, double time) {
  constexpr double half = 20;
  model::Model model = test::one_part(test::mild_steel(), test::shell_section(1.2, 3));
  model.control.hourglass.form = model::HourglassForm::Stiffness;
  const Index around = 4 * cells_of_side;
  const auto along = static_cast<Index>(length / (2 * half / cells_of_side));
  test::add_tube(model, 0, around, along, [=](double u, double v) {
    const auto [x, y] = test::on_square(u);
    // A small bow begins the folds.
    const double bow = 1 + 0.01 * std::sin(4 * std::numbers::pi * v) * (std::fabs(x) == 1 ? 1 : -1);
    return test::Point{half * x * bow, half * y * bow, length * v};
  });
  model::RigidWall wall;
  wall.id = 1;
  wall.normal = {0, 0, 1};
  wall.friction = 1;
  for (Index i = 0; i < model.nodes.count(); ++i) {
    wall.nodes.push_back(i);
    if (i >= along * around) model.lumped_masses.push_back({.id = i + 1, .node = i, .mass = 60.0 / around});
  }
  model.rigid_walls.push_back(wall);
  test::set_moving(model, 0, {0, 0, -20});
  test::touch_all(model, 0.2);
  model.control.end_time = time;
  return model;
}

TEST(ContactStress, BoxTubeFoldsOntoItself) {
  expect_sound("box tube folds onto itself", endure("box tube", box_tube(6, 120, 3)), 1e-5);
}

/// Round tubes across each other, in layers, each layer moving against the next at 100 m/s. `in_layer` tubes
/// lie side by side.
model::Model crossing_tubes(Index layers, Index in_layer, Index around, Index along, double time) {
  constexpr double radius = 15;
  constexpr double pitch = 36;
  model::Model model = test::one_part(test::mild_steel(), test::shell_section(1.5, 3));
  model.control.hourglass.form = model::HourglassForm::Stiffness;
  const double length = std::max(100.0, in_layer * pitch + 20);
  for (Index layer = 0; layer < layers; ++layer)
    for (Index i = 0; i < in_layer; ++i) {
      const double aside = pitch * (i - 0.5 * (in_layer - 1)) + 3 * layer;
      const double up = layer * (2 * radius + 2.5);
      const Index first = test::add_tube(model, 0, around, along, [=](double u, double v) {
        const auto [c, s] = test::on_circle(u + 0.013 * layer);
        const double x = length * (v - 0.5);
        const double y = aside + radius * c;
        return layer % 2 == 0 ? test::Point{x, y, up + radius * s} : test::Point{y, x, up + radius * s};
      });
      test::set_moving(model, first, {0, 0, -100 * (layer - 0.5 * (layers - 1))});
    }
  test::touch_all(model, 0.1);
  model.control.end_time = time;
  return model;
}

TEST(ContactStressSlow, CrossingTubes) {
  const Ordeal found = endure("4 tubes", crossing_tubes(2, 2, 16, 14, 0.8));
  expect_sound("four crossing tubes", found, 5e-5);
  expect_kept("four crossing tubes", found);
}

Ordeal twenty_crossing_tubes(model::ContactEdges edges, long every) {
  model::Model model = crossing_tubes(5, 4, 20, 32, 0.6);
  model.contacts[0].edges = edges;
  return endure(edges == model::ContactEdges::None ? "20 tubes" : "20 tubes with edges", model, every);
}

/// Edges cross between their nodes in folds as tight as these. Nodes and segments alone do not see it, and
/// four pairs of segments cut through each other at the end: so only the rest is asked for.
void expect_sound_but_for_crossing_edges(const Ordeal& found) {
  test::verified("twenty crossing tubes: error of the energy balance", "conservation")
      .below(found.energy.error(), 3e-4);
  EXPECT_EQ(found.beyond, 0);
  EXPECT_GT(found.energy.contact, -0.004 * found.energy.internal);
  expect_kept("twenty crossing tubes", found);
}

TEST(ContactStressNightly, TwentyCrossingTubes) {
  expect_sound_but_for_crossing_edges(twenty_crossing_tubes(model::ContactEdges::None, 50));
  // Brute force over all pairs of edges takes seconds for each look.
  const Ordeal found = twenty_crossing_tubes(model::ContactEdges::All, 1000);
  expect_sound("twenty crossing tubes with edges", found, 3e-4);
  expect_kept("twenty crossing tubes with edges", found);
}

/// Brute force over all nodes and segments takes minutes.
TEST(ContactStressNightly, TwentyCrossingTubesInEveryCycle) {
  expect_sound_but_for_crossing_edges(twenty_crossing_tubes(model::ContactEdges::None, 1));
}

/// A thin sheet that is held nowhere, with a ball that flies into it: it wraps around the ball and onto
/// itself.
TEST(ContactStressNightly, SheetCrumpledByABall) {
  model::Model model = test::one_part(test::mild_steel(), test::shell_section(0.4, 3));
  model.solid_sections.emplace_back().id = 1;
  model.control.hourglass.form = model::HourglassForm::Stiffness;
  test::add_grid(model, 0, 30, 30, [](double u, double v) {
    const double x = 120 * (u - 0.5);
    const double y = 120 * (v - 0.5);
    return test::Point{x, y, 0.2 * std::sin(0.3 * x) * std::cos(0.23 * y)};
  });
  const Index ball = test::add_ball(model, test::add_solid_part(model), 6, 15, {2, 1, 15.8});
  test::set_moving(model, ball, {0, 0, -60});
  test::touch_all(model, 0.1);
  model.control.end_time = 1.5;
  const Ordeal found = endure("sheet", model);
  expect_sound("sheet crumpled by a ball", found, 2e-5);
  expect_kept("sheet crumpled by a ball", found);
}

/// Strips one element wide, thrown at each other at random.
model::Model thin_strips(model::ContactEdges edges, double friction) {
  model::Model model = test::one_part(test::mild_steel(), test::shell_section(0.8, 3));
  model.control.hourglass.form = model::HourglassForm::Stiffness;
  std::mt19937 engine(7);
  const auto random = [&engine](double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) / 4294967295.0;
  };
  constexpr Index strips = 12;
  for (Index i = 0; i < strips; ++i) {
    const double angle = random(0, 2 * std::numbers::pi);
    const double up = 3.0 * i;
    const double tilt = random(-0.03, 0.03);
    const Index first = test::add_grid(model, 0, 25, 1, [&](double u, double v) {
      const double x = 75 * (u - 0.5);
      const double y = 3 * (v - 0.5);
      return test::Point{x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle),
                         up + tilt * y};
    });
    test::set_moving(model, first, {random(-5, 5), random(-5, 5), -8.0 * (i - 0.5 * (strips - 1))});
  }
  test::touch_all(model, friction).edges = edges;
  model.control.end_time = 1.5;
  return model;
}

TEST(ContactStress, ThinStrips) {
  const Ordeal found = endure("strips", thin_strips(model::ContactEdges::None, 0.1));
  EXPECT_EQ(found.beyond, 0);
  // Edges against edges are not seen by nodes on segments: strips have little else, and a few of them cut.
  EXPECT_LE(found.cuts, 6);
  test::verified("thin strips: error of the energy balance", "conservation")
      .below(found.energy.error(), 2e-4);
  EXPECT_GT(found.energy.contact, -0.004 * found.energy.internal);
  expect_kept("thin strips", found);
}

TEST(ContactStressSlow, ThinStripsThatTouchWithTheirEdges) {
  const Ordeal found = endure("strips with edges", thin_strips(model::ContactEdges::Free, 0.1));
  expect_sound("thin strips with edges", found, 2e-4);
  expect_kept("thin strips with edges", found);
}

TEST(ContactStress, ThinStripsWithSmoothEdgesKeepTheirMoment) {
  const Ordeal found = endure("smooth strips with edges", thin_strips(model::ContactEdges::Free, 0), 25);
  expect_sound("thin strips with smooth edges", found, 2e-4);
  expect_kept("thin strips with smooth edges", found);
}

/// A ball above or below a sheet of 20 x 20 elements of 4 mm.
model::Model sheet_and_ball(const test::Point& centre, const test::Point& velocity) {
  model::Model model = test::one_part(test::mild_steel(), test::shell_section(1.0, 3));
  model.solid_sections.emplace_back().id = 1;
  model.control.hourglass.form = model::HourglassForm::Stiffness;
  test::add_grid(model, 0, 20, 20, [](double u, double v) {
    return test::Point{80 * (u - 0.5), 80 * (v - 0.5), 0};
  });
  const Index ball = test::add_ball(model, test::add_solid_part(model), 6, 8, centre);
  test::set_moving(model, ball, velocity);
  test::touch_all(model);
  return model;
}

/// It grazes the sheet at 12 km/s and flies more than two elements of it in the 15 steps for which candidates
/// usually hold: it would be six, if its motion did not bound the step.
TEST(ContactStress, ShotThatFliesTwoElementsInAUsualSearchInterval) {
  model::Model model = sheet_and_ball({-55, 1, 8.45}, {12000, 0, 0});
  model.control.end_time = 0.009;
  const Ordeal found = endure("grazing shot", model);
  const double step = 0.009 / static_cast<double>(found.cycles);
  std::printf("elements in 15 steps: %.2f\n", 15 * step * 12000 / 4);
  EXPECT_GT(15 * step * 12000, 2 * 4.0);
  EXPECT_LT(15 * step * 12000, 15 * 0.2 * 4.0) << "a fifth of an edge in each step";
  EXPECT_GT(found.contact.worst_penetration, 0);
  EXPECT_EQ(found.cuts, 0);
  EXPECT_EQ(found.beyond, 0);
  test::verified("shot grazes a sheet at 12 km/s: error of the energy balance", "conservation")
      .below(found.energy.error(), 0.01);
  // Nodes are on the sheet from one step to the next, as deep as they fly: that is no approach.
  test::verified("shot grazes a sheet at 12 km/s: energy of the contact over that at first", "none")
      .below(std::fabs(found.energy.contact) / found.energy.initial_total, 1e-6);
  test::verified("shot grazes a sheet at 12 km/s: drift of the momentum", "conservation")
      .below(found.drift, 1e-13);
}

TEST(ContactStressSlow, ShotIntoASheet) {
  model::Model model = sheet_and_ball({1, 0.5, 30}, {0, 0, -300});
  model.control.end_time = 0.3;
  const Ordeal found = endure("shot", model);
  expect_sound("shot into a sheet", found, 5e-5);
  expect_kept("shot into a sheet", found);
}

}  // namespace
}  // namespace crumple::contact_stress_test
