// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Resistance of joints (*CONSTRAINED_JOINT_STIFFNESS). Both bodies carry a coordinate system; the second one
// is turned against the first by three rotations one after the other: phi about the x axis of A, theta about
// the y axis that has turned with it, psi about the z axis of B. Or its origin is displaced along the axes of
// A. Each of the three coordinates q has its own resistance
//
//     curve over q + stop + friction + curve over q'
//
// and the generalized forces act through the dual vectors of the axes of rotation, so that their power is
// that of the moments on the bodies (docs/theory/joints.md).

#include <array>
#include <limits>
#include <vector>

#include "constraints/joint_load.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// The joint stiffnesses of a model.
class JointStiffnesses {
 public:
  /// Adds the reports to the domain, whose rigid bodies must be there, at time zero. The model must outlive
  /// the object.
  JointStiffnesses(const model::Model& model, domain::Domain& domain);

  /// Adds the moments and forces at time n to the bodies. Work since time n-1 goes into the reports and into
  /// the ledger's damping energy, by the trapezoidal rule.
  void add_forces(domain::Domain& domain);

  /// The longest step for which springs and dampers are stable now, infinite without any [time].
  double longest_step() const { return longest_step_; }

  /// Declares what is remembered from step to step.
  void declare(domain::StateList& list);

 private:
  /// The coordinate systems, carried by the bodies: vectors in their axes.
  struct Frames {
    std::array<Index, 2> body{};
    std::array<math::Matrix3, 2> axes{};
    std::array<Vec3, 2> origin{};
  };
  /// What is remembered of time n-1.
  struct Memory {
    std::array<double, 3> position{};  ///< coordinates; phi and psi may be beyond half a turn
    std::array<double, 3> slip{};      ///< coordinate at which friction has no force
    JointLoad elastic;                 ///< curves, stops and friction
    JointLoad damping;
  };
  static_assert(sizeof(Memory) == 24 * sizeof(double));
  /// The three coordinates now, with what multiplies their generalized forces.
  struct Coordinates {
    std::array<double, 3> position{};
    std::array<double, 3> rate{};
    std::array<Vec3, 3> direction{};  ///< of the moment on B, or of the force
    Vec3 place;                       ///< where forces act
  };

  Coordinates coordinates(const domain::Domain& domain, std::size_t at) const;
  double elastic_force(const model::JointResistance& resistance, double position) const;
  void set_longest_step(const domain::Domain& domain);
  void add(domain::Domain& domain, std::size_t at);

  const model::Model* model_;
  std::vector<Frames> frames_;
  std::vector<Memory> memory_;
  std::vector<Index> joints_of_body_;  ///< how many act on each body
  double longest_step_ = std::numeric_limits<double>::infinity();
};

}  // namespace crumple::constraints
