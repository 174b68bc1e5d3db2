// SPDX-License-Identifier: BSD-3-Clause
#include "contact/move_apart.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/enforcement/multipliers.hpp"
#include "contact/node_segment/local_search.hpp"
#include "contact/search/global_search.hpp"
#include "contact/surface/surface.hpp"
#include "contact/tolerances.hpp"
#include "domain/build.hpp"

namespace crumple::contact {
namespace {

/// Rigid bodies and welds stay as they are.
void hold_bodies(const model::Model& model, domain::Domain& domain) {
  domain.body_of_node.assign(domain.nodes.count(), no_index);
  Index body = 0;
  const auto hold = [&](const std::vector<Index>& nodes) {
    for (const Index node : nodes) {
      domain.nodes.fixed[domain.nodes.domain_node[node]] |= domain::moved_by_body;
      domain.body_of_node[domain.nodes.domain_node[node]] = body;
    }
    ++body;
  };
  for (const model::RigidBody& rigid : model.rigid_bodies) hold(rigid.nodes);
  for (const model::SpotWeld& weld : model.spot_welds) hold(weld.nodes);
}

/// Moves the nodes of one contact once; returns the deepest overlap found before.
double move_once(const model::Model& model, const model::Contact& contact, domain::Domain& domain) {
  const Surface surface = build_surface(model, domain, contact);
  model::Contact without_friction = contact;
  without_friction.static_friction = without_friction.dynamic_friction = 0;
  without_friction.part_friction = {};
  Multipliers multipliers(surface, without_friction);
  // All rests, so that the predicted places are the present ones.
  const Kinematics at_rest = multipliers.predict(domain, 1, 1);
  GlobalSearch search(surface, model.search, domain.execution.threads);
  search.update(at_rest, false, {});
  LocalSearch local(surface);
  std::vector<Touch> touches;
  double deepest = 0;
  for (const ContactPair& pair : local.find(at_rest, search, {}, true, {})) {
    touches.push_back(touch_of(surface, pair));
    touches.back().penetration = pair.offset;
    deepest = std::max(deepest, pair.offset);
  }
  if (deepest <= tolerances::negligible_overlap * surface.mean_edge) return 0;
  multipliers.solve(touches);
  for (const Index node : surface.nodes) domain.nodes.reference[node] = at_rest.position[node];
  domain.nodes.position = domain.nodes.reference;
  return deepest;
}

}  // namespace

MovedApart move_apart(model::Model& model, const domain::Execution& execution) {
  domain::Domain domain = domain::build(model, execution);
  std::fill(domain.nodes.velocity.begin(), domain.nodes.velocity.end(), Vec3{});
  hold_bodies(model, domain);
  // All alike: a heavy node need not stay.
  domain.nodes.mass.assign(domain.nodes.mass.size(), 1.0);
  const AlignedArray<Vec3> before = domain.nodes.reference;
  MovedApart result;
  for (int round = 0; round < tolerances::most_moving_rounds; ++round) {
    result.left = 0;
    for (const model::Contact& contact : model.contacts)
      result.left = std::max(result.left, move_once(model, contact, domain));
    if (result.left == 0) break;
  }
  for (Index i = 0; i < domain.nodes.count(); ++i) {
    const double moved = norm(domain.nodes.reference[i] - before[i]);
    if (moved == 0) continue;
    const Index node = domain.nodes.model_node[i];
    const Vec3& x = domain.nodes.reference[i];
    model.nodes.position[node] = {x.x, x.y, x.z};
    ++result.nodes;
    if (moved <= result.farthest) continue;
    result.farthest = moved;
    result.farthest_node = model.nodes.id[node];
  }
  return result;
}

}  // namespace crumple::contact
