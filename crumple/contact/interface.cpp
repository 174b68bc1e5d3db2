// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "contact/edge_edge/edge_contact.hpp"
#include "contact/enforcement/forces.hpp"
#include "contact/enforcement/multipliers.hpp"
#include "contact/enforcement/saved_pairs.hpp"
#include "contact/intersections.hpp"
#include "contact/node_segment/local_search.hpp"
#include "contact/node_segment/lost_nodes.hpp"
#include "contact/node_segment/ragged_nodes.hpp"
#include "contact/node_segment/solid_overlaps.hpp"
#include "contact/pinball/pinball_contact.hpp"
#include "contact/search/global_search.hpp"
#include "contact/search/motion_limit.hpp"
#include "contact/surface/sides.hpp"
#include "contact/surface/surface.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {

struct Interface::Implementation {
  Implementation(const model::Model& model, const domain::Domain& domain, const model::Contact& settings,
                 Index place)
      : contact(settings),
        surface(build_surface(model, domain, settings)),
        search(surface, model.search, domain.execution.threads),
        local(surface),
        edges(model, domain, edges_of(model, settings), surface),
        forces(surface, settings, model.control),
        multipliers(surface, settings),
        method(model.search.method),
        step_scale(model.control.step_scale),
        report(place),
        ragged(surface) {
    if (model.search.local != model::LocalSearchKind::Pinballs) return;
    if (contact.enforcement == model::Enforcement::Multipliers)
      throw Error("Lagrange multipliers need --local-search inside-outside.");
    pinballs.emplace(surface, model.search, present(domain));
    method = "pinballs";
  }

  /// Pinballs see edges as they see everything.
  static model::Contact edges_of(const model::Model& model, model::Contact settings) {
    if (model.search.local == model::LocalSearchKind::Pinballs) settings.edges = model::ContactEdges::None;
    return settings;
  }

  bool acting(double time) const { return time >= contact.birth_time && time <= contact.death_time; }

  /// Bounds the step by the motion of the surfaces. What has been bounded grows slowly: bodies stand still
  /// for a moment where they turn round, and a step that changed while they press on each other would make
  /// energy.
  void bound_step(const domain::Domain& domain) {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const double allowed = step_scale * domain.clock.element_limit;
    if (acting(domain.clock.time))
      motion_step = std::min(tolerances::bounded_step_growth * motion_step,
                             longest_step_for_motion(surface, domain, allowed));
    if (!acting(domain.clock.time) || motion_step >= allowed) motion_step = unlimited;
  }

  /// Forgets pairs whose segment or node has eroded, and books what their springs held as eroded.
  void drop_eroded(domain::Domain& domain) {
    double held = 0;
    std::erase_if(remembered, [&](const RememberedPair& pair) {
      const bool gone = surface.active[pair.segment] == 0 || !surface.bears(pair.node);
      if (gone) held += std::max(0.0, pair.penalty.energy);
      return gone;
    });
    book_eroded(held, domain);
  }

  /// Never more than the contact holds: where edges have taken over from nodes, both remember it.
  void book_eroded(double held, domain::Domain& domain) const {
    domain::ContactReport& entry = domain.contacts[report];
    const double booked = std::min(held, std::max(0.0, entry.energy));
    entry.energy -= booked;
    entry.eroded_energy += booked;
  }

  /// Nodes that start inside of solids, however deep: their contact begins where they are.
  void find_deep(const domain::Domain& domain, const Kinematics& motion) {
    const std::vector<NodeInSolid> inside = nodes_in_solids(surface, domain);
    deep = faces_over({&surface, {motion.position.data(), motion.velocity.data(), 0}}, inside);
    for (const DeepPair& pair : deep) search.reach_behind(pair.segment, pair.depth);
    inside_at_start.clear();
    for (const NodeInSolid& found : inside) inside_at_start.push_back(found.node);
  }

