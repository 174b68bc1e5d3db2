// SPDX-License-Identifier: BSD-3-Clause
// Layers that fail by modes: strengths, off-axis curves, energy, strains of failure.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "base/error.hpp"
#include "materials/laws/composite_damage.hpp"
#include "materials/point_driver.hpp"
#include "support/alike.hpp"
#include "support/largest.hpp"
#include "support/verified.hpp"

namespace crumple::materials::testing::composite_damage_test {
namespace {

using Law = model::CompositeDamage;

/// Carbon fibre in epoxy, MPa. The strengths are of the order of those of T800/3900-2.
Law carbon() {
  Law law;
  law.modulus_a = 127000;
  law.modulus_b = law.modulus_c = 8400;
  law.poisson_ba = 0.02049;
  law.shear_ab = law.shear_ca = 4200;
  law.shear_bc = 3000;
  law.tension_a = 2200;
  law.compression_a = 1470;
  law.tension_b = 49;
  law.compression_b = 199;
  law.shear_strength = 154;
  set_stand_in(law);
  return law;
}
model::Material material_of(const Law& law) {
  model::Material material;
  material.id = 5;
  material.density = 1.5e-9;
  material.law = law;
  return material;
}
LaminaAxes axes_at(double angle) {
  LaminaAxes axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  axes.layer_angle = angle;
  return axes;
}

/// One point with its fibres at an angle.
template <class Real = double>
PointDriver<Real> point_of(const Law& law, double angle = 0, Isa isa = Isa::Scalar, int points = 1) {
  PointDriver<Real> point(material_of(law), isa, points);
  point.prepare(law, axes_at(angle));
  return point;
}

/// Strain increment along which the stress in the plane grows as `stress`, elastically.
Five strain_for(const Law& m, const std::array<double, 3>& stress, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double a = c * c * stress[0] + s * s * stress[1] + 2 * c * s * stress[2];
  const double b = s * s * stress[0] + c * c * stress[1] - 2 * c * s * stress[2];
  const double t = c * s * (stress[1] - stress[0]) + (c * c - s * s) * stress[2];
  const double ea = a / m.modulus_a - m.poisson_ba / m.modulus_b * b;
  const double eb = b / m.modulus_b - m.poisson_ba / m.modulus_b * a;
  const double g = t / m.shear_ab;
  return {c * c * ea + s * s * eb - c * s * g, s * s * ea + c * c * eb + c * s * g,
          2 * c * s * (ea - eb) + (c * c - s * s) * g, 0, 0};
}

Law without_limits() {
  Law law = carbon();
  law.failure_effective = 10;  // never reached
  return law;
}

/// In 400 steps along a ray of stress to 1.5 times the expected strength the stress follows the ray up to it
/// and stays there.
TEST(CompositeDamage, StrengthOfEachModeIsReachedAndKept) {
  const Law law = without_limits();
  struct Mode {
    const char* name;
    std::array<double, 3> strength;
    int which;
  };
  const Mode modes[] = {{"fibres in tension", {2200, 0, 0}, 0},
                        {"fibres in compression", {-1470, 0, 0}, 1},
                        {"matrix in tension", {0, 49, 0}, 2},
                        {"matrix in compression", {0, -199, 0}, 3},
                        {"shear", {0, 0, 154}, 2}};
  for (const Mode& mode : modes) {
    auto point = point_of(law);
    const std::array<double, 3>& s = mode.strength;
    const Five step = strain_for(law, {s[0] / 200, s[1] / 200, s[2] / 200}, 0);
    for (int i = 0; i < 199; ++i) point.apply(step);
    for (int k = 0; k < 5; ++k) EXPECT_EQ(point.item("failed_modes", 0, k), 0) << mode.name;
    for (int i = 0; i < 101; ++i) point.apply(step);
    const std::size_t component = s[0] != 0 ? 0 : s[1] != 0 ? 1 : 2;
    test::verified(std::string(mode.name) + ": stress at 1.5 times the strain of failure", "the strength")
        .within(point.stress()[component], s[component], 1e-12);
    EXPECT_EQ(point.item("failed_modes", 0, mode.which), 1) << mode.name;
    EXPECT_EQ(point.item("failed_modes", 0, composite_mode::gone), 0);
  }
}

/// Value of the criterion of the matrix or of the fibres in tension, written again.
double criterion(const Law& m, double a, double b, double t) {
  const double shear = t * t / (m.shear_strength * m.shear_strength);
  const double fibres = a > 0 ? a * a / (m.tension_a * m.tension_a) + m.shear_in_fibre_mode * shear
                              : a * a / (m.compression_a * m.compression_a);
  const double twice = 2 * m.shear_strength;
  double matrix = b * b / (m.tension_b * m.tension_b) + shear;
  if (b < 0)
    matrix = b * b / (twice * twice) +
             (m.compression_b * m.compression_b / (twice * twice) - 1) * b / m.compression_b + shear;
  if (m.matrix == Law::Matrix::TsaiWu)
    matrix = b * b / (m.tension_b * m.compression_b) + shear +
             (m.compression_b - m.tension_b) * b / (m.tension_b * m.compression_b);
  return std::max(fibres, matrix);
}

/// Strength under tension or compression at an angle to the fibres, by bisection of the criterion.
double off_axis_strength(const Law& m, double angle, double sign) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  double low = 0;
  double high = 1e4;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    const double stress = sign * middle;
    (criterion(m, c * c * stress, s * s * stress, -c * s * stress) < 1 ? low : high) = middle;
  }
  return low;
}

