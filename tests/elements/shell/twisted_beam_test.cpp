// SPDX-License-Identifier: BSD-3-Clause
// The twisted cantilever of R.H. MacNeal & R.L. Harder (Finite Elements in Analysis and Design 1 (1985)
// 3-20), solved with the stiffness of the elements as they are: the same beam under slow loading is in
// tests/verification. Thin: T. Belytschko, B.K. Wong & H. Stolarski (IJNME 28 (1989) 385-414).
#include <gtest/gtest.h>

#include <numbers>

#include "elements/shell_harness.hpp"
#include "support/verified.hpp"

namespace crumple::elements::testing::twisted_beam_test {
namespace {

constexpr double length = 12;
constexpr double width = 1.1;

/// Clamped at x = 0; the cross section turns by 90 degrees over the length, from z at the root to y.
model::Model twisted_beam(const Kind& kind, double t, Index columns, Index rows, double hourglass) {
  model::Model model =
      test::one_part({.id = 1, .title = "beam", .density = 1, .law = model::Elastic{29e6, 0.22}},
                     test::shell_section(t, 2, kind.formulation));
  model.control.hourglass = {model::HourglassForm::Stiffness, hourglass, hourglass, hourglass};
  test::add_grid(model, 0, columns, rows, [](double u, double v) {
    const double turn = 0.5 * std::numbers::pi * u;
    const double across = width * (v - 0.5);
    return test::Point{length * u, across * std::sin(turn), across * std::cos(turn)};
  });
  return model;
}

/// Forces and moments on the nodes, with the sign of internal ones, after one degree of freedom has moved.
std::vector<double> forces_after(const model::Model& model, Index degree, double size) {
  Driven body(model, {Precision::Double, available_isas().back(), 1});
  const domain::NodeFields& nodes = body.domain.nodes;
  std::vector<Vec3> u(nodes.count());
  std::vector<Vec3> r(nodes.count());
  (degree % 6 < 3 ? u : r)[nodes.domain_node[degree / 6]][degree % 3] = size;
  body.step(1, u, r);
  std::vector<double> forces;
  for (Index i = 0; i < nodes.count(); ++i)
    for (int axis = 0; axis < 6; ++axis) {
      const Index node = nodes.domain_node[i];
      forces.push_back(-(axis < 3 ? body.force(node)[axis] : body.moment(node)[axis - 3]));
    }
  return forces;
}

/// Column of the stiffness matrix, from motion to both sides: what is quadratic in the motion cancels, which
/// in a thin shell is not small against the bending.
std::vector<double> column(const model::Model& model, Index degree) {
  constexpr double size = 1e-6;
  std::vector<double> forces = forces_after(model, degree, size);
  const std::vector<double> back = forces_after(model, degree, -size);
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = (forces[i] - back[i]) / (2 * size);
  return forces;
}

/// Displacement where the unit load of the last entry acts; symmetric matrix, Cholesky's factors.
double compliance(std::vector<std::vector<double>> k, const std::vector<double>& load) {
  const std::size_t n = k.size();
  std::vector<double> y(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = k[i][j];
      for (std::size_t m = 0; m < j; ++m) sum -= k[i][m] * k[j][m];
      k[i][j] = i == j ? std::sqrt(sum) : sum / k[j][j];
    }
    double sum = load[i];
    for (std::size_t m = 0; m < i; ++m) sum -= k[i][m] * y[m];
    y[i] = sum / k[i][i];
  }
  // load . K^-1 load = |L^-1 load|^2
  double work = 0;
  for (const double value : y) work += value * value;
  return work;
}

struct Tip {
  double in_plane, out_of_plane;  ///< displacement in the direction of the unit load
};

/// The tip's cross section lies along y: the load along y is in its plane, that along z out of it.
/// The control of the beam as long as B.B was summed over four nodes with 0.1: a control half as strong
/// leaves the coarse mesh of thick shells 3.5 % too soft.
Tip tip_displacement(const Kind& kind, double t, Index columns, Index rows, double hourglass = 0.2) {
  const model::Model model = twisted_beam(kind, t, columns, rows, hourglass);
  std::vector<Index> free;
  for (Index node = 0; node < model.nodes.count(); ++node)
    for (Index axis = 0; axis < 6; ++axis)
      if (node % (columns + 1) != 0) free.push_back(6 * node + axis);
  std::vector<std::vector<double>> k(free.size(), std::vector<double>(free.size()));
  for (std::size_t j = 0; j < free.size(); ++j) {
    const std::vector<double> forces = column(model, free[j]);
    for (std::size_t i = 0; i < free.size(); ++i) {
      k[i][j] += 0.5 * forces[static_cast<std::size_t>(free[i])];
      k[j][i] += 0.5 * forces[static_cast<std::size_t>(free[i])];
    }
  }
  // Rotations about the normal have little or no stiffness; this much is too little to be felt.
  const double plate = 29e6 * t * t * t / 12;
  for (std::size_t i = 0; i < free.size(); ++i) k[i][i] += free[i] % 6 < 3 ? 0 : 1e-9 * plate;
  const auto loaded = [&](Index axis) {
    std::vector<double> load(free.size());
    for (Index row = 0; row <= rows; ++row) {
      const Index degree = 6 * (row * (columns + 1) + columns) + axis;
      const auto at = std::find(free.begin(), free.end(), degree) - free.begin();
      load[static_cast<std::size_t>(at)] = (row == 0 || row == rows ? 0.5 : 1.0) / static_cast<double>(rows);
    }
    return load;
  };
  return {compliance(k, loaded(1)), compliance(k, loaded(2))};
}

struct Beam {
  double thickness;
  Tip reference;  ///< per unit load
};
constexpr Beam thick{0.32, {0.005424, 0.001754}};
constexpr Beam thin{0.0032, {5256, 1294}};

/// Over the reference.
Tip ratio(const Kind& kind, const Beam& beam, Index columns, Index rows) {
  const Tip tip = tip_displacement(kind, beam.thickness, columns, rows);
  const Tip over{tip.in_plane / beam.reference.in_plane, tip.out_of_plane / beam.reference.out_of_plane};
  std::printf("%s, thickness %.4f, %d x %d: over the reference, in plane %.3f, out of plane %.3f\n",
              kind.name, beam.thickness, columns, rows, over.in_plane, over.out_of_plane);
  return over;
}

void expect_tip(const Kind& kind, const Beam& beam, const std::string& mesh, const Tip& over,
                double allowed) {
  const bool is_thick = beam.thickness == thick.thickness;
  const std::string what =
      "twisted beam, static, " + std::string(is_thick ? "t 0.32, " : "t 0.0032, ") + mesh + ", " + kind.name;
  const char* const source = is_thick ? "MacNeal and Harder 1985" : "Belytschko, Wong and Stolarski 1989";
  test::verified(what + ": tip in the plane over accepted", source).near(over.in_plane, 1, allowed);
  test::verified(what + ": tip out of the plane over accepted", source).near(over.out_of_plane, 1, allowed);
}

TEST(TwistedBeam, IsThatOfMacNealAndHarderWithTheWarp) {
  for (const Kind& kind : {belytschko_wong_chiang, hughes_liu, fully_integrated})
    for (const Beam& beam : {thick, thin}) {
      const Tip coarse = ratio(kind, beam, 12, 2);
      expect_tip(kind, beam, "12 x 2", coarse, 0.03);
      const Tip fine = ratio(kind, beam, 24, 4);
      expect_tip(kind, beam, "24 x 4", fine, 0.01);
    }
}

/// One point for the shear of an element that bends in full is stiffer, and slower to converge.
TEST(TwistedBeam, IsNearlyThatWithSelectiveReduction) {
  for (const Beam& beam : {thick, thin}) {
    const Tip coarse = ratio(hughes_liu_selective, beam, 12, 2);
    expect_tip(hughes_liu_selective, beam, "12 x 2", coarse, 0.1);
    const Tip fine = ratio(hughes_liu_selective, beam, 24, 4);
    expect_tip(hughes_liu_selective, beam, "24 x 4", fine, 0.05);
  }
}

/// Flat elements that are warped find motions with hardly any strain: the beam all but falls apart.
TEST(TwistedBeam, IsFarTooSoftForFlatElements) {
  EXPECT_GT(ratio(belytschko_tsay, thick, 12, 2).in_plane, 100);
  EXPECT_GT(ratio(belytschko_tsay, thick, 24, 4).in_plane, 50);
  EXPECT_GT(ratio(belytschko_tsay, thin, 12, 2).in_plane, 5);
}

}  // namespace
}  // namespace crumple::elements::testing::twisted_beam_test
