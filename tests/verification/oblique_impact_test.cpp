// SPDX-License-Identifier: BSD-3-Clause
//
// An elastic ball strikes obliquely and slides all the time. Exact are: the tangential impulse, mu times the
// normal one; the spin that it leaves; and, with a free block below, momentum and moment of momentum of the
// two. A rigid ball that slides all the time takes up the spin 5/2 mu (1 + e) v / R; it does so if its
// velocity along the plate exceeds 7/2 mu (1 + e) v (S.P. Timoshenko, D.H. Young, Advanced Dynamics, 1948, on
// the impact of a rough ball).

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "support/conservation.hpp"
#include "support/rigid.hpp"
#include "support/shapes.hpp"
#include "support/verified.hpp"

namespace crumple::oblique_impact_test {
namespace {

using math::Vec3;

constexpr double radius = 10;
constexpr double friction = 0.2;
constexpr double down = 10;
constexpr double along = 40;

enum class Below { FixedShells, FixedSolids, FreeBlock };

/// mm, ms, kg. The ball is the first part and comes first.
model::Model ball_above(Below below) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  model.shell_sections.push_back(test::shell_section(1.0, 3));
  model.control.hourglass.solid_form = model::SolidHourglassForm::ExactVolumeStiffness;
  test::add_ball(model, 0, 8, radius, {0, 0, radius + 0.001});
  const Index plate = model.nodes.count();
  test::set_moving(model, 0, {along, 0, -down});
  const auto turned = [](double u, double v, double z) {
    const double x = 36 * u - 16;
    const double y = 30 * v - 15;
    return test::Point{x * std::cos(0.2) - y * std::sin(0.2), x * std::sin(0.2) + y * std::cos(0.2), z};
  };
  if (below == Below::FixedShells)
    test::add_grid(model, test::add_shell_part(model), 6, 5,
                   [&](double u, double v) { return turned(u, v, -0.5); });
  else
    test::add_box(model, test::add_solid_part(model), 6, 5, 3,
                  [&](double u, double v, double w) { return turned(u, v, 18 * w - 18); });
  if (below != Below::FreeBlock) test::hold(model, plate, model.nodes.count());
  test::touch_all(model, friction);
  model.control.end_time = 0.12;
  return model;
}

/// Of the ball: momentum, and moment of momentum about a point that moves with it.
struct Ball {
  double mass = 0;
  double inertia = 0;  ///< about the y axis through the centre
  Vec3 centre;
  Vec3 momentum;
  Vec3 spin;  ///< moment of momentum about the centre

  Ball(const domain::Domain& domain, Index last) {
    const domain::NodeFields& nodes = domain.nodes;
    for (Index i = 0; i < last; ++i) {
      const Index node = nodes.domain_node[i];
      mass += nodes.mass[node];
      centre += nodes.mass[node] * nodes.position[node];
      momentum += nodes.mass[node] * nodes.velocity[node];
    }
    centre = (1 / mass) * centre;
    for (Index i = 0; i < last; ++i) {
      const Index node = nodes.domain_node[i];
      const Vec3 r = nodes.position[node] - centre;
      inertia += nodes.mass[node] * (r.x * r.x + r.z * r.z);
      spin += nodes.mass[node] * cross(r, nodes.velocity[node]);
    }
  }
};

class ObliqueImpact : public ::testing::TestWithParam<Below> {};

TEST_P(ObliqueImpact, SlidingTakesItsShareOfTheNormalImpulse) {
  const model::Model model = ball_above(GetParam());
  const Index last = 9 * 9 * 9;
  timeloop::Simulation simulation(model, test::execution());
  const domain::Domain& domain = simulation.domain();
  test::Conservation kept;
  Vec3 impulse;
  Vec3 before;
  test::run(simulation, [&](const domain::Domain& now) {
    if (now.clock.cycle == 0) before = Ball(now, last).momentum;
    kept.watch(now);
    // The kick that leads to these velocities.
    for (Index i = 0; i < last; ++i)
      impulse +=
          0.5 * (now.clock.step + simulation.next_step()) * now.contact_force[now.nodes.domain_node[i]];
  });
  const Ball ball(domain, last);
  const Vec3 change = ball.momentum - before;
  const double spin = ball.spin.y / ball.inertia;
  const double exact_spin = friction * impulse.z * radius / ball.inertia;
  std::printf(
      "tangential / normal impulse %.5f, velocity up / down %.4f, spin / exact %.4f, impulse %.1e, momentum "
      "%.1e, "
      "moment of momentum %.1e, energy %.1e\n",
      -impulse.x / impulse.z, ball.momentum.z / (ball.mass * down), spin / exact_spin,
      norm(change - impulse) / norm(change), kept.momentum_drift, kept.turning_drift, kept.worst_imbalance);
  EXPECT_EQ(domain.contacts[0].active_pairs, 0) << "they have parted";
  EXPECT_LT(norm(change - impulse), 1e-12 * norm(change));
  EXPECT_LT(kept.worst_imbalance, 1e-4);
  const double energy = std::fabs(domain.energy.imbalance());
  EXPECT_LT(energy, 0.01 * domain.energy.friction);
  if (GetParam() == Below::FreeBlock) {
    // The block turns a little, and the direction of the normal with it.
    test::verified("ball strikes a free block: tangential over normal impulse", "Coulomb")
        .within(-impulse.x / impulse.z, friction, 0.004);
    EXPECT_LT(kept.momentum_drift, 1e-13);
    EXPECT_LT(kept.turning_drift, 1e-13);
  } else {
    test::verified("ball strikes a fixed plate: tangential over normal impulse", "Coulomb")
        .within(-impulse.x / impulse.z, friction, 1e-4);
    // The place of contact moves by 0.8 mm over the plate.
    test::verified("ball strikes a fixed plate: spin over that of the impulse", "rigid ball")
        .near(spin / exact_spin, 1, 0.01);
  }
}

std::string name_of(const ::testing::TestParamInfo<Below>& info) {
  constexpr const char* names[] = {"FixedShells", "FixedSolids", "FreeBlock"};
  return names[static_cast<int>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(On, ObliqueImpact,
                         ::testing::Values(Below::FixedShells, Below::FixedSolids, Below::FreeBlock),
                         name_of);

}  // namespace
}  // namespace crumple::oblique_impact_test