/// The largest stress along x while the strain grows and the other stresses in the plane are zero: up to the
/// failure of the first mode the stress stays on its ray.
double computed_strength(const Law& law, double angle, double sign, double expected) {
  auto point = point_of(law, angle);
  constexpr int steps = 2000;
  const Five step = strain_for(law, {sign * expected / steps, 0, 0}, angle);
  for (int i = 0; i < 2 * steps; ++i) {
    point.apply(step);
    double failed = 0;
    for (int k = 0; k < 4; ++k) failed += point.item("failed_modes", 0, k);
    if (failed > 0) return sign * point.stress()[0];
  }
  return 0;
}

TEST(CompositeDamage, OffAxisStrengthFollowsTheCriterion) {
  for (const Law::Matrix matrix : {Law::Matrix::Chang, Law::Matrix::TsaiWu})
    for (const double sign : {1.0, -1.0}) {
      Law law = without_limits();
      law.matrix = matrix;
      law.shear_in_fibre_mode = 0.5;
      const std::string name = std::string(matrix == Law::Matrix::Chang ? "Chang-Chang" : "Tsai-Wu") +
                               (sign > 0 ? ", tension" : ", compression") + " at ";
      for (const int degrees : {0, 5, 10, 15, 20, 30, 45, 60, 75, 85, 90}) {
        const double angle = degrees * std::numbers::pi / 180;
        const double expected = off_axis_strength(law, angle, sign);
        test::verified(name + std::to_string(degrees) + " degrees: strength [MPa]", "the criterion")
            .within(computed_strength(law, angle, sign, expected), expected, 1e-3);
      }
    }
}

/// With BETA = 1 the fibres in tension obey Hashin's ellipse.
TEST(CompositeDamage, ShearInTheTensileModeOfTheFibres) {
  Law law = without_limits();
  law.shear_in_fibre_mode = 1;
  for (const double shear : {50.0, 100.0, 140.0}) {
    auto point = point_of(law);
    point.apply(strain_for(law, {0, 0, shear}, 0));
    for (int i = 0; i < 300; ++i) point.apply(strain_for(law, {10, 0, 0}, 0));
    EXPECT_NEAR(point.stress()[2], shear, 1e-9);
    test::verified("fibres in tension under the shear " + std::to_string(int(shear)) + " MPa: strength",
                   "Hashin 1980")
        .within(point.stress()[0], 2200 * std::sqrt(1 - shear * shear / (154.0 * 154.0)), 1e-9);
  }
}

