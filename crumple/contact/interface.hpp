// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Contact of shells, solids and beams with themselves or with each other. One Interface is one *CONTACT of
// the deck and remembers what it needs from step to step. The words (candidate, pair, touch, gap, reach) are
// drawn in docs/glossary.md, the methods with their sources are in docs/theory/contact.md.
//
//     surface/       segments, nodes, sides, thickness, stiffness      at the start, and when elements erode
//       |
//     search/        which nodes may touch which segments              when nodes have moved far enough
//       |
//     node_segment/  where, how deep, on which side: nodes             every step
//     edge_edge/     the same of edges and beams, beside the nodes
//     pinball/       segments by balls inside of them, instead of both
//       |
//       |            Each is a Detector (search/detector.hpp); a Touch, two points that repel each other, is
//       |            the same whatever detector found it
//     enforcement/   forces, friction, energy: by penalty, or by Lagrange multipliers
//       |
//     nodal forces   pair by pair in a fixed order: bitwise the same for any number of threads
//
// Sources: F. Wang, J. Cheng & Z. Yao, Acta Mechanica Sinica 16(4) (2000), for search and local search; S.P.
// Wang & E. Nakamachi, IJNME 40 (1997) 3665-3685, for the inside-outside idea, which is reconstructed here
// and extended to shells; D.J. Benson & J.O. Hallquist, CMAME 78 (1990) 141-163, and LS-DYNA's Theory Manual
// (2006) for single-surface contact and the penalty; J.C. Carpenter, R.L. Taylor & M.G. Katona, IJNME 32
// (1991) 103-128, for multipliers.
//
// Order of calls in a step, each stage for all contacts before the next, as the stiffness that one may have
// depends on what all others do to its nodes: clear_forces(), find_touches(), evaluate_forces(),
// add_forces(); for contacts by multipliers add_multipliers() instead, once all other forces are known.
// longest_step() bounds the step between them.
//
// Beside this: tied/ finds nodes that are tied to segments and has their springs; force_transducer.hpp sums
// forces on a surface, intersections.hpp checks the result, move_apart.hpp removes overlaps before the run.
// All tolerances are in tolerances.hpp.

#include <memory>
#include <span>
#include <vector>

#include "contact/enforcement/touch.hpp"
#include "contact/surface/statistics.hpp"
#include "contact/surface/surface.hpp"
#include "domain/contact_node_force.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// Contact of shells and solids with themselves or with each other.
class Interface {
 public:
  /// Collects segments and nodes of the parts that take part. `report` is the place of this interface in
  /// domain.contacts, whose entry it keeps up to date. Throws Error for settings that cannot be followed.
  Interface(const model::Model& model, const domain::Domain& domain, const model::Contact& contact,
            Index report);
  ~Interface();
  Interface(Interface&&) noexcept;
  Interface& operator=(Interface&&) noexcept;

  /// Takes the contact forces of the last step out of domain.contact_force: for all contacts before the
  /// stages of a step.
  void clear_forces(domain::Domain& domain) const;

  /// First of three stages at time n, each to be called for all contacts before the next: what several do to
  /// one node counts together. Finds what touches, and counts it at the nodes. On entry nodes.position is
  /// x(n), nodes.velocity is v(n-1/2) and clock.step the step between them (zero before the first). Searches
  /// again when a node may have moved further than the candidate list allows.
  void find_touches(domain::Domain& domain);

  /// Second stage: computes the forces of the touches.
  void evaluate_forces(domain::Domain& domain);

  /// The same again where touches have asked for a next step that is much shorter than the last one, by which
  /// their forces were computed: else a touch that begins loses or wins energy.
  void evaluate_forces_again(domain::Domain& domain, double next_step);

  /// Third stage: adds the contact forces to nodes.force and domain.contact_force, each node's in the
  /// order of pairs (node, segment), so that the sums are bitwise the same for any number of threads. Updates
  /// the report's energies by the trapezoidal rule, and the stage times.
  void add_forces(domain::Domain& domain);

  /// The same for contact that is enforced by multipliers, where the stages do nothing (and this one does
  /// nothing where they do): to be called when all other forces at time n are in nodes.force.
  /// `next_step` leads to n+1, `interval` is what velocities will be advanced by.
  void add_multipliers(domain::Domain& domain, double interval, double next_step);

  /// The longest next step that leaves the surfaces time to meet (motion_limit.hpp), after find_touches(),
  /// and that allows the stiffness with which none gets too deep, after evaluate_forces(); infinite where
  /// nothing is fast or deep [time].
  double longest_step() const;

  /// Fills what never changes: id, method, number of segments, whether there are two sides.
  void describe(domain::ContactReport& report) const;

  /// Declares what the contact remembers from step to step.
  void declare(domain::StateList& list);

  /// To be called once after a restart has filled what was declared, and the domain: makes what follows from
  /// it.
  void resume(const domain::Domain& domain);

  /// Compares every `cycles` cycles the candidates in use with a brute-force search; throws Error naming the
  /// first pair that was missed. 0 switches it off.
  void verify_search_every(long cycles);

  /// Finds segments that cut through each other deeper than half their thickness, if the contact acts, and
  /// keeps the largest number of the run in the report. It costs as much as 4 to 8 steps.
  void note_intersections(domain::Domain& domain) const;

  /// Finds all mid-surfaces that cut through each other, for the state at the end of a run, and sums up
  /// the penetrations; fills the report's inspection as well.
  void inspect(domain::Domain& domain) const;

  /// What happened so far, for warnings and summaries.
  const ContactStatistics& statistics() const;
  /// The pairs with a force at time n; holds until the next step.
  std::span<const Penetration> penetrations() const;
  /// All places that touch at time n, with their forces; holds until the next step.
  std::span<const Touch> touches() const;
  /// What the penalties hold now, as springs of their mean stiffness [energy].
  double stored_energy() const;
  /// Appends the forces on the nodes at time n, in the order of the domain.
  void append_node_forces(std::vector<domain::ContactNodeForce>& forces) const;
  /// The segments and nodes of this contact.
  const Surface& surface() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace crumple::contact
