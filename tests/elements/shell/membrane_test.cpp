// SPDX-License-Identifier: BSD-3-Clause
// Membranes: no bending, no rotary inertia, and what tension does to a warped element.
#include <gtest/gtest.h>

#include "elements/shell_harness.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"
#include "support/verified.hpp"

namespace crumple::elements::testing::membrane_test {
namespace {

constexpr double dt = 1e-7;

/// Rotations of the nodes and bending of the surface leave neither stress nor moment; the nodes have no
/// rotary inertia.
TEST(Membranes, DoNotFeelRotations) {
  for (const Kind& kind : membrane_kinds)
    for (const auto& execution : all_executions()) {
      Driven sheet(plate(kind.formulation, 3, 0.2), execution);
      std::vector<Vec3> still(sheet.domain.nodes.position.size());
      std::vector<Vec3> turned;
      for (const Vec3& x : sheet.domain.nodes.position) turned.push_back({0.1 * x.y, -0.2 * x.x, 0.3});
      sheet.step(dt, still, turned);
      EXPECT_EQ(sheet.largest_stress(), 0) << kind.name;
      for (Index i = 0; i < sheet.domain.nodes.count(); ++i) {
        EXPECT_EQ(norm(sheet.force(i)), 0);
        EXPECT_EQ(norm(sheet.moment(i)), 0);
        EXPECT_EQ(sheet.domain.nodes.inertia[i], 0);
        EXPECT_GT(sheet.domain.nodes.mass[i], 0);
      }
    }
}

/// Triangles of a part of membranes are membranes, too.
TEST(Membranes, TakeTriangles) {
  for (const Kind& kind : {membrane, full_membrane}) {
    model::Model model = plate(kind.formulation, 2, 0);
    const model::ShellElement first = model.shells.front();
    model.shells.front().node = {first.node[0], first.node[1], first.node[2], first.node[2]};
    model.shells.push_back(first);
    model.shells.back().id = 99;
    model.shells.back().node = {first.node[0], first.node[2], first.node[3], first.node[3]};
    const Driven sheet(model, {Precision::Double, Isa::Scalar, 1});
    ASSERT_EQ(sheet.domain.shells.size(), 2U);
    EXPECT_EQ(sheet.domain.shells[0].formulation, kind.formulation);
    EXPECT_EQ(sheet.domain.shells[1].formulation, model::ShellFormulation::MembraneTriangle);
  }
}

/// A square under the same tension N in both directions is warped by w: the corners, alternately up and down,
/// are drawn back. Of z = w xi eta the energy is N / 2 times the integral of |grad z|^2, 4/3 N w^2, and the
/// force on each corner 2/3 N w.
TEST(Membranes, TensionDrawsAWarpedElementFlat) {
  model::Model model = plate(full_membrane.formulation, 1, 0);
  test::Largest off("fully integrated membrane, tension and warp: force on a corner, relative error",
                    "energy of the bilinear surface, 2/3 N w", 1e-5);
  for (const auto& execution : all_executions()) {
    Driven square(model, execution);
    constexpr double stretch = 1e-3;
    const auto none = [](const Vec3&) { return Vec3{}; };
    square.step(
        dt, [](const Vec3& x) { return (1 + stretch) * x; }, none);
    const double tension = square.stress(0, 0, 0) * thickness;
    EXPECT_NEAR(tension, youngs_modulus / (1 - poissons_ratio) * stretch * thickness, 1e-3 * tension);
    constexpr double warp = 1e-4;
    const auto side = [](const Vec3& x) { return (x.x > 2) == (x.y > 2) ? 1.0 : -1.0; };
    square.step(
        dt,
        [&](const Vec3& x) {
          return x + Vec3{0, 0, warp * side(x)};
        },
        none);
    for (Index i = 0; i < 4; ++i) {
      const double force = -square.force(i).z * side(square.domain.nodes.position[i]);
      // The stretch by the warp itself adds to the tension: some (w / L)^2 over the stretch.
      off.compare(force, 2.0 / 3 * tension * warp, 2.0 / 3 * tension * warp, name_of(execution));
    }
  }
}

/// A beam bent in its plane: of the fully integrated membrane the energy is that of the beam, for any shape
/// of the rectangle.
TEST(Membranes, FullIntegrationBendsInItsPlaneAsABeam) {
  for (const double aspect : {0.5, 1.0, 4.0, 20.0})
    test::verified("fully integrated membrane, bent in its plane, length over height " +
                       std::to_string(aspect) + ": energy over the beam's",
                   "Bernoulli")
        .near(in_plane_bending_energy(full_membrane.formulation, aspect), 1, 1e-6);
}

/// The stable step is that of the Belytschko-Tsay shell.
TEST(Membranes, HaveTheStepOfShells) {
  const domain::Execution execution{Precision::Double, Isa::Scalar, 1};
  const auto limit = [&](const Kind& kind) {
    Driven sheet(plate(kind.formulation, 3, 0.2), execution);
    sheet.update(0);
    return sheet.domain.clock.element_limit;
  };
  EXPECT_EQ(limit(membrane), limit(belytschko_tsay));
  EXPECT_EQ(limit(full_membrane), limit(fully_integrated));
  EXPECT_EQ(limit(membrane_triangle), limit(triangle));
}

}  // namespace
}  // namespace crumple::elements::testing::membrane_test
