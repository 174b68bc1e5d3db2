// SPDX-License-Identifier: BSD-3-Clause
// Sheet metal by Hill (1948) with normal anisotropy and by Barlat & Lian (1989): R values, yield stresses,
// and von Mises as a special case.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "base/error.hpp"
#include "materials/point_driver.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::sheet_metal_test {
namespace {

struct Ratios {
  double r00, r45, r90;
};
constexpr Ratios isotropic{1, 1, 1};
constexpr Ratios aluminium{0.71, 0.58, 0.7};
constexpr Ratios steel{1.8, 1.3, 2.2};

model::Material sheet(bool is_normal, double exponent, const Ratios& r) {
  model::Material material;
  material.id = is_normal ? 37 : 36;
  material.density = 2.7e-9;
  model::SheetPlasticity law;
  law.youngs_modulus = youngs_modulus;
  law.poissons_ratio = poissons_ratio;
  law.is_normal = is_normal;
  law.yield_exponent = exponent;
  law.r00 = r.r00;
  law.r45 = r.r45;
  law.r90 = r.r90;
  law.plastic_strain = {0, 0.05, 0.3};
  law.yield_stress = {250, 300, 350};
  material.law = law;
  return material;
}
model::SheetPlasticity& law_of(model::Material& material) {
  return std::get<model::SheetPlasticity>(material.law);
}
LaminaAxes axes_at(double angle) {
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, angle, 1, 0};
}

template <class Real>
PointDriver<Real> driver_of(const model::Material& material, Isa isa, double angle, int points = 1) {
  PointDriver<Real> point(material, isa, points);
  point.prepare(material.law, axes_at(angle));
  return point;
}

/// Barlat & Lian's equivalent stress by the principal values of the scaled stress.
double barlat(const model::SheetPlasticity& law, double p, double x, double y, double s) {
  const double along = law.r00 / (1 + law.r00);
  const double across = law.r90 / (1 + law.r90);
  const double c = 2 * std::sqrt(along * across);
  const double h = std::sqrt(along / across);
  const double mean = (x + h * y) / 2;
  const double radius = std::hypot((x - h * y) / 2, p * s);
  const double m = law.yield_exponent;
  return std::pow(((2 - c) * (std::pow(std::fabs(mean + radius), m) + std::pow(std::fabs(mean - radius), m)) +
                   c * std::pow(2 * radius, m)) /
                      2,
                  1 / m);
}
/// The factor on the shear, so that the ratio of strains of a strip at 45 degrees is R45: by differences.
double shear_factor(const model::SheetPlasticity& law) {
  const auto ratio = [&](double p) {
    const double e = 1e-5;
    const double thinning =
        (barlat(law, p, 0.5 + e, 0.5 + e, 0.5) - barlat(law, p, 0.5 - e, 0.5 - e, 0.5)) / (2 * e);
    return barlat(law, p, 0.5, 0.5, 0.5) / thinning - 1;
  };
  double low = 0.1;
  double high = 10;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (ratio(middle) < law.r45 ? low : high) = middle;
  }
  return low;
}

class Sheet : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, Sheet, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

struct Strip {
  double stress, plastic, ratio;
};
/// Pulls a strip whose axis a is turned by `angle` from the direction of pull; all of the lateral stresses
/// vanish.
template <class Real>
Strip pulled(const model::Material& material, Isa isa, double angle, int steps, double size) {
  PointDriver<Real> point = driver_of<Real>(material, isa, -angle);
  double width = 0;
  double thickness = 0;
  double length = 0;
  // Newton on width and shear by differences.
  double yy = -0.4 * size;
  double xy = 0;
  for (int i = 0; i < steps; ++i) {
    for (int iteration = 0; iteration < 12; ++iteration) {
      const auto stress_of = [&](double b, double g) {
        PointDriver<Real> copy = point;
        copy.apply({size, b, g, 0, 0});
        return copy.stress();
      };
      const Five at = stress_of(yy, xy);
      const double e = 1e-9;
      const Five by_y = stress_of(yy + e, xy);
      const Five by_s = stress_of(yy, xy + e);
      const double a = (by_y[1] - at[1]) / e;
      const double b = (by_s[1] - at[1]) / e;
      const double c = (by_y[2] - at[2]) / e;
      const double d = (by_s[2] - at[2]) / e;
      yy -= (d * at[1] - b * at[2]) / (a * d - b * c);
      xy -= (a * at[2] - c * at[1]) / (a * d - b * c);
    }
    point.apply({size, yy, xy, 0, 0});
    length += size;
    width += yy;
    thickness += point.thickness_strain();
  }
  const double elastic = -poissons_ratio * point.stress()[0] / youngs_modulus;
  EXPECT_NEAR(point.stress()[1], 0, 1e-6);
  EXPECT_NEAR(point.stress()[2], 0, 1e-6);
  return {point.stress()[0], length - point.stress()[0] / youngs_modulus,
          (width - elastic) / (thickness - elastic)};
}

