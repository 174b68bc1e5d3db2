// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/air_blast.hpp"
#include "model/conditions.hpp"
#include "model/connections.hpp"
#include "model/contact.hpp"
#include "model/control.hpp"
#include "model/control_volume.hpp"
#include "model/curve.hpp"
#include "model/dynamic_relaxation.hpp"
#include "model/equation_of_state.hpp"
#include "model/joint.hpp"
#include "model/material.hpp"
#include "model/mesh.hpp"
#include "model/output_requests.hpp"
#include "model/rigid_body.hpp"
#include "model/section.hpp"
#include "model/spring.hpp"
#include "model/termination.hpp"
#include "model/tied_contact.hpp"

namespace crumple::model {

/// The validated description of what is to be computed. Holds no state and never changes during a run. All
/// references between items are indices into the arrays below; user ids serve input and output only.
/// Units are the user's own, and consistent.
struct Model {
  std::string title;
  Nodes nodes;
  std::vector<ShellElement> shells;
  std::vector<SolidElement> solids;
  std::vector<BeamElement> beams;
  std::vector<DiscreteElement> discretes;
  std::vector<Part> parts;
  std::vector<ShellSection> shell_sections;
  std::vector<Layup> layups;
  std::vector<double> layer_angles;  ///< of shells whose layers have angles of their own [rad]
  std::vector<SolidSection> solid_sections;
  std::vector<BeamSection> beam_sections;
  std::vector<DiscreteSection> discrete_sections;
  std::vector<Material> materials;
  std::vector<SpringMaterial> spring_materials;
  std::vector<EquationOfState> equations_of_state;
  std::vector<HourglassControl> hourglass_controls;
  std::vector<LumpedMass> lumped_masses;
  std::vector<Curve> curves;
  std::vector<NodeSet> node_sets;
  std::vector<PartSet> part_sets;
  std::vector<ShellSet> shell_sets;
  std::vector<SegmentSet> segment_sets;
  std::vector<RigidBody> rigid_bodies;
  std::vector<RigidBodyStopper> rigid_body_stoppers;
  std::vector<SpotWeld> spot_welds;
  std::vector<Rivet> rivets;
  std::vector<ConstrainedNodeSet> constrained_node_sets;
  std::vector<Joint> joints;
  std::vector<JointStiffness> joint_stiffnesses;
  std::vector<PartMass> part_masses;
  std::vector<LinearEquation> linear_equations;
  std::vector<Interpolation> interpolations;
  std::vector<EmbeddedBeams> embedded_beams;
  std::vector<FixedNode> fixed_nodes;
  std::vector<LocalSupport> local_supports;
  std::vector<InitialVelocity> initial_velocities;
  std::vector<InitialStress> shell_stresses;  ///< of an element that has several the last counts
  std::vector<InitialStress> solid_stresses;
  std::vector<NodalLoad> nodal_loads;
  std::vector<PressureLoad> pressure_loads;
  std::vector<AirBlast> air_blasts;
  std::vector<BlastSegment> blast_segments;
  std::vector<ViscousSegment> viscous_segments;
  std::vector<ControlVolume> control_volumes;
  std::vector<BodyLoad> body_loads;
  std::vector<InertiaField> inertia_fields;
  std::vector<RigidBodyLoad> rigid_body_loads;
  std::optional<MassDamping> mass_damping;
  std::vector<MassDamping> part_dampings;
  std::vector<RelativeDamping> relative_dampings;
  std::vector<PrescribedMotion> prescribed_motions;
  std::vector<RigidWall> rigid_walls;
  std::vector<Contact> contacts;
  std::vector<ForceTransducer> force_transducers;
  std::vector<TiedContact> tied_contacts;
  std::vector<Termination> terminations;
  std::optional<DynamicRelaxation> relaxation;  ///< before the run
  Control control;
  OutputRequests output;
  SearchSettings search;
  RunSettings run;
};

/// Thickness of a shell at its four nodes [length]: the element's own where given, else the section's. Where
/// a triangle repeats a node stands the mean of its corners, so that the mean of all four is that, too.
std::array<double, 4> shell_thickness(const Model& model, const ShellElement& shell);

/// Layup of a shell, or no_index if it has one material through the thickness.
Index layup_of(const Model& model, const ShellElement& shell);

/// The material of a shell; of a layered one that which stands in for its layers.
const Material& material_of(const Model& model, const ShellElement& shell);

/// The material that stands in for the layers of a shell where one is asked for: with the mean density, and
/// isotropic elastic constants whose plate waves and transverse shear are as fast as those of the layers
/// (docs/theory/layered_shells.md).
Material layup_material(const Model& model, const Layup& layup);

/// Whether the elements of a part are rigid: they have mass and a surface, but no forces.
bool is_rigid(const Model& model, const Part& part);

/// Hourglass control that holds for a part.
const HourglassControl& hourglass_of(const Model& model, const Part& part);

/// Hourglass control that holds for a part of solids: where it is that of the material, assumed strains with
/// the whole stiffness of elastic laws (1) and a hundredth of it for those that flow, which the control does
/// not; viscous for those without shear stiffness.
HourglassControl solid_hourglass_of(const Model& model, const Part& part);

/// Equation of state of a part, or nullptr.
const EquationOfState* equation_of_state_of(const Model& model, const Part& part);

/// Coefficients of the bulk viscosity of a part of solids.
struct BulkViscosity {
  double quadratic = 0;  ///< Q1 [-]
  double linear = 0;     ///< Q2 [-]
};

/// The bulk viscosity that holds for a part: its own where *HOURGLASS gives one, else the model's.
BulkViscosity bulk_viscosity_of(const Model& model, const Part& part);

/// Checks every reference and every number of a model that was not read from a deck (the deck reader reports
/// these with file and line itself). Returns one sentence per fault; empty if the model can be run.
std::vector<std::string> faults(const Model& model);

}  // namespace crumple::model
