// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra with ten nodes: faces, masses, stable step, curved sides, bending. What all solids must hold is
// in the other files of this folder.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>

#include "elements/solid_harness.hpp"
#include "elements/static_solution.hpp"
#include "model/solid_faces.hpp"
#include "support/verified.hpp"

namespace crumple::elements::testing::quadratic_tetrahedra_test {
namespace {

constexpr SolidCase quadratic{.formulation = model::SolidFormulation::QuadraticTetrahedron,
                              .name = "ELFORM 16"};

Vec3 at(const model::Model& model, Index node) {
  const auto& x = model.nodes.position[static_cast<std::size_t>(node)];
  return {x[0], x[1], x[2]};
}

/// One element with straight sides.
model::Model lone(const SolidCase& of, const std::array<test::Point, 4>& corner,
                  const model::Material& material = elastic()) {
  model::Model model = solid_model(of, material);
  for (const test::Point& x : corner) {
    model.nodes.id.push_back(model.nodes.count() + 1);
    model.nodes.position.push_back(x);
  }
  model.solids.push_back({.id = 1, .part = 0, .node = {0, 1, 2, 2, 3, 3, 3, 3}});
  test::add_middle_nodes(model);
  return model;
}
constexpr std::array<test::Point, 4> corner_of_cube = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<test::Point, 4> regular = {{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}};

TEST(QuadraticTetrahedra, FacesAreSixteenTrianglesThatCloseTheElement) {
  const model::Model model = lone(quadratic, corner_of_cube);
  const auto faces = model::faces_of(model.solids[0]);
  ASSERT_EQ(faces.size(), 16U);
  double area = 0;
  double volume = 0;
  std::map<std::pair<Index, Index>, int> used;
  for (const auto& face : faces) {
    EXPECT_EQ(face[2], face[3]);
    const Vec3 normal =
        0.5 * cross(at(model, face[1]) - at(model, face[0]), at(model, face[2]) - at(model, face[0]));
    EXPECT_NEAR(norm(normal), norm(normal) > 0.2 ? std::sqrt(3.0) / 8 : 0.125, 1e-15);
    area += norm(normal);
    volume += dot(normal, at(model, face[0])) / 3;
    for (std::size_t k = 0; k < 3; ++k) ++used[{face[k], face[(k + 1) % 3]}];
  }
  EXPECT_NEAR(area, 1.5 + std::sqrt(3.0) / 2, 1e-14);
  EXPECT_NEAR(volume, 1.0 / 6, 1e-15);
  // Each edge once in each direction.
  EXPECT_EQ(used.size(), 48U);
  for (const auto& [edge, count] : used) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(used.contains({edge.second, edge.first}));
  }
  // Two elements hide the four triangles of the face between them from each other.
  model::Model two = solid_model(quadratic, elastic());
  test::add_box(two, 0, 1, 1, 1, [](double u, double v, double w) { return test::Point{u, v, w}; });
  split_for(quadratic, two);
  std::vector<Index> all;
  for (std::size_t i = 0; i < two.solids.size(); ++i) all.push_back(static_cast<Index>(i));
  EXPECT_EQ(model::outer_faces(two.solids, all).size(), 12U * 4);
}

TEST(QuadraticTetrahedra, HaveMassAtAllNodes) {
  const model::Model model = lone(quadratic, corner_of_cube);
  const Driven body(model, {Precision::Double, available_isas().back(), 1});
  for (Index node = 0; node < 10; ++node) {
    const bool corner = norm(body.domain.nodes.reference[node]) == 0 ||
                        std::fabs(norm(body.domain.nodes.reference[node]) - 1) < 1e-12;
    EXPECT_NEAR(body.domain.nodes.mass[node] / (density / 6), corner ? 1.0 / 32 : 7.0 / 48, 1e-15);
  }
}

/// Lone elements, the fastest of all meshes: of any shape, with curved sides, for any Poisson's ratio.
TEST(QuadraticTetrahedra, StableStepIsSafeForLoneElements) {
  const SolidCase& of = quadratic;
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double nu : {0.0, 0.3, 0.45, 0.4999}) {
    model::Material material = elastic();
    material.law = model::Elastic{youngs_modulus, nu};
    double largest = courant_number(lone(of, regular, material));
    const double first = largest;
    for (int shape = 0; shape < 40; ++shape) {
      model::Model model = lone(of, corner_of_cube, material);
      const double curved = shape % 2 == 0 ? 0 : 0.07;
      std::array<Vec3, 3> stretch;
      for (Vec3& row : stretch) row = {uniform(generator), uniform(generator), uniform(generator)};
      if (dot(stretch[0], cross(stretch[1], stretch[2])) < 0) stretch[0] = -stretch[0];
      for (std::size_t node = 0; node < 10; ++node) {
        auto& x = model.nodes.position[node];
        const double share = node < 4 ? 0 : curved;
        const Vec3 moved =
            Vec3{x[0], x[1], x[2]} + share * Vec3{uniform(generator), uniform(generator), uniform(generator)};
        for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = dot(stretch[axis], moved);
      }
      largest = std::max(largest, courant_number(model));
    }
    std::printf("%s, nu %.4f: half omega dt %.3f, regular %.3f\n", of.name, nu, largest, first);
    test::verified(std::string(of.name) + ", lone elements: half omega dt", "stable up to 1")
        .below(largest, 1 + 1e-6);
  }
}

