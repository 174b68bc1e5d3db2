// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/local_constraints.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "domain/local_holds.hpp"
#include "math/to_vec3.hpp"

namespace crumple::constraints {

using domain::Domain;
using math::Vec3;

namespace {

/// Sine of the angle to the plane of the directions before it, below which a direction adds nothing to them.
constexpr double dependent = 1e-6;

/// Any unit vector across another one.
Vec3 unit_across(const Vec3& direction) {
  Vec3 axis;
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (std::fabs(direction[i]) < std::fabs(direction[least])) least = i;
  axis[least] = 1;
  return normalised(cross(direction, axis));
}

/// Directions of length one across each other, which the constraints of a node have used up.
class Basis {
 public:
  /// The part of a direction that is new; zero if there is none.
  Vec3 new_part(const Vec3& direction) const {
    Vec3 rest = direction;
    // Twice: what rounding leaves of the first time is gone after the second.
    for (int pass = 0; pass < 2; ++pass)
      for (int i = 0; i < count_; ++i)
        rest -= dot(rest, used_[static_cast<std::size_t>(i)]) * used_[static_cast<std::size_t>(i)];
    const double length = norm(rest);
    return count_ == 3 || !(length > dependent) ? Vec3{} : (1 / length) * rest;
  }
  void use(const Vec3& direction) { used_[static_cast<std::size_t>(count_++)] = direction; }

 private:
  std::array<Vec3, 3> used_{};
  int count_ = 0;
};

/// Mean angular velocity about an axis over the step that has led to `arm`, or at present without a step.
double angular_velocity_about(const Vec3& axis, const Vec3& arm, const Vec3& velocity, double step) {
  const double square = dot(arm, arm);
  if (!(step > 0)) return square > 0 ? dot(axis, cross(arm, velocity)) / square : 0;
  Vec3 before = arm - step * velocity;
  before -= dot(before, axis) * axis;
  return std::atan2(dot(axis, cross(before, arm)), dot(before, arm)) / step;
}

/// Places of a list by the node that they are of: pairs in ascending order.
using PlacesByNode = std::vector<std::pair<Index, Index>>;

template <class Items>
PlacesByNode places_by_node(const Items& items, const std::vector<char>& local) {
  PlacesByNode found;
  for (Index place = 0; place < static_cast<Index>(items.size()); ++place) {
    const Index node = items[static_cast<std::size_t>(place)].node;
    if (node != no_index && local[static_cast<std::size_t>(node)] != 0) found.emplace_back(node, place);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The part of the list that is of one node.
std::span<const std::pair<Index, Index>> of_node(const PlacesByNode& list, Index node) {
  const auto first = std::lower_bound(list.begin(), list.end(), std::pair<Index, Index>{node, 0});
  const auto last = std::lower_bound(first, list.end(), std::pair<Index, Index>{node + 1, 0});
  return {first, last};
}

}  // namespace

std::vector<char> nodes_with_local_constraints(const model::Model& model) {
  std::vector<char> local(static_cast<std::size_t>(model.nodes.count()), 0);
  for (const model::LocalSupport& support : model.local_supports)
    local[static_cast<std::size_t>(support.node)] = 1;
  for (const model::PrescribedMotion& motion : model.prescribed_motions)
    if (motion.node != no_index && (motion.has_direction() || motion.goes_round))
      local[static_cast<std::size_t>(motion.node)] = 1;
  return local;
}

LocalConstraints::LocalConstraints(const model::Model& model, Domain& domain) : model_(&model) {
  const std::vector<char> local = nodes_with_local_constraints(model);
  const PlacesByNode motions = places_by_node(model.prescribed_motions, local);
  const PlacesByNode supports = places_by_node(model.local_supports, local);
  for (Index node = 0; node < model.nodes.count(); ++node) {
    if (local[static_cast<std::size_t>(node)] == 0) continue;
    const Index own = domain.nodes.domain_node[node];
    if (!domain.nodes.is_free(own))
      throw Error("Node " + std::to_string(model.nodes.id[node]) +
                  " is held or moved along axes of its own, but a rigid body moves it.");
    Node entry;
    entry.node = own;
    entry.first = rows_.size();
    // Motions go before supports, and of motions the last one first.
    const auto own_motions = of_node(motions, node);
    for (auto motion = own_motions.rbegin(); motion != own_motions.rend(); ++motion)
      add_motion(model.prescribed_motions[motion->second], motion->second);
    for (const auto& [of, place] : of_node(supports, node)) add_support(model.local_supports[place]);
    add_held_axes(domain.nodes.fixed[own]);
    entry.last = rows_.size();
    nodes_.push_back(entry);
    reactions_.push_back({own, {}, {}});
    stop_initial_motion(domain, entry);
  }
  deferred_.assign(nodes_.size(), 0.0);
  for (const model::LocalSupport& support : model.local_supports)
    changes_.insert(changes_.end(), {support.birth, support.death});
  std::sort(changes_.begin(), changes_.end());
}

void LocalConstraints::add_support(const model::LocalSupport& support) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool rotation : {false, true})
      if (rotation ? support.rotation[axis] : support.translation[axis])
        rows_.push_back(
            {math::to_vec3(support.axes[axis]), rotation, no_index, true, support.birth, support.death});
}

void LocalConstraints::add_held_axes(std::uint8_t fixed) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 direction;
    direction[axis] = 1;
    if ((fixed & domain::fixed_translation(axis)) != 0) rows_.push_back({.direction = direction});
    if ((fixed & domain::fixed_rotation(axis)) != 0)
      rows_.push_back({.direction = direction, .rotation = true});
  }
}

