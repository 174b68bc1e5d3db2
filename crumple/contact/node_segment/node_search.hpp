// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/enforcement/contact_pair.hpp"
#include "contact/node_segment/seam.hpp"
#include "contact/node_segment/solid_overlaps.hpp"
#include "contact/search/global_search.hpp"
#include "contact/surface/inside_outside.hpp"
#include "contact/surface/nearest_point_kernel.hpp"

namespace crumple::contact {

/// What the local search of one step works with.
struct StepView {
  SurfaceAt now;        ///< positions and velocities of the step
  SurfaceAt reference;  ///< positions at time zero
  GlobalSearch* candidates = nullptr;
  NearestPointKernel nearest_point = nullptr;
  double step = 0;                 ///< from n-1 to n [time]
  std::span<const DeepPair> deep;  ///< nodes that start deep inside of solids, ascending; while tracking
  bool tracking = false;           ///< allow the penetrations that there are
};

/// The local search of one node.
class NodeSearch {
 public:
  NodeSearch(const StepView& view, Index place, std::span<const RememberedPair> remembered);

  /// Appends the contacts of the node to `found`, segments ascending, and puts off candidates that are far.
  void find(std::vector<ContactPair>& found);

 private:
  /// A node that is astray looks at all its candidates; so does every node at the start of a contact.
  bool looks_at_all() const { return astray_ || begins(); }
  /// At the start of a contact and where a tie of the node has just ended.
  bool begins() const { return view_.tracking || freed_; }
  /// True for a pair that is allowed the penetration that it has.
  bool is_tracked(const RememberedPair* memory) const {
    return view_.tracking || (freed_ && memory == nullptr);
  }
  static void measure(const Vec3& away, double distance, const Vec3& normal, ContactPair& pair);
  void smooth_direction(const SegmentShape& shape, const NearestPoint& nearest, ContactPair& pair) const;
  double examine(Index segment, double full, std::vector<ContactPair>& found);
  int kept_side(Index segment, const RememberedPair& memory, double distance, int present) const;
  int side_of(Index segment, const RememberedPair* memory, const NearestPoint& nearest, int present) const;
  void measure_faces();
  bool starts_inside(Index segment, double distance) const;
  double offset_of(Index segment, const RememberedPair* memory, double full, double gap) const;
  void keep_owners(std::vector<ContactPair>& found, std::size_t first) const;
  void carry_on(ContactPair& pair, std::span<const ContactPair> present);
  Vec3 slip_since(const RememberedPair& from, const SegmentShape& shape, const ContactPair& pair) const;
  bool came_from(const RememberedPair& other, Index segment) const;
  std::span<const Index> around(Index segment, const NearestPoint& nearest) const;
  bool agree(Index a, Index b, const NearestPoint& nearest_of_a) const;
  int crossed_around(Index segment, const NearestPoint& nearest) const;
  double hold(Index segment, const NearestPoint& nearest, const RememberedPair* memory, bool near) const;
  bool goes_on(Index segment, const NearestPoint& nearest, const Vec3& normal) const;
  double on_face(Index segment) const;
  bool enters_once(const ContactPair& a, const ContactPair& b) const;
  void enter_between(ContactPair& a, ContactPair& b) const;
  NodeAt here() const { return {&view_.now, place_, view_.step}; }
  bool goes_past(Index face) const;
  bool stand_out(Index a, Index b) const;
  const RememberedPair* memory_of(Index segment) const;

  const StepView& view_;
  const Surface& surface_;
  Index place_;
  Index node_;
  Vec3 p_;
  std::span<const RememberedPair> remembered_;
  std::uint64_t handed_on_ = 0;  ///< bits by place in `remembered_`: another pair has taken over from it
  bool astray_ = false;          ///< the node is on the wrong side of some segment
  bool freed_ = false;           ///< a tie of the node has ended in this step
  double nearest_face_ = 0;      ///< of a face of another solid, where the contact begins [length]
};

}  // namespace crumple::contact
