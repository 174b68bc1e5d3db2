// SPDX-License-Identifier: BSD-3-Clause
#include "contact/node_segment/node_contact.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "contact/node_segment/lost_nodes.hpp"
#include "contact/surface/saved_state.hpp"
#include "contact/surface/segment_shape.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

Configuration configuration_of(const Kinematics& motion) {
  return {motion.position.data(), motion.velocity.data(), 0};
}

void set_stiffness(const Surface& surface, const Configuration& x, const ContactPair& pair, Touch& touch) {
  const double of_node = node_stiffness(surface, x, pair);
  const std::span<const Index> own = surface.topology.at_node(pair.node);
  touch.stiffness = surface.stiffness[pair.segment];
  if (!own.empty() && surface.of_solid[own.front()] != 0)
    touch.turning_stiffness = of_node;
  else
    touch.stiffness = std::min(of_node, touch.stiffness);
}

}  // namespace

NodeContact::NodeContact(const Surface& surface, const model::SearchSettings& settings, int threads)
    : surface_(&surface),
      method_(settings.method),
      search_(surface, settings, threads),
      local_(surface),
      ragged_(surface) {}

double NodeContact::update(const domain::Domain& domain, const Kinematics& motion, bool surface_changed,
                           bool start) {
  double held = 0;
  if (surface_changed) {
    ragged_.follow();
    held = drop_eroded();
  }
  if (start) find_deep(domain, motion);
  search_.update(motion, surface_changed, remembered_);
  return held;
}

/// Forgets pairs whose segment or node has eroded; returns what their springs held [energy].
double NodeContact::drop_eroded() {
  double held = 0;
  std::erase_if(remembered_, [&](const RememberedPair& pair) {
    const bool gone = surface_->active[pair.segment] == 0 || !surface_->bears(pair.node);
    if (gone) held += std::max(0.0, pair.penalty.energy);
    return gone;
  });
  return held;
}

/// Nodes that start inside of solids, however deep: their contact begins where they are.
void NodeContact::find_deep(const domain::Domain& domain, const Kinematics& motion) {
  const std::vector<NodeInSolid> inside = nodes_in_solids(*surface_, domain);
  deep_ = faces_over({surface_, configuration_of(motion)}, inside);
  for (const DeepPair& pair : deep_) search_.reach_behind(pair.segment, pair.depth);
  inside_at_start_.clear();
  for (const NodeInSolid& found : inside) inside_at_start_.push_back(found.node);
}

double NodeContact::find(const domain::Domain& domain, const Kinematics& motion, bool start,
                         domain::ContactReport& report) {
  pairs_ = local_.find(motion, search_, remembered_, start, deep_);
  if (some_are_behind_)
    count_lost_nodes({surface_, configuration_of(motion)}, remembered_, pairs_, ragged_, domain.clock.cycle,
                     report.lost_nodes);
  return ragged_.lost_energy(remembered_, pairs_, domain);
}

void NodeContact::fill(const Kinematics& motion, std::span<Touch> touches) const {
  constexpr Index piece = 128;
  const Configuration x{motion.position.data(), nullptr, 0};
  parallel_for(pieces(count(), piece), motion.threads, [&](Index part) {
    for (Index i = part * piece; i < std::min((part + 1) * piece, count()); ++i) {
      prefetch_touch_after(*surface_, pairs_, i);
      Touch& touch = touches[i];
      touch = touch_of(*surface_, pairs_[i]);
      if (touch.penetration > 0) set_stiffness(*surface_, x, pairs_[i], touch);
    }
  });
}

/// What is left of the penetrations, by which a node may be right on a surface and not behind it.
void NodeContact::correct(const Kinematics& motion, std::span<const Touch> touches) {
  const Configuration x = configuration_of(motion);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    ContactPair& pair = pairs_[i];
    pair.gap = pair.reach - touches[i].penetration;
    const double size = std::max(pair.reach, surface_->height[pair.segment]);
    if (pair.gap > -tolerances::on_surface * size) pair.wrong = 0;
    const Vec3& node = motion.position[surface_->nodes[pair.node]];
    pair.weight = nearest_point(shape_of(*surface_, x, pair.segment), node).weight;
  }
}

