// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/index.hpp"
#include "deck/format/raw_connections.hpp"
#include "deck/format/raw_friction.hpp"
#include "deck/format/raw_loads.hpp"
#include "deck/format/raw_properties.hpp"
#include "deck/format/raw_transformation.hpp"
#include "deck/format/report.hpp"
#include "model/model.hpp"

namespace crumple::deck {

/// What the cards say, item by item, before references are followed: user ids instead of indices, and the
/// place of everything. Numbers have been checked one by one; whether items fit together has not.

struct RawNode {
  UserId id = 0;
  std::array<double, 3> position{};
  int translation_code = 0;  ///< TC
  int rotation_code = 0;     ///< RC
  Where where;
};

struct RawShell {
  UserId id = 0;
  UserId part = 0;
  std::array<UserId, 4> node{};
  std::array<double, 4> thickness{};
  double material_angle = 0;   ///< [rad]
  UserId material_system = 0;  ///< MCID: its x is the first axis of the material; 0 is none
  Where where;
  std::size_t layers = 0;  ///< of *ELEMENT_SHELL_COMPOSITE: place in RawDeck::element_layers, from 1; 0: none
};

/// One layer of *PART_COMPOSITE or *ELEMENT_SHELL_COMPOSITE.
struct RawLayer {
  UserId material = 0;
  double thickness = 0;
  double angle = 0;  ///< [rad]
  std::string_view field;
  Where where;
};

/// One point of *INTEGRATION_SHELL.
struct RawIntegrationPoint {
  double place = 0;
  double share = 0;
  UserId part = 0;  ///< 0: the element's own
  Where where;
};

/// *INTEGRATION_SHELL.
struct RawIntegrationRule {
  UserId id = 0;
  std::vector<RawIntegrationPoint> points;
  bool unfailing_layers_hold = false;
  Where where;
};

struct RawSolid {
  UserId id = 0;
  UserId part = 0;
  std::array<UserId, 8> node{};
  std::array<UserId, 6> middle{};  ///< N5 to N10 of a tetrahedron with ten nodes, else zero
  Where where;
  Where nodes_where;  ///< of the card with the nodes
};

struct RawBeam {
  UserId id = 0;
  UserId part = 0;
  std::array<UserId, 2> node{};
  UserId orientation_node = 0;
  std::array<double, 3> orientation{};
  Where where;
};

struct RawDiscrete {
  UserId id = 0;
  UserId part = 0;
  std::array<UserId, 2> node{};  ///< the second is zero if that end is held
  UserId orientation = 0;        ///< VID
  double scale = 1;
  double offset = 0;
  Where where;
};

/// A direction in which springs and dampers act.
struct RawOrientation {
  UserId id = 0;
  std::array<double, 3> vector{};  ///< not zero
  Where where;
};

struct RawMass {
  UserId id = 0;
  UserId target = 0;  ///< a node, or a node set
  bool is_set = false;
  double mass = 0;
  Where where;
  double inertia = 0;
};

struct RawPart {
  static constexpr UserId unreadable = -1;  ///< has been reported

