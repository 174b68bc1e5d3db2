// SPDX-License-Identifier: BSD-3-Clause
#include "contact/node_segment/looks_ahead.hpp"

#include "base/prefetch.hpp"

namespace crumple::contact {
namespace {

/// One function for each thing that is asked for, in the order in which one leads to the next.
class LooksAhead {
 public:
  LooksAhead(const StepView& view, std::span<const Visit> visits)
      : surface_(*view.now.surface), candidates_(*view.candidates), x_(view.now.x), visits_(visits) {}

  void candidates() const {
    for (const Visit& visit : visits_) {
      motion(surface_.nodes[visit.place]);
      candidates_.ask_for_candidates(visit.place);
    }
  }

  void segments() const {
    each_segment([&](Index segment) {
      prefetch<false>(surface_.segment(segment), 4);
      prefetch<false>(&surface_.topology.edges_of[segment], 1);
      prefetch<false>(&surface_.height[segment], 1);
      prefetch<false>(&surface_.face[segment], 1);
      prefetch<false>(&surface_.release_depth[segment], 1);
    });
  }

  void corners() const {
    each_segment([&](Index segment) {
      for (int k = 0; k < 4; ++k) motion(surface_.segment(segment)[k]);
    });
  }

 private:
  /// Three numbers may lie in two lines.
  void motion(Index node) const {
    prefetch<false>(&x_.position[node].x, 1);
    prefetch<false>(&x_.position[node].z, 1);
    prefetch<false>(&x_.velocity[node].x, 1);
    prefetch<false>(&x_.velocity[node].z, 1);
  }

  template <class Action>
  void each_segment(const Action& action) const {
    for (const Visit& visit : visits_)
      for (std::int64_t c = candidates_.first(visit.place); c < candidates_.first(visit.place + 1); ++c)
        if (candidates_.slack(c) <= candidates_.consumed()) action(candidates_.segment(c));
  }

  const Surface& surface_;
  const GlobalSearch& candidates_;
  const Configuration& x_;
  std::span<const Visit> visits_;
};

}  // namespace

void ask_for_visit(const StepView& view, Index place) {
  prefetch<false>(&view.now.surface->nodes[place], 1);
  view.candidates->ask_for_first(place);
}

void ask_for_looks(const StepView& view, std::span<const Visit> visits) {
  const LooksAhead ahead(view, visits);
  ahead.candidates();
  ahead.segments();
  ahead.corners();
}

}  // namespace crumple::contact