void LocalConstraints::add_motion(const model::PrescribedMotion& motion, Index place) {
  Row row;
  row.rotation = motion.rotation;
  row.motion = place;
  row.is_support = false;
  row.birth = motion.birth;
  row.death = motion.death;
  if (motion.goes_round) {
    // One row without a direction where the radius is free, else one along each axis of the plane.
    for (int k = 1; k <= (motion.keeps_radius ? 2 : 1); ++k) {
      row.direction = {};
      if (motion.keeps_radius) row.direction[(motion.axis + k) % 3] = 1;
      rows_.push_back(row);
    }
    return;
  }
  if (motion.has_direction())
    row.direction = math::to_vec3(motion.direction);
  else
    row.direction[motion.axis] = 1;
  rows_.push_back(row);
  if (!motion.holds_plane) return;
  const Vec3 along = row.direction;
  row.motion = no_index;
  row.direction = unit_across(along);
  rows_.push_back(row);
  row.direction = cross(along, row.direction);
  rows_.push_back(row);
}

void LocalConstraints::stop_initial_motion(Domain& domain, const Node& node) const {
  for (const bool rotation : {false, true}) {
    Vec3& velocity = (rotation ? domain.nodes.angular_velocity : domain.nodes.velocity)[node.node];
    Basis basis;
    for (std::size_t i = node.first; i < node.last; ++i) {
      const Row& row = rows_[i];
      if (!row.is_support || row.rotation != rotation || row.birth > 0) continue;
      const Vec3 part = basis.new_part(row.direction);
      if (norm(part) == 0) continue;
      velocity -= dot(velocity, part) * part;
      basis.use(part);
    }
  }
  domain.nodes.publish(node.node);
}

void LocalConstraints::refresh(Domain& domain) {
  const auto past = std::upper_bound(changes_.begin(), changes_.end(), domain.clock.time);
  if (past - changes_.begin() == changed_) return;
  changed_ = past - changes_.begin();
  domain::list_local_holds(*model_, domain.clock.time, domain.nodes);
}

void LocalConstraints::remember(const Domain& domain) {
  for (Node& node : nodes_) {
    node.position = domain.nodes.position[node.node];
    node.velocity = domain.nodes.velocity[node.node];
    node.spin = domain.nodes.angular_velocity[node.node];
  }
}

