// SPDX-License-Identifier: BSD-3-Clause
// Linear static solutions of the shells with 2 x 2 points in plane. The curved shells under slow loading are
// in tests/verification.
#include <gtest/gtest.h>

#include "elements/static_solution.hpp"
#include "support/shell_benchmarks.hpp"
#include "support/verified.hpp"

namespace crumple::elements::testing::static_shells_test {
namespace {

void control_hourglass(model::Model& model) {
  model.control.hourglass = {model::HourglassForm::Stiffness, 0.1, 0.1, 0.1};
}

double over_accepted(test::ShellBenchmark benchmark) {
  control_hourglass(benchmark.model);
  return under_first_load(benchmark.model, static_solution(benchmark.model, 1e-6)) / benchmark.accepted;
}

struct Curved {
  double cylinder, hemisphere;  ///< over the accepted displacements
};
Curved curved(const Kind& kind, Index n) {
  const Curved found{over_accepted(test::pinched_cylinder(kind.formulation, n)),
                     over_accepted(test::hemisphere(kind.formulation, n))};
  std::printf("%s %d x %d: pinched cylinder %.4f, hemisphere %.4f of the accepted\n", kind.name, n, n,
              found.cylinder, found.hemisphere);
  return found;
}

constexpr const char* macneal_harder = "MacNeal and Harder 1985";

/// The cylinder converges from below with about second order, as four-node elements do whose transverse shear
/// is tied; the hemisphere is right on the coarsest mesh.
TEST(StaticShell, FullyIntegratedConverges4To16) {
  const Curved coarse = curved(fully_integrated, 4);
  const Curved fine = curved(fully_integrated, 8);
  const Curved finest = curved(fully_integrated, 16);
  EXPECT_LT(1 - fine.cylinder, 0.5 * (1 - coarse.cylinder));
  EXPECT_LT(1 - finest.cylinder, 0.3 * (1 - fine.cylinder));
  EXPECT_LT(finest.cylinder, 1);
  int side = 4;
  for (const Curved& c : {coarse, fine, finest}) {
    test::verified(
        "hemisphere with a hole, ELFORM 16, " + std::to_string(side) + " a side: displacement over accepted",
        macneal_harder)
        .near(c.hemisphere, 1, 0.02);
    side *= 2;
  }
}
TEST(StaticShell, FullyIntegratedNightly32) {
  const Curved found = curved(fully_integrated, 32);
  EXPECT_NEAR(found.cylinder, 1, 0.02);
  EXPECT_NEAR(found.hemisphere, 1, 0.01);
}

TEST(StaticShell, SelectivelyReducedConverges4To16) {
  const Curved coarse = curved(hughes_liu_selective, 4);
  const Curved fine = curved(hughes_liu_selective, 8);
  const Curved finest = curved(hughes_liu_selective, 16);
  EXPECT_LT(std::fabs(1 - fine.cylinder), 0.5 * std::fabs(1 - coarse.cylinder));
  EXPECT_LT(std::fabs(1 - finest.cylinder), 0.3 * std::fabs(1 - fine.cylinder));
  EXPECT_LT(std::fabs(1 - fine.hemisphere), 0.6 * std::fabs(1 - coarse.hemisphere));
  EXPECT_LT(std::fabs(1 - finest.hemisphere), 0.6 * std::fabs(1 - fine.hemisphere));
}

/// How far the inner sides of a row lean, over half the height: none, all alike, one against the next.
enum class Shape { Rectangle, Parallelogram, Trapezoid };

/// The straight cantilever of MacNeal & Harder: 6 x 0.2 x 0.1, six elements in one row; in its plane (0.1081)
/// or across it (0.4321), a unit force at the tip.
double straight_cantilever(const Kind& kind, Shape shape, bool in_plane) {
  model::Model model =
      test::one_part({.id = 1, .title = "beam", .density = 1, .law = model::Elastic{1e7, 0.3}},
                     test::shell_section(0.1, 2, kind.formulation));
  control_hourglass(model);
  test::add_grid(model, 0, 6, 1, [&](double u, double v) {
    const Index i = static_cast<Index>(std::lround(6 * u));
    double lean = i == 0 || i == 6 || shape == Shape::Rectangle ? 0 : 0.2 * (v - 0.5);
    if (shape == Shape::Trapezoid && i % 2 == 0) lean = -lean;
    return test::Point{6 * u + lean, 0.2 * v, 0};
  });
  for (const Index root : {0, 7})
    model.fixed_nodes.push_back(
        {.node = root, .translation = {true, true, true}, .rotation = {true, true, true}});
  // The plate is flat: the drilling rotations have no stiffness.
  for (Index node = 0; node < 14; ++node)
    model.fixed_nodes.push_back({.node = node, .translation = {}, .rotation = {false, false, true}});
  const double y = in_plane ? 0.5 : 0;
  const double z = in_plane ? 0 : 0.5;
  model.nodal_loads.push_back({.node = 6, .force = {0, y, z}});
  model.nodal_loads.push_back({.node = 13, .force = {0, y, z}});
  return under_first_load(model, static_solution(model, 1e-7)) / (in_plane ? 0.1081 : 0.4321);
}

/// In its plane a row of rectangles or parallelograms follows beam theory as Pian and Sumihara's element
/// does; trapezoids lock, as in every four-node element without drilling rotations that passes the patch test
/// (R.H. MacNeal, 1987). Across its plane the shape makes no difference. The selectively reduced shell has
/// the bilinear element's in-plane bending, and needs rectangles also across its plane.
TEST(StaticShell, StraightCantilever6x1) {
  for (const Kind& kind : {fully_integrated, hughes_liu_selective}) {
    double in_plane[3];
    double across[3];
    int k = 0;
    for (const Shape shape : {Shape::Rectangle, Shape::Parallelogram, Shape::Trapezoid}) {
      in_plane[k] = straight_cantilever(kind, shape, true);
      across[k++] = straight_cantilever(kind, shape, false);
    }
    std::printf("%s rectangles, parallelograms, trapezoids: in plane %.4f %.4f %.4f, across %.4f %.4f %.4f\n",
                kind.name, in_plane[0], in_plane[1], in_plane[2], across[0], across[1], across[2]);
    const std::string beam = std::string("straight cantilever 6 x 1, ") + kind.name + ", ";
    test::verified(beam + "rectangles, across its plane: over accepted", macneal_harder)
        .near(across[0], 1, 0.03);
    if (kind.formulation == model::ShellFormulation::FullyIntegrated) {
      test::verified(beam + "rectangles, in its plane: over accepted", macneal_harder)
          .near(in_plane[0], 1, 0.02);
      test::verified(beam + "parallelograms, across its plane: over accepted", macneal_harder)
          .near(across[1], 1, 0.03);
      test::verified(beam + "trapezoids, across its plane: over accepted", macneal_harder)
          .near(across[2], 1, 0.03);
    } else {
      // (1 + (1 - nu) / 2 (a / b)^2) / (1 - nu^2) = 10.7 times as stiff in bending.
      test::verified(beam + "rectangles, in its plane: over accepted", "locking of the bilinear element")
          .near(in_plane[0], 1 / 10.7, 0.002);
    }
  }
}

/// A strip a thousand times as long as thick, elements a hundred times as long as thick and distorted: the
/// tip moves as a beam's does. Selective reduction keeps that promise for rectangles only: the one point sees
/// a shear in curved trapezoids, and full integration of the bending leaves it no way out.
TEST(StaticShell, DoesNotLockAtLengthOverThickness1000) {
  for (const Kind& kind : {fully_integrated, hughes_liu_selective})
    for (const double lean : {0.0, 0.3}) {
      model::Model model =
          test::one_part({.id = 1, .title = "strip", .density = 1, .law = model::Elastic{1e6, 0}},
                         test::shell_section(0.1, 2, kind.formulation));
      control_hourglass(model);
      test::add_grid(model, 0, 10, 1, [&](double u, double v) {
        const Index i = static_cast<Index>(std::lround(10 * u));
        const double shift = i == 0 || i == 10 ? 0 : 10 * lean * (v - 0.5) * (i % 2 == 0 ? 1 : -1);
        return test::Point{100 * u + shift, 10 * v, 0};
      });
      for (const Index root : {0, 11})
        model.fixed_nodes.push_back(
            {.node = root, .translation = {true, true, true}, .rotation = {true, true, true}});
      for (Index node = 0; node < 22; ++node)
        model.fixed_nodes.push_back({.node = node, .translation = {}, .rotation = {false, false, true}});
      model.nodal_loads.push_back({.node = 10, .force = {0, 0, 0.5}});
      model.nodal_loads.push_back({.node = 21, .force = {0, 0, 0.5}});
      const double exact = std::pow(100, 3) / (3 * 1e6 * 10 * std::pow(0.1, 3) / 12);
      const double ratio = under_first_load(model, static_solution(model, 1e-7)) / exact;
      std::printf("%s strip, lean %.1f: tip %.4f of the beam's\n", kind.name, lean, ratio);
      if (kind.formulation == model::ShellFormulation::FullyIntegrated || lean == 0) {
        test::verified(std::string("strip, length over thickness 1000, ") + kind.name +
                           (lean == 0 ? ", rectangles" : ", trapezoids") + ": tip over exact",
                       "Euler and Bernoulli")
            .near(ratio, 1, 0.01);
      } else {
        EXPECT_LT(ratio, 0.7);
      }
    }
}

}  // namespace
}  // namespace crumple::elements::testing::static_shells_test