/// The stress of a linear field is uniform whatever the sides.
TEST(QuadraticTetrahedra, LinearFieldsAreExactWithCurvedSides) {
  const SolidCase& of = quadratic;
  for (const auto& execution : all_executions()) {
    model::Model model = lone(of, corner_of_cube);
    model.nodes.position[4] = {0.55, -0.05, 0.02};
    model.nodes.position[8] = {0.5, 0.03, 0.56};
    Driven body(model, execution);
    body.step(
        1e-6,
        [](const Vec3& x) {
          return x + Vec3{1e-6 * x.x + 2e-6 * x.y, 0, 0};
        },
        [](const Vec3&) { return Vec3{}; });
    const domain::SolidBlock& block = body.domain.solids[0];
    const double lame = youngs_modulus * poissons_ratio / (1 + poissons_ratio) / (1 - 2 * poissons_ratio);
    const double shear = 0.5 * youngs_modulus / (1 + poissons_ratio);
    const double expected[6] = {lame + 2 * shear, lame, lame, 2 * shear, 0, 0};
    for (Index point = 0; point < 4; ++point)
      for (Index c = 0; c < 6; ++c)
        EXPECT_NEAR(block.state(0, 6 * point + c) / (1e-6 * shear), expected[c] / shear,
                    execution.precision == Precision::Double ? 1e-5 : 2e-4)
            << name_of(of, execution);
  }
}

/// Loads on the end x = length that are those of a uniform traction: a third of each face at the nodes in
/// the middle of its sides, nothing at corners.
void load_end(model::Model& model, double length) {
  constexpr std::size_t face[4][3] = {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  constexpr std::size_t side[4][3] = {{0, 1, 2}, {0, 4, 3}, {1, 5, 4}, {2, 3, 5}};
  for (const model::SolidElement& solid : model.solids)
    for (std::size_t f = 0; f < 4; ++f) {
      std::array<Vec3, 3> x;
      for (std::size_t k = 0; k < 3; ++k)
        x[k] = at(model, solid.node[model::corners_of_tetrahedron[face[f][k]]]);
      if (x[0].x != length || x[1].x != length || x[2].x != length) continue;
      const double area = 0.5 * norm(cross(x[1] - x[0], x[2] - x[0]));
      for (const std::size_t s : side[f])
        model.nodal_loads.push_back({.node = solid.node.middle(s), .force = {0, 0, area / 3}});
    }
}

/// As the cantilever of static_solids_test.cpp: 10 x 1 x 1 hexahedra, six elements to each.
double cantilever(const SolidCase& of, double nu, Index along, Index across) {
  constexpr double length = 10;
  model::Material material = elastic();
  material.law = model::Elastic{youngs_modulus, nu};
  model::Model model = solid_model(of, material);
  model.control.bulk_linear = model.control.bulk_quadratic = 0;
  test::add_box(model, 0, along, across, across, [](double u, double v, double w) {
    return test::Point{length * u, v, w};
  });
  split_for(of, model);
  hold_rotations(model);
  for (Index node = 0; node < model.nodes.count(); ++node)
    if (at(model, node).x == 0)
      model.fixed_nodes.push_back({.node = node, .translation = {true, true, true}});
  load_end(model, length);
  const std::vector<double> u = static_solution(model, 1e-7);
  double work = 0;
  for (const model::NodalLoad& load : model.nodal_loads)
    work += load.force[2] * u[6 * static_cast<std::size_t>(load.node) + 2];
  const double shear = 0.5 * youngs_modulus / (1 + nu);
  const double factor = 10 * (1 + nu) / (12 + 11 * nu);
  const double ratio =
      work / (length * length * length * 12 / (3 * youngs_modulus) + length / (factor * shear));
  std::printf("cantilever, %s, nu %.4f, %d x %d x %d: %.4f of the beam's deflection\n", of.name, nu, along,
              across, across, ratio);
  return ratio;
}

TEST(StaticSolids, CantileverOfTetrahedraWithTenNodesBends) {
  const auto expect = [](const SolidCase& of, double nu, double known) {
    test::verified("cantilever, " + std::string(of.name) + ", nu " + std::to_string(nu) +
                       ", 10 x 1 x 1 x 6: deflection over the beam's",
                   "earlier result of this code; the beam's is 1")
        .near(cantilever(of, nu, 10, 1), known, 0.001);
  };
  expect(quadratic, 0.3, 0.9758);
  expect(quadratic, 0.4999, 0.8608);
}

}  // namespace
}  // namespace crumple::elements::testing::quadratic_tetrahedra_test
