// SPDX-License-Identifier: BSD-3-Clause
// Rubber against the derivatives of its strain energy, which is written here anew.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <random>

#include "base/error.hpp"
#include "materials/motion_driver.hpp"
#include "support/drawn.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::rubber_test {
namespace {

constexpr double shear = 1.04;  // MPa
constexpr double first = 0.55;
constexpr double second = 0.14;

model::Material rubber(const model::ConstitutiveLaw& law) {
  model::Material material;
  material.id = 7;
  material.density = 1.1e-9;
  material.law = law;
  return material;
}
model::Material blatz_ko() {
  return rubber(model::BlatzKo{2 * shear * 1.463, 0.463});
}
model::Material mooney_rivlin(double poisson) {
  return rubber(model::MooneyRivlin{4 * (first + second) * (1 + poisson), poisson, first, second});
}

/// Vulcanized rubber after R.W. Ogden, Proc. R. Soc. A 326 (1972) 565-584, in MPa.
constexpr std::array<double, 8> ogden_moduli{0.63, 0.0012, -0.01};
constexpr std::array<double, 8> ogden_exponents{1.3, 5, -2};
constexpr double ogden_shear = 0.4225;
model::Material ogden(double poisson) {
  return rubber(model::OgdenRubber{2 * ogden_shear * (1 + poisson), poisson, ogden_moduli, ogden_exponents});
}
/// 10, 01, 11, 20, 02, 30.
constexpr double polynomial_constants[] = {0.3, 0.05, 0.01, -0.02, 0.004, 0.003};
model::Material polynomial(double poisson) {
  const auto& c = polynomial_constants;
  return rubber(model::PolynomialRubber{4 * (c[0] + c[1]) * (1 + poisson), poisson, c[0], c[1], c[2], c[3],
                                        c[4], c[5]});
}

using Energy = std::function<double(const Matrix&)>;

double first_invariant(const Matrix& f) {
  const Matrix c = times(transposed(f), f);
  return c[0][0] + c[1][1] + c[2][2];
}
double second_invariant(const Matrix& f) {
  const Matrix c = times(transposed(f), f);
  const Matrix square = times(c, c);
  const double trace = c[0][0] + c[1][1] + c[2][2];
  return 0.5 * (trace * trace - square[0][0] - square[1][1] - square[2][2]);
}
/// P.J. Blatz & W.L. Ko, Trans. Soc. Rheology 6 (1962) 223-252, with f = 1.
double blatz_ko_energy(const Matrix& f) {
  const double beta = 0.463 / (1 - 2 * 0.463);
  return shear / 2 * (first_invariant(f) - 3 + (std::pow(determinant(f), -2 * beta) - 1) / beta);
}
Energy mooney_rivlin_energy(double nu) {
  return [nu](const Matrix& f) {
    const double i3 = determinant(f) * determinant(f);
    const double c = first / 2 + second;
    const double d = (first * (5 * nu - 2) + second * (11 * nu - 5)) / (2 * (1 - 2 * nu));
    return first * (first_invariant(f) - 3) + second * (second_invariant(f) - 3) + c * (1 / (i3 * i3) - 1) +
           d * (i3 - 1) * (i3 - 1);
  };
}

double bulk_modulus(double shear_modulus, double nu) {
  return 2 * shear_modulus * (1 + nu) / (3 * (1 - 2 * nu));
}
double volumetric(const Matrix& f, double bulk) {
  return bulk / 2 * (determinant(f) - 1) * (determinant(f) - 1);
}
/// Squares of the principal stretches, by rotations that each take the largest off-diagonal number away.
std::array<double, 3> squared_stretches(const Matrix& f) {
  Matrix c = times(transposed(f), f);
  for (int i = 0; i < 40; ++i) {
    int p = 0;
    int q = 1;
    if (std::fabs(c[0][2]) > std::fabs(c[p][q])) q = 2;
    if (std::fabs(c[1][2]) > std::fabs(c[p][q])) p = 1, q = 2;
    const double angle = 0.5 * std::atan2(2 * c[p][q], c[q][q] - c[p][p]);
    Matrix turn = unit;
    turn[p][p] = turn[q][q] = std::cos(angle);
    turn[p][q] = std::sin(angle);
    turn[q][p] = -std::sin(angle);
    c = times(transposed(turn), times(c, turn));
  }
  return {c[0][0], c[1][1], c[2][2]};
}
Energy ogden_energy(double nu) {
  return [nu](const Matrix& f) {
    double sum = volumetric(f, bulk_modulus(ogden_shear, nu));
    for (const double square : squared_stretches(f)) {
      const double stretch = std::sqrt(square) / std::cbrt(determinant(f));
      for (int n = 0; n < 3; ++n)
        sum += ogden_moduli[n] / ogden_exponents[n] * (std::pow(stretch, ogden_exponents[n]) - 1);
    }
    return sum;
  };
}
Energy polynomial_energy(double nu) {
  return [nu](const Matrix& f) {
    const auto& c = polynomial_constants;
    const double j = determinant(f);
    const double x = first_invariant(f) / std::pow(j, 2.0 / 3) - 3;
    const double y = second_invariant(f) / std::pow(j, 4.0 / 3) - 3;
    return volumetric(f, bulk_modulus(2 * (c[0] + c[1]), nu)) + c[0] * x + c[1] * y + c[2] * x * y +
           c[3] * x * x + c[4] * y * y + c[5] * x * x * x;
  };
}

/// sigma = dW/dF F^T / J by central differences of fourth order.
Six stress_of(const Energy& energy, const Matrix& f) {
  constexpr double h = 2e-4;
  Matrix p{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto at = [&](double by) {
        Matrix g = f;
        g[i][j] += by * h;
        return energy(g);
      };
      p[i][j] = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
    }
  Six s = six_of(times(p, transposed(f)));
  for (double& value : s) value /= determinant(f);
  return s;
}

struct Case {
  const char* name;
  model::Material material;
  Energy energy;
  double stiffness;  ///< against which stresses are judged
};
std::vector<Case> cases() {
  return {{"Blatz-Ko", blatz_ko(), blatz_ko_energy, 14 * shear},
          {"Mooney-Rivlin 0.49", mooney_rivlin(0.49), mooney_rivlin_energy(0.49), 70},
          {"Mooney-Rivlin 0.4995", mooney_rivlin(0.4995), mooney_rivlin_energy(0.4995), 1400},
          {"Ogden 0.49", ogden(0.49), ogden_energy(0.49), 21},
          {"Ogden 0.4995", ogden(0.4995), ogden_energy(0.4995), 420},
          {"polynomial 0.49", polynomial(0.49), polynomial_energy(0.49), 35}};
}

Matrix random_gradient(std::mt19937& generator, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  Matrix f = unit;
  for (auto& row : f)
    for (double& value : row) value += uniform(generator);
  return f;
}

class Rubber : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, Rubber, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

TEST_P(Rubber, StressIsTheDerivativeOfTheEnergyWhateverThePath) {
  std::mt19937 generator(7);
  for (const Case& c : cases()) {
    const std::string law = std::string(c.name) + ", random motions: ";
    test::Largest off(law + "stress over the stiffness, error", "derivative of the strain energy", 1e-9);
    test::Largest paths(law + "stress after a detour over the stiffness, change", "straight path", 1e-12);
    for (int i = 0; i < 10; ++i) {
      const Matrix end = random_gradient(generator, 0.2);
      MotionDriver<double> straight(c.material, GetParam());
      straight.move_in_steps(end, 5);
      MotionDriver<double> detour(c.material, GetParam());
      for (int k = 0; k < 8; ++k) detour.move_to(random_gradient(generator, 0.3));
      detour.move_to(end);
      const Six expected = stress_of(c.energy, end);
      off.add(largest_difference(straight.stress(), expected) / c.stiffness);
      paths.add(largest_difference(detour.stress(), straight.stress()) / c.stiffness);
    }
  }
}

TEST_P(Rubber, KnowsNoRotation) {
  const Matrix stretched{{{1.4, 0.2, 0}, {0, 0.9, 0.1}, {0.05, 0, 0.85}}};
  const std::array<double, 3> axis{2.0 / 3, -1.0 / 3, 2.0 / 3};
  for (const Case& c : cases()) {
    MotionDriver<double> point(c.material, GetParam());
    // Ten whole turns without strain leave no stress.
    for (int i = 1; i <= 600; ++i) point.move_to(rotation(axis, 0.1047197551196598 * i));
    const std::string law = c.name;
    test::verified(law + ", ten turns without strain: stress over the stiffness", "none")
        .below(largest_difference(point.stress(), {}) / c.stiffness, 1e-12);
    point.move_in_steps(stretched, 3);
    const Matrix stress = matrix_of(point.stress());
    for (int i = 1; i <= 25; ++i) point.move_to(times(rotation(axis, 0.1 * i), stretched));
    const Matrix q = rotation(axis, 2.5);
    const Six expected = six_of(times(q, times(stress, transposed(q))));
    test::verified(law + ", stretched, then turned: stress over the stiffness, error", "turned stress")
        .below(largest_difference(point.stress(), expected) / c.stiffness, 1e-12);
  }
}

/// Uniaxial stress: s1 - s2 = (2 / J) (l1^2 - l2^2) (A + B l2^2), Rivlin 1948, with s2 = 0 at the right l2.
struct Bar {
  double stress;
  double across;  ///< lateral stretch without lateral stress
};
Bar stretched_bar(double stretch, double poisson, Isa isa) {
  double across = 1 / std::sqrt(stretch);
  Six s{};
  for (int i = 0; i < 30; ++i) {
    const auto lateral = [&](double side) {
      MotionDriver<double> point(mooney_rivlin(poisson), isa);
      point.move_to({{{stretch, 0, 0}, {0, side, 0}, {0, 0, side}}});
      s = point.stress();
      return s[1];
    };
    const double slope = (lateral(across + 1e-7) - lateral(across - 1e-7)) / 2e-7;
    across -= lateral(across) / slope;
  }
  return {s[0], across};
}
/// 2 (l^2 - 1/l) (A + B/l).
double incompressible(double stretch) {
  return 2 * (stretch * stretch - 1 / stretch) * (first + second / stretch);
}
TEST_P(Rubber, MooneyRivlinBarFollowsTheClosedForm) {
  const std::string bar = "Mooney-Rivlin bar, stretched to 0.6, 1.3 and 2.5: ";
  test::Largest off(bar + "stress, relative error", "Rivlin 1948", 1e-11);
  test::Largest limits(bar + "stress, relative difference", "Rivlin 1948, incompressible", 0.01);
  for (const double stretch : {0.6, 1.3, 2.5}) {
    const Bar found = stretched_bar(stretch, 0.4995, GetParam());
    const double square = found.across * found.across;
    const double expected = 2 / (stretch * square) * (stretch * stretch - square) * (first + second * square);
    off.compare(found.stress, expected, expected);
    limits.compare(found.stress, incompressible(stretch), incompressible(stretch));
  }
}
TEST(RubberBar, StressOverStretchIsDrawn) {
  test::Points exact;
  test::Points found;
  test::Largest off("Mooney-Rivlin bar, stretched to 0.5 and to 3: stress over the largest, difference",
                    "Rivlin 1948, incompressible", 1e-3);
  for (int i = 0; i <= 25; ++i) {
    const double stretch = 0.5 + 0.1 * i;
    exact.push_back({stretch, incompressible(stretch)});
    found.push_back({stretch, stretched_bar(stretch, 0.4995, Isa::Scalar).stress});
    off.compare(found.back()[1], exact.back()[1], incompressible(3));
  }
  test::drawn("Rubber bar, A = 0.55 MPa, B = 0.14 MPa", "stretch", "true stress [MPa]")
      .accepted("Rivlin, incompressible", exact)
      .found("Poisson's ratio 0.4995", found)
      .note();
}

/// Stretched along x, held at `held` along y or free there, free along z: the true stress in x.
struct Pull {
  const char* name;
  double power;  ///< y = x^power
};
constexpr Pull pulls[] = {{"bar", -0.5}, {"sheet pulled both ways", 1}, {"wide strip", 0}};
struct Pulled {
  double stress;
  std::array<double, 3> stretch;
};
Pulled pulled(const model::Material& material, const Pull& pull, double stretch, Isa isa) {
  double z = std::pow(stretch, -1 - pull.power);
  Six s{};
  double y = 0;
  for (int i = 0; i < 30; ++i) {
    const auto across = [&](double side) {
      MotionDriver<double> point(material, isa);
      y = pull.power < 0 ? side : std::pow(stretch, pull.power);
      point.move_to({{{stretch, 0, 0}, {0, y, 0}, {0, 0, side}}});
      s = point.stress();
      return s[2];
    };
    const double slope = (across(z + 1e-7) - across(z - 1e-7)) / 2e-7;
    z -= across(z) / slope;
  }
  return {s[0], {stretch, y, z}};
}
/// J sigma_x = sum mu (x^alpha - z^alpha) with the stretches over J^(1/3), as sigma_z = 0; Ogden 1972,
/// eq. 12.
TEST_P(Rubber, OgdenFollowsTheClosedForms) {
  for (const Pull& pull : pulls) {
    const std::string name = std::string("Ogden rubber, ") + pull.name + " to 0.7, 1.5 and 3: ";
    test::Largest off(name + "stress, relative error", "Ogden 1972", 1e-10);
    test::Largest limits(name + "stress, relative difference", "Ogden 1972, incompressible", 0.01);
    for (const double stretch : {0.7, 1.5, 3.0}) {
      const Pulled found = pulled(ogden(0.4995), pull, stretch, GetParam());
      const double volume = found.stretch[0] * found.stretch[1] * found.stretch[2];
      double expected = 0;
      double incompressible = 0;
      for (int n = 0; n < 3; ++n) {
        const auto term = [&](double of, double scale) {
          return ogden_moduli[n] * std::pow(of / scale, ogden_exponents[n]);
        };
        const double scale = std::cbrt(volume);
        expected += (term(found.stretch[0], scale) - term(found.stretch[2], scale)) / volume;
        incompressible += term(stretch, 1) - term(std::pow(stretch, -1 - pull.power), 1);
      }
      off.compare(found.stress, expected, expected);
      limits.compare(found.stress, incompressible, incompressible);
    }
  }
}
/// J sigma_x = 2 (x^2 - z^2) (W1 + y^2 W2) with the stretches over J^(1/3), as sigma_z = 0; Rivlin 1948.
TEST_P(Rubber, PolynomialRubberFollowsTheClosedForms) {
  const auto& c = polynomial_constants;
  for (const Pull& pull : pulls) {
    test::Largest off(
        std::string("polynomial rubber, ") + pull.name + " to 0.7, 1.4 and 2: stress, relative error",
        "Rivlin 1948", 1e-10);
    for (const double stretch : {0.7, 1.4, 2.0}) {
      const Pulled found = pulled(polynomial(0.4995), pull, stretch, GetParam());
      const double volume = found.stretch[0] * found.stretch[1] * found.stretch[2];
      double e[3];
      for (int k = 0; k < 3; ++k) e[k] = std::pow(found.stretch[k], 2) / std::pow(volume, 2.0 / 3);
      const double x = e[0] + e[1] + e[2] - 3;
      const double y = e[0] * e[1] + e[1] * e[2] + e[2] * e[0] - 3;
      const double w1 = c[0] + c[2] * y + 2 * c[3] * x + 3 * c[5] * x * x;
      const double w2 = c[1] + c[2] * x + 2 * c[4] * y;
      const double expected = 2 * (e[0] - e[2]) * (w1 + e[1] * w2) / volume;
      off.compare(found.stress, expected, expected);
    }
  }
}

/// Second order in the step, whether the axes turn or not.
TEST_P(Rubber, WorkIsTheEnergy) {
  const Matrix straight{{{1.3, 0, 0}, {0, 0.9, 0}, {0, 0, 0.87}}};
  const Matrix sheared{{{1.3, 0.3, 0}, {-0.1, 0.9, 0.1}, {0.05, 0, 0.95}}};
  for (const Case& c : cases()) {
    const std::string work = std::string(c.name) + ", two motions: ";
    test::Largest off(work + "work of 400 steps, relative error", "strain energy", 1e-4);
    test::Largest orders(work + "error of 200 steps over that of 400, off 4", "second order", 0.001);
    for (const Matrix& end : {straight, sheared}) {
      double error[2];
      for (const int fine : {0, 1}) {
        MotionDriver<double> point(c.material, GetParam());
        point.move_in_steps(end, fine == 0 ? 200 : 400);
        error[fine] = point.work() / c.energy(end) - 1;
      }
      off.add(std::fabs(error[1]));
      orders.compare(error[0] / error[1], 4);
    }
  }
}

TEST_P(Rubber, StartsAsHookesLawOfItsConstants) {
  const Six strain{3e-7, -1e-7, 2e-7, 4e-7, -2e-7, 1e-7};
  for (const Case& c : cases()) {
    const double nu = std::visit([](const auto& law) { return law.poissons_ratio; }, c.material.law);
    const double young = std::visit([](const auto& law) { return law.youngs_modulus; }, c.material.law);
    const double g = young / (2 * (1 + nu));
    MotionDriver<double> point(c.material, GetParam());
    Matrix f = matrix_of({strain[0], strain[1], strain[2], strain[3] / 2, strain[4] / 2, strain[5] / 2});
    point.move_to(plus(unit, 1, f));
    const double spherical = 2 * g * nu / (1 - 2 * nu) * 4e-7;
    test::Largest off(std::string(c.name) + ", small strains: direct stresses over the mean one, error",
                      "Hooke's law", 1e-5);
    for (int k = 0; k < 3; ++k) off.compare(point.stress()[k], 2 * g * strain[k] + spherical, spherical);
    for (int k = 3; k < 6; ++k) EXPECT_NEAR(point.stress()[k], g * strain[k], 1e-11 * c.stiffness) << c.name;
    test::verified(std::string(c.name) + ", small strains: wave speed over that of Hooke's law",
                   "closed form")
        .near(point.wave_speed() / solid_start(c.material, nullptr).wave_speed, 1, 1e-5);
  }
}

/// Tangent along each principal axis, by differences: the wave speed is not below it, and not far above.
TEST_P(Rubber, WaveSpeedBoundsTheTangent) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(0.7, 1.6);
  for (const Case& c : cases())
    for (int i = 0; i < 20; ++i) {
      double side[3] = {uniform(generator), uniform(generator), 0};
      side[2] = 1 / (side[0] * side[1]) * (1 + 0.1 * (uniform(generator) - 1));
      Matrix f{};
      for (int k = 0; k < 3; ++k) f[k][k] = side[k];
      MotionDriver<double> point(c.material, GetParam());
      point.move_to(f);
      double fastest = 0;
      for (int k = 0; k < 3; ++k) {
        const double h = 1e-5 * side[k];
        Matrix more = f;
        Matrix less = f;
        more[k][k] += h;
        less[k][k] -= h;
        const double slope = (stress_of(c.energy, more)[k] - stress_of(c.energy, less)[k]) / (2 * h);
        const double density = c.material.density / determinant(f);
        fastest = test::larger_of(fastest, slope * side[k] / density);
      }
      EXPECT_GT(point.wave_speed(), 0.9999 * std::sqrt(fastest)) << c.name;
      EXPECT_LT(point.wave_speed(), 1.25 * std::sqrt(fastest)) << c.name;
    }
}

