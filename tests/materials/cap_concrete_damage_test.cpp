// SPDX-License-Identifier: BSD-3-Clause
// Concrete with a smooth cap: what damage takes and what rates add, against closed forms.
#include <gtest/gtest.h>

#include "materials/concrete_cases.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::cap_concrete_damage_test {
namespace {

class CapConcreteDamage : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, CapConcreteDamage, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

SolidCorners cube(double side) {
  SolidCorners corners = unit_corners();
  for (math::Vec3& corner : corners) corner = side * corner;
  return corners;
}

/// Strength and work per area of an element that is strained along one axis until nothing is left.
struct Separation {
  double strength = 0;
  double work = 0;
};
Separation separated(const model::Material& material, Isa isa, double side, double first, double last) {
  SolidDriver<double> point(material, isa, 1, cube(side));
  Separation found;
  double step = first;
  for (double strain = 0; std::fabs(strain) < std::fabs(last); strain += step) {
    if (std::fabs(strain) > 400 * std::fabs(first)) step *= 1.01;
    press_along_x(point, step, 0);
    found.strength = std::max(found.strength, std::fabs(point.stress()[0]));
    found.work += side * point.energy();
  }
  return found;
}

TEST_P(CapConcreteDamage, TearingTakesTheFractureEnergyAtEverySize) {
  const model::Material material = concrete();
  const auto& law = std::get<model::CapConcrete>(material.law);
  const ConcreteSurface surface{law};
  // s / sqrt(3) = F(-s) / 2
  double low = 0;
  double high = 10;
  for (int i = 0; i < 100; ++i) {
    const double s = 0.5 * (low + high);
    (s / std::sqrt(3.0) < 0.5 * surface.strength(-s) ? low : high) = s;
  }
  test::Largest strength("concrete, uniaxial tension: strength, error [MPa]", "failure surface", 1e-6);
  test::Largest energy("concrete, uniaxial tension, elements of 10 to 40 mm: fracture energy over GFT, error",
                       "GFT", 0.02);
  for (const double side : {10.0, 20.0, 40.0}) {
    const Separation found =
        separated(material, GetParam(), side, 5e-7, 30 * law.tension_energy / low / side);
    strength.compare(found.strength, low);
    const double elastic = 0.5 * low * low / law.youngs_modulus * side;
    // A thousandth of the strength stays.
    const double rest = 0.001 * (30 - 1) * law.tension_energy;
    energy.compare(found.work - elastic - rest, law.tension_energy, law.tension_energy, std::to_string(side));
  }
}

TEST_P(CapConcreteDamage, CrushingTakesTheFractureEnergyAtEverySize) {
  const model::Material material = concrete();
  const auto& law = std::get<model::CapConcrete>(material.law);
  test::Largest energy(
      "concrete, uniaxial compression, elements of 50 to 200 mm: fracture energy over GFC, error", "GFC",
      0.02);
  for (const double side : {50.0, 100.0, 200.0}) {
    const Separation found =
        separated(material, GetParam(), side, -5e-6, 15 * law.compression_energy / 30 / side);
    const double elastic = 0.5 * found.strength * found.strength / law.youngs_modulus * side;
    energy.compare(found.work - elastic, law.compression_energy, law.compression_energy,
                   std::to_string(side));
  }
}

/// -Li2(-b) by its series in 1 / b (L. Lewin, Polylogarithms and Associated Functions (1981), section 1.3).
double negative_dilog(double b) {
  const double pi = std::acos(-1.0);
  double sum = pi * pi / 6 + 0.5 * std::log(b) * std::log(b);
  for (int k = 1; k < 200; ++k) sum += (k % 2 == 1 ? -1 : 1) * std::pow(b, -k) / (k * k);
  return sum;
}

/// Damage of a path of strains whose stress without damage is known, once more from its equations.
struct DamageForm {
  model::CapConcrete law;
  double length;
  double start = 0;
  double damage = 0;

