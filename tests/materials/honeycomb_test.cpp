// SPDX-License-Identifier: BSD-3-Clause
// Honeycomb along given paths.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/error.hpp"
#include "materials/honeycomb_samples.hpp"
#include "support/drawn.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::honeycomb_test {
namespace {

using namespace honeycomb_support;

class Comb : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, Comb, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

TEST_P(Comb, CrushAlongEachAxisFollowsItsCurveAndLoadsNoOther) {
  test::Largest off("honeycomb crushed along a, b and c to 0.62: stress off the given curve [MPa]",
                    "given curve", 1e-11);
  test::Largest others("honeycomb crushed along a, b and c: other stresses [MPa]", "none", 1e-11);
  test::Points exact;
  test::Points found;
  for (int axis = 0; axis < 3; ++axis) {
    MotionDriver<double> point(honeycomb(), GetParam());
    for (int i = 1; i <= 124; ++i) {
      const double crush = 0.005 * i;
      point.move_to(along(axis, 1 - crush));
      if (i < 20) continue;  // elastic still
      const Six s = local(point.stress());
      off.compare(s[axis], -yield_at(axis, crush));
      for (int c = 0; c < 6; ++c)
        if (c != axis) others.add(std::fabs(s[c]));
      if (axis == 0) exact.push_back({crush, yield_at(axis, crush)});
      if (axis == 0 && i % 4 == 0) found.push_back({crush, -s[axis]});
    }
  }
  if (GetParam() == Isa::Scalar)
    test::drawn("Honeycomb crushed along its axis a", "1 - V", "stress [MPa]")
        .accepted("given curve", exact)
        .found("one point of material", found)
        .note();
}

TEST_P(Comb, ShearIsElasticToItsOwnBound) {
  test::Largest off("honeycomb, pure shear ab, bc and ca, there and back: stress, error [MPa]",
                    "elastic to the bound at the present volume", 2e-6);
  for (int c = 3; c < 6; ++c)
    for (const double volume : {1.0, 0.7}) {
      // Squeezed first by the whole of its volume, then sheared at that volume.
      MotionDriver<double> point(honeycomb(), GetParam());
      const double side = std::cbrt(volume);
      if (volume < 1) point.move_in_steps(stretch({side, side, side}), 50);
      const double share = (1 - volume) / (1 - compacted);
      const double shear = moduli[c] + share * (full_shear - moduli[c]);
      const double bound = yield_at(c, 1 - volume);
      double expected = 0;
      double before = 0;
      const double last = 3 * bound / shear;
      for (int i = 1; i <= 400; ++i) {
        const double gamma = last * (i <= 200 ? i / 200.0 : 2 - i / 200.0);
        Matrix f = sheared(c, gamma);
        for (auto& row : f)
          for (double& value : row) value *= side;
        point.move_to(global(f));
        expected = std::clamp(expected + shear * (gamma - before), -bound, bound);
        before = gamma;
        const Six s = local(point.stress());
        off.compare(s[c], expected);
      }
    }
}

/// sigma = integral of E_u + (E - E_u) (1 - l) / (1 - V_f) over ln l, l the stretch along one axis.
TEST_P(Comb, StiffensLinearlyWithTheVolume) {
  for (int axis = 0; axis < 3; ++axis) {
    double error[2];
    for (const int fine : {0, 1}) {
      MotionDriver<double> point(changed(no_yield), GetParam());
      const int steps = fine == 0 ? 100 : 200;
      for (int i = 1; i <= steps; ++i) point.move_to(along(axis, 1 - 0.6 * i / steps));
      const double growth = (modulus - moduli[axis]) / (1 - compacted);
      const double expected = (moduli[axis] + growth) * std::log(0.4) + growth * 0.6;
      error[fine] = local(point.stress())[axis] / expected - 1;
    }
    test::verified("honeycomb without yield, squeezed to 0.4 along axis " + std::to_string(axis) +
                       ": relative error of 100 steps over that of 200",
                   "second order")
        .near(error[0] / error[1], 4, 0.05);
    test::verified("honeycomb without yield, squeezed to 0.4: stress of 200 steps, relative error",
                   "closed form")
        .below(std::fabs(error[1]), 2e-5);
  }
}

/// Behind V_f the pressure grows with the bulk modulus, the deviator is at its yield stress.
TEST_P(Comb, CompactedItIsElasticAndPerfectlyPlastic) {
  MotionDriver<double> point(honeycomb(), GetParam());
  test::Largest pressures(
      "honeycomb crushed along a to 0.25: growth of the pressure behind V_f, relative error", "K ln(V / V')",
      1e-5);
  test::Largest sizes("honeycomb crushed along a to 0.25: von Mises stress over SIGY, error", "1", 1e-12);
  double start_pressure = 0;
  double start_volume = 0;
  for (int i = 1; i <= 1500; ++i) {
    const double volume = 1 - 0.0005 * i;
    point.move_to(along(0, volume));
    if (volume > compacted) {
      // Before, the stresses across are zero.
      EXPECT_NEAR(point.pressure(), i < 20 ? point.pressure() : yield_at(0, 1 - volume) / 3, 1e-9);
      continue;
    }
    if (start_volume > 0)
      pressures.compare((point.pressure() - start_pressure) / (bulk * std::log(start_volume / volume)), 1);
    else
      start_pressure = point.pressure(), start_volume = volume;
    if (volume < compacted - 0.01) sizes.compare(equivalent(point.stress()) / solid_yield, 1);
  }
  // The first step behind V_f goes on from there.
  const double growth = bulk * std::log((start_volume + 0.0005) / start_volume);
  EXPECT_NEAR((start_pressure - yield_at(0, 1 - (start_volume + 0.0005)) / 3) / growth, 1, 1e-5);
  // Unloading is elastic.
  const Six loaded = local(point.stress());
  point.move_to(along(0, 0.25 * 1.0005));
  const double lame = bulk - 2.0 / 3 * full_shear;
  const Six unloaded = local(point.stress());
  const double strain = 0.0005 / 1.00025;
  EXPECT_NEAR((unloaded[0] - loaded[0]) / ((lame + 2 * full_shear) * strain), 1, 1e-10);
  EXPECT_NEAR((unloaded[1] - loaded[1]) / (lame * strain), 1, 1e-10);
}

TEST_P(Comb, UnloadsAndPullsElastically) {
  MotionDriver<double> point(honeycomb(), GetParam());
  point.move_in_steps(along(1, 0.8), 400);
  const double share = 0.2 / (1 - compacted);
  const double stiffness = moduli[1] + share * (modulus - moduli[1]);
  EXPECT_NEAR(local(point.stress())[1], -yield_at(1, 0.2), 1e-11);
  // By half of what there is.
  const double strain = 0.5 * yield_at(1, 0.2) / stiffness;
  point.move_to(along(1, 0.8 * (1 + strain)));
  test::verified("honeycomb, unloaded by half: stress over the yield stress, error",
                 "elastic, interpolated E")
      .below(std::fabs(local(point.stress())[1] / -yield_at(1, 0.2) - 0.5), 2e-4);
  // Far in tension the curve is continued.
  point.move_in_steps(along(1, 1.2), 400);
  EXPECT_NEAR(local(point.stress())[1], yield_at(1, -0.2), 1e-11);
}

TEST_P(Comb, WorkIsTheAreaBelowTheCurve) {
  // Of the elastic stress, the integral of E_c(V) over ln V, or the bound, whichever is less.
  double area = 0;
  const double growth = (modulus - moduli[2]) / (1 - compacted);
  constexpr int pieces = 200000;
  for (int i = 0; i < pieces; ++i) {
    const double crush = 0.6 * (i + 0.5) / pieces;
    const double elastic = -(moduli[2] + growth) * std::log1p(-crush) - growth * crush;
    area += std::min(elastic, yield_at(2, crush)) * 0.6 / pieces;
  }
  double error[2];
  for (const int fine : {0, 1}) {
    MotionDriver<double> point(honeycomb(), GetParam());
    point.move_in_steps(along(2, 0.4), fine == 0 ? 1000 : 2000);
    error[fine] = std::fabs(point.work() / area - 1);
  }
  test::verified("honeycomb crushed along c to 0.4: work, relative error",
                 "area below elastic line and curve")
      .below(error[1], 2e-5);
  EXPECT_LT(error[1], error[0]);
}

TEST_P(Comb, AxesTurnWithTheBody) {
  const std::array<double, 3> axis{0.6, 0, 0.8};
  MotionDriver<double> rest(honeycomb(), GetParam());
  MotionDriver<double> turned_point(honeycomb(), GetParam());
  const Matrix crushed = times(along(0, 0.8), along(2, 0.9));
  rest.move_in_steps(crushed, 100);
  turned_point.move_in_steps(crushed, 100);
  // Ten turns and a bit.
  Matrix q = unit;
  for (int i = 1; i <= 700; ++i) {
    q = rotation(axis, 0.1 * i);
    turned_point.move_to(times(q, crushed));
  }
  const auto carried = [&](const Six& s) { return six_of(times(q, times(matrix_of(s), transposed(q)))); };
  test::verified("honeycomb, crushed, then turned by 70 rad: stress, error [MPa]", "turned stress")
      .below(largest_difference(turned_point.stress(), carried(rest.stress())), 1e-10);
  // What follows is along the turned axes.
  for (int i = 1; i <= 100; ++i) {
    const Matrix more = times(along(1, 1 - 0.003 * i), crushed);
    rest.move_to(more);
    turned_point.move_to(times(q, more));
  }
  test::verified("honeycomb, crushed on after 70 rad: stress, error [MPa]", "the same at rest, turned")
      .below(largest_difference(turned_point.stress(), carried(rest.stress())), 1e-10);
}

TEST_P(Comb, YieldGrowsWithTheRate) {
  auto material = honeycomb();
  auto& law = std::get<model::Honeycomb>(material.law);
  law.rates = {{10, 100, 1000}, {1, 1.5, 2.5}};
  test::Largest off("honeycomb crushed at 1 to 5000 / s: stress over the curve, error", "given factors",
                    1e-11);
  for (const double rate : {1.0, 10.0, 55.0, 550.0, 5000.0}) {
    MotionDriver<double> point(material, GetParam());
    for (int i = 1; i <= 100; ++i) {
      const double before = std::pow(0.5, (i - 1) / 100.0);
      const double side = std::pow(0.5, i / 100.0);
      // Norm of the deviator of a strain along one axis: sqrt(2/3) of it.
      const double increment = 2 * (before - side) / (before + side) * std::sqrt(2.0 / 3);
      point.move_to(along(0, side), increment / rate);
      const double factor = rate <= 10    ? 1
                            : rate < 100  ? 1 + (rate - 10) / 180
                            : rate < 1000 ? 1.5 + (rate - 100) / 900
                                          : 2.5;
      if (i > 30) off.compare(local(point.stress())[0] / -yield_at(0, 1 - side), factor);
    }
  }
}

TEST_P(Comb, FailsByTensionAndByShear) {
  const auto failing = changed([](model::Honeycomb& law) {
    law.failure_tension = 0.2;
    law.failure_shear = 0.3;
  });
  for (int axis = 0; axis < 3; ++axis)
    for (const bool tension : {true, false}) {
      MotionDriver<double> point(failing, GetParam());
      for (int i = 1; i <= 60; ++i) {
        const double log = 0.005 * i * (tension ? 1 : -1);
        point.move_to(along(axis, std::exp(log)));
        EXPECT_EQ(point.intact(), log < 0.2005) << log;
        if (log > 0.2005) {
          EXPECT_EQ(point.stress(), Six{});
        }
      }
    }
  for (int c = 3; c < 6; ++c)
    for (const double sign : {1.0, -1.0}) {
      MotionDriver<double> point(failing, GetParam());
      for (int i = 1; i <= 60; ++i) {
        const double gamma = 0.0071 * i;
        point.move_to(global(sheared(c, sign * gamma)));
        EXPECT_EQ(point.intact(), gamma < 0.3) << gamma;
      }
    }
}

/// The same tilted axes by nodes, by a point and by vectors.
TEST(CombAxes, FollowNodesAPointOrVectors) {
  const auto axes = [](model::Honeycomb::Axes kind, const std::array<double, 3>& a,
                       const SolidCorners& corners) {
    auto material = honeycomb();
    auto& law = std::get<model::Honeycomb>(material.law);
    law.axes = kind;
    law.a = a;
    const MotionDriver<double> point(material, Isa::Scalar, nullptr, corners);
    std::array<double, 6> found{};
    for (int k = 0; k < 6; ++k) found[k] = point.item("material_axes", 0, k);
    return found;
  };
  const auto expect = [](const std::array<double, 6>& found, const std::array<double, 6>& accepted) {
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(found[k], accepted[k], 1e-15) << k;
  };
  SolidCorners skew = unit_corners();
  for (math::Vec3& corner : skew) corner = {corner.x + 0.5 * corner.y, 2 * corner.z, -corner.y};
  // Node 2 is along x from node 1; node 4 at (0.5, 0, -1).
  expect(axes(model::Honeycomb::Axes::Nodes, {}, skew), {1, 0, 0, 0, 0, -1});
  // The middle is at (0.75, 1, -0.5): from (0.75, -1, -0.5) a is y; c = a x z is x, b = c x a is z.
  expect(axes(model::Honeycomb::Axes::Point, {0.75, -1, -0.5}, skew), {0, 1, 0, 0, 0, 1});
  std::array<double, 6> tilted{};
  for (int k = 0; k < 3; ++k) {
    tilted[k] = tilt[k][0];
    tilted[3 + k] = tilt[k][1];
  }
  const auto law = std::get<model::Honeycomb>(honeycomb().law);
  expect(axes(model::Honeycomb::Axes::Vectors, law.a, skew), tilted);
  EXPECT_THROW(axes(model::Honeycomb::Axes::Point, {0.75, 1, 7}, skew), Error);
}

/// Squeezed to a volume and released a little, so that nothing yields: in random directions of motion and of
/// propagation, by differences.
TEST_P(Comb, WaveSpeedBoundsTheTangent) {
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto direction = [&] {
    std::array<double, 3> n{uniform(generator), uniform(generator), uniform(generator)};
    const double length = std::hypot(n[0], n[1], n[2]);
    for (double& component : n) component /= length;
    return n;
  };
  for (const double volume : {1.0, 0.8, 0.5, 0.31, 0.295}) {
    const double side = std::cbrt(volume);
    const double released = volume < 1 ? side * (1 + 1.5e-5) : 1;
    const auto squeezed = [&] {
      MotionDriver<double> point(honeycomb(), GetParam());
      point.move_in_steps(stretch({side, side, side}), 100);
      point.move_to(stretch({released, released, released}));
      return point;
    };
    const MotionDriver<double> point = squeezed();
    const double speed = point.wave_speed();
    double largest = 0;
    for (int i = 0; i < 200; ++i) {
      const auto n = direction();
      const auto u = i % 2 == 0 ? direction() : n;
      constexpr double h = 1e-8;
      Matrix more = stretch({released, released, released});
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) more[r][c] += h * released * u[r] * n[c];
      MotionDriver<double> moved = squeezed();
      moved.move_to(more);
      const Matrix now = matrix_of(moved.stress());
      const Matrix then = matrix_of(point.stress());
      double slope = 0;
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) slope += u[r] * (now[r][c] - then[r][c]) * n[c] / h;
      largest = std::max(largest, slope);
    }
    const double bound = 8e-11 / (released * released * released) * speed * speed;
    EXPECT_GT(bound, 0.99 * largest) << volume;
    EXPECT_LT(bound, 3 * largest) << volume;
  }
}