/// Float keeps F - 1 and what its sums lose: a hundred thousand small steps out and back leave no stress.
TEST_P(Rubber, FloatDoesNotDriftInManySteps) {
  for (const Case& c : cases()) {
    MotionDriver<float> coarse(c.material, GetParam());
    MotionDriver<double> exact(c.material, GetParam());
    for (int i = 1; i <= 100000; ++i) {
      const double phase = 2e-4 * 3.141592653589793 * i;
      const Matrix f{{{1 + 0.1 * std::sin(phase), 0.2 * std::sin(2 * phase), 0},
                      {0, 1 - 0.05 * std::sin(phase), 0},
                      {0.1 * std::sin(phase), 0, 1 - 0.04 * std::sin(phase)}}};
      coarse.move_to(f);
      exact.move_to(f);
    }
    test::verified(std::string(c.name) +
                       ", a hundred thousand steps in single precision: stress over the stiffness, error",
                   "double precision")
        .below(largest_difference(coarse.stress(), exact.stress()) / c.stiffness, 3e-6);
  }
}

TEST(RubberConstants, AreChecked) {
  EXPECT_THROW(solid_material_constants(rubber(model::MooneyRivlin{1, 0.5, first, second})), Error);
  EXPECT_THROW(solid_material_constants(rubber(model::MooneyRivlin{1, 0.49, -1, 0.5})), Error);
  EXPECT_THROW(solid_material_constants(rubber(model::BlatzKo{0, 0.463})), Error);
  EXPECT_THROW(solid_material_constants(ogden(0.5)), Error);
  EXPECT_THROW(solid_material_constants(rubber(model::PolynomialRubber{})), Error);
}

}  // namespace
}  // namespace crumple::materials::testing::rubber_test