  void measure_start(std::span<const ContactPair> pairs, domain::ContactReport& entry) {
    entry.initial_overlaps.clear();
    for (const ContactPair& pair : pairs)
      if (pair.offset > 0)
        entry.initial_overlaps.push_back(
            {surface.node_id[pair.node], surface.segment_id[pair.segment], pair.offset});
    for (const EdgePair& pair : edges.present())
      if (pair.share > 0 && pair.offset > 0)
        entry.initial_overlaps.push_back(
            {edges.node_id(pair), edges.edges().id[pair.key.second], pair.offset});
    if (pinballs)
      for (const PinballPair& pair : pinballs->present())
        if (pair.initial_overlap > 0)
          entry.initial_overlaps.push_back(
              {pinballs->node_id(pair), surface.segment_id[pair.second], pair.initial_overlap});
    const auto deeper = [](const domain::InitialOverlap& a, const domain::InitialOverlap& b) {
      return a.depth > b.depth;
    };
    std::stable_sort(entry.initial_overlaps.begin(), entry.initial_overlaps.end(), deeper);
    statistics.initial_penetrations = static_cast<Index>(entry.initial_overlaps.size());
    if (entry.initial_overlaps.empty()) return;
    statistics.worst_initial = entry.initial_overlaps.front().depth;
    statistics.worst_initial_node = entry.initial_overlaps.front().node;
    statistics.worst_initial_segment = entry.initial_overlaps.front().element;
  }

