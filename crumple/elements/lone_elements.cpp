// SPDX-License-Identifier: BSD-3-Clause
#include "elements/lone_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "elements/shell/shell_geometry.hpp"
#include "elements/shell/shell_setup.hpp"
#include "elements/shell/shell_task.hpp"
#include "elements/solid/solid_setup.hpp"
#include "elements/solid/solid_task.hpp"
#include "materials/common/shell_material.hpp"

namespace crumple::elements {
namespace {

using domain::Domain;
using math::Vec3;

/// Elements at the corners of a mesh of squares keep their usual step: this much is not taken off.
constexpr double allowance = 0.07;

/// Between which shares of its nodes an element passes from one in a mesh to one alone. Measured on meshes of
/// squares, rhombs, triangles and cubes of five and six tetrahedra.
struct Loneliness {
  double in_mesh, alone;
  double weight(double share) const { return std::clamp((share - in_mesh) / (alone - in_mesh), 0.0, 1.0); }
};
constexpr Loneliness of_shells{0.35, 0.85};
constexpr Loneliness of_tetrahedra{0.15, 0.5};

/// On the usual step of an element that has the exact limit `exact` times that where it is alone.
double lone_factor(double exact, double weight) {
  const double needed = 1 - (1 - std::min(exact, 1.0)) * weight;
  return std::min(1.0, (1 + allowance * (1 - weight * weight)) * needed);
}

/// 2 / omega of the membrane of a shell alone, over its characteristic length and times the wave speed [-].
/// `corners` is 3 or 4, `poissons` Poisson's ratio.
double exact_share(const ShellCorners& corner, std::size_t corners, double poissons) {
  const Vec3 r31 = corner[2] - corner[0];
  const Vec3 r42 = corner[3] - corner[1];
  const Vec3 normal = normalised(cross(r31, r42));
  const Vec3 e1 = normalised(r31 - dot(r31, normal) * normal);
  const Vec3 e2 = cross(normal, e1);
  const auto flat = [&](const Vec3& v) { return Vec3{dot(v, e1), dot(v, e2), 0}; };
  const double twice_area = 2 * shell_area(corner);
  // Constant gradients: a quarter turn of half the other diagonal, over the area.
  const Vec3 a = flat(r31);
  const Vec3 b = flat(r42);
  const Vec3 along_42{-b.y / twice_area, b.x / twice_area, 0};
  const Vec3 along_31{a.y / twice_area, -a.x / twice_area, 0};
  std::array<Vec3, 4> gradient{along_42, along_31, -1.0 * along_42, -1.0 * along_31};
  if (corners == 3) gradient[2] = gradient[2] + gradient[3];
  const double eigenvalue = largest_eigenvalue(std::span(gradient).first(corners), poissons, 1 - poissons);
  const double exact =
      2 / std::sqrt(static_cast<double>(corners) * eigenvalue) / characteristic_length(corner, corners == 3);
  // What is longer than wide may become square.
  return std::min(exact, 1 / std::sqrt(1 + poissons));
}

/// Gradients of the shape functions of a tetrahedron [1/length].
std::array<Vec3, 4> gradients_of(const std::array<Vec3, 4>& corner) {
  std::array<Vec3, 4> gradient;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3& from = corner[(k + 1) % 4];
    const Vec3 area = cross(corner[(k + 2) % 4] - from, corner[(k + 3) % 4] - from);
    gradient[k] = (1 / dot(corner[k] - from, area)) * area;
  }
  return gradient;
}

}  // namespace

