// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/tied_nodes.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "constraints/node_owners.hpp"

namespace crumple::constraints {

using domain::Domain;
using domain::NodeFields;
using math::Vec3;

namespace {

std::string name_of(const model::Model& model, const NodeFields& nodes, Index node) {
  return "node " + std::to_string(model.nodes.id[nodes.model_node[node]]);
}

/// Takes the components along fixed axes out; `fixed` has the bits of three axes.
Vec3 held(Vec3 vector, unsigned fixed) {
  for (int axis = 0; axis < 3; ++axis)
    if ((fixed >> static_cast<unsigned>(axis) & 1U) != 0) vector[axis] = 0;
  return vector;
}

/// What is wrong with tying a node, after its name; empty if nothing is. Fixed directions of the node must be
/// fixed at all nodes that it follows, as they are where both lie in a plane of symmetry.
std::string fault_of(const Domain& domain, const NodeOwners& owners, const domain::TiedNode& tied,
                     bool rotates) {
  const NodeFields& nodes = domain.nodes;
  const Index at = nodes.model_node[tied.node];
  const std::string& owner = owners.body[at].empty() ? owners.joint[at] : owners.body[at];
  if (!owner.empty()) return " is tied to a segment and belongs to " + owner;
  constexpr unsigned translations = 7;
  constexpr unsigned all = 63;
  const unsigned fixed = nodes.fixed[tied.node] & (rotates ? all : translations);
  for (std::size_t k = 0; k < 4; ++k)
    if (tied.weight[k] != 0 && (fixed & ~static_cast<unsigned>(nodes.fixed[tied.corner[k]])) != 0)
      return " is tied to a segment and held by *BOUNDARY_SPC in a direction in which that is free";
  return "";
}

}  // namespace

TiedNodes::TiedNodes(const model::Model& model, Domain& domain) {
  death_time_.reserve(model.tied_contacts.size());
  for (const model::TiedContact& tied : model.tied_contacts) death_time_.push_back(tied.death_time);
  add_links(model, domain);
  if (links_.empty()) return;
  check_corners(model, domain);
  order_links(model, domain);
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

void TiedNodes::add_links(const model::Model& model, const Domain& domain) {
  const NodeFields& nodes = domain.nodes;
  const NodeOwners owners = owners_of_nodes(model);
  for (std::size_t t = 0; t < domain.ties.size(); ++t) {
    const domain::Tie& tie = domain.ties[t];
    if (tie.method != model::TieMethod::Constraint) continue;
    links_.reserve(links_.size() + tie.nodes.size());
    for (const domain::TiedNode& tied : tie.nodes) {
      Link link;
      link.tie = static_cast<Index>(t);
      link.at = static_cast<Index>(&tied - tie.nodes.data());
      link.node = tied.node;
      link.corner = tied.corner;
      link.weight = tied.weight;
      link.block = tied.block;
      link.element = tied.element;
      link.rotates = model.tied_contacts[t].ties_rotations;
      for (std::size_t k = 0; k < 4; ++k)
        if (tied.weight[k] != 0 && !(nodes.inertia[tied.corner[k]] > 0)) link.rotates = false;
      const std::string fault = fault_of(domain, owners, tied, link.rotates);
      if (!fault.empty())
        throw Error(tie.name() + ": " + name_of(model, nodes, tied.node) + fault +
                    "; a node has room for one constraint, as in LS-DYNA. Take it out of the contact, or tie "
                    "by penalty (_OFFSET).");
      links_.push_back(link);
      members_.push_back(tied.node);
      members_.insert(members_.end(), tied.corner.begin(), tied.corner.end());
    }
  }
  std::sort(members_.begin(), members_.end());
  members_.erase(std::unique(members_.begin(), members_.end()), members_.end());
  const auto place_of = [&](Index node) {
    return static_cast<Index>(std::lower_bound(members_.begin(), members_.end(), node) - members_.begin());
  };
  for (Link& link : links_) {
    link.node = place_of(link.node);
    for (Index& corner : link.corner) corner = place_of(corner);
  }
}

void TiedNodes::check_corners(const model::Model& model, const Domain& domain) const {
  const NodeOwners owners = owners_of_nodes(model);
  for (const Link& link : links_)
    for (std::size_t k = 0; k < 4; ++k) {
      const Index node = members_[link.corner[k]];
      const std::string& body = owners.body[domain.nodes.model_node[node]];
      if (link.weight[k] != 0 && !body.empty())
        throw Error(domain.ties[link.tie].name() + ": " + name_of(model, domain.nodes, members_[link.node]) +
                    " is tied to a segment with " + name_of(model, domain.nodes, node) + " of " + body +
                    "; rigid bodies cannot take part in a tie by constraint, as in LS-DYNA. Tie by penalty "
                    "(_OFFSET), or join the node to the body by *CONSTRAINED_EXTRA_NODES.");
    }
}

/// Levels, and the order by them: what a node carries must be known before it is passed on.
void TiedNodes::order_links(const model::Model& model, const Domain& domain) {
  tied_by_.assign(members_.size(), no_index);
  for (std::size_t i = 0; i < links_.size(); ++i) tied_by_[links_[i].node] = static_cast<Index>(i);
  constexpr Index most = 100;  // more can only be a circle
  for (bool changed = true; changed;) {
    changed = false;
    for (Link& link : links_)
      for (std::size_t k = 0; k < 4; ++k) {
        const Index under = tied_by_[link.corner[k]];
        if (link.weight[k] == 0 || under == no_index || link.level > links_[under].level) continue;
        link.level = links_[under].level + 1;
        changed = true;
        if (link.level > most)
          throw Error(domain.ties[link.tie].name() + ": " +
                      name_of(model, domain.nodes, members_[link.node]) +
                      " is tied to a segment whose nodes are, by way of others, tied to it in turn. Take one "
                      "of these contacts out.");
      }
  }
  std::stable_sort(links_.begin(), links_.end(),
                   [](const Link& a, const Link& b) { return a.level > b.level; });
  for (std::size_t i = 0; i < links_.size(); ++i) tied_by_[links_[i].node] = static_cast<Index>(i);
}

/// What every member carries; marks the tied ones.
void TiedNodes::share_masses(Domain& domain) {
  if (links_.empty()) return;
  NodeFields& nodes = domain.nodes;
  nodes.carried_mass.assign(static_cast<std::size_t>(nodes.count()), 0.0);
  nodes.carried_inertia.assign(static_cast<std::size_t>(nodes.count()), 0.0);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const Index node = members_[link.node];
    if (active_[i] == 0) {
      nodes.fixed[node] &= static_cast<std::uint8_t>(~domain::moved_by_tie);
      tied_by_[link.node] = no_index;
      continue;
    }
    nodes.fixed[node] |= domain::moved_by_tie;
    for (std::size_t k = 0; k < 4; ++k) {
      const Index corner = members_[link.corner[k]];
      nodes.carried_mass[corner] += link.weight[k] * nodes.moving_mass(node);
      if (link.rotates) nodes.carried_inertia[corner] += link.weight[k] * nodes.moving_inertia(node);
    }
  }
}

/// At time zero: the momenta by which the tied nodes move against their segments go to these.
void TiedNodes::share_velocities(Domain& domain) {
  NodeFields& nodes = domain.nodes;
  for (const Link& link : links_) {
    const Index node = members_[link.node];
    Vec3 velocity = nodes.velocity[node];
    Vec3 spin = nodes.angular_velocity[node];
    for (std::size_t k = 0; k < 4; ++k) {
      velocity -= link.weight[k] * nodes.velocity[members_[link.corner[k]]];
      spin -= link.weight[k] * nodes.angular_velocity[members_[link.corner[k]]];
    }
    momentum_[link.node] += nodes.moving_mass(node) * velocity;
    moment_[link.node] += nodes.moving_inertia(node) * spin;
    for (std::size_t k = 0; k < 4; ++k) {
      momentum_[link.corner[k]] += link.weight[k] * momentum_[link.node];
      if (link.rotates) moment_[link.corner[k]] += link.weight[k] * moment_[link.node];
    }
  }
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const Index node = members_[m];
    const unsigned fixed = nodes.fixed[node];
    const bool tied = tied_by_[m] != no_index;
    if (!tied && nodes.carried_mass[node] > 0)
      nodes.velocity[node] += held((1 / nodes.moving_mass(node)) * momentum_[m], fixed);
    const bool turned = tied && links_[tied_by_[m]].rotates;
    if (!turned && nodes.carried_inertia[node] > 0)
      nodes.angular_velocity[node] += held((1 / nodes.moving_inertia(node)) * moment_[m], fixed >> 3U);
  }
  copy_velocities(domain);
}

