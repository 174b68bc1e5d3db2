// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/supports.hpp"

namespace crumple::timeloop {
namespace {

using domain::SupportReport;
using math::Vec3;

bool holds_translation(const domain::NodeFields& nodes, Index node, int axis) {
  return (nodes.fixed[node] & domain::fixed_translation(axis)) != 0;
}

bool holds_rotation(const domain::NodeFields& nodes, Index node, int axis) {
  return (nodes.fixed[node] & domain::fixed_rotation(axis)) != 0;
}

/// Takes from a support what acts on its node along and about the axes that it holds.
void resist(SupportReport& support, const domain::NodeFields& nodes, const Vec3& force, const Vec3& moment) {
  for (int axis = 0; axis < 3; ++axis) {
    if (holds_translation(nodes, support.node, axis)) support.force[axis] -= force[axis];
    if (holds_rotation(nodes, support.node, axis)) support.moment[axis] -= moment[axis];
  }
}

}  // namespace

Supports::Supports(const model::Model& model, domain::Domain& domain) {
  if (!model.output.of(model::HistoryFile::Spcforc).asked) return;
  const std::vector<Index>& domain_node = domain.nodes.domain_node;
  for (const model::FixedNode& fixed : model.fixed_nodes)
    domain.supports.push_back({.node = domain_node[fixed.node]});
  const bool none = domain.supports.empty() && model.local_supports.empty();
  if (none || (model.constrained_node_sets.empty() && model.local_supports.empty())) return;
  support_of_node_.assign(domain_node.size(), no_index);
  for (std::size_t i = 0; i < domain.supports.size(); ++i)
    support_of_node_[domain.supports[i].node] = static_cast<Index>(i);
  for (const model::LocalSupport& support : model.local_supports) {
    Index& place = support_of_node_[domain_node[support.node]];
    if (place != no_index) continue;
    place = static_cast<Index>(domain.supports.size());
    domain.supports.push_back({.node = domain_node[support.node]});
  }
  if (domain.supports.empty()) return;
  for (const model::ConstrainedNodeSet& given : model.constrained_node_sets) {
    Set& set = sets_.emplace_back();
    set.direction = given.direction;
    set.failure_time = given.failure_time;
    for (const Index node : given.nodes) set.nodes.push_back(domain_node[node]);
  }
}

void Supports::measure(domain::Domain& domain) const {
  const domain::NodeFields& nodes = domain.nodes;
  for (SupportReport& support : domain.supports) {
    const domain::NodeForce& sum = nodes.force[support.node];
    support.force = support.moment = {};
    resist(support, nodes, {sum.force[0], sum.force[1], sum.force[2]},
           {sum.moment[0], sum.moment[1], sum.moment[2]});
  }
  add_sets(domain);
}

void Supports::add_sets(domain::Domain& domain) const {
  const domain::NodeFields& nodes = domain.nodes;
  for (const Set& set : sets_)
    for (int axis = 0; axis < 3; ++axis) {
      if (!set.direction[static_cast<std::size_t>(axis)] || domain.clock.time >= set.failure_time) continue;
      double force = 0;
      double supports = 0;
      for (const Index node : set.nodes)
        if (holds_translation(nodes, node, axis))
          supports += 1;
        else
          force += nodes.force[node].force[axis];
      for (const Index node : set.nodes)
        if (holds_translation(nodes, node, axis))
          domain.supports[support_of_node_[node]].force[axis] -= force / supports;
    }
}

void Supports::add_ties(domain::Domain& domain, const constraints::TiedNodes& ties, double interval) const {
  if (ties.empty() || !(interval > 0)) return;
  for (SupportReport& support : domain.supports) {
    const constraints::TiedNodes::Share share = ties.share_of(support.node);
    resist(support, domain.nodes, (1 / interval) * share.momentum, (1 / interval) * share.moment);
  }
}

void Supports::add_local(domain::Domain& domain, const constraints::LocalConstraints& constraints) const {
  if (support_of_node_.empty()) return;
  for (const constraints::LocalConstraints::Reaction& reaction : constraints.reactions()) {
    const Index place = support_of_node_[reaction.node];
    if (place == no_index) continue;
    domain.supports[place].force += reaction.force;
    domain.supports[place].moment += reaction.moment;
  }
}

}  // namespace crumple::timeloop
