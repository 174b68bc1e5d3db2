// SPDX-License-Identifier: BSD-3-Clause
// Plies that lose stiffness by damage, against the closed form of each mode.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "base/error.hpp"
#include "materials/point_driver.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::laminated_fabric_test {
namespace {

using Law = model::LaminatedFabric;
using Surface = Law::Surface;

/// Glass fabric in epoxy, MPa.
Law glass(Surface surface, double poisson = 0.12) {
  Law law;
  law.modulus_a = 26000;
  law.modulus_b = law.modulus_c = 24000;
  law.poisson_ba = poisson;
  law.shear_ab = law.shear_ca = law.shear_bc = 4000;
  law.surface = surface;
  law.tension_a = {450, 0.024, 0.1};
  law.compression_a = {300, 0.018, 0.9};
  law.tension_b = {400, 0.022, 0};
  law.compression_b = {280, 0.02, 1};
  law.shear = {70, 0.05, 0.6};
  set_stand_in(law);
  return law;
}
model::Material material_of(const Law& law) {
  model::Material material;
  material.id = 58;
  material.density = 1.8e-9;
  material.law = law;
  return material;
}
template <class Real = double>
PointDriver<Real> point_of(const Law& law, Isa isa, double angle = 0, int points = 1) {
  PointDriver<Real> point(material_of(law), isa, points);
  LaminaAxes axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  axes.layer_angle = angle;
  point.prepare(law, axes);
  return point;
}

/// What is left of a modulus once the stress without damage has been `drive` times the strength:
/// Matzenmiller, Lubliner & Taylor (1995), with its bound.
double left(const Law::Mode& mode, double modulus, double drive) {
  const double peak = modulus * mode.strain / mode.strength;
  const double m = 1 / std::log(peak);
  const double share = std::exp(-std::pow(drive, m) / (m * std::numbers::e));
  return drive > peak ? std::max(share, mode.left / drive) : share;
}
double stress_of(const Law::Mode& mode, double modulus, double strain) {
  return modulus * strain * left(mode, modulus, modulus * strain / mode.strength);
}

class Fabric58 : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, Fabric58, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

/// Stress along one axis alone, in tension and compression along a and b, with every surface: the curve goes
/// through the strength at its strain and on to its bound; the other direction keeps its stiffness.
TEST_P(Fabric58, StressAlongOneAxisFollowsTheCurveOfItsMode) {
  test::Largest off("laminated fabric, stress along one axis: stress, error [MPa]",
                    "Matzenmiller, Lubliner & Taylor", 1e-8);
  test::Largest tops("laminated fabric, stress along one axis: largest stress over the strength, error",
                     "strength", 1e-9);
  test::Largest across("laminated fabric, stress along one axis: damage across", "none", 1e-12);
  for (const Surface surface : {Surface::Facets, Surface::Across, Surface::Smooth}) {
    const Law law = glass(surface);
    for (const bool along_b : {false, true})
      for (const double sign : {1.0, -1.0}) {
        const Law::Mode& mode = along_b ? (sign > 0 ? law.tension_b : law.compression_b)
                                        : (sign > 0 ? law.tension_a : law.compression_a);
        const double modulus = along_b ? law.modulus_b : law.modulus_a;
        PointDriver<double> point = point_of(law, GetParam(), along_b ? std::numbers::pi / 2 : 0);
        double most = 0;
        constexpr int steps = 240;
        for (int i = 1; i <= 2 * steps; ++i) {
          point.apply_uniaxial(sign * mode.strain / steps, 0.1);
          const double strain = mode.strain * i / steps;
          off.compare(sign * point.stress()[0], stress_of(mode, modulus, strain), 1, std::to_string(strain));
          most = std::max(most, std::fabs(point.stress()[0]));
        }
        tops.compare(most, mode.strength, mode.strength);
        across.add(std::fabs(point.item("damage", 0, along_b ? 0 : 1)));
        EXPECT_GT(point.item("damage", 0, along_b ? 1 : 0), 0.5);
      }
  }
}

/// The cross term of the compliance has no damage: lateral strain over stress stays what it was.
TEST_P(Fabric58, LateralStrainFollowsTheStress) {
  const Law law = glass(Surface::Smooth);
  PointDriver<double> point = point_of(law, GetParam());
  test::Largest off("laminated fabric pulled along a to twice the strain at strength: lateral strain, error",
                    "compliance of Matzenmiller, Lubliner & Taylor", 1e-12);
  for (int i = 0; i < 200; ++i) {
    point.apply_uniaxial(2.4e-4, 0.1);
    off.compare(point.item("ply_strain", 0, 1), -law.poisson_ba / law.modulus_b * point.stress()[0]);
  }
}

TEST_P(Fabric58, ShearFollowsItsCurve) {
  test::Largest off("laminated fabric, shear: stress, error [MPa]", "closed form", 1e-9);
  for (const Surface surface : {Surface::Facets, Surface::Across, Surface::Smooth}) {
    const Law law = glass(surface);
    PointDriver<double> point = point_of(law, GetParam());
    for (int i = 1; i <= 300; ++i) {
      point.apply({0, 0, 4e-4, 0, 0});
      off.compare(point.stress()[2], stress_of(law.shear, law.shear_ab, 4e-4 * i), 1, std::to_string(i));
    }
  }
  // TAU1 and GAMMA1: a curve to that point, a line to the strength, then the bound.
  Law law = glass(Surface::Facets);
  law.first_shear_stress = 40;
  law.first_shear_strain = 0.015;
  const Law::Mode first{40, 0.015, 0};
  PointDriver<double> point = point_of(law, GetParam());
  for (int i = 1; i <= 300; ++i) {
    const double gamma = 3.001e-4 * i;
    point.apply({0, 0, -3.001e-4, 0, 0});
    const double expected = gamma < 0.015  ? stress_of(first, law.shear_ab, gamma)
                            : gamma < 0.05 ? 40 + 30 * (gamma - 0.015) / 0.035
                                           : 0.6 * 70;
    off.compare(point.stress()[2], -expected, 1, "line at " + std::to_string(gamma));
  }
}

/// Both stresses on the way to the strength together. Without Poisson's ratio strains and stresses without
/// damage are in proportion.
TEST_P(Fabric58, SurfacesCoupleShearAndStress) {
  test::Largest off("laminated fabric, stress and shear in proportion: stresses, error [MPa]",
                    "curves of the modes over the common drive", 1e-8);
  constexpr double angle = 0.7;
  for (const Surface surface : {Surface::Facets, Surface::Across, Surface::Smooth})
    for (const bool along_b : {false, true}) {
      const Law law = glass(surface, 0);
      const Law::Mode& mode = along_b ? law.tension_b : law.tension_a;
      const double modulus = along_b ? law.modulus_b : law.modulus_a;
      PointDriver<double> point = point_of(law, GetParam());
      const bool coupled = surface == Surface::Smooth || (surface == Surface::Across && along_b);
      constexpr double step = 0.02;
      for (int i = 1; i <= 120; ++i) {
        const double direct = step * std::cos(angle) * mode.strength / modulus;
        const double shear = step * std::sin(angle) * law.shear.strength / law.shear_ab;
        point.apply({along_b ? 0 : direct, along_b ? direct : 0, shear, 0, 0});
        const double drive = step * i;
        const double own = coupled ? drive : drive * std::cos(angle);
        const double beside = coupled ? drive : drive * std::sin(angle);
        off.compare(point.stress()[along_b ? 1 : 0],
                    drive * std::cos(angle) * mode.strength * left(mode, modulus, own));
        off.compare(point.stress()[2],
                    drive * std::sin(angle) * law.shear.strength * left(law.shear, law.shear_ab, beside));
      }
    }
}

/// Damage unloads to the origin, and that in tension leaves compression alone.
TEST_P(Fabric58, UnloadsToTheOrigin) {
  const Law law = glass(Surface::Facets, 0);
  PointDriver<double> point = point_of(law, GetParam());
  for (int i = 0; i < 100; ++i) point.apply({2e-4, 0, 5e-4, 0, 0});
  const Five peak = point.stress();
  EXPECT_LT(peak[0], 0.95 * law.modulus_a * 0.02);
  test::Largest off("laminated fabric, unloaded from 2 %: stress, error [MPa]",
                    "secant; modulus in compression", 1e-9);
  for (int i = 1; i <= 100; ++i) {
    point.apply({-2e-4, 0, -5e-4, 0, 0});
    off.compare(point.stress()[0], peak[0] * (1 - 0.01 * i));
    off.compare(point.stress()[2], peak[2] * (1 - 0.01 * i));
  }
  for (int i = 1; i <= 40; ++i) {
    point.apply({-2e-4, 0, 0, 0, 0});
    off.compare(point.stress()[0], -stress_of(law.compression_a, law.modulus_a, 2e-4 * i));
  }
}

/// Round any closed path of the strain the ply takes up work, and its elastic energy is back.
TEST_P(Fabric58, ClosedPathsTakeUpWork) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double least = 1e300;
  double largest_left = 0;
  for (int cycle = 0; cycle < 30; ++cycle) {
    Law law = glass(cycle % 3 == 0 ? Surface::Facets : cycle % 3 == 1 ? Surface::Across : Surface::Smooth);
    if (cycle % 6 == 0) law.first_shear_stress = 40;
    if (cycle % 6 == 0) law.first_shear_strain = 0.015;
    PointDriver<double> point = point_of(law, GetParam(), 0.4);
    const double size = cycle < 15 ? 0.01 : 0.06;
    std::vector<Five> corners(3);
    for (Five& to : corners) {
      for (double& value : to) value = size * uniform(generator);
    }
    least = std::min(least, point.work_around(corners, 400));
    for (int k = 0; k < 5; ++k) largest_left = test::larger_of(largest_left, std::fabs(point.stress()[k]));
  }
  test::verified("laminated fabric, closed paths of the strain: least work [MPa] is above zero", "second law")
      .below(-least, 1e-10);
  test::verified("laminated fabric, closed paths of the strain: stress that is left [MPa]",
                 "damage, no plasticity")
      .below(largest_left, 1e-9);
}

