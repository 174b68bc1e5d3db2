// SPDX-License-Identifier: BSD-3-Clause
#include "elements/mass_scaling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "elements/line/beam_task.hpp"
#include "elements/shell/shell_geometry.hpp"
#include "elements/shell/shell_task.hpp"
#include "elements/solid/solid_task.hpp"
#include "elements/stable_steps.hpp"

namespace crumple::elements {
namespace {

using domain::Domain;
using math::Vec3;

/// An element gets a step this much longer than the kept one, so that it does not need more in the next
/// cycle.
constexpr double headroom = 1.02;

/// Before the first step there is nothing to balance yet.
void book(Domain& domain, double energy) {
  if (domain.clock.cycle > 0) domain.energy.external_work += energy;
}

/// Takes over mass and rotary inertia at a node, whose velocities stay.
void add_at(Domain& domain, Index node, double mass, double inertia) {
  domain::NodeFields& nodes = domain.nodes;
  nodes.mass[node] += mass;
  nodes.inertia[node] += inertia;
  domain.added_mass += mass;
  const Index body = domain.body_of_node.empty() ? no_index : domain.body_of_node[node];
  if (body == no_index || !domain.rigid_bodies[body].active) {
    const Vec3& velocity = nodes.velocity[node];
    const Vec3& spin = nodes.angular_velocity[node];
    book(domain, 0.5 * (mass * dot(velocity, velocity) + inertia * dot(spin, spin)));
    return;
  }
  domain::RigidBody& moved = domain.rigid_bodies[body];
  const Vec3 arm = nodes.position[node] - moved.centre;
  // As if half of the mass were on the far side of the centre, which stays where it is, and turning were as
  // hard about the arm as across it: the body is heavier at the node by the mass at least.
  const double turning = mass * dot(arm, arm) + inertia;
  moved.mass += mass;
  moved.principal_inertia += Vec3{turning, turning, turning};
  moved.angular_momentum += turning * moved.spin;
  book(domain, 0.5 * (mass * dot(moved.velocity, moved.velocity) + turning * dot(moved.spin, moved.spin)));
}

void set_scale(domain::ShellBlock& block, Index place, double ratio) {
  const Index item =
      from_numbers<ShellConstants<double>>(block.element_constants).own + element_state::step_scale;
  block.set_state(place, item, ratio * block.state(place, item));
}
void set_scale(domain::SolidBlock& block, Index place, double ratio) {
  const Index item =
      from_numbers<SolidConstants<double>>(block.element_constants).own + solid_state::step_scale;
  block.set_state(place, item, ratio * block.state(place, item));
}
void set_scale(domain::BeamBlock& block, Index place, double ratio) {
  block.set_state(place, beam_state::stable_step, ratio * block.state(place, beam_state::stable_step));
}

double share_of(const domain::ShellBlock& block, Index place, Index corner) {
  return mass_shares(block.nodes_of(place))[static_cast<std::size_t>(corner)];
}
double share_of(const domain::SolidBlock& block, Index /*place*/, Index corner) {
  return block.mass_share(corner);
}
double share_of(const domain::ElementBlock& block, Index /*place*/, Index /*corner*/) {
  return 1.0 / block.corners;
}

/// Scales the elements of a group that need it; returns their shortest step then [time].
template <class Block>
double scale_group(Domain& domain, Block& block, Index group, double found) {
  const Index begin = group * lanes;
  const Index end = std::min(begin + lanes, block.elements);
  double shortest = 1e30;
  for_each_step(domain, block, begin, end, [&](Index, double step) { shortest = std::min(shortest, step); });
  // What the kernel's step has beyond that of the geometry: viscous pressure and pressure of contact inside.
  const double reduced = std::min(1.0, found / shortest);
  const double wanted = headroom * domain.clock.kept_step;
  double left = 1e30;
  for_each_step(domain, block, begin, end, [&](Index place, double geometric) {
    const double step = reduced * geometric;
    const bool enough = step >= domain.clock.kept_step;
    left = std::min(left, enough ? step : wanted);
    if (enough) return;
    const double ratio = wanted / step;
    domain::ScaledMass& own = block.scaled[static_cast<std::size_t>(place)];
    const double more = ratio * ratio - 1;
    for (Index corner = 0; corner < block.corners; ++corner) {
      const double share = share_of(block, place, corner) * more;
      if (share > 0) add_at(domain, block.node_of(place, corner), share * own.mass, share * own.inertia);
    }
    own.mass *= 1 + more;
    own.inertia *= 1 + more;
    set_scale(block, place, ratio);
  });
  return left;
}

/// Scales the elements of a block that need it and brings clock.element_limit up to date.
template <class Block>
void scale_block(Domain& domain, Block& block) {
  domain::Clock& clock = domain.clock;
  for (Index group = 0; group < static_cast<Index>(block.group_step.size()); ++group) {
    double& step = block.group_step[static_cast<std::size_t>(group)];
    if constexpr (requires { set_scale(block, group, step); })
      if (step >= 0 && step < clock.kept_step && !block.scaled.empty())
        step = scale_group(domain, block, group, step);
    clock.element_limit = std::min(clock.element_limit, std::fabs(step));
  }
}

}  // namespace

void keep_step(Domain& domain) {
  domain::Clock& clock = domain.clock;
  if (!(clock.kept_step > 0) || clock.element_limit >= clock.kept_step) return;
  clock.element_limit = clock.rigid_limit;
  for (domain::ShellBlock& block : domain.shells) scale_block(domain, block);
  for (domain::SolidBlock& block : domain.solids) scale_block(domain, block);
  for (domain::BeamBlock& block : domain.beams) scale_block(domain, block);
  for (domain::DiscreteBlock& block : domain.discretes) scale_block(domain, block);
}

}  // namespace crumple::elements