  /// Takes over what the touches have become, for the next step and for what is told of this one. All that is
  /// in one pass: in a large model touches come from memory.
  void remember(std::span<const ContactPair> pairs, const Kinematics& motion, domain::Domain& domain) {
    const Configuration x{motion.position.data(), motion.velocity.data(), 0};
    remembered.clear();
    penetrations.clear();
    stored_energy = 0;
    some_are_behind = false;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const ContactPair& pair = pairs[i];
      const Touch& touch = touches[i];
      stored_energy += touch.stored_energy();
      RememberedPair memory;
      memory.node = pair.node;
      memory.segment = pair.segment;
      memory.side = pair.side;
      memory.wrong = pair.wrong;
      some_are_behind = some_are_behind || pair.wrong != 0;
      memory.let_go = pair.let_go;
      memory.weight = pair.weight;
      memory.offset = pair.offset;
      memory.gap = pair.gap;
      memory.depth = std::max(0.0, pair.penetration());
      if (dot(touch.friction, touch.friction) > 0) {
        const Frame& frame = pair.frame;
        memory.friction = (frame.is_known() ? frame : frame_of(shape_of(surface, x, pair.segment)))
                              .to_local(touch.friction);
      }
      memory.normal = pair.normal;
      memory.penalty = touch.penalty;
      remembered.push_back(memory);
      if (touch.withheld > 0) note_withheld(touch, surface.segment_id[pair.segment], domain);
      note_force(norm(touch.normal_force), pair, domain);
      if (pair.penetration() <= 0 || !pair.acts()) continue;
      const double height = surface.is_face(pair.segment) ? surface.height[pair.segment] : pair.reach;
      penetrations.push_back(
          {pair.penetration(), height, surface.node_id[pair.node], surface.segment_id[pair.segment]});
    }
    const std::span<const Touch> beyond_nodes = std::span(touches).subspan(pairs.size());
    for (std::size_t i = 0; i < beyond_nodes.size(); ++i) {
      stored_energy += beyond_nodes[i].stored_energy();
      if (beyond_nodes[i].withheld <= 0) continue;
      note_withheld(beyond_nodes[i], edges.edges().id[edges.present()[i].key.second], domain);
    }
    edges.remember(motion, beyond_nodes, pairs, penetrations);
    if (pinballs) pinballs->remember(motion, beyond_nodes.subspan(edges.present().size()), penetrations);
  }

  void note_force(double force, const ContactPair& pair, domain::Domain& domain) const {
    if (force == 0) return;
    domain::OverlapForces& found = domain.contacts[report].overlap_forces;
    found.impulse += domain.clock.step * force;
    if (pair.offset <= 0) return;
    found.overlap_impulse += domain.clock.step * force;
    if (force <= found.largest) return;
    found.largest = force;
    found.node = surface.node_id[pair.node];
  }

  void note_withheld(const Touch& touch, UserId segment, domain::Domain& domain) const {
    domain::WithheldForces& withheld = domain.contacts[report].withheld;
    ++withheld.count;
    if (touch.withheld <= withheld.largest) return;
    withheld.largest = touch.withheld;
    withheld.cycle = domain.clock.cycle;
    withheld.node = surface.node_id[touch.place[0]];
    withheld.segment = segment;
  }

  void verify(const Kinematics& motion) {
    if (pinballs) {
      pinballs->verify(motion);
      return;
    }
    search.verify(motion);
    edges.verify(motion);
  }

  /// The contacts where the nodes are or will be.
  std::span<ContactPair> find(domain::Domain& domain, const Kinematics& motion) {
    if (!acting(domain.clock.time)) {
      edges.find_nothing();
      if (pinballs) pinballs->find_nothing();
      return {};
    }
    {
      const StageTimer timer(domain.times.contact_search, &domain.contacts[report].times.search);
      const bool changed = follow_erosion(surface, domain);
      if (changed) ragged.follow();
      if (changed) drop_eroded(domain);
      if (pinballs) {
        pinballs->update(motion, changed);
      } else {
        if (started == 0) find_deep(domain, motion);
        search.update(motion, changed, remembered);
        book_eroded(edges.update(domain, motion, changed), domain);
      }
      if (verify_cycles > 0 && domain.clock.cycle % verify_cycles == 0) verify(motion);
    }
    const StageTimer timer(domain.times.contact_local, &domain.contacts[report].times.local);
    std::span<ContactPair> pairs;
    if (pinballs) {
      pinballs->find(motion, started == 0);
    } else {
      pairs = local.find(motion, search, remembered, started == 0, deep);
      if (some_are_behind)
        count_lost_nodes({&surface, {motion.position.data(), motion.velocity.data(), 0}}, remembered, pairs,
                         ragged, domain.clock.cycle, domain.contacts[report].lost);
      book_eroded(ragged.lost_energy(remembered, pairs, domain), domain);
      edges.find(motion, started == 0);
      edges.relieve(pairs);
    }
    if (started == 0) measure_start(pairs, domain.contacts[report]);
    if (started == 0) measure_mass(domain.nodes, domain.contacts[report]);
    started = 1;
    return pairs;
  }

  /// Takes over what is left of the penetrations, by which a node may be right on a surface and not behind
  /// it, and where it came to lie.
  void correct(std::span<ContactPair> pairs, const Kinematics& motion) const {
    const Configuration x{motion.position.data(), motion.velocity.data(), 0};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      ContactPair& pair = pairs[i];
      pair.gap = pair.reach - touches[i].penetration;
      const double size = std::max(pair.reach, surface.height[pair.segment]);
      if (pair.gap > -tolerances::on_surface * size) pair.wrong = 0;
      const Vec3& node = motion.position[surface.nodes[pair.node]];
      pair.weight = nearest_point(shape_of(surface, x, pair.segment), node).weight;
    }
  }

  /// The pairs as the forces see them, with the stiffness that their nodes have in these positions.
  void collect_touches(std::span<const ContactPair> pairs, const Kinematics& motion) {
    constexpr Index piece = 128;
    const Configuration x{motion.position.data(), nullptr, 0};
    const auto count = static_cast<Index>(pairs.size());
    touches.resize(pairs.size());
    parallel_for(pieces(count, piece), motion.threads, [&](Index part) {
      for (Index i = part * piece; i < std::min((part + 1) * piece, count); ++i) {
        ask_for_touch_after(surface, pairs, i);
        Touch& touch = touches[i];
        touch = touch_of(surface, pairs[i]);
        if (touch.penetration > 0)
          touch.stiffness =
              std::min(node_stiffness(surface, x, pairs[i]), surface.stiffness[pairs[i].segment]);
      }
    });
    edges.append_touches(touches);
    if (pinballs) pinballs->append_touches(touches);
  }

  void measure_mass(const domain::NodeFields& nodes, domain::ContactReport& entry) const {
    entry.mass = {};
    for (Index i = 0; i < surface.node_count(); ++i)
      for (std::size_t side = 0; side < entry.mass.size(); ++side)
        if ((surface.node_side[i] & (side == 0 ? first_side : second_side)) != 0)
          entry.mass[side] += nodes.mass[surface.nodes[i]];
  }

  void describe(domain::ContactReport& entry) const {
    entry.id = contact.id;
    entry.method = method;
    entry.segments = surface.segments();
    entry.two_sided = contact.kind != model::ContactKind::SingleSurface;
  }

  void describe_search(domain::SearchReport& entry) const {
    const SearchStatistics& done = search.statistics();
    const cellsearch::Statistics& last = search.details();
    entry.expansion = done.expansion;
    entry.node_visits = done.node_visits;
    entry.cell_visits = done.cell_visits;
    entry.participants = static_cast<long>(last.participants);
    entry.cells = static_cast<long>(last.cells);
    entry.bytes = static_cast<long>(last.bytes);
    entry.find_seconds = done.find_seconds;
  }

  void write_report(domain::ContactReport& entry) {
    describe(entry);
    entry.searches = search.statistics().searches + edges.search().searches();
    entry.candidates = search.statistics().candidates + edges.search().candidates();
    if (pinballs) {
      entry.searches += pinballs->searches();
      entry.candidates += pinballs->candidates();
    }
    describe_search(entry.search);
    entry.active_pairs = static_cast<Index>(penetrations.size());
    entry.penetration = 0;
    for (const Penetration& found : penetrations) {
      entry.penetration = std::max(entry.penetration, found.depth);
      if (found.depth <= entry.worst_penetration) continue;
      entry.worst_penetration = found.depth;
      entry.worst_node = found.node;
    }
    if (entry.two_sided) entry.force = force_on_first_side(surface, touches);
    statistics.search = search.statistics();
    statistics.limited_pairs = forces.limited();
    statistics.most_limited_pairs = std::max(statistics.most_limited_pairs, forces.limited());
    statistics.nodes_astray = 0;
    for (const RememberedPair& pair : remembered)
      if (!surface.is_face(pair.segment)) statistics.nodes_astray += pair.wrong;
    statistics.edges_astray = 0;
    for (const EdgePair& pair : edges.present()) statistics.edges_astray += pair.wrong;
  }

  model::Contact contact;
  Surface surface;
  GlobalSearch search;
  LocalSearch local;
  EdgeContact edges;
  std::optional<PinballContact> pinballs;  ///< if there are any, nodes and edges find nothing
  Forces forces;
  Multipliers multipliers;
  std::string method;
  double step_scale;
  double motion_step = std::numeric_limits<double>::infinity();  ///< bound by fast motion [time]
  Index report;
  long verify_cycles = 0;
  double stored_energy = 0;  ///< by the penalties now [energy]
  std::int64_t started = 0;  ///< 1 once the penetrations at the start are known
  RaggedNodes ragged;
  bool some_are_behind = false;          ///< nodes of `remembered`
  std::span<ContactPair> present_pairs;  ///< between the stages of a step
  std::vector<Touch> touches;
  std::vector<RememberedPair> remembered;
  std::vector<Penetration> penetrations;
  std::vector<DeepPair> deep;          ///< at the start, ascending
  std::vector<Index> inside_at_start;  ///< places of nodes in solids, ascending
  ContactStatistics statistics;
};

