// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Joints between two rigid bodies A and B by penalty (*CONSTRAINED_JOINT). Each joint is made of springs with
// dampers, between points and directions that the bodies carry:
//
//     point      a point p of B is held at a point q of A, in all directions or in some that A carries:
//                f = -k d - c d', d the held part of p - q; -f acts on A at the same place p
//     direction  a direction b of B keeps its angle with a direction a of A:
//                moment -k (a.b - its beginning) b x a on B, the opposite on A
//
//     spherical      the point of N1, N2               revolute       points of N1, N2 and N3, N4
//     cylindrical    N2, N4 of B held across the axis N1, N3 of A
//     translational  the same, and N6 held in the plane of the axis and N5
//     universal      the point of N1, N2, and the directions N1, N3 of A and N2, N4 of B
//     locking        points of N1, N2 and N3, N4 and N5, N6
//
// Forces and moments on both bodies sum to zero about any point, so that a joint keeps both momenta. The
// stiffness follows from the masses of the bodies and the step (docs/theory/joints.md): a joint never limits
// the step.

#include <array>
#include <vector>

#include "constraints/joint_load.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// The joints of a model.
class Joints {
 public:
  /// Adds the reports of the joints to the domain, whose rigid bodies must be there, at time zero. Throws
  /// Error if a node of a joint belongs to no rigid body.
  Joints(const model::Model& model, domain::Domain& domain);

  /// Adds the forces at time n to the forces and moments of the bodies. Work since time n-1 goes into the
  /// reports and into the ledger's damping energy, by the trapezoidal rule.
  void add_forces(domain::Domain& domain);

  /// Declares what is remembered from step to step.
  void declare(domain::StateList& list);

 private:
  /// A spring of a joint. Vectors are in the axes of the body that carries them.
  struct Spring {
    bool is_direction = false;
    Vec3 first;                                  ///< of A: arm of the point, or the direction
    Vec3 second;                                 ///< of B: the same
    math::Matrix3 axes = math::unit_matrix();    ///< of A: along which a point is held
    std::array<bool, 3> held{true, true, true};  ///< along which of them
    double cosine = 0;                           ///< of two directions at time zero
  };
  struct Joint {
    std::array<Index, 2> body{};
    double stiffness_scale = 1;
    double damping = 1;
    Vec3 point;  ///< first node, arm of A
    std::vector<Spring> springs;
    std::size_t first_spring = 0;  ///< place in penalty_
  };
  /// What a joint puts on its bodies.
  struct Loads {
    JointLoad elastic;
    JointLoad damping;
    double opening = 0;
  };

  /// Positions of a joint's nodes.
  using Places = std::array<Vec3, 6>;

  static void add_springs(const Places& place, model::JointKind kind, const JointBodies& body, Joint& joint);
  static void add_sliding_springs(const Places& place, model::JointKind kind, const JointBodies& body,
                                  Joint& joint);
  double inverse_mass(const domain::Domain& domain, const Joint& joint, const Spring& spring) const;
  void set_penalties(const domain::Domain& domain, double step);
  Loads evaluate(const domain::Domain& domain, const Joint& joint, double step) const;

  double step_scale_;
  std::vector<Joint> joints_;
  std::vector<Index> springs_of_body_;  ///< how many act on each body
  std::vector<double> penalty_;         ///< stiffness of each spring, from the first step on
  std::vector<JointLoad> previous_;     ///< elastic and damping load of each joint at time n-1
};

}  // namespace crumple::constraints