/// Curves that go straight up and down at once, as those of a deck that gives no strains at strength.
Law brittle(double poisson, double share_left, Surface surface) {
  Law law = glass(surface, poisson);
  law.modulus_a = law.modulus_b = 25000;
  law.tension_a = {450, 450.0 / 25000, share_left};
  law.compression_a = {300, 300.0 / 25000, share_left};
  law.tension_b = {400, 400.0 / 25000, share_left};
  law.compression_b = {280, 280.0 / 25000, share_left};
  law.shear = {70, 70.0 / 4000, share_left};
  return law;
}

/// A ply that is taken round closed paths, with what must not happen on the way.
struct BrittleCycles {
  double most_healed = 0;     ///< largest fall of a drive
  double most_made = -1e300;  ///< energy that a step makes, and a path [MPa]
  double most_beyond = 0;     ///< largest stress without damage over the strength, less the drive

  void go(const Law& law, Isa isa, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    PointDriver<double> point = point_of(law, isa);
    now_ = {};
    for (int path = 0; path < 5; ++path) {
      const double size = 0.016 + 0.004 * path;
      path_made_ = 0;
      for (int i = 0; i < 3; ++i) leg(law, point, size * uniform(generator), size * uniform(generator));
      leg(law, point, 0, 0);
      most_made = test::larger_of(most_made, path_made_);
    }
  }