TEST_P(Comb, FloatAgreesWithDouble) {
  MotionDriver<float> coarse(honeycomb(), GetParam());
  MotionDriver<double> exact(honeycomb(), GetParam());
  for (int i = 1; i <= 20000; ++i) {
    const Matrix f{{{1 - 2e-5 * i, 1e-5 * i, 0}, {-2e-5 * i, 1 + 2e-6 * i, 0}, {1e-5 * i, 0, 1}}};
    coarse.move_to(f);
    exact.move_to(f);
  }
  test::verified("honeycomb, 20000 steps in single precision: stress, error [MPa]", "double precision")
      .below(largest_difference(coarse.stress(), exact.stress()), 5e-4);
  EXPECT_NEAR(coarse.item("volume_change"), exact.item("volume_change"), 1e-6);
}

TEST(CombConstants, AreChecked) {
  EXPECT_NO_THROW(solid_material_constants(honeycomb()));
  const auto refuses = [](void (*change)(model::Honeycomb&)) {
    EXPECT_THROW(solid_material_constants(changed(change)), Error);
  };
  refuses([](model::Honeycomb& law) { law.compacted_volume = 1; });
  refuses([](model::Honeycomb& law) { law.moduli[4] = 0; });
  refuses([](model::Honeycomb& law) { law.yield_stress = 0; });
  refuses([](model::Honeycomb& law) { law.crush[2].stress[1] = -1; });
  refuses([](model::Honeycomb& law) { law.crush[2].crush[1] = 0; });
  refuses([](model::Honeycomb& law) { law.crush[5] = {}; });
  refuses([](model::Honeycomb& law) { law.rates = {{1, 2}, {1, 0}}; });
}

}  // namespace
}  // namespace crumple::materials::testing::honeycomb_test
