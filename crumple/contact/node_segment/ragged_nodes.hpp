// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/enforcement/contact_pair.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"

namespace crumple::contact {

/// The nodes of segments that have eroded or come to light: nodes slide off the rims that erosion leaves, and
/// nothing returns what their springs hold.
class RaggedNodes {
 public:
  explicit RaggedNodes(const Surface& surface) : surface_(&surface), active_before_(surface.active) {}

  /// To be called when segments may have eroded.
  void follow();

  /// What the springs of remembered pairs hold that no pair of `pairs` continues, at such nodes [energy].
  double lost_energy(std::span<const RememberedPair> remembered, std::span<const ContactPair> pairs,
                     const domain::Domain& domain) const;

  /// Whether the node of a pair or its segment is among them.
  bool has(const RememberedPair& pair) const;

  void declare(domain::StateList& list);
  /// To be called once after a restart, when the surface has followed the erosion. Throws Error if what was
  /// declared does not fit.
  void resume();

 private:
  const Surface* surface_;
  std::vector<std::uint8_t> active_before_;  ///< Surface::active at the last look
  std::vector<std::uint8_t> marked_;         ///< by place; empty where nothing has eroded
};

}  // namespace crumple::contact
