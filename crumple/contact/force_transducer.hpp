// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "contact/interface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// Measures the force that all contacts together put on a surface, or what of it comes from a second surface.
class ForceTransducer {
 public:
  ForceTransducer(const model::Model& model, const domain::Domain& domain,
                  const model::ForceTransducer& transducer);

  /// Force on the first side now [force]. A point counts as one of a side if all nodes it is the mean of are.
  Vec3 measure(const std::vector<Interface>& contacts) const;
  /// What one contact adds to it.
  Vec3 measure(const Interface& contact) const;
  /// Of the nodes of the first side [mass].
  double mass() const { return mass_; }

 private:
  std::vector<std::uint8_t> side_of_node_;  ///< by domain node; bits as in Surface::node_side
  bool has_second_ = false;
  double mass_ = 0;
};

}  // namespace crumple::contact
