// SPDX-License-Identifier: BSD-3-Clause
#include "model/dynamic_relaxation.hpp"

#include "model/model.hpp"

namespace crumple::model {

Model relaxation_model(const Model& model) {
  const DynamicRelaxation& relaxation = *model.relaxation;
  Model relaxing = model;
  relaxing.relaxation.reset();
  relaxing.nodal_loads = relaxation.nodal_loads;
  relaxing.pressure_loads = relaxation.pressure_loads;
  relaxing.body_loads = relaxation.body_loads;
  relaxing.inertia_fields = relaxation.inertia_fields;
  relaxing.rigid_body_loads = relaxation.rigid_body_loads;
  relaxing.prescribed_motions = relaxation.prescribed_motions;
  relaxing.initial_velocities.clear();
  for (RigidBody& body : relaxing.rigid_bodies) {
    body.initial_motion.reset();
    if (body.inertia) body.inertia->velocity_from_nodes = true;  // which are at rest
  }
  relaxing.air_blasts.clear();
  relaxing.terminations.clear();
  relaxing.control.step_curve = no_index;
  const double step_scale = relaxation.settings.step_scale;
  if (step_scale > 0) relaxing.control.step_scale = step_scale;
  return relaxing;
}

}  // namespace crumple::model
