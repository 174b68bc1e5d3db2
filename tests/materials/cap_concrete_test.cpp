// SPDX-License-Identifier: BSD-3-Clause
// Concrete with a smooth cap, its plastic part: strengths against the equations of the surface, the return
// against normality, the crush under pressure against its law.
#include <gtest/gtest.h>

#include <random>

#include "base/error.hpp"
#include "materials/concrete_cases.hpp"
#include "support/alike.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::cap_concrete_test {
namespace {

class CapConcrete : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, CapConcrete, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

/// Largest axial pressure of a test whose sides are held at a pressure.
double peak(const model::Material& material, Isa isa, double axial, double pressure, int steps) {
  SolidDriver<double> point(material, isa);
  press_all(point, pressure, std::get<model::CapConcrete>(material.law).bulk_modulus);
  double most = 0;
  for (int i = 0; i < steps; ++i) {
    press_along_x(point, axial, pressure);
    most = std::max(most, std::fabs(point.stress()[0]));
  }
  return most;
}

TEST_P(CapConcrete, DefaultParametersGiveTheStrengthThatTheyStandFor) {
  const std::string what = "concrete by f'c, unconfined compression: strength over ";
  test::Largest form(what + "that of the surface, 20 to 58 MPa, error", "failure surface and cap", 1e-4);
  test::Largest middle(what + "f'c of 28 to 46 MPa, error", "f'c of *MAT_CSCM_CONCRETE", 0.03);
  test::Largest ends(what + "f'c of 20 and 58 MPa, error", "f'c of *MAT_CSCM_CONCRETE", 0.16);
  for (const double strength : {20.0, 28.0, 30.0, 38.0, 46.0, 58.0}) {
    const model::Material material = concrete(strength);
    const ConcreteSurface surface{std::get<model::CapConcrete>(material.law)};
    double low = 0;
    double high = 2 * strength;
    for (int i = 0; i < 100; ++i) {
      const double s = 0.5 * (low + high);
      (s / std::sqrt(3.0) < surface.bound(s, surface.first_cap()) ? low : high) = s;
    }
    const double found = peak(material, GetParam(), -1e-5, 0, 300);
    form.compare(found, low, low, std::to_string(strength));
    (strength < 25 || strength > 50 ? ends : middle)
        .compare(found, strength, strength, std::to_string(strength));
  }
}

TEST_P(CapConcrete, TriaxialCompressionFollowsTheFailureSurface) {
  const model::Material material = uncapped_concrete();
  const ConcreteSurface surface{std::get<model::CapConcrete>(material.law)};
  test::Largest off("concrete, triaxial compression at seven pressures: q, error [MPa]",
                    "alpha - lambda exp(-beta I) + theta I", 1e-6);
  for (const double pressure : {0.0, 2.0, 5.0, 10.0, 20.0, 40.0, 80.0}) {
    SolidDriver<double> point(material, GetParam());
    press_all(point, pressure, surface.law.bulk_modulus);
    for (int i = 0; i < 200; ++i) press_along_x(point, -1e-4, pressure);
    const Six s = point.stress();
    EXPECT_NEAR(s[1], -pressure, 1e-8);
    EXPECT_LT(s[0], -pressure - 20);
    off.compare(size_of(s), surface.strength(trace_of(s)), 1, std::to_string(pressure));
  }
}

TEST_P(CapConcrete, ExtensionAndTorsionHaveRubinsRatios) {
  const model::Material material = uncapped_concrete();
  const ConcreteSurface surface{std::get<model::CapConcrete>(material.law)};
  test::Largest extension("concrete, triaxial extension: q over that of compression, error",
                          "alpha2 - lambda2 exp(-beta2 I) + theta2 I; 1/2 in tension", 1e-6);
  test::Largest torsion("concrete, torsion: q over that of compression, error",
                        "alpha1 - lambda1 exp(-beta1 I) + theta1 I; 1/sqrt(3) in tension", 1e-6);
  for (const double pressure : {-0.5, 0.0, 2.0, 5.0, 20.0, 60.0}) {
    SolidDriver<double> pulled(material, GetParam());
    SolidDriver<double> sheared(material, GetParam());
    press_all(pulled, pressure, surface.law.bulk_modulus);
    press_all(sheared, pressure, surface.law.bulk_modulus);
    for (int i = 0; i < 4000; ++i) {
      pulled.apply({2e-6, -1e-6, -1e-6, 0, 0, 0});
      sheared.apply({0, 0, 0, 2e-6, 0, 0});
    }
    const Six e = pulled.stress();
    const Six t = sheared.stress();
    EXPECT_GT(e[0], e[1] + 1);
    extension.compare(size_of(e) / surface.strength(trace_of(e)), surface.extension_ratio(trace_of(e)), 1,
                      std::to_string(pressure));
    torsion.compare(size_of(t) / surface.strength(trace_of(t)), surface.torsion_ratio(trace_of(t)), 1,
                    std::to_string(pressure));
  }
}

/// Principal deviators at an angle in the deviatoric plane, as strain increments; 30 degrees is compression.
Six at_angle(double degrees, double size) {
  const double a = degrees * 3.14159265358979323846 / 180;
  const double third = 2 * 3.14159265358979323846 / 3;
  // The middle one is sin(a) times 2/sqrt(3).
  return {size * std::sin(a + third), size * std::sin(a), size * std::sin(a - third), 0, 0, 0};
}

TEST_P(CapConcrete, SectionAcrossThePressureIsConvex) {
  const model::Material material = uncapped_concrete();
  for (const double trace : {-2.0, 6.0, 30.0, 120.0}) {
    std::vector<std::array<double, 2>> corner;
    for (int degrees = -30; degrees <= 30; degrees += 2) {
      // One step from rest, of a trial just outside, keeps the trace nearly.
      double low = 0;
      double high = 0.01;
      for (int k = 0; k < 60; ++k) {
        const double size = 0.5 * (low + high);
        Six strain = at_angle(degrees, size);
        const auto& law = std::get<model::CapConcrete>(material.law);
        for (int c = 0; c < 3; ++c) strain[c] -= trace / (9 * law.bulk_modulus);
        SolidDriver<double> point(material, GetParam());
        point.apply(strain);
        const double elastic = 2 * law.shear_modulus * size * std::sqrt(1.5 / 2);
        (size_of(point.stress()) < elastic * (1 - 1e-12) ? high : low) = size;
      }
      const double a = degrees * 3.14159265358979323846 / 180;
      corner.push_back({low * std::cos(a), low * std::sin(a)});
    }
    for (std::size_t k = 1; k + 1 < corner.size(); ++k) {
      const auto& [x0, y0] = corner[k - 1];
      const auto& [x1, y1] = corner[k];
      const auto& [x2, y2] = corner[k + 1];
      EXPECT_GE((x1 - x0) * (y2 - y1) - (y1 - y0) * (x2 - x1), -1e-18) << trace << " " << k;
    }
  }
}

TEST_P(CapConcrete, PressureCrushesByTheLawOfTheCap) {
  const model::Material material = tough_concrete();
  const ConcreteSurface surface{std::get<model::CapConcrete>(material.law)};
  const model::CapConcrete& law = surface.law;
  test::Largest off("concrete under pressure alone: loss of volume, error",
                    "elastic, and W (1 - exp(-D1 x - D2 x^2))", 1e-10);
  for (const int steps : {10, 300}) {
    SolidDriver<double> point(material, GetParam());
    const double all = 0.08;
    for (int i = 1; i <= steps; ++i) {
      const double third = -all / steps / 3;
      point.apply({third, third, third, 0, 0, 0});
      const double trace = trace_of(point.stress());
      const double loss =
          trace / (3 * law.bulk_modulus) + (trace > law.cap_start ? surface.crushed(trace) : 0.0);
      off.compare(loss, all * i / steps);
      EXPECT_NEAR(size_of(point.stress()), 0, 1e-9);
    }
    EXPECT_GT(trace_of(point.stress()), 1000);
    // Unloading is elastic.
    const double before = trace_of(point.stress());
    point.apply({1e-3, 1e-3, 1e-3, 0, 0, 0});
    off.compare((before - trace_of(point.stress())) / (3 * law.bulk_modulus), 3e-3);
  }
}

/// One long step from rest: the stress is on the surface, and the plastic strain normal to it there.
TEST_P(CapConcrete, ReturnIsNormalToTheSurface) {
  const model::Material material = tough_concrete();
  const ConcreteSurface surface{std::get<model::CapConcrete>(material.law)};
  const model::CapConcrete& law = surface.law;
  std::mt19937 generator(159);
  std::uniform_real_distribution<double> uniform(0, 1);
  test::Largest on("concrete, one long step of triaxial compression: q off the surface [MPa]",
                   "equations of the surface", 1e-9);
  test::Largest normal("concrete, one long step of triaxial compression: plastic strain off the normal [-]",
                       "associated flow", 1e-5);
  test::Largest volume("concrete, one long step of triaxial compression: crushed volume, error",
                       "law of the cap", 1e-10);
  int crushing = 0;
  int dilating = 0;
  for (int i = 0; i < 200; ++i) {
    const double trace = -30 + 500 * uniform(generator);
    const double size = 250 * uniform(generator);
    const double axial = size / (std::sqrt(3.0) * law.shear_modulus);
    const double third = trace / (9 * law.bulk_modulus);
    SolidDriver<double> point(material, GetParam());
    point.apply({-axial - third, axial / 2 - third, axial / 2 - third, 0, 0, 0});
    const double now = trace_of(point.stress());
    const double q = size_of(point.stress());
    const double cap = surface.first_cap() + point.item("cap_growth");
    if (std::fabs(now - trace) + std::fabs(q - size) < 1e-9) continue;  // elastic
    on.compare(q, std::max(surface.bound(now, cap), 0.0), 1, std::to_string(trace));
    const double h = 1e-5;
    if (q < 1) continue;  // the apex and the end of the cap have no slope
    const double slope = (surface.bound(now + h, cap) - surface.bound(now - h, cap)) / (2 * h);
    // (dI, dq) = l (9 K F', -G)
    const double first = (now - trace) / (9 * law.bulk_modulus);
    const double second = (size - q) / law.shear_modulus;
    normal.compare(first, second * slope, std::hypot(first, second) * std::hypot(1.0, slope),
                   std::to_string(trace) + " " + std::to_string(size));
    (now < trace ? crushing : dilating) += 1;
    volume.compare(surface.crushed(surface.end_of(cap)),
                   now < trace ? (trace - now) / (3 * law.bulk_modulus) : 0);
  }
  EXPECT_GT(crushing, 40);
  EXPECT_GT(dilating, 25);
}

TEST_P(CapConcrete, TensionFromAllSidesEndsAtTheApex) {
  const model::Material material = tough_concrete();
  const ConcreteSurface surface{std::get<model::CapConcrete>(material.law)};
  SolidDriver<double> point(material, GetParam());
  for (int i = 0; i < 100; ++i) point.apply({1e-5, 1.1e-5, 0.9e-5, 0, 0, 0});
  const double pull = -trace_of(point.stress());
  EXPECT_GT(pull, 1);
  test::verified("concrete pulled from all sides: strength at the apex [MPa]", "root of the failure surface")
      .below(std::fabs(surface.strength(-pull)), 1e-9);
}

TEST_P(CapConcrete, ATurnedObserverSeesTheTurnedStress) {
  const Matrix turn = turn_about({2.0 / 7, -3.0 / 7, 6.0 / 7}, 1.1);
  model::Material material = concrete();
  concrete_law(material).has_rate_effects = true;
  SolidDriver<double> one(material, GetParam());
  SolidDriver<double> other(material, GetParam());
  test::Largest off("concrete, seen by a turned observer: stress, error [MPa]", "invariance", 1e-9);
  for (int i = 0; i < 120; ++i) {
    const Six strain{
        -5e-5 * std::cos(0.1 * i), -4e-5 * std::cos(0.05 * i), 1e-5, 4e-5 * std::sin(0.2 * i), 3e-5, -2e-5};
    one.apply(strain, 1e-4);
    other.apply(rotated(strain, turn, 0.5), 1e-4);
    const Six expected = rotated(one.stress(), turn);
    for (int c = 0; c < 6; ++c) off.compare(other.stress()[c], expected[c]);
  }
}

/// A body that turns as it is loaded has the stress of one that does not, turned.
TEST_P(CapConcrete, HistoryTurnsWithTheBody) {
  model::Material material = concrete();
  concrete_law(material).has_rate_effects = true;
  SolidDriver<double> still(material, GetParam());
  SolidDriver<double> turning(material, GetParam());
  const std::array<double, 3> axis{0.6, 0, 0.8};
  constexpr double angle = 0.02;
  const Matrix half = turn_about(axis, angle / 2);
  Matrix at{};
  test::Largest off("concrete that turns while it is loaded: stress, error [MPa]", "at rest, turned", 1e-9);
  turning.set_turn(0, 0, turn_about(axis, angle));
  for (int i = 0; i < 150; ++i) {
    const Six strain{2e-6, -1e-5 * std::cos(0.05 * i), -1e-6, 3e-6, 2e-6, 0};
    still.apply(strain, 1e-5);
    // Strains are those of the middle of the step.
    turning.apply(rotated(strain, after(half, at), 0.5), 1e-5);
    at = after(turn_about(axis, angle), at);
    const Six expected = rotated(still.stress(), at);
    for (int c = 0; c < 6; ++c) off.compare(turning.stress()[c], expected[c]);
  }
}

/// Random strains of any size keep the numbers finite, and instruction sets of the same rounding the bits.
template <class Real>
void walk_all(double size) {
  model::Material material = concrete();
  concrete_law(material).has_rate_effects = true;
  concrete_law(material).erodes = true;
  concrete_law(material).erosion_strain = 0.5;
  std::vector<std::vector<Real>> bits;
  for (const Isa isa : available_isas()) {
    SolidDriver<Real> driver(material, isa, 3);
    for (int i = 0; i < 40; ++i) random_walk(driver, i, 1, size, 1e-5);
    bits.push_back(driver.bits());
  }
  for (const Real number : bits[0]) ASSERT_TRUE(std::isfinite(number));
  test::expect_alike(bits, [](const auto& a, const auto& b) { return same_bits(a, b); });
}
TEST(CapConcreteWalk, InstructionSetsWithTheSameRoundingGiveTheSameBits) {
  for (const double size : {1e-6, 1e-4, 3e-3}) {
    walk_all<double>(size);
    walk_all<float>(size);
  }
}

TEST_P(CapConcrete, FloatAgreesWithDouble) {
  for (const bool crush : {false, true}) {
    SolidDriver<float> coarse(concrete(), GetParam());
    SolidDriver<double> exact(concrete(), GetParam());
    test::Largest off(std::string("concrete in single precision, ") +
                          (crush ? "crushed under pressure" : "torn") + ": stress, error [MPa]",
                      "double precision", crush ? 0.3 : 2e-3);
    for (int i = 0; i < 4000; ++i) {
      const Six strain = crush ? Six{-4e-6, -3e-6, -3.5e-6, 1e-6, 0, 0} : Six{2e-7, -4e-8, -5e-8, 3e-8, 0, 0};
      coarse.apply(strain);
      exact.apply(strain);
      for (int c = 0; c < 6; ++c) off.compare(coarse.stress()[c], exact.stress()[c]);
    }
  }
}

TEST(CapConcreteConstants, AreChecked) {
  const auto refused = [](const auto& change) {
    model::Material material = concrete();
    change(concrete_law(material));
    EXPECT_THROW(solid_material_constants(material), Error);
  };
  EXPECT_NO_THROW(solid_material_constants(concrete()));
  refused([](model::CapConcrete& law) { law.compression.nonlinear = law.compression.constant; });
  refused([](model::CapConcrete& law) { law.cap_ratio = 0; });
  refused([](model::CapConcrete& law) { law.cap_start = 0; });
  refused([](model::CapConcrete& law) { law.crush_volume = -1; });
  refused([](model::CapConcrete& law) { law.tension_energy = 0; });
  refused([](model::CapConcrete& law) { law.first_damage = 1; });
  refused([](model::CapConcrete& law) { law.kept_damage = 1.5; });
  refused([](model::CapConcrete& law) {
    law.has_rate_effects = true;
    law.tension_rate.exponent = 1;
  });
}

/// The fits in the units of each UNITS are the same concrete.
TEST(CapConcreteDefaults, AreThoseOfTheReport) {
  const model::CapConcrete law = model::normal_strength_concrete(30, 19, {});
  test::Largest off("concrete by f'c of 30 MPa: parameters over those by hand, error",
                    "quadratics of FHWA-HRT-05-062", 5e-4);
  off.compare(law.compression.constant, 14.514, 14.514, "ALPHA");
  off.compare(law.compression.linear, 0.29654, 0.29654, "THETA");
  off.compare(law.torsion.exponent, 0.070570, 0.070570, "BETA1");
  off.compare(law.cap_start, 90.543, 90.543, "X0");
  off.compare(law.tension_rate.coefficient, 6.176e-5, 6.176e-5, "ETA0T");
  off.compare(law.compression_rate.limit, 21.454, 21.454, "OVERC");
  off.compare(law.youngs_modulus, 26357, 26357, "E");
  off.compare(law.poissons_ratio, 0.15, 0.15);
  // GPa, mm, ms.
  const model::CapConcrete other = model::normal_strength_concrete(30, 19, {1000, 1, 1e-3});
  off.compare(other.compression.constant, 0.014514, 0.014514);
  off.compare(other.compression.exponent, 19.29, 19.29);
  off.compare(other.crush_quadratic, 0.349, 0.349);
  // eta = eta0 / rate^N is a time: of 1/s and of 0.001/ms.
  off.compare(other.tension_rate.coefficient / std::pow(1e-3, 0.48), 1e3 * law.tension_rate.coefficient,
              1e3 * law.tension_rate.coefficient);
  off.compare(other.tension_energy, 1e-3 * law.tension_energy, 1e-3 * law.tension_energy);
}

}  // namespace
}  // namespace crumple::materials::testing::cap_concrete_test
