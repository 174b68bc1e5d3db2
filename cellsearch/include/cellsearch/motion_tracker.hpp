// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "cellsearch/array.hpp"
#include "cellsearch/instruction_set.hpp"
#include "cellsearch/scene.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch {

/// Tells when the candidates of a search run out, from how far the nodes have really moved.
///
/// After a search with the expansion c, every pair closer than the contact distance h is among the candidates
/// as long as no node has moved relative to a segment by more than c - h along any axis. "Closer" means that
/// the node lies within h of the segment's bounding box along each axis. Only the difference of displacements
/// counts: the common translation of all nodes uses up nothing. Eq. (10) of the paper predicts how long that
/// lasts from the last velocities (predicted_steps); this class watches it happen, so that nothing is missed
/// however the velocities change.
///
///     const cellsearch::Candidates& found = search.find(scene);
///     tracker.start(scene.positions, nodes);  // copies the positions
///     for (...) {
///       move();
///       tracker.update(scene.positions);
///       if (tracker.due()) { search.find(scene); tracker.start(scene.positions, nodes); }
///     }
///
/// Where expansions, radii or contact distances differ, give the smallest difference of expansion (with
/// radius) and contact distance over all pairs. With cells over part of the model only, nodes that enter them
/// are candidates from the next search on. Start anew as well when nodes, segments or activity flags change.
///
/// An object may be used by one thread at a time. All results are bitwise the same for any number of threads.
/// start() and update() read each watched node once: O(N) time, 28 bytes per watched node.
class MotionTracker {
 public:
  /// `expansion`: c [length]; `contact_distance`: h [length]; `threads`: >= 1. Only c - h counts, and where
  /// nothing is left to move (c <= h) a search is always due. Throws Error(BadSetting) if a length is not
  /// finite or negative, or if threads < 1.
  MotionTracker(double expansion, double contact_distance, int threads = 1);

  /// A search was made for these positions. Every node of `nodes` may be a candidate of a segment of any of
  /// the others. `nodes`: node numbers in any order, twice is harmless. Copies positions and numbers,
  /// re-using memory. Throws Error(BadNodeList), index the place in `nodes`, for a node that does not exist,
  /// and what update() throws for a coordinate that is not finite; a search is due then.
  void start(const Positions& positions, std::span<const Index> nodes);

  /// The same for all nodes.
  void start(const Positions& positions);

  /// The same for two surfaces: only `nodes` against the segments that `segment_nodes` belong to. The motion
  /// within each of the two lists then uses up nothing: two bodies that deform much but keep still relative
  /// to each other do not count as moving. Errors name the place in the two lists, one behind the other.
  void start(const Positions& positions, std::span<const Index> nodes, std::span<const Index> segment_nodes);

  /// The same for what a search of `scene` looks at: all nodes, or, if it lists its nodes, these against the
  /// nodes of its active segments as two surfaces. The scene's expansion is
  /// not looked at: c is the constructor's. Throws Error(BadConnectivity) as well.
  void start(const Scene& scene);

  /// A new start of the same nodes as the last time: nothing has moved since. Errors as of start(); without
  /// a start before, there is nothing to do.
  void start_again(const Positions& positions);

  /// Compares `positions` with those at the start: afterwards motion(), used(), left() and due() speak of
  /// now. Throws Error(NonFiniteCoordinate), naming the smallest such node, if a watched coordinate is not a
  /// finite number, and Error(BadLayout) if a watched node is missing; a search is due in both cases.
  void update(const Positions& positions);

  /// Largest displacement, since the start, of any watched node relative to any other one it may meet,
  /// along each axis [length]. Infinite after an error and before the first start().
  const Point& motion() const { return motion_; }

  /// The largest component of motion() [length].
  double used() const;

  /// c - h [length].
  double room() const { return room_; }

  /// What may still be used up [length]; negative once it is too late.
  double left() const { return room_ - used(); }

  /// Bound on the rounding in what the functions above say, and in moving a node once [length].
  double rounding() const { return rounding_; }

  /// True if a search is needed before the candidates may be used again. Rounding is on the safe side: a
  /// search is due a few units in the last place of the largest coordinate before c - h is used up.
  bool due() const;

  /// For how many further steps, of `largest_step` [time] at most, the candidates stay complete if the
  /// velocities remain: left() over the distance covered in a step, rounded down, at least 1 and at most
  /// `cap`; just after start() it is eq. (10) of the paper with vmax the largest component of speed().
  /// `velocities`: x, y, z [length/time] of each node, laid out like positions.
  int predicted_steps(const Positions& velocities, double largest_step, int cap) const;

  /// Largest difference of velocity, along each axis, of any watched node relative to any other one it may
  /// meet [length/time]. `velocities` as above. NaN if a velocity is not finite,
  /// infinite before the first start(). Throws Error(BadLayout) if a
  /// watched node is missing.
  Point relative_speed(const Positions& velocities) const;

  /// The positions at the start [length], 3 numbers per watched node in the order of the list(s): all that
  /// this object remembers between updates. Writable, so that a program that restarts can put them back.
  std::span<double> reference() { return reference_; }
  std::span<const double> reference() const { return reference_; }

 private:
  struct Range;

  Index watched(std::size_t place) const {
    return nodes_.empty() ? static_cast<Index>(place) : nodes_[place];
  }
  void forget();
  void watch(const Positions& positions, std::span<const Index> nodes, std::span<const Index> segment_nodes);
  void find_runs();
  template <class Visit>
  void visit_runs(std::size_t begin, std::size_t end, std::size_t longest, const Visit& visit) const;
  void remember(const Positions& positions);
  void check_layout(const Positions& values) const;
  Range range(const Positions& values, bool since_start, std::size_t begin, std::size_t end) const;
  Point largest_difference(const Positions& values, bool since_start, double& largest, bool& bad) const;
  void throw_if_bad_node(const Positions& positions) const;

  double room_;
  double lengths_;  // c + h, which enters the bound on rounding
  int threads_;
  InstructionSet set_;
  Array<Index> runs_;       // places from which on nodes follow each other by number
  Array<Index> nodes_;      // the watched nodes, of both lists; empty if these are all nodes
  std::size_t count_ = 0;   // how many there are
  std::size_t second_ = 0;  // where the second list begins; count_ if there is one only
  bool two_lists_ = false;
  bool started_ = false;
  Index highest_ = -1;              // the highest number of a watched node
  Array<std::uint8_t> of_segment_;  // by node: whether it belongs to an active segment; for start() only
  Array<Index> segment_nodes_;
  Array<double> reference_;
  double largest_reference_ = 0.0;  // largest absolute coordinate at the start [length]
  Point motion_;
  double rounding_ = 0.0;  // bound on the rounding in the search, the motion and a contact test [length]
};

}  // namespace cellsearch
