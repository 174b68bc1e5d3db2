// SPDX-License-Identifier: BSD-3-Clause
#include "contact/single_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "base/stopwatch.hpp"
#include "contact/forces.hpp"
#include "contact/global_search.hpp"
#include "contact/intersections.hpp"
#include "contact/local_search.hpp"
#include "contact/surface.hpp"

namespace crumple::contact {

struct SingleSurface::Implementation {
  Implementation(const model::Model& model, const domain::Domain& domain,
                 const model::SingleSurfaceContact& settings, Index place)
      : contact(settings),
        surface(build_surface(model, domain, settings)),
        search(surface, model.search, domain.execution.threads),
        local(surface),
        forces(surface, settings, model.control.step_scale),
        method(model.search.method),
        report(place) {}

  bool acting(double time) const { return time >= contact.birth_time && time <= contact.death_time; }

  void measure_start(std::span<const ContactPair> pairs) {
    for (const ContactPair& pair : pairs) {
      if (pair.offset <= 0) continue;
      ++statistics.initial_penetrations;
      if (pair.offset <= statistics.worst_initial) continue;
      statistics.worst_initial = pair.offset;
      statistics.worst_initial_node = surface.node_id[pair.node];
      statistics.worst_initial_segment = surface.segment_id[pair.segment];
    }
  }

  void remember(std::span<const ContactPair> pairs, const domain::Domain& domain) {
    const Configuration x{domain.nodes.position.data(), domain.nodes.velocity.data(), 0};
    remembered.clear();
    penetrations.clear();
    for (const ContactPair& pair : pairs) {
      RememberedPair memory;
      memory.node = pair.node;
      memory.segment = pair.segment;
      memory.side = pair.side;
      memory.wrong = pair.wrong;
      memory.weight = pair.weight;
      memory.offset = pair.offset;
      memory.depth = std::max(0.0, pair.penetration());
      if (dot(pair.friction, pair.friction) > 0)
        memory.friction = frame_of(shape_of(surface, x, pair.segment)).to_local(pair.friction);
      remembered.push_back(memory);
      if (pair.penetration() <= 0) continue;
      const double height = surface.is_face(pair.segment) ? surface.height[pair.segment] : pair.reach;
      penetrations.push_back(
          {pair.penetration(), height, surface.node_id[pair.node], surface.segment_id[pair.segment]});
    }
  }

  void write_report(domain::ContactReport& entry) {
    entry.id = contact.id;
    entry.method = method;
    entry.segments = surface.segments();
    entry.searches = search.statistics().searches;
    entry.candidates = search.statistics().candidates;
    entry.active_pairs = static_cast<Index>(penetrations.size());
    entry.penetration = 0;
    for (const Penetration& found : penetrations) {
      entry.penetration = std::max(entry.penetration, found.depth);
      if (found.depth <= entry.worst_penetration) continue;
      entry.worst_penetration = found.depth;
      entry.worst_node = found.node;
    }
    entry.initial_penetrations = statistics.initial_penetrations;
    entry.worst_initial = statistics.worst_initial;
    statistics.search = search.statistics();
    statistics.limited_pairs = forces.limited();
    statistics.most_limited_pairs = std::max(statistics.most_limited_pairs, forces.limited());
    statistics.nodes_astray = 0;
    for (const RememberedPair& pair : remembered)
      if (!surface.is_face(pair.segment)) statistics.nodes_astray += pair.wrong;
  }

  model::SingleSurfaceContact contact;
  Surface surface;
  GlobalSearch search;
  LocalSearch local;
  Forces forces;
  std::string method;
  Index report;
  long verify_cycles = 0;
  std::int64_t started = 0;  ///< 1 once the penetrations at the start are known
  std::vector<RememberedPair> remembered;
  std::vector<Penetration> penetrations;
  ContactStatistics statistics;
};

SingleSurface::SingleSurface(const model::Model& model, const domain::Domain& domain,
                             const model::SingleSurfaceContact& contact, Index report)
    : implementation_(std::make_unique<Implementation>(model, domain, contact, report)) {}
SingleSurface::~SingleSurface() = default;
SingleSurface::SingleSurface(SingleSurface&&) noexcept = default;
SingleSurface& SingleSurface::operator=(SingleSurface&&) noexcept = default;

void SingleSurface::add_forces(domain::Domain& domain) {
  Implementation& own = *implementation_;
  domain::ContactReport& report = domain.contacts[own.report];
  std::span<ContactPair> pairs;
  if (own.acting(domain.clock.time)) {
    {
      const StageTimer timer(domain.times.contact_search);
      const bool changed = drop_eroded(own.surface, domain);
      if (changed)
        std::erase_if(own.remembered,
                      [&](const RememberedPair& pair) { return own.surface.active[pair.segment] == 0; });
      own.search.update(domain, changed);
      if (own.verify_cycles > 0 && domain.clock.cycle % own.verify_cycles == 0) own.search.verify(domain);
    }
    const StageTimer timer(domain.times.contact_local);
    pairs = own.local.find(domain, own.search, own.remembered, own.started == 0);
    if (own.started == 0) own.measure_start(pairs);
    own.started = 1;
  }
  const StageTimer timer(domain.times.contact_forces);
  own.forces.add(domain, pairs, report);
  own.remember(pairs, domain);
  own.write_report(report);
}

void SingleSurface::declare(domain::StateList& list) {
  Implementation& own = *implementation_;
  list.add("contact_started", "-", domain::Entity::Contact, 1, std::span(&own.started, 1));
  own.search.declare(list);
  own.forces.declare(list);
  list.add("contact_pairs", "by item", domain::Entity::Contact, 1, std::span(own.remembered));
}

void SingleSurface::verify_search_every(long cycles) {
  implementation_->verify_cycles = cycles;
}

void SingleSurface::inspect(domain::Domain& domain) const {
  const Implementation& own = *implementation_;
  const auto cut = intersecting_segments(own.surface, domain.nodes.position, domain.execution.threads);
  const PenetrationSummary depth = summarise(own.penetrations);
  domain::ContactInspection& seen = domain.contacts[own.report].inspection;
  seen.made = true;
  seen.intersections = static_cast<Index>(cut.size());
  seen.first_segment = cut.empty() ? 0 : own.surface.segment_id[cut.front()[0]];
  seen.second_segment = cut.empty() ? 0 : own.surface.segment_id[cut.front()[1]];
  seen.nodes_beyond = depth.beyond;
  seen.largest_depth = depth.largest;
  seen.percentile_99 = depth.percentile_99;
}

const ContactStatistics& SingleSurface::statistics() const {
  return implementation_->statistics;
}

std::span<const Penetration> SingleSurface::penetrations() const {
  return implementation_->penetrations;
}

const Surface& SingleSurface::surface() const {
  return implementation_->surface;
}

}  // namespace crumple::contact
