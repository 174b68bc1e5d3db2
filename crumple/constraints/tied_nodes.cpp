// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/tied_nodes.hpp"

#include <algorithm>
#include <utility>

#include "constraints/tie_lever.hpp"

namespace crumple::constraints {

using domain::Domain;
using domain::NodeFields;
using math::Vec3;

namespace {

/// Takes the components along fixed axes out; `fixed` has the bits of three axes.
Vec3 held(Vec3 vector, unsigned fixed) {
  for (int axis = 0; axis < 3; ++axis)
    if ((fixed >> static_cast<unsigned>(axis) & 1U) != 0) vector[axis] = 0;
  return vector;
}

/// The energy that is lost where the ties end of which this is the first: what all that are tied carry less.
void book_release(Domain& domain, const TieLink& first, double before, double after) {
  if (first.embedded) {
    domain.embeddings[first.tie].lost += before - after;
    return;
  }
  domain::Tie& tie = domain.ties[first.tie];
  tie.energy += before;
  tie.energy -= after;
  tie.dissipated = std::max(0.0, tie.energy);
}

}  // namespace

TiedNodes::TiedNodes(const model::Model& model, Domain& domain) {
  death_time_.reserve(model.tied_contacts.size());
  for (const model::TiedContact& tied : model.tied_contacts) death_time_.push_back(tied.death_time);
  for (const model::EmbeddedBeams& embedded : model.embedded_beams) end_time_.push_back(embedded.end_time);
  TieLinks found = find_tie_links(model, domain);
  links_ = std::move(found.links);
  members_ = std::move(found.members);
  if (links_.empty()) return;
  tied_by_.assign(members_.size(), no_index);
  for (std::size_t i = 0; i < links_.size(); ++i) tied_by_[links_[i].node] = static_cast<Index>(i);
  active_.assign(links_.size(), 1);
  before_.resize(members_.size());
  spin_before_.resize(members_.size());
  momentum_.resize(members_.size());
  moment_.resize(members_.size());
  share_masses(domain);
  share_velocities(domain);
  place_nodes(domain);
  remember(domain);
}

/// What every member carries; marks the tied ones.
void TiedNodes::share_masses(Domain& domain) {
  if (links_.empty()) return;
  NodeFields& nodes = domain.nodes;
  nodes.carried_mass.assign(static_cast<std::size_t>(nodes.count()), 0.0);
  nodes.carried_inertia.assign(static_cast<std::size_t>(nodes.count()), 0.0);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const TieLink& link = links_[i];
    const Index node = members_[link.node];
    if (active_[i] == 0) {
      nodes.fixed[node] &= static_cast<std::uint8_t>(~domain::moved_by_tie);
      tied_by_[link.node] = no_index;
      continue;
    }
    nodes.fixed[node] |= domain::moved_by_tie;
    for (std::size_t k = 0; k < link.corners; ++k) {
      const Index corner = members_[link.corner[k]];
      nodes.carried_mass[corner] += link.weight[k] * nodes.moving_mass(node);
      if (link.rotates && !link.turns_on_face)
        nodes.carried_inertia[corner] += link.weight[k] * nodes.moving_inertia(node);
    }
  }
}

std::array<Vec3, 4> TiedNodes::corners(const NodeFields& nodes, const TieLink& link) const {
  std::array<Vec3, 4> corner;
  for (std::size_t k = 0; k < TieLink::of_segment; ++k) corner[k] = nodes.position[members_[link.corner[k]]];
  return corner;
}

TiedNodes::Motion TiedNodes::motion_of_segment(const NodeFields& nodes, const TieLink& link,
                                               double step) const {
  Motion motion;
  if (link.embedded) {
    for (std::size_t k = 0; k < link.corners; ++k)
      motion.velocity += link.weight[k] * nodes.velocity[members_[link.corner[k]]];
    return motion;
  }
  std::array<Vec3, TieLink::of_segment> velocity;
  for (std::size_t k = 0; k < TieLink::of_segment; ++k) {
    velocity[k] = nodes.velocity[members_[link.corner[k]]];
    motion.velocity += link.weight[k] * velocity[k];
    motion.spin += link.weight[k] * nodes.angular_velocity[members_[link.corner[k]]];
  }
  if (link.height == 0 && !link.turns_on_face) return motion;
  const TieLever lever(corners(nodes, link), link.height);
  if (link.height != 0) motion.velocity += lever.velocity(velocity, step);
  if (link.turns_on_face) motion.spin = lever.spin(velocity, step);
  return motion;
}

