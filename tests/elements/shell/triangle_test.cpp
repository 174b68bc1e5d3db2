// SPDX-License-Identifier: BSD-3-Clause
// The C0 triangle: patches that it must pass exactly, its zero modes, and that it does not lock.
#include <gtest/gtest.h>

#include "elements/shell_harness.hpp"
#include "elements/static_solution.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::elements::testing::triangle_test {
namespace {

constexpr double plane = youngs_modulus / (1 - poissons_ratio * poissons_ratio);
constexpr double shear_modulus = 0.5 * youngs_modulus / (1 + poissons_ratio);

/// A symmetric tensor in the plane: xx, yy, xy.
struct Tensor {
  double xx, yy, xy;
};
/// The same in axes turned so that the first lies along `axis`.
Tensor turned(const Tensor& t, const Vec3& axis) {
  const double c = axis.x / norm(axis);
  const double s = axis.y / norm(axis);
  return {c * c * t.xx + s * s * t.yy + 2 * c * s * t.xy, s * s * t.xx + c * c * t.yy - 2 * c * s * t.xy,
          c * s * (t.yy - t.xx) + (c * c - s * s) * t.xy};
}
/// Plane stress of a strain tensor.
Tensor stress_of(const Tensor& e) {
  return {plane * (e.xx + poissons_ratio * e.yy), plane * (e.yy + poissons_ratio * e.xx),
          2 * shear_modulus * e.xy};
}

/// Largest force or moment on the nodes that are not on the edge of a plate of n x n.
double largest_inside(const Driven& patch, Index n, bool moments) {
  double largest = 0;
  for (Index i = 0; i < patch.domain.nodes.count(); ++i) {
    const Index node = patch.domain.nodes.model_node[i];
    const Index column = node % (n + 1);
    const Index row = node / (n + 1);
    if (column == 0 || column == n || row == 0 || row == n) continue;
    largest = test::larger_of(largest, norm(moments ? patch.moment(i) : patch.force(i)));
  }
  return largest;
}

/// Membrane strain, bending and twist together on a distorted mesh; every point has the stress of the exact
/// strain, there is no transverse shear, and the inside is in equilibrium.
TEST(TrianglePatch, MembraneBendingAndTwistAreExact) {
  constexpr double size = 1e-18;  // the square of slopes is below round-off
  const Tensor strain{size, -0.4 * size, 0.7 * size};
  const Tensor curvature{0.5 * size, -0.3 * size, 0.8 * size};
  const std::string patched =
      "C0 triangle, membrane, bending and twist on a distorted mesh, in units of round-off: ";
  test::Largest stresses(patched + "stresses over E e, error", "Kirchhoff's plate, exact", 2e2);
  test::Largest shears(patched + "transverse shear over E e", "none", 1e3);
  test::Largest forces(patched + "forces and moments inside over E e t l", "equilibrium", 1e3);
  for (const auto& execution : all_executions()) {
    constexpr Index n = 4;
    const model::Model model = plate(model::ShellFormulation::Triangle, n, 0.25);
    Driven patch(model, execution);
    std::vector<Vec3> u;
    std::vector<Vec3> r;
    for (const Vec3& x : patch.domain.nodes.position) {
      u.push_back(
          {strain.xx * x.x + strain.xy * x.y, strain.xy * x.x + strain.yy * x.y,
           0.5 * curvature.xx * x.x * x.x + 0.5 * curvature.yy * x.y * x.y + curvature.xy * x.x * x.y});
      r.push_back({curvature.yy * x.y + curvature.xy * x.x, -(curvature.xx * x.x + curvature.xy * x.y), 0});
    }
    patch.step(1e-7, u, r);
    // Displacements of the size of the plate times the strain are rounded once.
    const double unit = round_off(execution) * youngs_modulus * size;
    for (Index e = 0; e < patch.block().elements; ++e) {
      const auto& node = model.shells[patch.block().element[e]].node;
      const auto& a = model.nodes.position[node[0]];
      const auto& b = model.nodes.position[node[1]];
      const Vec3 side{b[0] - a[0], b[1] - a[1], 0};
      for (Index p = 0; p < 3; ++p) {
        const double z = 0.5 * thickness * std::sqrt(0.6) * (p - 1);
        const Tensor expected = stress_of(
            turned({strain.xx - z * curvature.xx, strain.yy - z * curvature.yy, strain.xy - z * curvature.xy},
                   side));
        stresses.compare(patch.stress(e, p, 0), expected.xx, unit, name_of(execution));
        stresses.compare(patch.stress(e, p, 1), expected.yy, unit, name_of(execution));
        stresses.compare(patch.stress(e, p, 2), expected.xy, unit, name_of(execution));
        shears.compare(patch.stress(e, p, 3), 0, unit, name_of(execution));
        shears.compare(patch.stress(e, p, 4), 0, unit, name_of(execution));
      }
    }
    forces.add(largest_inside(patch, n, false) / (unit * thickness * 5));
    forces.add(largest_inside(patch, n, true) / (unit * thickness * 5));
    EXPECT_EQ(patch.block().hourglass_energy, 0);
  }
}

/// A surface that tilts under normals that stay: constant transverse shear in any direction.
TEST(TrianglePatch, TransverseShearIsExact) {
  test::Largest off(
      "C0 triangle, transverse shear on a distorted mesh: stress, relative error in units of round-off",
      "constant shear, exact", 1e2);
  constexpr double slope = 1e-16;
  for (const auto& execution : all_executions()) {
    model::Model model = plate(model::ShellFormulation::Triangle, 4, 0.25);
    model.shell_sections[0].shear_factor = 5.0 / 6.0;
    Driven patch(model, execution);
    patch.step(
        1e-7,
        [&](const Vec3& x) {
          return Vec3{x.x, x.y, slope * (x.x + 2 * x.y)};
        },
        [](const Vec3&) { return Vec3{}; });
    const double expected = std::sqrt(5.0 / 6.0) * shear_modulus * slope * std::sqrt(5.0);
    for (Index e = 0; e < patch.block().elements; ++e)
      off.compare(std::hypot(patch.stress(e, 1, 3), patch.stress(e, 1, 4)), expected,
                  round_off(execution) * expected, name_of(execution));
    EXPECT_LT(largest_inside(patch, 4, false), 1e4 * round_off(execution) * expected * thickness);
  }
}

/// Triangles beside quadrilaterals in one part pass the membrane patch test: each node gets the force of its
/// triangles once.
TEST(TrianglePatch, HoldsBesideQuadrilaterals) {
  for (const Kind& kind : kinds) {
    model::Model model = plate(kind.formulation, 4, 0.2);
    const std::vector<model::ShellElement> quads = model.shells;
    model.shells.resize(8);
    model::Model rest = model;
    rest.shells.assign(quads.begin() + 8, quads.end());
    split_into_triangles(rest);
    // The repeated node at any place.
    for (std::size_t i = 0; i < rest.shells.size(); ++i) {
      model::ShellElement shell = rest.shells[i];
      shell.id = static_cast<UserId>(100 + i);
      std::rotate(shell.node.begin(), shell.node.begin() + static_cast<std::ptrdiff_t>(i % 4),
                  shell.node.end());
      model.shells.push_back(shell);
    }
    Driven patch(model, {Precision::Double, available_isas().back(), 1});
    ASSERT_EQ(patch.domain.shells.size(), 2U);
    EXPECT_EQ(patch.domain.shells[0].formulation, kind.formulation);
    EXPECT_EQ(patch.domain.shells[1].formulation, model::ShellFormulation::Triangle);
    EXPECT_EQ(patch.domain.shells[1].elements, 16);
    patch.step(
        1e-7,
        [](const Vec3& x) {
          return Vec3{x.x * (1 + 1e-6) + 3e-7 * x.y, x.y * (1 - 5e-7), 0};
        },
        [](const Vec3&) { return Vec3{}; });
    double largest = 0;
    for (Index i = 0; i < patch.domain.nodes.count(); ++i)
      largest = test::larger_of(largest, norm(patch.force(i)));
    EXPECT_GT(largest, 0.1 * youngs_modulus * 1e-6 * thickness);
    EXPECT_LT(largest_inside(patch, 4, false), 50 * 2.2e-16 * youngs_modulus * thickness * 5) << kind.name;
  }
}

enum class Pattern {
  Diagonal,  ///< two triangles for each square, all cut the same way
  Cross      ///< four triangles for each square
};

/// Four triangles for each quadrilateral of a flat mesh, which meet at a new node in its middle.
void split_crosswise(model::Model& model) {
  const std::vector<model::ShellElement> quads = std::move(model.shells);
  model.shells.clear();
  for (const model::ShellElement& quad : quads) {
    std::array<double, 3> middle{};
    for (const Index node : quad.node)
      for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] += 0.25 * model.nodes.position[node][axis];
    const Index centre = model.nodes.count();
    model.nodes.id.push_back(centre + 1);
    model.nodes.position.push_back(middle);
    for (std::size_t k = 0; k < 4; ++k)
      model.shells.push_back({.id = static_cast<UserId>(model.shells.size()) + 1,
                              .part = quad.part,
                              .node = {quad.node[k], quad.node[(k + 1) % 4], centre, centre}});
  }
}