double largest_eigenvalue(std::span<const Vec3> gradients, double dilatation, double shear) {
  constexpr int iterations = 200;
  constexpr std::size_t most_corners = 4;
  std::array<Vec3, most_corners> u{};
  // In plane stress nothing moves along z.
  const bool flat = std::ranges::all_of(gradients, [](const Vec3& g) { return g.z == 0; });
  for (std::size_t n = 0; n < gradients.size(); ++n) {
    const double k = 3.0 * static_cast<double>(n);
    u[n] = {std::cos(k + 1), std::cos(k + 2), flat ? 0 : std::cos(k + 3)};
  }
  double eigenvalue = 0;
  for (int i = 0; i < iterations; ++i) {
    Vec3 x;  // rows of the sum of u g
    Vec3 y;
    Vec3 z;
    double square = 0;
    for (std::size_t n = 0; n < gradients.size(); ++n) {
      x = x + u[n].x * gradients[n];
      y = y + u[n].y * gradients[n];
      z = z + u[n].z * gradients[n];
      square += dot(u[n], u[n]);
    }
    const double mean = dilatation * (x.x + y.y + z.z);
    const double half = 0.5 * shear;
    const Vec3 row_x{mean + shear * x.x, half * (x.y + y.x), half * (x.z + z.x)};
    const Vec3 row_y{half * (x.y + y.x), mean + shear * y.y, half * (y.z + z.y)};
    const Vec3 row_z{half * (x.z + z.x), half * (y.z + z.y), mean + shear * z.z};
    double next = 0;
    for (std::size_t n = 0; n < gradients.size(); ++n) {
      const Vec3 force{dot(row_x, gradients[n]), dot(row_y, gradients[n]), dot(row_z, gradients[n])};
      next += dot(force, u[n]);
      u[n] = force;
    }
    eigenvalue = next / square;
    double largest = 0;
    for (const Vec3& v : u) largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (!(largest > 0)) break;
    for (Vec3& v : u) v = (1 / largest) * v;
  }
  return eigenvalue;
}

LoneElements::LoneElements(const model::Model& model, const Domain& domain)
    : count_(static_cast<std::size_t>(domain.nodes.count()), 0) {
  std::vector<Index> node;
  const auto add = [&](const auto& block) {
    // Null shells hold nothing back.
    const Index material = model.parts[block.part].material;
    if (material != no_index && !materials::has_stiffness(model.materials[material].law)) return;
    for (Index place = 0; place < block.elements; ++place) {
      node.clear();
      for (Index corner = 0; corner < block.corners; ++corner) node.push_back(block.node_of(place, corner));
      std::sort(node.begin(), node.end());
      node.erase(std::unique(node.begin(), node.end()), node.end());
      for (const Index n : node) ++count_[static_cast<std::size_t>(n)];
    }
  };
  for (const domain::ShellBlock& block : domain.shells) add(block);
  // Nor do cohesive solids take a share of the step of those beside them.
  for (const domain::SolidBlock& block : domain.solids)
    if (!model::is_cohesive(block.formulation)) add(block);
  for (const domain::BeamBlock& block : domain.beams) add(block);
}

/// What of its nodes is an element's own, in the mean.
double LoneElements::own_share(std::span<const Index> nodes) const {
  double sum = 0;
  for (const Index node : nodes) sum += 1.0 / std::max(1, count_[static_cast<std::size_t>(node)]);
  return sum / static_cast<double>(nodes.size());
}

double LoneElements::factor(const Domain& domain, const domain::ShellBlock& block, Index place) const {
  if (block.rigid) return 1;
  const std::array<Index, 4> node = block.nodes_of(place);
  const std::size_t corners = is_triangle(node) ? 3 : 4;
  const double weight = of_shells.weight(own_share(std::span(node).first(corners)));
  if (weight == 0) return 1;
  const auto constants = from_numbers<ShellConstants<double>>(block.element_constants);
  return lone_factor(exact_share(corners_of(domain, node), corners, constants.poissons_ratio), weight);
}

double LoneElements::factor(const Domain& domain, const domain::SolidBlock& block, Index place) const {
  const bool has_usual_step =
      model::is_tetrahedral(block.formulation) && !model::is_quadratic(block.formulation);
  if (block.rigid || !has_usual_step) return 1;
  std::array<Index, 4> node;
  std::array<Vec3, 4> corner;
  for (std::size_t k = 0; k < 4; ++k) {
    node[k] = block.node_of(place, static_cast<Index>(k));
    corner[k] = domain.nodes.position[node[k]];
  }
  const double weight = of_tetrahedra.weight(own_share(node));
  if (weight == 0) return 1;
  const auto constants = from_numbers<SolidConstants<double>>(block.element_constants);
  const double shear = constants.shear_share;
  const double eigenvalue = largest_eigenvalue(gradients_of(corner), 1 - shear, shear);
  return lone_factor(1 / std::sqrt(eigenvalue) / solid_size(domain, block, place, constants).length, weight);
}

}  // namespace crumple::elements
