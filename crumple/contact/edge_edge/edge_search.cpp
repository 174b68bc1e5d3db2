// SPDX-License-Identifier: BSD-3-Clause
#include "contact/edge_edge/edge_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "contact/search/search_calls.hpp"
#include "contact/surface/saved_state.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

constexpr Index piece = 512;

double margin_of(const Edges& edges, const model::SearchSettings& settings) {
  const double given = settings.expansion - 2 * edges.largest_half_thickness;
  return given > 0 ? given : tolerances::margin_over_edge * edges.mean_length;
}

cellsearch::EdgePairSettings settings_of(int threads) {
  cellsearch::EdgePairSettings found;
  found.threads = threads;
  return found;
}

double length_of(const cellsearch::Point& a) {
  return norm(Vec3{a[0], a[1], a[2]});
}

}  // namespace

EdgeSearch::EdgeSearch(const Edges& edges, const Surface& surface, const model::SearchSettings& settings,
                       int threads)
    : edges_(&edges),
      surface_(&surface),
      threads_(threads),
      margin_(margin_of(edges, settings)),
      search_(settings_of(threads)),
      motion_(0, 0, threads) {
  // A margin that is not finite comes from a bad position, which the first search will name.
  if (std::isfinite(margin_)) {
    const double distance = 2 * edges.largest_half_thickness;
    motion_ = cellsearch::MotionTracker(distance + margin_, distance, threads);
  }
}

void EdgeSearch::update(const Kinematics& motion, bool changed) {
  if (edges_->taking_part.empty()) {
    ready_ = false;
    return;
  }
  if (ready_) {
    try {
      motion_.update(view(motion.position));
    } catch (const cellsearch::Error& error) {
      rethrow(error, *surface_);
    }
    // Between two steps no pair comes nearer than at the worse of the two.
    consumed_ = std::max(consumed_, length_of(motion_.motion()));
    if (!motion_.due() && !changed) return;
  }
  search(motion);
  consumed_ = step_motion(motion);
}

/// As GlobalSearch::swept_by().
double EdgeSearch::swept_by(const Kinematics& motion) const {
  if (!ready_ || !(motion.way > margin_) || !(motion.step > 0)) return 0;
  return std::max(0.0, step_motion(motion) - margin_);
}

/// Largest relative motion of any two nodes in the step that led to now [length].
double EdgeSearch::step_motion(const Kinematics& motion) const {
  return motion.step * length_of(motion_.relative_speed(view(motion.velocity)));
}

void EdgeSearch::watch_ends() {
  watched_.clear();
  for (const Index e : edges_->taking_part)
    for (const Index node : edges_->ends(e)) watched_.push_back(node);
  std::sort(watched_.begin(), watched_.end());
  watched_.erase(std::unique(watched_.begin(), watched_.end()), watched_.end());
}

/// Finds the candidates for these positions and counts the motion from there.
void EdgeSearch::collect(std::span<const Vec3> position) {
  cellsearch::EdgeScene scene;
  scene.positions = view(position);
  scene.edges = cellsearch::Edges(edges_->nodes);
  // Each of the two boxes has half of the margin.
  scene.expansion = 0.5 * (margin_ + swept_);
  scene.edge_expansion = edges_->half_thickness;
  scene.subset = std::span<const cellsearch::Index>(edges_->taking_part);
  try {
    search_.find(scene);
    pairs_ = search_.take();
    motion_.start(scene.positions, watched_);
  } catch (const cellsearch::Error& error) {
    rethrow(error, *surface_);
  }
}

void EdgeSearch::search(const Kinematics& motion) {
  swept_ = swept_by(motion);
  watch_ends();
  collect(motion.position);
  measure(motion);
  ready_ = true;
  ++searches_;
  candidates_ += pairs_.count();
}

double EdgeSearch::contact_distance(const Kinematics& motion, Index one, Index other) const {
  const double full = edges_->contact_distance(one, other);
  if (!edges_->next_neighbours(*surface_, one, other)) return full;
  const Configuration reference{motion.reference.data(), motion.velocity.data(), 0};
  return std::min(full, edges_->distance(one, other, reference));
}

