// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "constraints/body_impact.hpp"
#include "constraints/near_nodes.hpp"
#include "constraints/wall_impact.hpp"
#include "constraints/wall_shapes.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// A surface that stops nodes, at rest, with a prescribed motion, or with a mass that they push: impact is
/// perfectly plastic, the force is the momentum exchanged (LS-DYNA Theory Manual, "Rigid walls"). Velocity is
/// changed in the integrator, between the kick and the drift, so that no node ever passes the surface. Nodes
/// of rigid bodies stop their bodies (see stop_body()); those of a turning one may pass by what the turn of a
/// step adds to its velocity.
class RigidWall {
 public:
  /// `report` is the place of this wall in domain.walls. Puts a wall with a displacement
  /// curve to where it is at time zero. The model must outlive the wall.
  RigidWall(const model::Model& model, const model::RigidWall& wall, domain::Domain& domain, Index report);

  /// What a wall needs to know of the step besides the domain.
  struct Step {
    const AlignedArray<math::Vec3>& previous_velocity;  ///< v(n-1/2) [length/time]
    double interval = 0;                                ///< over which the forces of time n act [time]
    double next = 0;                                    ///< the coming step [time]
    /// No node that a wall stops one by one is faster; infinite if that is not known. Raised if the wall
    /// makes one faster [length/time].
    double& fastest;
  };
  /// Takes from the velocities v(n+1/2) what would carry nodes through the surface within the coming step,
  /// with Coulomb friction along it. Adds impulse and energy to the report, the work of a prescribed motion
  /// to the ledger's external work, and moves the wall to time n+1. Returns by how much the kinetic energy of
  /// time n of the nodes that are stopped one by one changes [energy].
  double stop_nodes(domain::Domain& domain, const Step& step);

  /// To be called when positions have been put back to those of another time.
  void resume() { near_.forget(); }

  /// Declares where the wall is and how it moves.
  void declare(domain::StateList& list);

  /// Of all walls with mass at time n [energy].
  static double kinetic_energy(const domain::Domain& domain);

 private:
  /// What the wall's nodes do to it in one step.
  struct Sums {
    math::Vec3 impulse;  ///< on the wall
    double normal_impulse = 0;
    double energy = 0;    ///< the half that the kinetic energy of time n shows
    double deferred = 0;  ///< the half that the one of n+1 shows
    double kinetic = 0;   ///< change of the kinetic energy of time n of nodes
  };
  /// What the nodes are stopped in.
  struct Impact {
    domain::Domain& domain;
    const Step& step;
    Sums sums{};
  };
  /// What a wall with mass cannot push away: a fixed node, or a place of a body that is held.
  struct Obstacle {
    double highest = 0;     ///< velocity along the normal that it lets the wall have [length/time]
    Index body = no_index;  ///< a fixed node has none
    math::Vec3 arm;         ///< in the body [length]
  };

  bool is_stopped(const domain::Domain& domain, Index node) const;
  void stop_node(Impact& impact, Index node, const WallLimit& limit) const;
  template <class Shape>
  std::span<const Index> nodes_in_reach(const Shape& shape, const Impact& impact);
  template <class Shape>
  void stop_body_at(const Shape& shape, Impact& impact, Index place);
  template <class Shape>
  void stop_at(const Shape& shape, Impact& impact);

  template <class Shape>
  void push_at(const Shape& shape, Impact& impact);
  template <class Shape>
  double find_common_velocity(const Shape& shape, Impact& impact);
  template <class Shape>
  bool find_nodes_to_push(const Shape& shape, const Impact& impact);
  template <class Shape>
  bool find_bodies_to_push(const Shape& shape, const Impact& impact);
  template <class Shape>
  double impulse_at(const Shape& shape, double velocity, Impact& impact);
  void meet_obstacle(Impact& impact, double momentum_lost) const;
  void book_slide(domain::WallReport& report, Sums& sums, double next_step) const;

  math::Vec3 displacement_after(const domain::Clock& clock, const math::Vec3& now, double next_step) const;

  const model::Model* model_;
  std::vector<Index> nodes_;  ///< domain nodes, ascending
  NearNodes near_;
  std::vector<char> stops_;         ///< of each domain node, whether it is one of them
  std::vector<char> touched_;       ///< the same, whether it is among touches_ or pushed_
  std::vector<BodyTouch> touches_;  ///< of the body at hand
  WallSurface surface_;             ///< at time zero
  model::WallMotion motion_;
  math::Vec3 normal_;  ///< of a plane
  double mass_ = 0;    ///< 0: the motion is prescribed [mass]
  double friction_ = 0;
  double birth_time_ = 0;
  double death_time_ = 0;
  Index report_ = 0;
  math::Vec3 displacement_;  ///< at time n [length]
  math::Vec3 velocity_;      ///< from n to n+1 [length/time]
  math::Vec3 frame_;         ///< velocity of the frame in which impacts lose their energy [length/time]

  // Of a wall with mass, in the step at hand.
  std::vector<PushedNode> pushed_;
  std::vector<Index> pushed_bodies_;
  double lowest_ = 0;  ///< velocity along the normal at which it would push nothing [length/time]
  Obstacle obstacle_;
};

}  // namespace crumple::constraints