  static double softened(double rate, double past, double shape, double most) {
    return most / shape * ((1 + shape) / (1 + shape * std::exp(-rate * past)) - 1);
  }
  void ductile(const Six& stress, const Six& strain, bool dilates) {
    double energy = 0;
    for (int c = 0; c < 6; ++c) energy += 0.5 * stress[c] * strain[c];
    const double driver = std::sqrt(std::max(energy, 0.0));
    if (start == 0 && dilates) start = driver;
    if (start == 0 || driver <= start) return;
    const double along = trace_of(stress) / equivalent(stress);
    const double held = law.shear_energy + std::pow(std::min(along, 1.0), law.compression_power) *
                                               (law.compression_energy - law.shear_energy);
    const double b = law.ductile_shape;
    // held / 4 L = start (1 + B) ln(1 + B) / (B A) - (1 + B) Li2(-B) / (B A^2)
    const double p = (1 + b) / b * negative_dilog(b);
    const double q = start * (1 + b) / b * std::log(1 + b);
    const double g = held / (4 * length);
    double rate = (q + std::sqrt(q * q + 4 * p * g)) / (2 * g);
    const double most = std::min(0.999, std::pow(1 / std::max(along, 1.0), 1.5));
    rate *= std::pow(most + 0.001, law.pressure_power);
    damage = std::max(damage, softened(rate, driver - start, b, most));
  }
  void brittle(const Six& stress, double strain, bool dilates) {
    const double driver = std::sqrt(law.youngs_modulus) * strain;
    if (start == 0 && dilates) start = driver;
    if (start == 0 || driver <= start) return;
    const double along = std::min(-trace_of(stress) / equivalent(stress), 1.0);
    const double held =
        law.shear_energy + std::pow(along, law.tension_power) * (law.tension_energy - law.shear_energy);
    const double d = law.brittle_shape;
    const double rate = start * length * (1 + d) / (d * held) * std::log(1 + d);
    damage = std::max(damage, softened(rate, driver - start, d, 0.999));
  }
};

/// Both materials have the same stress without damage, so that their ratio is what is left.
TEST_P(CapConcreteDamage, DuctileDamageFollowsItsEquationsUnderConfinement) {
  for (const double confined : {0.1, 2.0}) {
    model::Material soft = concrete();
    concrete_law(soft).cap_start = 1e5;
    concrete_law(soft).pressure_power = 0.5;
    concrete_law(soft).shear_energy = 5 * concrete_law(soft).tension_energy;
    constexpr double side = 80;
    SolidDriver<double> worn(soft, GetParam(), 1, cube(side));
    SolidDriver<double> whole(uncapped_concrete(), GetParam(), 1, cube(side));
    DamageForm form{concrete_law(soft), side};
    test::Largest off("concrete confined by " + std::to_string(confined).substr(0, 4) +
                          " of its strain: share of the stress that is left, error",
                      "equations of ductile damage", 1e-6);
    Six strain{};
    for (int i = 0; i < 2000; ++i) {
      const Six more{-1e-5, confined * 1e-6, confined * 0.5e-6, 1e-6, 0, 0};
      const double before = trace_of(whole.stress());
      worn.apply(more);
      whole.apply(more);
      for (int c = 0; c < 6; ++c) strain[c] += more[c];
      const Six s = whole.stress();
      const auto& law = concrete_law(soft);
      const double elastic = before - 3 * law.bulk_modulus * (more[0] + more[1] + more[2]);
      form.ductile(s, strain, trace_of(s) > elastic + 1e-9);
      off.compare(worn.stress()[0] / s[0], 1 - form.damage, 1, std::to_string(i));
    }
    EXPECT_GT(form.damage, 0.2);
    EXPECT_LT(form.damage, 0.98);
  }
}

TEST_P(CapConcreteDamage, BrittleDamageFollowsItsEquationsUnderTensionAndShear) {
  model::Material soft = concrete();
  concrete_law(soft).shear_energy = 3 * concrete_law(soft).tension_energy;
  concrete_law(soft).tension_power = 2;
  constexpr double side = 30;
  SolidDriver<double> worn(soft, GetParam(), 1, cube(side));
  SolidDriver<double> whole(tough_concrete(), GetParam(), 1, cube(side));
  DamageForm form{concrete_law(soft), side};
  test::Largest off("concrete under tension and shear: share of the stress that is left, error",
                    "equations of brittle damage", 1e-6);
  for (int i = 1; i <= 1500; ++i) {
    const Six more{1e-6, 4e-7, 3e-7, 8e-7, 0, 0};
    const double before = trace_of(whole.stress());
    worn.apply(more);
    whole.apply(more);
    // Largest principal strain in the plane.
    const double middle = 0.5 * (more[0] + more[1]);
    const double greatest = i * (middle + std::hypot(0.5 * (more[0] - more[1]), 0.5 * more[3]));
    const Six s = whole.stress();
    const double elastic = before - 3 * concrete_law(soft).bulk_modulus * (more[0] + more[1] + more[2]);
    form.brittle(s, greatest, trace_of(s) > elastic + 1e-9);
    off.compare(worn.stress()[0] / s[0], 1 - form.damage, 1, std::to_string(i));
  }
  EXPECT_GT(form.damage, 0.5);
}

/// Axial stiffness over Young's modulus after tearing, back in tension and under pressure.
std::array<double, 2> stiffness_after_tearing(const model::Material& material, Isa isa) {
  SolidDriver<double> point(material, isa, 1, cube(20));
  for (int i = 0; i < 1000; ++i) press_along_x(point, 1e-6, 0);
  std::array<double, 2> found{};
  for (int k = 0; k < 2; ++k) {
    const double before = point.stress()[0];
    press_along_x(point, -1e-6, 0);
    found[k] = (before - point.stress()[0]) * 1e6 / std::get<model::CapConcrete>(material.law).youngs_modulus;
    for (int i = 0; i < 200; ++i) press_along_x(point, -1e-6, 0);
  }
  return found;
}

TEST_P(CapConcreteDamage, CracksCloseAsRecoverySays) {
  test::Largest off("concrete torn and pressed: stiffness over what RECOV leaves, error", "RECOV", 1e-6);
  for (const double kept : {0.0, 0.4, 1.0}) {
    model::Material material = concrete();
    concrete_law(material).kept_damage = kept;
    const auto [pulled, pressed] = stiffness_after_tearing(material, GetParam());
    EXPECT_GT(pulled, 0.1);
    EXPECT_LT(pulled, 0.6);
    off.compare(pressed, 1 - kept * (1 - pulled), 1, std::to_string(kept));
  }
  // Pressed, but still longer than at first.
  model::Material material = concrete();
  concrete_law(material).recovers_by_volume = true;
  const auto [pulled, pressed] = stiffness_after_tearing(material, GetParam());
  off.compare(pressed, pulled, 1, "by volume");
}

TEST_P(CapConcreteDamage, DamageFromTheStartTakesItsShare) {
  model::Material material = concrete();
  concrete_law(material).first_damage = 0.3;
  test::Largest off("concrete with PRED of 0.3: first stiffness over 0.7 E, error", "0.7", 1e-9);
  for (const double axial : {-1e-6, 1e-6}) {
    SolidDriver<double> point(material, GetParam());
    // Damage acts from the first step on.
    press_along_x(point, axial, 0);
    off.compare(point.stress()[0], 0.7 * axial * concrete_law(material).youngs_modulus, point.stress()[0]);
  }
}

TEST_P(CapConcreteDamage, PointsFailAtTheStrainOfErosion) {
  for (const double limit : {0.0, 0.02}) {
    model::Material material = concrete();
    concrete_law(material).erodes = true;
    concrete_law(material).erosion_strain = limit;
    SolidDriver<double> point(material, GetParam(), 1, cube(20));
    double damage = 0;
    double strain = 0;
    while (strain < 0.05 && (strain == 0 || point.intact())) {
      point.apply({1e-5, 0, 0, 0, 0, 0});
      strain += 1e-5;
      damage = point.item("brittle_damage");
    }
    EXPECT_GT(damage, 0.99);
    if (limit > 0)
      EXPECT_NEAR(strain, limit, 1.1e-5);
    else
      EXPECT_NEAR(damage, 0.99, 2e-4);
    EXPECT_EQ(point.stress()[0], 0);
  }
  SolidDriver<double> kept(concrete(), GetParam(), 1, cube(20));
  kept.apply({0.3, 0, 0, 0, 0, 0});
  kept.apply({0.3, 0, 0, 0, 0, 0});
  EXPECT_EQ(kept.item("failed"), 0);
}

/// What rates add is eta (C : strain rate - rate of the stress without them), once that is steady.
TEST_P(CapConcreteDamage, RatesAddTheStressOfTheirFluidity) {
  test::Largest off("concrete at 0.1 to 100 /s: what the rate adds over the closed form, error",
                    "E rate eta of Duvaut & Lions, up to OVERT and OVERC", 2e-3);
  for (const double rate : {0.1, 1.0, 10.0, 100.0})
    for (const double sign : {1.0, -1.0}) {
      model::Material slow = uncapped_concrete();
      auto& both = concrete_law(slow);
      // The same strength and the same fluidity at every pressure: what goes on is steady.
      both.compression = {20, 0, 0, 0};
      (sign > 0 ? both.compression_rate : both.tension_rate) =
          sign > 0 ? both.tension_rate : both.compression_rate;
      if (rate > 50) both.compression_rate.limit = both.tension_rate.limit = 4;
      model::Material fast = slow;
      concrete_law(fast).has_rate_effects = true;
      const auto& law = concrete_law(slow);
      SolidDriver<double> still(slow, GetParam());
      SolidDriver<double> quick(fast, GetParam());
      const double nu = law.poissons_ratio;
      const auto& fluidity = sign > 0 ? law.tension_rate : law.compression_rate;
      const double effective = 2.0 / 3 * (1 + nu) * rate;
      const double eta = std::min(fluidity.coefficient / std::pow(effective, fluidity.exponent),
                                  fluidity.limit / (law.youngs_modulus * effective));
      // Twenty times the fluidity, in steps that resolve it.
      const double step = eta / 50;
      const double strain = sign * rate * step;
      double before = 0;
      int steps = 0;
      for (double sum = 0; steps < 1000 || std::fabs(sum) < 4e-3; sum += strain, ++steps) {
        before = still.stress()[0];
        still.apply({strain, -nu * strain, -nu * strain, 0, 0, 0}, step);
        quick.apply({strain, -nu * strain, -nu * strain, 0, 0, 0}, step);
        ASSERT_LT(steps, 1000000);
      }
      const double drift = (still.stress()[0] - before) / step;
      const double expected = eta * (law.youngs_modulus * sign * rate - drift);
      off.compare(quick.stress()[0] - still.stress()[0], expected, expected, std::to_string(sign * rate));
    }
}

/// Faster concrete is stronger, and its cracks take more energy.
TEST_P(CapConcreteDamage, RatesRaiseStrengthAndEnergy) {
  model::Material material = concrete();
  concrete_law(material).has_rate_effects = true;
  const auto run = [&](double rate) {
    SolidDriver<double> point(material, GetParam(), 1, cube(20));
    double strength = 0;
    double work = 0;
    double step = 2e-6;
    for (double strain = 0; strain < 0.02; strain += step) {
      if (strain > 4e-4) step *= 1.01;
      press_along_x(point, step, 0, step / rate);
      strength = std::max(strength, point.stress()[0]);
      work += 20 * point.energy();
    }
    return std::pair(strength, work);
  };
  const auto [slow, slow_work] = run(1e-5);
  const auto [fast, fast_work] = run(1);
  const auto& law = concrete_law(material);
  const double added = law.youngs_modulus * law.tension_rate.coefficient;  // at 1 /s
  test::verified("concrete, uniaxial tension at 1 /s: strength over E rate eta more than at rest, error",
                 "f't + E rate eta")
      .below(std::fabs((fast - slow) / added - 1), 0.25);
  EXPECT_NEAR(fast_work / slow_work, 1 + added / slow, 0.3 * added / slow);
}

}  // namespace
}  // namespace crumple::materials::testing::cap_concrete_damage_test