void EdgeSearch::measure(const Kinematics& motion) {
  const Configuration now{motion.position.data(), motion.velocity.data(), 0};
  const Index count = edges_->count();
  const auto pairs = static_cast<std::size_t>(pairs_.count());
  distance_.resize(pairs);
  slack_.resize(pairs);
  edge_slack_.resize(static_cast<std::size_t>(count));
  parallel_for(pieces(count, piece), threads_, [&](Index part) {
    for (Index e = part * piece; e < std::min((part + 1) * piece, count); ++e) {
      double smallest = std::numeric_limits<double>::max();
      for (std::int64_t pair = first(e); pair < first(e + 1); ++pair) {
        const auto at = static_cast<std::size_t>(pair);
        const Index next = other(pair);
        distance_[at] = contact_distance(motion, e, next);
        slack_[at] = edges_->may_touch(*surface_, e, next) ? edges_->distance(e, next, now) - distance_[at]
                                                           : std::numeric_limits<double>::max();
        smallest = std::min(smallest, slack_[at]);
      }
      edge_slack_[static_cast<std::size_t>(e)] = smallest;
    }
  });
}

bool EdgeSearch::listed(Index one, Index other) const {
  const auto row = pairs_.of(one);
  return std::binary_search(row.begin(), row.end(), other);
}

/// Whether two edges that now are `apart` went through each other in the last step.
bool EdgeSearch::passed(Index one, Index other, double apart, const Kinematics& motion) const {
  const EdgeNodes first = edges_->ends(one);
  const EdgeNodes second = edges_->ends(other);
  if (motion.step <= 0 || apart > relative_motion(first, second, motion.velocity.data(), motion.step))
    return false;
  const Configuration now{motion.position.data(), motion.velocity.data(), 0};
  const Vec3 from = passed_from(first, second, now, motion.step);
  return dot(from, from) > 0;
}

void EdgeSearch::verify(const Kinematics& motion) const {
  const Configuration now{motion.position.data(), motion.velocity.data(), 0};
  const auto& taking_part = edges_->taking_part;
  for (std::size_t i = 0; i < taking_part.size(); ++i)
    for (std::size_t j = i + 1; j < taking_part.size(); ++j) {
      const Index one = taking_part[i];
      const Index other = taking_part[j];
      if (edges_->share_node(one, other) || !edges_->may_touch(*surface_, one, other)) continue;
      // What the motion has left of the margin is covered as well.
      const double distance = edges_->contact_distance(one, other) + std::max(0.0, margin_ - consumed_);
      const EdgeShape a = edge_shape(edges_->ends(one), now);
      const EdgeShape b = edge_shape(edges_->ends(other), now);
      const double apart = nearest_points(a, b).distance;
      if (listed(one, other)) continue;
      if (apart >= distance && !passed(one, other, apart, motion)) continue;
      throw Error("The contact search missed a pair of edges at cycle " + std::to_string(motion.cycle) +
                  ": one of element " + std::to_string(edges_->id[one]) + " touches one of element " +
                  std::to_string(edges_->id[other]) + ", but they are no candidates.");
    }
}

void EdgeSearch::declare(domain::StateList& list) {
  searched_position_.assign(motion_.reference().begin(), motion_.reference().end());
  list.add_list("contact_searched_edge_position", "length", domain::Entity::Contact, 3, searched_position_);
  list.keep("contact_searched_edge_sweep", "length", domain::Entity::Contact, swept_);
  list.keep("contact_edges_consumed", "length", domain::Entity::Contact, consumed_);
  list.keep("contact_edges_ready", "-", domain::Entity::Contact, ready_);
  list.keep("contact_edge_searches", "-", domain::Entity::Contact, searches_);
  list.keep("contact_edge_candidates", "-", domain::Entity::Contact, candidates_);
}

void EdgeSearch::resume(const Kinematics& motion) {
  if (!ready_) return;
  watch_ends();
  require_saved(searched_position_.size() == 3 * watched_.size(), "edges of the last search");
  const std::vector<Vec3> then = positions_at_search(motion.position, watched_, searched_position_);
  collect(then);
  Kinematics at_search = motion;
  at_search.position = then;
  measure(at_search);
}

}  // namespace crumple::contact
