// SPDX-License-Identifier: BSD-3-Clause
#include "contact/forces.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "base/parallel.hpp"
#include "contact/penalty.hpp"

namespace crumple::contact {
namespace {

constexpr Index piece = 64;

/// Step by which stability is judged: the larger of the last one and what the elements allow now.
double judged_step(const domain::Domain& domain, double step_scale) {
  return std::max(domain.clock.step, step_scale * domain.clock.element_limit);
}

}  // namespace

Forces::Forces(const Surface& surface, const model::SingleSurfaceContact& contact, double step_scale)
    : surface_(&surface),
      contact_(contact),
      step_scale_(step_scale),
      budget_(stability_budget(step_scale) * damping_factor(contact.viscous_damping)) {
  const std::size_t places = surface.nodes.size();
  touches_.resize(places);
  normal_.resize(places);
  friction_.resize(places);
  previous_normal_.resize(places);
  previous_friction_.resize(places);
}

void Forces::add(domain::Domain& domain, std::span<ContactPair> pairs, domain::ContactReport& report) {
  const auto count = static_cast<Index>(pairs.size());
  count_touches(pairs);
  pair_forces_.resize(pairs.size());
  parallel_for(pieces(count, piece), domain.execution.threads, [&](Index part) {
    for (Index i = part * piece; i < std::min((part + 1) * piece, count); ++i)
      pair_forces_[i] = evaluate(domain, pairs[i]);
  });
  limited_ = 0;
  for (Index i = 0; i < count; ++i) {
    pairs[i].friction = pair_forces_[i].friction;
    if (pair_forces_[i].limited) ++limited_;
  }
  scatter(pairs);
  add_work(domain, report);
  hand_over(domain);
}

/// How many pairs act on each node: its mass is shared out among them when stability is judged.
void Forces::count_touches(std::span<const ContactPair> pairs) {
  active_.clear();
  const auto touch = [&](Index place) {
    if (touches_[place]++ == 0) active_.push_back(place);
  };
  for (const ContactPair& pair : pairs) {
    if (pair.penetration() <= 0) continue;
    touch(pair.node);
    const int corners = surface_->is_triangle(pair.segment) ? 3 : 4;
    for (int k = 0; k < corners; ++k) touch(surface_->place[surface_->segment(pair.segment)[k]]);
  }
  std::sort(active_.begin(), active_.end());
}

/// 1/m* of the pair, each node lending its mass divided by the number of pairs that act on it: a spring of
/// stiffness k then has omega^2 <= k / m* in the assembled system (docs/theory/contact.md) [1/mass].
double Forces::inverse_mass(const domain::NodeFields& nodes, const ContactPair& pair) const {
  double sum = touches_[pair.node] / nodes.mass[surface_->nodes[pair.node]];
  const Index* segment = surface_->segment(pair.segment);
  for (int k = 0; k < 4; ++k) {
    if (pair.weight[k] == 0) continue;
    sum += pair.weight[k] * pair.weight[k] * touches_[surface_->place[segment[k]]] / nodes.mass[segment[k]];
  }
  return sum;
}

/// Of SOFT = 1: 1/2 SOFSCL m* / dt^2 with the whole masses of the nodes (LS-DYNA Keyword User's Manual,
/// *CONTACT, optional card A) [force/length].
double Forces::least_stiffness(const domain::NodeFields& nodes, const ContactPair& pair, double step) const {
  if (contact_.soft_scale <= 0 || step <= 0) return 0;
  double inverse = 1 / nodes.mass[surface_->nodes[pair.node]];
  const Index* segment = surface_->segment(pair.segment);
  for (int k = 0; k < 4; ++k) inverse += pair.weight[k] * pair.weight[k] / nodes.mass[segment[k]];
  return 0.5 * contact_.soft_scale / (step * step * inverse);
}

Forces::PairForce Forces::evaluate(const domain::Domain& domain, const ContactPair& pair) const {
  if (pair.penetration() <= 0) return {};
  const domain::NodeFields& nodes = domain.nodes;
  const Index* segment = surface_->segment(pair.segment);
  const double inverse = inverse_mass(nodes, pair);
  const double step = judged_step(domain, step_scale_);
  PenaltyLaw law;
  law.stiffness = std::max(std::min(surface_->node_stiffness[pair.node], surface_->stiffness[pair.segment]),
                           least_stiffness(nodes, pair, step));
  law.limit = step > 0 ? budget_ / (step * step * inverse) : std::numeric_limits<double>::max();
  // Behind a face there is no mid-surface that a strong squeeze would reach.
  law.reach = surface_->is_face(pair.segment) ? std::numeric_limits<double>::max() : pair.reach;

  Vec3 relative = nodes.velocity[surface_->nodes[pair.node]];
  for (int k = 0; k < 4; ++k) relative -= pair.weight[k] * nodes.velocity[segment[k]];
  const double stiffness = std::min(law.stiffness, law.limit);
  const double damping = 2 * contact_.viscous_damping * std::sqrt(stiffness / inverse);
  // Damping may take the force down to zero, but never pulls.
  const double size = std::max(0.0, law.force(pair.penetration()) - damping * dot(relative, pair.normal));

  PairForce force;
  force.limited = law.limit < law.stiffness;
  force.normal = pair.share * size * pair.normal;
  force.friction = friction(pair, pair.share * size, pair.share * stiffness, domain.clock.step);
  return force;
}

/// Coulomb friction by a tangential spring that gives way at mu f: sticks below, slips above
/// (Hallquist, LS-DYNA Theory Manual, friction of sliding interfaces).
Vec3 Forces::friction(const ContactPair& pair, double normal_force, double stiffness, double step) const {
  if (contact_.static_friction <= 0 && contact_.dynamic_friction <= 0) return {};
  const auto tangential = [&](const Vec3& a) { return a - dot(a, pair.normal) * pair.normal; };
  const Vec3 slip = tangential(pair.slip);
  const double speed = step > 0 ? norm(slip) / step : 0.0;
  const double mu = contact_.dynamic_friction + (contact_.static_friction - contact_.dynamic_friction) *
                                                    decay(contact_.friction_decay * speed);
  const Vec3 trial = tangential(pair.friction) - stiffness * slip;
  const double size = norm(trial);
  double capacity = mu * normal_force;
  if (contact_.friction_stress > 0)
    capacity = std::min(capacity, contact_.friction_stress * surface_->area[pair.segment]);
  return size > capacity ? capacity / size * trial : trial;
}

/// In the order of the pairs, one after another: there are few, and the sums must not depend on threads.
void Forces::scatter(std::span<const ContactPair> pairs) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const ContactPair& pair = pairs[i];
    if (pair.penetration() <= 0) continue;
    const PairForce& force = pair_forces_[i];
    normal_[pair.node] += force.normal;
    friction_[pair.node] += force.friction;
    const Index* segment = surface_->segment(pair.segment);
    for (int k = 0; k < 4; ++k) {
      const Index place = surface_->place[segment[k]];
      normal_[place] -= pair.weight[k] * force.normal;
      friction_[place] -= pair.weight[k] * force.friction;
    }
  }
}

