// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The time step: central differences with a variable step. Positions, stresses and forces belong to times n,
// velocities to the middle between two of them:
//
//     x(n-1)        x(n)              x(n+1)
//     ---|------------|------------------|-----> time
//             v(n-1/2)        v(n+1/2)
//        |--- step ---|--- next_step ----|
//              |-- interval --|                  (step + next_step) / 2
//
//     drift            x(n) = x(n-1) + step v(n-1/2)                nodes, rigid bodies, tied nodes
//     compute_forces   f(n) of elements, contacts, tied contacts with springs, joints, loads, damping
//     choose_step      next_step: TSSFAC times the smallest stable step of an element; bounds on its growth
//     close_gaps       non-reflecting boundaries and contacts by multipliers, which need all other forces
//                      and next_step
//     kick             v(n+1/2) = v(n-1/2) + interval f(n) / m, then what constrains velocities: ties,
//                      rivets, prescribed motions, rigid walls, rigid bodies
//     balance          energies of time n, and guards that end a run which has lost its stability
//
// The kinetic energy is 1/2 m v(n-1/2).v(n+1/2), with which the balance closes to round-off
// (docs/theory/time_integration.md, energy.md). step.cpp has these stages on one page; docs/step.md says what
// each of them reads and writes, in the same order.
//
// Simulation owns the domain and one object for each actor of the step. An actor that remembers something
// from step to step declares it in state(); what follows from that state is rebuilt in resume(). Order of
// calls: constructor, start() (or resume() after a restart), then step() until finished(). A dynamic
// relaxation (dynamic_relaxation.hpp) is a simulation of its own before start(), which begin_with() takes
// over. Between two calls of step() an observer sees one moment, with velocities half a step ahead.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "constraints/interpolations.hpp"
#include "constraints/joint_stiffness.hpp"
#include "constraints/joints.hpp"
#include "constraints/linear_equations.hpp"
#include "constraints/local_constraints.hpp"
#include "constraints/node_sets.hpp"
#include "constraints/prescribed_motion.hpp"
#include "constraints/rigid_bodies.hpp"
#include "constraints/rigid_body_stoppers.hpp"
#include "constraints/rigid_wall.hpp"
#include "constraints/rivets.hpp"
#include "constraints/spot_welds.hpp"
#include "constraints/tied_nodes.hpp"
#include "contact/force_transducer.hpp"
#include "contact/interface.hpp"
#include "contact/tied/tie_springs.hpp"
#include "domain/domain.hpp"
#include "domain/energy_residual.hpp"
#include "elements/energy_trace.hpp"
#include "elements/section_forces.hpp"
#include "loads/air_blast.hpp"
#include "loads/body_loads.hpp"
#include "loads/control_volumes.hpp"
#include "loads/follower_loads.hpp"
#include "loads/inertia_fields.hpp"
#include "loads/mass_damping.hpp"
#include "loads/nodal_loads.hpp"
#include "loads/pressure_loads.hpp"
#include "loads/relative_damping.hpp"
#include "loads/viscous_boundary.hpp"
#include "model/model.hpp"
#include "timeloop/held_step.hpp"
#include "timeloop/node_kernels.hpp"
#include "timeloop/supports.hpp"
#include "timeloop/terminations.hpp"

namespace crumple::timeloop {

class StartLoss;

/// A model in motion. The caller owns the loop: start once, then step until the end time.
class Simulation {
 public:
  /// Builds the domain and everything that acts on it. The model must outlive the simulation. Throws Error if
  /// the model cannot be run.
  Simulation(const model::Model& model, const domain::Execution& execution);
  Simulation(const model::Model&& model, const domain::Execution& execution) = delete;

  /// Everything that a run can be taken up from between two steps; the hash is that of every array that
  /// changes. Holds until the next step.
  domain::StateList state();

  /// What output shows of time n and the next step makes anew. A restart may lack it, if the deck has not
  /// asked before.
  void declare_reports(domain::StateList& list);

  /// Instead of start(), or to go back: the arrays of state() have been filled with those of an earlier time,
  /// or of another simulation of the same model. The steps that follow are bitwise the same as there, with
  /// any number of threads.
  void resume();

  /// Before start(), instead of the undeformed model: places, stresses, masses, and what contacts, ties and
  /// joints remember, from another simulation of the same model with other loads, the end of its dynamic
  /// relaxation. Velocities and the clock stay those of time zero. Throws Error if the models differ.
  void begin_with(Simulation& relaxed);

  /// From now on all motion loses `share` of its velocity in each step (dynamic relaxation).
  void relax(double share) { mass_damping_.relax(domain_, share); }

  /// Forces, energies and the first step size at time zero; velocities then are half a step ahead.
  void start();

