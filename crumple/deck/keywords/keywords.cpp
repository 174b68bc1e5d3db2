// SPDX-License-Identifier: BSD-3-Clause
#include "deck/keywords/keywords.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace crumple::deck {

namespace {

constexpr HeadingKind none = HeadingKind::None;
constexpr HeadingKind title = HeadingKind::Title;
constexpr HeadingKind identity = HeadingKind::Identity;
using File = model::HistoryFile;
using Traced = HistoryItem;

// KEYWORD, INCLUDE, INCLUDE_PATH and END are the scanner's, PARAMETER and its kin and INCLUDE_TRANSFORM are
// the reader's.
constexpr Keyword table[] = {
    {"TITLE", read_title},

    {"NODE", read_node},
    {"NODE_TRANSFORM", read_node_transform},
    {"ELEMENT_SHELL", read_element_shell},
    {"ELEMENT_SHELL_THICKNESS", read_element_shell_thickness},
    {"ELEMENT_SHELL_BETA", read_element_shell_thickness},
    {"ELEMENT_SHELL_COMPOSITE", read_element_shell_composite},
    {"ELEMENT_SOLID", read_element_solid},
    {"ELEMENT_BEAM", read_element_beam},
    {"ELEMENT_BEAM_ORIENTATION", read_element_beam_orientation},
    {"ELEMENT_DISCRETE", read_element_discrete},
    {"ELEMENT_INERTIA", read_element_inertia},
    {"ELEMENT_SEATBELT_ACCELEROMETER", read_element_seatbelt_accelerometer},
    {"ELEMENT_MASS", read_element_mass},
    {"ELEMENT_MASS_NODE_SET", read_element_mass_node_set},
    {"ELEMENT_MASS_PART", read_element_mass_part},
    {"ELEMENT_MASS_PART_SET", read_element_mass_part_set},

    {"PART", read_part},
    {"PART_CONTACT", read_part},
    {"PART_PRINT", read_part},
    {"PART_CONTACT_PRINT", read_part},
    {"PART_COMPOSITE", read_part_composite},
    {"PART_COMPOSITE_CONTACT", read_part_composite},
    {"PART_COMPOSITE_LONG", read_part_composite_long},
    {"PART_COMPOSITE_LONG_CONTACT", read_part_composite_long},
    {"PART_INERTIA", read_part_inertia},
    {"PART_INERTIA_CONTACT", read_part_inertia},
    {"PART_INERTIA_PRINT", read_part_inertia},
    {"PART_INERTIA_CONTACT_PRINT", read_part_inertia},
    {"SECTION_SHELL", read_section_shell, title},
    {"SECTION_SOLID", read_section_solid, title},
    {"SECTION_BEAM", read_section_beam, title},
    {"INTEGRATION_BEAM", read_integration_beam},
    {"SECTION_DISCRETE", read_section_discrete, title},
    {"INTEGRATION_SHELL", read_integration_shell},
    {"HOURGLASS", read_hourglass, title},

    {"MAT_ELASTIC", read_mat_elastic, title},
    {"MAT_001", read_mat_elastic, title},
    {"MAT_PLASTIC_KINEMATIC", read_mat_plastic_kinematic, title},
    {"MAT_003", read_mat_plastic_kinematic, title},
    {"MAT_PIECEWISE_LINEAR_PLASTICITY", read_mat_piecewise_linear_plasticity, title},
    {"MAT_024", read_mat_piecewise_linear_plasticity, title},
    {"MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY", read_mat_modified_piecewise_linear_plasticity, title},
    {"MAT_123", read_mat_modified_piecewise_linear_plasticity, title},
    {"MAT_POWER_LAW_PLASTICITY", read_mat_power_law_plasticity, title},
    {"MAT_018", read_mat_power_law_plasticity, title},
    {"MAT_JOHNSON_COOK", read_mat_johnson_cook, title},
    {"MAT_015", read_mat_johnson_cook, title},
    {"MAT_SIMPLIFIED_JOHNSON_COOK", read_mat_simplified_johnson_cook, title},
    {"MAT_098", read_mat_simplified_johnson_cook, title},
    {"MAT_ORTHOTROPIC_ELASTIC", read_mat_orthotropic_elastic, title},
    {"MAT_002", read_mat_orthotropic_elastic, title},
    {"MAT_COMPOSITE_DAMAGE", read_mat_composite_damage, title},
    {"MAT_022", read_mat_composite_damage, title},
    {"MAT_ENHANCED_COMPOSITE_DAMAGE", read_mat_enhanced_composite_damage, title},
    {"MAT_054", read_mat_enhanced_composite_damage, title},
    {"MAT_055", read_mat_enhanced_composite_damage, title},
    {"MAT_NULL", read_mat_null, title},
    {"MAT_009", read_mat_null, title},
    {"MAT_FABRIC", read_mat_fabric, title},
    {"MAT_034", read_mat_fabric, title},
    {"MAT_RIGID", read_mat_rigid, title},
    {"MAT_020", read_mat_rigid, title},
    {"MAT_BLATZ-KO_RUBBER", read_mat_blatz_ko_rubber, title},
    {"MAT_007", read_mat_blatz_ko_rubber, title},
    {"MAT_MOONEY-RIVLIN_RUBBER", read_mat_mooney_rivlin_rubber, title},
    {"MAT_027", read_mat_mooney_rivlin_rubber, title},
    {"MAT_CRUSHABLE_FOAM", read_mat_crushable_foam, title},
    {"MAT_063", read_mat_crushable_foam, title},
    {"MAT_ADD_EROSION", read_mat_add_erosion, title},
    {"MAT_LOW_DENSITY_FOAM", read_mat_low_density_foam, title},
    {"MAT_057", read_mat_low_density_foam, title},
    {"MAT_FU_CHANG_FOAM", read_mat_fu_chang_foam, title},
    {"MAT_083", read_mat_fu_chang_foam, title},
    {"MAT_OGDEN_RUBBER", read_mat_ogden_rubber, title},
    {"MAT_077_O", read_mat_ogden_rubber, title},
    {"MAT_HYPERELASTIC_RUBBER", read_mat_hyperelastic_rubber, title},
    {"MAT_077_H", read_mat_hyperelastic_rubber, title},
    {"MAT_VISCOELASTIC", read_mat_viscoelastic, title},
    {"MAT_006", read_mat_viscoelastic, title},
    {"MAT_GENERAL_VISCOELASTIC", read_mat_general_viscoelastic, title},
    {"MAT_076", read_mat_general_viscoelastic, title},
    {"MAT_HONEYCOMB", read_mat_honeycomb, title},
    {"MAT_026", read_mat_honeycomb, title},
    {"MAT_SOIL_AND_FOAM", read_mat_soil_and_foam, title},
    {"MAT_005", read_mat_soil_and_foam, title},
    {"MAT_VISCOUS_FOAM", read_mat_viscous_foam, title},
    {"MAT_062", read_mat_viscous_foam, title},
    {"MAT_SIMPLIFIED_RUBBER/FOAM", read_mat_simplified_rubber, title},
    {"MAT_181", read_mat_simplified_rubber, title},
    {"EOS_LINEAR_POLYNOMIAL", read_eos_linear_polynomial, title},
    {"EOS_001", read_eos_linear_polynomial, title},
    {"EOS_GRUNEISEN", read_eos_gruneisen, title},
    {"EOS_004", read_eos_gruneisen, title},

    {"MAT_RESULTANT_PLASTICITY", read_mat_resultant_plasticity, title},
    {"MAT_028", read_mat_resultant_plasticity, title},
    {"MAT_LINEAR_ELASTIC_DISCRETE_BEAM", read_mat_linear_elastic_discrete_beam, title},
    {"MAT_066", read_mat_linear_elastic_discrete_beam, title},
    {"MAT_NONLINEAR_ELASTIC_DISCRETE_BEAM", read_mat_nonlinear_elastic_discrete_beam, title},
    {"MAT_067", read_mat_nonlinear_elastic_discrete_beam, title},
    {"MAT_CABLE_DISCRETE_BEAM", read_mat_cable_discrete_beam, title},
    {"MAT_071", read_mat_cable_discrete_beam, title},
    {"MAT_ELASTIC_SPRING_DISCRETE_BEAM", read_mat_elastic_spring_discrete_beam, title},
    {"MAT_074", read_mat_elastic_spring_discrete_beam, title},
    {"MAT_SPOTWELD", read_mat_spotweld, title},
    {"MAT_100", read_mat_spotweld, title},
    {"MAT_SPOTWELD_DAMAGE-FAILURE", read_mat_spotweld_damage_failure, title},
    {"MAT_100_DAMAGE-FAILURE", read_mat_spotweld_damage_failure, title},
    {"MAT_SPRING_ELASTIC", read_mat_spring_elastic, title},
    {"MAT_S01", read_mat_spring_elastic, title},
    {"MAT_DAMPER_VISCOUS", read_mat_damper_viscous, title},
    {"MAT_S02", read_mat_damper_viscous, title},
    {"MAT_SPRING_ELASTOPLASTIC", read_mat_spring_elastoplastic, title},
    {"MAT_S03", read_mat_spring_elastoplastic, title},
    {"MAT_SPRING_NONLINEAR_ELASTIC", read_mat_spring_nonlinear_elastic, title},
    {"MAT_S04", read_mat_spring_nonlinear_elastic, title},
    {"MAT_DAMPER_NONLINEAR_VISCOUS", read_mat_damper_nonlinear_viscous, title},
    {"MAT_S05", read_mat_damper_nonlinear_viscous, title},

    {"DEFINE_SD_ORIENTATION", read_define_sd_orientation, title},
    {"DEFINE_CURVE", read_define_curve, title},
    {"DEFINE_CURVE_FUNCTION", read_define_curve_function, title},
    {"DEFINE_TABLE", read_define_table, title},
    {"DEFINE_TABLE_2D", read_define_table_2d, title},
    {"DEFINE_BOX", read_define_box, title},
    {"DEFINE_TRANSFORMATION", read_define_transformation, title},
    {"DEFINE_COORDINATE_SYSTEM", read_define_coordinate_system, title},
    {"DEFINE_COORDINATE_NODES", read_define_coordinate_nodes, title},
    {"DEFINE_COORDINATE_VECTOR", read_define_coordinate_vector, title},
    {"DEFINE_VECTOR", read_define_vector, title},
    {"SET_NODE", read_set<SetItem::Node, SetForm::List>, title},
    {"SET_NODE_LIST", read_set<SetItem::Node, SetForm::List>, title},
    {"SET_NODE_COLUMN", read_set<SetItem::Node, SetForm::Column>, title},
    {"SET_NODE_LIST_GENERATE", read_set<SetItem::Node, SetForm::Generate>, title},
    {"SET_NODE_LIST_GENERATE_INCREMENT", read_set<SetItem::Node, SetForm::GenerateIncrement>, title},
    {"SET_NODE_GENERAL", read_set<SetItem::Node, SetForm::General>, title},
    {"SET_NODE_ADD", read_set<SetItem::Node, SetForm::Add>, title},
    {"SET_PART", read_set<SetItem::Part, SetForm::List>, title},
    {"SET_PART_LIST", read_set<SetItem::Part, SetForm::List>, title},
    {"SET_PART_COLUMN", read_set<SetItem::Part, SetForm::Column>, title},
    {"SET_PART_LIST_GENERATE", read_set<SetItem::Part, SetForm::Generate>, title},
    {"SET_PART_LIST_GENERATE_INCREMENT", read_set<SetItem::Part, SetForm::GenerateIncrement>, title},
    {"SET_PART_GENERAL", read_set<SetItem::Part, SetForm::General>, title},
    {"SET_PART_ADD", read_set<SetItem::Part, SetForm::Add>, title},
    {"SET_SHELL", read_set<SetItem::Shell, SetForm::List>, title},
    {"SET_SHELL_LIST", read_set<SetItem::Shell, SetForm::List>, title},
    {"SET_SHELL_COLUMN", read_set<SetItem::Shell, SetForm::Column>, title},
    {"SET_SHELL_LIST_GENERATE", read_set<SetItem::Shell, SetForm::Generate>, title},
    {"SET_SHELL_LIST_GENERATE_INCREMENT", read_set<SetItem::Shell, SetForm::GenerateIncrement>, title},
    {"SET_SHELL_GENERAL", read_set<SetItem::Shell, SetForm::General>, title},
    {"SET_SHELL_ADD", read_set<SetItem::Shell, SetForm::Add>, title},
    {"SET_SOLID", read_set<SetItem::Solid, SetForm::List>, title},
    {"SET_SOLID_LIST", read_set<SetItem::Solid, SetForm::List>, title},
    {"SET_SOLID_GENERATE", read_set<SetItem::Solid, SetForm::Generate>, title},
    {"SET_SOLID_GENERATE_INCREMENT", read_set<SetItem::Solid, SetForm::GenerateIncrement>, title},
    {"SET_SOLID_LIST_GENERATE", read_set<SetItem::Solid, SetForm::Generate>, title},
    {"SET_SOLID_LIST_GENERATE_INCREMENT", read_set<SetItem::Solid, SetForm::GenerateIncrement>, title},
    {"SET_SOLID_GENERAL", read_set<SetItem::Solid, SetForm::General>, title},
    {"SET_SOLID_ADD", read_set<SetItem::Solid, SetForm::Add>, title},
    {"SET_BEAM", read_set<SetItem::Beam, SetForm::List>, title},
    {"SET_BEAM_LIST", read_set<SetItem::Beam, SetForm::List>, title},
    {"SET_BEAM_GENERATE", read_set<SetItem::Beam, SetForm::Generate>, title},
    {"SET_BEAM_GENERATE_INCREMENT", read_set<SetItem::Beam, SetForm::GenerateIncrement>, title},
    {"SET_BEAM_LIST_GENERATE", read_set<SetItem::Beam, SetForm::Generate>, title},
    {"SET_BEAM_LIST_GENERATE_INCREMENT", read_set<SetItem::Beam, SetForm::GenerateIncrement>, title},
    {"SET_BEAM_GENERAL", read_set<SetItem::Beam, SetForm::General>, title},
    {"SET_BEAM_ADD", read_set<SetItem::Beam, SetForm::Add>, title},
    {"SET_DISCRETE", read_set<SetItem::Discrete, SetForm::List>, title},
    {"SET_DISCRETE_LIST", read_set<SetItem::Discrete, SetForm::List>, title},
    {"SET_DISCRETE_GENERATE", read_set<SetItem::Discrete, SetForm::Generate>, title},
    {"SET_DISCRETE_GENERATE_INCREMENT", read_set<SetItem::Discrete, SetForm::GenerateIncrement>, title},
    {"SET_DISCRETE_LIST_GENERATE", read_set<SetItem::Discrete, SetForm::Generate>, title},
    {"SET_DISCRETE_LIST_GENERATE_INCREMENT", read_set<SetItem::Discrete, SetForm::GenerateIncrement>, title},
    {"SET_DISCRETE_GENERAL", read_set<SetItem::Discrete, SetForm::General>, title},
    {"SET_DISCRETE_ADD", read_set<SetItem::Discrete, SetForm::Add>, title},
    {"SET_SEGMENT", read_set_segment, title},
    {"SET_SEGMENT_LIST", read_set_segment, title},
    {"SET_SEGMENT_GENERAL", read_set_segment_general, title},
    {"SET_SEGMENT_ADD", read_set_segment_add, title},

    {"BOUNDARY_SPC_NODE", read_boundary_spc_node, identity},
    {"BOUNDARY_SPC_SET", read_boundary_spc_set, identity},
    {"BOUNDARY_SPC_NODE_BIRTH_DEATH", read_boundary_spc_node_birth_death, identity},
    {"BOUNDARY_SPC_SET_BIRTH_DEATH", read_boundary_spc_set_birth_death, identity},
    {"BOUNDARY_PRESCRIBED_MOTION_NODE", read_boundary_prescribed_motion_node, identity},
    {"BOUNDARY_PRESCRIBED_MOTION_SET", read_boundary_prescribed_motion_set, identity},
    {"BOUNDARY_PRESCRIBED_MOTION_RIGID", read_boundary_prescribed_motion_rigid, identity},
    {"CONSTRAINED_SPOTWELD", read_constrained_spotweld, identity},
    {"CONSTRAINED_GENERALIZED_WELD_SPOT", read_constrained_generalized_weld_spot, identity},
    {"CONSTRAINED_RIVET", read_constrained_rivet, identity},
    {"CONSTRAINED_NODE_SET", read_constrained_node_set, identity},
    {"CONSTRAINED_JOINT_SPHERICAL", read_joint<model::JointKind::Spherical>, identity},
    {"CONSTRAINED_JOINT_SPHERICAL_LOCAL", read_joint<model::JointKind::Spherical>, identity},
    {"CONSTRAINED_JOINT_REVOLUTE", read_joint<model::JointKind::Revolute>, identity},
    {"CONSTRAINED_JOINT_REVOLUTE_LOCAL", read_joint<model::JointKind::Revolute>, identity},
    {"CONSTRAINED_JOINT_CYLINDRICAL", read_joint<model::JointKind::Cylindrical>, identity},
    {"CONSTRAINED_JOINT_CYLINDRICAL_LOCAL", read_joint<model::JointKind::Cylindrical>, identity},
    {"CONSTRAINED_JOINT_TRANSLATIONAL", read_joint<model::JointKind::Translational>, identity},
    {"CONSTRAINED_JOINT_TRANSLATIONAL_LOCAL", read_joint<model::JointKind::Translational>, identity},
    {"CONSTRAINED_JOINT_UNIVERSAL", read_joint<model::JointKind::Universal>, identity},
    {"CONSTRAINED_JOINT_UNIVERSAL_LOCAL", read_joint<model::JointKind::Universal>, identity},
    {"CONSTRAINED_JOINT_LOCKING", read_joint<model::JointKind::Locking>, identity},
    {"CONSTRAINED_JOINT_LOCKING_LOCAL", read_joint<model::JointKind::Locking>, identity},
    {"CONSTRAINED_LINEAR_GLOBAL", read_constrained_linear_global},
    {"CONSTRAINED_ADAPTIVITY", read_constrained_adaptivity},
    {"CONSTRAINED_INTERPOLATION", read_constrained_interpolation},
    {"CONSTRAINED_GLOBAL", read_constrained_global},
    {"CONSTRAINED_JOINT_STIFFNESS_GENERALIZED", read_constrained_joint_stiffness_generalized, identity},
    {"CONSTRAINED_JOINT_STIFFNESS_TRANSLATIONAL", read_constrained_joint_stiffness_translational, identity},
    {"CONSTRAINED_RIGID_BODIES", read_constrained_rigid_bodies},
    {"DEFORMABLE_TO_RIGID", read_deformable_to_rigid},
    {"CONSTRAINED_EXTRA_NODES_NODE", read_constrained_extra_nodes_node},
    {"CONSTRAINED_EXTRA_NODES_SET", read_constrained_extra_nodes_set},
    {"CONSTRAINED_NODAL_RIGID_BODY", read_constrained_nodal_rigid_body, title},
    {"CONSTRAINED_NODAL_RIGID_BODY_INERTIA", read_constrained_nodal_rigid_body_inertia, title},
    {"CONSTRAINED_NODAL_RIGID_BODY_SPC", read_constrained_nodal_rigid_body_spc, title},
    {"CONSTRAINED_NODAL_RIGID_BODY_SPC_INERTIA", read_constrained_nodal_rigid_body_spc_inertia, title},
    {"INITIAL_VELOCITY", read_initial_velocity},
    {"INITIAL_VELOCITY_NODE", read_initial_velocity_node},
    {"INITIAL_VELOCITY_RIGID_BODY", read_initial_velocity_rigid_body},
    {"INITIAL_VELOCITY_GENERATION", read_initial_velocity_generation},
    {"INITIAL_STRESS_SHELL", read_initial_stress_shell},
    {"INITIAL_STRESS_SHELL_SET", read_initial_stress_shell_set},
    {"INITIAL_STRESS_SOLID", read_initial_stress_solid},
    {"INITIAL_STRESS_SOLID_SET", read_initial_stress_solid_set},
    {"INTERFACE_SPRINGBACK_LSDYNA", read_interface_springback_lsdyna},
    {"LOAD_NODE_POINT", read_load_node_point},
    {"LOAD_NODE_SET", read_load_node_set},
    {"LOAD_SEGMENT", read_load_segment, identity},
    {"LOAD_SEGMENT_SET", read_load_segment_set, identity},
    {"LOAD_SHELL_ELEMENT", read_load_shell_element, identity},
    {"LOAD_SHELL_SET", read_load_shell_set, identity},
    {"AIRBAG_SIMPLE_PRESSURE_VOLUME", read_airbag_simple_pressure_volume, identity},
    {"AIRBAG_ADIABATIC_GAS_MODEL", read_airbag_adiabatic_gas_model, identity},
    {"AIRBAG_LINEAR_FLUID", read_airbag_linear_fluid, identity},
    {"AIRBAG_SIMPLE_AIRBAG_MODEL", read_airbag_simple_airbag_model, identity},
    {"AIRBAG_WANG_NEFSKE", read_airbag_wang_nefske, identity},
    {"LOAD_BODY_X", read_load_body_x},
    {"LOAD_BODY_Y", read_load_body_y},
    {"LOAD_BODY_Z", read_load_body_z},
    {"LOAD_BODY_RX", read_load_body_rx},
    {"LOAD_BODY_RY", read_load_body_ry},
    {"LOAD_BODY_RZ", read_load_body_rz},
    {"LOAD_BODY_VECTOR", read_load_body_vector},
    {"LOAD_BODY_PARTS", read_load_body_parts},
    {"LOAD_BODY_GENERALIZED", read_load_body_generalized},
    {"LOAD_BODY_GENERALIZED_SET_NODE", read_load_body_generalized_set_node},
    {"LOAD_BODY_GENERALIZED_SET_PART", read_load_body_generalized_set_part},
    {"LOAD_GRAVITY_PART", read_load_gravity_part},
    {"LOAD_GRAVITY_PART_SET", read_load_gravity_part_set},
    {"DAMPING_GLOBAL", read_damping_global},
    {"DAMPING_PART_MASS", read_damping_part_mass},
    {"DAMPING_PART_MASS_SET", read_damping_part_mass_set},
    {"DAMPING_PART_STIFFNESS", read_damping_part_stiffness},
    {"DAMPING_PART_STIFFNESS_SET", read_damping_part_stiffness_set},
    {"DAMPING_RELATIVE", read_damping_relative},
    {"LOAD_RIGID_BODY", read_load_rigid_body},
    {"RIGIDWALL_PLANAR", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_FINITE", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_MOVING", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_FINITE_MOVING", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_FORCES", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_FINITE_FORCES", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_MOVING_FORCES", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_FINITE_MOVING_FORCES", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_DISPLAY", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_FINITE_DISPLAY", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_MOVING_DISPLAY", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_FINITE_MOVING_DISPLAY", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_FORCES_DISPLAY", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_FINITE_FORCES_DISPLAY", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_MOVING_FORCES_DISPLAY", read_rigidwall_planar, identity},
    {"RIGIDWALL_PLANAR_FINITE_MOVING_FORCES_DISPLAY", read_rigidwall_planar, identity},
    {"RIGIDWALL_GEOMETRIC_FLAT", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_FLAT_MOTION", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_FLAT_DISPLAY", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_FLAT_MOTION_DISPLAY", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_PRISM", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_PRISM_MOTION", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_PRISM_DISPLAY", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_PRISM_MOTION_DISPLAY", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_CYLINDER", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_CYLINDER_MOTION", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_CYLINDER_DISPLAY", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_CYLINDER_MOTION_DISPLAY", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_SPHERE", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_SPHERE_MOTION", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_SPHERE_DISPLAY", read_rigidwall_geometric, identity},
    {"RIGIDWALL_GEOMETRIC_SPHERE_MOTION_DISPLAY", read_rigidwall_geometric, identity},
    {"CONTACT_AUTOMATIC_SINGLE_SURFACE", read_contact_single_surface, identity},
    {"CONTACT_AUTOMATIC_SINGLE_SURFACE_MORTAR", read_contact_single_surface, identity},
    {"CONTACT_AIRBAG_SINGLE_SURFACE", read_contact_single_surface, identity},
    {"CONTACT_SINGLE_SURFACE", read_contact_single_surface, identity},
    {"CONTACT_ERODING_SINGLE_SURFACE", read_contact_single_surface, identity},
    {"CONTACT_AUTOMATIC_GENERAL", read_contact_automatic_general, identity},
    {"CONTACT_AUTOMATIC_GENERAL_INTERIOR", read_contact_automatic_general, identity},
    {"CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", read_contact_automatic_surface_to_surface, identity},
    {"CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR", read_contact_automatic_surface_to_surface, identity},
    {"CONTACT_AUTOMATIC_NODES_TO_SURFACE", read_contact_automatic_nodes_to_surface, identity},
    {"CONTACT_AUTOMATIC_BEAMS_TO_SURFACE", read_contact_automatic_nodes_to_surface, identity},
    // The nodes of one surface against the segments of the other.
    {"CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", read_contact_automatic_nodes_to_surface, identity},
    {"CONTACT_ONE_WAY_SURFACE_TO_SURFACE", read_contact_nodes_to_surface, identity},
    {"CONTACT_SURFACE_TO_SURFACE", read_contact_surface_to_surface, identity},
    {"CONTACT_NODES_TO_SURFACE", read_contact_nodes_to_surface, identity},
    {"CONTACT_FORMING_SURFACE_TO_SURFACE", read_contact_forming_surface_to_surface, identity},
    {"CONTACT_FORMING_SURFACE_TO_SURFACE_MORTAR", read_contact_forming_surface_to_surface, identity},
    {"CONTACT_FORMING_ONE_WAY_SURFACE_TO_SURFACE", read_contact_forming_nodes_to_surface, identity},
    {"CONTACT_FORMING_NODES_TO_SURFACE", read_contact_forming_nodes_to_surface, identity},
    {"CONTACT_ERODING_SURFACE_TO_SURFACE", read_contact_eroding_surface_to_surface, identity},
    {"CONTACT_ERODING_NODES_TO_SURFACE", read_contact_eroding_nodes_to_surface, identity},
    {"CONTACT_CONSTRAINT_SURFACE_TO_SURFACE", read_contact_constraint_surface_to_surface, identity},
    {"CONTACT_CONSTRAINT_NODES_TO_SURFACE", read_contact_constraint_nodes_to_surface, identity},
    {"CONTACT_INTERIOR", read_contact_interior},
    {"CONTACT_FORCE_TRANSDUCER", read_contact_force_transducer, identity},
    {"CONTACT_FORCE_TRANSDUCER_PENALTY", read_contact_force_transducer, identity},
    {"CONTACT_TIED_NODES_TO_SURFACE", read_contact_tied, identity},
    {"CONTACT_TIED_NODES_TO_SURFACE_OFFSET", read_contact_tied_offset, identity},
    {"CONTACT_TIED_SURFACE_TO_SURFACE", read_contact_tied, identity},
    {"CONTACT_TIED_SURFACE_TO_SURFACE_OFFSET", read_contact_tied_offset, identity},
    {"CONTACT_TIED_SHELL_EDGE_TO_SURFACE", read_contact_tied_shell_edge, identity},
    {"CONTACT_SPOTWELD", read_contact_tied_shell_edge, identity},
    {"CONTACT_SPOTWELD_WITH_TORSION", read_contact_tied_shell_edge, identity},
    {"CONTACT_TIED_SHELL_EDGE_TO_SURFACE_OFFSET", read_contact_tied_offset, identity},
    {"CONTACT_TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET", read_contact_tied_offset, identity},
    {"CONTACT_TIED_SURFACE_TO_SURFACE_CONSTRAINED_OFFSET", read_contact_tied_offset, identity},
    {"CONTACT_TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET", read_contact_tied_shell_edge_beam_offset,
     identity},
    {"CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET", read_contact_tied_shell_edge_beam_offset, identity},
    {"CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", read_contact_automatic_tiebreak, identity},
    {"CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK", read_contact_automatic_one_way_tiebreak,
     identity},
    {"CONTACT_TIEBREAK_NODES_TO_SURFACE", read_contact_tiebreak_nodes, identity},
    {"CONTACT_TIEBREAK_SURFACE_TO_SURFACE", read_contact_tiebreak_surface, identity},

    {"CONTROL_TERMINATION", read_control_termination, none, false},
    {"TERMINATION_NODE", read_termination_node},
    {"TERMINATION_BODY", read_termination_body},
    {"TERMINATION_CONTACT", read_termination_contact},
    {"TERMINATION_DELETED_SHELLS", read_termination_deleted},
    {"TERMINATION_DELETED_SHELLS_SET", read_termination_deleted_set},
    {"TERMINATION_DELETED_SOLIDS", read_termination_deleted},
    {"TERMINATION_DELETED_SOLIDS_SET", read_termination_deleted_set},
    {"CONTROL_TIMESTEP", read_control_timestep, none, false},
    {"CONTROL_ENERGY", read_control_energy, none, false},
    {"CONTROL_HOURGLASS", read_control_hourglass, none, false},
    {"CONTROL_BULK_VISCOSITY", read_control_bulk_viscosity, none, false},
    {"CONTROL_ACCURACY", read_control_accuracy, none, false},
    {"CONTROL_SHELL", read_control_shell, none, false},
    {"CONTROL_SOLID", read_control_solid, none, false},
    {"CONTROL_SOLUTION", read_control_solution, none, false},
    {"CONTROL_CONTACT", read_control_contact, none, false},
    {"CONTROL_DYNAMIC_RELAXATION", read_control_dynamic_relaxation, none, false},
    {"CONTROL_IMPLICIT_GENERAL", read_control_implicit_general, none, false},

    {"DATABASE_GLSTAT", read_database<File::Glstat>, none, false},
    {"DATABASE_MATSUM", read_database<File::Matsum>, none, false},
    {"DATABASE_RWFORC", read_database<File::Rwforc>, none, false},
    {"DATABASE_RCFORC", read_database<File::Rcforc>, none, false},
    {"DATABASE_NODOUT", read_database<File::Nodout>, none, false},
    {"DATABASE_RBDOUT", read_database<File::Rbdout>, none, false},
    {"DATABASE_SLEOUT", read_database<File::Sleout>, none, false},
    {"DATABASE_SWFORC", read_database<File::Swforc>, none, false},
    {"DATABASE_JNTFORC", read_database<File::Jntforc>, none, false},
    {"DATABASE_ABSTAT", read_database<File::Abstat>, none, false},
    {"DATABASE_DEFORC", read_database<File::Deforc>, none, false},
    {"DATABASE_ELOUT", read_database<File::Elout>, none, false},
    {"DATABASE_SPCFORC", read_database<File::Spcforc>, none, false},
    {"DATABASE_SECFORC", read_database<File::Secforc>, none, false},
    {"DATABASE_NCFORC", read_database<File::Ncforc>, none, false},
    {"DATABASE_HISTORY_NODE", read_history<Traced::Node>},
    {"DATABASE_HISTORY_NODE_ID", read_named_history<Traced::Node>},
    {"DATABASE_HISTORY_NODE_SET", read_history_set<Traced::Node>},
    {"DATABASE_HISTORY_NODE_LOCAL", read_database_history_node_local},
    {"DATABASE_HISTORY_NODE_SET_LOCAL", read_database_history_node_set_local},
    {"DATABASE_HISTORY_SHELL", read_history<Traced::Shell>},
    {"DATABASE_HISTORY_SHELL_ID", read_named_history<Traced::Shell>},
    {"DATABASE_HISTORY_SHELL_SET", read_history_set<Traced::Shell>},
    {"DATABASE_HISTORY_SOLID", read_history<Traced::Solid>},
    {"DATABASE_HISTORY_SOLID_ID", read_named_history<Traced::Solid>},
    {"DATABASE_HISTORY_SOLID_SET", read_history_set<Traced::Solid>},
    {"DATABASE_HISTORY_BEAM", read_history<Traced::Beam>},
    {"DATABASE_HISTORY_BEAM_ID", read_named_history<Traced::Beam>},
    {"DATABASE_HISTORY_BEAM_SET", read_history_set<Traced::Beam>},
    {"DATABASE_HISTORY_DISCRETE", read_history<Traced::Discrete>},
    {"DATABASE_HISTORY_DISCRETE_ID", read_named_history<Traced::Discrete>},
    {"DATABASE_HISTORY_DISCRETE_SET", read_history_set<Traced::Discrete>},
    {"DATABASE_CROSS_SECTION_SET", read_database_cross_section_set, identity},
    {"DATABASE_CROSS_SECTION_PLANE", read_database_cross_section_plane, identity},
    {"DATABASE_EXTENT_BINARY", read_database_extent_binary, none, false},
    {"DATABASE_BINARY_D3PLOT", read_database_binary_d3plot, none, false},
    {"DATABASE_BINARY_D3DUMP", read_database_binary_d3dump, none, false},
    {"DATABASE_BINARY_RUNRSF", read_database_binary_runrsf, none, false},
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// `MAT_3` and `MAT_03` are MAT_003, and likewise of EOS.
std::string with_three_digits(std::string_view name) {
  constexpr std::string_view prefix = "MAT_";
  if (!name.starts_with(prefix) && !name.starts_with("EOS_")) return std::string(name);
  std::string_view rest = name.substr(prefix.size());
  std::size_t digits = 0;
  while (digits < rest.size() && is_digit(rest[digits])) ++digits;
  if (digits == 0 || digits >= 3 || (digits < rest.size() && rest[digits] != '_')) return std::string(name);
  return fmt::format("{}{:0>3}{}", name.substr(0, prefix.size()), rest.substr(0, digits),
                     rest.substr(digits));
}

/// An option that may stand anywhere in a name, taken out.
std::string without_option(std::string name, std::string_view family, std::string_view option) {
  const std::size_t at = name.starts_with(family) ? name.find(option) : std::string::npos;
  const bool is_option =
      at != std::string::npos && (at + option.size() == name.size() || name[at + option.size()] == '_');
  return is_option ? name.erase(at, option.size()) : name;
}

/// The words of a name, those behind the first two sorted: options stand in any order. "NODES_TO_SURFACE" is
/// one.
std::vector<std::string> words_in_order(std::string_view name) {
  std::vector<std::string> words;
  bool goes_on = false;
  for (std::size_t start = 0; start <= name.size();) {
    const std::size_t end = std::min(name.find('_', start), name.size());
    const std::string word(name.substr(start, end - start));
    if (goes_on || (word == "TO" && !words.empty()))
      words.back() += "_" + word;
    else
      words.push_back(word);
    goes_on = word == "TO";
    start = end + 1;
  }
  if (words.size() > 2) std::sort(words.begin() + 2, words.end());
  return words;
}

const Keyword* find_exact(std::string_view name) {
  const auto found =
      std::find_if(std::begin(table), std::end(table), [&](const Keyword& k) { return k.name == name; });
  return found == std::end(table) ? nullptr : found;
}

/// The keyword of this name, or of one whose options stand in another order. The names of materials,
/// equations of state and controls are no lists of options.
const Keyword* find_in_any_order(std::string_view name) {
  if (const Keyword* keyword = find_exact(name)) return keyword;
  for (const std::string_view family : {"MAT_", "EOS_", "CONTROL_"})
    if (name.starts_with(family)) return nullptr;
  const std::vector<std::string> words = words_in_order(name);
  const auto found = std::find_if(std::begin(table), std::end(table), [&](const Keyword& keyword) {
    return keyword.name.size() == name.size() && words_in_order(keyword.name) == words;
  });
  return found == std::end(table) ? nullptr : found;
}

}  // namespace

std::span<const Keyword> keyword_table() {
  return table;
}

std::string canonical_name(std::string_view name) {
  return without_option(without_option(with_three_digits(name), "SET_", "_COLLECT"), "CONTACT_", "_MPP");
}

std::optional<FoundKeyword> find_keyword(std::string_view name) {
  const std::string full = canonical_name(name);
  if (const Keyword* keyword = find_in_any_order(full)) return FoundKeyword{keyword, none};
  const std::string titled = without_option(full, "", "_TITLE");
  const std::string named = without_option(titled, "", "_ID");
  const Keyword* keyword = titled == full ? nullptr : find_in_any_order(titled);
  if (keyword && keyword->heading != none) return FoundKeyword{keyword, keyword->heading};
  keyword = named == titled ? nullptr : find_in_any_order(named);
  if (keyword && keyword->heading == identity) return FoundKeyword{keyword, identity};
  return std::nullopt;
}

}  // namespace crumple::deck
