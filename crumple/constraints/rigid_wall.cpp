// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/rigid_wall.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <variant>

#include "constraints/rigid_motion.hpp"
#include "math/to_vec3.hpp"

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

/// How much of a push along the normal supports let through; 0 if that is hardly anything: a normal that is
/// almost fixed would throw the node along the wall. `free_normal` is the part of the normal along which they
/// let the node move.
double free_part(const Vec3& free_normal) {
  const double part = dot(free_normal, free_normal);
  constexpr double least_free = 0.01;
  return part < least_free ? 0 : part;
}

/// The change of velocity without what supports do not let through; along the normal it is then made up for
/// in the free directions.
Vec3 let_through(const domain::NodeFields& nodes, Index node, const Vec3& change, const Vec3& normal) {
  const Vec3 free_change = nodes.free_translation(node, change);
  const Vec3 free_normal = nodes.free_translation(node, normal);
  const double part = free_part(free_normal);
  if (part == 0) return free_change;
  const double missing = dot(change - free_change, normal);
  return missing == 0 ? free_change : free_change + (missing / part) * free_normal;
}

/// What a wall's impacts on a body change, to be put back.
class KeptMotion {
 public:
  explicit KeptMotion(domain::RigidBody& body)
      : body_(body),
        velocity_(body.velocity),
        angular_momentum_(body.angular_momentum),
        spin_(body.spin),
        impulse_(body.impulse),
        angular_impulse_(body.angular_impulse) {}
  void put_back() const {
    body_.velocity = velocity_;
    body_.angular_momentum = angular_momentum_;
    body_.spin = spin_;
    body_.impulse = impulse_;
    body_.angular_impulse = angular_impulse_;
  }

 private:
  domain::RigidBody& body_;
  Vec3 velocity_;
  Vec3 angular_momentum_;
  Vec3 spin_;
  Vec3 impulse_;
  Vec3 angular_impulse_;
};

}  // namespace

RigidWall::RigidWall(const model::Model& model, const model::RigidWall& wall, domain::Domain& domain,
                     Index report)
    : model_(&model),
      surface_(wall_surface(wall)),
      motion_(wall.motion),
      normal_(normalised(math::to_vec3(wall.normal))),
      mass_(wall.mass),
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
  domain::WallReport& now = domain.walls[report];
  if (motion_.is_displacement) now.displacement = displacement_after(domain.clock, {}, 0);
  now.displacement_now = now.displacement;
  if (!(mass_ > 0)) return;
  now.mass = mass_;
  now.velocity = wall.initial_velocity * normal_;
  now.kinetic_energy = 0.5 * mass_ * dot(now.velocity, now.velocity);
}

void RigidWall::declare(domain::StateList& list) {
  list.keep("wall_displacement_now", "length", domain::Entity::Wall, displacement_);
  list.keep("wall_velocity_now", "length/time", domain::Entity::Wall, velocity_);
  list.keep("wall_frame_velocity", "length/time", domain::Entity::Wall, frame_);
}

double RigidWall::kinetic_energy(const domain::Domain& domain) {
  double sum = 0;
  for (const domain::WallReport& wall : domain.walls) sum += wall.kinetic_energy;
  return sum;
}

Vec3 RigidWall::displacement_after(const domain::Clock& clock, const Vec3& now, double next_step) const {
  if (motion_.curve == no_index) return now;
  const model::Curve& curve = model_->curves[motion_.curve];
  const Vec3 direction = {motion_.direction[0], motion_.direction[1], motion_.direction[2]};
  if (motion_.is_displacement) return curve.at(clock.time + next_step) * direction;
  return now + (next_step * curve.at(clock.time + 0.5 * next_step)) * direction;
}

bool RigidWall::is_stopped(const domain::Domain& domain, Index node) const {
  if (!domain.body_of_node.empty() && domain.body_of_node[node] != no_index) return false;
  // A tied node is between those that it follows, and these are stopped.
  return !domain.nodes.is_tied(node);
}