Interface::Interface(const model::Model& model, const domain::Domain& domain, const model::Contact& contact,
                     Index report)
    : implementation_(std::make_unique<Implementation>(model, domain, contact, report)) {}
Interface::~Interface() = default;
Interface::Interface(Interface&&) noexcept = default;
Interface& Interface::operator=(Interface&&) noexcept = default;

void Interface::find_touches(domain::Domain& domain) {
  Implementation& own = *implementation_;
  own.bound_step(domain);
  if (own.contact.enforcement != model::Enforcement::Penalty) return;
  const Kinematics motion = present(domain);
  own.present_pairs = own.find(domain, motion);
  const StageTimer timer(domain.times.contact_forces, &domain.contacts[own.report].times.forces);
  own.collect_touches(own.present_pairs, motion);
  own.forces.count(domain, own.touches);
}

void Interface::evaluate_forces(domain::Domain& domain) {
  Implementation& own = *implementation_;
  if (own.contact.enforcement != model::Enforcement::Penalty) return;
  const StageTimer timer(domain.times.contact_forces, &domain.contacts[own.report].times.forces);
  own.forces.bound_step(domain, own.motion_step);
  own.forces.evaluate(domain, own.touches);
}

void Interface::add_forces(domain::Domain& domain) {
  Implementation& own = *implementation_;
  if (own.contact.enforcement != model::Enforcement::Penalty) return;
  domain::ContactReport& report = domain.contacts[own.report];
  const StageTimer timer(domain.times.contact_forces, &report.times.forces);
  own.forces.apply(domain, own.touches, report);
  own.remember(own.present_pairs, present(domain), domain);
  own.write_report(report);
}

