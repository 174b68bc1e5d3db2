// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/enforcement/touch.hpp"
#include "contact/surface/kinematics.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// Contact forces as Lagrange multipliers of a forward increment: the forces at time n are those that leave
/// no penetration at time n+1, no slip where friction holds, and never pull (Carpenter, Taylor & Katona, Int.
/// J. Numer. Meth. Engng 32 (1991) 103-128). The step stays that of the elements. The equations are solved
/// touch by touch in a fixed order until nothing changes any more (projected Gauss-Seidel).
///
/// What is held does not yield: what supports hold along whatever axes, and the nodes of rigid bodies, whose
/// motion in the step counts as given.
class Multipliers {
 public:
  Multipliers(const Surface& surface, const model::Contact& contact);

  /// Where the nodes will be at n+1 if there is no contact: v(n-1/2) + interval f(n) / m, and from there one
  /// `step`. `step` is the next one, `interval` what velocities are advanced by. Holds until the next call.
  Kinematics predict(const domain::Domain& domain, double interval, double step);

  /// Writes the forces of the touches, which were found where predict() said, and reduces their penetration
  /// to what is left. The positions that predict() returned are those at n+1 afterwards.
  void solve(std::span<Touch> touches);

  /// Rounds of the last call.
  int rounds() const { return rounds_; }

 private:
  struct Unknown {
    double compliance = 0;             ///< relative displacement per normal force [length/force]
    double tangential_compliance = 0;  ///< the largest in the tangential plane [length/force]
    double friction = 0;               ///< coefficient
    double friction_stress = 0;        ///< bound over the area of the touch [stress]; 0: none
    double force = 0;                  ///< [force]
    Vec3 friction_force;               ///< on the first point [force]
  };

  void predict_node(const domain::NodeFields& nodes, Index node, double interval);
  Unknown prepare(const Touch& touch) const;
  double correct_normal(const Touch& touch, Unknown& unknown);
  double correct_friction(const Touch& touch, Unknown& unknown);
  void move(const Touch& touch, const Vec3& force);
  Vec3 moved(const Touch& touch) const;
  Vec3 slip_in_step(const Touch& touch) const;

  const Surface* surface_;
  model::Contact contact_;
  double step_ = 0;
  std::vector<Vec3> position_;    ///< predicted, by domain node
  std::vector<Vec3> velocity_;    ///< likewise
  std::vector<Vec3> compliance_;  ///< displacement at n+1 per force, along each axis, by place [length/force]
  std::vector<const domain::LocalHold*> holds_;  ///< what else holds the node, by place; null where nothing
  std::vector<Vec3> displacement_;  ///< by the forces so far, by place; zero between calls [length]
  std::vector<Unknown> unknowns_;
  int rounds_ = 0;
};

}  // namespace crumple::contact
