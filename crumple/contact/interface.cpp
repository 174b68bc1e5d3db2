// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "contact/edge_edge/edge_contact.hpp"
#include "contact/enforcement/forces.hpp"
#include "contact/enforcement/multipliers.hpp"
#include "contact/intersections.hpp"
#include "contact/node_segment/node_contact.hpp"
#include "contact/pinball/pinball_contact.hpp"
#include "contact/search/detector.hpp"
#include "contact/search/motion_limit.hpp"
#include "contact/surface/saved_state.hpp"
#include "contact/surface/sides.hpp"
#include "contact/surface/surface.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {

namespace {

using Detectors = std::vector<std::unique_ptr<Detector>>;

/// Pinballs see nodes and edges as they see everything.
Detectors detectors_of(const model::Model& model, const domain::Domain& domain, const model::Contact& contact,
                       const Surface& surface) {
  Detectors found;
  if (model.search.local == model::LocalSearchKind::Pinballs) {
    if (contact.enforcement == model::Enforcement::Multipliers)
      throw Error("Lagrange multipliers need --local-search inside-outside.");
    found.push_back(std::make_unique<PinballContact>(surface, model.search, present(domain)));
    return found;
  }
  auto nodes = std::make_unique<NodeContact>(surface, model.search, domain.execution.threads);
  auto edges = std::make_unique<EdgeContact>(model, domain, contact, surface, nodes->pairs());
  found.push_back(std::move(nodes));
  if (edges->exists()) found.push_back(std::move(edges));
  return found;
}

}  // namespace

struct Interface::Implementation {
  Implementation(const model::Model& model, const domain::Domain& domain, const model::Contact& settings,
                 Index place)
      : contact(settings),
        surface(build_surface(model, domain, settings)),
        detectors(detectors_of(model, domain, settings, surface)),
        forces(surface, settings, model.control),
        multipliers(surface, settings),
        step_scale(model.control.step_scale),
        report(place) {}

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

  /// The same by the stiffness that the touches need so that none gets too deep.
  void bound_step_by_depth(const domain::Domain& domain) {
    const double allowed = std::min(step_scale * domain.clock.element_limit, motion_step);
    depth_step = std::min(tolerances::bounded_step_growth * depth_step,
                          std::max(forces.longest_step(), tolerances::least_step_for_depth * allowed));
    if (depth_step >= allowed) depth_step = std::numeric_limits<double>::infinity();
  }

  double longest_step() const { return std::min(motion_step, depth_step); }

  /// Never more than the contact holds: where edges have taken over from nodes, both remember it.
  void book_eroded(double held, domain::ContactReport& entry) const {
    const double booked = std::min(held, std::max(0.0, entry.energy));
    entry.energy -= booked;
    entry.eroded_energy += booked;
  }