void Interface::add_multipliers(domain::Domain& domain, double interval, double next_step) {
  Implementation& own = *implementation_;
  if (own.contact.enforcement != model::Enforcement::Multipliers) return;
  domain::ContactReport& report = domain.contacts[own.report];
  const Kinematics motion = own.multipliers.predict(domain, interval, next_step);
  const std::span<ContactPair> pairs = own.find(domain, motion);
  const StageTimer timer(domain.times.contact_forces, &report.times.forces);
  own.collect_touches(pairs, motion);
  own.multipliers.solve(own.touches);
  own.forces.apply(domain, own.touches, report);
  own.correct(pairs, motion);
  own.remember(pairs, motion, domain);
  own.write_report(report);
}

double Interface::longest_step() const {
  return implementation_->motion_step;
}

void Interface::describe(domain::ContactReport& report) const {
  implementation_->describe(report);
}

void Interface::declare(domain::StateList& list) {
  Implementation& own = *implementation_;
  list.add("contact_started", "-", domain::Entity::Contact, 1, std::span(&own.started, 1));
  own.search.declare(list);
  own.forces.declare(list);
  list.add_list("contact_pairs", "by item", domain::Entity::Contact, 1, own.remembered);
  list.keep_list("contact_penetrations", "by item", domain::Entity::Contact, 1, own.penetrations);
  own.ragged.declare(list);
  list.keep_list("contact_inside_at_start", "-", domain::Entity::Contact, 1, own.inside_at_start);
  list.keep("contact_motion_step", "time", domain::Entity::Contact, own.motion_step);
  list.keep("contact_stored_energy", "energy", domain::Entity::Contact, own.stored_energy);
  list.keep("contact_statistics", "by item", domain::Entity::Contact, own.statistics);
  own.edges.declare(list);
  if (own.pinballs) own.pinballs->declare(list);
}

void Interface::resume(const domain::Domain& domain) {
  Implementation& own = *implementation_;
  require_saved_pairs(own.remembered, own.inside_at_start, own.surface);
  own.forces.resume();
  if (own.started == 0) return;
  const Kinematics motion = present(domain);
  follow_erosion(own.surface, domain);
  own.ragged.resume();
  own.some_are_behind = std::ranges::any_of(own.remembered, [](const auto& pair) { return pair.wrong != 0; });
  if (own.pinballs) {
    own.pinballs->resume(motion);
    return;
  }
  own.search.resume(motion);
  own.edges.resume(domain, motion);
}

void Interface::verify_search_every(long cycles) {
  implementation_->verify_cycles = cycles;
}

void Interface::inspect(domain::Domain& domain) const {
  const Implementation& own = *implementation_;
  const auto cut = intersecting_segments(own.surface, domain.nodes.position, domain.execution.threads);
  const PenetrationSummary depth = summarise(own.penetrations);
  domain::ContactInspection& seen = domain.contacts[own.report].inspection;
  seen.made = true;
  seen.intersections = static_cast<Index>(cut.size());
  seen.first_segment = cut.empty() ? 0 : own.surface.segment_id[cut.front()[0]];
  seen.second_segment = cut.empty() ? 0 : own.surface.segment_id[cut.front()[1]];
  if (!own.pinballs) inspect_solids(own.surface, domain, own.remembered, own.inside_at_start, seen);
  seen.nodes_beyond = depth.beyond;
  seen.largest_depth = depth.largest;
  seen.percentile_99 = depth.percentile_99;
}

const ContactStatistics& Interface::statistics() const {
  return implementation_->statistics;
}

std::span<const Penetration> Interface::penetrations() const {
  return implementation_->penetrations;
}

std::span<const Touch> Interface::touches() const {
  return implementation_->touches;
}

double Interface::stored_energy() const {
  return implementation_->stored_energy;
}

void Interface::append_node_forces(std::vector<domain::ContactNodeForce>& forces) const {
  const Implementation& own = *implementation_;
  for (const Index place : own.forces.places())
    forces.push_back(
        {own.report, own.surface.nodes[place], own.surface.node_side[place], own.forces.force_at(place)});
}

const Surface& Interface::surface() const {
  return implementation_->surface;
}

}  // namespace crumple::contact