 private:
  struct State {
    std::array<double, 2> strain{}, stress{};
    std::array<double, 4> drive{};
    double stored() const { return 0.5 * (strain[0] * stress[0] + strain[1] * stress[1]); }
  };

  void leg(const Law& law, PointDriver<double>& point, double a, double b) {
    constexpr int steps = 200;
    const std::array<double, 2> step{(a - now_.strain[0]) / steps, (b - now_.strain[1]) / steps};
    for (int i = 0; i < steps; ++i) {
      const State before = now_;
      point.apply({step[0], step[1], 0, 0, 0});
      for (int k = 0; k < 2; ++k) now_.strain[k] += step[k];
      for (int k = 0; k < 2; ++k) now_.stress[k] = point.stress()[k];
      for (int k = 0; k < 4; ++k) now_.drive[k] = point.item("damage_drive", 0, k);
      for (int k = 0; k < 4; ++k) most_healed = test::larger_of(most_healed, before.drive[k] - now_.drive[k]);
      const double made = now_.stored() - before.stored() - point.energy() - kink_of(law, before, step);
      most_made = test::larger_of(most_made, made);
      path_made_ += made;
      judge(law, point);
    }
  }

  /// The work of a step is by the mean of its stresses. Where one changes its sign, and with it its modulus,
  /// the mean is off by up to S^2 / (8 E), S the change of the stress without damage.
  double kink_of(const Law& law, const State& before, const std::array<double, 2>& step) const {
    const double nu = law.poisson_ba;
    double kink = 0;
    for (int k = 0; k < 2; ++k) {
      const double change =
          law.modulus_a * (std::fabs(step[k]) + nu * std::fabs(step[1 - k])) / (1 - nu * nu);
      if (before.stress[k] * now_.stress[k] < 0) kink += change * change / (8 * law.modulus_a);
    }
    return kink;
  }

