// SPDX-License-Identifier: BSD-3-Clause
// Belytschko-Wong-Chiang shells: what the projected shear and the warp's coupling make exact that
// Belytschko-Tsay's flat elements miss.
#include <gtest/gtest.h>

#include "elements/shell_harness.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::elements::testing::warped_shell_test {
namespace {

constexpr double plane = youngs_modulus / (1 - poissons_ratio * poissons_ratio);
constexpr double shear_modulus = 0.5 * youngs_modulus / (1 + poissons_ratio);

/// Bending and twist on a flat distorted mesh, without hourglass control (which cannot tell a twist from its
/// warping mode). Returns the largest transverse shear stress over the bending stress of the surface.
double shear_in_bending(const Kind& kind, const domain::Execution& execution, double* unbalanced) {
  constexpr double size = 1e-17;  // its square is below round-off
  constexpr Index n = 8;
  model::Model model = plate(kind.formulation, n, 0.25);
  model.control.hourglass = no_hourglass_control();
  Driven patch(model, execution);
  std::vector<Vec3> u;
  std::vector<Vec3> r;
  for (const Vec3& x : patch.domain.nodes.position) {
    u.push_back({0, 0, size * (0.5 * x.x * x.x - 0.3 * x.y * x.y + 0.8 * x.x * x.y)});
    r.push_back({size * (-0.6 * x.y + 0.8 * x.x), -size * (x.x + 0.8 * x.y), 0});
  }
  patch.step(1e-7, u, r);
  double largest = 0;
  for (Index e = 0; e < patch.block().elements; ++e)
    largest = test::larger_of(largest, std::hypot(patch.stress(e, 1, 3), patch.stress(e, 1, 4)));
  double moment = 0;
  double inside = 0;
  for (Index i = 0; i < patch.domain.nodes.count(); ++i) {
    const Index node = patch.domain.nodes.model_node[i];
    const Index column = node % (n + 1);
    const Index row = node / (n + 1);
    moment = test::larger_of(moment, norm(patch.moment(i)));
    if (column > 0 && column < n && row > 0 && row < n)
      inside = test::larger_of(inside, norm(patch.moment(i)));
  }
  *unbalanced = inside / moment;
  return largest / (youngs_modulus * 0.5 * thickness * size);
}

TEST(ProjectedShear, MakesBendingAndTwistExactOnDistortedMeshes) {
  const std::string bent =
      "Belytschko-Wong-Chiang, bending and twist on a distorted mesh, in units of round-off: ";
  test::Largest shears(bent + "transverse shear over bending stress", "Kirchhoff's plate, exact", 1e3);
  test::Largest moments(bent + "moments inside over the largest", "equilibrium", 1e3);
  for (const auto& execution : all_executions()) {
    double unbalanced = 0;
    const double shear = shear_in_bending(belytschko_wong_chiang, execution, &unbalanced);
    shears.add(shear / round_off(execution), name_of(execution));
    moments.add(unbalanced / round_off(execution), name_of(execution));
    const double flat = shear_in_bending(belytschko_tsay, execution, &unbalanced);
    EXPECT_GT(flat, 0.1);
    if (execution.isa == Isa::Scalar)
      std::printf(
          "%s, transverse shear over surface bending: Belytschko-Wong-Chiang %.1e, Belytschko-Tsay %.2f\n",
          name_of(execution).c_str(), shear, flat);
  }
}

/// A surface that tilts under normals that stay has the same shear in every element.
TEST(ProjectedShear, IsExactInConstantShear) {
  test::Largest off(
      "Belytschko-Wong-Chiang, constant transverse shear: stress, relative error in units of round-off",
      "exact", 1e2);
  constexpr double slope = 1e-16;
  for (const auto& execution : all_executions()) {
    Driven patch(plate(model::ShellFormulation::BelytschkoWongChiang, 4, 0.25), execution);
    patch.step(
        1e-7,
        [&](const Vec3& x) {
          return Vec3{x.x, x.y, slope * (x.x + 2 * x.y)};
        },
        [](const Vec3&) { return Vec3{}; });
    const double expected = shear_modulus * slope * std::sqrt(5.0);
    for (Index e = 0; e < patch.block().elements; ++e)
      off.compare(std::hypot(patch.stress(e, 1, 3), patch.stress(e, 1, 4)), expected,
                  round_off(execution) * expected, name_of(execution));
  }
}

using Corners = std::array<Vec3, 4>;

/// Corners of a rectangle a x b whose corners lie +-h out of its plane.
Corners warped_rectangle(double a, double b, double h) {
  return {Vec3{-a / 2, -b / 2, h}, Vec3{a / 2, -b / 2, -h}, Vec3{a / 2, b / 2, h}, Vec3{-a / 2, b / 2, -h}};
}

model::Model one_element(const Kind& kind, const Corners& corner) {
  model::Model model = test::one_part(elastic(), test::shell_section(thickness, 3, kind.formulation));
  model.control.hourglass = no_hourglass_control();
  for (const Vec3& x : corner) {
    model.nodes.id.push_back(model.nodes.count() + 1);
    model.nodes.position.push_back({x.x, x.y, x.z});
  }
  model.shells.push_back({.id = 1, .part = 0, .node = {0, 1, 2, 3}});
  return model;
}

/// Normal of the bilinear surface at a corner, scaled to the component 1 along z.
Vec3 fibre(const Corners& x, std::size_t k) {
  const Vec3 n = cross(x[(k + 1) % 4] - x[k], x[(k + 3) % 4] - x[k]);
  return (1 / n.z) * n;
}

/// Displacement gradient at the centre of the layer at z of the solid x_I + z y_I: d u / d (x, y).
struct Gradient {
  double xx, xy, yx, yy;
};
Gradient layer_gradient(const Corners& x, const Corners& u, const Corners& r, double z) {
  Vec3 place[4];
  Vec3 moved[4];
  for (std::size_t k = 0; k < 4; ++k) {
    place[k] = x[k] + z * fibre(x, k);
    moved[k] = u[k] + z * cross(r[k], fibre(x, k));
  }
  const auto by_xi = [](const Vec3* f) { return 0.25 * ((f[1] - f[0]) + (f[2] - f[3])); };
  const auto by_eta = [](const Vec3* f) { return 0.25 * ((f[3] - f[0]) + (f[2] - f[1])); };
  const Vec3 a = by_xi(place);
  const Vec3 b = by_eta(place);
  const Vec3 ua = by_xi(moved);
  const Vec3 ub = by_eta(moved);
  const double det = a.x * b.y - a.y * b.x;
  return {(ua.x * b.y - ub.x * a.y) / det, (ub.x * a.x - ua.x * b.x) / det, (ua.y * b.y - ub.y * a.y) / det,
          (ub.y * a.x - ua.y * b.x) / det};
}

struct Motion {
  Corners u, r;
};
Driven moved(const Kind& kind, const Corners& x, const Motion& motion) {
  Driven body(one_element(kind, x), {Precision::Double, available_isas().back(), 1});
  std::vector<Vec3> u(4);
  std::vector<Vec3> r(4);
  for (Index i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(body.domain.nodes.model_node[i]);
    u[i] = motion.u[k];
    r[i] = motion.r[k];
  }
  body.step(1, u, r);
  return body;
}
Motion random_motion(double size) {
  std::mt19937 generator(17);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Motion motion;
  for (std::size_t k = 0; k < 4; ++k) {
    motion.u[k] = size * Vec3{uniform(generator), uniform(generator), uniform(generator)};
    motion.r[k] = size * Vec3{uniform(generator), uniform(generator), uniform(generator)};
  }
  return motion;
}

/// In any motion of a warped rectangle the curvature is that of the degenerated solid, the derivative of its
/// strain over the thickness, and the shear along each side is that of the side's mid-point.
TEST(WarpedElement, HasTheCurvatureOfTheDegeneratedSolid) {
  constexpr double size = 1e-9;
  const Corners x = warped_rectangle(5, 4, 0.7);
  const Motion motion = random_motion(size);
  const Gradient up = layer_gradient(x, motion.u, motion.r, 1e-4);
  const Gradient down = layer_gradient(x, motion.u, motion.r, -1e-4);
  const double kxx = (up.xx - down.xx) / 2e-4;
  const double kyy = (up.yy - down.yy) / 2e-4;
  const double kxy = (up.xy + up.yx - down.xy - down.yx) / 2e-4;
  // Opposite sides' mean shear; sides 1-2 and 4-3 lie along x, 1-4 and 2-3 along y.
  const auto along = [&](std::size_t i, std::size_t j) {
    const Vec3 rate = 0.5 * (cross(motion.r[i], fibre(x, i)) + cross(motion.r[j], fibre(x, j)));
    const Vec3 normal = 0.5 * (fibre(x, i) + fibre(x, j));
    return dot(x[j] - x[i], rate) + dot(motion.u[j] - motion.u[i], normal);
  };
  const double shear_x = 0.5 * (along(0, 1) + along(3, 2)) / 5;
  const double shear_y = 0.5 * (along(0, 3) + along(1, 2)) / 4;

  const double z = 0.5 * thickness * std::sqrt(0.6);
  const double unit = youngs_modulus * size;
  const auto error = [&](const Kind& kind) {
    const Driven body = moved(kind, x, motion);
    const auto bending = [&](Index c) { return 0.5 * (body.stress(0, 2, c) - body.stress(0, 0, c)); };
    return std::array{bending(0) - z * plane * (kxx + poissons_ratio * kyy),
                      bending(1) - z * plane * (kyy + poissons_ratio * kxx),
                      bending(2) - z * shear_modulus * kxy, body.stress(0, 1, 3) - shear_modulus * shear_y,
                      body.stress(0, 1, 4) - shear_modulus * shear_x};
  };
  const auto warped = error(belytschko_wong_chiang);
  const auto flat = error(belytschko_tsay);
  test::Largest off("warped Belytschko-Wong-Chiang element, random motion: stresses over E u, error",
                    "degenerated solid", 1e-9);
  for (std::size_t c = 0; c < 5; ++c) {
    off.compare(warped[c], 0, unit, std::to_string(c));
    EXPECT_GT(std::fabs(flat[c]), 1e-3 * unit) << c;
  }
  std::printf("bending stresses, error over E u: with the warp %.0e %.0e %.0e, flat %.3f %.3f %.3f\n",
              warped[0] / unit, warped[1] / unit, warped[2] / unit, flat[0] / unit, flat[1] / unit,
              flat[2] / unit);
}

/// A warped element turns about its normal while its nodes turn only as far as their fibres must, that is not
/// about them: no stress. To a flat element the nodes' rotation looks like a twist.
TEST(WarpedElement, DoesNotFeelRotationsAboutItsFibres) {
  constexpr double angle = 1e-9;
  const Corners x = warped_rectangle(5, 4, 0.7);
  Motion motion;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 y = math::normalised(fibre(x, k));
    motion.u[k] = cross(Vec3{0, 0, angle}, x[k]);
    motion.r[k] = Vec3{0, 0, angle} - (angle * y.z) * y;
  }
  const double warped = moved(belytschko_wong_chiang, x, motion).largest_stress() / (youngs_modulus * angle);
  const double flat = moved(belytschko_tsay, x, motion).largest_stress() / (youngs_modulus * angle);
  std::printf("stress over E times the angle: with the warp %.1e, flat %.3f\n", warped, flat);
  test::verified(
      "warped Belytschko-Wong-Chiang element turned about its fibres: stress over E times the angle", "none")
      .below(warped, 1e-8);
  EXPECT_GT(flat, 0.01);
}

}  // namespace
}  // namespace crumple::elements::testing::warped_shell_test