void RigidWall::stop_node(Impact& impact, Index node, const WallLimit& limit) const {
  domain::NodeFields& nodes = impact.domain.nodes;
  const Vec3 velocity = nodes.velocity[node] - velocity_;
  Vec3 after = stopped(velocity, limit, friction_);
  if (nodes.fixed[node] != 0 || nodes.local_hold_of(node) != nullptr)
    after = velocity + let_through(nodes, node, after - velocity, limit.normal);
  const Vec3 received = nodes.moving_mass(node) * (after - velocity);
  nodes.velocity[node] = after + velocity_;
  Sums& sums = impact.sums;
  sums.impulse -= received;
  sums.normal_impulse += dot(received, limit.normal);
  sums.energy -= 0.5 * dot(received, impact.step.previous_velocity[node] - frame_);
  sums.kinetic += 0.5 * dot(received, impact.step.previous_velocity[node]);
  impact.step.fastest = std::max(impact.step.fastest, norm(nodes.velocity[node]));
  sums.deferred -= 0.5 * dot(received, after + (velocity_ - frame_));
}

template <class Shape>
void RigidWall::stop_body_at(const Shape& shape, Impact& impact, Index place) {
  domain::RigidBody& body = impact.domain.rigid_bodies[place];
  const AlignedArray<Vec3>& position = impact.domain.nodes.position;
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
      if (!limit_of(shape, position[i] - displacement_, velocity, impact.step.next, limit)) continue;
      if (touched_[i] != 0) continue;
      touched_[i] = 1;
      touches_.push_back({i, arm, limit.normal, limit.slowest, {}});
    }
    if (touches_.size() == before) break;
    stop_body(body, {velocity_, friction_}, touches_);
  }
  for (const BodyTouch& touch : touches_) {
    touched_[touch.node] = 0;
    impact.sums.impulse -= touch.impulse;
    impact.sums.normal_impulse += dot(touch.impulse, touch.normal);
    const Vec3 previous = body.previous_velocity + cross(body.previous_spin, touch.arm);
    impact.sums.energy -= 0.5 * dot(touch.impulse, previous - frame_);
    impact.sums.deferred -= 0.5 * dot(touch.impulse, velocity_at(body, touch.arm) - frame_);
  }
}

/// Those that are asked one by one whether the wall is in their way.
template <class Shape>
std::span<const Index> RigidWall::nodes_in_reach(const Shape& shape, const Impact& impact) {
  if constexpr (requires { shape.height(Vec3{}); }) {
    const AlignedArray<Vec3>& position = impact.domain.nodes.position;
    return near_.find(nodes_, (impact.step.fastest + norm(velocity_)) * impact.step.next,
                      [&](Index node) { return shape.height(position[node] - displacement_); });
  } else {
    return nodes_;
  }
}

template <class Shape>
void RigidWall::stop_at(const Shape& shape, Impact& impact) {
  const domain::Domain& domain = impact.domain;
  WallLimit limit;
  for (const Index i : nodes_in_reach(shape, impact)) {
    const Vec3 velocity = domain.nodes.velocity[i] - velocity_;
    if (limit_of(shape, domain.nodes.position[i] - displacement_, velocity, impact.step.next, limit) &&
        is_stopped(domain, i))
      stop_node(impact, i, limit);
  }
  for (Index body = 0; body < static_cast<Index>(domain.rigid_bodies.size()); ++body)
    if (domain.rigid_bodies[body].active) stop_body_at(shape, impact, body);
}

