// SPDX-License-Identifier: BSD-3-Clause
#include "output/driven_speed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "math/to_vec3.hpp"

namespace crumple::output {

namespace {

/// Of a node with a prescribed motion: of what is prescribed, so that a node which shoots off otherwise gives
/// no measure [length/time].
double prescribed_speed(const domain::Domain& domain, const model::PrescribedMotion& motion) {
  const Index node = domain.nodes.domain_node[motion.node];
  const math::Vec3& velocity = domain.nodes.velocity[node];
  if (motion.goes_round) {
    math::Vec3 axis;
    axis[motion.axis] = 1;
    math::Vec3 arm = domain.nodes.position[node] - math::to_vec3(motion.centre);
    arm[motion.axis] = 0;
    const math::Vec3 around = math::cross(axis, arm);
    const double radius = math::norm(around);
    return radius > 0 ? std::fabs(math::dot(velocity, around)) / radius : 0;
  }
  const math::Vec3 direction{motion.direction[0], motion.direction[1], motion.direction[2]};
  return std::fabs(motion.has_direction() ? dot(direction, velocity) : velocity[motion.axis]);
}

/// The forces of one curve, at a factor of one.
struct Drive {
  double power = 0;  ///< [force * length/time]
  double force = 0;  ///< sum of the sizes [force]
  void add(const math::Vec3& at_node, const math::Vec3& velocity) {
    power += math::dot(at_node, velocity);
    force += math::norm(at_node);
  }
  double speed() const { return force > 0 ? std::fabs(power) / force : 0; }
};

/// Whether a load of this curve has acted by now: what it has set in motion goes on when it has ended.
bool has_acted(const model::Model& model, Index curve, double since_arrival) {
  if (since_arrival < 0) return false;
  if (curve == no_index) return true;
  const model::Curve& load = model.curves[curve];
  if (load.at(since_arrival) != 0) return true;
  for (std::size_t i = 0; i < load.abscissa.size() && load.abscissa[i] <= since_arrival; ++i)
    if (load.ordinate[i] != 0) return true;
  return false;
}

using Drives = std::map<Index, Drive>;  // by curve

void add_nodal_loads(const View& view, Drives& drives) {
  const domain::NodeFields& nodes = view.domain.nodes;
  for (const model::NodalLoad& load : view.model.nodal_loads) {
    math::Vec3 force = math::to_vec3(load.force);
    if (load.plane.given()) {
      std::array<math::Vec3, 3> x;
      for (std::size_t k = 0; k < 3; ++k) x[k] = nodes.position[nodes.domain_node[load.plane.node[k]]];
      const math::Vec3 normal = math::cross(x[1] - x[0], x[2] - x[0]);
      const double length = math::norm(normal);
      force = length > 0 ? (load.force[0] / length) * normal : math::Vec3{};
    }
    drives[load.curve].add(force, nodes.velocity[nodes.domain_node[load.node]]);
  }
}

void add_pressures(const View& view, Drives& drives) {
  const domain::NodeFields& nodes = view.domain.nodes;
  const double time = view.domain.clock.time;
  for (const model::PressureLoad& load : view.model.pressure_loads) {
    if (!has_acted(view.model, load.curve, time - load.arrival)) continue;
    std::array<Index, 4> node{};
    for (std::size_t k = 0; k < 4; ++k) node[k] = nodes.domain_node[load.node[k]];
    const auto& x = nodes.position;
    const math::Vec3 area = 0.5 * math::cross(x[node[2]] - x[node[0]], x[node[3]] - x[node[1]]);
    const std::size_t corners = node[3] == node[2] ? 3 : 4;
    math::Vec3 velocity;
    for (std::size_t k = 0; k < corners; ++k) velocity += nodes.velocity[node[k]];
    drives[load.curve].add(load.pressure * area, (1.0 / static_cast<double>(corners)) * velocity);
  }
}

/// The power of the forces of a curve over their sum: a single node among many that shoots off changes it
/// little. The energy that they supply is no measure where it stays in a small piece of the mass.
double speed_under_forces(const View& view) {
  Drives drives;
  add_nodal_loads(view, drives);
  std::erase_if(
      drives, [&](const auto& drive) { return !has_acted(view.model, drive.first, view.domain.clock.time); });
  double fastest = 0;
  for (const auto& [curve, drive] : drives) fastest = std::max(fastest, drive.speed());
  Drives pressures;
  add_pressures(view, pressures);
  for (const auto& [curve, drive] : pressures) fastest = std::max(fastest, drive.speed());
  return fastest;
}

}  // namespace

double driven_speed(const View& view) {
  const domain::Domain& domain = view.domain;
  double fastest = speed_under_forces(view);
  for (const model::PrescribedMotion& motion : view.model.prescribed_motions) {
    const bool acts = domain.clock.time >= motion.birth && domain.clock.time < motion.death;
    if (acts && motion.node != no_index && !motion.rotation)
      fastest = std::max(fastest, prescribed_speed(domain, motion));
  }
  for (const domain::RigidBody& body : domain.rigid_bodies) {
    double arm = 0;
    for (const math::Vec3& r : body.arm) arm = std::max(arm, math::norm(r));
    fastest = std::max(fastest, math::norm(body.velocity) + arm * math::norm(body.angular_velocity));
  }
  for (const domain::WallReport& wall : domain.walls) fastest = std::max(fastest, math::norm(wall.velocity));
  return fastest;
}

}  // namespace crumple::output
