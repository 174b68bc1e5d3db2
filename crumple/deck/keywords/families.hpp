// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/format/cards.hpp"
#include "deck/format/raw_deck.hpp"

namespace crumple::deck {

/// Of a load along or about the normal of three nodes (DOF 4 or 8): false, with a message, if M1, M2, M3 are
/// not three nodes.
bool check_followed_nodes(const Card& card, Report& report);

/// The readers of the keywords, one file per family (read_*.cpp). Each takes the cards of one keyword and
/// adds what they say to the raw deck.
using KeywordReader = void (*)(Cards& cards, RawDeck& deck);

// read_mesh.cpp
void read_node(Cards& cards, RawDeck& deck);
void read_element_shell(Cards& cards, RawDeck& deck);
void read_element_shell_thickness(Cards& cards, RawDeck& deck);
void read_element_shell_mcid(Cards& cards, RawDeck& deck);
void read_element_shell_offset(Cards& cards, RawDeck& deck);
void read_element_shell_dof(Cards& cards, RawDeck& deck);
void read_element_mass(Cards& cards, RawDeck& deck);
void read_element_mass_node_set(Cards& cards, RawDeck& deck);
void read_element_seatbelt_accelerometer(Cards& cards, RawDeck& deck);

// read_transformations.cpp
void read_define_transformation(Cards& cards, RawDeck& deck);
void read_node_transform(Cards& cards, RawDeck& deck);

// read_solids.cpp
void read_element_solid(Cards& cards, RawDeck& deck);
void read_section_solid(Cards& cards, RawDeck& deck);

// read_beams.cpp
void read_element_beam(Cards& cards, RawDeck& deck);
void read_element_beam_orientation(Cards& cards, RawDeck& deck);
void read_mat_resultant_plasticity(Cards& cards, RawDeck& deck);
// read_beam_sections.cpp
void read_section_beam(Cards& cards, RawDeck& deck);
// read_integration_beam.cpp
void read_integration_beam(Cards& cards, RawDeck& deck);
// read_discrete_beam_materials.cpp
void read_mat_linear_elastic_discrete_beam(Cards& cards, RawDeck& deck);
void read_mat_nonlinear_elastic_discrete_beam(Cards& cards, RawDeck& deck);
void read_mat_cable_discrete_beam(Cards& cards, RawDeck& deck);
void read_mat_elastic_spring_discrete_beam(Cards& cards, RawDeck& deck);
void read_mat_general_nonlinear_6dof(Cards& cards, RawDeck& deck);
void read_mat_general_nonlinear_1dof(Cards& cards, RawDeck& deck);
// read_spot_weld_materials.cpp
void read_mat_spotweld(Cards& cards, RawDeck& deck);
void read_mat_spotweld_damage_failure(Cards& cards, RawDeck& deck);

// read_discretes.cpp
void read_element_discrete(Cards& cards, RawDeck& deck);
void read_element_inertia(Cards& cards, RawDeck& deck);
void read_section_discrete(Cards& cards, RawDeck& deck);
void read_define_sd_orientation(Cards& cards, RawDeck& deck);
void read_mat_spring_elastic(Cards& cards, RawDeck& deck);
void read_mat_damper_viscous(Cards& cards, RawDeck& deck);
void read_mat_spring_elastoplastic(Cards& cards, RawDeck& deck);
void read_mat_spring_nonlinear_elastic(Cards& cards, RawDeck& deck);
void read_mat_damper_nonlinear_viscous(Cards& cards, RawDeck& deck);
void read_mat_spring_maxwell(Cards& cards, RawDeck& deck);
void read_mat_spring_inelastic(Cards& cards, RawDeck& deck);

// read_parts.cpp
void read_part(Cards& cards, RawDeck& deck);
void read_part_inertia(Cards& cards, RawDeck& deck);
void read_section_shell(Cards& cards, RawDeck& deck);
void read_hourglass(Cards& cards, RawDeck& deck);
// read_layups.cpp
void read_part_composite(Cards& cards, RawDeck& deck);
void read_part_composite_long(Cards& cards, RawDeck& deck);
void read_element_shell_composite(Cards& cards, RawDeck& deck);
void read_integration_shell(Cards& cards, RawDeck& deck);
/// The shell of a card of *ELEMENT_SHELL; false, with a message, if its ids could not be read.
bool read_shell(Cards& cards, RawShell& shell);
/// OPTT and SFT of the card that _CONTACT adds to *PART.
void read_part_contact(Cards& cards, RawPart& part);

// read_materials.cpp
void read_mat_elastic(Cards& cards, RawDeck& deck);
void read_mat_plastic_kinematic(Cards& cards, RawDeck& deck);
void read_mat_isotropic_elastic_plastic(Cards& cards, RawDeck& deck);
void read_mat_isotropic_elastic_failure(Cards& cards, RawDeck& deck);
void read_mat_piecewise_linear_plasticity(Cards& cards, RawDeck& deck);
void read_mat_modified_piecewise_linear_plasticity(Cards& cards, RawDeck& deck);
void read_mat_plasticity_with_damage(Cards& cards, RawDeck& deck);
// read_compression_tension.cpp
void read_mat_plasticity_compression_tension(Cards& cards, RawDeck& deck);
// read_rate_materials.cpp
void read_mat_power_law_plasticity(Cards& cards, RawDeck& deck);
void read_mat_johnson_cook(Cards& cards, RawDeck& deck);
void read_mat_simplified_johnson_cook(Cards& cards, RawDeck& deck);
// read_hydro_materials.cpp
void read_mat_elastic_plastic_hydro(Cards& cards, RawDeck& deck);
void read_mat_elastic_plastic_hydro_spall(Cards& cards, RawDeck& deck);
// read_elastic_materials.cpp
void read_mat_orthotropic_elastic(Cards& cards, RawDeck& deck);
void read_mat_null(Cards& cards, RawDeck& deck);
// read_composite_materials.cpp
void read_mat_composite_damage(Cards& cards, RawDeck& deck);
void read_mat_enhanced_composite_damage(Cards& cards, RawDeck& deck);
// read_fabric.cpp
void read_mat_fabric(Cards& cards, RawDeck& deck);

// read_solid_materials.cpp
void read_mat_blatz_ko_rubber(Cards& cards, RawDeck& deck);
void read_mat_mooney_rivlin_rubber(Cards& cards, RawDeck& deck);
void read_mat_crushable_foam(Cards& cards, RawDeck& deck);
void read_mat_add_erosion(Cards& cards, RawDeck& deck);
void read_mat_add_damage_gissmo(Cards& cards, RawDeck& deck);
void read_mat_low_density_foam(Cards& cards, RawDeck& deck);
void read_mat_fu_chang_foam(Cards& cards, RawDeck& deck);
void read_mat_ogden_rubber(Cards& cards, RawDeck& deck);
void read_mat_hyperelastic_rubber(Cards& cards, RawDeck& deck);
void read_mat_viscoelastic(Cards& cards, RawDeck& deck);
void read_mat_general_viscoelastic(Cards& cards, RawDeck& deck);
// read_honeycomb.cpp
void read_mat_honeycomb(Cards& cards, RawDeck& deck);
void read_mat_modified_honeycomb(Cards& cards, RawDeck& deck);
// read_more_foams.cpp
void read_mat_soil_and_foam(Cards& cards, RawDeck& deck);
// read_concrete.cpp
void read_mat_cscm(Cards& cards, RawDeck& deck);
void read_mat_cscm_concrete(Cards& cards, RawDeck& deck);
// read_damaged_concrete.cpp
void read_mat_concrete_damage_rel3(Cards& cards, RawDeck& deck);
// read_johnson_holmquist.cpp
void read_mat_johnson_holmquist_ceramics(Cards& cards, RawDeck& deck);
void read_mat_johnson_holmquist_concrete(Cards& cards, RawDeck& deck);
// read_cohesive_materials.cpp
void read_mat_cohesive_mixed_mode(Cards& cards, RawDeck& deck);
void read_mat_cohesive_elastic(Cards& cards, RawDeck& deck);
void read_mat_bilkhu_dubois_foam(Cards& cards, RawDeck& deck);
void read_mat_viscous_foam(Cards& cards, RawDeck& deck);
void read_mat_simplified_rubber(Cards& cards, RawDeck& deck);
// read_sheet_materials.cpp
void read_mat_transversely_anisotropic(Cards& cards, RawDeck& deck);
void read_mat_barlat(Cards& cards, RawDeck& deck);
// read_laminated_fabric.cpp
void read_mat_laminated_composite_fabric(Cards& cards, RawDeck& deck);
// read_equations_of_state.cpp
void read_eos_linear_polynomial(Cards& cards, RawDeck& deck);
void read_eos_gruneisen(Cards& cards, RawDeck& deck);

// read_curves.cpp
void read_define_curve(Cards& cards, RawDeck& deck);
void read_define_curve_function(Cards& cards, RawDeck& deck);
void read_define_curve_smooth(Cards& cards, RawDeck& deck);
void read_define_table(Cards& cards, RawDeck& deck);
void read_define_table_2d(Cards& cards, RawDeck& deck);

// coordinates.cpp
void read_define_coordinate_system(Cards& cards, RawDeck& deck);
void read_define_coordinate_nodes(Cards& cards, RawDeck& deck);
void read_define_coordinate_vector(Cards& cards, RawDeck& deck);
void read_define_vector(Cards& cards, RawDeck& deck);

// read_sets.cpp
void read_define_box(Cards& cards, RawDeck& deck);
/// What the members of a set are. Segments, which have no ids, are read apart.
enum class SetItem { Node, Part, Shell, Solid, Beam, Discrete };
/// How the cards of a set give its members.
enum class SetForm { List, Column, Generate, GenerateIncrement, General, Add };
void read_set_of(Cards& cards, RawDeck& deck, SetItem item, SetForm form);
template <SetItem Kind, SetForm Form>
void read_set(Cards& cards, RawDeck& deck) {
  read_set_of(cards, deck, Kind, Form);
}
void read_set_segment(Cards& cards, RawDeck& deck);
void read_set_segment_general(Cards& cards, RawDeck& deck);
void read_set_segment_add(Cards& cards, RawDeck& deck);

// read_control.cpp
void read_title(Cards& cards, RawDeck& deck);
void read_termination_node(Cards& cards, RawDeck& deck);
void read_termination_body(Cards& cards, RawDeck& deck);
void read_termination_contact(Cards& cards, RawDeck& deck);
void read_termination_deleted(Cards& cards, RawDeck& deck);
void read_termination_deleted_set(Cards& cards, RawDeck& deck);
void read_control_termination(Cards& cards, RawDeck& deck);
void read_control_timestep(Cards& cards, RawDeck& deck);
void read_control_energy(Cards& cards, RawDeck& deck);
void read_control_hourglass(Cards& cards, RawDeck& deck);
void read_control_bulk_viscosity(Cards& cards, RawDeck& deck);
void read_control_accuracy(Cards& cards, RawDeck& deck);
void read_control_implicit_general(Cards& cards, RawDeck& deck);

// read_relaxation.cpp
void read_control_dynamic_relaxation(Cards& cards, RawDeck& deck);

// read_control_shell.cpp
void read_control_shell(Cards& cards, RawDeck& deck);
void read_control_solid(Cards& cards, RawDeck& deck);
void read_control_solution(Cards& cards, RawDeck& deck);

// read_control_contact.cpp
void read_control_contact(Cards& cards, RawDeck& deck);

// read_database.cpp
void read_database_history_file(Cards& cards, RawDeck& deck, model::HistoryFile file);
template <model::HistoryFile WhichFile>
void read_database(Cards& cards, RawDeck& deck) {
  read_database_history_file(cards, deck, WhichFile);
}
void read_database_history_ids(Cards& cards, RawDeck& deck, HistoryItem item);
void read_database_history_named(Cards& cards, RawDeck& deck, HistoryItem item);
void read_database_history_sets(Cards& cards, RawDeck& deck, HistoryItem item);
void read_database_history_node_local(Cards& cards, RawDeck& deck);
void read_database_history_node_set_local(Cards& cards, RawDeck& deck);
template <HistoryItem Kind>
void read_history(Cards& cards, RawDeck& deck) {
  read_database_history_ids(cards, deck, Kind);
}
template <HistoryItem Kind>
void read_named_history(Cards& cards, RawDeck& deck) {
  read_database_history_named(cards, deck, Kind);
}
template <HistoryItem Kind>
void read_history_set(Cards& cards, RawDeck& deck) {
  read_database_history_sets(cards, deck, Kind);
}
void read_database_binary_d3plot(Cards& cards, RawDeck& deck);
void read_database_binary_d3dump(Cards& cards, RawDeck& deck);
void read_database_binary_runrsf(Cards& cards, RawDeck& deck);
void read_database_extent_binary(Cards& cards, RawDeck& deck);

// read_cross_sections.cpp
void read_database_cross_section_set(Cards& cards, RawDeck& deck);
void read_database_cross_section_plane(Cards& cards, RawDeck& deck);

// read_conditions.cpp
void read_boundary_spc_node(Cards& cards, RawDeck& deck);
void read_boundary_spc_set(Cards& cards, RawDeck& deck);
void read_boundary_spc_node_birth_death(Cards& cards, RawDeck& deck);
void read_boundary_spc_set_birth_death(Cards& cards, RawDeck& deck);
void read_initial_velocity(Cards& cards, RawDeck& deck);
void read_initial_velocity_node(Cards& cards, RawDeck& deck);
void read_initial_velocity_generation(Cards& cards, RawDeck& deck);
void read_initial_velocity_generation_start_time(Cards& cards, RawDeck& deck);
// read_initial_stress.cpp
void read_initial_stress_shell(Cards& cards, RawDeck& deck);
void read_initial_stress_shell_set(Cards& cards, RawDeck& deck);
void read_initial_stress_solid(Cards& cards, RawDeck& deck);
void read_initial_stress_solid_set(Cards& cards, RawDeck& deck);
// read_springback.cpp
void read_interface_springback_lsdyna(Cards& cards, RawDeck& deck);

// read_connections.cpp
void read_constrained_spotweld(Cards& cards, RawDeck& deck);
void read_constrained_generalized_weld_spot(Cards& cards, RawDeck& deck);
void read_constrained_shell_to_solid(Cards& cards, RawDeck& deck);
void read_constrained_rivet(Cards& cards, RawDeck& deck);
void read_constrained_node_set(Cards& cards, RawDeck& deck);
// read_joints.cpp
void read_constrained_joint(Cards& cards, RawDeck& deck, model::JointKind kind);
template <model::JointKind Kind>
void read_joint(Cards& cards, RawDeck& deck) {
  read_constrained_joint(cards, deck, Kind);
}
void read_constrained_linear_global(Cards& cards, RawDeck& deck);
void read_constrained_adaptivity(Cards& cards, RawDeck& deck);
void read_constrained_interpolation(Cards& cards, RawDeck& deck);
void read_deformable_to_rigid(Cards& cards, RawDeck& deck);
void read_constrained_global(Cards& cards, RawDeck& deck);
// read_embedded_beams.cpp
void read_constrained_beam_in_solid(Cards& cards, RawDeck& deck);
void read_constrained_beam_in_solid_penalty(Cards& cards, RawDeck& deck);
void read_constrained_lagrange_in_solid(Cards& cards, RawDeck& deck);
// read_joint_stiffness.cpp
void read_constrained_joint_stiffness_generalized(Cards& cards, RawDeck& deck);
void read_constrained_joint_stiffness_translational(Cards& cards, RawDeck& deck);
// read_rigid_bodies.cpp
void read_mat_rigid(Cards& cards, RawDeck& deck);
void read_constrained_rigid_bodies(Cards& cards, RawDeck& deck);
void read_initial_velocity_rigid_body(Cards& cards, RawDeck& deck);
void read_constrained_extra_nodes_node(Cards& cards, RawDeck& deck);
void read_constrained_extra_nodes_set(Cards& cards, RawDeck& deck);
void read_constrained_nodal_rigid_body(Cards& cards, RawDeck& deck);
void read_constrained_nodal_rigid_body_inertia(Cards& cards, RawDeck& deck);
void read_constrained_nodal_rigid_body_spc(Cards& cards, RawDeck& deck);
void read_constrained_nodal_rigid_body_spc_inertia(Cards& cards, RawDeck& deck);

// read_motions.cpp
void read_boundary_prescribed_motion_node(Cards& cards, RawDeck& deck);
void read_boundary_prescribed_motion_set(Cards& cards, RawDeck& deck);
void read_boundary_prescribed_motion_rigid(Cards& cards, RawDeck& deck);
void read_load_body_x(Cards& cards, RawDeck& deck);
void read_load_body_y(Cards& cards, RawDeck& deck);
void read_load_body_z(Cards& cards, RawDeck& deck);
void read_load_rigid_body(Cards& cards, RawDeck& deck);

// read_inertia_fields.cpp
void read_load_body_rx(Cards& cards, RawDeck& deck);
void read_load_body_ry(Cards& cards, RawDeck& deck);
void read_load_body_rz(Cards& cards, RawDeck& deck);
void read_load_body_vector(Cards& cards, RawDeck& deck);
void read_load_body_parts(Cards& cards, RawDeck& deck);
void read_load_body_generalized(Cards& cards, RawDeck& deck);
void read_load_body_generalized_set_node(Cards& cards, RawDeck& deck);
void read_load_body_generalized_set_part(Cards& cards, RawDeck& deck);
void read_load_gravity_part(Cards& cards, RawDeck& deck);
void read_load_gravity_part_set(Cards& cards, RawDeck& deck);

// read_non_reflecting.cpp
void read_boundary_non_reflecting(Cards& cards, RawDeck& deck);

// read_damping.cpp
void read_damping_global(Cards& cards, RawDeck& deck);
void read_damping_part_mass(Cards& cards, RawDeck& deck);
void read_damping_part_mass_set(Cards& cards, RawDeck& deck);
void read_damping_part_stiffness(Cards& cards, RawDeck& deck);
void read_damping_part_stiffness_set(Cards& cards, RawDeck& deck);
void read_damping_relative(Cards& cards, RawDeck& deck);
void read_element_mass_part(Cards& cards, RawDeck& deck);
void read_element_mass_part_set(Cards& cards, RawDeck& deck);

// read_loads.cpp
void read_load_node_point(Cards& cards, RawDeck& deck);
void read_load_node_set(Cards& cards, RawDeck& deck);
void read_load_segment(Cards& cards, RawDeck& deck);
void read_load_segment_set(Cards& cards, RawDeck& deck);
void read_load_shell_element(Cards& cards, RawDeck& deck);
void read_load_shell_set(Cards& cards, RawDeck& deck);

// read_blasts.cpp
void read_load_blast_enhanced(Cards& cards, RawDeck& deck);
void read_load_blast_segment(Cards& cards, RawDeck& deck);
void read_load_blast_segment_set(Cards& cards, RawDeck& deck);

// read_airbags.cpp
void read_airbag_simple_pressure_volume(Cards& cards, RawDeck& deck);
void read_airbag_adiabatic_gas_model(Cards& cards, RawDeck& deck);
void read_airbag_linear_fluid(Cards& cards, RawDeck& deck);
void read_airbag_simple_airbag_model(Cards& cards, RawDeck& deck);
void read_airbag_wang_nefske(Cards& cards, RawDeck& deck);

// read_contact.cpp
void read_rigidwall_planar(Cards& cards, RawDeck& deck);
void read_rigidwall_geometric(Cards& cards, RawDeck& deck);
void read_contact_single_surface(Cards& cards, RawDeck& deck);
void read_contact_automatic_general(Cards& cards, RawDeck& deck);
void read_contact_automatic_surface_to_surface(Cards& cards, RawDeck& deck);
void read_contact_automatic_nodes_to_surface(Cards& cards, RawDeck& deck);
void read_contact_surface_to_surface(Cards& cards, RawDeck& deck);
void read_contact_forming_surface_to_surface(Cards& cards, RawDeck& deck);
void read_contact_forming_nodes_to_surface(Cards& cards, RawDeck& deck);
void read_contact_nodes_to_surface(Cards& cards, RawDeck& deck);
void read_contact_eroding_surface_to_surface(Cards& cards, RawDeck& deck);
void read_contact_eroding_nodes_to_surface(Cards& cards, RawDeck& deck);
void read_contact_constraint_surface_to_surface(Cards& cards, RawDeck& deck);
void read_contact_constraint_nodes_to_surface(Cards& cards, RawDeck& deck);
void read_contact_force_transducer(Cards& cards, RawDeck& deck);
void read_contact_interior(Cards& cards, RawDeck& deck);

// read_symmetry_planes.cpp
void read_boundary_spc_symmetry_plane(Cards& cards, RawDeck& deck);
void read_boundary_spc_symmetry_plane_set(Cards& cards, RawDeck& deck);

// read_stoppers.cpp
void read_constrained_rigid_body_stoppers(Cards& cards, RawDeck& deck);

// read_friction.cpp
void read_define_friction(Cards& cards, RawDeck& deck);

// read_tied_contact.cpp
void read_contact_tied(Cards& cards, RawDeck& deck);
void read_contact_tied_offset(Cards& cards, RawDeck& deck);
void read_contact_tied_shell_edge(Cards& cards, RawDeck& deck);
void read_contact_tied_edge_to_solid(Cards& cards, RawDeck& deck);
void read_contact_tied_edge_offset(Cards& cards, RawDeck& deck);
void read_contact_automatic_tiebreak(Cards& cards, RawDeck& deck);
void read_contact_automatic_one_way_tiebreak(Cards& cards, RawDeck& deck);
void read_contact_tiebreak_nodes(Cards& cards, RawDeck& deck);
void read_contact_tiebreak_surface(Cards& cards, RawDeck& deck);

/// Which forms of hourglass control there are, and what instead of the others.
inline constexpr std::string_view hourglass_forms =
    "1-3 are viscous, 4-5 stiffness, 6 assumed strain of solids, 0 is 1 for shells and 2 for solids, and 8 "
    "the same: "
    "the warping stiffness that it adds to ELFORM 16 is always there; 7, 9 and 10, for solids, are computed "
    "as 6";
/// What HGID's and CONTROL_HOURGLASS' form number means for shells.
model::HourglassForm hourglass_form(std::int64_t number);
/// What it means for solids.
model::SolidHourglassForm solid_hourglass_form(std::int64_t number);
/// Warns of a form of hourglass control that another one stands for.
void warn_of_hourglass_form(const Card& card, Report& report);
/// Warns of a hourglass coefficient above what LS-DYNA recommends.
void warn_of_hourglass_coefficient(const Card& card, std::string_view field, Report& report);
/// ELFORM of *SECTION_SHELL and THEORY of *CONTROL_SHELL; other numbers are Belytschko-Tsay.
model::ShellFormulation shell_formulation(std::int64_t number);

}  // namespace crumple::deck
