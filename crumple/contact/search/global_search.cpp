// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/global_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <cellsearch/search_interval.hpp>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "contact/search/search_calls.hpp"
#include "contact/surface/crossing.hpp"
#include "contact/surface/saved_state.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

constexpr Index piece = 1024;

struct Range {
  std::array<double, 3> low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(),
                            std::numeric_limits<double>::max()};
  std::array<double, 3> high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest(),
                             std::numeric_limits<double>::lowest()};

  void include(const Vec3& a) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], a[axis]);
      high[axis] = std::max(high[axis], a[axis]);
    }
  }
};

cellsearch::Settings settings_of(const model::SearchSettings& settings, int threads) {
  cellsearch::Settings found;
  const auto method = cellsearch::method_named(settings.method);
  if (!method) {
    std::string names;
    for (const cellsearch::Method known : cellsearch::methods())
      names += (names.empty() ? "" : ", ") + std::string(cellsearch::name_of(known));
    throw Error("There is no contact search method \"" + settings.method + "\"; choose one of: " + names +
                ".");
  }
  found.method = *method;
  found.threads = threads;
  if (settings.has_cells) {
    cellsearch::CellDomain domain;
    domain.cells = settings.cells;
    domain.box.lo = settings.domain_minimum;
    domain.box.hi = settings.domain_maximum;
    found.domain = domain;
  }
  return found;
}

Vec3 vector_of(const cellsearch::Point& a) {
  return {a[0], a[1], a[2]};
}

/// True if a tied contact joins nodes of two segments.
bool joined(const Surface& surface, Index a, Index b) {
  if (surface.joined.empty()) return false;
  const Index* nodes = surface.segment(a);
  return std::any_of(nodes, nodes + 4, [&](Index node) { return surface.joined_to(surface.place[node], b); });
}

/// True if a segment shares a node with a segment of `place`, or is tied to it: a next neighbour in the mesh.
bool next_neighbour(const Surface& surface, Index place, Index segment) {
  for (const Index own : surface.topology.at_node(place))
    if (connected(surface, own, segment) || joined(surface, own, segment)) return true;
  return false;
}

/// True if a point is further than `distance` from a box along some axis.
bool beyond(const Range& box, const Vec3& p, double distance) {
  return box.low[0] - p.x > distance || p.x - box.high[0] > distance || box.low[1] - p.y > distance ||
         p.y - box.high[1] > distance || box.low[2] - p.z > distance || p.z - box.high[2] > distance;
}

}  // namespace

GlobalSearch::GlobalSearch(const Surface& surface, const model::SearchSettings& settings, int threads)
    : surface_(&surface),
      threads_(threads),
      cells_(settings_of(settings, threads).domain),
      search_(settings_of(settings, threads)),
      motion_(0, 0, threads),
      travel_(0, threads) {
  statistics_.margin = margin_of(surface, settings);
  // The node's half thickness and the margin are common to all territories, the other half is the segment's.
  common_expansion_ = surface.largest_half_thickness + statistics_.margin;
  segment_expansion_ = surface.half_thickness;
  statistics_.expansion = 2 * surface.largest_half_thickness + statistics_.margin;
  searched_segment_.assign(surface.segment_id.size(), 1);
  std::uint8_t sides = 0;
  for (const std::uint8_t touching : surface.touched_by) {
    sides |= touching;
    some_untouched_ = some_untouched_ || touching == 0;
  }
  for (Index i = 0; i < surface.node_count(); ++i)
    if ((surface.node_side[i] & sides) != 0) searched_node_.push_back(surface.nodes[i]);
  // A margin that is not finite comes from a bad position or setting, which the first search will name.
  if (!std::isfinite(statistics_.margin)) return;
  motion_ =
      cellsearch::MotionTracker(statistics_.expansion, statistics_.expansion - statistics_.margin, threads);
  travel_ = Travel(tolerances::leg_over_margin * statistics_.margin, threads);
}

void GlobalSearch::update(const Kinematics& motion, bool surface_changed,
                          std::span<const RememberedPair> remembered) {
  if (statistics_.searches > 0) {
    bool due = false;
    try {
      travel_.update(motion.position, motion.way);
      // Nobody is further away than the way was long.
      if (travel_.length() > safe_length_) {
        motion_.update(view(motion.position));
        due = motion_.due();
        safe_length_ = travel_.length_to_meet(tolerances::usable_margin * motion_.left());
      }
    } catch (const cellsearch::Error& error) {
      rethrow(error, *surface_);
    }
    consumed_ = travel_.length();
    if (!due && !surface_changed) return;
  }
  search(motion, surface_changed, remembered);
  consumed_ = norm(step_motion(motion));
}