/// Of a motion round an axis: the chord of the arc of the step, so that the place at n+1 is on the circle;
/// or, where the radius is free, so much across the arm of time n that the node is on the ray of n+1. (Across
/// that ray itself the reaction would be of the end of the step, and the radial motion of first order.)
LocalConstraints::Demand LocalConstraints::demand_round(const Node& node, const Row& row,
                                                        const MotionTimes& times,
                                                        const Vec3& velocity) const {
  const model::PrescribedMotion& motion = model_->prescribed_motions[row.motion];
  const double step = times.next_step;
  Vec3 axis;
  axis[motion.axis] = 1;
  Vec3 arm = node.position - math::to_vec3(motion.centre);
  arm[motion.axis] = 0;
  const double before = angular_velocity_about(axis, arm, node.velocity, 2 * times.interval - step);
  const double angle = step * prescribed_velocity(motion, model_->curves[motion.curve], times, before);
  const Vec3 across = cross(axis, arm);
  if (motion.keeps_radius) {
    const double sine = std::sin(0.5 * angle);
    const Vec3 chord = std::sin(angle) * across - 2 * sine * sine * arm;
    return {row.direction, dot(chord, row.direction) / step};
  }
  const double radius = norm(arm);
  if (!(radius > 0)) return {};
  const double next_radius = radius + step * dot(velocity, arm) / radius;
  return {(1 / radius) * across, next_radius * std::tan(angle) / step};
}

LocalConstraints::Demand LocalConstraints::demand(const Node& node, const Row& row, const MotionTimes& times,
                                                  const Vec3& velocity) const {
  if (row.motion == no_index) return {row.direction, 0};
  const model::PrescribedMotion& motion = model_->prescribed_motions[row.motion];
  if (motion.goes_round) return demand_round(node, row, times, velocity);
  const double before = dot(row.rotation ? node.spin : node.velocity, row.direction);
  return {row.direction, prescribed_velocity(motion, model_->curves[motion.curve], times, before)};
}

Vec3 LocalConstraints::constrain(const Node& node, bool rotation, const MotionTimes& times,
                                 Vec3& velocity) const {
  Vec3 by_supports;
  Basis basis;
  for (std::size_t i = node.first; i < node.last; ++i) {
    const Row& row = rows_[i];
    if (row.rotation != rotation || times.time < row.birth || times.time >= row.death) continue;
    const Demand asked = demand(node, row, times, velocity);
    const Vec3 part = basis.new_part(asked.direction);
    if (norm(part) == 0) continue;
    // Along the new part alone, so that what goes before stays as it is.
    const double lacks = asked.velocity - dot(velocity, asked.direction);
    const Vec3 change = (lacks / dot(part, asked.direction)) * part;
    velocity += change;
    if (row.is_support) by_supports += change;
    basis.use(part);
  }
  return by_supports;
}

KineticChange LocalConstraints::impose(Domain& domain, double interval, double next_step) {
  domain::NodeFields& nodes = domain.nodes;
  const MotionTimes times{domain.clock.time, interval, next_step};
  KineticChange sum;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    domain.energy.external_work += deferred_[i];
    deferred_[i] = 0;
    for (const bool rotation : {false, true}) {
      const double mass = rotation ? nodes.moving_inertia(node.node) : nodes.moving_mass(node.node);
      Vec3& velocity = (rotation ? nodes.angular_velocity : nodes.velocity)[node.node];
      const Vec3 kicked = velocity;
      const Vec3 by_supports = constrain(node, rotation, times, velocity);
      const Vec3 impulse = mass * (velocity - kicked);
      const double work = 0.5 * dot(impulse, rotation ? node.spin : node.velocity);
      domain.energy.external_work += work;
      (rotation ? sum.rotational : sum.translational) += work;
      deferred_[i] += 0.5 * dot(impulse, velocity);
      (rotation ? reactions_[i].moment : reactions_[i].force) = (mass / interval) * by_supports;
    }
  }
  return sum;
}

void LocalConstraints::declare(domain::StateList& list) {
  if (!empty()) list.add("local_deferred_work", "energy", domain::Entity::Run, 1, std::span(deferred_));
}

}  // namespace crumple::constraints