/// Nodes in the way at the present velocity of the wall; false if all are known already.
template <class Shape>
bool RigidWall::find_nodes_to_push(const Shape& shape, const Impact& impact) {
  const domain::NodeFields& nodes = impact.domain.nodes;
  const std::size_t known = pushed_.size();
  WallLimit limit;
  for (const Index i : nodes_) {
    if (touched_[i] != 0 || !is_stopped(impact.domain, i)) continue;
    const Vec3 velocity = nodes.velocity[i] - velocity_;
    if (!limit_of(shape, nodes.position[i] - displacement_, velocity, impact.step.next, limit)) continue;
    const double highest = dot(nodes.velocity[i], normal_) - limit.slowest;
    lowest_ = std::min(lowest_, highest);
    const double free = free_part(nodes.free_translation(i, normal_));
    if (free > 0) {
      touched_[i] = 1;
      pushed_.push_back({i, limit.slowest, highest, nodes.moving_mass(i) / free});
    } else if (highest < obstacle_.highest) {
      obstacle_ = {highest, no_index, {}};
    }
  }
  return pushed_.size() > known;
}

/// The same of bodies.
template <class Shape>
bool RigidWall::find_bodies_to_push(const Shape& shape, const Impact& impact) {
  const AlignedArray<Vec3>& position = impact.domain.nodes.position;
  const std::size_t known = pushed_bodies_.size();
  WallLimit limit;
  for (Index place = 0; place < static_cast<Index>(impact.domain.rigid_bodies.size()); ++place) {
    const domain::RigidBody& body = impact.domain.rigid_bodies[place];
    if (!body.active || std::count(pushed_bodies_.begin(), pushed_bodies_.end(), place) > 0) continue;
    bool is_met = false;
    for (const Index i : body.nodes) {
      if (!stops_[i]) continue;
      const Vec3 arm = position[i] - body.centre;
      const Vec3 velocity = velocity_at(body, arm);
      if (!limit_of(shape, position[i] - displacement_, velocity - velocity_, impact.step.next, limit))
        continue;
      is_met = true;
      const double highest = dot(velocity, normal_) - limit.slowest;
      lowest_ = std::min(lowest_, highest);
      if (highest < obstacle_.highest && !(dot(normal_, response_at(body, arm, normal_)) > 0))
        obstacle_ = {highest, place, arm};
    }
    if (is_met) pushed_bodies_.push_back(place);
  }
  return pushed_bodies_.size() > known;
}

/// What all nodes and bodies take from a wall that leaves with this velocity; they stay as they are.
template <class Shape>
double RigidWall::impulse_at(const Shape& shape, double velocity, Impact& impact) {
  double impulse = 0;
  for (const PushedNode& pushed : pushed_) impulse += pushed.mass * std::max(0.0, velocity - pushed.limit);
  velocity_ = velocity * normal_;
  for (const Index place : pushed_bodies_) {
    const KeptMotion kept(impact.domain.rigid_bodies[place]);
    Impact trial{impact.domain, impact.step};
    stop_body_at(shape, trial, place);
    impulse += trial.sums.normal_impulse;
    kept.put_back();
  }
  return impulse;
}

template <class Shape>
double RigidWall::find_common_velocity(const Shape& shape, Impact& impact) {
  constexpr double body_tolerance = 1e-11;  // stop_body() iterates
  const double before = dot(velocity_, normal_);
  double common = before;
  obstacle_.highest = std::numeric_limits<double>::infinity();
  lowest_ = before;
  pushed_.clear();
  pushed_bodies_.clear();
  for (;;) {
    const double last_highest = obstacle_.highest;
    const bool finds_nodes = find_nodes_to_push(shape, impact);
    const bool finds_bodies = find_bodies_to_push(shape, impact);
    if (!finds_nodes && !finds_bodies && obstacle_.highest == last_highest) break;
    SlidingWall wall{mass_, before, lowest_, obstacle_.highest};
    if (!pushed_bodies_.empty()) wall.tolerance = body_tolerance;
    common = common_velocity(wall, [&](double velocity) { return impulse_at(shape, velocity, impact); });
    velocity_ = common * normal_;
    // A slower wall meets no more, unless by its edges.
    if constexpr (std::is_same_v<Shape, PlaneShape>) break;
  }
  for (const PushedNode& pushed : pushed_) touched_[pushed.node] = 0;
  return common;
}

