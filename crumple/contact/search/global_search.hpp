// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The global search: which nodes may touch which segments until the next search. The library cellsearch finds
// the nodes in the territory of each segment, its bounding box expanded by c on all sides (F. Wang, J. Cheng
// & Z. Yao, Acta Mechanica Sinica 16(4) (2000), eq. 7-9):
//
//      - - - - - - - - - - - - -    c = h + margin
//     |                         |   h: contact distance, half of both thicknesses
//        .===================.      margin: 0.4 of the mean edge, or what the user's c leaves beyond h
//     |  |      segment      |  |
//        '==================='      As long as no two nodes have moved relative to each other by more than
//     |                         |   the margin along any axis, no pair can touch that is not a candidate.
//      - - - - - - - - - - - - -
//
// The motion itself is watched, so that no contact is missed; the interval of eq. (10) is given as a
// prediction only. A step that moves nodes by more than the margin expands the next territories by the rest,
// and motion_limit bounds the step where bodies close so fast.
//
// Candidates that are far from touching are deferred: Travel bounds the path of any two nodes relative to
// each other by the sum of short displacements, and a pair that is g from touching is not due before that has
// grown by g. While it is below the margin no search can be due either, so that most steps read no positions
// for it.
//
// Order of calls: update() in every step, with the pairs that are remembered; then the local search walks
// over the candidates of each node from first() on, skips those with slack() > consumed(), defers with
// put_off(), and ends with refresh_node(). verify() compares with all nodes and segments. After a restart
// resume() repeats the last search from the positions that declare() saved.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <cellsearch/motion_tracker.hpp>
#include <cellsearch/search.hpp>

#include "base/index.hpp"
#include "base/prefetch.hpp"
#include "contact/enforcement/contact_pair.hpp"
#include "contact/search/travel.hpp"
#include "contact/surface/inside_outside.hpp"
#include "contact/surface/kinematics.hpp"
#include "contact/surface/nearest_point_kernel.hpp"
#include "contact/surface/statistics.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// The global contact search: which nodes may touch which segments. The candidates of one search hold until
/// two nodes have moved relative to each other, along any axis, by more than what the expansion leaves beyond
/// the contact distance. The motion itself is watched, so that no contact is ever missed.
class GlobalSearch {
 public:
  /// Throws Error for an unknown method or an expansion that does not exceed the contact distance.
  GlobalSearch(const Surface& surface, const model::SearchSettings& settings, int threads);

  /// Searches again if the candidates may no longer be complete or if the surface has changed. Nodes that are
  /// `remembered` behind a segment stay its candidates, however deep; behind a face of a solid those of the
  /// faces around, too. Throws NumericalError if a coordinate is not a finite number.
  void update(const Kinematics& motion, bool surface_changed, std::span<const RememberedPair> remembered);

  /// Places in the arrays below of the candidates of a node, segments ascending.
  std::int64_t first(Index place) const { return first_[place]; }
  Index segment(std::int64_t pair) const { return segment_[pair]; }
  std::span<const Index> segments_of(Index place) const {
    return std::span(segment_).subspan(first_[place], first_[place + 1] - first_[place]);
  }
  /// Distance at which the pair touches. A node and its next neighbours may be nearer by thickness alone: it
  /// is at most what the undeformed mesh leaves between them [length].
  double contact_distance(std::int64_t pair) const { return distance_[pair]; }
  /// The pair cannot have touched since the last step while this exceeds consumed() [length].
  double slack(std::int64_t pair) const { return slack_[pair]; }
  /// The first of the nodes from `place` to before `end` of which a pair may have touched, or `end`.
  Index next_awake(Index place, Index end) const {
    while (place < end && node_slack_[place] > consumed_) ++place;
    return place;
  }
  /// Ask for where the candidates of a node begin, and then for them: in a large model they come from memory.
  void ask_for_first(Index place) const { prefetch<false>(&first_[place], 2); }
  void ask_for_candidates(Index place) const {
    const std::int64_t first = first_[place];
    const std::int64_t count = first_[place + 1] - first;
    prefetch<true>(slack_.data() + first, count);
    prefetch<false>(segment_.data() + first, count);
    prefetch<false>(distance_.data() + first, count);
  }
  /// Bound on the way of any two nodes relative to each other since the search, or in the step before it if
  /// there was one just now [length].
  double consumed() const { return consumed_; }

