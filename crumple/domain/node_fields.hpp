// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "base/aligned_array.hpp"
#include "base/index.hpp"
#include "math/rotation.hpp"
#include "math/vec3.hpp"

namespace crumple::domain {

using math::Vec3;

/// What an element gathers from a node, in one cache line for float kernels. The integrator writes it when
/// the node has moved. The fourth places are padding, so that a vector loads whole.
template <class Real>
struct alignas(sizeof(Real) == sizeof(float) ? 64 : 32) NodeRecord {
  double position[4];        ///< x at time n [length]
  Real velocity[4];          ///< v at n - 1/2 [length/time]
  Real angular_velocity[4];  ///< omega at n - 1/2 [1/time]
};

/// Sum of forces and moments at a node; always double.
struct alignas(64) NodeForce {
  double force[4];   ///< [force]; the fourth place is padding
  double moment[4];  ///< [force * length]; the fourth place is padding
};

/// Bits of NodeFields::fixed, set where a degree of freedom is held at zero.
inline constexpr std::uint8_t fixed_translation(int axis) {
  return static_cast<std::uint8_t>(1U << axis);
}
inline constexpr std::uint8_t fixed_rotation(int axis) {
  return static_cast<std::uint8_t>(8U << axis);
}
/// Bit of NodeFields::fixed, set where a rigid body moves the node: the integrator leaves its velocities
/// alone and does not count its kinetic energy.
inline constexpr std::uint8_t moved_by_body = 64;
/// Bit of NodeFields::fixed, set while the node follows the segment that it is tied to.
inline constexpr std::uint8_t moved_by_tie = 128;

/// What supports along axes of their own, or for a part of the run, leave of a node's translation; the global
/// axes that are fixed are in it as well.
struct LocalHold {
  math::Matrix3 free = math::unit_matrix();  ///< projects on the directions that are free
  int held = 0;                              ///< directions that are not
  bool lasts = true;                         ///< the same during the whole run
};

/// The fields of all nodes, in the domain's own numbering. Every array has one entry per node, but `force`,
/// which has Assembly::slots() more at its end.
struct NodeFields {
  AlignedArray<Vec3> position;          ///< x at time n [length]
  AlignedArray<Vec3> velocity;          ///< v at n - 1/2 [length/time]
  AlignedArray<Vec3> angular_velocity;  ///< omega at n - 1/2, global axes [1/time]
  AlignedArray<double> mass;            ///< [mass]
  AlignedArray<double> inertia;         ///< rotary inertia, isotropic [mass * length^2]; 0 without shells
  AlignedArray<std::uint8_t> fixed;     ///< see fixed_translation, moved_by_body, moved_by_tie
  AlignedArray<NodeForce> force;        ///< forces on the nodes at time n, cleared by the integrator
  AlignedArray<Vec3> reference;         ///< position at time zero [length]; never changes
  AlignedArray<Vec3> acceleration;      ///< at time n, if output asks for it [length/time^2]

  // Of nodes that are tied to this one by a constraint: they move with it. Empty without such ties.
  AlignedArray<double> carried_mass;     ///< besides `mass` [mass]
  AlignedArray<double> carried_inertia;  ///< besides `inertia` [mass * length^2]

  AlignedArray<NodeRecord<float>> float_records;    ///< filled in mixed precision, else empty
  AlignedArray<NodeRecord<double>> double_records;  ///< filled in double precision, else empty

  std::vector<Index> local_hold;       ///< place in local_holds of a node, or no_index; empty without any
  std::vector<LocalHold> local_holds;  ///< at the present time

  std::vector<Index> model_node;   ///< model index of a domain node
  std::vector<Index> domain_node;  ///< domain index of a model node

  bool is_free(Index node) const { return (fixed[node] & moved_by_body) == 0; }
  bool is_tied(Index node) const { return (fixed[node] & moved_by_tie) != 0; }

  /// What resists a change of the node's velocity [mass], and of its angular velocity [mass * length^2].
  double moving_mass(Index node) const {
    return carried_mass.empty() ? mass[node] : mass[node] + carried_mass[node];
  }
  double moving_inertia(Index node) const {
    return carried_inertia.empty() ? inertia[node] : inertia[node] + carried_inertia[node];
  }

  /// What holds a translation along other axes than the global ones, or for a part of the run; null if
  /// nothing does.
  const LocalHold* local_hold_of(Index node) const {
    const Index place = local_hold.empty() ? no_index : local_hold[static_cast<std::size_t>(node)];
    return place == no_index ? nullptr : &local_holds[static_cast<std::size_t>(place)];
  }
  /// The part of a vector along which supports let the node move.
  Vec3 free_translation(Index node, Vec3 vector) const {
    if (const LocalHold* const hold = local_hold_of(node)) return hold->free * vector;
    for (int axis = 0; axis < 3; ++axis)
      if ((fixed[node] & fixed_translation(axis)) != 0) vector[axis] = 0;
    return vector;
  }

  Index count() const { return static_cast<Index>(position.size()); }

  /// Copies position and velocities of one node to its record.
  void publish(Index node);
  /// The same for all nodes.
  void publish_all();
};

template <class Real>
AlignedArray<NodeRecord<Real>>& records(NodeFields& nodes);
template <>
inline AlignedArray<NodeRecord<float>>& records<float>(NodeFields& nodes) {
  return nodes.float_records;
}
template <>
inline AlignedArray<NodeRecord<double>>& records<double>(NodeFields& nodes) {
  return nodes.double_records;
}

}  // namespace crumple::domain
