// SPDX-License-Identifier: BSD-3-Clause
// Fabric that wrinkles: closed forms, the relaxed energy by search over all directions, no work in a cycle.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "base/error.hpp"
#include "materials/point_driver.hpp"
#include "support/largest.hpp"
#include "support/verified.hpp"

namespace crumple::materials::testing::fabric_test {
namespace {

constexpr double pi = std::numbers::pi;

/// A coated nylon, MPa: weak in shear.
model::Fabric nylon() {
  model::Fabric law;
  law.sheet.modulus_a = 500;
  law.sheet.modulus_b = 300;
  law.sheet.poisson_ba = 0.1;
  law.sheet.shear_ab = 20;
  law.wrinkles = true;
  set_stand_in(law);
  return law;
}
model::Fabric isotropic() {
  model::Fabric law;
  law.sheet.modulus_a = law.sheet.modulus_b = 500;
  law.sheet.poisson_ba = 0.3;
  law.sheet.shear_ab = 0.5 * 500 / 1.3;
  law.wrinkles = true;
  set_stand_in(law);
  return law;
}
model::Material material(const model::Fabric& law) {
  model::Material material;
  material.id = 5;
  material.density = 9e-10;
  material.law = law;
  return material;
}

/// Symmetric tensor in the plane, shear of strains as a tensor's.
struct Plane {
  double xx, yy, xy;
};
Plane turned(const Plane& t, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * c * t.xx + s * s * t.yy - 2 * c * s * t.xy, s * s * t.xx + c * c * t.yy + 2 * c * s * t.xy,
          c * s * (t.xx - t.yy) + (c * c - s * s) * t.xy};
}
double dot(const Plane& a, const Plane& b) {
  return a.xx * b.xx + a.yy * b.yy + 2 * a.xy * b.xy;
}
/// Strain of a stress in the axes of the yarns.
Plane compliance(const model::OrthotropicElastic& m, const Plane& s) {
  return {s.xx / m.modulus_a - m.poisson_ba / m.modulus_b * s.yy,
          s.yy / m.modulus_b - m.poisson_ba / m.modulus_b * s.xx, 0.5 * s.xy / m.shear_ab};
}

/// One point driven by strains in lamina axes.
template <class Real>
class FabricPoint : public PointDriver<Real> {
 public:
  explicit FabricPoint(const model::Fabric& law, Isa isa = Isa::Scalar, double angle = 0)
      : PointDriver<Real>(material(law), isa) {
    this->prepare(law, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, angle, 7});
  }
  Plane strained(const Plane& e) {
    this->apply({e.xx, e.yy, 2 * e.xy, 0, 0});
    const Five s = this->stress(0, 0);
    return {s[0], s[1], s[2]};
  }
};

constexpr double size = 0.01;

/// Without wrinkles the sheet is the orthotropic one, and a liner is added by its share.
TEST(Fabric, IsTheOrthotropicSheetAndItsLiner) {
  model::Fabric law = nylon();
  law.wrinkles = false;
  law.liner_share = 0.2;
  law.liner_modulus = 100;
  law.liner_ratio = 0.4;
  const double direct = 100 / (1 - 0.16);
  const double determinant = 1 - 0.01 * 500 / 300;
  for (const Isa isa : available_isas()) {
    FabricPoint<double> point(law, isa);
    const Plane s = point.strained({size, -0.5 * size, 0.3 * size});
    const double aa = 0.8 * (500 - 0.5 * 0.1 * 500) / determinant + 0.2 * direct * (1 - 0.5 * 0.4);
    const double bb = 0.8 * (0.1 * 500 - 0.5 * 300) / determinant + 0.2 * direct * (0.4 - 0.5);
    const double ab = (0.8 * 20 + 0.2 * 0.5 * (1 - 0.4) * direct) * 2 * 0.3;
    test::verified("fabric with a liner: stresses over the strain", "both sheets by their shares")
        .within(s.xx / size, aa, 1e-13);
    EXPECT_NEAR(s.yy / size, bb, 1e-11);
    EXPECT_NEAR(s.xy / size, ab, 1e-11);
  }
}

/// An isotropic sheet pulled along a direction and pressed across has the tension E e along it, in pure shear
/// half of that of the shear's principal strain, and none where it is pressed in both directions.
TEST(Fabric, IsotropicWrinklesBearTensionAlone) {
  test::Largest doubles(
      "isotropic fabric, wrinkled, eleven directions: stress over E e, error, double precision",
      "tension along the principal strain, E e", 1e-12);
  test::Largest singles(
      "isotropic fabric, wrinkled, eleven directions: stress over E e, error, single precision",
      "tension along the principal strain, E e", 2e-5);
  const auto check = [&]<class Real>(Real, test::Largest& off, Isa isa) {
    for (int k = 0; k < 11; ++k) {
      const double angle = 0.31 * k;
      for (const double across : {-0.31, -0.7, -1.0, -20.0}) {
        FabricPoint<Real> point(isotropic(), isa, 0.4);
        const Plane s = point.strained(turned({size, across * size, 0}, angle));
        const Plane expected = turned({500 * size, 0, 0}, angle);
        off.compare(s.xx, expected.xx, 500 * size);
        off.compare(s.yy, expected.yy, 500 * size);
        off.compare(s.xy, expected.xy, 500 * size);
      }
      FabricPoint<Real> slack(isotropic(), isa);
      const Plane s = slack.strained(turned({-1e-3 * size, -size, 0}, angle));
      off.add(std::sqrt(dot(s, s)));
      FabricPoint<Real> taut(isotropic(), isa);
      const Plane t = taut.strained(turned({size, -0.29 * size, 0}, angle));
      const Plane elastic =
          turned({500 * size * (1 - 0.3 * 0.29) / 0.91, 500 * size * (0.3 - 0.29) / 0.91, 0}, angle);
      off.compare(t.xx, elastic.xx, 500 * size);
      off.compare(t.yy, elastic.yy, 500 * size);
    }
  };
  for (const Isa isa : available_isas()) {
    check(1.0, doubles, isa);
    check(1.0F, singles, isa);
  }
}

