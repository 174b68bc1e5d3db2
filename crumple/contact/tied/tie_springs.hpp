// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Tied contact: nodes of a first side that are joined to segments of a second. What is tied is decided once,
// at time zero, by the distance of the node from the nearest segment (tie_search.hpp), with the tolerances of
// LS-DYNA's Keyword User's Manual.
//
//           o  node           TIED without OFFSET: the node is put onto its segment and follows it
//           |                 (constraints/tied_nodes.hpp)
//           |  h              OFFSET: the gap stays, the node follows a = sum of w_k x_k + h n, at its own
//           |                 height over the segment; a spring holds it there where something else
//     ------+------ segment   holds the node or its segment
//                             TIEBREAK: a spring holds it there, until it breaks
//
// The forces on the corners are the derivatives of the spring's energy by their positions, so that force and
// moment of force sum to zero and no rigid motion makes a force (own derivation, docs/theory/tied.md). The
// stiffness is ten times that of a contact, at most what half of the stability budget of contact allows. With
// TIEBREAK a tie ends where tension and shear exceed its strength, or is damaged from there until it has
// taken its energy (cohesive_law.hpp); all ties end with their segment, or when their time is over.
//
// Order of calls: find_ties() before the elements are prepared, as it moves nodes; constraints::TiedNodes,
// which takes the nodes that follow; a TieSprings for each tie that has others; add_forces() in every step.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

using math::Vec3;

/// What all springs by penalty have at a node or rigid body.
struct SpringSums {
  std::vector<double> at_node;  ///< sum of their gains, one for the node that is tied [-]
  std::vector<Index> at_body;   ///< springs to segments of the body
};

/// Nodes that springs hold to segments: those of a tie that do not follow (TiedNode::follows). The other end
/// of a spring stands at the height of the node over its segment, on the segment's normal, and moves with it:
/// forces on the corners are the derivatives of the spring's energy by their places, so that force and moment
/// of force add up to zero and no rigid motion makes a force (docs/theory/tied.md). Bodies may be rigid on
/// either side.
class TieSprings {
 public:
  /// `tie` is the place of the contact in Model::tied_contacts and domain.ties.
  TieSprings(const model::Model& model, const domain::Domain& domain, Index tie);

  /// Adds the forces at time n to nodes.force and Tie::force, and ends ties that are overloaded, whose
  /// segment has eroded or whose time is over. Work since the last call goes into the tie's energy, by the
  /// trapezoidal rule.
  void add_forces(domain::Domain& domain);

  /// The longest step for which ties that soften keep the stiffness of their first step: cutting it later
  /// would take strength and energy from them. The largest number where none is left [time].
  double longest_step() const;

  void declare(domain::StateList& list);

 private:
  static constexpr std::size_t ends = 5;  ///< the node and four corners
  struct Spring {
    domain::TiedNode tied;
    std::size_t at = 0;            ///< in Tie::nodes
    double inverse_mass = 0;       ///< bound on 1/m* with shared masses [1/mass]
    double turning_stiffness = 0;  ///< 0: rotations are free [force * length]
    double inverse_inertia = 0;    ///< as inverse_mass [1/(mass * length^2)]
  };
  /// Where the ends of a spring are.
  struct Place {
    Vec3 first;       ///< diagonals of the segment [length]
    Vec3 second;      ///< likewise
    Vec3 normal;      ///< of the segment, of unit length
    double size = 0;  ///< of the product of the diagonals; 0: the segment has no normal [length^2]
    Vec3 away;        ///< stretch of the spring [length]
  };
  /// Stiffness now, damage included [force/length].
  struct Secant {
    double normal = 0;
    double shear = 0;
  };
  /// Forces of a spring, and of its moments.
  struct Load {
    std::array<Vec3, ends> force{};  ///< on the node and on the corners [force]
    Vec3 moment;                     ///< on the node; reversed and shared by weights on the corners
    double opening = 0;              ///< stretch of the spring [length]
    double share = 0;                ///< of its strength, or its damage [-]
  };

  std::array<Index, ends> nodes_of(const Spring& spring) const;
  void set_limits(const domain::Domain& domain, const SpringSums& sums, Spring& spring) const;
  bool ends_now(const domain::Domain& domain, const Spring& spring, bool look) const;
  void settle_stiffness(double step);
  static Place place_of(const domain::NodeFields& nodes, const domain::TiedNode& tied);
  Secant secant_of(std::size_t at, const Place& place, double limit);
  void add_moment(const domain::Domain& domain, std::size_t at, double limit, Load& load);
  Load evaluate(const domain::Domain& domain, std::size_t at, double step);
  double share_of_strength(const Spring& spring, double tension, double shear) const;
  double add(domain::Domain& domain, std::size_t at, const Load& load);

  model::TiedContact contact_;
  Index tie_;
  double step_scale_;
  double budget_;
  Index eroded_ = 0;
  std::vector<Spring> springs_;
  std::vector<std::int32_t> active_;
  std::vector<Load> loads_;      ///< now
  std::vector<Load> previous_;   ///< at time n - 1
  std::vector<double> bedding_;  ///< of ties that soften, before damage; 0: not settled [force/length]
  std::vector<double> damage_;   ///< likewise, 1 is broken [-]
  std::vector<Vec3> turn_;       ///< of the node against its segment, in the segment's frame [rad]
};

}  // namespace crumple::contact