/// What two nodes may have moved relative to each other in the last step beyond the margin: they may have met
/// and parted between the two searches, so that territories must reach that much further.
double GlobalSearch::swept_by(const Kinematics& motion) const {
  if (!(motion.way > statistics_.margin) || !(motion.step > 0)) return 0;
  return std::max(0.0, norm(step_motion(motion)) - statistics_.margin);
}

void GlobalSearch::refresh_node(Index place) {
  double smallest = std::numeric_limits<double>::max();
  for (std::int64_t pair = first(place); pair < first(place + 1); ++pair)
    smallest = std::min(smallest, slack_[pair]);
  node_slack_[place] = smallest;
}

/// Largest relative motion of any two nodes in the step that led to now, along each axis.
Vec3 GlobalSearch::step_motion(const Kinematics& motion) const {
  return motion.step * vector_of(motion_.relative_speed(view(motion.velocity)));
}

/// Finds the candidates for these positions and counts the motion from there.
void GlobalSearch::collect(std::span<const Vec3> position) {
  cellsearch::Scene scene;
  scene.positions = view(position);
  scene.segments = cellsearch::Segments(surface_->connectivity);
  scene.expansion = common_expansion_ + swept_;
  scene.segment_expansion = segment_expansion_;
  if (surface_->some_inactive || some_untouched_) {
    for (Index s = 0; s < surface_->segments(); ++s)
      searched_segment_[s] = surface_->active[s] != 0 && surface_->touched_by[s] != 0 ? 1 : 0;
    scene.segment_active = searched_segment_;
  }
  scene.nodes = std::span<const cellsearch::Index>(searched_node_);
  try {
    const cellsearch::Candidates* found = nullptr;
    {
      const StageTimer timer(statistics_.find_seconds);
      found = &search_.find(scene);
    }
    sort_by_node(*found);
    add_kept();
    motion_.start(scene.positions, surface_->nodes);
  } catch (const cellsearch::Error& error) {
    rethrow(error, *surface_);
  }
}

/// Adds the pairs of kept_ that are not among the candidates.
void GlobalSearch::add_kept() {
  const auto is_listed = [&](const Pair& pair) { return listed(pair.node, pair.segment); };
  if (std::ranges::all_of(kept_, is_listed)) return;
  std::vector<Index> merged;
  std::vector<std::int64_t> rows;
  auto next = kept_.begin();
  for (Index i = 0; i < surface_->node_count(); ++i) {
    rows.push_back(static_cast<std::int64_t>(merged.size()));
    const auto row = static_cast<std::ptrdiff_t>(merged.size());
    merged.insert(merged.end(), segment_.begin() + first_[i], segment_.begin() + first_[i + 1]);
    for (; next != kept_.end() && next->node == i; ++next)
      if (!is_listed(*next)) merged.push_back(next->segment);
    std::sort(merged.begin() + row, merged.end());
  }
  rows.push_back(static_cast<std::int64_t>(merged.size()));
  segment_.assign(merged.begin(), merged.end());
  first_.assign(rows.begin(), rows.end());
}

/// A node that is behind a segment stays its candidate. Behind a solid it is deeper than territories reach,
/// and passes on to the faces around that go on as the surface does.
void GlobalSearch::keep_behind(const SurfaceAt& now, std::span<const RememberedPair> remembered) {
  const Surface& surface = *surface_;
  kept_.clear();
  for (const RememberedPair& pair : remembered) {
    if (pair.wrong == 0 || surface.active[pair.segment] == 0 || !surface.bears(pair.node)) continue;
    kept_.push_back({pair.node, pair.segment});
    if (!surface.is_face(pair.segment)) continue;
    const Vec3 normal = normalised(area_normal(now.shape(pair.segment)));
    for (int k = 0; k < 4; ++k)
      for (const Index beside : surface.topology.at_node(surface.place[surface.segment(pair.segment)[k]]))
        if (surface.is_face(beside) && surface.may_touch(pair.node, beside) &&
            !surface.owns(beside, surface.nodes[pair.node]) &&
            dot(normalised(area_normal(now.shape(beside))), normal) > tolerances::two_walls)
          kept_.push_back({pair.node, beside});
  }
  std::sort(kept_.begin(), kept_.end());
  kept_.erase(std::unique(kept_.begin(), kept_.end()), kept_.end());
}

