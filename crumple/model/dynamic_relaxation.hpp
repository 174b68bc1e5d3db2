// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model/conditions.hpp"

namespace crumple::model {

struct Model;

/// How a dynamic relaxation is made. Defaults are LS-DYNA's.
struct RelaxationSettings {
  long check_cycles = 250;            ///< NRCYCK: cycles between two checks
  double tolerance = 1e-3;            ///< DRTOL: kinetic energy over the largest of the phase [-]
  double factor = 0.995;              ///< DRFCTR: what is left of velocities in each step [-]
  double end_time = 0;                ///< DRTERM [time]; 0 is none
  double step_scale = 0;              ///< TSSFDR [-]; 0 takes that of the run
  bool automatic = false;             ///< IRELAL: the factor follows from the motion
  double automatic_tolerance = 0.04;  ///< EDTTL: change of the slowest rate that is steady [-]
};

/// A dynamic relaxation before the run (*CONTROL_DYNAMIC_RELAXATION), with the loads and motions that act in
/// it (docs/theory/dynamic_relaxation.md).
struct DynamicRelaxation {
  RelaxationSettings settings;
  std::vector<NodalLoad> nodal_loads;
  std::vector<PressureLoad> pressure_loads;
  std::vector<BodyLoad> body_loads;
  std::vector<InertiaField> inertia_fields;
  std::vector<RigidBodyLoad> rigid_body_loads;
  std::vector<PrescribedMotion> prescribed_motions;
};

/// The model as its relaxation sees it: at rest, with the loads and motions of that phase. It must have one.
Model relaxation_model(const Model& model);

}  // namespace crumple::model
