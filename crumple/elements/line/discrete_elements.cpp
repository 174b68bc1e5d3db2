// SPDX-License-Identifier: BSD-3-Clause
#include "elements/line/discrete_elements.hpp"

#include <algorithm>

namespace crumple::elements {
namespace {

using domain::DiscreteBlock;
using domain::NodeForce;
using math::Vec3;

/// One spring or damper at time n.
struct Motion {
  Vec3 axis;
  double deformation = 0;
  double rate = 0;
};

Motion motion_of(const domain::Domain& domain, const DiscreteBlock& block, Index place) {
  namespace item = discrete_state;
  const domain::NodeFields& nodes = domain.nodes;
  const auto [first, second] = block.nodes_of(place);
  const bool grounded = block.state(place, item::grounded) != 0;
  const auto& speed = block.torsional ? nodes.angular_velocity : nodes.velocity;
  const Vec3 from_ground{};
  const Vec3 span = (grounded ? from_ground : nodes.position[second]) - nodes.position[first];
  const Vec3 relative = (grounded ? from_ground : speed[second]) - speed[first];
  Motion motion;
  motion.axis = {block.state(place, item::axis), block.state(place, item::axis + 1),
                 block.state(place, item::axis + 2)};
  double distance = dot(span, motion.axis);
  if (dot(motion.axis, motion.axis) == 0) {
    distance = norm(span);
    motion.axis = (1 / distance) * span;
  }
  motion.rate = dot(relative, motion.axis);
  motion.deformation = block.torsional
                           ? block.state(place, item::deformation) + domain.clock.step * motion.rate
                           : distance - block.state(place, item::reference);
  return motion;
}

/// Pulls the first end along the axis and the second against it.
void pull(domain::Domain& domain, const DiscreteBlock& block, Index place, const Vec3& pulled) {
  const std::size_t first = (static_cast<std::size_t>(place / lanes) * 2) * lanes + place % lanes;
  NodeForce& near = domain.nodes.force[block.target[first]];
  NodeForce& far = domain.nodes.force[block.target[first + lanes]];
  const bool grounded = block.state(place, discrete_state::grounded) != 0;
  for (int axis = 0; axis < 3; ++axis) {
    (block.torsional ? near.moment : near.force)[axis] += pulled[axis];
    if (!grounded) (block.torsional ? far.moment : far.force)[axis] -= pulled[axis];
  }
}

}  // namespace

void add_discrete_forces(domain::Domain& domain, DiscreteBlock& block, const domain::Chunk& chunk,
                         ElementSums& sums) {
  namespace item = discrete_state;
  const DiscreteLaw law(block.material_constants);
  sums = {};
  for (Index place = chunk.first_group * lanes; place < std::min(chunk.last_group * lanes, block.elements);
       ++place) {
    const Motion motion = motion_of(domain, block, place);
    DiscreteHistory history{block.state(place, item::plastic), block.state(place, item::hardening)};
    const double before = block.state(place, item::force);
    const double change = motion.deformation - block.state(place, item::deformation);
    const double force = block.state(place, item::scale) * law.force({.deformation = motion.deformation,
                                                                      .change = change,
                                                                      .rate = motion.rate,
                                                                      .time = domain.clock.time,
                                                                      .step = domain.clock.step},
                                                                     history);
    const auto group = static_cast<std::size_t>(place / lanes);
    const double step = block.state(place, item::stable_step);
    block.energy[group].internal += 0.5 * (before + force) * change;
    sums.shortest_step = std::min(sums.shortest_step, step);
    if (!block.group_step.empty())
      block.group_step[group] = place % lanes == 0 ? step : std::min(block.group_step[group], step);
    block.set_state(place, item::deformation, motion.deformation);
    block.set_state(place, item::force, force);
    block.set_state(place, item::plastic, history.plastic);
    block.set_state(place, item::hardening, history.hardening);
    pull(domain, block, place, force * motion.axis);
  }
}

}  // namespace crumple::elements
