// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Dynamic relaxation: the static answer to some loads, before the run, by explicit steps in which all motion
// loses a share of its velocity. It is a simulation of its own, of model::relaxation_model: the same model at
// rest, with the loads of that phase and a clock of its own. Its end is where the run begins
// (Simulation::begin_with). Method, source and limits: docs/theory/dynamic_relaxation.md.
//
// Order of calls: constructor, start(), then step() until finished().

#include "model/model.hpp"
#include "timeloop/simulation.hpp"
#include "timeloop/slowest_rate.hpp"

namespace crumple::timeloop {

/// A model on its way to rest under the loads of its relaxation.
class DynamicRelaxation {
 public:
  /// The model must have a relaxation, and outlive this. Throws Error if it cannot be run.
  DynamicRelaxation(const model::Model& model, const domain::Execution& execution);

  void start();
  /// One step; true if it ended with a check of the convergence. Throws NumericalError as the simulation.
  bool step();

  /// Whether it has converged or come to its end time.
  bool finished() const { return converged_ || out_of_time(); }
  bool converged() const { return converged_; }

  /// At the last check: the largest kinetic energy since the one before over the largest of all, without that
  /// of rigid bodies [-]. 1 before the first, 0 if nothing has moved.
  double ratio() const { return ratio_; }
  /// What is left of velocities in each step now [-].
  double factor() const { return factor_; }
  /// Kinetic energy of all but rigid bodies and walls now [energy].
  double distortional_energy() const;

  Simulation& simulation() { return simulation_; }
  const Simulation& simulation() const { return simulation_; }

 private:
  bool out_of_time() const;
  void adapt();

  const model::RelaxationSettings settings_;
  const model::Model model_;
  Simulation simulation_;
  SlowestRate slowest_;
  double factor_;
  double largest_ = 0;              ///< kinetic energy of all steps [energy]
  double largest_since_check_ = 0;  ///< [energy]
  double ratio_ = 1;
  bool converged_ = false;
};

/// Makes the relaxation of the model that `run` has, if it has one, to its end, and has the run begin with
/// it. Before Simulation::start().
void begin_relaxed(Simulation& run);

}  // namespace crumple::timeloop
