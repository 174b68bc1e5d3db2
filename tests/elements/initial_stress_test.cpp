// SPDX-License-Identifier: BSD-3-Clause
// Stresses at time zero: turned into the elements' axes, interpolated through the thickness, in the first
// forces.
#include "elements/initial_stress.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "elements/shell_harness.hpp"
#include "support/largest.hpp"

namespace crumple::elements::testing::initial_stress_test {
namespace {

const Vec3 tilt_axis = math::normalised({1, 2, -0.5});
constexpr double tilt = 0.7;
const domain::Execution plain{Precision::Double, Isa::Scalar, 1};

using Tensor = std::array<double, 6>;

/// The tensor whose components in axes turned by the tilt are those given.
Tensor tilted(const Tensor& own) {
  const double t[3][3] = {{own[0], own[3], own[5]}, {own[3], own[1], own[4]}, {own[5], own[4], own[2]}};
  const Vec3 axis[3] = {rotated({1, 0, 0}, tilt_axis, tilt), rotated({0, 1, 0}, tilt_axis, tilt),
                        rotated({0, 0, 1}, tilt_axis, tilt)};
  double sum[3][3] = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) sum[i][j] += t[a][b] * axis[a][i] * axis[b][j];
  return {sum[0][0], sum[1][1], sum[2][2], sum[0][1], sum[1][2], sum[0][2]};
}

/// All shells of a model begin with these points.
void begin_with(model::Model& model, int planes, const std::vector<model::InitialPointStress>& points) {
  for (std::size_t i = 0; i < model.shells.size(); ++i)
    model.shell_stresses.push_back({.element = static_cast<Index>(i), .planes = planes, .points = points});
}

/// A plate that is stretched has forces; the same plate, stretched from the beginning, with the stress given
/// in global axes has the same.
TEST(InitialStress, HasTheForcesOfTheStrainThatMakesIt) {
  for (const Kind& kind : all_kinds) {
    test::Largest off(
        std::string(kind.name) + ", tilted plate that begins stretched: forces, relative difference",
        "plate that is stretched", 1e-11);
    const auto stretched = [](const Vec3& x) {
      return Vec3{1.001 * x.x + 2e-4 * x.y, 0.9995 * x.y + 2e-4 * x.x, 0};
    };
    Driven pulled(plate(kind.formulation, 3, 0), plain);
    pulled.step(1e-7, stretched, [](const Vec3&) { return Vec3{}; });
    // e1 lies along x at first, and again when the plate begins: the stretch is symmetric.
    model::Model model = plate(kind.formulation, 3, 0);
    place(model, [&](const Vec3& x) { return rotated(stretched(x), tilt_axis, tilt); });
    std::vector<model::InitialPointStress> point(1);
    const double plane = youngs_modulus / (1 - poissons_ratio * poissons_ratio);
    // Strain at the middle of the step, G (1 + G/2)^-1 with the symmetric G.
    const double a = 1 + 0.5e-3;
    const double d = 1 - 0.25e-3;
    const double b = 1e-4;
    const double det = a * d - b * b;
    const double exx = (1e-3 * d - 2e-4 * b) / det;
    const double eyy = (-5e-4 * a - 2e-4 * b) / det;
    const double exy = (2e-4 * a - 1e-3 * b) / det;
    point[0].stress = tilted({plane * (exx + poissons_ratio * eyy), plane * (eyy + poissons_ratio * exx), 0,
                              youngs_modulus / (1 + poissons_ratio) * exy, 0, 0});
    begin_with(model, 1, point);
    Driven body(model, plain);
    body.update(0);
    // Each model numbers its nodes along a curve in space.
    const auto at = [](const Driven& of, Index i) {
      return of.force(of.domain.nodes.domain_node[static_cast<std::size_t>(i)]);
    };
    double size = 0;
    for (Index i = 0; i < model.nodes.count(); ++i) size = std::fmax(size, norm(at(pulled, i)));
    EXPECT_GT(size, 100);
    for (Index i = 0; i < model.nodes.count(); ++i)
      off.add(norm(at(body, i) - rotated(at(pulled, i), tilt_axis, tilt)) / size);
  }
}

/// Points at other places: linear between and beyond them; points in plane one by one, or their mean.
TEST(InitialStress, IsInterpolatedThroughTheThickness) {
  std::vector<model::InitialPointStress> points;
  for (int k = 0; k < 4; ++k)
    for (const double place : {-0.5, 0.5}) {
      model::InitialPointStress point;
      point.place = place;
      point.stress[0] = 100.0 * k + 40 * place;
      point.plastic_strain = 0.01 * (k + 1);
      points.push_back(point);
    }
  const double outer = std::sqrt(0.6);
  model::Model one = plate(belytschko_tsay.formulation, 1, 0, 3, plastic(1));
  begin_with(one, 4, points);
  Driven mean(one, plain);
  EXPECT_NEAR(mean.stress(0, 0, 0), 150 - 40 * outer, 1e-10);
  EXPECT_NEAR(mean.stress(0, 1, 0), 150, 1e-10);
  EXPECT_NEAR(mean.stress(0, 2, 0), 150 + 40 * outer, 1e-10);
  EXPECT_NEAR(mean.item("plastic_strain", 0, 1), 0.025, 1e-15);
  model::Model full = plate(fully_integrated.formulation, 1, 0, 3, plastic(1));
  begin_with(full, 4, points);
  Driven each(full, plain);
  for (Index plane = 0; plane < 4; ++plane) {
    EXPECT_NEAR(each.stress(0, 3 * plane + 2, 0), 100.0 * static_cast<double>(plane) + 40 * outer, 1e-10);
    EXPECT_NEAR(each.item("plastic_strain", 0, 3 * plane), 0.01 * static_cast<double>(plane + 1), 1e-15);
  }
  full.shell_stresses[0].planes = 2;
  EXPECT_THROW(Driven(full, plain), Error);
}

/// The strain of fabric is that which belongs to the stress: it carries on from there.
TEST(InitialStress, OfFabricFindsItsStrain) {
  model::Fabric law;
  law.sheet.modulus_a = 500;
  law.sheet.modulus_b = 300;
  law.sheet.poisson_ba = 0.1;
  law.sheet.shear_ab = 20;
  law.sheet.angle = 0.4;
  law.wrinkles = true;
  law.liner_share = 0.2;
  law.liner_modulus = 50;
  law.liner_ratio = 0.3;
  set_stand_in(law);
  const model::Material cloth{.id = 1, .title = "cloth", .density = density, .law = law};
  model::Model model = plate(full_membrane.formulation, 1, 0, 1, cloth);
  std::vector<model::InitialPointStress> point(1);
  point[0].stress = {3, 2, 0, 0.5, 0, 0};
  begin_with(model, 1, point);
  Driven body(model, plain);
  body.update(0);
  EXPECT_NEAR(body.stress(0, 0, 0), 3, 1e-12);
  EXPECT_NEAR(body.stress(0, 0, 1), 2, 1e-12);
  EXPECT_NEAR(body.stress(0, 0, 2), 0.5, 1e-12);
}

}  // namespace
}  // namespace crumple::elements::testing::initial_stress_test