  UserId id = 0;
  std::string title;
  UserId section = 0;   ///< 0 is none
  UserId material = 0;  ///< 0 is none
  UserId hourglass = 0;
  std::optional<RawInertia> inertia{};
  UserId equation_of_state = 0;
  double contact_thickness = 0;               ///< OPTT; 0 is none
  double contact_thickness_scale = 1;         ///< SFT
  std::optional<model::Friction> friction{};  ///< of *PART_CONTACT
  Where where;
  std::vector<RawLayer> layers{};  ///< of *PART_COMPOSITE
  std::size_t own_section = 0;     ///< then its place in RawDeck::sections
};

struct RawCurve {
  model::Curve curve;
  std::string function;  ///< of TIME, instead of points
  double delay = 0;      ///< SFA OFFA: before it what the curve drives over time is zero [abscissa]
  enum class Phase { Run, Relaxation, Both };
  Phase phase = Phase::Run;  ///< SIDR, where loads and motions by it act
  Where where;
};

/// Curves over a second variable.
struct RawTable {
  UserId id = 0;
  std::vector<double> value;
  std::vector<UserId> curve;    ///< of each value; empty: the curves defined next after the table
  std::size_t first_curve = 0;  ///< place in RawDeck::curves of the first of those
  Where where;
};

/// Axes that are fixed in space, by two vectors or by three nodes.
struct RawCoordinateSystem {
  UserId id = 0;
  std::array<double, 3> first{};   ///< along the x axis
  std::array<double, 3> other{};   ///< in the xy plane
  std::array<UserId, 3> node{};    ///< origin, on the x axis, in the xy plane; 0: the vectors count
  std::array<double, 3> origin{};  ///< where there are no nodes
  Where where;
};

/// A box with sides along the global axes.
struct RawBox {
  UserId id = 0;
  std::array<double, 3> lowest{};
  std::array<double, 3> highest{};
  Where where;
};

/// Something to put into a set, or to take out again: a member, a range of members, or what an item has.
struct RawMember {
  enum class What {
    Member,
    All,
    Part,
    Box,
    BoxOfShells,
    BoxOfSolids,
    Shell,
    Solid,
    Beam,
    Discrete,
    Segment,
    OwnSet,
    ShellSet,
    SolidSet,
    BeamSet,
    DiscreteSet,
    PartWithInside,      ///< faces between its solids as well
    BoxOfAllFaces,       ///< faces of solids, likewise
    SolidSetWithInside,  ///< likewise
  };
  What what = What::Member;
  bool removes = false;
  UserId first = 0;
  UserId last = 0;               ///< of a range; otherwise the same
  UserId increment = 1;          ///< of a range
  std::array<UserId, 4> node{};  ///< of a segment
  std::string_view field;
  Where where;
};

struct RawSet {
  UserId id = 0;
  std::string title;
  std::vector<RawMember> members;
  std::array<double, 4> attributes{};  ///< DA1 to DA4
  bool collects = false;               ///< sets with COLLECT and the same id are one
  Where where;
};

/// A part set of *CONTACT_INTERIOR.
struct RawInterior {
  UserId part_set = 0;
  std::string_view field;
  Where where;
};

struct RawVelocity {
  enum class Target { All, NodeSet, Node, Part, PartSet };
  Target target = Target::All;
  UserId id = 0;
  std::array<double, 3> velocity{};
  std::array<double, 3> angular_velocity{};
  /// Rotation about an axis through a point (GENERATION), added to `velocity`.
  bool rotates = false;
  std::array<double, 3> spin{};  ///< vector of the angular velocity
  std::array<double, 3> axis_point{};
  UserId exempt_set = 0;  ///< nodes of this set get the two below
  std::array<double, 3> exempt_velocity{};
  std::array<double, 3> exempt_angular_velocity{};
  bool is_generation = false;
  bool replaces_given = false;   ///< IRIGID: velocities that come with a given inertia do not count
  bool of_whole_bodies = false;  ///< IVATN: of the nodes tied to these, too
  UserId system = 0;             ///< ICID, of velocities and spins; 0 is global axes
  UserId box = 0;                ///< only nodes in it; 0 is all
  bool begins_at_once = false;   ///< PHASE = 0: with a dynamic relaxation, if there is one
  Where where;
};

struct RawWall {
  model::RigidWall wall;
  UserId node_set = 0;
  UserId exempt_set = 0;
  UserId box = 0;
  UserId motion_curve = 0;
  Where motion_where;
  Where where;
};

/// What one side of a contact consists of.
struct RawContactSide {
  enum class Target { All, Part, PartSet, AllButPartSet, SegmentSet, ShellSet, NodeSet };
  Target target = Target::All;
  UserId id = 0;
  UserId box = 0;
  std::string_view field;      ///< SSID or MSID
  std::string_view box_field;  ///< SBOXID or MBOXID
};

struct RawContact {
  model::Contact contact;
  std::array<RawContactSide, 2> side;       ///< of contact with itself the first alone
  bool takes_own_thickness_option = false;  ///< THKOPT: not that of *CONTROL_CONTACT
  int thickness_option = 0;                 ///< SHLTHK
  bool only_measures = false;               ///< a force transducer
  FrictionSource friction = FrictionSource::Contact;
  UserId friction_table = 0;  ///< 0: the only one
  double friction_scale = 1;  ///< FSF
  double stress_scale = 1;    ///< VSF
  Where friction_where;
  Where where;
};

/// A tied contact, with what it becomes where it has broken.
struct RawTiedContact {
  model::TiedContact tied;
  std::array<RawContactSide, 2> side{};
  std::optional<model::Contact> afterwards{};
  Where where;
};

/// What *DATABASE_HISTORY names.
enum class HistoryItem { Node, Shell, Solid, Beam, Discrete };

/// *TERMINATION. What it is about by id.
struct RawTermination {
  model::Termination termination;
  bool is_set = false;  ///< a set of parts
  Where where;
};

struct RawHistory {
  UserId id = 0;
  bool is_set = false;
  Where where;
  HistoryItem item = HistoryItem::Node;
  UserId system = 0;    ///< of nodes: the coordinate system of their motion; 0 is global axes
  bool moving = false;  ///< REF = 1: it moves with its nodes
};

/// A plane through the elements of some parts.
struct RawCutPlane {
  UserId part_set = 0;             ///< 0: all parts
  std::array<double, 3> point{};   ///< the tail of the normal; where the edges begin
  std::array<double, 3> normal{};  ///< not yet of length one
  double radius = 0;               ///< of a circle around the point; 0: it is none
  std::array<double, 3> edge{};    ///< direction of the first edge
  double length = 0;               ///< of the first edge; 0: without end
  double width = 0;                ///< of the second one, along normal x edge
  Where edge_where;
};

/// A cut whose force is to be written: sets, or a plane.
struct RawCrossSection {
  UserId id = 0;
  std::string title;
  UserId nodes = 0;  ///< sets; 0 is none
  UserId shells = 0;
  UserId solids = 0;
  UserId beams = 0;
  UserId discretes = 0;
  std::optional<RawCutPlane> plane{};
  Where where;
};

/// The id that a keyword would define if it were supported: a missing reference then names the true cause.
struct UnsupportedDefinition {
  UserId id = 0;
  Where where;
};

/// LCTM of *CONTROL_TIMESTEP.
struct RawStepCurve {
  UserId curve = 0;
  Where where;
};

/// NFAIL1 and NFAIL4 of *CONTROL_SHELL: LS-DYNA deletes shells with a negative Jacobian, or stops.
struct RawDistortedShells {
  Where where;
  bool one_point = false;
  bool fully_integrated = false;
};

/// An unsupported value of *CONTROL_SHELL, and the shells that it is about: an error where there are any.
struct RawShellOption {
  enum class About { OffsetShells, HughesLiuShells, LayeredShells, ShellsOfNoFormulation };
  About about;
  Where where;
  std::string_view field;
  std::string read;
  std::string_view expected;
  std::string_view hint;
};

/// *INITIAL_STRESS_SHELL, _SOLID: of one element or of a set.
struct RawInitialStress {
  UserId element = 0;  ///< or the set
  bool is_set = false;
  model::InitialStress stress{};  ///< without its element
  bool has_histories = false;     ///< any history variable is not zero
  bool more_histories = false;    ///< so is one beyond the first five
  Where where;
};

/// *INTERFACE_SPRINGBACK_LSDYNA.
struct RawSpringback {
  struct Hold {
    UserId node = 0;
    int translation = 0;  ///< TC
    int rotation = 0;     ///< RC
    Where where;
  };
  UserId parts = 0;  ///< a set
  std::vector<Hold> holds;
  Where where;
};

struct RawDeck {
  std::size_t section_count() const {
    return sections.size() + solid_sections.size() + beam_sections.size() + discrete_sections.size();
  }

