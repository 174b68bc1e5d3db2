// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/rigid_wall.hpp"

#include <algorithm>
#include <variant>

namespace crumple::constraints {

using math::Vec3;

namespace {

/// The velocity, relative to the wall, that a node is left with.
Vec3 stopped(const Vec3& velocity, const WallLimit& limit, double friction) {
  const double normal_velocity = dot(velocity, limit.normal);
  const double normal_change = limit.slowest - normal_velocity;
  Vec3 tangential = velocity - normal_velocity * limit.normal;
  const double slip = norm(tangential);
  if (friction >= 1.0 || slip <= friction * normal_change)
    tangential = Vec3{};
  else
    tangential = (1.0 - friction * normal_change / slip) * tangential;
  return tangential + limit.slowest * limit.normal;
}

/// The change of velocity without what fixed degrees of freedom do not let through; along the normal it is
/// then made up for in the free directions.
Vec3 let_through(const Vec3& change, const Vec3& normal, std::uint8_t fixed) {
  Vec3 free_change = change;
  Vec3 free_normal = normal;
  for (int axis = 0; axis < 3; ++axis)
    if ((fixed & domain::fixed_translation(axis)) != 0) free_change[axis] = free_normal[axis] = 0;
  // A normal that is almost fixed would throw the node along the wall.
  constexpr double least_free = 0.01;
  const double free_part = dot(free_normal, free_normal);
  if (free_part < least_free) return free_change;
  const double missing = dot(change - free_change, normal);
  return missing == 0 ? free_change : free_change + (missing / free_part) * free_normal;
}

}  // namespace

RigidWall::RigidWall(const model::Model& model, const model::RigidWall& wall, domain::Domain& domain,
                     Index report)
    : model_(&model),
      surface_(wall_surface(wall)),
      motion_(wall.motion),
      friction_(wall.friction),
      birth_time_(wall.birth_time),
      death_time_(wall.death_time),
      report_(report) {
  nodes_.reserve(wall.nodes.size());
  for (const Index node : wall.nodes) nodes_.push_back(domain.nodes.domain_node[node]);
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  if (motion_.is_displacement) domain.walls[report].displacement = displacement_after(domain.clock, {}, 0);
}

Vec3 RigidWall::displacement_after(const domain::Clock& clock, const Vec3& now, double next_step) const {
  if (motion_.curve == no_index) return now;
  const model::Curve& curve = model_->curves[motion_.curve];
  const Vec3 direction = {motion_.direction[0], motion_.direction[1], motion_.direction[2]};
  if (motion_.is_displacement) return curve.at(clock.time + next_step) * direction;
  return now + (next_step * curve.at(clock.time + 0.5 * next_step)) * direction;
}

template <class Shape>
RigidWall::Sums RigidWall::stop_at(const Shape& shape, domain::NodeFields& nodes,
                                   const AlignedArray<Vec3>& previous_velocity, double next_step) const {
  Sums sums;
  WallLimit limit;
  for (const Index i : nodes_) {
    const Vec3 velocity = nodes.velocity[i] - velocity_;
    if (!limit_of(shape, nodes.position[i] - displacement_, velocity, next_step, limit)) continue;
    Vec3 after = stopped(velocity, limit, friction_);
    if (nodes.fixed[i] != 0) after = velocity + let_through(after - velocity, limit.normal, nodes.fixed[i]);
    const Vec3 received = nodes.mass[i] * (after - velocity);
    nodes.velocity[i] = after + velocity_;
    sums.impulse -= received;
    sums.normal_impulse += dot(received, limit.normal);
    sums.energy -= 0.5 * dot(received, previous_velocity[i] - velocity_);
    sums.deferred -= 0.5 * dot(received, after);
  }
  return sums;
}

void RigidWall::stop_nodes(domain::Domain& domain, const AlignedArray<Vec3>& previous_velocity,
                           double impulse_interval, double next_step) {
  domain::WallReport& report = domain.walls[report_];
  displacement_ = report.displacement;
  report.displacement = displacement_after(domain.clock, displacement_, next_step);
  velocity_ = (1.0 / next_step) * (report.displacement - displacement_);
  Sums sums;
  if (domain.clock.time >= birth_time_ && domain.clock.time <= death_time_)
    sums = std::visit(
        [&](const auto& shape) { return stop_at(shape, domain.nodes, previous_velocity, next_step); },
        surface_);
  report.impulse += sums.impulse;
  report.normal_impulse += sums.normal_impulse;
  // An impulse at time n acts on the mean of v(n-1/2) and v(n+1/2); the kinetic energy of time n knows the
  // first.
  report.energy += report.deferred + sums.energy;
  report.deferred = sums.deferred;
  const double work = -0.5 * dot(sums.impulse, velocity_);
  domain.energy.external_work += report.deferred_work + work;
  report.deferred_work = work;
  report.force = (1.0 / impulse_interval) * sums.impulse;
  report.normal_force = sums.normal_impulse / impulse_interval;
}

}  // namespace crumple::constraints