  void judge(const Law& law, const PointDriver<double>& point) {
    const Law::Mode* const modes[] = {&law.tension_a, &law.compression_a, &law.tension_b, &law.compression_b};
    for (int k = 0; k < 2; ++k) {
      const double left = 1 - point.item("damage", 0, k);
      if (left < 1e-6) continue;
      const int mode = 2 * k + (now_.stress[k] < 0 ? 1 : 0);
      most_beyond = test::larger_of(
          most_beyond, std::fabs(now_.stress[k]) / left / modes[mode]->strength - now_.drive[mode]);
    }
  }

  State now_;
  double path_made_ = 0;
};

TEST_P(Fabric58, SteepModesNeitherHealNorMakeEnergy) {
  BrittleCycles found;
  unsigned seed = 1;
  for (const double poisson : {0.3, 0.5})
    for (const double share_left : {0.0, 0.1, 1.0})
      for (const Surface surface : {Surface::Facets, Surface::Smooth})
        for (int i = 0; i < 2; ++i) found.go(brittle(poisson, share_left, surface), GetParam(), seed++);
  const std::string what = "laminated fabric, strains at strength of the elastic line, closed paths: ";
  test::verified(what + "largest fall of a drive", "damage does not heal").below(found.most_healed, 1e-300);
  test::verified(what + "energy made by a step or a path [MPa]", "second law").below(found.most_made, 1e-9);
  test::verified(what + "stress without damage over the strength, beyond the drive", "drive")
      .below(found.most_beyond, 1e-3);
}

TEST_P(Fabric58, WorkOfATestIsTheAreaBelowItsCurve) {
  const Law law = glass(Surface::Smooth);
  PointDriver<double> point = point_of(law, GetParam());
  double work = 0;
  constexpr int steps = 4000;
  const double end = 3 * law.tension_a.strain;
  for (int i = 0; i < steps; ++i) {
    point.apply_uniaxial(end / steps, 0.1);
    work += point.energy();
  }
  double area = 0;
  constexpr int slices = 20000;
  for (int i = 0; i < slices; ++i)
    area += stress_of(law.tension_a, law.modulus_a, end * (i + 0.5) / slices) * end / slices;
  test::verified(
      "laminated fabric pulled to three times the strain at strength: work over the area below the curve",
      "quadrature")
      .near(work / area, 1, 1e-5);
}