/// gamma = tau / G + alpha tau^3 there and back, in steps of any size.
TEST(CompositeDamage, NonlinearShearIsElastic) {
  Law law = without_limits();
  law.shear_softening = 2e-8;
  const double linear = 1 / law.shear_ab;
  test::Largest off("shear of 25 to 150 MPa and back, stress over 150 MPa, error", "closed form", 1e-12);
  for (const double tau : {25.0, 100.0, 150.0, -150.0}) {
    const double gamma = tau * linear + law.shear_softening * tau * tau * tau;
    for (const int steps : {1, 10, 1000}) {
      auto point = point_of(law);
      for (int i = 0; i < steps; ++i) point.apply({0, 0, gamma / steps, 0, 0});
      off.compare(point.stress()[2], tau, 150);
      for (int i = 0; i < steps; ++i) point.apply({0, 0, -gamma / steps, 0, 0});
      off.compare(point.stress()[2], 0, 150);
    }
  }
}

/// *MAT_COMPOSITE_DAMAGE: the shear counts with its strain energy, tau^2/2G + 3/4 alpha tau^4.
TEST(CompositeDamage, ShearEnergyInTheCriterion) {
  Law law = without_limits();
  law.matrix = Law::Matrix::ChangShear;
  law.shear_softening = 2e-8;
  const auto energy = [&](double tau) {
    return 0.5 * tau * tau / law.shear_ab + 0.75 * law.shear_softening * tau * tau * tau * tau;
  };
  for (const double ratio : {0.0, 0.3, 1.0, 3.0}) {
    // A ray of stress from which the criterion is reached: shear = ratio * across.
    auto point = point_of(law);
    for (int i = 0; i < 4000; ++i) {
      const double now = point.stress()[2];
      const double slope = 1 / law.shear_ab + 3 * law.shear_softening * now * now;
      Five strain = strain_for(law, {0, 0.02, 0}, 0);
      strain[2] = 0.02 * ratio * slope;
      point.apply(strain);
    }
    const auto [xx, yy, xy, yz, zx] = point.stress();
    EXPECT_NEAR(xx + yz + zx, xx, 0);
    test::verified("tension across with the shear " + std::to_string(ratio) + " times as large: criterion",
                   "Chang & Chang 1987")
        .near(yy * yy / (49.0 * 49.0) + energy(xy) / energy(154), 1, 1e-10);
    EXPECT_EQ(point.item("failed_modes", 0, composite_mode::matrix_tension), 1);
  }
}

/// Where the matrix has been crushed the fibres are weaker: FBRT and YCFAC.
TEST(CompositeDamage, CrushedMatrixWeakensTheFibres) {
  Law law = without_limits();
  law.fibre_tension_left = 0.4;
  law.fibre_compression_by_matrix = 2;
  for (const double sign : {1.0, -1.0}) {
    auto point = point_of(law);
    for (int i = 0; i < 30; ++i) point.apply(strain_for(law, {0, -10, 0}, 0));
    EXPECT_EQ(point.item("failed_modes", 0, composite_mode::matrix_compression), 1);
    for (int i = 0; i < 300; ++i) point.apply(strain_for(law, {sign * 10, 0, 0}, 0));
    EXPECT_NEAR(point.stress()[0], sign > 0 ? 0.4 * 2200 : -2 * 199.0, 1e-9);
  }
}

/// Random paths that end where they began never give work, and only what failed has taken it.
TEST(CompositeDamage, ClosedPathsNeverGiveWork) {
  for (const Law::Matrix matrix : {Law::Matrix::Chang, Law::Matrix::TsaiWu, Law::Matrix::ChangShear}) {
    Law law = without_limits();
    law.matrix = matrix;
    law.shear_in_fibre_mode = 1;
    law.shear_softening = matrix == Law::Matrix::ChangShear ? 2e-8 : 0;
    for (int seed = 1; seed <= 10; ++seed) {
      auto point = point_of(law, 0.3);
      std::mt19937 generator(static_cast<unsigned>(seed));
      std::uniform_real_distribution<double> uniform(-0.02, 0.02);
      std::vector<Five> corners{{}};
      for (int i = 0; i < 6; ++i)
        corners.push_back({uniform(generator), uniform(generator), uniform(generator), 0, 0});
      corners.push_back({});
      double work = 0;
      for (std::size_t k = 1; k < corners.size(); ++k) {
        constexpr int steps = 1000;
        Five step{};
        for (std::size_t c = 0; c < 3; ++c) step[c] = (corners[k][c] - corners[k - 1][c]) / steps;
        for (int i = 0; i < steps; ++i) {
          point.apply(step);
          work += point.energy();
        }
      }
      // What is stored at the end is that of the stress that is left.
      EXPECT_GT(work, 0) << seed;
    }
  }
}