  /// Expands the territory of a segment by `depth` in the next search: nodes that start that deep behind it.
  void reach_behind(Index segment, double depth) {
    segment_expansion_[segment] =
        std::max(segment_expansion_[segment], surface_->half_thickness[segment] + depth);
  }

  /// To be told when a pair is found to be `gap` > 0 from touching now: it need not be looked at again before
  /// something can have moved that far. Pairs of different nodes may be put off at the same time.
  void put_off(std::int64_t pair, double gap) { slack_[pair] = travel_.length_to_meet(gap); }
  /// To be told once all pairs of a node that are not near have been put off.
  void refresh_node(Index place);

  /// Every pair closer than its contact distance, and every one that went through each other in the last
  /// step, must be a candidate: throws Error naming the first that is not. Looks at all nodes and segments,
  /// O(N^2).
  void verify(const Kinematics& motion);

  const SearchStatistics& statistics() const { return statistics_; }
  /// Counts of the last search.
  const cellsearch::Statistics& details() const { return search_.statistics(); }

  /// Declares the positions at the last search, from which the candidates follow.
  void declare(domain::StateList& list);

  /// To be called once after a restart has filled what was declared: finds the candidates of the last search
  /// again. `motion` is where the nodes are now.
  void resume(const Kinematics& motion);

 private:
  void search(const Kinematics& motion, bool surface_changed, std::span<const RememberedPair> remembered);
  void keep_behind(const SurfaceAt& now, std::span<const RememberedPair> remembered);
  void add_kept();
  double swept_by(const Kinematics& motion) const;
  void collect(std::span<const Vec3> position);
  void sort_by_node(const cellsearch::Candidates& found);
  void measure_slack(const Kinematics& motion);
  void measure_pairs(const SurfaceAt& at, Index begin, Index end, DistancesKernel measure);
  /// Position at the last search.
  Vec3 searched(Index place) const {
    const double* x = motion_.reference().data() + 3 * static_cast<std::size_t>(place);
    return {x[0], x[1], x[2]};
  }
  double distance_of(const SurfaceAt& reference, Index place, Index segment,
                     NearestPointKernel nearest) const;
  void keep_distances(bool surface_changed);
  void measure_distances(const SurfaceAt& reference, Index place, NearestPointKernel nearest);
  Vec3 step_motion(const Kinematics& motion) const;
  bool listed(Index place, Index segment) const;

  const Surface* surface_;
  int threads_;
  std::optional<cellsearch::CellDomain> cells_;
  cellsearch::Search search_;
  std::vector<Index> searched_node_;            ///< domain nodes that may touch any segment
  std::vector<std::uint8_t> searched_segment_;  ///< 1 for those that any node may touch now
  bool some_untouched_ = false;                 ///< there are segments that no node may ever touch
  double common_expansion_ = 0;
  double swept_ =
      0;  ///< by which the last search expanded territories for the motion of a fast step [length]
  std::vector<double> segment_expansion_;  ///< beyond what all have [length]
  /// A node, by place, that was behind a segment at the last search; that segment, or a face around it.
  struct Pair {
    Index node = no_index;
    Index segment = no_index;

    bool operator==(const Pair&) const = default;
    bool operator<(const Pair& other) const {
      return node != other.node ? node < other.node : segment < other.segment;
    }
  };
  std::vector<Pair> kept_;            ///< ascending
  cellsearch::MotionTracker motion_;  ///< of the surface's nodes, by place, since the last search
  std::vector<std::int64_t> first_;
  std::vector<Index> segment_;
  std::vector<double> distance_;
  std::vector<std::int64_t> earlier_first_;  ///< as above, of the search before
  std::vector<Index> earlier_segment_;
  std::vector<double> earlier_distance_;
  std::vector<double> slack_;
  std::vector<double> node_slack_;  ///< smallest of its pairs
  Travel travel_;                   ///< since the last search
  double safe_length_ = 0;          ///< of the way, up to which no search can be due [length]
  double consumed_ = 0;
  SearchStatistics statistics_;
  std::vector<double> searched_position_;  ///< filled by declare(), and by a restart
};

}  // namespace crumple::contact
