// SPDX-License-Identifier: BSD-3-Clause
// Two equal elastic bars of solids meet end to end: by the wave equation they part after twice the time that
// a wave takes through one of them, and have exchanged their velocities (S.P. Timoshenko, J.N. Goodier,
// Theory of Elasticity, section on the impact of bars).

#include <gtest/gtest.h>

#include <cmath>

#include "support/larger.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::bar_impact_test {
namespace {

constexpr double length = 100;
constexpr double speed = 2;
constexpr double gap = 0.01;
constexpr double modulus = 210;
constexpr double density = 7.85e-6;

/// mm, ms, kg. Without lateral strain, so that the waves are those of the bar. The first is the left one,
/// which moves; its cross section has `cells` times as many elements as that of the second.
model::Model two_bars(Index first_cells, Index second_cells, double poisson = 0) {
  model::Model model = test::one_solid_part(
      {.id = 1, .title = "steel", .density = density, .law = model::Elastic{modulus, poisson}});
  model.parts.push_back({.id = 2, .title = "second", .solid_section = 0, .material = 0});
  const auto add = [&](Index part, Index cells, double start) {
    return test::add_box(model, part, 100, cells, cells, [=](double u, double v, double w) {
      return test::Point{start + length * u, 4 * v, 4 * w};
    });
  };
  add(0, first_cells, 0);
  const Index second = add(1, second_cells, length + gap);
  for (Index i = 0; i < second; ++i)
    model.initial_velocities.push_back({.node = i, .velocity = {speed, 0, 0}, .angular_velocity = {}});
  model.contacts.push_back(model::self_contact(1, "ends", {0, 1}));
  model.control.end_time = 0.06;
  return model;
}

struct Impact {
  double begin = 0;
  double end = 0;
  double first_velocity = 0;
  double second_velocity = 0;
  double momentum_error = 0;
  double energy_error = 0;
  double largest_force = 0;
};

Impact run_impact(const model::Model& model) {
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  simulation.start();
  const auto motion = [&] {
    std::array<double, 4> sum{};
    for (Index i = 0; i < domain.nodes.count(); ++i) {
      const std::size_t bar = domain.nodes.reference[i].x < length + 0.5 * gap ? 0 : 1;
      sum[bar] += domain.nodes.mass[i] * domain.nodes.velocity[i].x;
      sum[2 + bar] += domain.nodes.mass[i];
    }
    return sum;
  };
  const std::array<double, 4> before = motion();
  Impact impact;
  while (!simulation.finished()) {
    simulation.step();
    double force = 0;
    for (Index i = 0; i < domain.nodes.count(); ++i)
      if (domain.nodes.reference[i].x > length + 0.5 * gap) force += domain.contact_force[i].x;
    impact.largest_force = test::larger_of(impact.largest_force, force);
    const double full = 16 * 0.5 * std::sqrt(modulus * density) * speed;
    if (force > 0.5 * full) {
      if (impact.begin == 0) impact.begin = domain.clock.time;
      impact.end = domain.clock.time;
    }
  }
  const std::array<double, 4> after = motion();
  impact.first_velocity = after[0] / after[2];
  impact.second_velocity = after[1] / after[3];
  impact.momentum_error = std::fabs(after[0] + after[1] - before[0]) / before[0];
  impact.energy_error = domain.energy.error();
  return impact;
}

void expect_exchange(const std::string& of, const Impact& impact) {
  const double transit = length / std::sqrt(modulus / density);
  std::printf("duration / (2 L / c) %.4f, velocities / v %.4f %.4f, momentum %.1e, energy %.2e\n",
              (impact.end - impact.begin) / (2 * transit), impact.first_velocity / speed,
              impact.second_velocity / speed, impact.momentum_error, impact.energy_error);
  const char* const wave = "wave equation, exact";
  test::verified("two equal bars meet" + of + ": duration over exact", wave)
      .near((impact.end - impact.begin) / (2 * transit), 1, 0.03);
  test::verified("two equal bars meet" + of + ": velocity left", wave)
      .near(impact.first_velocity / speed, 0, 0.02);
  test::verified("two equal bars meet" + of + ": velocity given", wave)
      .near(impact.second_velocity / speed, 1, 0.02);
  EXPECT_LT(impact.momentum_error, 1e-12);
  test::verified("two equal bars meet" + of + ": energy error", "conservation")
      .below(impact.energy_error, 0.01);
}

TEST(BarImpact, EqualBarsExchangeTheirVelocities) {
  expect_exchange("", run_impact(two_bars(2, 2)));
}

TEST(BarImpact, MeshesNeedNotMatch) {
  model::Model model = two_bars(2, 3);
  // Forces on some of the nodes of an end would be patterns of hourglasses in elements of one point.
  model.solid_sections[0].formulation = model::SolidFormulation::SelectiveHexahedron;
  expect_exchange(", 2 x 2 against 3 x 3 elements", run_impact(model));
}

/// With lateral strain the ends widen, and the nodes of their flush rims slide on the other end.
TEST(BarImpact, BarsThatWidenExchangeTheirVelocities) {
  expect_exchange(", nu 0.3", run_impact(two_bars(2, 2, 0.3)));
  model::Model model = two_bars(2, 3, 0.3);
  model.solid_sections[0].formulation = model::SolidFormulation::SelectiveHexahedron;
  expect_exchange(", nu 0.3, 2 x 2 against 3 x 3 elements", run_impact(model));
}

TEST(BarImpact, MultipliersExchangeThemAsWell) {
  for (const Index cells : {2, 3}) {
    model::Model model = two_bars(2, cells);
    model.solid_sections[0].formulation = model::SolidFormulation::SelectiveHexahedron;
    model.contacts[0].enforcement = model::Enforcement::Multipliers;
    expect_exchange(cells == 2 ? ", by multipliers" : ", by multipliers, 2 x 2 against 3 x 3 elements",
                    run_impact(model));
  }
}

TEST(BarImpact, TheStepRecoversBesideMultipliers) {
  model::Model model = two_bars(2, 2);
  model.contacts[0].enforcement = model::Enforcement::Multipliers;
  timeloop::Simulation usual(model, test::execution());
  usual.start();
  model.control.initial_step = 0.01 * usual.next_step();
  timeloop::Simulation cautious(model, test::execution());
  cautious.start();
  EXPECT_LT(cautious.next_step(), 0.011 * usual.next_step());
  for (int cycle = 0; cycle < 100; ++cycle) cautious.step();
  EXPECT_GT(cautious.next_step(), 0.94 * usual.next_step()) << "it stays from 0.9 of what is allowed on";
}

}  // namespace
}  // namespace crumple::bar_impact_test
