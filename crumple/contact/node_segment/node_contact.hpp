// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "contact/enforcement/contact_pair.hpp"
#include "contact/node_segment/local_search.hpp"
#include "contact/node_segment/ragged_nodes.hpp"
#include "contact/node_segment/solid_overlaps.hpp"
#include "contact/search/detector.hpp"
#include "contact/search/global_search.hpp"
#include "contact/surface/surface.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// The contact of nodes with segments: global search, local search, what pairs remember, nodes that start
/// deep in solids, and nodes that are lost.
class NodeContact final : public Detector {
 public:
  /// Throws Error for an unknown search method or an expansion that does not exceed the contact distance.
  NodeContact(const Surface& surface, const model::SearchSettings& settings, int threads);

  /// Those that find() found, until the next one. Edges reduce the force of some (EdgeContact).
  const std::span<ContactPair>& pairs() const { return pairs_; }

  std::string method() const override { return method_; }
  double update(const domain::Domain& domain, const Kinematics& motion, bool surface_changed,
                bool start) override;
  double find(const domain::Domain& domain, const Kinematics& motion, bool start,
              domain::ContactReport& report) override;
  void find_nothing() override { pairs_ = {}; }
  Index count() const override { return static_cast<Index>(pairs_.size()); }
  void fill(const Kinematics& motion, std::span<Touch> touches) const override;
  void correct(const Kinematics& motion, std::span<const Touch> touches) override;
  void remember(const Kinematics& motion, std::span<const Touch> touches, TouchNotes& notes) override;
  void append_initial_overlaps(std::vector<domain::InitialOverlap>& overlaps) const override;
  void verify(const Kinematics& motion) override { search_.verify(motion); }
  void report(domain::ContactReport& report, ContactStatistics& statistics) const override;
  void inspect(const domain::Domain& domain, domain::ContactInspection& seen) const override;
  void declare_search(domain::StateList& list) override { search_.declare(list); }
  void declare_pairs(domain::StateList& list) override;
  void resume(const domain::Domain& domain, const Kinematics& motion) override;

 private:
  double drop_eroded();
  void find_deep(const domain::Domain& domain, const Kinematics& motion);
  RememberedPair memory_of(const ContactPair& pair, const Touch& touch, const Configuration& x) const;

  const Surface* surface_;
  std::string method_;
  GlobalSearch search_;
  LocalSearch local_;
  RaggedNodes ragged_;
  std::span<ContactPair> pairs_;
  std::vector<RememberedPair> remembered_;
  bool some_are_behind_ = false;        ///< nodes of `remembered_`
  std::vector<DeepPair> deep_;          ///< at the start, ascending
  std::vector<Index> inside_at_start_;  ///< places of nodes in solids, ascending
};

}  // namespace crumple::contact
