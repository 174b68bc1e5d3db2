// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "base/index.hpp"
#include "contact/enforcement/contact_pair.hpp"
#include "contact/node_segment/solid_overlaps.hpp"
#include "contact/search/global_search.hpp"
#include "contact/surface/inside_outside.hpp"
#include "contact/surface/kinematics.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"

namespace crumple::contact {

struct StepView;

/// The local search: which candidates are in contact now, where, and how deep. A node has a contact with
/// every segment that is a nearest place of the surface around it; of connected segments that push in almost
/// the same direction the dividing planes choose one (docs/theory/contact.md).
class LocalSearch {
 public:
  explicit LocalSearch(const Surface& surface) : surface_(&surface) {}

  /// Finds the contacts. `remembered` are the pairs of the step before, in order.
  /// Candidates that are far are put off. With `tracking` every contact is allowed the penetration that it
  /// has now (first step of a contact), those of `deep` with the faces named there. The result is ordered by
  /// (node, segment) and the same for any number of threads; it holds until the next call.
  std::span<ContactPair> find(const Kinematics& motion, GlobalSearch& candidates,
                              std::span<const RememberedPair> remembered, bool tracking,
                              std::span<const DeepPair> deep);

 private:
  /// The contacts of the nodes of one part, into its list.
  void find_in(Index part, const StepView& view, std::span<const RememberedPair> remembered);

  const Surface* surface_;
  std::vector<std::vector<ContactPair>> parts_;
  std::vector<ContactPair> pairs_;
};

}  // namespace crumple::contact
