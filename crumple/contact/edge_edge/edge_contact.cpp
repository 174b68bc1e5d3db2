// SPDX-License-Identifier: BSD-3-Clause
#include "contact/edge_edge/edge_contact.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "contact/edge_edge/edge_pair_search.hpp"
#include "contact/surface/saved_state.hpp"

namespace crumple::contact {
namespace {

/// True if the contact point of a node lies on edge k of its segment, ends included.
bool on_edge(const Surface& surface, const ContactPair& pair, int k) {
  // The third node of a triangle is its fourth as well.
  const bool triangle = surface.is_triangle(pair.segment);
  const int next = triangle && k == 3 ? 0 : (k + 1) % 4;
  const int start = triangle && k == 3 ? 2 : k;
  for (int corner = 0; corner < 4; ++corner)
    if (pair.weight[corner] != 0 && corner != start && corner != next) return false;
  return true;
}

/// Calls visit(edge) for the edges on which the contact point of a node lies.
template <class Visit>
void for_each_edge(const Surface& surface, const Edges& edges, const ContactPair& pair, const Visit& visit) {
  const std::array<Index, 4>& around = edges.of_segment[pair.segment];
  for (int k = 0; k < 4; ++k)
    if (around[k] != no_index && on_edge(surface, pair, k)) visit(around[k]);
}

}  // namespace

EdgeContact::EdgeContact(const model::Model& model, const domain::Domain& domain,
                         const model::Contact& contact, const Surface& surface,
                         const std::span<ContactPair>& nodes)
    : surface_(&surface),
      nodes_(&nodes),
      edges_(build_edges(model, domain, contact, surface)),
      search_(edges_, surface, model.search, domain.execution.threads),
      local_(edges_, surface) {}

double EdgeContact::update(const domain::Domain& domain, const Kinematics& motion, bool surface_changed,
                           bool /*start*/) {
  double held = 0;
  Index eroded = 0;
  for (const domain::BeamBlock& block : domain.beams) eroded += block.eroded;
  const bool changed = surface_changed || eroded != eroded_beams_;
  eroded_beams_ = eroded;
  if (changed) {
    refresh(edges_, *surface_, domain);
    std::erase_if(remembered_, [&](const RememberedEdgePair& pair) {
      const bool gone = edges_.active[pair.key.first] == 0 || edges_.active[pair.key.second] == 0;
      if (gone) held += std::max(0.0, pair.penalty.energy);
      return gone;
    });
  }
  search_.update(motion, changed);
  return held;
}

double EdgeContact::find(const domain::Domain& domain, const Kinematics& motion, bool start,
                         domain::ContactReport& report) {
  pairs_ = local_.find(motion, search_, remembered_, node_depths_, start);
  if (!start) local_.count_lost(motion, search_, remembered_, domain.clock.cycle, report.lost_edges);
  relieve_nodes();
  return 0;
}

/// Takes from nodes the share of those contacts that crossing edges have.
void EdgeContact::relieve_nodes() const {
  if (pairs_.empty()) return;
  const std::vector<NodeOnEdge> found = reliefs(edges_, pairs_);
  if (found.empty()) return;
  for (ContactPair& pair : *nodes_)
    for_each_edge(*surface_, edges_, pair,
                  [&](Index edge) { pair.fade *= share_left(found, surface_->nodes[pair.node], edge); });
}

/// Of the higher one of the two solids that the edges belong to; 0 for edges of shells and beams [length].
double EdgeContact::height_of(const EdgePair& pair) const {
  return std::max(edges_.height[pair.key.first], edges_.height[pair.key.second]);
}

Touch EdgeContact::touch_of(const EdgePair& pair) const {
  Touch touch;
  for (int i = 0; i < 2; ++i) {
    const double sign = i == 0 ? 1 : -1;
    const EdgeNodes ends = edges_.ends(i == 0 ? pair.key.first : pair.key.second);
    const double fraction = pair.fraction[i];
    if (fraction < 1) touch.add(surface_->place[ends[0]], sign * (1 - fraction));
    if (fraction > 0) touch.add(surface_->place[ends[1]], sign * fraction);
  }
  touch.normal = pair.normal;
  touch.penetration = pair.share > 0 ? pair.penetration() : 0;
  // Between edges of solids there is no mid-surface that a strong squeeze would reach.
  touch.reach = edges_.contact_distance(pair.key.first, pair.key.second) > 0
                    ? pair.reach
                    : std::numeric_limits<double>::max();
  touch.most = std::max(pair.reach, 0.0) + 0.5 * edges_.contact_distance(pair.key.first, pair.key.second) +
               tolerances::deepest_in_solid * height_of(pair);
  touch.stiffness = std::min(edges_.stiffness[pair.key.first], edges_.stiffness[pair.key.second]);
  touch.area = std::min(edges_.area[pair.key.first], edges_.area[pair.key.second]);
  touch.part = {edges_.part[pair.key.first], edges_.part[pair.key.second]};
  touch.fade = pair.share;
  touch.starts_loaded = pair.starts_loaded;
  touch.slip = pair.slip;
  touch.friction = pair.friction;
  touch.penalty = pair.penalty;
  touch.last_speed = pair.last_speed;
  return touch;
}

void EdgeContact::fill(const Kinematics& /*motion*/, std::span<Touch> touches) const {
  std::ranges::transform(pairs_, touches.begin(), [&](const EdgePair& pair) { return touch_of(pair); });
}

/// Id of a node of the first edge where a contact is.
UserId EdgeContact::node_id(const EdgePair& pair) const {
  const EdgeNodes ends = edges_.ends(pair.key.first);
  return surface_->node_id[surface_->place[ends[pair.fraction[0] <= 0.5 ? 0 : 1]]];
}

void EdgeContact::remember(const Kinematics& motion, std::span<const Touch> touches, TouchNotes& notes) {
  const Configuration x{motion.position.data(), motion.velocity.data(), 0};
  remembered_.clear();
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const EdgePair& pair = pairs_[i];
    const UserId segment = edges_.id[pair.key.second];
    notes.stored_energy += touches[i].stored_energy();
    if (touches[i].withheld > 0)
      notes.note_withheld(touches[i], surface_->node_id[touches[i].place[0]], segment);
    RememberedEdgePair memory;
    memory.key = pair.key;
    memory.wrong = pair.wrong;
    memory.fraction = pair.fraction;
    memory.offset = pair.offset;
    memory.depth = pair.share > 0 ? std::max(0.0, pair.penetration()) : 0;
    memory.share = pair.share;
    memory.normal = pair.normal;
    memory.side = pair.side;
    memory.penalty = touches[i].penalty;
    const Vec3& friction = touches[i].friction;
    if (dot(friction, friction) > 0)
      memory.friction = frame_of(edge_shape(edges_.ends(pair.key.first), x),
                                 edge_shape(edges_.ends(pair.key.second), x), pair.normal)
                            .to_local(friction);
    remembered_.push_back(memory);
    if (pair.penetration() > 0 && pair.share > 0)
      notes.penetrations.push_back({pair.penetration(), std::max(pair.reach, height_of(pair)), node_id(pair),
                                    segment, touches[i].most});
  }
  remember_nodes();
}

