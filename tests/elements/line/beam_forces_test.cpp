// SPDX-License-Identifier: BSD-3-Clause
// The forces of one beam: derivatives of its energy, in balance, none in rigid motion; mass scaling.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "domain/build.hpp"
#include "elements/elements.hpp"
#include "support/largest.hpp"
#include "support/meshes.hpp"

namespace crumple::elements::beam_forces_test {
namespace {

using domain::Domain;
using math::Vec3;

model::Model one_beam() {
  model::Model model;
  model.materials.push_back({.id = 1, .title = "", .density = 2.0, .law = model::Elastic{100.0, 0.25}});
  model.beam_sections.push_back({.id = 1,
                                 .title = "",
                                 .area = 0.5,
                                 .inertia_s = 0.03,
                                 .inertia_t = 0.01,
                                 .torsion = 0.02,
                                 .shear_area = 0.4});
  model.parts.push_back({.id = 1, .title = "", .beam_section = 0, .material = 0});
  model.nodes.id = {1, 2, 3};
  model.nodes.position = {{{0.1, 0.2, 0.3}, {1.6, 1.1, -0.4}, {0.2, 1.5, 0.9}}};
  model.beams.push_back({.id = 1, .part = 0, .node = {0, 1}, .orientation_node = 2});
  return model;
}

Domain prepared(const model::Model& model) {
  Domain domain = domain::build(model, {});
  prepare_elements(model, domain);
  add_element_forces(domain);
  return domain;
}

/// Moves and turns both ends in one step, turns as rotation vectors, and leaves the new forces.
void move(Domain& domain, const std::array<Vec3, 2>& by, const std::array<Vec3, 2>& turn) {
  const auto nodes = domain.beams[0].nodes_of(0);
  for (std::size_t end = 0; end < 2; ++end) {
    domain.nodes.position[nodes[end]] += by[end];
    domain.nodes.angular_velocity[nodes[end]] = turn[end];
    domain.nodes.force[nodes[end]] = {};
  }
  domain.clock.step = 1;
  add_element_forces(domain);
}

/// Force (0 to 2) or moment (3 to 5) on an end, inner, so against what the node feels.
double inner(const Domain& domain, std::size_t end, int degree) {
  const domain::NodeForce& sum = domain.nodes.force[domain.beams[0].nodes_of(0)[end]];
  return degree < 3 ? -sum.force[degree] : -sum.moment[degree - 3];
}

const std::array<Vec3, 2> far{Vec3{0.2, -0.1, 0.3}, Vec3{-0.3, 0.4, 0.2}};
const std::array<Vec3, 2> turned{Vec3{0.5, -0.3, 0.2}, Vec3{-0.2, 0.6, 0.4}};

TEST(BeamForces, AreTheDerivativesOfTheEnergy) {
  const model::Model model = one_beam();
  Domain domain = prepared(model);
  move(domain, far, turned);
  constexpr double size = 1e-5;
  test::Largest off("beam stretched, bent and twisted: forces and moments, error",
                    "derivatives of its energy", 1e-8);
  for (std::size_t end = 0; end < 2; ++end)
    for (int degree = 0; degree < 6; ++degree) {
      double energy[2] = {};
      for (const int sign : {-1, 1}) {
        Domain moved = domain;
        std::array<Vec3, 2> by{};
        std::array<Vec3, 2> turn{};
        (degree < 3 ? by : turn)[end][degree % 3] = sign * size;
        move(moved, by, turn);
        energy[sign > 0 ? 1 : 0] = moved.beams[0].internal_energy;
      }
      off.compare(inner(domain, end, degree), (energy[1] - energy[0]) / (2 * size), 1,
                  std::to_string(end) + " " + std::to_string(degree));
    }
}

TEST(BeamForces, AreInBalance) {
  const model::Model model = one_beam();
  Domain domain = prepared(model);
  move(domain, far, turned);
  const auto nodes = domain.beams[0].nodes_of(0);
  const Vec3 span = domain.nodes.position[nodes[1]] - domain.nodes.position[nodes[0]];
  const Vec3 second{inner(domain, 1, 0), inner(domain, 1, 1), inner(domain, 1, 2)};
  const Vec3 arm = cross(span, second);
  test::Largest forces("beam stretched, bent and twisted: sum of forces", "conservation", 1e-12);
  test::Largest moments("beam stretched, bent and twisted: sum of moments", "conservation", 1e-12);
  for (int axis = 0; axis < 3; ++axis) {
    forces.add(std::fabs(inner(domain, 0, axis) + inner(domain, 1, axis)));
    moments.add(std::fabs(inner(domain, 0, 3 + axis) + inner(domain, 1, 3 + axis) + arm[axis]));
  }
  EXPECT_GT(norm(second), 0.4);
}

TEST(BeamForces, AreNoneInARigidMotionOfAnySize) {
  const model::Model model = one_beam();
  Domain domain = prepared(model);
  // Half a radian about z through the origin, and a shift.
  const Vec3 axis{0, 0, 0.5};
  const auto nodes = domain.beams[0].nodes_of(0);
  std::array<Vec3, 2> by;
  for (std::size_t end = 0; end < 2; ++end) {
    const Vec3 x = domain.nodes.position[nodes[end]];
    const Vec3 there{std::cos(0.5) * x.x - std::sin(0.5) * x.y, std::sin(0.5) * x.x + std::cos(0.5) * x.y,
                     x.z};
    by[end] = there - x + Vec3{1, 2, 3};
  }
  move(domain, by, {axis, axis});
  test::Largest forces("beam moved and turned by half a radian in one step: forces", "none", 1e-12);
  for (std::size_t end = 0; end < 2; ++end)
    for (int degree = 0; degree < 6; ++degree) forces.add(std::fabs(inner(domain, end, degree)));
}

TEST(BeamForces, StepAndMassAreThoseOfTheRodAndScale) {
  model::Model model = one_beam();
  const double length = std::sqrt(1.5 * 1.5 + 0.9 * 0.9 + 0.7 * 0.7);
  const Domain domain = prepared(model);
  const double mass = 2.0 * 0.5 * length;
  const auto first = domain.beams[0].nodes_of(0)[0];
  EXPECT_NEAR(domain.nodes.mass[first], 0.5 * mass, 1e-12);
  EXPECT_NEAR(domain.nodes.inertia[first], 0.5 * 2.0 * length * 0.03 + mass * length * length / 24, 1e-12);
  EXPECT_LE(domain.clock.element_limit, length / std::sqrt(50.0) * (1 + 1e-12));
  model.control.mass_scaling_step = -2 * domain.clock.element_limit;
  const Domain scaled = prepared(model);
  EXPECT_NEAR(scaled.clock.element_limit, 2 * domain.clock.element_limit, 1e-12);
  EXPECT_NEAR(scaled.added_mass, 3 * mass, 1e-12);
}

}  // namespace
}  // namespace crumple::elements::beam_forces_test