/// Of any strain the stress has no pressure, what of the strain is not elastic has no tension, both do no
/// work on each other: that makes it the largest of the dual energy. A search over all directions finds no
/// larger one.
TEST(Fabric, StressIsThatOfTheRelaxedEnergy) {
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  test::Largest pressure("weak fabric, 2000 strains: pressure over E e", "none", 1e-12);
  test::Largest excess("weak fabric, 2000 strains: tension of the wrinkles' strain over e", "none", 1e-6);
  test::Largest work("weak fabric, 2000 strains: work of the stress on it over E e e", "none", 1e-12);
  test::Largest search("weak fabric, 2000 strains: energy less the largest over 3600 directions, over E e e",
                       "search", 1e-5);
  const model::Fabric law = nylon();
  int wrinkled = 0;
  for (int sample = 0; sample < 2000; ++sample) {
    const Plane e{size * uniform(generator), size * uniform(generator), size * uniform(generator)};
    FabricPoint<double> point(law);
    const Plane s = point.strained(e);
    const double unit = 500 * size;
    const double mean = 0.5 * (s.xx + s.yy);
    const double radius = std::hypot(0.5 * (s.xx - s.yy), s.xy);
    pressure.add(std::max(0.0, radius - mean) / unit);
    const Plane elastic = compliance(law.sheet, s);
    const Plane rest{e.xx - elastic.xx, e.yy - elastic.yy, e.xy - elastic.xy};
    const double stretch = 0.5 * (rest.xx + rest.yy) + std::hypot(0.5 * (rest.xx - rest.yy), rest.xy);
    excess.add(std::max(0.0, stretch) / size);
    work.add(std::fabs(dot(s, rest)) / (unit * size));
    if (radius < 0.999 * mean) continue;  // taut
    ++wrinkled;
    double largest = 0;
    for (int k = 0; k < 3600; ++k) {
      const Plane n = turned({1, 0, 0}, k * pi / 3600);
      const double along = dot(n, e);
      if (along > 0) largest = std::max(largest, 0.5 * along * along / dot(n, compliance(law.sheet, n)));
    }
    search.add(std::fabs(0.5 * dot(s, e) - largest) / (unit * size));
  }
  EXPECT_GT(wrinkled, 1000);
}

/// Round and round through wrinkled, slack and taut states: the work of a closed path of strain vanishes with
/// the square of its steps, and the stress comes back.
TEST(Fabric, AClosedPathOfStrainDoesNoWork) {
  const auto path = [](double t) {
    return Plane{size * (0.3 * std::sin(t) + 0.8 * std::sin(2 * t)), size * (std::sin(t + 1) - std::sin(1.0)),
                 size * 0.6 * std::sin(3 * t)};
  };
  const auto work = [&](int steps) {
    FabricPoint<double> point(nylon());
    double sum = 0;
    double largest = 0;
    for (int i = 0; i < steps; ++i) {
      const Plane a = path(2 * pi * i / steps);
      const Plane b = path(2 * pi * (i + 1) / steps);
      point.strained({b.xx - a.xx, b.yy - a.yy, b.xy - a.xy});
      sum += point.energy();
      largest = std::max(largest, sum);
    }
    return std::fabs(sum) / largest;
  };
  const double coarse = work(200);
  const double fine = work(800);
  test::verified("weak fabric, closed path of strain in 800 steps: work over the largest on the way", "none")
      .below(fine, 1e-4);
  EXPECT_LT(fine, 0.2 * coarse);
}

/// The viscous stress is the damping times the elastic stress of the step's strain, and gone in the next
/// step.
TEST(Fabric, DampingIsAShareOfTheStressOfAStep) {
  model::Fabric law = isotropic();
  const double speed = law.youngs_modulus;
  law.damping = 0.05;
  set_stand_in(law);
  FabricPoint<double> point(law);
  const Plane s = point.strained({size, 0, 0});
  EXPECT_NEAR(s.xx, 1.05 * 500 * size / 0.91, 1e-12);
  const Plane rest = point.strained({0, 0, 0});
  EXPECT_NEAR(rest.xx, 500 * size / 0.91, 1e-12);
  const double shorter = std::sqrt(1 + 0.05 * 0.05) - 0.05;
  EXPECT_NEAR(law.youngs_modulus * shorter * shorter, speed, 1e-9 * speed);
}

TEST(Fabric, RefusesWrongNumbers) {
  model::Fabric law = nylon();
  law.sheet.poisson_ba = 0.9;
  EXPECT_THROW(shell_material_constants(material(law)), Error);
  law = nylon();
  law.sheet.shear_ab = 0;
  EXPECT_THROW(shell_material_constants(material(law)), Error);
  law = nylon();
  law.liner_share = 0.5;
  EXPECT_THROW(shell_material_constants(material(law)), Error);
}

}  // namespace
}  // namespace crumple::materials::testing::fabric_test