/// What a node has received goes to the corners of its segment.
void TiedNodes::pass_on(const NodeFields& nodes, const TieLink& link) {
  for (std::size_t k = 0; k < link.corners; ++k) {
    momentum_[link.corner[k]] += link.weight[k] * momentum_[link.node];
    if (link.rotates && !link.turns_on_face) moment_[link.corner[k]] += link.weight[k] * moment_[link.node];
  }
  if (link.height == 0 && !link.turns_on_face) return;
  const TieLever lever(corners(nodes, link), link.height);
  const auto add = [&](const std::array<Vec3, 4>& couple) {
    for (std::size_t k = 0; k < couple.size(); ++k) momentum_[link.corner[k]] += couple[k];
  };
  if (link.height != 0) add(lever.couple(momentum_[link.node]));
  // The corners have no rotations: the moment arrives as forces on them.
  if (link.turns_on_face) add(lever.couple_of_moment(moment_[link.node]));
}

/// A couple acts on corners that carry nothing, too.
void TiedNodes::mark_receivers() {
  receives_.assign(members_.size(), 0);
  for (std::size_t i = 0; i < links_.size(); ++i)
    if (active_[i] != 0)
      for (std::size_t k = 0; k < links_[i].corners; ++k) receives_[links_[i].corner[k]] = 1;
}

/// At time zero: the momenta by which the tied nodes move against their segments go to these.
void TiedNodes::share_velocities(Domain& domain) {
  NodeFields& nodes = domain.nodes;
  for (const TieLink& link : links_) {
    const Index node = members_[link.node];
    const Motion segment = motion_of_segment(nodes, link, 0);
    momentum_[link.node] += nodes.moving_mass(node) * (nodes.velocity[node] - segment.velocity);
    moment_[link.node] += nodes.moving_inertia(node) * (nodes.angular_velocity[node] - segment.spin);
    pass_on(nodes, link);
  }
  mark_receivers();
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const Index node = members_[m];
    const unsigned fixed = nodes.fixed[node];
    const bool tied = tied_by_[m] != no_index;
    if (!tied && receives_[m] != 0)
      nodes.velocity[node] += held((1 / nodes.moving_mass(node)) * momentum_[m], fixed);
    const bool turned = tied && links_[tied_by_[m]].rotates;
    if (!turned && nodes.carried_inertia[node] != 0)
      nodes.angular_velocity[node] += held((1 / nodes.moving_inertia(node)) * moment_[m], fixed >> 3U);
  }
  copy_velocities(domain, 0);
}

/// Those of the places on the segments, of nodes that carry nothing last.
void TiedNodes::copy_velocities(Domain& domain, double step) const {
  NodeFields& nodes = domain.nodes;
  for (std::size_t i = links_.size(); i-- > 0;) {
    const TieLink& link = links_[i];
    if (active_[i] == 0) continue;
    const Motion segment = motion_of_segment(nodes, link, step);
    nodes.velocity[members_[link.node]] = segment.velocity;
    if (link.rotates) nodes.angular_velocity[members_[link.node]] = segment.spin;
  }
}

/// Whether a tie ends now; elements are asked only if `look` says that some may have eroded.
bool TiedNodes::is_over(const Domain& domain, const TieLink& link, bool look) const {
  const auto failed = [&](const domain::SolidPlace& solid) {
    return domain::has_failed(domain, solid.block, solid.element);
  };
  if (link.embedded)
    return domain.clock.time >= end_time_[link.tie] ||
           (look && std::ranges::all_of(domain.embeddings[link.tie].nodes[link.at].hosts, failed));
  return domain.clock.time >= death_time_[link.tie] || (look && failed({link.block, link.element}));
}

void TiedNodes::release(Domain& domain) {
  if (links_.empty()) return;
  const Index eroded = domain::eroded_elements(domain);
  const bool look = eroded != eroded_;
  eroded_ = eroded;
  const TieLink* first = nullptr;
  double carried = 0;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const TieLink& link = links_[i];
    if (active_[i] == 0) continue;
    if (!is_over(domain, link, look)) continue;
    if (first == nullptr) {
      first = &link;
      remember(domain);
      const KineticChange before = carried_energy(domain);
      carried = before.translational + before.rotational;
    }
    active_[i] = 0;
    (link.embedded ? domain.embeddings[link.tie].holds : domain.ties[link.tie].holds)[link.at] = 0;
    ++(link.embedded ? domain.embeddings[link.tie].released : domain.ties[link.tie].released);
  }
  if (first == nullptr) return;
  share_masses(domain);
  const KineticChange after = carried_energy(domain);
  book_release(domain, *first, carried, after.translational + after.rotational);
}

void TiedNodes::remember(const Domain& domain) {
  for (std::size_t m = 0; m < members_.size(); ++m) {
    before_[m] = domain.nodes.velocity[members_[m]];
    spin_before_[m] = domain.nodes.angular_velocity[members_[m]];
  }
}

