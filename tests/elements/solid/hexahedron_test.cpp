// SPDX-License-Identifier: BSD-3-Clause
// The hexahedron with one point: geometry, stable step, negative volume.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "elements/solid/solid_geometry.hpp"
#include "elements/solid/solid_setup.hpp"
#include "elements/solid_harness.hpp"
#include "support/largest.hpp"

namespace crumple::elements::testing::hexahedron_test {
namespace {

using Form = model::SolidHourglassForm;
/// A cube of side 2.
model::Model one_cube(Form form) {
  return solid_cube({.form = form}, 1, 0);
}

std::array<Vec3, 8> distorted_corners(int seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-0.25, 0.25);
  std::array<Vec3, 8> corner{Vec3{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                             {-1, -1, 1},      {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  for (Vec3& x : corner) x += Vec3{uniform(generator), uniform(generator), uniform(generator)};
  return corner;
}

/// Volume by Gauss's rule of 2 x 2 x 2 points, exact for the trilinear map, from shape functions.
double volume_by_points(const std::array<Vec3, 8>& corner) {
  constexpr double signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                  {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  double sum = 0;
  for (const auto& place : signs) {
    Vec3 tangent[3];
    for (std::size_t k = 0; k < 8; ++k) {
      double factor[3];
      for (int a = 0; a < 3; ++a) factor[a] = 1 + signs[k][a] * place[a] / std::sqrt(3.0);
      tangent[0] += 0.125 * signs[k][0] * factor[1] * factor[2] * corner[k];
      tangent[1] += 0.125 * signs[k][1] * factor[2] * factor[0] * corner[k];
      tangent[2] += 0.125 * signs[k][2] * factor[0] * factor[1] * corner[k];
    }
    sum += dot(tangent[0], cross(tangent[1], tangent[2]));
  }
  return sum;
}

TEST(SolidGeometry, VolumeIsThatOfTheTrilinearMap) {
  test::Largest off("fifty distorted hexahedra: volume, relative error", "Gauss's rule, 2 x 2 x 2", 1e-14);
  for (int seed = 0; seed < 50; ++seed) {
    const auto corner = distorted_corners(seed);
    const double exact = volume_by_points(corner);
    off.compare(solid_geometry(patterns_of(corner), true).volume, exact, exact);
  }
}

TEST(SolidGeometry, GradientsAreDerivativesOfTheVolume) {
  test::Largest off("twenty distorted hexahedra: gradients of the volume, error", "central differences",
                    1e-9);
  for (int seed = 0; seed < 20; ++seed)
    for (const bool exact : {false, true}) {
      const SolidPatterns<double> x = patterns_of(distorted_corners(seed));
      const auto g = solid_geometry(x, exact);
      for (int p = 0; p < 6; ++p) {
        const auto derivative = [&](double math::PackVec3<double>::*axis) {
          // The volume is of the third degree: the central difference's error is that of step squared.
          const double step = 1e-4;
          SolidPatterns<double> up = x;
          SolidPatterns<double> down = x;
          up.of[p].*axis += step;
          down.of[p].*axis -= step;
          return (solid_geometry(up, exact).volume - solid_geometry(down, exact).volume) / (2 * step);
        };
        using Vec = math::PackVec3<double>;
        off.compare(derivative(&Vec::x), g.gradient[p].x);
        off.compare(derivative(&Vec::y), g.gradient[p].y);
        off.compare(derivative(&Vec::z), g.gradient[p].z);
      }
    }
}

/// A free box with the sides a_i that strains evenly has omega^2 = 4 c^2 (s max + (1 - s) sum) of 1 / a_i^2,
/// s = 2 mu / (lambda + 2 mu).
TEST(OnePointHexahedron, StepIsThatOfTheFreeBox) {
  model::Model model = one_cube(Form::ExactVolumeViscous);
  for (auto& x : model.nodes.position) x[2] *= 0.25;
  Driven body(model, {Precision::Double, available_isas().back(), 1});
  const double nu = poissons_ratio;
  const double speed = std::sqrt(youngs_modulus * (1 - nu) / (density * (1 + nu) * (1 - 2 * nu)));
  const double shear_share = (1 - 2 * nu) / (1 - nu);
  const double length = 1 / std::sqrt(shear_share * 4 + (1 - shear_share) * (0.25 + 0.25 + 4));
  EXPECT_NEAR(stable_step(body.domain, body.domain.solids[0]), length / speed, 1e-12 / speed);
  body.update(0);
  // It goes with the third root of the volume; the mode that it damps with the length.
  const double viscosity = 0.06 * std::cbrt(2.0) / (std::sqrt(3.0) * length);
  test::verified("hexahedron 2 x 2 x 0.5: step times wave speed", "free box, with bulk viscosity")
      .near(body.domain.clock.element_limit * speed, length / (viscosity + std::hypot(viscosity, 1)), 1e-12);
}

TEST(OnePointHexahedron, OfNegativeVolumeIsRefusedByName) {
  model::Model model = one_cube(Form::StandardViscous);
  std::swap(model.solids[0].node[0], model.solids[0].node[4]);
  std::swap(model.solids[0].node[1], model.solids[0].node[5]);
  std::swap(model.solids[0].node[2], model.solids[0].node[6]);
  std::swap(model.solids[0].node[3], model.solids[0].node[7]);
  try {
    Driven body(model, {Precision::Double, available_isas().back(), 1});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("Solid 1 has no positive volume"), std::string::npos);
  }
}

}  // namespace
}  // namespace crumple::elements::testing::hexahedron_test