/// A point goes in the step in which a strain of failure is passed; the work of the step is half of the old
/// stress's.
TEST(CompositeDamage, StrainsOfFailure) {
  Law law = carbon();
  law.failure_tension = 0.025;
  law.failure_compression = -0.02;
  law.failure_matrix = 0.03;
  law.failure_shear = 0.035;
  struct Limit {
    Five step;
    int last;  ///< step in which the point is still there
  };
  for (const Limit& limit :
       {Limit{{1e-4, 0, 0, 0, 0}, 249}, Limit{{-1e-4, 0, 0, 0, 0}, 199}, Limit{{0, 1e-4, 0, 0, 0}, 299},
        Limit{{0, -1e-4, 0, 0, 0}, 299}, Limit{{0, 0, 2e-4, 0, 0}, 349}, Limit{{0, 0, -2e-4, 0, 0}, 349}}) {
    auto point = point_of(law);
    for (int i = 0; i < limit.last; ++i) point.apply(limit.step);
    EXPECT_EQ(point.item("failed_modes", 0, composite_mode::gone), 0) << limit.last;
    EXPECT_TRUE(point.intact());
    const Five before = point.stress();
    for (int i = 0; i < 2 && point.intact(); ++i) point.apply(limit.step);
    EXPECT_FALSE(point.intact()) << limit.last;
    double work = 0;
    for (std::size_t c = 0; c < components; ++c) {
      EXPECT_EQ(point.stress()[c], 0);
      work += 0.5 * before[c] * limit.step[c];
    }
    EXPECT_NEAR(point.energy(), work, 1e-3 * std::fabs(work));
  }
}

TEST(CompositeDamage, EffectiveStrainOfFailure) {
  Law law = carbon();
  law.failure_tension = 1;
  law.failure_effective = 0.01;
  // sqrt(4/3 (a^2 + a b + b^2 + shear^2)) of (3, -1, 2) k is k sqrt(44/3), the engineering shear being 4 k.
  const double k = 0.01 / std::sqrt(44.0 / 3);
  auto point = point_of(law);
  for (int i = 0; i < 100; ++i) point.apply({0.03 * 0.999 * k, -0.01 * 0.999 * k, 0.04 * 0.999 * k, 0, 0});
  EXPECT_TRUE(point.intact());
  point.apply({0.06 * k, -0.02 * k, 0.08 * k, 0, 0});
  EXPECT_FALSE(point.intact());
}

/// Without DFAILT a point goes with its fibres in tension.
TEST(CompositeDamage, GoesWithItsFibresInTension) {
  Law law = carbon();
  law.goes_by_fibre_tension = true;
  auto point = point_of(law);
  const Five step = strain_for(law, {22, 0, 0}, 0);
  for (int i = 0; i < 99; ++i) point.apply(step);
  EXPECT_TRUE(point.intact());
  for (int i = 0; i < 2; ++i) point.apply(step);
  EXPECT_FALSE(point.intact());
  EXPECT_EQ(point.stress()[0], 0);
  auto pressed = point_of(law);
  for (int i = 0; i < 200; ++i) pressed.apply(strain_for(law, {-22, 0, 0}, 0));
  EXPECT_TRUE(pressed.intact());
  EXPECT_NEAR(pressed.stress()[0], -1470, 1e-9);
}