  void measure_start(domain::ContactReport& entry) {
    entry.initial_overlaps.clear();
    for (const auto& detector : detectors) detector->append_initial_overlaps(entry.initial_overlaps);
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

  /// Finds the contacts where the nodes are or will be.
  void find(domain::Domain& domain, const Kinematics& motion) {
    if (!acting(domain.clock.time)) {
      for (const auto& detector : detectors) detector->find_nothing();
      return;
    }
    domain::ContactReport& entry = domain.contacts[report];
    const bool start = started == 0;
    {
      const StageTimer timer(domain.times.contact_search, &entry.times.search);
      const bool changed = follow_erosion(surface, domain, contact.id);
      for (const auto& detector : detectors)
        book_eroded(detector->update(domain, motion, changed, start), entry);
      if (verify_cycles > 0 && domain.clock.cycle % verify_cycles == 0)
        for (const auto& detector : detectors) detector->verify(motion);
    }
    const StageTimer timer(domain.times.contact_local, &entry.times.local);
    for (const auto& detector : detectors) book_eroded(detector->find(domain, motion, start, entry), entry);
    if (start) measure_start(entry);
    if (start) measure_mass(domain.nodes, entry);
    started = 1;
  }

  /// Calls visit(detector, its touches) for all detectors in order.
  template <class Visit>
  void for_each_detector(const Visit& visit) {
    std::size_t first = 0;
    for (const auto& detector : detectors) {
      const auto count = static_cast<std::size_t>(detector->count());
      visit(*detector, std::span(touches).subspan(first, count));
      first += count;
    }
  }

  /// The contacts as the forces see them, with the stiffness that their nodes have in these positions.
  void collect_touches(const Kinematics& motion) {
    std::size_t count = 0;
    for (const auto& detector : detectors) count += static_cast<std::size_t>(detector->count());
    touches.resize(count);
    for_each_detector([&](Detector& detector, std::span<Touch> own) { detector.fill(motion, own); });
  }

  /// Takes over what the touches have become, for the next step and for what is reported of this one.
  void remember(const Kinematics& motion, domain::Domain& domain) {
    penetrations.clear();
    TouchNotes notes{domain.contacts[report], domain.clock.step, domain.clock.cycle, penetrations};
    for_each_detector(
        [&](Detector& detector, std::span<Touch> own) { detector.remember(motion, own, notes); });
    domain.contacts[report].stored_energy = stored_energy = notes.stored_energy;
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
    entry.method = detectors.front()->method();
    entry.segments = surface.segments();
    entry.thickness_cut = surface.thickness_cut;
    entry.two_sided = contact.kind != model::ContactKind::SingleSurface;
  }

  static void note_deepest(const Penetration& found, long cycle, domain::DeepestPenetration& deepest) {
    const double share = found.most > 0 ? found.depth / found.most : HUGE_VAL;
    if (share > deepest.share) deepest = {share, cycle, found.node, found.segment};
  }

  void write_report(domain::ContactReport& entry, long cycle) {
    describe(entry);
    entry.searches = 0;
    entry.candidates = 0;
    statistics.nodes_astray = 0;
    statistics.edges_astray = 0;
    for (const auto& detector : detectors) detector->report(entry, statistics);
    entry.active_pairs = static_cast<Index>(penetrations.size());
    entry.penetration = 0;
    for (const Penetration& found : penetrations) {
      entry.penetration = std::max(entry.penetration, found.depth);
      note_deepest(found, cycle, entry.deepest);
      if (found.depth <= entry.worst_penetration) continue;
      entry.worst_penetration = found.depth;
      entry.worst_node = found.node;
    }
    if (entry.two_sided) entry.force = force_on_first_side(surface, touches);
    statistics.limited_pairs = forces.limited();
    statistics.most_limited_pairs = std::max(statistics.most_limited_pairs, forces.limited());
  }

  model::Contact contact;
  Surface surface;
  Detectors detectors;  ///< at least one
  Forces forces;
  Multipliers multipliers;
  double step_scale;
  double motion_step = std::numeric_limits<double>::infinity();  ///< bound by fast motion [time]
  double depth_step = std::numeric_limits<double>::infinity();   ///< bound by deep touches [time]
  Index report;
  long verify_cycles = 0;
  double stored_energy = 0;    ///< by the penalties now [energy]
  std::int64_t started = 0;    ///< 1 once the penetrations at the start are known
  std::vector<Touch> touches;  ///< those of each detector in turn
  std::vector<Penetration> penetrations;
  ContactStatistics statistics;
};

Interface::Interface(const model::Model& model, const domain::Domain& domain, const model::Contact& contact,
                     Index report)
    : implementation_(std::make_unique<Implementation>(model, domain, contact, report)) {}
Interface::~Interface() = default;
Interface::Interface(Interface&&) noexcept = default;
Interface& Interface::operator=(Interface&&) noexcept = default;

void Interface::clear_forces(domain::Domain& domain) const {
  implementation_->forces.clear(domain);
}

void Interface::find_touches(domain::Domain& domain) {
  Implementation& own = *implementation_;
  own.bound_step(domain);
  if (own.contact.enforcement != model::Enforcement::Penalty) return;
  const Kinematics motion = present(domain);
  own.find(domain, motion);
  const StageTimer timer(domain.times.contact_forces, &domain.contacts[own.report].times.forces);
  own.collect_touches(motion);
  own.forces.count(domain, own.touches);
}

void Interface::evaluate_forces(domain::Domain& domain) {
  Implementation& own = *implementation_;
  if (own.contact.enforcement != model::Enforcement::Penalty) return;
  const StageTimer timer(domain.times.contact_forces, &domain.contacts[own.report].times.forces);
  own.forces.bound_step(domain, own.longest_step());
  own.forces.evaluate(domain, own.touches);
  own.bound_step_by_depth(domain);
}

void Interface::evaluate_forces_again(domain::Domain& domain, double next_step) {
  Implementation& own = *implementation_;
  if (own.contact.enforcement != model::Enforcement::Penalty) return;
  const StageTimer timer(domain.times.contact_forces, &domain.contacts[own.report].times.forces);
  own.collect_touches(present(domain));
  own.forces.bound_step(domain, next_step);
  own.forces.evaluate(domain, own.touches, next_step);
}

void Interface::add_forces(domain::Domain& domain) {
  Implementation& own = *implementation_;
  if (own.contact.enforcement != model::Enforcement::Penalty) return;
  domain::ContactReport& report = domain.contacts[own.report];
  const StageTimer timer(domain.times.contact_forces, &report.times.forces);
  own.forces.apply(domain, own.touches, report);
  own.remember(present(domain), domain);
  own.write_report(report, domain.clock.cycle);
}

void Interface::add_multipliers(domain::Domain& domain, double interval, double next_step) {
  Implementation& own = *implementation_;
  if (own.contact.enforcement != model::Enforcement::Multipliers) return;
  domain::ContactReport& report = domain.contacts[own.report];
  const Kinematics motion = own.multipliers.predict(domain, interval, next_step);
  own.find(domain, motion);
  const StageTimer timer(domain.times.contact_forces, &report.times.forces);
  own.collect_touches(motion);
  own.multipliers.solve(own.touches);
  own.forces.apply(domain, own.touches, report);
  own.for_each_detector([&](Detector& detector, std::span<Touch> left) { detector.correct(motion, left); });
  own.remember(motion, domain);
  own.write_report(report, domain.clock.cycle);
}

double Interface::longest_step() const {
  return implementation_->longest_step();
}

void Interface::describe(domain::ContactReport& report) const {
  implementation_->describe(report);
}

void Interface::declare(domain::StateList& list) {
  Implementation& own = *implementation_;
  list.add("contact_started", "-", domain::Entity::Contact, 1, std::span(&own.started, 1));
  for (const auto& detector : own.detectors) {
    detector->declare_search(list);
    if (detector == own.detectors.front()) own.forces.declare(list);
    detector->declare_pairs(list);
  }
  list.keep_list("contact_penetrations", "by item", domain::Entity::Contact, 1, own.penetrations);
  list.keep("contact_motion_step", "time", domain::Entity::Contact, own.motion_step);
  list.keep("contact_depth_step", "time", domain::Entity::Contact, own.depth_step);
  list.keep("contact_stored_energy", "energy", domain::Entity::Contact, own.stored_energy);
  list.keep("contact_statistics", "by item", domain::Entity::Contact, own.statistics);
}

void Interface::resume(const domain::Domain& domain) {
  Implementation& own = *implementation_;
  require_saved(own.started == 0 || own.started == 1, "marks of the start");
  own.forces.sums().resume();
  follow_erosion(own.surface, domain, own.contact.id);
  for (const auto& detector : own.detectors) detector->resume(domain, present(domain));
}

void Interface::verify_search_every(long cycles) {
  implementation_->verify_cycles = cycles;
}

void Interface::note_intersections(domain::Domain& domain) const {
  const Implementation& own = *implementation_;
  if (!own.acting(domain.clock.time)) return;
  note_worst(Intersections(own.surface, domain, CutDepth::Through), own.surface, domain.clock,
             domain.contacts[own.report].worst_intersections);
}

void Interface::inspect(domain::Domain& domain) const {
  const Implementation& own = *implementation_;
  const Intersections cut(own.surface, domain, CutDepth::Any);
  note_worst(cut, own.surface, domain.clock, domain.contacts[own.report].worst_intersections);
  const auto& named = cut.since_start.empty() ? cut.all : cut.since_start;
  const PenetrationSummary depth = summarise(own.penetrations);
  domain::ContactInspection& seen = domain.contacts[own.report].inspection;
  seen.made = true;
  seen.intersections = static_cast<Index>(cut.all.size());
  seen.initial_intersections = static_cast<Index>(cut.all.size() - cut.since_start.size());
  seen.first_segment = named.empty() ? 0 : own.surface.segment_id[named.front()[0]];
  seen.second_segment = named.empty() ? 0 : own.surface.segment_id[named.front()[1]];
  for (const auto& detector : own.detectors) detector->inspect(domain, seen);
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
  const NodalSums& sums = own.forces.sums();
  for (const Index place : sums.places())
    forces.push_back(
        {own.report, own.surface.nodes[place], own.surface.node_side[place], sums.force_at(place)});
}

const Surface& Interface::surface() const {
  return implementation_->surface;
}

}  // namespace crumple::contact