  std::string title;
  std::vector<RawNode> nodes;
  std::vector<RawShell> shells;
  std::vector<std::vector<RawLayer>> element_layers;
  std::vector<RawIntegrationRule> integration_rules;
  std::vector<RawSolid> solids;
  std::vector<RawBeam> beams;
  std::vector<RawDiscrete> discretes;
  std::vector<RawMass> masses;
  std::vector<RawPart> parts;
  std::vector<RawSection> sections;
  std::vector<RawSolidSection> solid_sections;
  std::vector<RawBeamSection> beam_sections;
  std::vector<RawBeamRule> beam_rules;
  std::vector<RawDiscreteSection> discrete_sections;
  std::vector<RawMaterial> materials;
  std::vector<RawSpringMaterial> spring_materials;
  std::vector<RawErosion> erosions;
  std::vector<RawDamage> damages;
  std::vector<RawInitialStress> shell_stresses;
  std::vector<RawInitialStress> solid_stresses;
  std::vector<RawSpringback> springbacks;
  std::vector<RawOrientation> orientations;
  std::vector<RawEquationOfState> equations_of_state;
  std::vector<RawHourglass> hourglasses;
  std::vector<RawCurve> curves;
  std::vector<RawTable> tables;
  std::vector<RawSet> node_sets;
  std::vector<RawSet> part_sets;
  std::vector<RawSet> shell_sets;
  std::vector<RawSet> solid_sets;
  std::vector<RawSet> beam_sets;
  std::vector<RawSet> discrete_sets;
  std::vector<RawSet> segment_sets;
  std::vector<RawBox> boxes;
  std::vector<RawCoordinateSystem> coordinate_systems;
  std::vector<RawTransformation> transformations;
  std::vector<RawNodeTransform> node_transforms;
  std::vector<RawFixed> fixed;
  std::vector<RawVelocity> velocities;
  std::vector<RawNodalLoad> nodal_loads;
  std::vector<RawPressureLoad> pressure_loads;
  std::vector<RawAirBlast> air_blasts;
  std::vector<RawBlastSegment> blast_segments;
  std::vector<RawControlVolume> control_volumes;
  std::vector<RawRigidMerge> rigid_merges;
  std::vector<RawRigidPart> rigid_parts;
  std::vector<RawRigidVelocity> rigid_velocities;
  std::vector<RawExtraNodes> extra_nodes;
  std::vector<RawNodalBody> nodal_bodies;
  std::vector<RawWeld> welds;
  std::vector<RawRivet> rivets;
  std::vector<RawConstrainedSet> constrained_sets;
  std::vector<RawJoint> joints;
  std::vector<RawEquation> equations;
  std::vector<RawInterpolation> interpolations;
  std::vector<RawEmbeddedBeams> embedded_beams;
  std::vector<RawHeldPlane> held_planes;
  std::vector<RawSymmetryPlane> symmetry_planes;
  std::vector<RawStopper> stoppers;
  std::vector<RawMidNode> mid_nodes;
  std::vector<RawJointStiffness> joint_stiffnesses;
  std::vector<RawPrescribedMotion> prescribed_motions;
  std::vector<RawBodyLoad> body_loads;
  std::vector<RawRigidBodyLoad> rigid_body_loads;
  std::vector<RawMassDamping> mass_dampings;
  std::vector<RawMassDamping> part_dampings;
  std::vector<RawStiffnessDamping> stiffness_dampings;
  std::vector<RawRelativeDamping> relative_dampings;
  std::vector<RawViscousBoundary> viscous_boundaries;
  std::vector<RawInertiaField> inertia_fields;
  std::vector<RawBodyLoadParts> body_load_parts;
  std::vector<RawVector> vectors;
  std::vector<RawPartMass> part_masses;
  std::optional<RawStepCurve> step_curve;
  std::vector<RawWall> walls;
  std::vector<RawContact> contacts;
  std::vector<RawInterior> interiors;
  std::vector<RawFrictionTable> friction_tables;
  int contact_thickness_option = 0;  ///< SHLTHK of *CONTROL_CONTACT
  std::vector<RawTiedContact> tied_contacts;
  std::vector<RawHistory> histories;
  std::vector<RawTermination> terminations;
  std::vector<RawCrossSection> cross_sections;
  std::vector<UnsupportedDefinition> unsupported;
  std::vector<std::string_view> faulty;  ///< keywords with asterisk, of blocks that were damaged
  model::Control control;
  model::OutputRequests output;
  model::SearchSettings search;
  model::RunSettings run;
  long state_count = 0;  ///< NPLTC: states over the whole run; 0 is not given
  model::ShellFormulation default_formulation = model::ShellFormulation::BelytschkoTsay;
  bool warping_stiffness = false;  ///< BWC: Belytschko-Tsay shells are Belytschko-Wong-Chiang ones
  bool lobatto_points = false;     ///< CONTROL_SHELL's INTGRD
  std::optional<Where> termination;
  std::string end_time_text;        ///< of ENDTIM, as the deck has it
  bool end_time_is_faulty = false;  ///< and reported
  std::optional<RawRelaxation> relaxation;
  std::optional<Where> control_shell;
  std::optional<Where> control_hourglass;
  RawDistortedShells distorted_shells;
  std::vector<RawShellOption> shell_options;
  std::optional<Where> sorts_solids;    ///< ESORT of *CONTROL_SOLID, where it is not zero
  bool takes_ls_dyna_defaults = false;  ///< `$crumple defaults=ls-dyna`
  std::optional<Where> search_cells;
  std::optional<Where> search_domain;
};

}  // namespace crumple::deck