/// The weighted means, those of nodes that carry nothing last.
void TiedNodes::copy_velocities(Domain& domain) const {
  NodeFields& nodes = domain.nodes;
  for (std::size_t i = links_.size(); i-- > 0;) {
    const Link& link = links_[i];
    if (active_[i] == 0) continue;
    Vec3 velocity;
    Vec3 spin;
    for (std::size_t k = 0; k < 4; ++k) {
      velocity += link.weight[k] * nodes.velocity[members_[link.corner[k]]];
      spin += link.weight[k] * nodes.angular_velocity[members_[link.corner[k]]];
    }
    nodes.velocity[members_[link.node]] = velocity;
    if (link.rotates) nodes.angular_velocity[members_[link.node]] = spin;
  }
}

void TiedNodes::release(Domain& domain) {
  if (links_.empty()) return;
  const Index eroded = domain::eroded_elements(domain);
  const bool look = eroded != eroded_;
  eroded_ = eroded;
  domain::Tie* first = nullptr;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    if (active_[i] == 0) continue;
    if (domain.clock.time < death_time_[link.tie] &&
        !(look && domain::has_failed(domain, link.block, link.element)))
      continue;
    if (first == nullptr) {
      first = &domain.ties[link.tie];
      remember(domain);
      const KineticChange before = carried_energy(domain);
      first->energy += before.translational + before.rotational;
    }
    active_[i] = domain.ties[link.tie].holds[link.at] = 0;
    ++domain.ties[link.tie].released;
  }
  if (first == nullptr) return;
  share_masses(domain);
  const KineticChange after = carried_energy(domain);
  first->energy -= after.translational + after.rotational;
  first->dissipated = std::max(0.0, first->energy);
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
    const Link& link = links_[i];
    if (active_[i] == 0) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      momentum_[link.corner[k]] += link.weight[k] * momentum_[link.node];
      if (link.rotates) moment_[link.corner[k]] += link.weight[k] * moment_[link.node];
    }
  }
  KineticChange change;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const Index node = members_[m];
    const unsigned fixed = nodes.fixed[node];
    Vec3& velocity = nodes.velocity[node];
    Vec3& spin = nodes.angular_velocity[node];
    const bool carries = tied_by_[m] == no_index && nodes.carried_mass[node] > 0;
    if (carries) velocity = before_[m] + held((1 / nodes.moving_mass(node)) * momentum_[m], fixed);
    if (tied_by_[m] != no_index && links_[tied_by_[m]].rotates) {
      change.rotational -= 0.5 * nodes.inertia[node] * dot(spin_before_[m], spin);
    } else if (nodes.carried_inertia[node] > 0) {
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

void TiedNodes::follow(Domain& domain, double interval) {
  copy_velocities(domain);
  NodeFields& nodes = domain.nodes;
  for (domain::Tie& tie : domain.ties)
    if (tie.method == model::TieMethod::Constraint) tie.force = Vec3{};
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    if (active_[i] == 0) continue;
    const Index node = members_[link.node];
    const Vec3 change = nodes.velocity[node] - before_[link.node];
    domain.ties[link.tie].force += (1 / interval) * (nodes.moving_mass(node) * change - momentum_[link.node]);
  }
  if (!keep_acceleration_) return;
  for (std::size_t m = 0; m < members_.size(); ++m)
    nodes.acceleration[members_[m]] = (1 / interval) * (nodes.velocity[members_[m]] - before_[m]);
}

double TiedNodes::place_nodes(Domain& domain) const {
  NodeFields& nodes = domain.nodes;
  double largest = 0;
  for (std::size_t i = links_.size(); i-- > 0;) {
    const Link& link = links_[i];
    if (active_[i] == 0) continue;
    Vec3 position;
    for (std::size_t k = 0; k < 4; ++k) position += link.weight[k] * nodes.position[members_[link.corner[k]]];
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