/// Trapezoidal rule: the mean of the forces at both ends of the step, times the displacement between them.
void Forces::add_work(const domain::Domain& domain, domain::ContactReport& report) {
  std::vector<Index> both;
  std::set_union(active_.begin(), active_.end(), previous_active_.begin(), previous_active_.end(),
                 std::back_inserter(both));
  double normal = 0;
  double friction = 0;
  for (const Index place : both) {
    const Vec3& v = domain.nodes.velocity[surface_->nodes[place]];
    normal += dot(previous_normal_[place] + normal_[place], v);
    friction += dot(previous_friction_[place] + friction_[place], v);
  }
  report.energy -= 0.5 * domain.clock.step * normal;
  report.friction_energy -= 0.5 * domain.clock.step * friction;
}

/// Adds the sums to the domain and makes them the previous ones.
void Forces::hand_over(domain::Domain& domain) {
  for (const Index place : active_) {
    const Index node = surface_->nodes[place];
    const Vec3 sum = normal_[place] + friction_[place];
    domain.contact_force[node] += sum;
    for (int axis = 0; axis < 3; ++axis) domain.nodes.force[node].force[axis] += sum[axis];
    touches_[place] = 0;
  }
  for (const Index place : previous_active_) {
    previous_normal_[place] = Vec3{};
    previous_friction_[place] = Vec3{};
  }
  std::swap(previous_normal_, normal_);
  std::swap(previous_friction_, friction_);
  std::swap(previous_active_, active_);
}

void Forces::declare(domain::StateList& list) {
  list.add("contact_normal_force", "force", domain::Entity::Contact, 3, std::span(previous_normal_));
  list.add("contact_friction_force", "force", domain::Entity::Contact, 3, std::span(previous_friction_));
}

}  // namespace crumple::contact
