// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "constraints/kinetic_change.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// Nodes that move with the mean of others (*CONSTRAINED_INTERPOLATION): by the rigid motion that fits the
/// velocities of the independent nodes best, in weighted least squares. After the kick equal and opposite
/// impulses act on the dependent node and, by the transpose of that fit, on the independent ones, so that
/// momentum and its moment are kept. The fit is that of the middle of the coming step, where a rigid rotation
/// is one; impulses act at the places of time n (own derivation, docs/theory/connections.md).
class Interpolations {
 public:
  /// Makes the velocities at time zero fit, too. Throws Error for one that cannot be solved.
  Interpolations(const model::Model& model, domain::Domain& domain);

  bool empty() const { return all_.empty(); }

  /// Keeps the angular velocities of n-1/2, and lets the forces on dependent nodes without mass act on the
  /// independent ones. To be called before the kick.
  void prepare(domain::Domain& domain);

  /// Changes the velocities v(n+1/2); `next_step` is the step that they will be used for. Returns what the
  /// rotational energy at time n changes by.
  KineticChange constrain(domain::Domain& domain, double next_step);

 private:
  struct Independent {
    Index node = no_index;  ///< domain node
    double weight = 0;      ///< of its translations; all sum to one [-]
    double turning = 0;     ///< of its rotations [length^2]
  };
  /// A symmetric matrix by its upper triangle.
  struct Symmetric {
    double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
    math::Vec3 operator*(const math::Vec3& v) const;
  };
  /// Velocities or impulses: along and about the axes.
  struct Motion {
    math::Vec3 along, about;
    double& operator[](std::size_t component);
  };
  /// The rigid fit at given places of the nodes. Everything from the weighted centre.
  struct Fit {
    std::vector<math::Vec3> arm;  ///< of the independent nodes
    math::Vec3 dependent;         ///< arm of the dependent one
    Symmetric inverse;            ///< of the weighted moments of inertia; zero where there is none
  };
  struct Interpolation {
    UserId id = 0;
    Index dependent = no_index;     ///< domain node
    std::array<bool, 6> follows{};  ///< translations and rotations of it
    std::vector<Independent> independent;
    Fit now;     ///< at time n
    Fit middle;  ///< half a step later
  };
  /// A node with what it turned with before the kick.
  struct Spin {
    Index node = no_index;
    math::Vec3 before{};
  };
  /// Rows of one interpolation that are solved for.
  struct Rows {
    std::array<std::size_t, 6> component{};
    std::size_t count = 0;
  };
  using Matrix = std::array<std::array<double, 6>, 6>;

  static Interpolation made(const model::Interpolation& given, const domain::NodeFields& nodes);
  static void fit(const domain::NodeFields& nodes, double time, const Interpolation& of, Fit& fit);
  static Motion fitted(const domain::NodeFields& nodes, const Interpolation& of);
  static Motion share(const Fit& fit, const Interpolation& of, std::size_t i, const Motion& impulse);
  static Matrix response(const domain::NodeFields& nodes, const Interpolation& of, const Rows& rows);
  static double correct(domain::NodeFields& nodes, const Interpolation& of);

  std::vector<Interpolation> all_;
  std::vector<Spin> spins_;
  bool share_nodes_ = false;  ///< some nodes are in several: these are solved in turn until all fit
};

}  // namespace crumple::constraints
