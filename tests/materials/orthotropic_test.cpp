// SPDX-License-Identifier: BSD-3-Clause
// Orthotropic elasticity against the compliance of the sheet, turned by tensor algebra.
#include <gtest/gtest.h>

#include <random>

#include "base/error.hpp"
#include "materials/point_driver.hpp"
#include "support/alike.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::orthotropic_test {
namespace {

using math::Vec3;

/// Unidirectional carbon fibre in epoxy, MPa.
model::OrthotropicElastic carbon() {
  model::OrthotropicElastic law;
  law.modulus_a = 138000;
  law.modulus_b = 8960;
  law.modulus_c = 8000;
  law.poisson_ba = 0.3 * 8960 / 138000;
  law.poisson_ca = 0.02;
  law.poisson_cb = 0.4;
  law.shear_ab = 7100;
  law.shear_bc = 3000;
  law.shear_ca = 6500;
  set_stand_in(law);
  return law;
}
model::Material material(const model::OrthotropicElastic& law) {
  model::Material material;
  material.id = 5;
  material.density = 1.6e-9;
  material.law = law;
  return material;
}

LaminaAxes plane_axes() {
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, 0, 7};
}

/// Strain from stress: the stress tensor is turned to the material axes, the compliance applied there, and
/// the strain tensor turned back. Also gives zz.
std::array<double, 6> strain_of(const model::OrthotropicElastic& m, const Five& stress, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double turn[3][3] = {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
  const double sigma[3][3] = {
      {stress[0], stress[2], stress[4]}, {stress[2], stress[1], stress[3]}, {stress[4], stress[3], 0}};
  double own[3][3] = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) own[i][j] += turn[i][k] * turn[j][l] * sigma[k][l];
  double e[3][3] = {};
  e[0][0] = own[0][0] / m.modulus_a - m.poisson_ba / m.modulus_b * own[1][1];
  e[1][1] = own[1][1] / m.modulus_b - m.poisson_ba / m.modulus_b * own[0][0];
  e[2][2] = -m.poisson_ca / m.modulus_c * own[0][0] - m.poisson_cb / m.modulus_c * own[1][1];
  e[0][1] = e[1][0] = 0.5 * own[0][1] / m.shear_ab;
  e[1][2] = e[2][1] = 0.5 * own[1][2] / m.shear_bc;
  e[2][0] = e[0][2] = 0.5 * own[2][0] / m.shear_ca;
  double back[3][3] = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) back[i][j] += turn[k][i] * turn[l][j] * e[k][l];
  return {back[0][0], back[1][1], 2 * back[0][1], 2 * back[1][2], 2 * back[2][0], back[2][2]};
}

template <class Real>
void expect_inverse_of_compliance(Isa isa, const char* precision, double tolerance) {
  const Five stress{120, -40, 25, 8, -15};
  const std::string lamina = std::string("carbon lamina at five angles, ") + precision + " precision: ";
  const char* const source = "compliance, turned by tensor algebra";
  test::Largest stresses(lamina + "stress over the largest, error", source, tolerance);
  test::Largest thickness(lamina + "thickness strain, relative error", source, tolerance * 4);
  test::Largest energies(lamina + "energy, relative error", source, tolerance * 4);
  for (const double angle : {0.0, 0.3, 1.1, 2.5, -0.7}) {
    model::OrthotropicElastic law = carbon();
    law.angle = angle;
    PointDriver<Real> point(material(law), isa, 2);
    point.prepare(law, plane_axes());
    const auto strain = strain_of(law, stress, angle);
    for (int p = 0; p < 2; ++p)
      for (Index e = 0; e < tile_lanes; ++e)
        point.set_strain(e, p, {strain[0], strain[1], strain[2], strain[3], strain[4]});
    point.apply(1.0);
    double energy = 0;
    for (std::size_t c = 0; c < components; ++c) energy += 0.5 * stress[c] * strain[c];
    for (const Index e : {Index(0), Index(9), Index(tile_lanes - 1)}) {
      for (std::size_t c = 0; c < components; ++c)
        stresses.compare(point.stress(e, 1)[c], stress[c], 120, "angle " + std::to_string(angle));
      thickness.compare(point.thickness_strain(e), strain[5], strain[5]);
      energies.compare(point.energy(e), energy, energy);
    }
  }
}

TEST(Orthotropic, StressIsTheInverseOfTheTurnedCompliance) {
  for (const Isa isa : available_isas()) {
    expect_inverse_of_compliance<double>(isa, "double", 2e-14);
    expect_inverse_of_compliance<float>(isa, "single", 3e-6);
  }
}

TEST(Orthotropic, EqualModuliAreTheIsotropicLaw) {
  model::OrthotropicElastic law;
  law.modulus_a = law.modulus_b = law.modulus_c = youngs_modulus;
  law.poisson_ba = law.poisson_ca = law.poisson_cb = poissons_ratio;
  law.shear_ab = law.shear_bc = law.shear_ca = shear_modulus;
  law.angle = 0.6;
  set_stand_in(law);
  EXPECT_NEAR(law.youngs_modulus, youngs_modulus, 1e-9 * youngs_modulus);
  EXPECT_NEAR(law.poissons_ratio, poissons_ratio, 1e-12);
  model::Material isotropic;
  isotropic.law = model::Elastic{youngs_modulus, poissons_ratio};
  PointDriver<double> a(material(law), Isa::Scalar);
  a.prepare(law, plane_axes());
  PointDriver<double> b(isotropic, Isa::Scalar);
  const Five strain{0.001, -0.0004, 0.0007, 0.0002, -0.0003};
  a.apply(strain);
  b.apply(strain);
  test::Largest off("orthotropic law with equal moduli: stress over 300 MPa, difference", "isotropic law",
                    1e-12);
  for (std::size_t c = 0; c < components; ++c) off.compare(a.stress()[c], b.stress()[c], 300);
  EXPECT_NEAR(a.thickness_strain(), b.thickness_strain(), 1e-16);
}

