// SPDX-License-Identifier: BSD-3-Clause
// What sets the Hughes-Liu shell apart: layers of a warped solid, and fibres that stay normal in a fold.
#include <gtest/gtest.h>

#include <numbers>

#include "elements/shell_harness.hpp"
#include "support/largest.hpp"

namespace crumple::elements::testing::hughes_liu_test {
namespace {

using Corners = std::array<Vec3, 4>;

/// One element over a parallelogram, its corners alternately `warp` above and below the plane.
model::Model warped_element(const Kind& kind, double warp) {
  model::Model model = test::one_part(elastic(), test::shell_section(thickness, 3, kind.formulation));
  model.control.hourglass = no_hourglass_control();
  model.nodes.id = {1, 2, 3, 4};
  model.nodes.position = {{0, 0, warp}, {6, 1, -warp}, {8, 6, warp}, {2, 5, -warp}};
  model.shells.push_back({.id = 1, .part = 0, .node = {0, 1, 2, 3}});
  return model;
}

/// Derivatives of a bilinear field by xi and eta.
Vec3 by_xi(const Corners& f, double eta) {
  return 0.25 * ((1 - eta) * (f[1] - f[0]) + (1 + eta) * (f[2] - f[3]));
}
Vec3 by_eta(const Corners& f, double xi) {
  return 0.25 * ((1 - xi) * (f[3] - f[0]) + (1 + xi) * (f[2] - f[1]));
}
constexpr double corner_xi[] = {-1, 1, 1, -1};
constexpr double corner_eta[] = {-1, -1, 1, 1};

/// Displacement gradient of the degenerated solid at the centre, a height z above the reference surface,
/// straight from its definition: x = sum N (x_I + z y_I), y_I normal to the surface, u = sum N (u_I + z r x
/// y_I).
struct Gradient {
  Vec3 along[3];    ///< change of u along each base vector
  Vec3 inverse[3];  ///< rows of the inverse Jacobian

  double operator()(const Vec3& row, const Vec3& column) const {
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += dot(row, along[k]) * dot(inverse[k], column);
    return sum;
  }
};
Gradient solid_gradient(const Corners& x, const Corners& u, const Corners& r, double z) {
  Corners y;
  Corners turned;
  Vec3 mean;
  Vec3 mean_turned;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 normal = cross(by_xi(x, corner_eta[k]), by_eta(x, corner_xi[k]));
    y[k] = (1 / normal.z) * normal;
    turned[k] = cross(r[k], y[k]);
    mean += 0.25 * y[k];
    mean_turned += 0.25 * turned[k];
  }
  const Vec3 a = by_xi(x, 0) + z * by_xi(y, 0);
  const Vec3 b = by_eta(x, 0) + z * by_eta(y, 0);
  const double volume = dot(cross(a, b), mean);
  return {{by_xi(u, 0) + z * by_xi(turned, 0), by_eta(u, 0) + z * by_eta(turned, 0), mean_turned},
          {(1 / volume) * cross(b, mean), (1 / volume) * cross(mean, a), (1 / volume) * cross(a, b)}};
}

TEST(HughesLiuShell, LayersAreThoseOfTheDegeneratedSolid) {
  const Kind& kind = hughes_liu;
  const model::Model model = warped_element(kind, 0.7);
  Driven body(model, {Precision::Double, available_isas().back(), 1});
  std::mt19937 generator(17);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Corners x;
  Corners u;
  Corners r;
  std::vector<Vec3> displacement;
  std::vector<Vec3> rotation;
  const double size = 1e-9;
  for (Index node = 0; node < 4; ++node) {
    const auto k = static_cast<std::size_t>(body.domain.nodes.model_node[node]);
    x[k] = body.domain.nodes.position[node];
    u[k] = size * Vec3{uniform(generator), uniform(generator), uniform(generator)};
    r[k] = size * Vec3{uniform(generator), uniform(generator), uniform(generator)};
    displacement.push_back(u[k]);
    rotation.push_back(r[k]);
  }
  body.step(1, displacement, rotation);

  const Vec3 e1 = math::normalised(by_xi(x, 0));
  const Vec3 e3{0, 0, 1};
  const Vec3 e2 = cross(e3, e1);
  const double plane = youngs_modulus / (1 - poissons_ratio * poissons_ratio);
  const double shear = 0.5 * youngs_modulus / (1 + poissons_ratio);
  const double root = std::sqrt(model.shell_sections[0].shear_factor);
  test::Largest off("warped Hughes-Liu element, random motion: stresses over E u, error",
                    "degenerated solid, from its "
                    "definition",
                    1e-9);
  for (Index p = 0; p < 3; ++p) {
    const Gradient d = solid_gradient(x, u, r, 0.5 * thickness * std::sqrt(0.6) * (p - 1));
    const double xx = d(e1, e1);
    const double yy = d(e2, e2);
    const double expected[] = {plane * (xx + poissons_ratio * yy), plane * (yy + poissons_ratio * xx),
                               shear * (d(e1, e2) + d(e2, e1)), root * shear * (d(e2, e3) + d(e3, e2)),
                               root * shear * (d(e3, e1) + d(e1, e3))};
    for (Index c = 0; c < 5; ++c) off.compare(body.stress(0, p, c), expected[c], youngs_modulus * size);
  }
}

/// The ends of one element turn against each other until they are nearly folded together, as at the crest of
/// a fold. The plastic hinge keeps its moment: fibres that turned with the nodes would lose it with the
/// square of the cosine of half the angle and leave the element without a volume at 180 degrees.
TEST(Fold, KeepsItsPlasticMoment) {
  constexpr double yield = 250;
  for (const Kind& kind : kinds) {
    model::Model model = plate(kind.formulation, 1, 0, 3, plastic(1, 1e-3));
    Driven body(model, {Precision::Double, available_isas().back(), 1});
    constexpr int steps = 2000;
    const double half_angle = 85 * std::numbers::pi / 180;
    test::Largest off(std::string(kind.name) + ", folded by 170 degrees: plastic moment, relative error",
                      "plane strain, closed form", 2e-5);
    // Both outer points yield in plane strain across the fold: sigma = 2 / sqrt(3) yield.
    const double lever = 0.5 * thickness * std::sqrt(0.6);
    const double expected = 5 * thickness * 2 * (5.0 / 18) * lever * 2 / std::sqrt(3.0) * yield;
    for (int i = 1; i <= steps; ++i) {
      body.step(
          1e-7, [](const Vec3& x) { return x; },
          [&](const Vec3& x) {
            return Vec3{0, (x.x > 2.5 ? 1 : -1) * half_angle / steps, 0};
          });
      if (i % 200 != 0) continue;
      double moment = 0;
      for (Index n = 0; n < 4; ++n)
        if (body.domain.nodes.position[n].x > 2.5) moment -= body.moment(n).y;
      off.compare(moment, expected, expected, "step " + std::to_string(i));
    }
  }
}

}  // namespace
}  // namespace crumple::elements::testing::hughes_liu_test