void GlobalSearch::search(const Kinematics& motion, bool surface_changed,
                          std::span<const RememberedPair> remembered) {
  keep_distances(surface_changed);
  keep_behind({surface_, {motion.position.data(), motion.velocity.data(), 0}}, remembered);
  swept_ = statistics_.searches > 0 ? swept_by(motion) : 0;
  if (!std::isfinite(swept_))
    throw NumericalError(
        "The relative motion of the nodes of a contact in a step is not a finite number any more.");
  collect(motion.position);
  // From now on what starts deep behind a segment is remembered there.
  segment_expansion_ = surface_->half_thickness;
  travel_.start(motion.position, surface_->nodes);
  safe_length_ = tolerances::usable_margin * statistics_.margin;
  measure_slack(motion);
  ++statistics_.searches;
  statistics_.candidates += static_cast<long>(segment_.size());
  statistics_.node_visits += search_.statistics().raw_visits;
  statistics_.cell_visits += search_.statistics().cell_visits;

  const double step = motion.step;
  const double speed = step > 0 ? norm(step_motion(motion)) / step : 0.0;
  statistics_.predicted_interval =
      cellsearch::search_interval(statistics_.expansion, statistics_.expansion - statistics_.margin, speed,
                                  step, tolerances::longest_predicted_interval);
}

void GlobalSearch::sort_by_node(const cellsearch::Candidates& found) {
  const Index places = surface_->node_count();
  const auto for_each = [&](const auto& do_it) {
    for (Index s = 0; s < found.segments(); ++s)
      for (const Index node : found.of(s)) {
        const Index place = surface_->place[node];
        if ((!surface_->some_inactive || surface_->bears(place)) && surface_->may_touch(place, s))
          do_it(place, s);
      }
  };
  // Numbers are counted two places on: once filled, every place's first is where it belongs.
  first_.assign(static_cast<std::size_t>(places) + 2, 0);
  for_each([&](Index place, Index) { ++first_[place + 2]; });
  for (Index i = 0; i < places; ++i) first_[i + 2] += first_[i + 1];
  segment_.resize(static_cast<std::size_t>(first_.back()));
  // Rows come in the order of the segments, so that each node's own come out ascending.
  for_each([&](Index place, Index s) { segment_[first_[place + 1]++] = s; });
  first_.pop_back();
}

double GlobalSearch::distance_of(const SurfaceAt& reference, Index place, Index segment,
                                 NearestPointKernel nearest) const {
  const double full = surface_->contact_distance(place, segment);
  if (!next_neighbour(*surface_, place, segment)) return full;
  const Vec3 origin = reference.x[surface_->nodes[place]];
  return std::min(full, std::sqrt(nearest(reference.shape(segment), origin).distance_squared));
}

/// Most pairs are candidates in one search after the other, and their contact distance depends on the
/// undeformed mesh alone.
void GlobalSearch::keep_distances(bool surface_changed) {
  earlier_first_.swap(first_);
  earlier_segment_.swap(segment_);
  earlier_distance_.swap(distance_);
  if (surface_changed) earlier_first_.clear();
}

/// Contact distances of the pairs of a node; both searches have its segments in ascending order.
void GlobalSearch::measure_distances(const SurfaceAt& reference, Index place, NearestPointKernel nearest) {
  std::int64_t earlier = earlier_first_.empty() ? 0 : earlier_first_[place];
  const std::int64_t end = earlier_first_.empty() ? 0 : earlier_first_[place + 1];
  for (std::int64_t pair = first_[place]; pair < first_[place + 1]; ++pair) {
    while (earlier < end && earlier_segment_[earlier] < segment_[pair]) ++earlier;
    const bool known = earlier < end && earlier_segment_[earlier] == segment_[pair];
    distance_[pair] =
        known ? earlier_distance_[earlier] : distance_of(reference, place, segment_[pair], nearest);
  }
}

void GlobalSearch::measure_slack(const Kinematics& motion) {
  const Index places = surface_->node_count();
  const SurfaceAt at{surface_, {motion.position.data(), motion.velocity.data(), 0}};
  const SurfaceAt reference{surface_, {motion.reference.data(), motion.velocity.data(), 0}};
  const NearestPointKernel nearest_of = nearest_point_kernel(motion.isa);
  distance_.resize(segment_.size());
  slack_.resize(segment_.size());
  node_slack_.resize(places);
  parallel_for(pieces(places, piece), threads_, [&](Index part) {
    const Index begin = part * piece;
    const Index end = std::min(begin + piece, places);
    measure_pairs(at, begin, end, distances_kernel(motion.isa));
    for (Index i = begin; i < end; ++i) {
      double smallest = std::numeric_limits<double>::max();
      if (first_[i] < first_[i + 1]) measure_distances(reference, i, nearest_of);
      for (std::int64_t pair = first_[i]; pair < first_[i + 1]; ++pair) {
        slack_[pair] = slack_[pair] - distance_[pair] - surface_->watch(segment_[pair]);
        smallest = std::min(smallest, slack_[pair]);
      }
      node_slack_[i] = smallest;
    }
  });
}

