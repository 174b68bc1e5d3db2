// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::elements {

/// How easily the rigid bodies of a model move where something pulls at one of their nodes that has no mass
/// of its own. For stable steps: the bodies themselves are made later.
class BodyResponse {
 public:
  /// The masses of the nodes must be there.
  BodyResponse(const model::Model& model, const domain::Domain& domain);

  /// Upper bound of the velocity that an impulse of one gives to the node, whatever its direction [1/mass];
  /// if `turning` of the angular velocity by an angular impulse [1/(mass * length^2)]. Zero without a body.
  double at(Index node, bool turning) const;

  /// The same for all nodes of a body without mass (if `turning` without rotary inertia) of their own, so
  /// that what pulls at them can be summed; for others the node itself.
  Index shared_node(Index node, bool turning) const;

 private:
  struct Body {
    double mass = 0;
    math::Vec3 centre;
    double inertia = 0;  ///< the smallest principal moment that is not zero
    Index first = no_index;
  };
  Body body_of(const model::RigidBody& given) const;

  const domain::NodeFields& nodes_;
  std::vector<Body> bodies_;
  std::vector<Index> body_of_node_;  ///< empty without bodies
};

}  // namespace crumple::elements
