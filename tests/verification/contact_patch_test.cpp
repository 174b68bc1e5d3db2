// SPDX-License-Identifier: BSD-3-Clause
//
// Patch test of contact (R.L. Taylor, P. Papadopoulos, On a patch test for contact problems in two
// dimensions, in Nonlinear Computational Mechanics, 1991): a block on a block, under an even pressure, free
// to widen. The stress is the pressure everywhere, whatever the meshes. Nodes that press on segments pass it
// where the meshes match; elsewhere the error is what is measured here. It does not fall with the mesh, but
// stays near the interface.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/shapes.hpp"
#include "support/verified.hpp"

namespace crumple::contact_patch_test {
namespace {

constexpr double side = 24;
constexpr double height = 12;
constexpr double pressure = 0.1;

/// mm, ms, kg. The lower block stands on the plane z = 0; `lower` and `upper` cells across, SLSFAC
/// `stiffness`. The upper one is narrower by that share.
model::Model two_blocks(Index lower, Index upper, double stiffness, double narrower = 0) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  model.solid_sections[0].formulation = model::SolidFormulation::SelectiveHexahedron;
  const auto add = [&](Index part, Index cells, double width, double bottom) {
    return test::add_box(model, part, cells, cells, 4, [=](double u, double v, double w) {
      return test::Point{width * u, width * v, bottom + height * w};
    });
  };
  add(0, lower, side, 0);
  const Index second = add(test::add_solid_part(model), upper, (1 - narrower) * side, height);
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const test::Point& x = model.nodes.position[i];
    model.fixed_nodes.push_back({.node = i, .translation = {x[0] == 0, x[1] == 0, x[2] == 0}});
  }
  model.curves.push_back({1, {0, 0.05, 1e6}, {0, 1, 1}});
  const Index top = second + 4 * (upper + 1) * (upper + 1);
  for (Index j = 0; j < upper; ++j)
    for (Index i = 0; i < upper; ++i) {
      const Index corner = top + (upper + 1) * j + i;
      model.pressure_loads.push_back({.node = {corner, corner + 1, corner + upper + 2, corner + upper + 1},
                                      .pressure = pressure,
                                      .curve = 0});
    }
  model.control.contact_stiffness_scale = stiffness;
  // The limit of stability shall cut no stiffness.
  model.control.step_scale = 0.5;
  model.control.end_time = 0.5;
  test::touch_all(model);
  return model;
}

/// Deviation of the stress along z from the pressure, over the pressure.
struct Deviation {
  double largest = 0;
  double beside = 0;  ///< root of the mean square, of the layers of elements at the interface
  double away = 0;    ///< of the other layers
};

Deviation pressed(const model::Model& model, const std::string& name) {
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 0.02);
  const domain::Domain& domain = simulation.domain();
  Deviation found;
  std::array<double, 2> count{};
  std::array<double, 2> squares{};
  for (const domain::SolidBlock& block : domain.solids)
    for (Index e = 0; e < block.elements; ++e) {
      double stress = 0;
      double z = 0;
      for (Index point = 0; point < block.points; ++point)
        stress += block.state(e, 6 * point + 2) / static_cast<double>(block.points);
      for (int k = 0; k < 8; ++k) z += domain.nodes.reference[block.node_of(e, k)].z / 8;
      const double off = stress / pressure + 1;
      const std::size_t layer = std::fabs(z - height) < height / 4 ? 0 : 1;
      found.largest = test::larger_of(found.largest, std::fabs(off));
      squares[layer] += off * off;
      count[layer] += 1;
    }
  found.beside = std::sqrt(squares[0] / count[0]);
  found.away = std::sqrt(squares[1] / count[1]);
  std::printf("%s: largest error %.2e, root of the mean square beside the interface %.2e, elsewhere %.2e\n",
              name.c_str(), found.largest, found.beside, found.away);
  return found;
}

Deviation pressed(Index lower, Index upper, double stiffness) {
  return pressed(two_blocks(lower, upper, stiffness), std::to_string(upper) + " on " + std::to_string(lower) +
                                                          " cells, SLSFAC " + std::to_string(stiffness));
}

/// All four sides are held, so that no mesh is in the other's way.
TEST(ContactPatch, IsPassedWhereMeshesMatch) {
  model::Model model = two_blocks(4, 4, 0.1);
  for (model::FixedNode& fixed : model.fixed_nodes)
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (model.nodes.position[fixed.node][axis] == side) fixed.translation[axis] = true;
  test::verified("patch test of contact, 4 on 4 cells: largest error of the stress", "exact")
      .below(pressed(model, "4 on 4 cells").largest, 1e-5);
}

/// The rims are almost flush, as after a mesh generator's rounding: the nodes of the wider block touch the
/// other's face all the same. If they do not, the pressure at the rim is wrong by 25 %.
TEST(ContactPatch, IsPassedWhereRimsAreAlmostFlush) {
  for (const double narrower : {0.0, 1e-8, 1e-5, 1e-4})
    for (const double stiffness : {0.1, 1.0})
      test::verified("patch test of contact, 4 on 4 cells, free sides, upper block narrower by " +
                         std::to_string(1e6 * narrower) + " millionths, SLSFAC " + std::to_string(stiffness) +
                         ": largest error of the stress",
                     "exact")
          .below(pressed(two_blocks(4, 4, stiffness, narrower), "almost flush").largest, 0.01);
}

/// With the usual stiffness the nodes go in by some times what the elements give way, evenly for each node,
/// and the pressure goes with the number of nodes that share it. A stiffer contact leaves the error of the
/// form itself.
TEST(ContactPatch, ErrorOfNodesOnSegments) {
  const auto error = [](const char* meshes) {
    return test::verified(std::string("patch test of contact, ") + meshes + ": error beside the interface",
                          "exact");
  };
  error("4 on 5 cells, SLSFAC 0.1").below(pressed(5, 4, 0.1).beside, 0.09);
  error("10 on 8 cells, SLSFAC 0.1").below(pressed(8, 10, 0.1).beside, 0.08);
  error("4 on 6 cells, SLSFAC 1").below(pressed(6, 4, 1).beside, 0.04);
  error("4 on 5 cells, SLSFAC 1").below(pressed(5, 4, 1).beside, 0.02);
  const Deviation fine = pressed(8, 10, 1);
  EXPECT_LT(fine.beside, 0.025);
  EXPECT_LT(fine.away, 0.006);
}

/// The rims of the blocks are flush, widen by turns and lift off by turns: nodes of the one leave the face of
/// the other sideways by some millionths of an element and come back, meanwhile deep. That is no approach and
/// may store nothing. With (omega dt)^2 = 1 of the contact nothing else bounds what is made.
TEST(ContactPatch, NodesAtFlushRimsMakeNoEnergy) {
  for (const double step_scale : {0.5, 0.37}) {
    model::Model model = two_blocks(6, 4, 1);
    model.control.step_scale = step_scale;
    model.control.end_time = 0.1;
    timeloop::Simulation simulation(model, test::execution());
    double least = 0;
    simulation.start();
    while (!simulation.finished()) {
      simulation.step();
      const domain::EnergyLedger& energy = simulation.domain().energy;
      least = std::min(least, energy.contact / energy.internal);
    }
    const std::string run =
        "flush blocks at " + std::to_string(step_scale).substr(0, 4) + " of the stable step, ";
    test::verified(run + "energy that their contact makes over internal", "conservation").below(-least, 1e-3);
    test::verified(run + "imbalance over what was absorbed", "conservation")
        .below(simulation.domain().energy.error(), 1e-4);
  }
}

}  // namespace
}  // namespace crumple::contact_patch_test
