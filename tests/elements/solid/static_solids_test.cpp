// SPDX-License-Identifier: BSD-3-Clause
// Static problems with the kernels' own stiffness: a cantilever in bending, and a thick cylinder of a
// material that hardly changes its volume.
#include <gtest/gtest.h>

#include <cstdio>

#include "elements/solid_harness.hpp"
#include "elements/static_solution.hpp"
#include "support/verified.hpp"

namespace crumple::elements::testing::static_solids_test {
namespace {

constexpr SolidCase form_4{.form = model::SolidHourglassForm::FlanaganBelytschkoStiffness, .name = "IHQ 4"};
constexpr SolidCase form_5{.form = model::SolidHourglassForm::ExactVolumeStiffness, .name = "IHQ 5"};
constexpr SolidCase form_6{.form = model::SolidHourglassForm::AssumedStrain, .name = "IHQ 6"};
constexpr SolidCase selective{.formulation = model::SolidFormulation::SelectiveHexahedron,
                              .name = "ELFORM 2"};
constexpr SolidCase assumed{.formulation = model::SolidFormulation::AssumedStrainHexahedron,
                            .name = "ELFORM -2"};
constexpr SolidCase tetrahedron{.formulation = model::SolidFormulation::Tetrahedron, .name = "ELFORM 10"};
constexpr SolidCase nodal_pressure{.formulation = model::SolidFormulation::NodalPressureTetrahedron,
                                   .name = "ELFORM 13"};

/// Deflection of the end of a beam of length 10 and section 1 x 1, over that of Timoshenko's theory, P L^3 /
/// (3 E I) + P L / (k G A), k = 10 (1 + nu) / (12 + 11 nu) (G.R. Cowper 1966). `skew` leans the sections by
/// that times their distance from the ends.
double cantilever(const SolidCase& of, double coefficient, Index along, Index across, double skew = 0) {
  constexpr double length = 10;
  model::Model model = solid_model(of, elastic());
  model.control.hourglass.coefficient = coefficient;
  model.control.bulk_linear = model.control.bulk_quadratic = 0;
  test::add_box(model, 0, along, across, across, [&](double u, double v, double w) {
    const bool end = u == 0 || u == 1;
    return test::Point{length * u + (end ? 0 : skew * (w - 0.5)), v, w};
  });
  split_for(of, model);
  hold_rotations(model);
  const double share = 1.0 / static_cast<double>(across);
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const auto& x = model.nodes.position[node];
    if (x[0] == 0) model.fixed_nodes.push_back({.node = node, .translation = {true, true, true}});
    if (x[0] != length) continue;
    double force = share * share;
    for (const double coordinate : {x[1], x[2]})
      if (coordinate == 0 || coordinate == 1) force *= 0.5;
    model.nodal_loads.push_back({.node = node, .force = {0, 0, force}});
  }
  const std::vector<double> u = static_solution(model, 1e-7);
  double work = 0;
  for (const model::NodalLoad& load : model.nodal_loads)
    work += load.force[2] * u[6 * static_cast<std::size_t>(load.node) + 2];
  const double shear = 0.5 * youngs_modulus / (1 + poissons_ratio);
  const double factor = 10 * (1 + poissons_ratio) / (12 + 11 * poissons_ratio);
  const double exact = length * length * length * 12 / (3 * youngs_modulus) + length / (factor * shear);
  const double ratio = work / exact;
  std::printf("cantilever, %s QM %.2g, %d x %d x %d, skew %.1f: %.4f of the beam's deflection\n", of.name,
              coefficient, along, across, across, skew, ratio);
  return ratio;
}

TEST(StaticSolids, CantileverBends) {
  const auto expect = [](const SolidCase& of, double coefficient, Index layers, double known) {
    const std::string mesh = layers == 1 ? ", 10 x 1 x 1: " : ", 20 x 2 x 2: ";
    test::verified("cantilever, " + std::string(of.name) + (coefficient == 1 ? " with QM 1" : "") + mesh +
                       "deflection over the beam's",
                   "earlier result of this code; the beam's is 1")
        .near(cantilever(of, coefficient, 10 * layers, layers), known, known > 5 ? 0.01 : 0.001);
  };
  // One layer: assumed strains are made for it; the others have their hourglass stiffness alone, or shear in
  // the place of bending.
  expect(form_6, 1, 1, 0.989);
  EXPECT_NEAR(cantilever(form_6, 1, 10, 1, 0.5), 0.799, 0.001);
  expect(form_6, 0.1, 1, 9.83);
  expect(form_5, 0.1, 1, 1.641);
  expect(selective, 0, 1, 1.197);
  EXPECT_NEAR(cantilever(selective, 0, 5, 1), 0.500, 0.001);
  expect(form_6, 1, 2, 0.987);
  expect(form_6, 0.1, 2, 1.279);
  expect(form_4, 0.1, 2, 1.084);
  expect(form_5, 0.1, 2, 1.084);
  expect(selective, 0, 2, 0.976);
  expect(tetrahedron, 0, 2, 0.504);
  expect(nodal_pressure, 0, 2, 0.665);
}

/// Deflection of the end of a thin strip of length 50, width 1 and height 1, over that of beam theory: ten
/// elements along it, ten times as long as they are high with two layers.
double thin_cantilever(const SolidCase& of, Index layers, double skew = 0) {
  constexpr double length = 50;
  model::Model model = solid_model(of, elastic());
  model.control.bulk_linear = model.control.bulk_quadratic = 0;
  test::add_box(model, 0, 10, 1, layers, [&](double u, double v, double w) {
    const bool end = u == 0 || u == 1;
    return test::Point{length * u + (end ? 0 : skew * (v - 0.5 + (w - 0.5))), v, w};
  });
  hold_rotations(model);
  const double share = 1.0 / static_cast<double>(layers);
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const auto& x = model.nodes.position[node];
    // The clamp lets the section contract: the beam's theory knows no clamp that does not.
    if (x[0] == 0) model.fixed_nodes.push_back({.node = node, .translation = {true, x[1] == 0, x[2] == 0}});
    if (x[0] != length) continue;
    const double force = 0.5 * share * (x[2] == 0 || x[2] == 1 ? 0.5 : 1);
    model.nodal_loads.push_back({.node = node, .force = {0, 0, force}});
  }
  const std::vector<double> u = static_solution(model, 1e-7);
  double work = 0;
  for (const model::NodalLoad& load : model.nodal_loads)
    work += load.force[2] * u[6 * static_cast<std::size_t>(load.node) + 2];
  const double ratio = work / (length * length * length * 12 / (3 * youngs_modulus));
  std::printf("thin cantilever, %s, %d layers, skew %.1f: %.4f of the beam's deflection\n", of.name, layers,
              skew, ratio);
  return ratio;
}