RememberedPair NodeContact::memory_of(const ContactPair& pair, const Touch& touch,
                                      const Configuration& x) const {
  RememberedPair memory;
  memory.node = pair.node;
  memory.segment = pair.segment;
  memory.side = pair.side;
  memory.wrong = pair.wrong;
  memory.let_go = pair.let_go;
  memory.weight = pair.weight;
  memory.offset = pair.offset;
  memory.gap = pair.gap;
  memory.depth = std::max(0.0, pair.penetration());
  if (dot(touch.friction, touch.friction) > 0) {
    const Frame& frame = pair.frame;
    memory.friction =
        (frame.is_known() ? frame : frame_of(shape_of(*surface_, x, pair.segment))).to_local(touch.friction);
  }
  memory.normal = pair.normal;
  memory.penalty = touch.penalty;
  return memory;
}

void NodeContact::remember(const Kinematics& motion, std::span<const Touch> touches, TouchNotes& notes) {
  const Configuration x = configuration_of(motion);
  remembered_.clear();
  some_are_behind_ = false;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const ContactPair& pair = pairs_[i];
    const Touch& touch = touches[i];
    notes.stored_energy += touch.stored_energy();
    some_are_behind_ = some_are_behind_ || pair.wrong != 0;
    remembered_.push_back(memory_of(pair, touch, x));
    const UserId node = surface_->node_id[pair.node];
    const UserId segment = surface_->segment_id[pair.segment];
    if (touch.withheld > 0) notes.note_withheld(touch, node, segment);
    notes.note_force(touch, node, pair.offset);
    if (pair.penetration() <= 0 || !pair.acts()) continue;
    const double height = surface_->is_face(pair.segment) ? surface_->height[pair.segment] : pair.reach;
    notes.penetrations.push_back({pair.penetration(), height, node, segment, touch.most});
  }
}

void NodeContact::append_initial_overlaps(std::vector<domain::InitialOverlap>& overlaps) const {
  for (const ContactPair& pair : pairs_)
    if (pair.offset > 0)
      overlaps.push_back({surface_->node_id[pair.node], surface_->segment_id[pair.segment], pair.offset});
}

void NodeContact::report(domain::ContactReport& report, ContactStatistics& statistics) const {
  const SearchStatistics& done = search_.statistics();
  const cellsearch::Statistics& last = search_.details();
  report.searches += done.searches;
  report.candidates += done.candidates;
  report.search.expansion = done.expansion;
  report.search.node_visits = done.node_visits;
  report.search.cell_visits = done.cell_visits;
  report.search.participants = static_cast<long>(last.participants);
  report.search.cells = static_cast<long>(last.cells);
  report.search.bytes = static_cast<long>(last.bytes);
  report.search.find_seconds = done.find_seconds;
  statistics.search = done;
  for (const RememberedPair& pair : remembered_)
    if (!surface_->is_face(pair.segment)) statistics.nodes_astray += pair.wrong;
}

void NodeContact::inspect(const domain::Domain& domain, domain::ContactInspection& seen) const {
  inspect_solids(*surface_, domain, remembered_, inside_at_start_, seen);
}

void NodeContact::declare_pairs(domain::StateList& list) {
  list.add_list("contact_pairs", "by item", domain::Entity::Contact, 1, remembered_);
  ragged_.declare(list);
  list.keep_list("contact_inside_at_start", "-", domain::Entity::Contact, 1, inside_at_start_);
}

void NodeContact::resume(const domain::Domain& /*domain*/, const Kinematics& motion) {
  const std::size_t nodes = surface_->nodes.size();
  const auto fits = [&](const RememberedPair& pair) {
    return is_one_of(pair.node, nodes) && is_one_of(pair.segment, surface_->segment_id.size()) &&
           pair.side >= -1 && pair.side <= 1 && (pair.wrong == 0 || pair.wrong == 1) &&
           (pair.let_go == 0 || pair.let_go == 1);
  };
  require_all_saved(remembered_, fits, "pairs of nodes and segments");
  const auto unordered = [](const RememberedPair& a, const RememberedPair& b) { return a.node > b.node; };
  require_saved(std::ranges::adjacent_find(remembered_, unordered) == remembered_.end(),
                "pairs of nodes and segments");
  const auto is_node = [&](Index place) { return is_one_of(place, nodes); };
  require_all_saved(inside_at_start_, is_node, "nodes in solids");
  ragged_.resume();
  some_are_behind_ = std::ranges::any_of(remembered_, [](const auto& pair) { return pair.wrong != 0; });
  search_.resume(motion);
}

}  // namespace crumple::contact
