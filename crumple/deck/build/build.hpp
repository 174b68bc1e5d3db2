// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// From the raw deck to the model: ids become indices, defaults are filled in, what does not fit together is
// refused. Readers have judged each card by itself; here the whole deck is known.
//
//     RawDeck                          Build                                   model::Model
//     ids of the deck, each with  -->  enter(): an id gets its index;     -->  indices, sets of nodes and
//     its field and place              an id defined twice is reported         elements
//                                      find(): the index of an id; if there
//                                      is none, says which keyword would
//                                      define it
//
// No fault ends the building: it is reported where the deck has it, the item is left out, and the rest is
// checked as well, so that one reading shows all faults. What refers to a definition that is not supported
// is refused for that reason, or dropped with --allow-unsupported.
//
// Order of calls: build_model() in build.cpp is the list. Definitions come before what refers to them:
// properties (curves, materials, sections), nodes, coordinate systems, parts, elements, sets, then what acts
// on them: masses, rigid bodies, connections, conditions, loads, motions, walls, contacts, ties, output. One
// file for each, as named below. units.hpp guesses the units from densities and moduli.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deck/format/id_table.hpp"
#include "deck/format/raw_deck.hpp"
#include "deck/format/read_options.hpp"
#include "deck/format/report.hpp"
#include "deck/format/vector.hpp"
#include "model/model.hpp"

namespace crumple::deck {

/// What a user id can be the id of.
enum class Item {
  Node,
  Shell,
  Mass,
  Part,
  Section,
  Material,
  Hourglass,
  Curve,
  NodeSet,
  PartSet,
  Wall,
  Contact,
  Table,
  Solid,
  ShellSet,
  SolidSet,
  SegmentSet,
  Box,
  RigidBody,
  Beam,
  Discrete,
  Orientation,
  EquationOfState,
  CoordinateSystem,
  BeamSet,
  DiscreteSet,
  CrossSection,
  Transformation,
  Joint,
  ControlVolume,
  DefinedVector,
  IntegrationRule,
  AirBlast,
  FrictionTable,
  Count,  ///< how many there are
};

/// A user id with the field in which it stands.
struct Reference {
  UserId id = 0;
  std::string_view field;
  Where where;
};

/// The model under construction, with the ids of what it already has. The deck and the report outlive it.
class Build {
 public:
  Build(const RawDeck& raw, Report& to);

  const RawDeck& deck;
  Report& report;
  model::Model model;
  std::vector<std::vector<Index>> solid_sets;     ///< members by set, as in RawDeck::solid_sets
  std::vector<std::vector<Index>> beam_sets;      ///< likewise
  std::vector<std::vector<Index>> discrete_sets;  ///< likewise
  std::vector<std::int32_t> shells_of_part;       ///< number of shells, by index of the part
  std::vector<std::int32_t> solids_of_part;       ///< number of solids, by index of the part
  model::DynamicRelaxation relaxation;            ///< what acts in a dynamic relaxation, if there is one
  std::map<std::vector<double>, Index> layups;    ///< of elements, by materials and shares of their layers
  std::vector<std::int32_t> lines_of_part;  ///< number of beams or discrete elements, by index of the part

  /// Enters the id of an item that gets this index. An id that is there already is reported.
  void enter(Item item, const Reference& reference, std::size_t index);

  /// Index of the item that a field refers to. Where there is none, says so and returns no_index: an error,
  /// or what --allow-unsupported makes of it if an unsupported keyword would define the item.
  Index find(Item item, const Reference& reference);

  /// The same without a message.
  Index find_quietly(Item item, UserId id) const;

  /// Parts that are left out because something they need is not supported.
  void drop_part(UserId id) { dropped_parts_.insert(id, 0); }
  bool is_dropped(UserId part) const { return dropped_parts_.find(part) != no_index; }

  /// The unsupported keyword that would define an item; null if there is none.
  const UnsupportedDefinition* unsupported_definition(Item item, UserId id) const;