/// Elements ten times as long as high: the shear of bending locks ELFORM 2.
TEST(StaticSolids, ThinCantileverOfLongElementsBendsByAssumedStrainsOnly) {
  const auto expect = [](const SolidCase& of, Index layers, double known) {
    test::verified("thin cantilever of 10 x 1 x " + std::to_string(layers) + ", " + of.name +
                       ": deflection over the beam's",
                   "earlier result of this code; the beam's is 1")
        .near(thin_cantilever(of, layers), known, 0.002);
  };
  expect(selective, 1, 0.0994);
  expect(selective, 2, 0.0949);
  expect(selective, 4, 0.0942);
  // What bending adds to the volume goes into the thickness, of which one layer has no other share.
  expect(assumed, 1, 0.860);
  expect(assumed, 2, 0.9475);
  expect(assumed, 4, 0.982);
  EXPECT_NEAR(thin_cantilever(assumed, 2, 0.5), 0.7076, 0.001);
  EXPECT_NEAR(cantilever(assumed, 0, 10, 1), 0.852, 0.001);
  EXPECT_NEAR(cantilever(assumed, 0, 5, 1), 0.834, 0.001);
  EXPECT_NEAR(cantilever(assumed, 0, 20, 2), 0.938, 0.001);
}

/// Radial displacement of the inner face of a thick cylinder under inner pressure in plane strain, over the
/// exact one. R.H. MacNeal and R.L. Harder, A proposed standard set of problems to test finite element
/// accuracy, Finite Elements in Analysis and Design 1 (1985) 3-20: radii 3 and 9, five elements between, ten
/// degrees each.
double thick_cylinder(const SolidCase& of, double poisson, Index finer = 1) {
  constexpr double modulus = 1000;
  constexpr double inner = 3;
  constexpr double outer = 9;
  constexpr std::array<double, 6> radii{3, 3.5, 4.2, 5.2, 6.75, 9};
  model::Material material = elastic();
  material.law = model::Elastic{modulus, poisson};
  model::Model model = solid_model(of, material);
  model.control.bulk_linear = model.control.bulk_quadratic = 0;
  model.control.hourglass.coefficient = 0.1;
  const Index radial = 5 * finer;
  const Index around = 9 * finer;
  test::add_box(model, 0, radial, around, 1, [&](double u, double v, double w) {
    const double place = 5 * u;
    const auto before = std::min<std::size_t>(4, static_cast<std::size_t>(place + 1e-9));
    const double r =
        radii[before] + (radii[before + 1] - radii[before]) * (place - static_cast<double>(before));
    const double angle = 1.57079632679489662 * v;
    return test::Point{v == 1 ? 0 : r * std::cos(angle), r * std::sin(angle), w / static_cast<double>(finer)};
  });
  split_for(of, model);
  hold_rotations(model);
  const double half = 0.5 * 1.57079632679489662 / static_cast<double>(around);
  const double facet = 2 * inner * std::sin(half) / static_cast<double>(finer);  // area
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const auto& x = model.nodes.position[node];
    model.fixed_nodes.push_back({.node = node, .translation = {x[0] == 0, x[1] == 0, true}});
    if (std::hypot(x[0], x[1]) > inner + 1e-6) continue;
    // A quarter of each of two facets, or of the one that symmetry leaves.
    const double angle = std::atan2(x[1], x[0]);
    std::array<double, 3> force{};
    for (const double side : {-half, half}) {
      if (angle + side < 0 || angle + side > 1.57079632679489662) continue;
      force[0] += 0.25 * facet * std::cos(angle + side);
      force[1] += 0.25 * facet * std::sin(angle + side);
    }
    model.nodal_loads.push_back({.node = node, .force = force});
  }
  const std::vector<double> u = static_solution(model, 1e-7);
  double mean = 0;
  for (const model::NodalLoad& load : model.nodal_loads) {
    const auto& x = model.nodes.position[static_cast<std::size_t>(load.node)];
    const std::size_t at = 6 * static_cast<std::size_t>(load.node);
    mean += (u[at] * x[0] + u[at + 1] * x[1]) / inner / static_cast<double>(model.nodal_loads.size());
  }
  const double exact = (1 + poisson) * inner * inner / (modulus * (outer * outer - inner * inner)) *
                       (outer * outer / inner + (1 - 2 * poisson) * inner);
  std::printf("thick cylinder, %s, nu %.4f, %d x %d: %.4f of the exact displacement\n", of.name, poisson,
              radial, around, mean / exact);
  return mean / exact;
}

