// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Pinballs: contact of segments with segments by balls that are embedded in them, instead of nodes and edges
// (T. Belytschko & M.O. Neal, IJNME 31 (1991) 547-572). Balls around a segment, around its quarters, and so
// on, are split where they overlap, down to the smallest (T. Belytschko & I.S. Yeh, CMAME 105 (1993)
// 375-393):
//
//        ,-----.             (_)(_)(_)(_)     The two smallest balls that overlap most are the contact of
//       /       \            (_)(_)(_)(_)     two segments. Penetration: the sum of their radii less the
//       \       /    --->    (_)(_)(_)(_)     distance of their centres; force: along the line between them
//        '-----'             (_)(_)(_)(_)
//        level 0               level 2
//
// The smallest balls of shells have half the contact thickness as radius, where that is not too thin for
// their spacing; those of faces of solids lie below the face and touch it from inside (pinballs.hpp). Which
// balls is our own choice, as are the forces on the nodes of a face, which turn it with its normal
// (docs/theory/contact.md).
//
// It tells no sides apart: beyond half of the thickness it pushes out on the far side. It is slow, and there
// for comparison and where edges, corners and sides give trouble. The force has a potential and needs no
// limit by passivity.
//
// The order of calls is that of every detector (search/detector.hpp). The candidates, pairs of segments, come
// from cellsearch and hold until two nodes have moved by the margin; the skin distances of pairs work as
// those of nodes (search/travel.hpp).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <cellsearch/motion_tracker.hpp>
#include <cellsearch/segment_pairs.hpp>

#include "contact/enforcement/penalty.hpp"
#include "contact/enforcement/touch.hpp"
#include "contact/pinball/pinballs.hpp"
#include "contact/search/detector.hpp"
#include "contact/search/travel.hpp"
#include "contact/surface/kinematics.hpp"
#include "contact/surface/statistics.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// What two segments in contact by their pinballs remember from one step to the next. No padding, so that
/// its bytes can be hashed.
struct RememberedPinballs {
  Index first = no_index;  ///< segments in Surface, first < second
  Index second = no_index;
  std::array<double, 4> first_weight{};  ///< of the nodes at the contact point
  std::array<double, 4> second_weight{};
  double offset = 0;  ///< by which the contact distance is reduced [length]
  Vec3 apart;         ///< from the second contact point to the first, in the frame of the first [length]
  Vec3 friction;      ///< on the first, in its frame [force]
  PenaltyMemory penalty;
};
static_assert(sizeof(RememberedPinballs) == 200);

/// Two segments in contact, now.
struct PinballPair {
  Index first = no_index;
  Index second = no_index;
  PinballOverlap overlap;
  double offset = 0;           ///< [length]
  double initial_overlap = 0;  ///< of this offset, what was overlap when the contact began [length]
  Vec3 slip;                   ///< movement of the first ball over the second since the last step [length]
  Vec3 friction;               ///< on the first at the last step, turned with it [force]
  PenaltyMemory penalty;       ///< of the last step
};

/// Contact of segments with segments by their pinballs, instead of nodes with segments: the global search for
/// pairs of segments, and the deepest overlap of each pair. It tells no sides apart: what has gone through by
/// more than half is pushed out on the far side.
class PinballContact final : public Detector {
 public:
  /// Throws Error for a contact that pinballs cannot serve: one with nodes alone or with orientation, or
  /// with cells over part of the model.
  PinballContact(const Surface& surface, const model::SearchSettings& settings, const Kinematics& start);

  std::string method() const override { return "pinballs"; }
  double update(const domain::Domain& domain, const Kinematics& motion, bool surface_changed,
                bool start) override;
  double find(const domain::Domain& domain, const Kinematics& motion, bool start,
              domain::ContactReport& report) override;
  void find_nothing() override { present_.clear(); }
  Index count() const override { return static_cast<Index>(present_.size()); }
  void fill(const Kinematics& motion, std::span<Touch> touches) const override;
  void remember(const Kinematics& motion, std::span<const Touch> touches, TouchNotes& notes) override;
  void append_initial_overlaps(std::vector<domain::InitialOverlap>& overlaps) const override;
  /// Every pair of segments whose balls overlap must be a candidate.
  void verify(const Kinematics& motion) override;
  void report(domain::ContactReport& report, ContactStatistics& statistics) const override;
  void declare_search(domain::StateList& list) override;
  void declare_pairs(domain::StateList& list) override;
  void resume(const domain::Domain& domain, const Kinematics& motion) override;

 private:
  void search(const Kinematics& motion);
  void collect(std::span<const Vec3> position);
  bool may_touch(Index first, Index second) const;
  bool next_neighbours(Index first, Index second) const;
  double contact_distance(Index first, Index second) const;
  double offset_at_start(const Kinematics& motion, Index first, Index second) const;
  const RememberedPinballs* memory_of(Index first, Index second) const;
  double examine(const Kinematics& motion, bool tracking, PinballPair& pair) const;
  void carry_on(const Configuration& x, const RememberedPinballs& memory, PinballPair& pair) const;
  Touch touch_of(const PinballPair& pair) const;
  UserId node_id(const PinballPair& pair) const;

  const Surface* surface_;
  Pinballs pinballs_;
  double margin_ = 0;
  cellsearch::SegmentPairSearch search_;
  cellsearch::MotionTracker motion_;
  cellsearch::Pairs pairs_;
  std::vector<double> expansion_;  ///< by segment [length]
  std::vector<double> slack_;      ///< way at which a pair is due for a look [length]
  Travel travel_;                  ///< since the last search
  std::vector<PinballPair> present_;
  std::vector<std::vector<PinballPair>> parts_;
  std::vector<RememberedPinballs> remembered_;
  long searches_ = 0;
  long candidates_ = 0;
  std::vector<double> searched_position_;  ///< filled by declare(), and by a restart
};

}  // namespace crumple::contact
