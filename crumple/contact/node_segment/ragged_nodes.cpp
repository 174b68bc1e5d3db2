// SPDX-License-Identifier: BSD-3-Clause
#include "contact/node_segment/ragged_nodes.hpp"

#include <algorithm>

#include "contact/surface/saved_state.hpp"

namespace crumple::contact {

void RaggedNodes::follow() {
  marked_.resize(surface_->nodes.size());
  for (Index s = 0; s < surface_->segments(); ++s)
    if (surface_->active[s] != active_before_[s])
      for (int k = 0; k < 4; ++k) marked_[surface_->place[surface_->segment(s)[k]]] = 1;
  active_before_ = surface_->active;
}

bool RaggedNodes::has(const RememberedPair& pair) const {
  if (marked_.empty()) return false;
  const Index* nodes = surface_->segment(pair.segment);
  return marked_[pair.node] != 0 ||
         std::any_of(nodes, nodes + 4, [&](Index node) { return marked_[surface_->place[node]] != 0; });
}

double RaggedNodes::lost_energy(std::span<const RememberedPair> remembered,
                                std::span<const ContactPair> pairs, const domain::Domain& domain) const {
  double held = 0;
  if (marked_.empty()) return held;
  auto at = pairs.begin();
  for (const RememberedPair& memory : remembered) {
    while (at != pairs.end() && at->node < memory.node) ++at;
    if (memory.penalty.energy <= 0 || !has(memory)) continue;
    bool goes_on = false;
    for (auto pair = at; pair != pairs.end() && pair->node == memory.node; ++pair)
      goes_on = goes_on || (pair->heir_of == memory.segment && pair->penetration() > 0);
    if (goes_on) continue;
    Vec3 relative = domain.nodes.velocity[surface_->nodes[memory.node]];
    for (int k = 0; k < 4; ++k)
      relative -= memory.weight[k] * domain.nodes.velocity[surface_->segment(memory.segment)[k]];
    const double returned = 0.5 * domain.clock.step * memory.penalty.force * dot(relative, memory.normal);
    held += std::max(0.0, memory.penalty.energy - returned);
  }
  return held;
}

void RaggedNodes::declare(domain::StateList& list) {
  list.keep_list("contact_ragged", "-", domain::Entity::Contact, 1, marked_);
}

void RaggedNodes::resume() {
  require_saved(marked_.empty() || marked_.size() == surface_->nodes.size(), "nodes at eroded segments");
  active_before_ = surface_->active;
}

}  // namespace crumple::contact