TEST_P(Fabric58, AxesTurnWithTheLayer) {
  test::Largest off("laminated fabric, axes turned by 0.7 rad: stress, error [MPa]", "invariance", 1e-9);
  const Law law = glass(Surface::Smooth);
  constexpr double angle = 0.7;
  PointDriver<double> straight = point_of(law, GetParam());
  PointDriver<double> turned = point_of(law, GetParam(), angle);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (int i = 0; i < 60; ++i) {
    const double x = 0.001 * std::cos(0.1 * i);
    const double y = -0.0005 + 0.0005 * std::sin(0.2 * i);
    const double g = 0.002 * std::sin(0.05 * i);
    straight.apply({x, y, g, 0, 0});
    turned.apply({c * c * x + s * s * y - c * s * g, s * s * x + c * c * y + c * s * g,
                  2 * c * s * (x - y) + (c * c - s * s) * g, 0, 0});
    const Five a = straight.stress();
    const Five b = turned.stress();
    off.compare(b[0], c * c * a[0] + s * s * a[1] - 2 * c * s * a[2]);
    off.compare(b[1], s * s * a[0] + c * c * a[1] + 2 * c * s * a[2]);
    off.compare(b[2], c * s * (a[0] - a[1]) + (c * c - s * s) * a[2]);
  }
}

TEST_P(Fabric58, PointsGoAtTheEffectiveStrain) {
  Law law = glass(Surface::Facets);
  law.erosion_strain = 0.05;
  PointDriver<double> point = point_of(law, GetParam());
  int last = 0;
  for (int i = 1; i <= 80; ++i) {
    point.apply({1e-3, 5e-4, 1e-3, 0, 0});
    const double strain = 1e-3 * i * std::sqrt(4.0 / 3 * (1 + 0.5 + 0.25 + 0.25));
    EXPECT_EQ(point.intact(), strain <= 0.05) << strain;
    if (point.intact()) last = i;
    EXPECT_EQ(point.stress()[0] == 0, !point.intact()) << strain;
  }
  EXPECT_EQ(last, 30);
  for (const double stress : point.stress()) EXPECT_EQ(stress, 0);
  EXPECT_FALSE(can_fail(material_of(glass(Surface::Facets))));
}

TEST_P(Fabric58, FloatAgreesWithDouble) {
  const Law law = glass(Surface::Smooth);
  PointDriver<float> coarse = point_of<float>(law, GetParam());
  PointDriver<double> exact = point_of<double>(law, GetParam());
  double worst = 0;
  for (int i = 1; i <= 5000; ++i) {
    const Five strain{6e-6 * std::cos(2e-4 * i), -2e-6, 8e-6, 1e-7, 0};
    coarse.apply(strain);
    exact.apply(strain);
    for (int k = 0; k < 5; ++k)
      worst = test::larger_of(worst, std::fabs(coarse.stress()[k] - exact.stress()[k]) / 450);
  }
  test::verified("laminated fabric, 5000 steps in single precision: stress over 450 MPa, error",
                 "double precision")
      .below(worst, 2e-5);
}

TEST(Fabric58Constants, AreChecked) {
  Law law = glass(Surface::Facets);
  EXPECT_NO_THROW(shell_material_constants(material_of(law)));
  law.tension_a.strain = 0.01;  // below 450 / 26000
  EXPECT_THROW(shell_material_constants(material_of(law)), Error);
  law = glass(Surface::Facets);
  law.shear.left = 1.5;
  EXPECT_THROW(shell_material_constants(material_of(law)), Error);
  law = glass(Surface::Facets);
  law.first_shear_stress = 80;
  law.first_shear_strain = 0.03;
  EXPECT_THROW(shell_material_constants(material_of(law)), Error);
  law = glass(Surface::Facets);
  law.compression_b.strength = 0;
  EXPECT_THROW(shell_material_constants(material_of(law)), Error);
}

}  // namespace
}  // namespace crumple::materials::testing::laminated_fabric_test