/// The slack of all pairs of these nodes becomes their distance.
void GlobalSearch::measure_pairs(const SurfaceAt& at, Index begin, Index end, DistancesKernel measure) {
  PairsInLanes pairs;
  int held = 0;
  std::int64_t from = first_[begin];
  for (Index i = begin; i < end; ++i)
    for (std::int64_t pair = first_[i]; pair < first_[i + 1]; ++pair) {
      pairs.set(held, at.shape(segment_[pair]), at.x[surface_->nodes[i]]);
      if (++held < PairsInLanes::lanes && pair + 1 < first_[end]) continue;
      measure(pairs, held, &slack_[from]);
      from += held;
      held = 0;
    }
}

bool GlobalSearch::listed(Index place, Index segment) const {
  return std::binary_search(segment_.begin() + first_[place], segment_.begin() + first_[place + 1], segment);
}

void GlobalSearch::verify(const Kinematics& motion) {
  const Surface& surface = *surface_;
  const std::span<const Vec3> x = motion.position;
  const SurfaceAt at{surface_, {x.data(), motion.velocity.data(), 0}};
  std::vector<Range> boxes(surface.segments());
  for (Index s = 0; s < surface.segments(); ++s)
    for (int k = 0; k < 4; ++k) boxes[s].include(x[surface.segment(s)[k]]);
  // What the motion has left of the margin is covered as well.
  motion_.update(view(motion.position));
  const double left = std::max(0.0, motion_.left());
  for (Index i = 0; i < surface.node_count(); ++i) {
    if (!surface.bears(i)) continue;
    const Index node = surface.nodes[i];
    const Vec3 searched_at = searched(i);
    if (cells_ && !cells_->box.contains(&searched_at.x)) continue;
    for (Index s = 0; s < surface.segments(); ++s) {
      const double distance = surface.contact_distance(i, s) + left;
      const double way = motion.step > 0 ? relative_motion(at, node, s, motion.step) : 0;
      if (beyond(boxes[s], x[node], std::max(distance, way)) || surface.active[s] == 0 ||
          !surface.may_touch(i, s))
        continue;
      if (surface.owns(s, node) || listed(i, s)) continue;
      const NearestPoint nearest = nearest_point(at.shape(s), x[node]);
      // One that went through within the step may be anywhere behind by now.
      const bool near = nearest.distance_squared < distance * distance;
      const bool through = nearest.distance_squared <= way * way;
      if (!near && !(through && crossed_from(at, node, s, motion.step) != 0)) continue;
      throw Error("The contact search missed a pair at cycle " + std::to_string(motion.cycle) + ": node " +
                  std::to_string(surface.node_id[i]) + (near ? " touches" : " went through") + " element " +
                  std::to_string(surface.segment_id[s]) + ", but is not among its candidates.");
    }
  }
}

void GlobalSearch::declare(domain::StateList& list) {
  searched_position_.assign(motion_.reference().begin(), motion_.reference().end());
  list.add_list("contact_searched_position", "length", domain::Entity::Contact, 3, searched_position_);
  list.keep_list("contact_kept_pairs", "by item", domain::Entity::Contact, 1, kept_);
  list.keep("contact_searched_sweep", "length", domain::Entity::Contact, swept_);
  list.keep("contact_search_statistics", "by item", domain::Entity::Contact, statistics_);
}

void GlobalSearch::resume(const Kinematics& motion) {
  const auto fits = [this](const Pair& pair) {
    return is_one_of(pair.node, surface_->nodes.size()) &&
           is_one_of(pair.segment, surface_->segment_id.size());
  };
  require_all_saved(kept_, fits, "pairs of the last search");
  const auto unordered = [](const Pair& a, const Pair& b) { return a.node > b.node; };
  require_saved(std::ranges::adjacent_find(kept_, unordered) == kept_.end(), "pairs of the last search");
  require_saved(statistics_.searches >= 0 && std::isfinite(statistics_.margin), "figures of the last search");
  if (statistics_.searches == 0) return;
  require_saved(searched_position_.size() == 3 * surface_->nodes.size(), "positions at the last search");
  // Those of another time, when other segments may have failed.
  earlier_first_.clear();
  collect(positions_at_search(motion.position, surface_->nodes, searched_position_));
  // The path since the search is not known: skin distances are measured again, and the path begins here.
  travel_.start(motion.position, surface_->nodes);
  motion_.update(view(motion.position));
  safe_length_ = tolerances::usable_margin * motion_.left();
  measure_slack(motion);
  consumed_ = norm(step_motion(motion));
}

}  // namespace crumple::contact