/// Damage energy of a strip pulled along its fibres until it goes: the elastic part and the plateau, on which
/// it does not get narrower: the strain that is left over lies along the fibres.
TEST(CompositeDamage, EnergyUntilThePointGoes) {
  Law law = carbon();
  law.failure_tension = 0.03;
  auto point = point_of(law);
  const double first = 2200 / law.modulus_a;
  Five step = strain_for(law, {0.22, 0, 0}, 0);
  double work = 0;
  double largest = 0;
  while (point.item("failed_modes", 0, composite_mode::gone) == 0) {
    point.apply(step);
    work += point.energy();
    largest = std::max(largest, point.stress()[0]);
    if (point.item("failed_modes", 0, composite_mode::fibre_tension) != 0) step[1] = 0;
  }
  test::verified("carbon layer along its fibres until it goes at 3 %: work [MPa]", "X^2 / 2E + X (e - X / E)")
      .within(work, 0.5 * 2200 * first + 2200 * (0.03 - first), 2e-4);
  EXPECT_NEAR(largest, 2200, 1e-9);
}

template <class Real>
std::vector<std::vector<Real>> bits_of_all() {
  std::vector<std::vector<Real>> bits;
  Law law = carbon();
  law.failure_tension = 0.04;
  law.failure_shear = 0.1;
  law.shear_softening = 2e-8;
  law.matrix = Law::Matrix::ChangShear;
  law.shear_in_fibre_mode = 1;
  law.fibre_tension_left = 0.5;
  for (const Isa isa : available_isas()) {
    auto point = point_of<Real>(law, 0.4, isa, 3);
    random_walk(point, 3, 40, 5e-4, 1);
    bits.push_back(point.bits());
  }
  return bits;
}

TEST(CompositeDamage, InstructionSetsWithTheSameRoundingGiveTheSameBits) {
  const auto same = [](const auto& a, const auto& b) { return same_bits(a, b); };
  test::expect_alike(bits_of_all<float>(), same);
  test::expect_alike(bits_of_all<double>(), same);
}

/// A hundred thousand small steps in float: the strength is kept, and nothing drifts.
TEST(CompositeDamage, SlowLoadingInSinglePrecision) {
  const Law law = without_limits();
  auto point = point_of<float>(law, 0.5, available_isas().back());
  constexpr int steps = 100000;
  const Five step = strain_for(law, {0, 98.0 / steps, 0}, 0);
  // The fibres lie at 0.5: the strain of the ply, turned.
  const double c = std::cos(0.5);
  const double s = std::sin(0.5);
  const Five turned{c * c * step[0] + s * s * step[1], s * s * step[0] + c * c * step[1],
                    2 * c * s * (step[0] - step[1]), 0, 0};
  for (int i = 0; i < steps; ++i) point.apply(turned);
  const auto [xx, yy, xy, yz, zx] = point.stress();
  EXPECT_NEAR(yz + zx, 0, 0);
  test::verified("tension across to twice the strain of failure in 100000 steps, single precision: stress",
                 "the strength")
      .within(s * s * xx + c * c * yy - 2 * c * s * xy, 49, 2e-3);
}

TEST(CompositeDamage, EqualsTheElasticLawBelowItsStrengths) {
  const Law law = without_limits();
  model::OrthotropicElastic plain = law;
  model::Material elastic;
  elastic.law = plain;
  PointDriver<double> a(elastic, Isa::Scalar);
  a.prepare(elastic.law, axes_at(0.7));
  auto b = point_of(law, 0.7);
  const Five strain{0.001, -0.0004, 0.0007, 0.0002, -0.0003};
  a.apply(strain);
  b.apply(strain);
  for (std::size_t c = 0; c < components; ++c) EXPECT_NEAR(a.stress()[c], b.stress()[c], 1e-11);
  EXPECT_NEAR(a.energy(), b.energy(), 1e-15);
}

TEST(CompositeDamage, BadNumbersAreNamed) {
  const auto fails = [](const auto& change) {
    Law law = carbon();
    change(law);
    EXPECT_THROW(shell_material_constants(material_of(law)), Error);
  };
  fails([](Law& law) { law.tension_b = 0; });
  fails([](Law& law) { law.shear_in_fibre_mode = 2; });
  fails([](Law& law) { law.shear_softening = -1; });
  fails([](Law& law) { law.poisson_ba = 0.5; });
}

}  // namespace
}  // namespace crumple::materials::testing::composite_damage_test
