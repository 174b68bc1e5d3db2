// SPDX-License-Identifier: BSD-3-Clause
// States of constant strain on meshes of any shape.
#include <gtest/gtest.h>

#include "shell_harness.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::elements::testing::patch_test {
namespace {

const Vec3 tilt_axis = math::normalised({1, 2, -0.5});
constexpr double tilt = 0.7;

Vec3 tilted(const Vec3& x) {
  return rotated(x, tilt_axis, tilt);
}
Vec3 flat(const Vec3& x) {
  return rotated(x, tilt_axis, -tilt);
}

/// Nodes of the patch's inside, by distance from the middle.
bool inside(const model::Model& model, const Driven& patch, Index node) {
  const auto& shells = model.shells;
  int elements = 0;
  for (const auto& shell : shells)
    for (const Index n : shell.node) elements += n == patch.domain.nodes.model_node[node] ? 1 : 0;
  return elements == 4;
}

double largest_inside(const model::Model& model, const Driven& patch, bool moments) {
  double largest = 0;
  for (Index i = 0; i < patch.domain.nodes.count(); ++i)
    if (inside(model, patch, i))
      largest = test::larger_of(largest, norm(moments ? patch.moment(i) : patch.force(i)));
  return largest;
}
double largest_anywhere(const Driven& patch, bool moments) {
  double largest = 0;
  for (Index i = 0; i < patch.domain.nodes.count(); ++i)
    largest = test::larger_of(largest, norm(moments ? patch.moment(i) : patch.force(i)));
  return largest;
}

/// A constant displacement gradient on a distorted mesh, tilted in space: every element has the same stress,
/// that of the strain at the middle of the step, and the nodes inside are in equilibrium. Hourglass control
/// stays on: it must not feel a linear field.
TEST(MembranePatch, IsExactOnDistortedMeshes) {
  const double gxx = 3e-4;
  const double gyy = -2e-4;
  const double gxy = 5e-4;
  const double gyx = -1e-4;
  // Strain at the middle of the step: sym(G (1 + G/2)^-1), G = [gxx gxy; gyx gyy].
  const double a = 1 + gxx / 2;
  const double b = gxy / 2;
  const double c = gyx / 2;
  const double d = 1 + gyy / 2;
  const double det = a * d - b * c;
  const double exx = (gxx * d - gxy * c) / det;
  const double eyy = (-gyx * b + gyy * a) / det;
  const double exy = (-gxx * b + gxy * a + gyx * d - gyy * c) / det;  // engineering shear
  const double plane = youngs_modulus / (1 - poissons_ratio * poissons_ratio);
  const double sum = plane * (1 + poissons_ratio) * (exx + eyy);
  const double difference = plane * (1 - poissons_ratio) * (exx - eyy);
  const double shear = 0.5 * youngs_modulus / (1 + poissons_ratio) * exy;
  const double deviator = std::hypot(difference, 2 * shear);

  for (const Kind& kind : quadrilaterals) {
    const std::string patched =
        std::string(kind.name) + ", membrane patch, distorted, over what rounding allows: ";
    test::Largest stresses(patched + "stresses, error", "constant strain, exact", 1);
    test::Largest forces(patched + "forces inside", "equilibrium", 5);
    for (const auto& execution : all_executions()) {
      model::Model model = plate(kind.formulation, 4, 0.25);
      place(model, tilted);
      Driven patch(model, execution);
      patch.step(
          1e-7,
          [&](const Vec3& x) {
            const Vec3 p = flat(x);
            return tilted({p.x + gxx * p.x + gxy * p.y, p.y + gyx * p.x + gyy * p.y, 0});
          },
          [](const Vec3&) { return Vec3{}; });
      // The displacements are differences of positions in double; in mixed precision the velocities, of size
      // |G| x, are rounded once more.
      const double tolerance = 20 * 2.2e-16 * youngs_modulus + 1e2 * round_off(execution) * std::fabs(sum);
      for (Index e = 0; e < patch.block().elements; ++e)
        for (Index p = 0; p < 3; ++p) {
          const double sxx = patch.stress(e, p, 0);
          const double syy = patch.stress(e, p, 1);
          stresses.compare(sxx + syy, sum, tolerance, name_of(execution));
          stresses.compare(std::hypot(sxx - syy, 2 * patch.stress(e, p, 2)), deviator, tolerance);
          stresses.compare(patch.stress(e, p, 3), 0, tolerance);
          stresses.compare(patch.stress(e, p, 4), 0, tolerance);
        }
      const double boundary = largest_anywhere(patch, false);
      EXPECT_GT(boundary, 0.1 * std::fabs(sum) * thickness);
      forces.add(largest_inside(model, patch, false) / (thickness * tolerance));
      EXPECT_LT(patch.block().hourglass_energy,
                1e4 * round_off(execution) * round_off(execution) * patch.block().internal_energy * 1e4);
    }
  }
}

/// Cylindrical bending, saddle and twist with Kirchhoff rotations, small displacements.
struct Curvature {
  double xx, yy, xy;
};

std::vector<Vec3> deflection(const Driven& patch, const Curvature& k) {
  std::vector<Vec3> u;
  for (const Vec3& x : patch.domain.nodes.position)
    u.push_back({0, 0, 0.5 * k.xx * x.x * x.x + 0.5 * k.yy * x.y * x.y + k.xy * x.x * x.y});
  return u;
}
std::vector<Vec3> rotation(const Driven& patch, const Curvature& k) {
  std::vector<Vec3> r;
  for (const Vec3& x : patch.domain.nodes.position)
    r.push_back({k.yy * x.y + k.xy * x.x, -(k.xx * x.x + k.xy * x.y), 0});
  return r;
}

/// So small that the square of the slope is below round-off.
constexpr double unit_curvature = 1e-17;
const Curvature curvatures[] = {{unit_curvature, 0, 0},
                                {0, unit_curvature, 0},
                                {0, 0, unit_curvature},
                                {unit_curvature, -0.6 * unit_curvature, 0.8 * unit_curvature}};

/// On parallelograms the stresses are exact and the inside is in equilibrium, without hourglass control
/// (which cannot tell a twist from its warping mode).
TEST(BendingPatch, IsExactOnParallelograms) {
  const double plane = youngs_modulus / (1 - poissons_ratio * poissons_ratio);
  const double shear_modulus = 0.5 * youngs_modulus / (1 + poissons_ratio);
  const double outer = 0.5 * thickness * std::sqrt(0.6);
  for (const Kind& kind : kinds) {
    const std::string patched =
        std::string(kind.name) + ", bending patch, parallelograms, in units of round-off: ";
    test::Largest stresses(patched + "stresses over E k t, error", "Kirchhoff's plate, exact", 1e2);
    test::Largest moments_inside(patched + "moments inside over the largest", "equilibrium", 5e2);
    for (const auto& execution : all_executions())
      for (const Curvature& k : curvatures) {
        model::Model model = plate(kind.formulation, 4, 0);
        model.control.hourglass = no_hourglass_control();
        place(model, [](const Vec3& x) { return Vec3{x.x + 0.4 * x.y, 0.8 * x.y, 0}; });
        Driven patch(model, execution);
        patch.step(1e-7, deflection(patch, k), rotation(patch, k));
        const double unit = youngs_modulus * unit_curvature * thickness;
        const double rounding = round_off(execution) * unit;
        const double tolerance = 1e2 * rounding;
        // e1 lies along x: side 1-2 is parallel to it. The strain is -z times the curvature.
        for (Index e = 0; e < patch.block().elements; ++e) {
          stresses.compare(patch.stress(e, 2, 0), -outer * plane * (k.xx + poissons_ratio * k.yy), rounding);
          stresses.compare(patch.stress(e, 2, 1), -outer * plane * (k.yy + poissons_ratio * k.xx), rounding);
          stresses.compare(patch.stress(e, 2, 2), -outer * shear_modulus * 2 * k.xy, rounding);
          stresses.compare(patch.stress(e, 1, 0), 0, rounding);
          EXPECT_NEAR(patch.stress(e, 2, 3), 0, 10 * tolerance);
          EXPECT_NEAR(patch.stress(e, 2, 4), 0, 10 * tolerance);
        }
        const double moments = largest_anywhere(patch, true);
        EXPECT_GT(moments, 0.01 * unit * thickness * thickness);
        moments_inside.add(largest_inside(model, patch, true) / (round_off(execution) * moments),
                           name_of(execution));
      }
  }
}

/// On distorted meshes one-point shells without projected shear are not exact: the gradient of a quadratic
/// deflection is off by curvature times element size, which shows as transverse shear. It must vanish with
/// first order.
TEST(BendingPatch, ErrorOnDistortedMeshesVanishesWithFirstOrder) {
  for (const Kind& kind : {belytschko_tsay, hughes_liu}) {
    double error[3] = {};
    int run = 0;
    for (const Index n : {8, 16, 32}) {
      model::Model model = test::one_part(elastic(), test::shell_section(thickness, 3, kind.formulation));
      model.control.hourglass = no_hourglass_control();
      add_distorted_grid(model, n, 80.0 / n, 0.25);
      Driven patch(model, {Precision::Double, available_isas().back(), 1});
      const Curvature& k = curvatures[3];
      patch.step(1e-7, deflection(patch, k), rotation(patch, k));
      double square = 0;
      for (Index e = 0; e < patch.block().elements; ++e)
        square += std::pow(patch.stress(e, 1, 3), 2) + std::pow(patch.stress(e, 1, 4), 2);
      // Over the bending stress at the surface.
      error[run++] =
          std::sqrt(square / patch.block().elements) / (youngs_modulus * 0.5 * thickness * unit_curvature);
    }
    EXPECT_NEAR(error[0] / error[1], 2, 0.35) << kind.name;
    test::verified(std::string(kind.name) + ", bent distorted mesh: shear of 16 x 16 over that of 32 x 32",
                   "first order")
        .near(error[1] / error[2], 2, 0.25);
    std::printf("%s: spurious transverse shear over surface bending stress, h = 10, 5, 2.5: %.3f %.3f %.3f\n",
                kind.name, error[0], error[1], error[2]);
  }
}

/// Transverse shear: a plate whose normals stay while the surface tilts. Each stress is sqrt(kappa) G gamma
/// and the nodal forces carry kappa G gamma.
TEST(ShearPatch, CarriesTheShearFactorOnce) {
  test::Largest factors("five shells, constant transverse shear: force, relative error in units of round-off",
                        "kappa G gamma", 1e2);
  for (const Kind& kind : kinds)
    for (const auto& execution : all_executions()) {
      model::Model model = plate(kind.formulation, 4, 0.25);
      model.shell_sections[0].shear_factor = 5.0 / 6.0;
      Driven patch(model, execution);
      const double slope = 1e-16;  // its square is below round-off
      patch.step(
          1e-7,
          [&](const Vec3& x) {
            return Vec3{x.x, x.y, slope * x.x};
          },
          [](const Vec3&) { return Vec3{}; });
      const double shear_modulus = 0.5 * youngs_modulus / (1 + poissons_ratio);
      double edge = 0;
      double area = 0;
      for (Index i = 0; i < patch.domain.nodes.count(); ++i) {
        edge -= patch.force(i).z * patch.domain.nodes.position[i].x;
        area += patch.domain.nodes.mass[i] / (density * thickness);
      }
      const double expected = 5.0 / 6.0 * shear_modulus * slope * thickness * area;
      factors.compare(edge, expected, round_off(execution) * expected, kind.name);
      EXPECT_NEAR(patch.block().internal_energy, 0.5 * expected * slope,
                  1e3 * round_off(execution) * expected * slope);
    }
}

/// Triangles, as quadrilaterals with a repeated node, pass the membrane patch test too and have no hourglass.
TEST(MembranePatch, HoldsForTriangles) {
  for (const Kind& kind : quadrilaterals) {
    model::Model model = test::one_part(elastic(), test::shell_section(thickness, 3, kind.formulation));
    add_distorted_grid(model, 3, 5, 0.2);
    split_into_triangles(model);
    Driven patch(model, {Precision::Double, available_isas().back(), 1});
    patch.step(
        1e-7,
        [](const Vec3& x) {
          return Vec3{x.x * (1 + 1e-6), x.y * (1 + 1e-6), 0};
        },
        [](const Vec3&) { return Vec3{}; });
    const double expected = youngs_modulus / (1 - poissons_ratio) * 1e-6;
    for (Index e = 0; e < patch.block().elements; ++e) {
      EXPECT_NEAR(patch.stress(e, 1, 0), expected, 2e-6 * expected);
      EXPECT_NEAR(patch.stress(e, 1, 1), expected, 2e-6 * expected);
      EXPECT_NEAR(patch.stress(e, 1, 2), 0, 1e-9 * expected);
    }
    for (Index i = 0; i < patch.domain.nodes.count(); ++i) {
      const Vec3 x = patch.domain.nodes.position[i];
      if (x.x > 3 && x.x < 12 && x.y > 3 && x.y < 12) {
        EXPECT_LT(norm(patch.force(i)), 20 * 2.2e-16 * youngs_modulus * thickness * 5);
      }
    }
    EXPECT_LT(patch.block().hourglass_energy, 1e-20 * patch.block().internal_energy);
  }
}

}  // namespace
}  // namespace crumple::elements::testing::patch_test