/// How deep nodes are at edges: what edges that take over from them may begin with.
void EdgeContact::remember_nodes() {
  node_depths_.clear();
  for (const ContactPair& pair : *nodes_) {
    if (!pair.acts() || pair.penetration() <= 0) continue;
    for_each_edge(*surface_, edges_, pair, [&](Index edge) {
      node_depths_.push_back({surface_->nodes[pair.node], edge, pair.penetration()});
    });
  }
  std::sort(node_depths_.begin(), node_depths_.end());
}

void EdgeContact::append_initial_overlaps(std::vector<domain::InitialOverlap>& overlaps) const {
  for (const EdgePair& pair : pairs_)
    if (pair.share > 0 && pair.offset > 0)
      overlaps.push_back({node_id(pair), edges_.id[pair.key.second], pair.offset});
}

void EdgeContact::report(domain::ContactReport& report, ContactStatistics& statistics) const {
  report.searches += search_.searches();
  report.candidates += search_.candidates();
  for (const EdgePair& pair : pairs_) statistics.edges_astray += pair.wrong;
}

void EdgeContact::declare_pairs(domain::StateList& list) {
  list.add_list("contact_edge_pairs", "by item", domain::Entity::Contact, 1, remembered_);
  list.add_list("contact_edge_node_depths", "by item", domain::Entity::Contact, 1, node_depths_);
  list.keep("contact_eroded_beams", "-", domain::Entity::Contact, eroded_beams_);
}

void EdgeContact::resume(const domain::Domain& domain, const Kinematics& motion) {
  const auto edges = static_cast<std::size_t>(edges_.count());
  const auto fits = [&](const RememberedEdgePair& pair) {
    return is_one_of(pair.key.first, edges) && is_one_of(pair.key.second, edges) &&
           pair.key.meeting >= EdgeMeeting::Crossing && pair.key.meeting <= EdgeMeeting::SecondEnd &&
           (pair.wrong == 0 || pair.wrong == 1);
  };
  require_all_saved(remembered_, fits, "pairs of edges");
  const auto unordered = [](const RememberedEdgePair& a, const RememberedEdgePair& b) {
    return b.key < a.key;
  };
  require_saved(std::ranges::adjacent_find(remembered_, unordered) == remembered_.end(), "pairs of edges");
  require_saved(std::is_sorted(node_depths_.begin(), node_depths_.end()), "nodes on edges");
  refresh(edges_, *surface_, domain);
  search_.resume(motion);
}

}  // namespace crumple::contact