KineticChange TiedNodes::share(Domain& domain) {
  NodeFields& nodes = domain.nodes;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const Index node = members_[m];
    momentum_[m] = nodes.mass[node] * (nodes.velocity[node] - before_[m]);
    moment_[m] = nodes.inertia[node] * (nodes.angular_velocity[node] - spin_before_[m]);
  }
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const TieLink& link = links_[i];
    if (active_[i] == 0) continue;
    pass_on(nodes, link);
  }
  mark_receivers();
  KineticChange change;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const Index node = members_[m];
    const unsigned fixed = nodes.fixed[node];
    Vec3& velocity = nodes.velocity[node];
    Vec3& spin = nodes.angular_velocity[node];
    if (tied_by_[m] == no_index && receives_[m] != 0)
      velocity = before_[m] + held((1 / nodes.moving_mass(node)) * momentum_[m], fixed);
    if (tied_by_[m] != no_index && links_[tied_by_[m]].rotates) {
      change.rotational -= 0.5 * nodes.inertia[node] * dot(spin_before_[m], spin);
    } else if (nodes.carried_inertia[node] != 0) {
      const double own = nodes.inertia[node] * dot(spin_before_[m], spin);
      spin = spin_before_[m] + held((1 / nodes.moving_inertia(node)) * moment_[m], fixed >> 3U);
      change.rotational += 0.5 * (nodes.moving_inertia(node) * dot(spin_before_[m], spin) - own);
    }
  }
  return change;
}

TiedNodes::Share TiedNodes::share_of(Index node) const {
  Share share;
  const auto found = std::lower_bound(members_.begin(), members_.end(), node);
  if (found == members_.end() || *found != node) return share;
  const auto m = static_cast<std::size_t>(found - members_.begin());
  const Index link = tied_by_[m];
  if (link == no_index) share.momentum = momentum_[m];
  if (link == no_index || !links_[link].rotates) share.moment = moment_[m];
  return share;
}

void TiedNodes::follow(Domain& domain, double interval, double next_step) {
  copy_velocities(domain, next_step);
  NodeFields& nodes = domain.nodes;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const TieLink& link = links_[i];
    if (active_[i] == 0) continue;
    const Index node = members_[link.node];
    const Vec3 change = nodes.velocity[node] - before_[link.node];
    Vec3& force = link.embedded ? domain.embeddings[link.tie].force : domain.ties[link.tie].force;
    force += (1 / interval) * (nodes.moving_mass(node) * change - momentum_[link.node]);
  }
  if (!keep_acceleration_) return;
  for (std::size_t m = 0; m < members_.size(); ++m)
    nodes.acceleration[members_[m]] = (1 / interval) * (nodes.velocity[members_[m]] - before_[m]);
}

double TiedNodes::place_nodes(Domain& domain) const {
  NodeFields& nodes = domain.nodes;
  double largest = 0;
  for (std::size_t i = links_.size(); i-- > 0;) {
    const TieLink& link = links_[i];
    if (active_[i] == 0) continue;
    Vec3 position;
    for (std::size_t k = 0; k < link.corners; ++k)
      position += link.weight[k] * nodes.position[members_[link.corner[k]]];
    if (link.height != 0) {
      const TieLever lever(corners(nodes, link), link.height);
      if (!(lever.size > 0)) continue;
      position += link.height * lever.normal;
    }
    largest = std::max(largest, norm(position - nodes.position[members_[link.node]]));
    nodes.position[members_[link.node]] = position;
    nodes.publish(members_[link.node]);
  }
  return largest;
}

KineticChange TiedNodes::carried_energy(const Domain& domain) const {
  const NodeFields& nodes = domain.nodes;
  KineticChange energy;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const Index node = members_[m];
    const double translational = dot(before_[m], nodes.velocity[node]);
    const double rotational = dot(spin_before_[m], nodes.angular_velocity[node]);
    const bool tied = tied_by_[m] != no_index;
    energy.translational += 0.5 * (tied ? -nodes.mass[node] : nodes.carried_mass[node]) * translational;
    const bool turned = tied && links_[tied_by_[m]].rotates;
    energy.rotational += 0.5 * (turned ? -nodes.inertia[node] : nodes.carried_inertia[node]) * rotational;
  }
  return energy;
}

void TiedNodes::declare(domain::StateList& list) {
  list.add("tied_nodes", "-", domain::Entity::Contact, 1, std::span(active_));
  list.keep_list("tied_by", "-", domain::Entity::Contact, 1, tied_by_);
  list.keep("tied_nodes_eroded", "-", domain::Entity::Contact, eroded_);
}

}  // namespace crumple::constraints