/// Width over thickness of a strip gives R back at 0, 45 and 90 degrees; the yield stress along it is that of
/// the equivalent stress, hardened by the plastic work.
TEST_P(Sheet, StripsHaveTheRatiosAndYieldStressesOfTheirDirections) {
  test::Largest ratios("Barlat & Lian, strips at 0, 45 and 90 degrees, m 2 to 12: R, error", "R00, R45, R90",
                       1e-7);
  test::Largest stresses(
      "Barlat & Lian, strips at 0, 30, 45 and 90 degrees: yield stress over that along a, error",
      "criterion by principal values", 1e-8);
  for (const Ratios& r : {isotropic, aluminium, steel})
    for (const double exponent : {2.0, 6.0, 8.0, 12.0}) {
      auto material = sheet(false, exponent, r);
      const auto& law = law_of(material);
      const double p = shear_factor(law);
      for (const double degrees : {0.0, 30.0, 45.0, 90.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        const Strip strip = pulled<double>(material, GetParam(), angle, 6, 0.002);
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const double size = barlat(law, p, c * c, s * s, c * s);
        // Plastic work: the equivalent strain is the one along the strip over this size.
        const double strength = (250 + 1000 * strip.plastic / size) / size;
        const std::string place = "m " + std::to_string(exponent) + " at " + std::to_string(degrees);
        stresses.compare(strip.stress, strength, 250, place);
        if (degrees != 30)
          ratios.compare(strip.ratio, degrees == 0 ? r.r00 : degrees == 45 ? r.r45 : r.r90, 1, place);
      }
    }
}

TEST_P(Sheet, NormalAnisotropyHasOneRatio) {
  test::Largest ratios("Hill with normal anisotropy, strips: R, error", "R", 1e-7);
  test::Largest stresses(
      "Hill with normal anisotropy: strips, equal biaxial tension, shear: yield, relative error", "Hill 1948",
      1e-9);
  for (const double r : {0.6, 1.0, 2.5}) {
    const auto material = sheet(true, 0, {r, r, r});
    const Strip strip = pulled<double>(material, GetParam(), 0, 6, 0.002);
    ratios.compare(strip.ratio, r);
    stresses.compare(strip.stress, 250 + 1000 * strip.plastic, 250);
    PointDriver<double> biaxial(material, GetParam());
    PointDriver<double> sheared(material, GetParam());
    for (int i = 0; i < 5; ++i) {
      biaxial.apply({0.001, 0.001, 0, 0, 0});
      sheared.apply({0, 0, 0.003, 0, 0});
    }
    const double yields = 250 + 1000 * biaxial.item("plastic_strain");
    stresses.compare(biaxial.stress()[0], yields * std::sqrt((r + 1) / 2), yields);
    const double shear = 250 + 1000 * sheared.item("plastic_strain");
    stresses.compare(sheared.stress()[2], shear * std::sqrt((r + 1) / (2 * (2 * r + 1))), shear);
  }
}

/// With m = 2 and R = 1 both are von Mises: the same path as by *MAT_PIECEWISE_LINEAR_PLASTICITY.
TEST_P(Sheet, VonMisesIsASpecialCase) {
  const std::string walk =
      "random strains in the plane, sheet metal with R = 1 beside *MAT_024: stress, error over 250 MPa, ";
  test::Largest by_barlat(walk + "Barlat & Lian with m = 2", "*MAT_024 of this code", 1e-10);
  test::Largest by_hill(walk + "Hill", "*MAT_024 of this code", 1e-10);
  const auto mises = tabulated({0, 0.05, 0.3}, {250, 300, 350});
  const auto barlat_sheet = sheet(false, 2, isotropic);
  const auto hill_sheet = sheet(true, 0, isotropic);
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  PointDriver<double> exact(mises, GetParam());
  PointDriver<double> turned = driver_of<double>(barlat_sheet, GetParam(), 0.4);
  PointDriver<double> hill(hill_sheet, GetParam());
  for (int i = 0; i < 300; ++i) {
    const double size = 2e-4 * std::exp2(5 * uniform(generator));
    const Five strain{size * uniform(generator), size * uniform(generator), size * uniform(generator), 0, 0};
    exact.apply(strain);
    turned.apply(strain);
    hill.apply(strain);
    for (int k = 0; k < 3; ++k) {
      by_barlat.compare(turned.stress()[k], exact.stress()[k], 250, std::to_string(i));
      by_hill.compare(hill.stress()[k], exact.stress()[k], 250, std::to_string(i));
    }
    by_barlat.compare(turned.item("plastic_strain"), exact.item("plastic_strain"));
    by_hill.compare(hill.item("plastic_strain"), exact.item("plastic_strain"));
    by_barlat.compare(turned.thickness_strain(), exact.thickness_strain());
    by_barlat.compare(turned.energy(), exact.energy(), 1);
  }
}

/// From wherever, the stress is on the yield surface, and the plastic strain is along its normal.
template <class Real>
double worst_excess(const model::Material& material, Isa isa, double p) {
  PointDriver<Real> driver = driver_of<Real>(material, isa, 0, 3);
  const auto& law = std::get<model::SheetPlasticity>(material.law);
  double worst = 0;
  for (int i = 0; i < 30; ++i) {
    random_walk(driver, i, 1, 2e-4, 1);
    for (Index e = 0; e < tile_lanes; ++e)
      for (int point = 0; point < 3; ++point) {
        const Five s = driver.stress(e, point);
        const double plastic = driver.item("plastic_strain", e, point);
        const double yield =
            plastic < 0.05 ? 250 + 1000 * plastic : std::min(300 + 200 * (plastic - 0.05), 350.0);
        worst = test::larger_of(worst, barlat(law, p, s[0], s[1], s[2]) / yield - 1);
      }
  }
  return worst;
}

TEST_P(Sheet, YieldFunctionIsKeptAfterEveryStep) {
  const std::string walk = "Barlat & Lian, m 2 to 20, random strains: excess over the yield stress, ";
  test::Largest doubles(walk + "double precision", "criterion by principal values", 1e-9);
  test::Largest singles(walk + "single precision", "criterion by principal values", 5e-6);
  for (const Ratios& r : {isotropic, aluminium, steel})
    for (const double exponent : {2.0, 6.0, 8.0, 20.0}) {
      auto material = sheet(false, exponent, r);
      const double p = shear_factor(law_of(material));
      doubles.add(worst_excess<double>(material, GetParam(), p), std::to_string(exponent));
      singles.add(worst_excess<float>(material, GetParam(), p), std::to_string(exponent));
    }
}

/// Whatever the step, the plastic strain is normal to the yield surface where the stress has come to, and the
/// effective one is its size: the closest point, not just any on the surface.
TEST_P(Sheet, PlasticStrainIsNormalToTheSurface) {
  test::Largest off(
      "Barlat & Lian, m 2 to 20, single steps of up to 100 yield strains: plastic strain, relative error",
      "normal by differences", 1e-6);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int compared = 0;
  for (const Ratios& r : {isotropic, aluminium, steel})
    for (const double exponent : {2.0, 6.0, 8.0, 20.0}) {
      auto material = sheet(false, exponent, r);
      const auto& law = law_of(material);
      const double p = shear_factor(law);
      for (int i = 0; i < 100; ++i) {
        const double size = 0.01 * std::exp2(3.5 * uniform(generator));
        const Five strain{size * uniform(generator), size * uniform(generator), size * uniform(generator), 0,
                          0};
        PointDriver<double> point = driver_of<double>(material, GetParam(), 0);
        point.apply(strain);
        const Five s = point.stress();
        const double flow = point.item("plastic_strain");
        if (flow < 1e-4) continue;
        const double plastic[] = {strain[0] - (s[0] - poissons_ratio * s[1]) / youngs_modulus,
                                  strain[1] - (s[1] - poissons_ratio * s[0]) / youngs_modulus,
                                  strain[2] - s[2] / shear_modulus};
        const double e = 1e-3;
        const double normal[] = {
            (barlat(law, p, s[0] + e, s[1], s[2]) - barlat(law, p, s[0] - e, s[1], s[2])) / (2 * e),
            (barlat(law, p, s[0], s[1] + e, s[2]) - barlat(law, p, s[0], s[1] - e, s[2])) / (2 * e),
            (barlat(law, p, s[0], s[1], s[2] + e) - barlat(law, p, s[0], s[1], s[2] - e)) / (2 * e)};
        for (int k = 0; k < 3; ++k) off.compare(plastic[k] / flow, normal[k], 1, std::to_string(exponent));
        ++compared;
      }
    }
  EXPECT_GT(compared, 800);
}

/// The same strains in axes that are turned give the turned stresses.
TEST_P(Sheet, AxesTurnWithTheSheet) {
  test::Largest off("Barlat & Lian, axes turned by 0.7 rad: stress, error over 250 MPa", "invariance", 1e-11);
  const auto material = sheet(false, 8, steel);
  const double angle = 0.7;
  PointDriver<double> straight = driver_of<double>(material, GetParam(), 0);
  PointDriver<double> turned = driver_of<double>(material, GetParam(), angle);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (int i = 0; i < 40; ++i) {
    const double x = 0.002 * std::cos(0.3 * i);
    const double y = -0.001 + 0.0005 * std::sin(0.2 * i);
    const double g = 0.002 * std::sin(0.5 * i);
    straight.apply({x, y, g, 0, 0});
    turned.apply({c * c * x + s * s * y - c * s * g, s * s * x + c * c * y + c * s * g,
                  2 * c * s * (x - y) + (c * c - s * s) * g, 0, 0});
    const Five a = straight.stress();
    const Five b = turned.stress();
    off.compare(b[0], c * c * a[0] + s * s * a[1] - 2 * c * s * a[2], 250);
    off.compare(b[1], s * s * a[0] + c * c * a[1] + 2 * c * s * a[2], 250);
    off.compare(b[2], c * s * (a[0] - a[1]) + (c * c - s * s) * a[2], 250);
  }
}

TEST_P(Sheet, RatesScaleTheYieldStress) {
  test::Largest off("sheet metal, Cowper-Symonds: equivalent over static yield stress, error",
                    "1 + (rate / C)^(1/p)", 1e-9);
  for (const bool is_normal : {false, true}) {
    auto material = sheet(is_normal, 8, {1.5, 1.5, 1.5});
    law_of(material).cowper_symonds_rate = 40;
    law_of(material).cowper_symonds_exponent = 5;
    const double p = shear_factor(law_of(material));
    for (const double step : {1e-6, 1e-4, 1e-2}) {
      PointDriver<double> point = driver_of<double>(material, GetParam(), 0);
      for (int i = 0; i < 20; ++i) point.apply({0.001, 0, 0, 0, 0}, step);
      const Five s = point.stress();
      const double size = is_normal ? std::sqrt(s[0] * s[0] + s[1] * s[1] - 2 * 1.5 / 2.5 * s[0] * s[1])
                                    : barlat(law_of(material), p, s[0], s[1], s[2]);
      const double rate = std::sqrt(4.0 / 3) * 0.001 / step;
      off.compare(size / (250 + 1000 * point.item("plastic_strain")), 1 + std::pow(rate / 40, 0.2));
    }
  }
}

/// Round a closed path of the strain the sheet takes up work.
TEST_P(Sheet, ClosedPathsTakeUpWork) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double least = 1e300;
  for (int cycle = 0; cycle < 20; ++cycle) {
    const auto material = sheet(cycle % 4 == 3, cycle % 2 == 0 ? 8 : 6, cycle % 3 == 0 ? steel : aluminium);
    PointDriver<double> point = driver_of<double>(material, GetParam(), 0.3);
    const double size = cycle < 10 ? 0.002 : 0.1;
    std::vector<Five> corners(3);
    for (Five& to : corners) {
      for (double& value : to) value = size * uniform(generator);
      to[3] = to[4] = 0;
    }
    least = std::min(least, point.work_around(corners, 200));
  }
  test::verified("sheet metal, closed paths of the strain: least work [MPa] is above zero", "second law")
      .below(-least, 1e-10);
}