TEST(Orthotropic, InstructionSetsWithTheSameRoundingGiveTheSameBits) {
  std::vector<std::vector<float>> bits;
  for (const Isa isa : available_isas()) {
    model::OrthotropicElastic law = carbon();
    law.angle = 0.4;
    PointDriver<float> point(material(law), isa, 3);
    point.prepare(law, plane_axes());
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1e-3, 1e-3);
    for (int i = 0; i < 10; ++i) {
      for (Index e = 0; e < tile_lanes; ++e)
        for (int p = 0; p < 3; ++p)
          point.set_strain(e, p,
                           {uniform(generator), uniform(generator), uniform(generator), uniform(generator),
                            uniform(generator)});
      point.apply(1.0);
    }
    bits.push_back(point.bits());
  }
  test::expect_alike(bits, [](const auto& a, const auto& b) { return same_bits(a, b); });
}

/// The axis a of each option on a shell that lies askew in space.
TEST(Orthotropic, AxesFollowTheOption) {
  const Vec3 e1 = normalised(Vec3{1, 2, -0.5});
  const Vec3 e3 = normalised(cross(e1, Vec3{0.2, -1, 3}));
  const Vec3 e2 = cross(e3, e1);
  LaminaAxes axes{e1, e2, e3, 2 * std::cos(0.2) * e1 + 2 * std::sin(0.2) * e2, 0, 7};
  const auto angle_of = [&](const model::OrthotropicElastic& law) {
    PointDriver<double> point(material(law), Isa::Scalar);
    point.prepare(law, axes);
    return std::atan2(point.item("material_axis", 0, 1), point.item("material_axis", 0, 0));
  };
  using Axes = model::OrthotropicElastic::Axes;
  model::OrthotropicElastic law = carbon();
  EXPECT_NEAR(angle_of(law), 0.2, 1e-14);
  law.angle = 0.5;
  EXPECT_NEAR(angle_of(law), 0.7, 1e-14);
  axes.angle = -0.1;
  EXPECT_NEAR(angle_of(law), 0.1, 1e-14) << "the element's own angle goes before the material's";
  axes.angle = 0;
  law.angle = 0;
  law.axes = Axes::Vector;
  const Vec3 vector = 3.0 * (std::cos(1.1) * e1 + std::sin(1.1) * e2) + 5.0 * e3;
  law.direction = {vector.x, vector.y, vector.z};
  EXPECT_NEAR(angle_of(law), 1.1, 1e-14);
  law.axes = Axes::CrossNormal;
  // v x e3 of v = e2 cos + ... lies a quarter turn behind v.
  EXPECT_NEAR(angle_of(law), 1.1 - std::acos(0.0), 1e-14);
  law.direction = {e3.x, e3.y, e3.z};
  try {
    angle_of(law);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("Shell 7: the direction"), std::string::npos);
  }
}

/// No wave in the plane is faster than the stand-in's, no transverse shear stiffer.
TEST(Orthotropic, StandInBoundsTheStep) {
  const model::OrthotropicElastic law = carbon();
  const ElasticConstants stand_in = elastic_constants(material(law));
  const double fibre = law.modulus_a / (1 - law.poisson_ba * law.poisson_ba * law.modulus_a / law.modulus_b);
  const double fastest = stand_in.plate_wave_speed() * stand_in.plate_wave_speed() * 1.6e-9;
  EXPECT_GE(fastest, fibre * (1 - 1e-12));
  EXPECT_LE(fastest, 1.01 * fibre);
  EXPECT_GE(stand_in.shear_modulus(), law.shear_ca);
}

TEST(Orthotropic, BadNumbersAreNamed) {
  model::OrthotropicElastic law = carbon();
  law.poisson_ba = 0.3;
  EXPECT_THROW(shell_material_constants(material(law)), Error);
  law = carbon();
  law.shear_bc = 0;
  EXPECT_THROW(shell_material_constants(material(law)), Error);
}

TEST(Null, HasNoStress) {
  model::Material null;
  null.id = 6;
  null.density = 1e-9;
  null.law = model::NullMaterial{youngs_modulus, poissons_ratio};
  EXPECT_FALSE(has_stiffness(null.law));
  EXPECT_TRUE(has_stiffness(material(carbon()).law));
  for (const Isa isa : available_isas()) {
    PointDriver<float> point(null, isa);
    point.apply({0.1, 0.2, 0.3, 0.1, 0.1});
    EXPECT_EQ(point.stress(), Five{});
    EXPECT_EQ(point.energy(), 0);
    EXPECT_EQ(point.thickness_strain(), 0);
  }
}

}  // namespace
}  // namespace crumple::materials::testing::orthotropic_test
