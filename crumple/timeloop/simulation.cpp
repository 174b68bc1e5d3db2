// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/simulation.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "constraints/embedded_search.hpp"
#include "contact/tied/tie_search.hpp"
#include "domain/build.hpp"
#include "domain/state_snapshot.hpp"
#include "elements/elements.hpp"
#include "materials/common/shell_material.hpp"
#include "timeloop/guards.hpp"
#include "timeloop/impedances.hpp"
#include "timeloop/initial_motion.hpp"

namespace crumple::timeloop {
namespace {

/// Null shells alone set no step.
void require_stiffness(const model::Model& model) {
  const auto stiff = [&](const model::ShellElement& shell) {
    return materials::has_stiffness(model.materials[model.parts[shell.part].material].law);
  };
  if (model.solids.empty() && model.beams.empty() && model.discretes.empty() && !model.shells.empty() &&
      std::none_of(model.shells.begin(), model.shells.end(), stiff))
    throw Error(
        "No element of the model has any stiffness (all materials are null): there is no time step to take.");
}

/// The domain with its elements and their masses.
domain::Domain prepared_domain(const model::Model& model, const domain::Execution& execution) {
  domain::Domain domain = domain::build(model, execution);
  require_stiffness(model);
  contact::find_ties(model, domain);
  constraints::find_embedded_beams(model, domain);
  elements::prepare_elements(model, domain);
  return domain;
}

}  // namespace

Simulation::Simulation(const model::Model& model, const domain::Execution& execution)
    : model_(&model),
      domain_(prepared_domain(model, execution)),
      sections_(model, domain_),
      rigid_bodies_(model, domain_),
      joints_(model, domain_),
      joint_stiffnesses_(model, domain_),
      spot_welds_(model, domain_),
      tied_nodes_(model, domain_),
      node_sets_(model, domain_),
      linear_equations_(model, domain_),
      interpolations_(model, domain_),
      rivets_(model, domain_),
      prescribed_motions_(model, domain_),
      rigid_body_stoppers_(model, domain_),
      local_constraints_(model, domain_),
      supports_(model, domain_),
      nodal_loads_(model, domain_),
      pressure_loads_(model, domain_),
      air_blasts_(model, domain_),
      control_volumes_(model, domain_),
      body_loads_(model),
      rigid_body_loads_(model),
      follower_loads_(model, domain_),
      inertia_fields_(model, domain_),
      mass_damping_(model, domain_),
      relative_dampings_(model, domain_),
      viscous_boundary_(model, domain_, impedances_of_parts(model)),
      terminations_(model, domain_) {
  for (const model::RigidWall& wall : model.rigid_walls) {
    domain_.walls.push_back({.id = wall.id});
    walls_.emplace_back(model, wall, domain_, static_cast<Index>(domain_.walls.size()) - 1);
  }
  for (const model::Contact& contact : model.contacts) {
    has_multipliers_ = has_multipliers_ || contact.enforcement == model::Enforcement::Multipliers;
    domain_.contacts.push_back({.id = contact.id});
    contacts_.emplace_back(model, domain_, contact, static_cast<Index>(domain_.contacts.size()) - 1);
    contacts_.back().describe(domain_.contacts.back());
  }
  for (const model::ForceTransducer& transducer : model.force_transducers) {
    domain_.transducers.push_back({.id = transducer.id});
    transducers_.emplace_back(model, domain_, transducer);
    domain_.transducers.back().mass = transducers_.back().mass();
  }
  for (Index tie = 0; tie < static_cast<Index>(domain_.ties.size()); ++tie)
    if (domain_.ties[tie].springs() > 0) tie_springs_.emplace_back(model, domain_, tie);
  if (!model.output.history_nodes.empty()) keep_accelerations();
  initial_stress_energy_ = initial_stress_energy(model, domain_);
}

bool Simulation::finished() const {
  const model::Control& control = model_->control;
  const domain::Clock& clock = domain_.clock;
  // A step that ends within a millionth of itself before the end time counts as arrived.
  return terminations_.met() || clock.time >= control.end_time - 1e-6 * next_step_ ||
         (control.end_cycle > 0 && clock.cycle >= control.end_cycle);
}

/// What a dynamic relaxation leaves behind, and the first part of all that a run can be taken up from.
domain::StateList Simulation::deformation() {
  domain::StateList list;
  domain_.declare(list);
  for (contact::Interface& contact : contacts_) contact.declare(list);
  for (contact::TieSprings& springs : tie_springs_) springs.declare(list);
  joints_.declare(list);
  joint_stiffnesses_.declare(list);
  tied_nodes_.declare(list);
  return list;
}

domain::StateList Simulation::state() {
  domain::StateList list = deformation();
  prescribed_motions_.declare(list);
  local_constraints_.declare(list);
  list.add("next_step", "time", domain::Entity::Run, 1, std::span(&next_step_, 1));
  held_step_.declare(list);
  list.keep("start_loss", "energy", domain::Entity::Run, start_loss_);
  list.keep("start_work", "energy", domain::Entity::Run, start_work_);
  list.keep("largest_step", "time", domain::Entity::Run, largest_step_);
  list.keep_list("previous_velocity", "length/time", domain::Entity::Node, 3, previous_velocity_);
  for (constraints::RigidWall& wall : walls_) wall.declare(list);
  nodal_loads_.declare(list);
  pressure_loads_.declare(list);
  air_blasts_.declare(list);
  control_volumes_.declare(list);
  body_loads_.declare(list);
  rigid_body_loads_.declare(list);
  follower_loads_.declare(list);
  inertia_fields_.declare(list);
  mass_damping_.declare(list);
  relative_dampings_.declare(list);
  viscous_boundary_.declare(list);
  terminations_.declare(list);
  if (energy_trace_) energy_trace_->declare(list);
  return list;
}

void Simulation::begin_with(Simulation& relaxed) {
  const InitialMotion motion(domain_);
  domain::StateSnapshot(relaxed.deformation()).put_back(deformation());
  motion.put_back(domain_);
  resume();
  begins_relaxed_ = true;
}

void Simulation::declare_reports(domain::StateList& list) {
  Supports::declare(domain_, list);
  sections_.declare(list);
}

void Simulation::resume() {
  domain_.nodes.publish_all();
  // A step that failed has left forces behind.
  std::fill(domain_.nodes.force.begin(), domain_.nodes.force.end(), domain::NodeForce{});
  for (domain::RigidBody& body : domain_.rigid_bodies) body.force = body.moment = math::Vec3{};
  for (contact::Interface& contact : contacts_) contact.resume(domain_);
  for (constraints::RigidWall& wall : walls_) wall.resume();
}

std::vector<domain::ContactNodeForce> Simulation::contact_node_forces() const {
  std::vector<domain::ContactNodeForce> forces;
  for (const contact::Interface& contact : contacts_) contact.append_node_forces(forces);
  return forces;
}

void Simulation::note_intersections() {
  for (const contact::Interface& contact : contacts_) contact.note_intersections(domain_);
}

void Simulation::inspect_contacts() {
  for (const contact::Interface& contact : contacts_) contact.inspect(domain_);
}

void Simulation::verify_search_every(long cycles) {
  for (contact::Interface& contact : contacts_) contact.verify_search_every(cycles);
}

void Simulation::trace_energy() {
  constexpr Index usual_groups = 32;
  if (domain_.execution.groups_per_chunk == 0) {
    domain_.execution.groups_per_chunk = usual_groups;
    domain::deal_out(domain_);
  }
  energy_trace_.emplace(domain_);
}

domain::EnergyTraceReport Simulation::energy_trace() const {
  constexpr std::size_t worst_elements = 10;
  domain::EnergyTraceReport report;
  if (!energy_trace_) return report;
  report.parts = energy_trace_->parts(*model_, domain_);
  report.worst = energy_trace_->worst(*model_, domain_, worst_elements);
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const domain::ContactReport& contact = domain_.contacts[i];
    report.contacts.push_back(
        {"contact", contact.id, contact.energy, contact.energy - contacts_[i].stored_energy()});
  }
  return report;
}

void Simulation::keep_accelerations() {
  keeps_accelerations_ = true;
  rigid_bodies_.keep_accelerations();
  tied_nodes_.keep_accelerations();
}

}  // namespace crumple::timeloop
