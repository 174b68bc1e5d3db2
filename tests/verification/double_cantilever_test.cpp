// SPDX-License-Identifier: BSD-3-Clause
//
// A crack that runs along a layer of cohesive solids between the arms of a double cantilever beam.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "support/cohesive.hpp"
#include "support/largest.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::double_cantilever_test {
namespace {

// A double cantilever beam: two arms of aluminium without lateral strain, the crack along x.
constexpr double arm_height = 1.5;
constexpr double arm_length = 30;
constexpr double cell = 0.5;
constexpr double crack = 10;
constexpr double modulus = 70;
constexpr double toughness = 3e-4;
// Sixteen times that of aluminium, for longer steps: the arms still swing some 15 times while the crack runs.
constexpr double density = 4.3e-5;

model::Model double_cantilever() {
  model::Model model =
      test::one_solid_part({.id = 1, .title = "arms", .density = density, .law = model::Elastic{modulus, 0}});
  // In bending ELFORM -2 keeps the volume, which without lateral strain makes two layers a quarter too stiff.
  model.solid_sections[0].formulation = model::SolidFormulation::SelectiveHexahedron;
  const auto cells = static_cast<Index>(std::lround(arm_length / cell));
  std::array<Index, 2> start{};
  for (const Index arm : {0, 1})
    start[static_cast<std::size_t>(arm)] =
        test::add_box(model, 0, cells, 1, 2, [&](double u, double v, double w) {
          return test::Point{arm_length * u, v, arm_height * (arm == 0 ? w - 1 : w)};
        });
  const Index layer = test::add_layer(model,
                                      {.youngs_modulus = 100,
                                       .shear_stiffness = 100,
                                       .normal_strength = 0.03,
                                       .shear_strength = 0.03,
                                       .normal_energy = toughness,
                                       .shear_energy = toughness,
                                       .mass_by_area = true,
                                       .failed_points = 4},
                                      1e-9);
  const Index row = cells + 1;
  const Index top = start[0] + 4 * row;
  for (Index i = static_cast<Index>(std::lround(crack / cell)); i < cells; ++i) {
    const auto face = [&](Index from) {
      return std::array<Index, 4>{from + i, from + i + 1, from + row + i + 1, from + row + i};
    };
    const auto a = face(top);
    const auto b = face(start[1]);
    model.solids.push_back({.id = static_cast<UserId>(model.solids.size()) + 1,
                            .part = layer,
                            .node = {a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]}});
  }
  // The ends of the arms are drawn apart, slowly at first; the far end stays.
  model.curves.push_back({1, {0, 1, 1e6}, {0, 1, 1}});
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const auto& x = model.nodes.position[node];
    if (x[0] < 1e-9 && std::fabs(std::fabs(x[2]) - 0.5 * arm_height) < 1e-9)
      model.prescribed_motions.push_back(
          {.node = node, .axis = 2, .curve = 0, .scale = x[2] > 0 ? 0.15 : -0.15});
    if (x[0] > arm_length - 1e-9)
      model.fixed_nodes.push_back({.node = node, .translation = {true, false, false}, .rotation = {}});
  }
  model.mass_damping = model::MassDamping{.constant = 0.3};
  model.control.end_time = 6;
  return model;
}

/// J.G. Williams, Int. J. Fracture 36 (1988) 101-119 and every text on the test: the arms are cantilevers of
/// the length a of the crack, 2 deflections make the opening 2 P a^3 / (3 E I), and G = P^2 a^2 / (b E I).
/// Without a, which the cracks tip's compliance shifts, P sqrt(opening) stays while the crack runs.
TEST(DoubleCantilever, ACrackRunsThroughADoubleCantileverBeam) {
  const model::Model model = double_cantilever();
  timeloop::Simulation simulation(model, test::execution());
  double work = 0;
  double opening = 0;
  std::vector<std::array<double, 2>> forces;  // opening and force, means over windows of it
  constexpr double window = 0.1;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double now = 2 * test::displacement(domain, model.prescribed_motions.back().node).z;
    if (now < opening + window) return;
    const double done = domain.energy.external_work;
    forces.push_back({0.5 * (now + opening), (done - work) / (now - opening)});
    work = done;
    opening = now;
  });
  const domain::Domain& domain = simulation.domain();
  const domain::SolidBlock& layer = domain.solids[1];
  const double bending = modulus * arm_height * arm_height * arm_height / 12;
  const double constant = std::sqrt(toughness * bending * 2.0 / 3 * std::sqrt(toughness / bending));
  test::Largest curve("double cantilever beam: force over opening while the crack runs, error",
                      "beam theory (Williams 1988)", 0.02);
  for (const auto& [at, force] : forces) {
    std::printf("opening %.3f: force %.5f, theory %.5f\n", at, force, constant / std::sqrt(at));
    if (at > 0.5) curve.compare(force / (constant / std::sqrt(at)), 1);
  }
  const double cracked = layer.eroded * cell;
  std::printf("gone %d, energy of what is gone over GIC area %.5f, imbalance %.1e\n", layer.eroded,
              layer.eroded_energy / (toughness * cracked),
              std::fabs(domain.energy.imbalance()) / domain.energy.external_work);
  EXPECT_GT(layer.eroded, 12);
  test::verified("double cantilever beam: energy of the cracked elements over GIC times their area", "exact")
      .near(layer.eroded_energy / (toughness * cracked), 1, 5e-3);
  // The crack stands where the opening wants it, but for what the tip's compliance adds.
  const double length = std::sqrt(1.5 * opening / std::sqrt(toughness / bending));
  test::verified("double cantilever beam: length of the crack at the end", "beam theory (Williams 1988)")
      .within(crack + cracked, length, 0.12);
}

}  // namespace
}  // namespace crumple::double_cantilever_test
