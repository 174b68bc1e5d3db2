// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "math/vec3.hpp"

namespace crumple::domain {

/// Wall time of each stage of the cycle, summed over the run [s]. The names are those of run.json.
struct StageTimes {
  double elements = 0;
  double contact_search = 0;
  double contact_local = 0;
  double contact_forces = 0;
  double constraints = 0;
  double integrate = 0;
  double output = 0;
};

/// The shares that one contact has in StageTimes [s].
struct ContactTimes {
  double search = 0;
  double local = 0;
  double forces = 0;
};

/// What the global search of a contact cost so far, that of nodes and segments alone.
struct SearchReport {
  double expansion = 0;     ///< c: largest expansion of a territory [length]
  long node_visits = 0;     ///< nodes looked at in all searches, candidates or not
  long cell_visits = 0;     ///< cells looked into in all searches; 0 for methods without cells
  long participants = 0;    ///< N: nodes that took part in the last search
  long cells = 0;           ///< Ncell of the last search; 0 for methods without cells
  long bytes = 0;           ///< working memory of the method at the last search
  double find_seconds = 0;  ///< the share of building and asking in ContactTimes::search [s]
};

/// A look at the surfaces of a contact at one time. Made on request: it costs as much as a search.
struct ContactInspection {
  bool made = false;
  Index intersections = 0;          ///< pairs of segments whose mid-surfaces cut through each other
  Index initial_intersections = 0;  ///< of these: where the undeformed mid-surfaces cut already
  UserId first_segment = 0;         ///< the first pair of the others, or of all if there are no others
  UserId second_segment = 0;
  Index nodes_in_solids = 0;  ///< nodes deep inside of solids that have no contact there
  UserId node_in_solid = 0;   ///< the first such node
  Index nodes_beyond = 0;     ///< pairs in contact whose node is on or beyond the mid-surface
  double largest_depth = 0;   ///< penetration over the depth at which the mid-surface is reached [-]
  double percentile_99 = 0;   ///< the same; 99 % of the pairs are at most this deep [-]
};

/// The largest number of segments that cut through each other at once: in the inspections during a run those
/// deeper than half their thickness, at its end all. Bodies that pass through each other and come apart again
/// leave no other trace.
struct WorstIntersections {
  Index count = 0;           ///< most pairs of segments at one of them, without those of the start
  UserId first_segment = 0;  ///< the first of these pairs
  UserId second_segment = 0;
  long cycle = 0;   ///< of the first inspection with so many
  double time = 0;  ///< likewise [time]
};

/// A node that was nearer to a segment than the contact distance when the contact began.
struct InitialOverlap {
  UserId node = 0;
  UserId element = 0;  ///< shell or solid of the segment
  double depth = 0;    ///< [length]
};

/// Contact forces that were limited because they would have created energy: penetrations that grew without an
/// approach against a force.
struct WithheldForces {
  long count = 0;      ///< touches, summed over the cycles
  double largest = 0;  ///< largest part of a force that was withheld [force]
  long cycle = 0;      ///< when that was
  UserId node = 0;     ///< where
  UserId segment = 0;  ///< shell, solid or edge
};

/// Nodes that were beyond a mid-surface or behind the face of a solid when their contact ended, or edges that
/// had gone through each other, though nothing released them: they are where they should not be, and nothing
/// pushes them back.
struct LostContacts {
  long count = 0;
  long cycle = 0;  ///< of the first
  UserId node = 0;
  UserId segment = 0;  ///< shell, solid or beam
};

/// What pairs push whose contact distance is reduced, beside all pairs of the contact: overlaps of the start
/// must not push.
struct OverlapForces {
  double impulse = 0;          ///< of all normal forces, their sizes summed [force * time]
  double overlap_impulse = 0;  ///< of pairs with a reduced contact distance [force * time]
  double largest = 0;          ///< the largest single force of these [force]
  UserId node = 0;             ///< where