TEST_P(Sheet, PowerHardeningFollowsItsFormula) {
  for (const bool is_normal : {false, true}) {
    auto material = sheet(is_normal, 6, steel);
    law_of(material).plastic_strain = law_of(material).yield_stress = {};
    law_of(material).strength = 500;
    law_of(material).hardening_exponent = 0.22;
    law_of(material).yield_strain = 0.002;
    PointDriver<double> point = driver_of<double>(material, GetParam(), 0);
    for (int i = 0; i < 20; ++i) point.apply_uniaxial(0.002, 0.4);
    const double plastic = point.item("plastic_strain");
    EXPECT_NEAR(point.stress()[0], 500 * std::pow(0.002 + plastic, 0.22), 1e-8);
    EXPECT_NEAR(plastic, 0.04 - point.stress()[0] / youngs_modulus, 1e-10);
  }
}

TEST(SheetConstants, AreChecked) {
  auto material = sheet(false, 8, steel);
  EXPECT_NO_THROW(shell_material_constants(material));
  law_of(material).r45 = 0;
  EXPECT_THROW(shell_material_constants(material), Error);
  material = sheet(false, 1.5, steel);
  EXPECT_THROW(shell_material_constants(material), Error);
  material = sheet(true, 0, {-1, 1, 1});
  EXPECT_THROW(shell_material_constants(material), Error);
  material = sheet(false, 8, steel);
  law_of(material).plastic_strain = {0, 0.1, 0.1};
  EXPECT_THROW(shell_material_constants(material), Error);
}

}  // namespace
}  // namespace crumple::materials::testing::sheet_metal_test
