// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/node_owners.hpp"

namespace crumple::constraints {

NodeOwners owners_of_nodes(const model::Model& model) {
  const auto count = static_cast<std::size_t>(model.nodes.count());
  NodeOwners owners{std::vector<std::string>(count), std::vector<std::string>(count)};
  for (const model::RigidBody& body : model.rigid_bodies)
    for (const Index node : body.nodes) owners.body[node] = "rigid body " + std::to_string(body.id);
  for (const model::SpotWeld& weld : model.spot_welds)
    for (const Index node : weld.nodes) owners.body[node] = "spot weld " + std::to_string(weld.id);
  for (const model::Rivet& rivet : model.rivets)
    for (const Index node : rivet.node) owners.joint[node] = "rivet " + std::to_string(rivet.id);
  for (const model::ConstrainedNodeSet& set : model.constrained_node_sets)
    for (const Index node : set.nodes) owners.joint[node] = "a constrained node set";
  for (const model::LinearEquation& equation : model.linear_equations)
    for (const model::LinearEquation::Term& term : equation.terms)
      owners.joint[term.node] = "a linear equation";
  for (const model::Interpolation& interpolation : model.interpolations) {
    owners.joint[interpolation.dependent] = "an interpolation";
    for (const model::Interpolation::Independent& each : interpolation.independent)
      owners.joint[each.node] = "an interpolation";
  }
  for (const model::PrescribedMotion& motion : model.prescribed_motions)
    if (motion.node != no_index) owners.joint[motion.node] = "a prescribed motion";
  for (const model::LocalSupport& support : model.local_supports)
    owners.joint[support.node] = "a support with axes of its own";
  return owners;
}

}  // namespace crumple::constraints
