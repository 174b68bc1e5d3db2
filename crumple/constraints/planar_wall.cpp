// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/planar_wall.hpp"

#include <algorithm>

namespace crumple::constraints {

using math::Vec3;

namespace {

Vec3 to_vec3(const std::array<double, 3>& a) {
  return {a[0], a[1], a[2]};
}

/// What a wall does to the velocity of one node within a step.
struct Stop {
  Vec3 velocity;  ///< after the wall
  bool touched = false;
};

Stop stop_node(const Vec3& velocity, const Vec3& normal, double gap, double friction, double next_step) {
  // The node may come as far as the plane and no further; one that starts behind it is held, not thrown out.
  const double slowest = -std::max(gap, 0.0) / next_step;
  const double normal_velocity = dot(velocity, normal);
  if (normal_velocity >= slowest) return {velocity, false};
  const double normal_change = slowest - normal_velocity;
  Vec3 tangential = velocity - normal_velocity * normal;
  const double slip = norm(tangential);
  if (friction >= 1.0 || slip <= friction * normal_change)
    tangential = Vec3{};
  else
    tangential = (1.0 - friction * normal_change / slip) * tangential;
  return {tangential + slowest * normal, true};
}

}  // namespace

PlanarWall::PlanarWall(const model::RigidWall& wall, const domain::Domain& domain, Index report)
    : point_(to_vec3(wall.point)),
      normal_(normalised(to_vec3(wall.normal))),
      friction_(wall.friction),
      report_(report) {
  for (const Index node : wall.nodes) nodes_.push_back(domain.nodes.domain_node[node]);
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
}

void PlanarWall::stop_nodes(domain::Domain& domain, const AlignedArray<Vec3>& previous_velocity,
                            double impulse_interval, double next_step) {
  domain::NodeFields& nodes = domain.nodes;
  Vec3 impulse;
  double energy = 0;
  double deferred = 0;
  for (const Index i : nodes_) {
    const double gap = dot(nodes.position[i] - point_, normal_);
    const Stop stop = stop_node(nodes.velocity[i], normal_, gap, friction_, next_step);
    if (!stop.touched) continue;
    const Vec3 received = nodes.mass[i] * (stop.velocity - nodes.velocity[i]);
    nodes.velocity[i] = stop.velocity;
    impulse -= received;
    energy -= 0.5 * dot(received, previous_velocity[i]);
    deferred -= 0.5 * dot(received, stop.velocity);
  }
  domain::WallReport& report = domain.walls[report_];
  report.impulse += impulse;
  // An impulse at time n acts on the mean of v(n-1/2) and v(n+1/2); the kinetic energy of time n knows the
  // first.
  report.energy += report.deferred + energy;
  report.deferred = deferred;
  report.force = (1.0 / impulse_interval) * impulse;
  report.normal_force = -dot(report.force, normal_);
}

}  // namespace crumple::constraints
