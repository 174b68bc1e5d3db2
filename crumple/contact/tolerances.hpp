// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The tolerances and limits of contact, each with its unit in brackets, the reason, and what happens beyond
// it. Ratios have the unit [-] and say what they are over. Most are our own choice; docs/theory/contact.md
// has the methods in which they stand, and the tests that hold them. The golden hashes depend on nearly all
// of them.
//
// Not here: how many items a thread takes or prefetches at once, the number of lanes, and series of
// functions, which change no result and stay where they are used.

#include <cstddef>

namespace crumple::contact::tolerances {

// --- Thickness, stiffness, orientation (surface/) ---

/// Contact thickness of a shell over the shortest edge of its segment, undeformed [-], at most where the
/// shell may touch its own surface: LS-DYNA's rule for single-surface contact. Thicker shells have this
/// thickness and overlap in pictures before they touch; the run names them. Between two surfaces the
/// thickness is whole.
inline constexpr double thickness_over_edge = 0.4;

/// Smallest 1 - 2 nu that enters the bulk modulus [-]. Nearly incompressible laws would ask for any
/// stiffness; below, K is that of this value.
inline constexpr double smallest_compressibility = 0.02;

/// Component of a face's unit normal along an axis, above which the face is perpendicular to it [-]: 2.6
/// degrees. If all its nodes are held along the axis, but not in all directions, it is on a plane of
/// symmetry, and nothing touches it.
inline constexpr double along_axis = 0.999;

/// Distances between segments and nodes that are measured to orient pieces of shells, all pieces together
/// [1]. Beyond, fewer segments of each piece vote, at least one.
inline constexpr std::size_t most_orientation_distances = 100'000'000;
/// Segments of a piece that vote on its outside, about [1]. A piece with more is sampled evenly.
inline constexpr std::size_t largest_orientation_sample = 64;

/// Difference of two squared distances over the squared size of a segment, within which segments are equally
/// near to a node [-]: the round-off of a point on a common edge. The one that faces the node more squarely
/// is chosen; beyond, the nearer.
inline constexpr double equally_near_squared = 1e-12;

// --- Nearest places, sides, passages (surface/, node_segment/, edge_edge/) ---

/// Length of the difference of two unit vectors below which they are parallel [-]. Two segments are then
/// folded onto each other, and no dividing plane tells them apart.
inline constexpr double degenerate_bisector = 1e-6;

/// Cosine of the angle between two directions above which a surface comes nearer to a node along the second
/// [-]. Below, a point above an edge is both neighbours' business; one of the two contacts is dropped
/// afterwards.
inline constexpr double comes_nearer = 1e-9;

/// Halvings of the step in which the moment of a passage is found [1]: to 1e-12 of the step.
inline constexpr int passage_halvings = 40;
/// Distance at the moment of a change of sides over the larger of those at the ends of the step [-]. Below,
/// the node went through the segment, or one edge through the other; above, the node went round a free edge,
/// or the edges became parallel.
inline constexpr double passage_distance = 1e-3;
/// Distance at the start of a step over that at its end, below which the node starts on the mid-surface [-].
/// It then comes from no side, or from outside if the segment is a face.
inline constexpr double starts_on_surface = 1e-9;

/// Distance from a face over the height of its solid (with multipliers: from any segment, over its height or
/// reach) within which a node lies on it [-]: the round-off of coordinates. The node then is pushed along
/// the normal of the face, and is not behind.
inline constexpr double on_surface = 1e-6;

/// Distance from a face over the height of its solid, from which on a node in front of it is remembered
/// before it touches [-]. One that is behind the face in the next step is known to have come through it; one
/// from further away only if its path over the step shows it.
inline constexpr double watch_over_height = 0.1;

// --- Search (search/, and the searches of edge_edge/ and pinball/) ---

/// Margin over the mean edge, if the user gives no expansion [-]. With a thickness below 0.4 of an edge the
/// territory stays below one edge, so that the next ring of nodes of a flat mesh that touches itself are no
/// candidates. Two nodes that have moved further relative to each other make a new search due. It changes no
/// bit of the forces, unless a node is lost deep behind a segment.
inline constexpr double margin_over_edge = 0.4;

/// Stretch of the path bound over the margin, at which its displacements are measured again [-]. Shorter
/// ones are measured more often, longer ones bound less tightly. No result depends on it.
inline constexpr double leg_over_margin = 0.01;
/// Displacement that ends a stretch when it is measured, over the length up to which it grows unmeasured [-].
inline constexpr double ended_leg = 0.5;
/// Steps for which the bound of each step is added up before a stretch is measured again, where measuring
/// gained little [1].
inline constexpr int steps_per_sample = 64;
/// Displacement over the sum of the bounds of its steps, below which measuring is worth its time [-]. Above,
/// it is left for steps_per_sample steps.
inline constexpr double worth_measuring = 0.7;
/// Part of what the motion has left of the margin, up to which the path bound alone tells that no search is
/// due [-]: the rest is for round-off. Beyond, the displacements decide.
inline constexpr double usable_margin = 0.999;

/// Most steps until the next search that eq. (10) may predict [1]. For the report only.
inline constexpr int longest_predicted_interval = 100000;

/// Relative motion of two nodes in a step over the mean edge [-]: half of the default margin, whatever
/// margin the user sets, as that must not change the result. Faster bodies bound the step, so that no node
/// is far behind a shell before it is found.
inline constexpr double motion_over_edge = 0.2;
/// Growth of a step that motion has bounded, from cycle to cycle [-]. Bodies stand still for a moment where
/// they turn round, and a step that changed while they press on each other would make energy.
inline constexpr double bounded_step_growth = 1.01;

/// Penetration that a touch must be heading for to bound the step, over that at the mid-surface of a shell
/// [-], ...
inline constexpr double bounds_step = 0.9;
/// ... and over that at which contact with a face has not held (Touch::most) [-]. Beyond, the stiffness that
/// stability allows is not enough, and a shorter step allows more.
inline constexpr double bounds_step_in_solid = 0.75;
/// The same over the height of a crushable solid as it is now: from there on a touch with it gets stiffer
/// [-], ...
inline constexpr double stiffens_in_crushable = 0.04;
/// ... and from which on it bounds the step [-].
inline constexpr double bounds_step_in_crushable = 0.07;
/// Growth of a stiffness in a step, where a touch is too deep already [-]: its force grows with the root.
inline constexpr double stiffness_growth = 1.2;
/// Penetration over that at which contact has not held, up to which the height of the solid as it is now is
/// not worked out [-]: solids that are not crushed keep a quarter of their height ...
inline constexpr double far_from_room = 0.2;
/// ... and those that are crushed a twentieth [-].
inline constexpr double far_from_room_in_crushable = 0.01;
/// Least step that depth asks for over what elements and motion allow [-]: stiffness grows with the square.
inline constexpr double least_step_for_depth = 1.0 / 3;

// --- Nodes on segments (node_segment/) ---

/// Cosine of the angle between the directions in which two connected segments push a node: 30 degrees [-].
/// Above, they are one surface and only the owner pushes.
inline constexpr double same_surface = 0.8660254037844386;
/// The same: 60 degrees [-]. Below, they are two walls and both push; in between the share of the other
/// grows. A face also hands a node on over its rim where the next one bends by less.
inline constexpr double two_walls = 0.5;

/// Sideways distance beyond the rim of a face, over the root of its area, within which a node goes behind it
/// as if it were inside of the rim [-]: rims of flush blocks swing over each other by less. For one that the
/// contact does not know in front of the face it is over the depth. Further out it does not enter the face.
inline constexpr double beside_rim = 1e-3;
/// The same distance from which on the share of a node behind the face fades [-] ...
inline constexpr double fades_beyond_rim = 0.015;
/// ... and at which the face loses it [-].
inline constexpr double lost_beyond_rim = 0.05;

/// Excess over the distance of the nearest face, within which a face is as near [-]: round-off.
inline constexpr double as_near_as_nearest = 1e-9;

/// Excess over the relative motion in a step, within which a node may have changed sides by it [-]:
/// round-off. Beyond, the segment has inverted below the node, and the side of the pair changes with it.
inline constexpr double motion_round_off = 1e-6;

/// Radius of the zone around an edge in which deep contacts push along the smooth normal, over the
/// penetration [-]. Outside of it the force points along the line from the nearest place, which at a third
/// of the penetration turns slowly enough.
inline constexpr double smooth_in_front = 1.0 / 3;
/// The same behind a segment, over the depth below the mid-surface or face [-].
inline constexpr double smooth_behind = 2;

/// Depth of a node behind a face over the height of its solid, beyond which the contact has not held [-]: it
/// is as near to the far side. A check of the run fails; the forces know nothing of it.
inline constexpr double deepest_in_solid = 0.5;

/// Distance from a side of a solid over the third root of its volume, within which a node lies on the side
/// and is not inside [-].
inline constexpr double on_side_of_solid = 0.01;
/// Volume of a part of a tetrahedron over the whole, by which a point may be outside and count as inside
/// [-].
inline constexpr double outside_tetrahedron = 1e-6;
/// Distance of the face through which a node inside of a solid may have come, over that of the nearest face
/// [-]. Beyond, it is not clear which way it came, and it has no contact: nodes of a side of a block that
/// lies along the side of another.
inline constexpr double ambiguous_face = 2;

/// Sine of the angle, from upright on, by which a face of a node must point against another for the node to
/// enter that [-]: 12 degrees. Without such a face it does not: a node in the middle of a plate never enters
/// the side of a block.
inline constexpr double opposed = 0.2;
/// Length of the mean of the unit normals around a node, below which the node is a tip and enters any face
/// [-].
inline constexpr double pointed = 0.5;

// --- Edges (edge_edge/) ---

/// Squared sine of the angle between two edges below which they are parallel [-]: round-off. Of the nearest
/// pairs of points one is taken.
inline constexpr double parallel_squared = 1e-24;
/// Sine of that angle below which edges have no crossing, and nothing is remembered [-].
inline constexpr double parallel = 0.05;
/// Below, the ends of the edges carry the whole contact; ... [-]
inline constexpr double almost_parallel = 0.1;
/// ... above, their crossing does; in between the share changes linearly [-].
inline constexpr double crossing = 0.3;

/// Sine of the angle by which the surface falls away from an edge inside of it. Of two edges that cross, the
/// sharper one must exceed the first to have any force, and the second to have all; else nodes carry it [-].
inline constexpr double flat = 0.1;
inline constexpr double folded = 0.3;
/// The same of the other one: hollow edges have no force, and all of it from the second on [-].
inline constexpr double hollow = -0.3;
inline constexpr double almost_flat = -0.1;

/// Sine of the angle between an axis and a normal, below which the axis gives no direction across the normal
/// [-]. The next one of a list is taken for the frame of friction.
inline constexpr double no_direction = 0.1;

/// Sine of the angle by which two faces of solids fall away from their common edge, undeformed, for it to
/// take part [-]. Flatter edges are left to the nodes.
inline constexpr double sharp_edge = 0.25;

// --- Pinballs (pinball/) ---

/// Radius of the smallest balls over their spacing [-]. They overlap: half the diagonal of the lattice is
/// 0.71 of the spacing, and nothing passes between them.
inline constexpr double radius_over_spacing = 0.75;
/// Largest spacing of the balls of a shell over half of its thickness [-]: the surface is then even within
/// 0.29 of the radius. Not held by shells that would need more levels; they touch earlier instead.
inline constexpr double spacing_over_half_thickness = 1.0;
/// Times that a shell is split, at most [1]: 32 balls along an edge.
inline constexpr int most_shell_levels = 5;
/// Times that the face of a solid is split [1]: 8 balls along an edge.
inline constexpr int face_levels = 3;

// --- Penalty, stability, friction (enforcement/) ---

/// Slope of the force at the mid-surface of a shell over the penalty stiffness [-]. It grows from half of
/// the reach on, and further behind, so that a strong squeeze does not go through.
inline constexpr double stiffening = 10.0;

/// Penalty stiffness that a node of solids would have by its faces now, over that with which its contact
/// began, from which on it takes it [-]. Turning from face to corner, nodes of cubes gain 1.73 at most.
inline constexpr double regained_stiffness = 2;

/// Part that contact uses of (omega dt)^2 = 4 - 4 TSSFAC^2 that elements leave below the bound 4 of central
/// differences [-].
inline constexpr double budget_safety = 0.9;
/// The most that it uses of (omega dt)^2 [-]: a linear spring below 1 never reaches the limit of passivity.
inline constexpr double largest_budget = 1.0;
/// The least, also where elements leave less [-].
inline constexpr double smallest_budget = 0.1;
/// The most over the scale of the penalty stiffness, SLSFAC SFS [-]. With the usual 0.1 an impact takes five
/// steps or more, and its energy is kept to a per cent. A stiffer pair has its slope limited and counts as
/// limited.
inline constexpr double budget_over_stiffness_scale = 3.5;

/// A node that is new behind two faces came in at their edge if it is at least this much as far behind the
/// one as behind the other [-].
inline constexpr double as_deep_at_edge = 0.5;

/// Share of the deeper face where a node came in at the edge of two, at the least [-]: round-off.
inline constexpr double least_share_at_edge = 1e-9;

/// Part of a node's mass that a touch borrows beside its weight on the node [-]: the couple of friction acts
/// on nodes that have no weight.
inline constexpr double borrowed_mass = 0.05;

/// Energy that a contact spring may return beyond what it holds, over the most that it held [-]: normals
/// rotate within a step. Beyond, the force is reduced, and what is withheld is reported.
inline constexpr double passivity = 5e-4;

/// Budget that normal force and friction use together, over that of a pair that begins [-]: at least so much.
inline constexpr double budget_with_friction = 2.0;
/// Least budget of friction over that of a pair that begins [-], whatever the normal force uses.
inline constexpr double least_friction_budget = 0.1;
/// Moment of a normal force over force and arm, below which it is round-off and no couple takes it up [-].
inline constexpr double no_moment = 1e-9;
/// Weight above which a node belongs to the first point of a touch [-]: round-off. Touches with as many
/// nodes on both sides bear a couple in halves.
inline constexpr double no_weight = 1e-12;
/// Determinant of the inertia of the nodes that bear a couple, over the third power of its trace [-]. Below,
/// they are on a line, which bears no moment about itself: there is no couple.
inline constexpr double collinear = 1e-9;

// --- Multipliers, overlaps at the start (enforcement/multipliers, move_apart) ---

/// Change in a round over the largest penetration or slip before the first, at which the forces are found
/// [-].
inline constexpr double multipliers_converged = 1e-12;
/// Rounds of the solution at most [1]. Beyond, it ends with what it has, silently.
inline constexpr int most_multiplier_rounds = 1000;
/// Weighted compliance of a node over that of the whole touch, beyond which the touch has no force [-]: its
/// contact point is at a node that cannot move, and the others would have to go any distance for it.
inline constexpr double most_leverage = 10;
/// Compliance along the normal over the largest, below which supports hold all nodes of a touch along the
/// normal but for rounding [-].
inline constexpr double least_compliance = 1e-9;

/// Overlap over the mean edge, below which meshes that are moved apart do not overlap [-].
inline constexpr double negligible_overlap = 1e-9;
/// Rounds of finding and moving at most [1]: nodes that move change the normals of others. What is left
/// after them is reported.
inline constexpr int most_moving_rounds = 20;

// --- Tied contact (tied/) ---

/// Distance at which a node is tied over the sum of both thicknesses [-], ...
inline constexpr double tied_over_thickness = 0.60;
/// ... and over the smaller diagonal of the segment [-]; the larger counts. LS-DYNA's tolerances. Nodes
/// further away are not tied, and are reported.
inline constexpr double tied_over_diagonal = 0.05;
/// Rounds in which nodes are put onto segments that other ties move [1]: longer chains stay as they are by
/// then.
inline constexpr int longest_chain_of_ties = 100;

/// Stretch of a spring over the largest coordinate, below which it is round-off and makes no force [-]: a
/// model at rest has no energy that could tell such noise from motion.
inline constexpr double no_stretch = 1e-14;
/// Stiffness of a tie over that of a contact [-]: a joint must be stiffer than the elements beside it, not
/// softer.
inline constexpr double tie_over_contact_stiffness = 10;
/// Part of the stability budget of contact that ties use [-]: the rest is for contact at the same nodes.
inline constexpr double tie_budget = 0.5;

// --- Checks of the result (intersections) ---

/// Distance of an end of a line from the plane of a triangle over the length of the line, within which it
/// lies in the plane and the line does not go through [-].
inline constexpr double in_plane = 1e-9;
/// Depth over the height of the lower of two solids, from which on their faces cut each other [-]. Less is
/// what the penalty needs, as faces have no thickness.
inline constexpr double pressed_faces = 0.1;

}  // namespace crumple::contact::tolerances