  /// A keyword that defines such items could not be read, so that one may be missing for that reason.
  bool is_definition_faulty(Item item) const;

 private:
  struct Entries {
    IdTable table;
    std::vector<Where> first;  ///< where each id was entered, in the order of entering
  };

  bool is_left_out(Item item, UserId id);
  void report_twice(Item item, const Reference& reference, const Where& other);

  Entries entries_[static_cast<std::size_t>(Item::Count)];
  IdTable dropped_parts_;
  std::map<Item, std::vector<UserId>> element_ids_;  ///< of the deck, ascending; made where one is missing
  std::multimap<UserId, const UnsupportedDefinition*> unsupported_;  ///< of each id in the deck's order
};

// build_properties.cpp
void build_properties(Build& build, const ReadOptions& options);
/// The curve that a field refers to; no_index, with a message, if there is none, if it is a function of
/// time, or if it has less than two points, which the reader has reported. Only such a curve may be asked for
/// its first and last point.
Index find_points(Build& build, const Reference& reference);
/// The model's curve of every value of a table; no_index where find_points() has none.
std::vector<Index> curves_of(const RawTable& raw, Build& build);
// build_hardening.cpp
/// What the curves of hardening make of a law.
void take_hardening(const RawMaterial& raw, model::PiecewiseLinearPlasticity& law, Build& build);
void take_hardening(const RawMaterial& raw, model::SheetPlasticity& law, Build& build);
void take_hardening(const RawMaterial& raw, model::CompressionTension& law, Build& build);
// build_failure.cpp
/// Gives criteria of erosion and damage to materials that are there already.
void take_erosions(Build& build);
void take_damages(Build& build);
// build_foams.cpp
/// What the curves of a honeycomb, a soil or a foam make of its law.
void take_foam_curves(const RawMaterial& raw, model::ConstitutiveLaw& law, Build& build);
/// Honeycomb with ELFORM 0 and 9 has its curves over the nominal strain.
void build_nominal_honeycombs(Build& build);
// build_rate_factors.cpp
/// What the curve of rates of a concrete makes of its law.
void take_rate_factors(const RawMaterial& raw, model::ConstitutiveLaw& law, Build& build);
// check_materials.cpp
void check_materials(Build& build);
// check_parts.cpp
/// Whether the elements, the material and the equation of state of a part go together.
void check_part(const RawPart& raw, const model::Part& part, Build& build);
/// Warns of shells of *MAT_NULL with YM = 0 in a model with contacts, which must be there.
void check_contact_of_null_shells(Build& build);
// build_mesh.cpp
void build_nodes(Build& build);
void build_parts(Build& build);
void build_shells(Build& build);
void check_empty_parts(Build& build);

// coincident_elements.cpp
/// Warns of two shells, solids or beams that have the same nodes. Layers of two parts may be meant.
void check_coincident_elements(Build& build);

using model::ElementKind;

/// Index of the part that an element names. Where there is none, or its section is for another kind of
/// elements, says so and returns no_index.
Index find_part_of(Build& build, ElementKind kind, const Reference& reference);
// build_layups.cpp
/// Gives a part of shells the layers that its keyword or its section asks for. False, with a message, if they
/// cannot be made.
bool build_part_layup(Build& build, const RawPart& raw, model::Part& part);
/// The layers of *ELEMENT_SHELL_COMPOSITE; shells with the same ones share a layup. False as above.
bool build_element_layup(Build& build, const RawShell& raw, model::ShellElement& shell);
// build_shell_axes.cpp
/// Turns the material's axes of a shell to the x axis of the system that MCID names. False, with a message,
/// if there is none, or if the material has axes of another kind.
bool turn_to_system(Build& build, const RawShell& raw, model::ShellElement& shell);
// build_transformations.cpp
/// Moves the nodes of *NODE_TRANSFORM. Before all else that uses their positions.
void move_nodes(Build& build);
// build_functions.cpp
/// The points of a function of time, from zero to the end of the run. Reports what it cannot evaluate.
model::Curve sample_function(const RawCurve& raw, double end_time, Report& report);
// build_coordinates.cpp
/// Enters the ids of the coordinate systems and of the vectors. The nodes of the model must be there.
void enter_coordinate_systems(Build& build);
/// The axes of the coordinate system that a field refers to. Absent, with a message, where there is none or
/// where it has no axes.
std::optional<std::array<Vector, 3>> find_axes(Build& build, UserId id, std::string_view field,
                                               const Where& where);
/// A direction whose components are along the axes of a coordinate system, or global if that is 0. Absent as
/// above.
std::optional<Vector> turned(Build& build, const Vector& components, UserId system, std::string_view field,
                             const Where& where);
/// The direction, of unit length, of the vector that a field refers to. Absent, with a message, if there is
/// none.
std::optional<Vector> find_vector(Build& build, UserId id, std::string_view field, const Where& where);
/// Right-handed axes of unit length, the first along a vector of unit length, the others any.
std::array<Vector, 3> axes_along(const Vector& first);
/// Where a coordinate system has its origin. Its axes must have been found.
Vector origin_of(const Build& build, UserId id);
// build_defaults.cpp
/// Settles what the deck leaves open about shells and one-point hexahedra: with thickness change and the
/// hourglass stiffness of their material, or as LS-DYNA does. Adds a note of what it took.
void settle_defaults(Build& build, bool as_ls_dyna);
/// NFAIL1 and NFAIL4 where the model has shells that they are about.
void settle_distorted_shells(Build& build);
/// Values of *CONTROL_SHELL that are not supported, where the model has shells that they are about.
void check_shell_options(Build& build);
// build_solids.cpp
void build_solids(Build& build);
/// *CONTACT_INTERIOR. The part sets must be there, at the places that they have in the deck.
void build_interiors(Build& build);
// build_lines.cpp
void build_beam_sections(Build& build);
/// Axes of discrete beams, once there are coordinate systems.
void settle_discrete_beams(Build& build);
void build_beams(Build& build);
void build_discretes(Build& build);
// build_sets.cpp
void build_sets(Build& build);
/// Whether a point is in a box; its sides belong to it.
bool is_inside(const RawBox& box, const std::array<double, 3>& point);
// build_conditions.cpp
/// Nodes of the elements of some parts, ascending.
std::vector<Index> nodes_of_parts(const Build& build, const std::vector<Index>& parts);
/// Nodes of the set that a field refers to; null, with a message, if there is none.
const std::vector<Index>* set_nodes(Build& build, const Reference& set);
std::vector<Index> all_nodes(const Build& build);
void build_masses(Build& build);
void build_part_masses(Build& build);
// build_supports.cpp
void build_fixed_nodes(Build& build);
// build_conditions.cpp
void build_velocities(Build& build);
// build_initial_stress.cpp
void build_initial_stresses(Build& build);
// build_connections.cpp
void build_connections(Build& build);
/// A spot weld, rivet or constrained set, to a node that it moves.
struct Connection {
  std::string name;                   ///< "spot weld 7"
  std::array<bool, 3> translation{};  ///< global axes along which it changes the node's velocity
  bool is_body = false;               ///< it sets all of the node's motion, whatever is held
};
/// The connections of the model by node.
std::map<Index, Connection> connections_of_nodes(const Build& build);
// build_embedded_beams.cpp
/// Beams inside solids.
void build_embedded_beams(Build& build);
// build_joints.cpp
/// Joints between rigid bodies.
void build_joints(Build& build);
// build_joint_stiffness.cpp
void build_joint_stiffnesses(Build& build);
// build_walls.cpp
void build_walls(Build& build);
// build_rigid_bodies.cpp
void build_rigid_bodies(Build& build);
// build_stoppers.cpp
/// Bounds of the motion of rigid bodies. What holds these must be known.
void build_stoppers(Build& build);
// build_solid_welds.cpp
/// What solids of *MAT_SPOTWELD do not do as beams of it do.
void check_solid_weld(const RawPart& raw, const model::SpotWeldLaw& law, Report& report);
/// Gives solid welds the law of their metal.
void build_solid_welds(Build& build);
// build_rigid_bodies.cpp
/// Before anything asks which parts are rigid: those of *DEFORMABLE_TO_RIGID are.
void make_parts_rigid(Build& build);
/// The rigid body of every node, or no_index.
std::vector<Index> bodies_of_nodes(const Build& build);
// build_motions.cpp
/// Prescribed motions and loads on rigid bodies.
void build_motions(Build& build);
// build_relaxation.cpp
/// The phases that loads and motions by a curve act in (SIDR).
RawCurve::Phase phase_of_load(const Build& build, Index curve);
/// Deals the loads and motions out to a dynamic relaxation and the run, by SIDR of their curves, and refuses
/// what the relaxation cannot have. `end_time`: of the run [time]. When all loads and motions are there.
void build_relaxation(Build& build, double end_time);
// short_curves.cpp
/// Warns once of each curve of a load, velocity or acceleration that ends before the run and goes on with
/// another value than zero. `end_time`: of the run [time].
void check_short_curves(Build& build, double end_time);
// time_curves.cpp
/// Delays what goes over time by curves with OFFA above zero, and warns of curves that begin late or
/// displacements that begin elsewhere than at zero. When all loads and motions are there.
void finish_time_curves(Build& build);
// idle_loads.cpp
/// Warns of moments on nodes without rotations and of forces on nodes without mass.
void check_idle_loads(Build& build);
// build_inertia_fields.cpp
/// Body loads, and damping.
void build_inertia_fields(Build& build);
/// The parts of a set, or one part; empty, with a message, if there is no such item.
std::vector<Index> find_parts(Build& build, bool is_set, const Reference& reference);
// build_loads.cpp
void build_loads(Build& build);
// build_blasts.cpp
/// Charges and the segments that they load, but for the shells which these are.
void build_blasts(Build& build);
// build_viscous_boundaries.cpp
/// Segments of solids that do not reflect waves.
void build_viscous_boundaries(Build& build);
// build_airbags.cpp
void build_airbags(Build& build);
/// Force and moment on a node or a body at a factor of one.
struct ForceAndMoment {
  Vector force{};
  Vector moment{};
  model::FollowedPlane plane{};
};
/// What DOF, SF, CID and M1 to M3 say; absent, with a message, if an item is missing.
std::optional<ForceAndMoment> find_force(Build& build, int direction, double scale, UserId system,
                                         const std::array<UserId, 3>& plane, const Where& where);
// build_friction.cpp
/// Enters the ids of *DEFINE_FRICTION.
void enter_friction_tables(Build& build);
/// Gives a contact the friction of its parts or of a table, where FS is -1 or -2.
void take_part_friction(Build& build, const RawContact& raw, model::Contact& contact);
// build_contacts.cpp
void build_contacts(Build& build, bool automatic_contact);
/// Enters a contact by its place among all contacts, and returns its id: the one that the deck gives, or a
/// free one if that is 0 or, with a warning, taken by an earlier contact.
UserId enter_contact(Build& build, UserId given, const Where& where, std::size_t place);
/// Adds what a field names to the side of a contact. False, with a message, if there is a fault.
bool add_contact_side(Build& build, const RawContactSide& raw, const Where& where, model::ContactSide& side);
// build_tied_contact.cpp
void build_tied_contacts(Build& build);
// build_terminations.cpp
void build_terminations(Build& build);
// build_cross_sections.cpp
void build_cross_sections(Build& build);
// build_output.cpp
void build_output(Build& build);

/// Follows all references, checks that the items fit together and makes the model. Faults go to the report.
model::Model build_model(const RawDeck& deck, const ReadOptions& options, Report& report);

}  // namespace crumple::deck
