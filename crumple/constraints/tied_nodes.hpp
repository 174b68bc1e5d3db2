// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/aligned_array.hpp"
#include "constraints/kinetic_change.hpp"
#include "constraints/tie_links.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// Nodes that follow the segments that they are tied to, or the solids that they lie in (J.O. Hallquist,
/// LS-DYNA Theory Manual, chapter on tied contact): the force and the mass of a tied node are shared out
/// among the nodes of its segment by its weights there, and its motion is the weighted mean of theirs
/// (docs/theory/tied.md). A node that is tied at a height over its segment stands on a lever (tie_lever.hpp).
/// A node of a segment may itself be tied to another one. Nodes of beams in solids follow the corners of
/// these in the same way, by the shape functions (docs/theory/connections.md).
///
/// A step calls, in this order: release(), remember(), the kick of all nodes by their own masses, share(),
/// whatever else changes velocities, follow(), and place_nodes() when the nodes have drifted.
class TiedNodes {
 public:
  /// Takes over those of domain.ties that can follow (find_tie_links()), and domain.embeddings, and makes
  /// velocities at time zero fit: momentum is kept. Throws Error for a node of a tie by constraint that
  /// something else holds or moves.
  TiedNodes(const model::Model& model, domain::Domain& domain);

  bool empty() const { return links_.empty(); }

  /// Has NodeFields::acceleration of tied nodes written.
  void keep_accelerations() { keep_acceleration_ = true; }

  /// Ends the ties whose segment has eroded, or all solids that hold the node, or whose time is over. Books
  /// the energy of the relative motion that this frees.
  void release(domain::Domain& domain);

  /// Keeps the velocities of n-1/2.
  void remember(const domain::Domain& domain);

  /// After the kick of the nodes: gives what the tied ones received to the nodes of their segments, whose
  /// velocities of n+1/2 then are right. Returns what the rotational energy at time n changes by; for the
  /// translational one see carried_energy().
  KineticChange share(domain::Domain& domain);

  /// Makes the tied nodes follow, so that after the next step they are at their places; forces are added to
  /// those of domain.ties. `interval` is that of the kick.
  void follow(domain::Domain& domain, double interval, double next_step);

  /// Puts the tied nodes, which are there to round-off, where they belong. Returns how far it moved any of
  /// them at most [length].
  double place_nodes(domain::Domain& domain) const;

  /// What the nodes of the segments have more than sum of 1/2 m v.v of all nodes, because they carry the
  /// masses of the tied ones; of the remembered velocities times the present ones [energy].
  KineticChange carried_energy(const domain::Domain& domain) const;

  /// What tied nodes and the node itself received in this step, where the node follows none; else zero.
  struct Share {
    math::Vec3 momentum;  ///< [mass * length/time]
    math::Vec3 moment;    ///< [mass * length^2/time]
  };
  Share share_of(Index node) const;

  void declare(domain::StateList& list);

  /// Brings what nodes carry up to date, once masses or what is tied have changed.
  void share_masses(domain::Domain& domain);

 private:
  /// Of a place on a segment.
  struct Motion {
    math::Vec3 velocity;  ///< [length/time]
    math::Vec3 spin;      ///< [rad/time]
  };

  std::array<math::Vec3, 4> corners(const domain::NodeFields& nodes, const TieLink& link) const;
  Motion motion_of_segment(const domain::NodeFields& nodes, const TieLink& link, double step) const;
  void pass_on(const domain::NodeFields& nodes, const TieLink& link);
  void mark_receivers();
  bool is_over(const domain::Domain& domain, const TieLink& link, bool look) const;
  void share_velocities(domain::Domain& domain);
  void copy_velocities(domain::Domain& domain, double step) const;

  std::vector<TieLink> links_;            ///< those whose nodes carry nothing first
  std::vector<std::int32_t> active_;      ///< 1 or 0, by link
  std::vector<Index> members_;            ///< domain nodes that take part, ascending
  std::vector<Index> tied_by_;            ///< active link of a member, or no_index
  std::vector<std::uint8_t> receives_;    ///< 1 for the corners of active links, by member
  std::vector<double> death_time_;        ///< by tie
  std::vector<double> end_time_;          ///< by embedding
  AlignedArray<math::Vec3> before_;       ///< v(n-1/2), by member
  AlignedArray<math::Vec3> spin_before_;  ///< the same of angular velocities
  AlignedArray<math::Vec3> momentum_;     ///< that members received in this step, and pass on
  AlignedArray<math::Vec3> moment_;       ///< the same of angular momentum
  Index eroded_ = 0;                      ///< elements of the model at the last look
  bool keep_acceleration_ = false;        ///< output asks for accelerations
};

}  // namespace crumple::constraints