  double share() const { return impulse > 0 ? overlap_impulse / impulse : 0; }
};

/// The deepest place of all pairs so far, over the depth at which a node has gone through the whole thickness
/// of a shell, or through half of a solid.
struct DeepestPenetration {
  double share = 0;  ///< penetration over that depth [-]
  long cycle = 0;
  UserId node = 0;
  UserId segment = 0;  ///< shell, solid or edge
};

/// Shells that touch with less than their thickness, as they are thick beside their edges.
struct ThicknessCut {
  Index shells = 0;
  double from = 0;  ///< thickness of the one that is cut most [length]
  double to = 0;    ///< contact thickness of it [length]
  UserId shell = 0;
  UserId part = 0;
};

/// What a contact interface did so far.
struct ContactReport {
  UserId id = 0;
  std::string method{};  ///< of the global search
  Index segments = 0;    ///< shells and faces of solids that take part
  ThicknessCut thickness_cut{};
  long searches = 0;             ///< global searches
  long candidates = 0;           ///< candidate pairs of all searches together
  Index active_pairs = 0;        ///< node-segment pairs with a force, now
  double penetration = 0;        ///< largest now [length]
  double worst_penetration = 0;  ///< largest of the run [length]
  UserId worst_node = 0;         ///< where that was
  double energy = 0;             ///< normal: stored and dissipated [energy]
  double damping_energy = 0;     ///< of that, dissipated by damping [energy]
  double stored_energy = 0;    ///< of that, held by the penalties now, as springs of mean stiffness [energy]
  double friction_energy = 0;  ///< dissipated [energy]
  double eroded_energy =
      0;  ///< held by pairs when their segment or node eroded, taken from `energy` [energy]
  std::vector<InitialOverlap> initial_overlaps{};  ///< the deepest first; their contact distance is reduced
  bool two_sided = false;
  math::Vec3 force{};            ///< on the first of two sides now, from the second [force]
  std::array<double, 2> mass{};  ///< of the nodes of its sides [mass]
  WithheldForces withheld{};
  DeepestPenetration deepest{};
  LostContacts lost_nodes{};
  LostContacts lost_edges{};
  OverlapForces overlap_forces{};
  ContactInspection inspection{};
  WorstIntersections worst_intersections{};
  SearchReport search{};
  ContactTimes times{};
};

/// What a force transducer measures.
struct TransducerReport {
  UserId id = 0;
  math::Vec3 force{};  ///< on its first side now [force]
  double mass = 0;     ///< of the nodes of its first side [mass]
};

/// What a rigid wall did so far.
struct WallReport {
  UserId id = 0;
  math::Vec3 force{};         ///< on the wall, in the last step [force]
  double normal_force = 0;    ///< sum over the nodes of its parts along the normals where they touch [force]
  math::Vec3 impulse{};       ///< on the wall, of the whole run [force * time]
  double normal_impulse = 0;  ///< likewise along the normals [force * time]
  double energy = 0;          ///< taken from the model until time n [energy]
  double deferred = 0;        ///< the half of the last impulses' work that the kinetic energy of n+1 shows
  double deferred_work = 0;   ///< the half of the last impulses' work done by the wall's motion, likewise
  math::Vec3 displacement{};  ///< of a moving wall; once its nodes are stopped that of n+1 [length]
  math::Vec3 displacement_now{};  ///< the same at time n [length]
  math::Vec3 velocity{};          ///< of a moving wall between the two [length/time]
  double mass = 0;                ///< 0: nothing changes the wall's motion [mass]
  double kinetic_energy = 0;      ///< of a wall with mass at time n, in product form [energy]
};

/// What is in a control volume, at time n.
struct ControlVolumeReport {
  UserId id = 0;
  double volume = 0;       ///< [volume]
  double pressure = 0;     ///< on the surface [stress]
  double energy = 0;       ///< internal energy of the filling [energy]
  double inflow = 0;       ///< [mass/time]
  double outflow = 0;      ///< [mass/time]
  double mass = 0;         ///< [mass]
  double temperature = 0;  ///< 0 where the law knows none
  double area = 0;         ///< of the surface [length^2]
};

/// The force in a spot weld between two nodes.
struct WeldReport {
  UserId id = 0;
  double axial = 0;  ///< tension at time n [force]
  double shear = 0;  ///< at time n [force]
  bool broken = false;
  double failure_time = 0;  ///< if broken [time]
};

/// A joint between two rigid bodies at time n.
struct JointReport {
  UserId id = 0;
  math::Vec3 force{};         ///< on the body of its first node, from the other one [force]
  math::Vec3 moment{};        ///< the same, about the first node [force * length]
  double energy = 0;          ///< stored in the penalty [energy]
  double damping_energy = 0;  ///< dissipated so far [energy]
  double opening = 0;         ///< largest distance of what the joint holds together [length]
};

/// The resistance of a joint at time n, by angle or displacement.
struct JointStiffnessReport {
  UserId id = 0;
  std::array<double, 3> position{};  ///< of the second body against the first [rad, length]
  std::array<double, 3> rate{};      ///< [rad/time, length/time]
  std::array<double, 3> elastic{};   ///< of curves, stops and friction, as it resists [moment, force]
  std::array<double, 3> damping{};   ///< of curves over rates [moment, force]
  double energy = 0;                 ///< stored in curves and stops [energy]
  double friction_energy = 0;        ///< dissipated [energy]
  double damping_energy = 0;         ///< dissipated [energy]
};

/// The force of what holds a node in place (*BOUNDARY_SPC).
struct SupportReport {
  Index node = no_index;  ///< domain node
  math::Vec3 force{};     ///< on the model at time n [force]
  math::Vec3 moment{};    ///< the same [force * length]
};

/// The element that governs the step.
struct ControllingElement {
  const char* kind = "shell";  ///< what the element is called
  UserId element = 0;
  UserId part = 0;
};

}  // namespace crumple::domain
