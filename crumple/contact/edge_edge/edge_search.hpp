// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <cellsearch/edge_pairs.hpp>
#include <cellsearch/motion_tracker.hpp>

#include "base/index.hpp"
#include "contact/edge_edge/edges.hpp"
#include "contact/surface/kinematics.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// The global search of edges: which edges may touch which. As in GlobalSearch, the candidates of one search
/// hold until two nodes have moved relative to each other, along any axis, by more than the margin by which
/// their boxes were too large. Edges with a node in common, and of one rigid body, are no candidates.
class EdgeSearch {
 public:
  EdgeSearch(const Edges& edges, const Surface& surface, const model::SearchSettings& settings, int threads);

  /// Searches anew if the candidates may no longer be complete, or if the edges have changed. Throws
  /// NumericalError if a coordinate is not a finite number.
  void update(const Kinematics& motion, bool changed);

  /// Places in the arrays below of the candidates of an edge, those with a higher number, ascending.
  std::int64_t first(Index edge) const { return pairs_.first[static_cast<std::size_t>(edge)]; }
  Index other(std::int64_t pair) const { return pairs_.second[static_cast<std::size_t>(pair)]; }
  /// Distance at which the pair touches. Of next neighbours, which may be nearer than their thickness, it is
  /// at most their distance in the undeformed mesh [length].
  double contact_distance(std::int64_t pair) const { return distance_[static_cast<std::size_t>(pair)]; }
  /// The same of any two edges, candidates or not.
  double contact_distance(const Kinematics& motion, Index one, Index other) const;
  /// The pair cannot have touched since the last step while this exceeds consumed() [length].
  double slack(std::int64_t pair) const { return slack_[static_cast<std::size_t>(pair)]; }
  /// Smallest slack of an edge's pairs [length].
  double edge_slack(Index edge) const { return edge_slack_[static_cast<std::size_t>(edge)]; }
  /// As GlobalSearch::consumed() [length].
  double consumed() const { return consumed_; }
  /// False before the first search, and without any edges.
  bool ready() const { return ready_; }

  /// Every pair closer than its contact distance, and every one that went through each other in the last
  /// step, must be a candidate: throws Error naming the first that is not. Looks at all pairs of edges,
  /// O(N^2).
  void verify(const Kinematics& motion) const;

  long searches() const { return searches_; }
  long candidates() const { return candidates_; }

  /// Declares the positions at the last search, from which the candidates follow.
  void declare(domain::StateList& list);

  /// To be called once after a restart has filled what was declared: finds the candidates of the last search
  /// again.
  void resume(const Kinematics& motion);

 private:
  void watch_ends();
  void collect(std::span<const Vec3> position);
  void search(const Kinematics& motion);
  void measure(const Kinematics& motion);
  double step_motion(const Kinematics& motion) const;
  double swept_by(const Kinematics& motion) const;
  bool listed(Index one, Index other) const;
  bool passed(Index one, Index other, double apart, const Kinematics& motion) const;

  const Edges* edges_;
  const Surface* surface_;
  int threads_;
  double margin_ = 0;
  double swept_ = 0;  ///< as of GlobalSearch [length]
  cellsearch::EdgePairSearch search_;
  cellsearch::MotionTracker motion_;
  std::vector<Index> watched_;
  cellsearch::Pairs pairs_;
  std::vector<double> distance_;
  std::vector<double> slack_;
  std::vector<double> edge_slack_;
  double consumed_ = 0;
  bool ready_ = false;
  long searches_ = 0;
  long candidates_ = 0;
  std::vector<double> searched_position_;  ///< filled by declare(), and by a restart
};

}  // namespace crumple::contact
