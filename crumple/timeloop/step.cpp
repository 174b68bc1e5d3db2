// SPDX-License-Identifier: BSD-3-Clause
//
// The time step. Central differences with a variable step (DESIGN 2.2): positions and forces live at times n,
// velocities at n + 1/2. On entry to step() the velocities are already half a step ahead; on exit everything
// that has a time belongs to n+1, and the velocities are half a step ahead of it again.

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/stopwatch.hpp"
#include "elements/elements.hpp"
#include "elements/mass_scaling.hpp"
#include "timeloop/guards.hpp"
#include "timeloop/motion.hpp"
#include "timeloop/simulation.hpp"
#include "timeloop/start_loss.hpp"
#include "timeloop/trouble.hpp"

namespace crumple::timeloop {
namespace {

/// No step is longer than this times the stable step at the start: elements that fly apart do not take the
/// clock with them.
constexpr double step_growth_limit = 10.0;

/// From one step to the next it grows by this factor at most: the energy of variable steps is kept to the
/// square of their change, and the loss of the smallest element would change it many times over.
constexpr double growth_in_a_cycle = 1.1;

/// The next step over the last one, below which the forces of contacts that ask for it are computed again.
constexpr double much_shorter = 0.9;

/// Multipliers throw nodes to and fro from step to step; steps that change with the forces would make energy
/// of it. So the step stays as long as it uses most of what is allowed, and changes to the middle of that.
double steady_step(double last, double allowed) {
  constexpr double least_use = 0.9;
  constexpr double middle_use = 0.95;
  return last <= allowed && last >= least_use * allowed ? last : middle_use * allowed;
}

/// LCTM: what its curve allows at a time; a zero and the time behind its end allow all [time].
double curve_limit(const model::Model& model, double time) {
  constexpr double all = std::numeric_limits<double>::max();
  if (model.control.step_curve == no_index) return all;
  const model::Curve& curve = model.curves[model.control.step_curve];
  const double limit = time <= curve.abscissa.back() ? curve.at(time) : 0;
  return limit > 0 ? limit : all;
}

}  // namespace

void Simulation::start() {
  StartLoss start_loss(domain_);
  compute_forces(&start_loss);
  choose_step();
  const AlignedArray<math::Vec3>& velocity = domain_.nodes.velocity;
  if (keeps_previous_velocity()) previous_velocity_ = velocity;
  tied_nodes_.remember(domain_);
  const constraints::KineticChange carried = tied_nodes_.carried_energy(domain_);
  domain_.energy.kinetic = kinetic_energy(domain_, velocity, velocity) + carried.translational +
                           rotational_energy(domain_) + carried.rotational +
                           constraints::RigidBodies::kinetic_energy(domain_) +
                           constraints::RigidWall::kinetic_energy(domain_);
  close_gaps(0.5 * next_step_);
  balance();
  domain_.energy.initial_total = domain_.energy.total();
  kick(0.5 * next_step_);
  const StartLoss::Left left = start_loss.of_kick(domain_, 0.5 * next_step_);
  // What holds the balance of a relaxed model dissipates nothing in that.
  start_loss_ = (begins_relaxed_ ? 0 : left.inner) + viscous_boundary_.start_loss();
  start_work_ = begins_relaxed_ ? left.loads + left.inner : left.loads;
}

void Simulation::step() {
  drift();
  if (domain_.clock.cycle == 1) {
    if (initial_stress_energy_ == 0)
      domain_.energy.damping += start_loss_;
    else  // initial stresses dissipate nothing: there is less to balance from the first step on
      domain_.energy.initial_total -= start_loss_;
    domain_.energy.external_work -= start_work_;
  }
  compute_forces();
  choose_step();
  close_gaps(0.5 * (domain_.clock.step + next_step_));
  kick(0.5 * (domain_.clock.step + next_step_));
  domain_.energy.kinetic = kick_sums_.translational + kick_sums_.rotational +
                           constraints::RigidBodies::kinetic_energy(domain_) +
                           constraints::RigidWall::kinetic_energy(domain_);
  balance();
}

void Simulation::drift() {
  const StageTimer timer(domain_.times.integrate);
  domain::Clock& clock = domain_.clock;
  const VelocityRange velocities = move_nodes(domain_, next_step_);
  clock.step = next_step_;
  clock.time += next_step_;
  ++clock.cycle;
  const double placed = rigid_bodies_.place_nodes(domain_) + tied_nodes_.place_nodes(domain_);
  clock.way = clock.step * velocities.relative_speed() + 2 * placed;
}

void Simulation::compute_forces(StartLoss* start) {
  {
    const StageTimer timer(domain_.times.elements);
    sections_.measure(domain_);
    elements::add_element_forces(domain_, energy_trace_ ? &*energy_trace_ : nullptr);
    scale_masses();
    limit_step_without_elements();
  }
  add_contact_forces();
  for (std::size_t i = 0; i < transducers_.size(); ++i)
    domain_.transducers[i].force = transducers_[i].measure(contacts_);
  for (domain::Tie& tie : domain_.ties) tie.force = {};
  for (domain::Embedding& embedding : domain_.embeddings) embedding.force = {};
  for (contact::TieSprings& springs : tie_springs_) springs.add_forces(domain_);
  joints_.add_forces(domain_);
  joint_stiffnesses_.add_forces(domain_);
  if (start != nullptr) start->keep_inner_forces(domain_);
  pressure_loads_.add_forces(domain_);
  air_blasts_.add_forces(domain_);
  control_volumes_.add_forces(domain_);
  nodal_loads_.add_forces(domain_);
  body_loads_.add_forces(domain_);
  rigid_body_loads_.add_forces(domain_);
  follower_loads_.add_forces(domain_);
  inertia_fields_.add_forces(domain_);
  if (start != nullptr) start->keep_loads(domain_);
  mass_damping_.add_forces(domain_);
  relative_dampings_.add_forces(domain_);
}

/// What tied nodes weigh is carried by others: the work that brings new mass to their speed is the
/// difference.
void Simulation::scale_masses() {
  const bool needed = domain_.clock.kept_step > 0 && domain_.clock.element_limit < domain_.clock.kept_step;
  if (!needed) return;
  tied_nodes_.remember(domain_);
  const constraints::KineticChange before = tied_nodes_.carried_energy(domain_);
  elements::keep_step(domain_);
  tied_nodes_.share_masses(domain_);
  const constraints::KineticChange after = tied_nodes_.carried_energy(domain_);
  if (domain_.clock.cycle > 0)  // before the first step there is nothing to balance yet
    domain_.energy.external_work +=
        (after.translational - before.translational) + (after.rotational - before.rotational);
}

/// Where the last element is gone none limits the step, but loads, contacts and joints hold on to what it
/// would be: that of the start, then.
void Simulation::limit_step_without_elements() {
  const domain::Clock no_elements;
  if (domain_.clock.cycle > 0 && domain_.clock.element_limit >= no_elements.rigid_limit)
    domain_.clock.element_limit = largest_step_ / step_growth_limit / model_->control.step_scale;
}

/// In three stages: how stiff a contact may be depends on what the others do to its nodes.
void Simulation::add_contact_forces() {
  if (contacts_.empty()) return;
  for (contact::Interface& contact : contacts_) contact.clear_forces(domain_);
  for (contact::Interface& contact : contacts_) contact.find_touches(domain_);
  rigid_bodies_.weigh(domain_);
  for (contact::Interface& contact : contacts_) contact.evaluate_forces(domain_);
  const double longest = longest_contact_step();
  if (longest < much_shorter * domain_.clock.step)
    for (contact::Interface& contact : contacts_) contact.evaluate_forces_again(domain_, longest);
  for (contact::Interface& contact : contacts_) contact.add_forces(domain_);
}

double Simulation::longest_contact_step() const {
  double longest = std::numeric_limits<double>::infinity();
  for (const contact::Interface& contact : contacts_) longest = std::min(longest, contact.longest_step());
  return longest;
}

void Simulation::choose_step() {
  const model::Control& control = model_->control;
  const bool first = domain_.clock.cycle == 0;
  next_step_ = control.step_scale * domain_.clock.element_limit;
  if (first) largest_step_ = step_growth_limit * next_step_;
  next_step_ *= control_volumes_.stable_share(domain_.clock.element_limit);
  next_step_ *= mass_damping_.stable_share(domain_.clock.element_limit);
  next_step_ *= relative_dampings_.stable_share(domain_.clock.element_limit);
  if (first && control.initial_step > 0) next_step_ = std::min(next_step_, control.initial_step);
  next_step_ = std::min({next_step_, largest_step_, curve_limit(*model_, domain_.clock.time)});
  for (const contact::TieSprings& springs : tie_springs_)
    next_step_ = std::min(next_step_, springs.longest_step());
  next_step_ = std::min(next_step_, longest_contact_step());
  next_step_ = std::min(next_step_, joint_stiffnesses_.longest_step());
  next_step_ = has_multipliers_ ? steady_step(domain_.clock.step, next_step_)
                                : held_step_.next(domain_.clock.cycle, domain_.clock.step, next_step_);
  if (!first) next_step_ = std::min(next_step_, growth_in_a_cycle * domain_.clock.step);
  if (!(next_step_ > 0) || !std::isfinite(next_step_))
    throw_trouble(*model_, domain_, "The time step is no longer a positive number: an element has collapsed");
}

/// The forces that need to know all others, and the step.
void Simulation::close_gaps(double interval) {
  local_constraints_.refresh(domain_);
  viscous_boundary_.add_forces(domain_, interval);
  for (contact::Interface& contact : contacts_) contact.add_multipliers(domain_, interval, next_step_);
  for (std::size_t i = 0; i < transducers_.size(); ++i)
    domain_.transducers[i].force = transducers_[i].measure(contacts_);
}

void Simulation::kick(double interval) {
  {
    const StageTimer timer(domain_.times.constraints);
    spot_welds_.break_overloaded(domain_);
    tied_nodes_.release(domain_);
    tied_nodes_.remember(domain_);
    linear_equations_.remember(domain_);
    interpolations_.prepare(domain_);
    supports_.measure(domain_);
    rigid_bodies_.kick(domain_, interval);
  }
  accelerate_free_nodes(interval);
  const StageTimer timer(domain_.times.constraints);
  join_nodes(interval);
  impose_motions(interval);
  stop_at_walls(interval);
  tied_nodes_.follow(domain_, interval, next_step_);
  sum_kinetic_energy();
  rigid_bodies_.carry_nodes(domain_, interval, next_step_);
}

void Simulation::impose_motions(double interval) {
  constraints::KineticChange change;
  if (!prescribed_motions_.empty()) change = prescribed_motions_.impose(domain_, interval, next_step_);
  if (!rigid_body_stoppers_.empty()) rigid_body_stoppers_.impose(domain_, next_step_);
  if (!local_constraints_.empty()) {
    const constraints::KineticChange local = local_constraints_.impose(domain_, interval, next_step_);
    change.translational += local.translational;
    change.rotational += local.rotational;
    supports_.add_local(domain_, local_constraints_);
  }
  kick_sums_.translational += change.translational;
  kick_sums_.rotational += change.rotational;
}

void Simulation::accelerate_free_nodes(double interval) {
  prescribed_motions_.remember(domain_);
  local_constraints_.remember(domain_);
  const StageTimer timer(domain_.times.integrate);
  math::Vec3* const previous = keeps_previous_velocity() ? previous_velocity_.data() : nullptr;
  kick_sums_ = accelerate_nodes(domain_, {interval, previous, keeps_accelerations_});
}

bool Simulation::joins_nodes() const {
  return !rivets_.empty() || !node_sets_.empty() || !linear_equations_.empty() || !interpolations_.empty() ||
         !tied_nodes_.empty();
}

void Simulation::join_nodes(double interval) {
  kick_sums_.rotational += tied_nodes_.share(domain_).rotational;
  supports_.add_ties(domain_, tied_nodes_, interval);
  node_sets_.constrain(domain_);
  kick_sums_.rotational += linear_equations_.constrain(domain_).rotational;
  kick_sums_.rotational += interpolations_.constrain(domain_, next_step_).rotational;
  rivets_.constrain(domain_, next_step_);
}

void Simulation::stop_at_walls(double interval) {
  // What else changes velocities after the kick does not tell how fast nodes are then; nor do bodies that may
  // release theirs.
  const bool known =
      !joins_nodes() && prescribed_motions_.empty() && local_constraints_.empty() && spot_welds_.empty();
  double fastest = known ? kick_sums_.fastest : std::numeric_limits<double>::infinity();
  for (constraints::RigidWall& wall : walls_)
    kick_sums_.translational += wall.stop_nodes(domain_, {previous_velocity_, interval, next_step_, fastest});
}

/// Anew, where what has changed the velocities of the kick does not tell by how much.
void Simulation::sum_kinetic_energy() {
  if (!joins_nodes()) return;
  kick_sums_.translational = kinetic_energy(domain_, previous_velocity_, domain_.nodes.velocity) +
                             tied_nodes_.carried_energy(domain_).translational;
}

void Simulation::balance() {
  domain::EnergyLedger& energy = domain_.energy;
  energy.internal = energy.hourglass = energy.eroded = 0;
  energy.contact = energy.contact_dissipated = energy.friction = energy.rigidwall = 0;
  for (const domain::ElementBlock* block : domain_.blocks()) {
    energy.internal += block->internal_energy;
    energy.hourglass += block->hourglass_energy;
    energy.eroded += block->eroded_energy;
  }
  for (const domain::ContactReport& contact : domain_.contacts) {
    energy.contact += contact.energy;
    energy.contact_dissipated += contact.damping_energy;
    energy.friction += contact.friction_energy;
    energy.eroded += contact.eroded_energy;
  }
  for (const domain::Tie& tie : domain_.ties) {
    energy.contact += tie.energy;
    energy.contact_dissipated += tie.dissipated;
  }
  for (const domain::Embedding& embedding : domain_.embeddings) {
    energy.contact += embedding.lost;
    energy.contact_dissipated += embedding.lost;
  }
  for (const domain::JointReport& joint : domain_.joints) energy.internal += joint.energy;
  for (const domain::JointStiffnessReport& stiffness : domain_.joint_stiffnesses) {
    energy.internal += stiffness.energy;
    energy.friction += stiffness.friction_energy;
  }
  for (const domain::WallReport& wall : domain_.walls) energy.rigidwall += wall.energy;
  guard_kinetic_energy(*model_, domain_, initial_stress_energy_);
  if (guards_contact_energy_) guard_contact_energy(domain_);
  if (domain_.clock.cycle > 0) terminations_.observe(domain_);
}

}  // namespace crumple::timeloop
