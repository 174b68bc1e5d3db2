// SPDX-License-Identifier: BSD-3-Clause
// Concrete of three surfaces: strengths against the published equations, compaction against its table, the
// opening in triaxial tension and the energy of tearing against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "materials/concrete_cases.hpp"
#include "support/alike.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::three_surface_concrete_test {
namespace {

constexpr double strength = 45.4;
constexpr double psi_per_mpa = 145;

/// In t, mm, s.
model::Material damaged_concrete() {
  model::Material material;
  material.id = 72;
  material.density = 2.4e-9;
  material.law = model::three_surface_concrete(strength, 0.19, psi_per_mpa, 1 / 25.4);
  return material;
}
model::ThreeSurfaceConcrete& law_of(model::Material& material) {
  return std::get<model::ThreeSurfaceConcrete>(material.law);
}
double bulk_of(const model::Material& material) {
  return std::get<model::ThreeSurfaceConcrete>(material.law).unloading[0];
}
double hyperbola(const model::ThreeSurfaceConcrete::Surface& of, double p) {
  return of.constant + p / (of.first + of.second * p);
}
double pressure_of(const Six& s) {
  return -mean(s);
}

/// Strains the x axis while the stresses yy and zz are held at -pressure: by the least lateral strain that
/// does, as torn sides have no stress either.
template <class Real>
void press_with_held_sides(SolidDriver<Real>& point, double axial, double pressure) {
  const auto side = [&](double lateral) {
    SolidDriver<Real> trial = point;
    trial.apply({axial, lateral, lateral, 0, 0, 0});
    return trial.stress()[1] + pressure;
  };
  const double step = 0.25 * std::fabs(axial);
  double b = -4 * step;
  while (side(b) < 0 && b < 40 * step) b += step;
  double a = b - step;
  for (int i = 0; i < 45; ++i) {
    const double middle = 0.5 * (a + b);
    (side(middle) < 0 ? a : b) = middle;
  }
  point.apply({axial, 0.5 * (a + b), 0.5 * (a + b), 0, 0, 0});
}

class ThreeSurfaceConcrete : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, ThreeSurfaceConcrete, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

TEST_P(ThreeSurfaceConcrete, UniaxialStrengthsAreThoseOfTheConcrete) {
  const model::Material material = damaged_concrete();
  const double tension = std::get<model::ThreeSurfaceConcrete>(material.law).tensile_strength;
  test::Largest off("concrete by f'c, strengths in compression and tension over f'c and FT, error",
                    "f'c and FT", 0.002);
  SolidDriver<double> crushed(material, GetParam());
  double most = 0;
  for (int i = 0; i < 300; ++i) {
    press_with_held_sides(crushed, -1e-5, 0);
    most = std::max(most, -crushed.stress()[0]);
  }
  off.compare(most, strength, strength, "compression");
  SolidDriver<double> torn(material, GetParam());
  most = 0;
  for (int i = 0; i < 400; ++i) {
    press_with_held_sides(torn, 1e-6, 0);
    most = std::max(most, torn.stress()[0]);
  }
  off.compare(most, tension, tension, "tension");
}

/// The whole surface grows by the factor of the rate: of compression at f/3, of tension without pressure.
TEST_P(ThreeSurfaceConcrete, RatesRaiseTheStrengthsByTheirFactors) {
  model::Material material = damaged_concrete();
  model::ThreeSurfaceConcrete& law = law_of(material);
  law.tension_rates = {{0, 1e-9}, {1, 3}};
  law.compression_rates = {{0, 1e-9}, {1, 1.4}};
  const double tension = law.tensile_strength;
  test::Largest off("concrete by f'c, fast: strengths over the factor of the rate times those at rest, error",
                    "factors of the rate", 0.004);
  SolidDriver<double> crushed(material, GetParam());
  double most = 0;
  for (int i = 0; i < 400; ++i) {
    press_with_held_sides(crushed, -1e-5, 0);
    most = std::max(most, -crushed.stress()[0]);
  }
  off.compare(most, 1.4 * strength, strength, "compression");
  SolidDriver<double> torn(material, GetParam());
  most = 0;
  for (int i = 0; i < 700; ++i) {
    press_with_held_sides(torn, 1e-6, 0);
    most = std::max(most, torn.stress()[0]);
  }
  off.compare(most, 3 * tension, tension, "tension");
}

/// Pressed along two axes alike, the third free.
TEST_P(ThreeSurfaceConcrete, BiaxialStrengthIsThatOfTheMeridianOfExtension) {
  SolidDriver<double> point(damaged_concrete(), GetParam());
  double most = 0;
  for (int i = 0; i < 300; ++i) {
    double a = -2e-4;
    double b = 2e-4;
    const auto try_free = [&](double zz) {
      SolidDriver<double> trial = point;
      trial.apply({-1e-5, -1e-5, zz, 0, 0, 0});
      return trial.stress()[2];
    };
    for (int k = 0; k < 45; ++k) {
      const double middle = 0.5 * (a + b);
      (try_free(middle) < 0 ? a : b) = middle;
    }
    point.apply({-1e-5, -1e-5, 0.5 * (a + b), 0, 0, 0});
    most = std::max(most, -point.stress()[0]);
  }
  test::Largest off("concrete by f'c, biaxial compression: strength over f'c, error", "1.15", 0.005);
  off.compare(most / strength, 1.15);
}

TEST_P(ThreeSurfaceConcrete, TriaxialCompressionReachesTheMaximumAndEndsOnTheResidual) {
  const model::Material material = damaged_concrete();
  const auto& law = std::get<model::ThreeSurfaceConcrete>(material.law);
  test::Largest peak("concrete, triaxial compression at three pressures: largest q over the maximum, error",
                     "a0 + p / (a1 + a2 p)", 0.002);
  test::Largest end("concrete, triaxial compression at three pressures: q in the end, error [MPa]",
                    "p / (a1f + a2f p)", 1e-6);
  for (const double pressure : {7.0, 20.0, 40.0}) {
    SolidDriver<double> point(material, GetParam());
    press_all(point, pressure, bulk_of(material));
    double most = 0;
    for (int i = 0; i < 500; ++i) {
      press_with_held_sides(point, i < 300 ? -6e-5 : -8e-4, pressure);
      most = std::max(most, equivalent(point.stress()) / hyperbola(law.maximum, pressure_of(point.stress())));
    }
    EXPECT_NEAR(point.stress()[1], -pressure, 1e-6);
    peak.compare(most, 1, 1, std::to_string(pressure));
    end.compare(equivalent(point.stress()), hyperbola(law.residual, pressure_of(point.stress())), 1,
                std::to_string(pressure));
  }
}

TEST_P(ThreeSurfaceConcrete, CompactionFollowsItsTableAndUnloadsElastically) {
  const model::Material material = damaged_concrete();
  const auto& law = std::get<model::ThreeSurfaceConcrete>(material.law);
  test::Largest off(
      "concrete, pressure alone: pressure at the table's points and at half of an unloading, error",
      "table of pressure and bulk moduli", 1e-6);
  SolidDriver<double> point(material, GetParam());
  constexpr int steps = 200;
  const auto squeeze = [&](double amount) {
    // Volumes of the driver are products: 1 + e of steps, of the middle of each.
    for (int i = 0; i < steps; ++i) {
      const double third = -2 * std::tanh(amount / steps / 6);
      point.apply({third, third, third, 0, 0, 0});
    }
  };
  for (std::size_t k = 1; k < law.compression.size(); ++k) {
    squeeze(law.compression[k] - law.compression[k - 1]);
    off.compare(pressure_of(point.stress()), law.pressure[k], law.pressure[k], std::to_string(k));
    EXPECT_NEAR(equivalent(point.stress()), 0, 1e-8);
    const double back = 0.5 * law.pressure[k] / law.unloading[k];
    squeeze(-back);
    off.compare(pressure_of(point.stress()), 0.5 * law.pressure[k], law.pressure[k], std::to_string(k));
    squeeze(back);
  }
}

/// lambda = B3 times the volume that has opened, and the pressure is -FT eta(lambda).
TEST_P(ThreeSurfaceConcrete, TriaxialTensionOpensByItsOwnDamage) {
  const model::Material material = damaged_concrete();
  const auto& law = std::get<model::ThreeSurfaceConcrete>(material.law);
  const double bulk = bulk_of(material);
  test::Largest off("concrete, tension in all directions: pressure behind the maximum, error [MPa]",
                    "-FT eta(B3 volume of cracks)", 0.03);
  SolidDriver<double> point(material, GetParam());
  constexpr double third = 2e-7;
  double lowest = 0;
  for (int i = 0; i < 1400; ++i) {
    point.apply({third, third, third, 0, 0, 0});
    const double pressure = pressure_of(point.stress());
    lowest = std::min(lowest, pressure);
    const double lambda = law.opening_damage * (3 * third * (i + 1) + pressure / bulk);
    if (lambda < law.damage[4]) continue;
    std::size_t k = 4;
    while (lambda > law.damage[k + 1]) ++k;
    const double eta = law.share[k] + (law.share[k + 1] - law.share[k]) * (lambda - law.damage[k]) /
                                          (law.damage[k + 1] - law.damage[k]);
    off.compare(pressure, -law.tensile_strength * eta);
  }
  EXPECT_NEAR(lowest, -law.tensile_strength, 1e-9);
  EXPECT_NEAR(pressure_of(point.stress()), 0, 1e-9);
}

TEST_P(ThreeSurfaceConcrete, TearingTakesTheSameEnergyOfLargerElements) {
  const model::Material material = damaged_concrete();
  const auto& law = std::get<model::ThreeSurfaceConcrete>(material.law);
  const double stored = law.tensile_strength * law.tensile_strength / (2 * law.youngs_modulus);
  const auto torn_energy = [&](double length) {
    SolidCorners corners = unit_corners();
    for (auto& corner : corners) corner = length * corner;
    SolidDriver<double> point(material, GetParam(), 1, corners);
    double work = 0;
    double at_peak = 0;
    double most = 0;
    for (int i = 0; i < 450; ++i) {
      press_with_held_sides(point, i < 200 ? 1e-6 : 4e-6, 0);
      work += point.energy();
      if (point.stress()[0] > most) {
        most = point.stress()[0];
        at_peak = work;
      }
    }
    EXPECT_LT(std::fabs(point.stress()[0]), 1e-6);
    return work - at_peak + stored;
  };
  test::Largest off("concrete, torn elements of 1 to 2 LOCWIDTH: energy behind the maximum per area, error",
                    "the same at all sizes", 0.02);
  const double one = 25.4 * torn_energy(25.4);
  off.compare(38.1 * torn_energy(38.1), one, one, "38.1");
  off.compare(50.8 * torn_energy(50.8), one, one, "50.8");
  EXPECT_NEAR(25.4 * torn_energy(10), one, 1e-6 * one);
}

/// Sheared without a change of volume before the maximum: the pressure rises by what the dilation takes.
TEST_P(ThreeSurfaceConcrete, DilationIsAShareOfTheNormalOne) {
  model::Material material = damaged_concrete();
  const auto slope = [](const model::ThreeSurfaceConcrete::Surface& of, double p) {
    return of.first / std::pow(of.first + of.second * p, 2);
  };
  test::Largest off("concrete, sheared at constant volume: rise of the pressure over that of OMEGA, error",
                    "OMEGA K F'(p) times the plastic strain", 0.01);
  for (const double dilatancy : {0.0, 0.4, 0.8}) {
    law_of(material).dilatancy = dilatancy;
    const model::ThreeSurfaceConcrete& law = law_of(material);
    const double bulk = bulk_of(material);
    const double shear = 1.5 * bulk * (1 - 2 * law.poissons_ratio) / (1 + law.poissons_ratio);
    SolidDriver<double> point(material, GetParam());
    press_all(point, 18, bulk);
    Six before = point.stress();
    for (int i = 0; i < 4000; ++i) {
      constexpr double e = 5e-7;
      point.apply({-2 * e, e, e, 0, 0, 0});
      const Six now = point.stress();
      const double p = pressure_of(now);
      const double first = hyperbola(law.yield, p);
      const double share = (equivalent(now) - first) / (hyperbola(law.maximum, p) - first);
      const double plastic = 2 * e - (equivalent(now) - equivalent(before)) / (3 * shear);
      if (share > 0.98 || p > 25) break;
      const double normal = (1 - share) * slope(law.yield, p) + share * slope(law.maximum, p);
      if (share > 0.5)
        off.compare((p - pressure_of(before)) / bulk, dilatancy * normal * plastic, normal * plastic);
      before = now;
    }
  }
}

TEST_P(ThreeSurfaceConcrete, StressTurnsWithTheObserver) {
  const Matrix turn = turn_about({0.36, 0.48, 0.8}, 0.7);
  SolidDriver<double> one(damaged_concrete(), GetParam());
  SolidDriver<double> other(damaged_concrete(), GetParam());
  test::Largest off("concrete of three surfaces, another observer: stress, error [MPa]", "turned", 1e-8);
  for (int i = 0; i < 300; ++i) {
    const Six strain{3e-6, -1e-5 * std::cos(0.05 * i), -1e-6, 3e-6, 2e-6, -1e-6};
    one.apply(strain);
    other.apply(rotated(strain, turn, 0.5));
    const Six expected = rotated(one.stress(), turn);
    for (int c = 0; c < 6; ++c) off.compare(other.stress()[c], expected[c]);
  }
}

/// A body that turns as it is loaded has the stress of one that does not, turned, but for the volume: that of
/// a step with strain and rotation is exact to second order alone.
TEST_P(ThreeSurfaceConcrete, HistoryTurnsWithTheBody) {
  SolidDriver<double> still(damaged_concrete(), GetParam());
  SolidDriver<double> turning(damaged_concrete(), GetParam());
  const std::array<double, 3> axis{0.6, 0, 0.8};
  constexpr double angle = 0.02;
  const Matrix half = turn_about(axis, angle / 2);
  Matrix at{};
  test::Largest off("concrete of three surfaces that turns while it is loaded: stress, error [MPa]",
                    "at rest, turned", 0.005);
  turning.set_turn(0, 0, turn_about(axis, angle));
  for (int i = 0; i < 150; ++i) {
    const Six strain{2e-6, -1e-5 * std::cos(0.05 * i), -1e-6, 3e-6, 2e-6, 0};
    still.apply(strain);
    // Strains are those of the middle of the step.
    turning.apply(rotated(strain, after(half, at), 0.5));
    at = after(turn_about(axis, angle), at);
    const Six expected = rotated(still.stress(), at);
    for (int c = 0; c < 6; ++c) off.compare(turning.stress()[c], expected[c]);
  }
}

TEST_P(ThreeSurfaceConcrete, FloatAgreesWithDouble) {
  for (const bool crush : {false, true}) {
    SolidDriver<float> coarse(damaged_concrete(), GetParam());
    SolidDriver<double> exact(damaged_concrete(), GetParam());
    test::Largest off(std::string("concrete of three surfaces in single precision, ") +
                          (crush ? "crushed under pressure" : "torn") + ": stress, error [MPa]",
                      "double precision", crush ? 0.3 : 0.02);
    for (int i = 0; i < 4000; ++i) {
      const Six strain = crush ? Six{-4e-6, -3e-6, -3.5e-6, 1e-6, 0, 0} : Six{2e-7, -4e-8, -5e-8, 3e-8, 0, 0};
      coarse.apply(strain);
      exact.apply(strain);
      for (int c = 0; c < 6; ++c) off.compare(coarse.stress()[c], exact.stress()[c]);
    }
  }
}

/// Random strains of any size keep the numbers finite, and instruction sets of the same rounding the bits.
template <class Real>
void walk_three_surfaces(double size) {
  std::vector<std::vector<Real>> bits;
  for (const Isa isa : available_isas()) {
    SolidDriver<Real> driver(damaged_concrete(), isa, 3);
    for (int i = 0; i < 40; ++i) random_walk(driver, i, 1, size, 1e-5);
    bits.push_back(driver.bits());
  }
  for (const Real number : bits[0]) ASSERT_TRUE(std::isfinite(number));
  test::expect_alike(bits, [](const auto& a, const auto& b) { return same_bits(a, b); });
}
TEST(ThreeSurfaceConcreteWalk, InstructionSetsWithTheSameRoundingGiveTheSameBits) {
  for (const double size : {1e-6, 1e-4, 3e-3}) {
    walk_three_surfaces<double>(size);
    walk_three_surfaces<float>(size);
  }
}

TEST(ThreeSurfaceConcreteConstants, AreChecked) {
  const auto refused = [](const auto& change) {
    model::Material material = damaged_concrete();
    change(law_of(material));
    EXPECT_THROW(solid_material_constants(material), Error);
  };
  EXPECT_NO_THROW(solid_material_constants(damaged_concrete()));
  refused([](model::ThreeSurfaceConcrete& law) { law.tensile_strength = 0; });
  refused([](model::ThreeSurfaceConcrete& law) { law.tensile_strength = 16; });
  refused([](model::ThreeSurfaceConcrete& law) { law.residual.first = 0; });
  refused([](model::ThreeSurfaceConcrete& law) { law.yield.constant = 0; });
  refused([](model::ThreeSurfaceConcrete& law) { law.dilatancy = 1.1; });
  refused([](model::ThreeSurfaceConcrete& law) { law.width = 0; });
  refused([](model::ThreeSurfaceConcrete& law) { law.damage[3] = 0; });
  refused([](model::ThreeSurfaceConcrete& law) { law.share[4] = 0.995; });
  refused([](model::ThreeSurfaceConcrete& law) { law.pressure[0] = 1; });
  refused([](model::ThreeSurfaceConcrete& law) { law.tension_rates = {{0, 1}, {1, 2}}; });
  refused([](model::ThreeSurfaceConcrete& law) {
    law.tension_rates = law.compression_rates = {{0, 1}, {1, 0.9}};
  });
  refused([](model::ThreeSurfaceConcrete& law) { law.unloading[8] = law.unloading[9] = 1; });
}

/// The numbers that are published for 45.4 MPa.
TEST(ThreeSurfaceConcreteDefaults, AreThePublishedOnes) {
  const model::ThreeSurfaceConcrete law =
      model::three_surface_concrete(strength, 0.19, psi_per_mpa, 1 / 25.4);
  test::Largest off("concrete by f'c of 45.4 MPa: parameters over the published ones, error",
                    "L.E. Schwer & L.J. Malvar (2005)", 2e-3);
  off.compare(law.maximum.constant, 13.42, 13.42, "A0");
  off.compare(law.maximum.second, 1.780e-3, 1.780e-3, "A2");
  off.compare(law.yield.constant, 10.13, 10.13, "A0Y");
  off.compare(law.yield.second, 5.676e-3, 5.676e-3, "A2Y");
  off.compare(law.residual.second, 2.608e-3, 2.608e-3, "A2F");
  off.compare(law.tensile_strength, 3.8274, 3.8274, "FT");
  off.compare(model::unconfined_strength(law.maximum), strength, strength, "f'c");
  off.compare(model::unconfined_strength(law.yield), 20.36, 20.36, "yield in compression");
  // The formulas at two rates, of 45.4 MPa: below the knees and above.
  model::ThreeSurfaceConcrete fast = law;
  model::set_rate_factors(fast, strength, psi_per_mpa, 1);
  const auto at = [](const model::ThreeSurfaceConcrete::RateFactors& of, double rate) {
    return model::value_at({of.rate, of.factor}, rate);
  };
  const double delta = 1 / (1 + 0.8 * 45.4);
  const double alpha = 1 / (5 + 0.9 * 45.4);
  off.compare(at(fast.tension_rates, 1e-2), std::pow(1e4, delta), 1, "tension, slow");
  off.compare(at(fast.tension_rates, 100), std::pow(10, 6 * delta - 2) * std::cbrt(1e8), 10, "tension, fast");
  off.compare(at(fast.compression_rates, 3e-2), std::pow(1e3, 1.026 * alpha), 1, "compression, slow");
  off.compare(at(fast.compression_rates, 300), std::pow(10, 6.156 * alpha - 2) * std::cbrt(1e7), 10,
              "compression, fast");
  // In Pa and m.
  const model::ThreeSurfaceConcrete other =
      model::three_surface_concrete(strength * 1e6, 0.19, psi_per_mpa * 1e-6, 1 / 0.0254);
  off.compare(other.tensile_strength, 1e6 * law.tensile_strength, 1e6 * law.tensile_strength);
  off.compare(other.pressure[5], 1e6 * law.pressure[5], 1e6 * law.pressure[5]);
  off.compare(other.width, 1e-3 * law.width, 1e-3 * law.width);
}

}  // namespace
}  // namespace crumple::materials::testing::three_surface_concrete_test
