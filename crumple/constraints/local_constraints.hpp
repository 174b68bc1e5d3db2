// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "constraints/kinetic_change.hpp"
#include "constraints/prescribed_motion.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// What holds and moves the nodes that have a support in axes of their own, or a motion along a vector or
/// round an axis: all directions of such a node are solved together, those of the global axes as well. They
/// replace what the kick has made of its velocities, as PrescribedMotions does
/// (docs/theory/prescribed_motion.md).
class LocalConstraints {
 public:
  /// Velocities at time zero lose what supports hold. The model must outlive the constraints. Throws Error
  /// for a node that a rigid body moves.
  LocalConstraints(const model::Model& model, domain::Domain& domain);

  bool empty() const { return nodes_.empty(); }

  /// Lists what supports hold at the present time, for contact and walls, which act before and after them.
  void refresh(domain::Domain& domain);

  /// Keeps the velocities of n-1/2. Before the kick of the nodes.
  void remember(const domain::Domain& domain);

  /// Sets the velocities of n+1/2, after the kick of the nodes over `interval` and before the drift over
  /// `next_step`. Returns what the kinetic energy of the nodes at time n changes by.
  KineticChange impose(domain::Domain& domain, double interval, double next_step);

  /// What the supports of a node have put on it over the last interval.
  struct Reaction {
    Index node = no_index;  ///< of the domain
    math::Vec3 force;       ///< [force]
    math::Vec3 moment;      ///< [force * length]
  };
  std::span<const Reaction> reactions() const { return reactions_; }

  void declare(domain::StateList& list);

 private:
  /// One direction along or about which a node is held or moved.
  struct Row {
    math::Vec3 direction;     ///< of unit length; of a motion round an axis whose radius is free: none
    bool rotation = false;    ///< about it
    Index motion = no_index;  ///< in Model::prescribed_motions; no_index: at rest
    bool is_support = true;   ///< of a support, not of a motion
    double birth = 0;         ///< free before [time]
    double death = 1e28;      ///< free from then on [time]
  };
  struct Node {
    Index node = no_index;  ///< of the domain
    std::size_t first = 0;  ///< its rows, those that go before others first
    std::size_t last = 0;   ///< the one behind them
    math::Vec3 position;    ///< x(n)
    math::Vec3 velocity;    ///< v(n-1/2)
    math::Vec3 spin;        ///< omega(n-1/2)
  };
  void add_support(const model::LocalSupport& support);
  void add_held_axes(std::uint8_t fixed);  ///< of the global ones
  void add_motion(const model::PrescribedMotion& motion, Index place);
  /// A direction, and the velocity of n+1/2 along it.
  struct Demand {
    math::Vec3 direction;
    double velocity = 0;
  };
  /// `velocity` is that of n+1/2 as far as it is known.
  Demand demand(const Node& node, const Row& row, const MotionTimes& times, const math::Vec3& velocity) const;
  Demand demand_round(const Node& node, const Row& row, const MotionTimes& times,
                      const math::Vec3& velocity) const;
  void stop_initial_motion(domain::Domain& domain, const Node& node) const;
  /// Changes the velocity as the rows of one sort ask; returns the part that supports have in the change.
  math::Vec3 constrain(const Node& node, bool rotation, const MotionTimes& times, math::Vec3& velocity) const;

  const model::Model* model_;
  std::vector<double> changes_;  ///< births and deaths of supports, ascending [time]
  std::ptrdiff_t changed_ = -1;  ///< how many of them had been when the holds were listed; -1: not known
  std::vector<Row> rows_;
  std::vector<Node> nodes_;
  std::vector<Reaction> reactions_;  ///< of each node
  std::vector<double> deferred_;     ///< of each node: half of the work, which the energy of n+1 shows
};

}  // namespace crumple::constraints
