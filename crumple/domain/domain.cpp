// SPDX-License-Identifier: BSD-3-Clause
#include "domain/domain.hpp"

#include "base/state_hash.hpp"

namespace crumple::domain {

std::uint64_t StateList::hash() const {
  StateHash hash;
  for (const StateArray& array : arrays_)
    if (array.in_hash) hash.add(array.bytes);
  return hash.value();
}

namespace {

void declare_block(const std::string& name, Entity entity, ElementBlock& block, StateList& list) {
  list.add(name, "by item", entity, block.components, std::span(block.float_state));
  list.add(name, "by item", entity, block.components, std::span(block.double_state));
  list.add(name + "_energy", "energy", entity, 4, std::span(block.energy));
  list.keep(name + "_internal_energy", "energy", Entity::Run, block.internal_energy);
  list.keep(name + "_hourglass_energy", "energy", Entity::Run, block.hourglass_energy);
  list.keep(name + "_damping_energy", "energy", Entity::Run, block.damping_energy);
  list.keep(name + "_eroded_energy", "energy", Entity::Run, block.eroded_energy);
  list.add(name + "_eroded", "-", Entity::Run, 1, std::span(&block.eroded, 1));
  list.keep_list(name + "_scaled_mass", "by item", entity, 2, block.scaled);
}

void keep_body(RigidBody& body, StateList& list) {
  const auto keep = [&](const char* name, const char* unit, auto& value) {
    list.keep(std::string("body_") + name, unit, Entity::RigidBody, value);
  };
  keep("mass", "mass", body.mass);
  keep("principal_inertia", "mass*length^2", body.principal_inertia);
  keep("acceleration", "length/time^2", body.acceleration);
  keep("kinetic_energy", "energy", body.kinetic_energy);
  keep("reaction", "force", body.reaction);
  keep("reaction_moment", "force*length", body.reaction_moment);
  keep("held_translation", "-", body.held_translation);
  keep("prescribed_velocity", "length/time", body.prescribed_velocity);
  keep("previous_velocity", "length/time", body.previous_velocity);
  keep("previous_spin", "1/time", body.previous_spin);
  keep("previous_momentum", "mass*length^2/time", body.previous_momentum);
  keep("impulse", "force*time", body.impulse);
  keep("angular_impulse", "force*length*time", body.angular_impulse);
}

void keep_contact(ContactReport& contact, StateList& list) {
  const auto keep = [&](const char* name, const char* unit, auto& value) {
    list.keep(std::string("contact_") + name, unit, Entity::Contact, value);
  };
  keep("searches", "-", contact.searches);
  keep("candidates", "-", contact.candidates);
  keep("active_pairs", "-", contact.active_pairs);
  keep("penetration", "length", contact.penetration);
  keep("worst_penetration", "length", contact.worst_penetration);
  keep("worst_node", "-", contact.worst_node);
  keep("deepest", "by item", contact.deepest);
  keep("held_energy", "energy", contact.stored_energy);
  keep("worst_intersections", "by item", contact.worst_intersections);
  keep("damping_energy", "energy", contact.damping_energy);
  keep("force", "force", contact.force);
  keep("mass", "mass", contact.mass);
  keep("times", "s", contact.times);
  keep("withheld", "by item", contact.withheld);
  keep("lost_nodes", "by item", contact.lost_nodes);
  keep("lost_edges", "by item", contact.lost_edges);
  keep("eroded_energy", "energy", contact.eroded_energy);
  keep("overlap_forces", "by item", contact.overlap_forces);
  list.keep_list("contact_initial_overlaps", "by item", Entity::Contact, 1, contact.initial_overlaps);
}

void declare_body(RigidBody& body, StateList& list) {
  const auto add = [&](const char* name, const char* unit, int components, auto& value) {
    list.add(std::string("body_") + name, unit, Entity::RigidBody, components, std::span(&value, 1));
  };
  add("centre", "length", 3, body.centre);
  add("turn", "-", 4, body.turn);
  add("next_turn", "-", 4, body.next_turn);
  add("velocity", "length/time", 3, body.velocity);
  add("angular_momentum", "mass*length^2/time", 3, body.angular_momentum);
  add("angular_velocity", "1/time", 3, body.angular_velocity);
  add("spin", "1/time", 3, body.spin);
  add("deferred_work", "energy", 1, body.deferred_work);
  add("held_rotation", "-", 3, body.held_rotation);
  add("prescribed_spin", "1/time", 3, body.prescribed_spin);
  add("active", "-", 1, body.active);
  keep_body(body, list);
}

}  // namespace

std::vector<ElementBlock*> Domain::blocks() {
  std::vector<ElementBlock*> all;
  for (ShellBlock& block : shells) all.push_back(&block);
  for (SolidBlock& block : solids) all.push_back(&block);
  for (BeamBlock& block : beams) all.push_back(&block);
  for (DiscreteBlock& block : discretes) all.push_back(&block);
  return all;
}

std::vector<const ElementBlock*> Domain::blocks() const {
  std::vector<const ElementBlock*> all;
  for (const ShellBlock& block : shells) all.push_back(&block);
  for (const SolidBlock& block : solids) all.push_back(&block);
  for (const BeamBlock& block : beams) all.push_back(&block);
  for (const DiscreteBlock& block : discretes) all.push_back(&block);
  return all;
}

void Domain::declare(StateList& list) {
  list.add("position", "length", Entity::Node, 3, std::span(nodes.position));
  list.add("velocity", "length/time", Entity::Node, 3, std::span(nodes.velocity));
  list.add("angular_velocity", "1/time", Entity::Node, 3, std::span(nodes.angular_velocity));
  list.add("mass", "mass", Entity::Node, 1, std::span(nodes.mass));
  list.add("inertia", "mass*length^2", Entity::Node, 1, std::span(nodes.inertia));
  list.keep_list("fixed", "-", Entity::Node, 1, nodes.fixed);
  list.keep_list("carried_mass", "mass", Entity::Node, 1, nodes.carried_mass);
  list.keep_list("carried_inertia", "mass*length^2", Entity::Node, 1, nodes.carried_inertia);
  list.keep_list("acceleration", "length/time^2", Entity::Node, 3, nodes.acceleration);
  list.keep_list("contact_force", "force", Entity::Node, 3, contact_force);
  list.keep_list("body_of_node", "-", Entity::Node, 1, body_of_node);
  for (ShellBlock& block : shells) {
    // A part has one block of quadrilaterals and one of triangles at most, of each layup.
    const bool triangles = model::is_triangular(block.formulation);
    std::string name = (triangles ? "triangle_state_" : "shell_state_") + std::to_string(block.part);
    if (block.has_own_layup) name += "_layup_" + std::to_string(block.layup);
    declare_block(name, Entity::Shell, block, list);
  }
  for (SolidBlock& block : solids)
    declare_block("solid_state_" + std::to_string(block.part), Entity::Solid, block, list);
  for (BeamBlock& block : beams)
    declare_block("beam_state_" + std::to_string(block.part), Entity::Beam, block, list);
  for (DiscreteBlock& block : discretes)
    declare_block("discrete_state_" + std::to_string(block.part), Entity::Discrete, block, list);
  for (WallReport& wall : walls) {
    list.add("wall_impulse", "force*time", Entity::Wall, 3, std::span(&wall.impulse, 1));
    list.add("wall_energy", "energy", Entity::Wall, 1, std::span(&wall.energy, 1));
    list.add("wall_deferred_energy", "energy", Entity::Wall, 1, std::span(&wall.deferred, 1));
    list.add("wall_normal_impulse", "force*time", Entity::Wall, 1, std::span(&wall.normal_impulse, 1));
    list.add("wall_deferred_work", "energy", Entity::Wall, 1, std::span(&wall.deferred_work, 1));
    list.add("wall_displacement", "length", Entity::Wall, 3, std::span(&wall.displacement, 1));
    // That of the others follows from their curves.
    if (wall.mass > 0)
      list.add("wall_velocity", "length/time", Entity::Wall, 3, std::span(&wall.velocity, 1));
    list.keep("wall_report", "by item", Entity::Wall, wall);
  }
  for (RigidBody& body : rigid_bodies) declare_body(body, list);
  for (ContactReport& contact : contacts) {
    list.add("contact_energy", "energy", Entity::Contact, 1, std::span(&contact.energy, 1));
    list.add("friction_energy", "energy", Entity::Contact, 1, std::span(&contact.friction_energy, 1));
    keep_contact(contact, list);
  }
  for (Tie& tie : ties) {
    list.add("tie_energy", "energy", Entity::Contact, 1, std::span(&tie.energy, 1));
    list.add("tie_released", "-", Entity::Contact, 1, std::span(&tie.released, 1));
    list.add("tie_broken", "-", Entity::Contact, 1, std::span(&tie.broken, 1));
    list.keep_list("tie_holds", "-", Entity::Contact, 1, tie.holds);
    list.keep("tie_force", "force", Entity::Contact, tie.force);
    list.keep("tie_dissipated", "energy", Entity::Contact, tie.dissipated);
    list.keep("tie_opening", "length", Entity::Contact, tie.opening);
  }
  for (Embedding& embedding : embeddings) {
    list.add("embedding_lost", "energy", Entity::Contact, 1, std::span(&embedding.lost, 1));
    list.add("embedding_released", "-", Entity::Contact, 1, std::span(&embedding.released, 1));
    list.keep_list("embedding_holds", "-", Entity::Contact, 1, embedding.holds);
    list.keep("embedding_force", "force", Entity::Contact, embedding.force);
  }
  for (ControlVolumeReport& volume : control_volumes)
    list.keep("control_volume_report", "by item", Entity::Run, volume);
  for (WeldReport& weld : welds) list.keep("weld_report", "by item", Entity::Run, weld);
  for (JointReport& joint : joints) list.keep("joint_report", "by item", Entity::RigidBody, joint);
  for (JointStiffnessReport& stiffness : joint_stiffnesses)
    list.keep("joint_stiffness_report", "by item", Entity::RigidBody, stiffness);
  list.keep_list("transducers", "by item", Entity::Contact, 1, transducers);
  list.keep("energy_ledger", "energy", Entity::Run, energy);
  list.keep("added_mass", "mass", Entity::Run, added_mass);
  list.keep("stage_times", "s", Entity::Run, times);
  list.keep("element_limit", "time", Entity::Run, clock.element_limit);
  list.add("time", "time", Entity::Run, 1, std::span(&clock.time, 1));
  list.add("step", "time", Entity::Run, 1, std::span(&clock.step, 1));
  list.add("cycle", "-", Entity::Run, 1, std::span(&clock.cycle, 1));
}

}  // namespace crumple::domain
