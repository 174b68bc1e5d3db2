// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/multipliers.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "contact/enforcement/penalty.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

constexpr Index piece = 1024;

}  // namespace

Multipliers::Multipliers(const Surface& surface, const model::Contact& contact)
    : surface_(&surface),
      contact_(contact),
      compliance_(surface.nodes.size()),
      holds_(surface.nodes.size()),
      displacement_(surface.nodes.size()) {}

/// Of a node of the surface.
void Multipliers::predict_node(const domain::NodeFields& nodes, Index node, double interval) {
  const Index place = surface_->place[node];
  Vec3& compliance = compliance_[place];
  compliance = Vec3{};
  holds_[place] = nullptr;
  if (!nodes.is_free(node) || !(nodes.mass[node] > 0)) return;
  const double inverse = interval / nodes.mass[node];
  const double* const force = nodes.force[node].force;
  if (const domain::LocalHold* const hold = nodes.local_hold_of(node)) {
    holds_[place] = hold;
    velocity_[node] = hold->free * (velocity_[node] + inverse * Vec3{force[0], force[1], force[2]});
    if (hold->held < 3) compliance = step_ * inverse * Vec3{1, 1, 1};
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if ((nodes.fixed[node] & domain::fixed_translation(axis)) != 0) continue;
    velocity_[node][axis] += inverse * force[axis];
    compliance[axis] = step_ * inverse;
  }
}

Kinematics Multipliers::predict(const domain::Domain& domain, double interval, double step) {
  const domain::NodeFields& nodes = domain.nodes;
  step_ = step;
  position_.resize(nodes.position.size());
  velocity_.resize(nodes.position.size());
  parallel_for(pieces(nodes.count(), piece), domain.execution.threads, [&](Index part) {
    for (Index i = part * piece; i < std::min((part + 1) * piece, nodes.count()); ++i) {
      velocity_[i] = nodes.velocity[i];
      if (surface_->place[i] != no_index) predict_node(nodes, i, interval);
      position_[i] = nodes.position[i] + step * velocity_[i];
    }
  });
  return {.position = position_,
          .velocity = velocity_,
          .reference = {nodes.reference.data(), nodes.reference.size()},
          .step = step,
          .cycle = domain.clock.cycle,
          .threads = domain.execution.threads,
          .isa = domain.execution.isa};
}

Multipliers::Unknown Multipliers::prepare(const Touch& touch) const {
  Unknown unknown;
  Vec3 sum;
  double local = 0;  // what supports along axes of their own take from the compliance along the normal
  for (int i = 0; i < touch.nodes; ++i) {
    const Index place = touch.place[i];
    const Vec3 own = touch.weight[i] * touch.weight[i] * compliance_[place];
    sum += own;
    if (holds_[place] != nullptr)
      local += own.x * (1 - dot(touch.normal, holds_[place]->free * touch.normal));
  }
  for (int axis = 0; axis < 3; ++axis)
    unknown.compliance += touch.normal[axis] * touch.normal[axis] * sum[axis];
  unknown.tangential_compliance = std::max({sum.x, sum.y, sum.z});
  unknown.compliance -= local;
  if (local > 0 && unknown.compliance < tolerances::least_compliance * unknown.tangential_compliance)
    unknown.compliance = 0;
  // Where the contact point is at a node that cannot move, the others would have to go any distance for it.
  double largest = 0;
  for (int i = 0; i < touch.nodes; ++i) {
    const Vec3& own = compliance_[touch.place[i]];
    largest = std::max(largest, std::fabs(touch.weight[i]) * std::max({own.x, own.y, own.z}));
  }
  if (largest > tolerances::most_leverage * unknown.tangential_compliance)
    unknown.compliance = unknown.tangential_compliance = 0;
  const Vec3 slip = touch.slip - dot(touch.slip, touch.normal) * touch.normal;
  const model::Friction law = contact_.friction_between(touch.part[0], touch.part[1]);
  unknown.friction =
      law.when_sliding + (law.at_rest - law.when_sliding) * decay(law.decay * norm(slip) / step_);
  unknown.friction_stress = law.stress;
  return unknown;
}