/// Lets the wall hit what is in its way, at the velocity that all have in common then.
template <class Shape>
void RigidWall::push_at(const Shape& shape, Impact& impact) {
  const double before = dot(velocity_, normal_);
  const double common = find_common_velocity(shape, impact);
  for (const PushedNode& pushed : pushed_) {
    const double change = common - pushed.limit;
    if (!(change > 0)) continue;
    stop_node(impact, pushed.node, {normal_, pushed.slowest});
    // What fixed directions take of the push comes from the wall as well.
    const Vec3 fixed_part = normal_ - impact.domain.nodes.free_translation(pushed.node, normal_);
    const Vec3 taken = pushed.mass * change * fixed_part;
    impact.sums.impulse -= taken;
    impact.sums.normal_impulse += dot(taken, normal_);
  }
  for (const Index place : pushed_bodies_) stop_body_at(shape, impact, place);
  if (common >= obstacle_.highest) meet_obstacle(impact, mass_ * (before - common));
}

/// What is missing of the wall's loss of momentum went to what cannot be moved.
void RigidWall::meet_obstacle(Impact& impact, double momentum_lost) const {
  const double missing = momentum_lost - impact.sums.normal_impulse;
  if (!(missing > 0)) return;
  const Vec3 received = missing * normal_;
  impact.sums.impulse -= received;
  impact.sums.normal_impulse += missing;
  if (obstacle_.body == no_index) return;
  domain::RigidBody& body = impact.domain.rigid_bodies[obstacle_.body];
  give_impulse(body, obstacle_.arm, received);
  const Vec3 previous = body.previous_velocity + cross(body.previous_spin, obstacle_.arm);
  impact.sums.energy -= 0.5 * dot(received, previous);
  impact.sums.deferred -= 0.5 * dot(received, velocity_at(body, obstacle_.arm));
}

/// Moves a wall with mass; in an impact it gives what the others take.
void RigidWall::book_slide(domain::WallReport& report, Sums& sums, double next_step) const {
  const Vec3 before = report.velocity;
  report.velocity -= (sums.normal_impulse / mass_) * normal_;
  report.displacement = displacement_ + next_step * report.velocity;
  report.kinetic_energy = 0.5 * mass_ * dot(before, report.velocity);
  sums.energy += 0.5 * sums.normal_impulse * dot(before, normal_);
  sums.deferred += 0.5 * sums.normal_impulse * dot(report.velocity, normal_);
}

double RigidWall::stop_nodes(domain::Domain& domain, const Step& step) {
  domain::WallReport& report = domain.walls[report_];
  const bool slides = mass_ > 0;
  displacement_ = report.displacement_now = report.displacement;
  if (!slides) {
    report.displacement = displacement_after(domain.clock, displacement_, step.next);
    report.velocity = (1.0 / step.next) * (report.displacement - displacement_);
  }
  velocity_ = report.velocity;
  frame_ = slides ? Vec3{} : velocity_;
  Impact impact{domain, step};
  Sums& sums = impact.sums;
  if (domain.clock.time >= birth_time_ && domain.clock.time <= death_time_)
    std::visit([&](const auto& shape) { slides ? push_at(shape, impact) : stop_at(shape, impact); },
               surface_);
  else
    near_.forget();
  if (slides) book_slide(report, sums, step.next);
  report.impulse += sums.impulse;
  report.normal_impulse += sums.normal_impulse;
  // An impulse at time n acts on the mean of v(n-1/2) and v(n+1/2); the kinetic energy of time n knows the
  // first.
  report.energy += report.deferred + sums.energy;
  report.deferred = sums.deferred;
  const double work = -0.5 * dot(sums.impulse, frame_);
  domain.energy.external_work += report.deferred_work + work;
  report.deferred_work = work;
  report.force = (1.0 / step.interval) * sums.impulse;
  report.normal_force = sums.normal_impulse / step.interval;
  return sums.kinetic;
}

}  // namespace crumple::constraints