/// Deflection at the middle of a simply supported square plate under a force there, over that of thin plate
/// theory, 0.01160 F a^2 / D (S.P. Timoshenko & S. Woinowsky-Krieger, Theory of Plates and Shells, 2nd ed.,
/// section 34).
double centre_deflection(double t, Index n, Pattern pattern) {
  constexpr double side = 10;
  model::Model model =
      test::one_part(elastic(), test::shell_section(t, 2, model::ShellFormulation::Triangle));
  test::add_grid(model, 0, n, n, [](double u, double v) { return test::Point{side * u, side * v, 0}; });
  pattern == Pattern::Diagonal ? split_into_triangles(model) : split_crosswise(model);
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const auto& x = model.nodes.position[node];
    const bool along_x = x[1] == 0 || x[1] == side;
    const bool along_y = x[0] == 0 || x[0] == side;
    model.fixed_nodes.push_back({.node = node,
                                 .translation = {true, true, along_x || along_y},
                                 .rotation = {along_y, along_x, true}});
  }
  model.nodal_loads.push_back({.node = (n / 2) * (n + 2), .force = {0, 0, 1}, .moment = {}});
  const double bending = plane * t * t * t / 12;
  return under_first_load(model, static_solution(model, 1e-6)) / (0.01160 * side * side / bending);
}