/// Adds what a force on the first point of a touch, and its reverse on the second, does to the nodes.
void Multipliers::move(const Touch& touch, const Vec3& force) {
  for (int i = 0; i < touch.nodes; ++i) {
    const Index place = touch.place[i];
    const Vec3& compliance = compliance_[place];
    const Vec3 felt = holds_[place] != nullptr ? holds_[place]->free * force : force;
    for (int axis = 0; axis < 3; ++axis)
      displacement_[place][axis] += touch.weight[i] * compliance[axis] * felt[axis];
  }
}

/// Displacement of the first point of a touch relative to the second by all forces so far.
Vec3 Multipliers::moved(const Touch& touch) const {
  Vec3 sum;
  for (int i = 0; i < touch.nodes; ++i) sum += touch.weight[i] * displacement_[touch.place[i]];
  return sum;
}

/// Returns the displacement by which it corrects.
double Multipliers::correct_normal(const Touch& touch, Unknown& unknown) {
  if (unknown.compliance <= 0) return 0;
  const double left = touch.share * touch.fade * touch.penetration - dot(moved(touch), touch.normal);
  const double force = std::max(0.0, unknown.force + left / unknown.compliance);
  const double change = force - unknown.force;
  if (change == 0) return 0;
  unknown.force = force;
  move(touch, change * touch.normal);
  return std::fabs(change) * unknown.compliance;
}

double Multipliers::correct_friction(const Touch& touch, Unknown& unknown) {
  if (unknown.friction <= 0 || unknown.tangential_compliance <= 0) return 0;
  const auto tangential = [&](const Vec3& a) { return a - dot(a, touch.normal) * touch.normal; };
  const Vec3 slip = tangential(touch.slip + moved(touch));
  Vec3 force = unknown.friction_force - (1 / unknown.tangential_compliance) * slip;
  double capacity = unknown.friction * unknown.force;
  if (unknown.friction_stress > 0) capacity = std::min(capacity, unknown.friction_stress * touch.area);
  const double size = norm(force);
  if (size > capacity) force = (capacity / size) * force;
  const Vec3 change = force - unknown.friction_force;
  unknown.friction_force = force;
  move(touch, change);
  return norm(change) * unknown.tangential_compliance;
}

/// Movement of the first point of a touch over the second in this step, by the predicted velocities.
Vec3 Multipliers::slip_in_step(const Touch& touch) const {
  Vec3 sum;
  for (int i = 0; i < touch.nodes; ++i) sum += touch.weight[i] * velocity_[surface_->nodes[touch.place[i]]];
  return step_ * sum;
}

void Multipliers::solve(std::span<Touch> touches) {
  unknowns_.clear();
  double scale = 0;
  for (Touch& touch : touches) {
    // One that begins has no point of the step before, but slips: nodes of elastic bodies begin often.
    if (dot(touch.slip, touch.slip) == 0) touch.slip = slip_in_step(touch);
    unknowns_.push_back(prepare(touch));
    scale = std::max({scale, touch.penetration, unknowns_.back().friction > 0 ? norm(touch.slip) : 0.0});
    for (int i = 0; i < touch.nodes; ++i) displacement_[touch.place[i]] = Vec3{};
  }
  double change = scale;
  for (rounds_ = 0;
       change > tolerances::multipliers_converged * scale && rounds_ < tolerances::most_multiplier_rounds;
       ++rounds_) {
    change = 0;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      change = std::max(change, correct_normal(touches[i], unknowns_[i]));
      change = std::max(change, correct_friction(touches[i], unknowns_[i]));
    }
  }
  for (std::size_t i = 0; i < touches.size(); ++i) {
    Touch& touch = touches[i];
    touch.normal_force = unknowns_[i].force * touch.normal;
    touch.friction = unknowns_[i].friction_force;
    touch.penetration -= dot(moved(touch), touch.normal);
  }
  // Each node once, though several touches may have it.
  for (const Touch& touch : touches)
    for (int i = 0; i < touch.nodes; ++i) {
      Vec3& displacement = displacement_[touch.place[i]];
      position_[surface_->nodes[touch.place[i]]] += displacement;
      displacement = Vec3{};
    }
}

}  // namespace crumple::contact
