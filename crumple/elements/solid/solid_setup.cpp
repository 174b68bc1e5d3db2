// SPDX-License-Identifier: BSD-3-Clause
#include "elements/solid/solid_setup.hpp"

#include <algorithm>

#include "elements/solid/quadratic_tetrahedron_nodes.hpp"
#include "elements/solid/selective_hexahedron.hpp"
#include "elements/solid/tetrahedron_nodes.hpp"

namespace crumple::elements {

SolidPatterns<double> patterns_of(const std::array<math::Vec3, 8>& node) {
  SolidSides<double> side{};
  for (std::size_t k = 1; k < 8; ++k) {
    const math::Vec3 d = node[k] - node[0];
    side.of[k - 1] = {d.x, d.y, d.z};
  }
  return patterns_of_sides(side);
}

namespace {

SolidSize tetrahedron_size(const std::array<math::Vec3, 8>& corner) {
  ThreeVectors<double> side;
  const std::size_t ends[3] = {1, 2, 4};
  for (std::size_t s = 0; s < 3; ++s) {
    const math::Vec3 d = corner[ends[s]] - corner[0];
    side.of[s] = {d.x, d.y, d.z};
  }
  const ThreeVectors<double> area = areas_across(side);
  const double six_volumes = math::dot(side.of[0], area.of[0]);
  return {six_volumes / 6, tetrahedron_length(area, six_volumes)};
}

SolidSize quadratic_size(const domain::Domain& domain, const domain::SolidBlock& block, Index place,
                         double shear_share) {
  QuadraticSides<double> side;
  const math::Vec3& first = domain.nodes.position[block.node_of(place, 0)];
  for (Index s = 0; s < quadratic_tetrahedron::sides; ++s) {
    const math::Vec3 d = domain.nodes.position[block.node_of(place, s + 1)] - first;
    side.of[s] = {d.x, d.y, d.z};
  }
  QuadraticStiffness<double> stiffness = no_quadratic_stiffness<double>();
  double volume = 0;
  for (int point = 0; point < quadratic_tetrahedron::points; ++point) {
    const ThreeVectors<double> tangent = quadratic_tangents(side, point);
    const ThreeVectors<double> area = areas_across(tangent);
    const double six_volumes = math::dot(tangent.of[0], area.of[0]);
    stiffness.add(area, six_volumes);
    volume += six_volumes / 24;
  }
  if (!(stiffness.narrowest > 0)) return {stiffness.narrowest, stiffness.narrowest};
  return {volume, quadratic_length(stiffness, volume, shear_share)};
}

double least_jacobian(const SolidPatterns<double>& x) {
  double least = 1e300;
  for_each_point<double>([&](int /*point*/, double xi, double eta, double zeta) {
    least = std::min(least, geometry_at(tangents_at(x, xi, eta, zeta)).jacobian);
  });
  return least;
}

}  // namespace

SolidSize solid_size(const domain::Domain& domain, const domain::SolidBlock& block, Index place,
                     const SolidConstants<double>& constants) {
  if (model::is_cohesive(block.formulation))
    return {block.state(place, constants.own + solid_state::reference_volume), 1};
  const std::array<Index, 8> node = block.nodes_of(place);
  std::array<math::Vec3, 8> corner;
  for (std::size_t k = 0; k < 8; ++k) corner[k] = domain.nodes.position[node[k]];
  if (block.corners == 4) return tetrahedron_size(corner);
  double share = constants.shear_share;
  if (constants.present_wave_speed > 0) {
    const double speed = block.state(place, constants.present_wave_speed);
    if (speed > 0)
      share = std::min(1.0, share * constants.wave_speed * constants.wave_speed / (speed * speed));
  }
  if (block.corners == 10) return quadratic_size(domain, block, place, share);
  const SolidPatterns<double> x = patterns_of(corner);
  const SolidGeometry<double> geometry = solid_geometry(x, constants.exact_volume);
  const double volume = geometry.volume;
  double length = std::min(volume / square_root(largest_face_squared(x)),
                           free_length(geometry, patterns_of_gradient(constants.exact_volume), share));
  if (block.formulation == model::SolidFormulation::AssumedStrainHexahedron)
    length *= skew_factor(bending_frame(x).tangent);
  if (model::is_selective(block.formulation))
    if (const double least = least_jacobian(x); !(least > 0)) return {least, length};
  return {volume, length};
}

}  // namespace crumple::elements