/// Squares cut crosswise do not lock, however thin the plate.
TEST(TrianglePlate, CutCrosswiseDoesNotLock) {
  for (const double t : {1e-1, 1e-2, 1e-3}) {
    const double coarse = centre_deflection(t, 4, Pattern::Cross);
    const double fine = centre_deflection(t, 10, Pattern::Cross);
    std::printf(
        "cross, thickness over side %.4f: centre deflection over theory, 4 x 4: %.4f, 10 x 10: %.4f\n",
        t / 10, coarse, fine);
    const std::string supported =
        "C0 triangles cut crosswise, thickness over side " + std::to_string(t / 10).substr(0, 6) + ", ";
    EXPECT_NEAR(coarse, 0.87, 0.01);
    test::verified(supported + "10 x 10: centre deflection over theory",
                   "earlier result of this code; Timoshenko's is 1")
        .near(fine, 0.97, 0.01);
  }
}

/// Squares all cut the same way have more conditions of no shear than rotations to fulfil them: right for
/// sheets a tenth as thick as their elements are long, and locked when a hundred times thinner.
TEST(TrianglePlate, CutAlikeLocksWhenVeryThin) {
  const auto ratio = [](double t, Index n) {
    const double found = centre_deflection(t, n, Pattern::Diagonal);
    std::printf("cut alike, thickness over side %.4f, %d x %d: centre deflection over theory %.4f\n", t / 10,
                n, n, found);
    return found;
  };
  EXPECT_NEAR(ratio(1e-1, 8), 0.874, 0.01);
  test::verified("C0 triangles cut alike, thickness over side 0.01, 16 x 16: centre deflection over theory",
                 "earlier result of this code; Timoshenko's is 1")
      .near(ratio(1e-1, 16), 0.980, 0.01);
  test::verified("C0 triangles cut alike, thickness over side 0.001, 16 x 16: centre deflection over theory",
                 "earlier result of this code, which locks; Timoshenko's is 1")
      .near(ratio(1e-2, 16), 0.853, 0.01);
  EXPECT_LT(ratio(1e-3, 16), 0.5);
}

}  // namespace
}  // namespace crumple::elements::testing::triangle_test
