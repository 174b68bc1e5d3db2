// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/rigid_wall.hpp"

#include <algorithm>
#include <variant>

#include "constraints/rigid_motion.hpp"

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
  stops_.assign(static_cast<std::size_t>(domain.nodes.count()), 0);
  for (const Index node : nodes_) stops_[node] = 1;
  touched_.assign(stops_.size(), 0);
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
void RigidWall::stop_body_at(const Shape& shape, domain::Domain& domain, Index place, double next_step,
                             Sums& sums) {
  domain::RigidBody& body = domain.rigid_bodies[place];
  const AlignedArray<Vec3>& position = domain.nodes.position;
  touches_.clear();
  WallLimit limit;
  // What stops one node may drive others into the wall: these are looked for again.
  constexpr int most_searches = 8;
  for (int search = 0; search < most_searches; ++search) {
    const std::size_t before = touches_.size();
    for (const Index i : body.nodes) {
      if (!stops_[i]) continue;
      const Vec3 arm = position[i] - body.centre;
      const Vec3 velocity = velocity_at(body, arm) - velocity_;
      if (!limit_of(shape, position[i] - displacement_, velocity, next_step, limit)) continue;
      if (touched_[i] != 0) continue;
      touched_[i] = 1;
      touches_.push_back({i, arm, limit.normal, limit.slowest, {}});
    }
    if (touches_.size() == before) break;
    stop_body(body, {velocity_, friction_}, touches_);
  }
  for (const BodyTouch& touch : touches_) {
    touched_[touch.node] = 0;
    sums.impulse -= touch.impulse;
    sums.normal_impulse += dot(touch.impulse, touch.normal);
    const Vec3 previous = body.previous_velocity + cross(body.previous_spin, touch.arm);
    sums.energy -= 0.5 * dot(touch.impulse, previous - velocity_);
    sums.deferred -= 0.5 * dot(touch.impulse, velocity_at(body, touch.arm) - velocity_);
  }
}

template <class Shape>
RigidWall::Sums RigidWall::stop_at(const Shape& shape, domain::Domain& domain,
                                   const AlignedArray<Vec3>& previous_velocity, double next_step) {
  Sums sums;
  domain::NodeFields& nodes = domain.nodes;
  const bool has_bodies = !domain.body_of_node.empty();
  WallLimit limit;
  for (const Index i : nodes_) {
    if (has_bodies && domain.body_of_node[i] != no_index) continue;
    // A tied node is between those that it follows, and these are stopped.
    if (nodes.is_tied(i)) continue;
    const Vec3 velocity = nodes.velocity[i] - velocity_;
    if (!limit_of(shape, nodes.position[i] - displacement_, velocity, next_step, limit)) continue;
    Vec3 after = stopped(velocity, limit, friction_);
    if (nodes.fixed[i] != 0) after = velocity + let_through(after - velocity, limit.normal, nodes.fixed[i]);
    const Vec3 received = nodes.moving_mass(i) * (after - velocity);
    nodes.velocity[i] = after + velocity_;
    sums.impulse -= received;
    sums.normal_impulse += dot(received, limit.normal);
    sums.energy -= 0.5 * dot(received, previous_velocity[i] - velocity_);
    sums.deferred -= 0.5 * dot(received, after);
  }
  for (Index body = 0; body < static_cast<Index>(domain.rigid_bodies.size()); ++body)
    if (domain.rigid_bodies[body].active) stop_body_at(shape, domain, body, next_step, sums);
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
    sums = std::visit([&](const auto& shape) { return stop_at(shape, domain, previous_velocity, next_step); },
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