  /// One step of central differences, from time n to n+1. On entry and on exit: positions, stresses, forces
  /// and energies belong to the same time, velocities are half a step ahead. Throws NumericalError if a
  /// velocity or energy stops being a finite number, naming where.
  void step();

  /// True when the end time or the last cycle is reached, or something else ends the run.
  bool finished() const;

  /// What else has ended it, in a sentence (*TERMINATION).
  std::optional<std::string> ended_by() const { return terminations_.reason(); }

  /// Fingerprint of every array that changes.
  std::uint64_t state_hash() { return state().hash(); }

  /// Has every contact find segments that cut through each other (Interface::note_intersections).
  void note_intersections();
  /// Has every contact fill its report's inspection (Interface::inspect).
  void inspect_contacts();

  /// Compares contact candidates with brute force every `cycles` cycles (a debugging aid); 0 is off.
  void verify_search_every(long cycles);

  /// Has the energy balance followed by part and contact, from the start on.
  void trace_energy();
  /// Where energy goes wrong, if it is traced; else empty.
  domain::EnergyTraceReport energy_trace() const;

  /// Goes on where a contact has given much more energy than it took, which else ends the run.
  void allow_negative_contact_energy() { guards_contact_energy_ = false; }

  /// Has NodeFields::acceleration written in every step, also if the deck asks for no nodes' motion.
  void keep_accelerations();

  /// What each contact puts on each node at time n, in the order of the contacts.
  std::vector<domain::ContactNodeForce> contact_node_forces() const;

  /// Forces in the cross-sections at time n, if the deck asks for them.
  std::span<const domain::SectionReport> sections() const { return sections_.reports(); }

  const model::Model& model() const { return *model_; }
  domain::Domain& domain() { return domain_; }
  const domain::Domain& domain() const { return domain_; }
  /// The step that the next call of step() will take [time].
  double next_step() const { return next_step_; }

 private:
  domain::StateList deformation();
  void compute_forces(StartLoss* start = nullptr);
  void scale_masses();
  void limit_step_without_elements();
  void add_contact_forces();
  double longest_contact_step() const;
  void choose_step();
  void close_gaps(double interval);
  void kick(double interval);
  void accelerate_free_nodes(double interval);
  bool joins_nodes() const;
  bool keeps_previous_velocity() const { return joins_nodes() || !walls_.empty(); }
  void join_nodes(double interval);
  void impose_motions(double interval);
  void stop_at_walls(double interval);
  void sum_kinetic_energy();
  void drift();
  void balance();

  const model::Model* model_;
  domain::Domain domain_;
  elements::SectionForces sections_;
  std::vector<contact::Interface> contacts_;
  bool has_multipliers_ = false;
  std::vector<contact::ForceTransducer> transducers_;
  std::vector<contact::TieSprings> tie_springs_;
  constraints::RigidBodies rigid_bodies_;
  constraints::Joints joints_;
  constraints::JointStiffnesses joint_stiffnesses_;
  constraints::SpotWelds spot_welds_;
  constraints::TiedNodes tied_nodes_;
  constraints::NodeSets node_sets_;
  constraints::LinearEquations linear_equations_;
  constraints::Interpolations interpolations_;
  constraints::Rivets rivets_;
  constraints::PrescribedMotions prescribed_motions_;
  constraints::RigidBodyStoppers rigid_body_stoppers_;
  constraints::LocalConstraints local_constraints_;
  std::vector<constraints::RigidWall> walls_;
  Supports supports_;
  loads::NodalLoads nodal_loads_;
  loads::PressureLoads pressure_loads_;
  loads::AirBlasts air_blasts_;
  loads::ControlVolumes control_volumes_;
  loads::BodyLoads body_loads_;
  loads::RigidBodyLoads rigid_body_loads_;
  loads::FollowerLoads follower_loads_;
  loads::InertiaFields inertia_fields_;
  loads::MassDamping mass_damping_;
  loads::RelativeDampings relative_dampings_;
  loads::ViscousBoundary viscous_boundary_;
  Terminations terminations_;
  AlignedArray<math::Vec3> previous_velocity_;  ///< v(n-1/2), kept by the kick if joints or walls change it
  KickSums kick_sums_;                          ///< of the last kick, walls included
  bool keeps_accelerations_ = false;
  bool guards_contact_energy_ = true;
  bool begins_relaxed_ = false;       ///< begin_with() has been called
  double initial_stress_energy_ = 0;  ///< see guards.hpp [energy]
  std::optional<elements::EnergyTrace> energy_trace_;
  double start_loss_ = 0;    ///< see start_loss.hpp; the ledger has it from cycle 1 on [energy]
  double start_work_ = 0;    ///< likewise, of loads [energy]
  double largest_step_ = 0;  ///< no step exceeds this [time]
  double next_step_ = 0;     ///< from n to n+1 [time]
  HeldStep held_step_;
};

}  // namespace crumple::timeloop
