// SPDX-License-Identifier: BSD-3-Clause
// What full integration with assumed strains promises: exact patches for bending, twist and shear on any
// mesh, and no locking in a single row of elements.
#include <gtest/gtest.h>

#include "elements/shell_harness.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::elements::testing::fully_integrated_test {
namespace {

constexpr double plane = youngs_modulus / (1 - poissons_ratio * poissons_ratio);
constexpr double shear_modulus = 0.5 * youngs_modulus / (1 + poissons_ratio);
constexpr double small = 1e-17;  // curvatures: the square of the slope is below round-off

bool inside(const Driven& patch, Index node, double size) {
  const Vec3 x = patch.domain.nodes.position[node];
  return x.x > 0.15 * size && x.x < 0.85 * size && x.y > 0.15 * size && x.y < 0.85 * size;
}

double largest(const Driven& patch, bool moments, bool only_inside) {
  double found = 0;
  for (Index i = 0; i < patch.domain.nodes.count(); ++i)
    if (!only_inside || inside(patch, i, 20))
      found = test::larger_of(found, norm(moments ? patch.moment(i) : patch.force(i)));
  return found;
}

/// The stress invariants of a bending state: they do not depend on each element's axes.
struct Invariants {
  double sum, deviator;
};
Invariants invariants(double xx, double yy, double xy) {
  return {xx + yy, std::hypot(xx - yy, 2 * xy)};
}

/// Cylindrical bending, saddle, twist and all of them on a distorted mesh: stresses of all points in plane
/// and through the thickness are exact, there is no transverse shear, the inside is in equilibrium.
TEST(FullyIntegratedShell, BendsExactlyOnDistortedMeshes) {
  struct Curvature {
    double xx, yy, xy;
  };
  const Curvature curvatures[] = {
      {small, 0, 0}, {0, small, 0}, {0, 0, small}, {small, -0.6 * small, 0.8 * small}};
  const double outer = 0.5 * thickness * std::sqrt(0.6);
  const std::string bent = "ELFORM 16, bending and twist on distorted meshes, in units of round-off: ";
  const char* const source = "Kirchhoff's plate, exact";
  test::Largest stresses(bent + "stress over E k t, error", source, 1e2);
  test::Largest shears(bent + "transverse shear over E k t", source, 1e3);
  test::Largest forces(bent + "forces inside over the largest moment", "equilibrium", 1e3);
  for (const auto& execution : all_executions())
    for (const Curvature& k : curvatures) {
      Driven patch(plate(fully_integrated.formulation, 4, 0.25), execution);
      std::vector<Vec3> u;
      std::vector<Vec3> r;
      for (const Vec3& x : patch.domain.nodes.position) {
        u.push_back({0, 0, 0.5 * k.xx * x.x * x.x + 0.5 * k.yy * x.y * x.y + k.xy * x.x * x.y});
        r.push_back({k.yy * x.y + k.xy * x.x, -(k.xx * x.x + k.xy * x.y), 0});
      }
      patch.step(1e-7, u, r);
      const Invariants expected =
          invariants(outer * plane * (k.xx + poissons_ratio * k.yy),
                     outer * plane * (k.yy + poissons_ratio * k.xx), outer * shear_modulus * 2 * k.xy);
      // Transverse shear is the difference of slopes over the patch, of size curvature times 20.
      const double unit = round_off(execution) * youngs_modulus * small * thickness;
      const std::string name = name_of(execution);
      for (Index e = 0; e < patch.block().elements; ++e)
        for (Index point = 0; point < 12; point += 3) {
          for (const Index p : {point, point + 2}) {
            const Invariants found =
                invariants(patch.stress(e, p, 0), patch.stress(e, p, 1), patch.stress(e, p, 2));
            stresses.compare(found.sum, (p == point ? 1 : -1) * expected.sum, unit, name);
            stresses.compare(found.deviator, expected.deviator, unit, name);
            shears.compare(patch.stress(e, p, 3), 0, unit, name);
            shears.compare(patch.stress(e, p, 4), 0, unit, name);
          }
          stresses.compare(patch.stress(e, point + 1, 0), 0, unit, name);
        }
      const double moments = largest(patch, true, false);
      EXPECT_GT(moments, 0.01 * youngs_modulus * small * std::pow(thickness, 3));
      forces.add(largest(patch, true, true) / (round_off(execution) * moments), name);
      forces.add(largest(patch, false, true) / (round_off(execution) * moments), name);
    }
}

/// A surface that tilts under normals that stay: the same transverse shear everywhere, on any mesh.
TEST(FullyIntegratedShell, ShearsExactlyOnDistortedMeshes) {
  const double slope = 1e-16;
  test::Largest off(
      "ELFORM 16, transverse shear on distorted meshes: stress, relative error in units of round-off",
      "constant shear, exact", 1e2);
  for (const auto& execution : all_executions()) {
    Driven patch(plate(fully_integrated.formulation, 4, 0.25), execution);
    std::vector<Vec3> u;
    for (const Vec3& x : patch.domain.nodes.position) u.push_back({0, 0, slope * (x.x - 0.5 * x.y)});
    patch.step(1e-7, u, std::vector<Vec3>(u.size()));
    const double expected = shear_modulus * slope * std::hypot(1, 0.5);
    const double tolerance = 1e2 * round_off(execution) * expected;
    for (Index e = 0; e < patch.block().elements; ++e)
      for (Index p = 0; p < 12; ++p)
        off.compare(std::hypot(patch.stress(e, p, 3), patch.stress(e, p, 4)), expected,
                    round_off(execution) * expected, name_of(execution));
    EXPECT_LT(largest(patch, false, true), 10 * tolerance * thickness * 5);
  }
}

/// Bending in its own plane of one rectangular element, long or high: the nodes move as in a beam, the
/// energy is that of the beam. (The plain bilinear element has (1 + (1 - nu) / 2 (a / b)^2) / (1 - nu^2) of
/// it.) Pian & Sumihara (1984).
TEST(FullyIntegratedShell, BendsInItsPlaneLikeABeam) {
  test::Largest off("ELFORM 16, bent in its plane, aspects from 0.5 to 20: energy over exact, off 1",
                    "Pian and Sumihara 1984, beam", 1e-12);
  for (const double aspect : {0.5, 1.0, 5.0, 20.0})
    off.compare(in_plane_bending_energy(fully_integrated.formulation, aspect), 1, 1, std::to_string(aspect));
}

}  // namespace
}  // namespace crumple::elements::testing::fully_integrated_test