/// Constant stress in tetrahedra locks, and a finer mesh does not help. So does the hourglass stiffness of
/// forms 4 and 5, which goes with lambda + 2 mu.
TEST(StaticSolids, ThickCylinderThatHardlyChangesItsVolume) {
  for (const SolidCase& of : {form_5, form_6, selective, assumed, tetrahedron, nodal_pressure}) {
    const auto cylinder = [&](const char* nu) {
      return test::verified(
          std::string("thick cylinder 5 x 9, ") + of.name + ", nu " + nu + ": displacement over exact",
          "MacNeal and Harder 1985");
    };
    cylinder("0.3").near(thick_cylinder(of, 0.3), 1, 0.04);
    const double nearly = thick_cylinder(of, 0.4999);
    if (of.formulation == model::SolidFormulation::Tetrahedron) {
      EXPECT_LT(nearly, 0.65);
      EXPECT_LT(thick_cylinder(of, 0.4999, 2), 0.65);
    } else if (of.form == model::SolidHourglassForm::ExactVolumeStiffness) {
      EXPECT_LT(nearly, 0.2);
    } else {
      cylinder("0.4999").near(nearly, 1, 0.05);
    }
  }
  EXPECT_NEAR(thick_cylinder(nodal_pressure, 0.4999, 2), 1, 0.01);
}

}  // namespace
}  // namespace crumple::elements::testing::static_solids_test
