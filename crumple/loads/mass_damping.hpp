// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "domain/domain.hpp"
#include "loads/part_selection.hpp"
#include "model/model.hpp"

namespace crumple::loads {

/// Damping of motion in proportion to mass, of all or of parts (*DAMPING_GLOBAL, *DAMPING_PART_MASS):
/// -D(t) S m v on every node, likewise with its rotary inertia, and on rigid bodies with their mass and
/// momentum. Velocities are those of n-1/2, half a step late, so the damping lowers the stable step. Source:
/// LS-DYNA Keyword User's Manual, *DAMPING; the stability limit is our own derivation (docs/theory/loads.md).
class MassDamping {
 public:
  /// The model must outlive the loads.
  MassDamping(const model::Model& model, const domain::Domain& domain);

  /// From now on all motion loses `share` of its velocity in each step, besides other dampings (dynamic
  /// relaxation): v(n+1/2) = (1 - share) v(n-1/2) + step f(n) / m where the step does not change.
  void relax(const domain::Domain& domain, double share);

  /// Adds the forces at time n and, by the trapezoidal rule, what they took since time n-1 to the ledger's
  /// damping energy. On entry velocities are those of n-1/2 and clock.step is the step between.
  void add_forces(domain::Domain& domain);

  /// The part of an undamped stable step that is stable at time n: 1 without damping [-].
  double stable_share(double undamped_step);

  /// Declares what is remembered of time n-1.
  void declare(domain::StateList& list);

 private:
  /// Damping forces on something that moves and turns.
  struct Push {
    math::Vec3 force;
    math::Vec3 moment;
  };
  static_assert(sizeof(Push) == 6 * sizeof(double));

  /// One damping, with what it acts on.
  struct Damping {
    const model::MassDamping* given = nullptr;
    bool of_all = true;
    std::optional<double> lost_in_step;  ///< of the velocity, where the step sets the factor [-]
    NodeShares selection;                ///< unless of all
    std::vector<Index> bodies;           ///< in the domain
    double factor = 0;                   ///< D(t) at time n [1/time]
    std::vector<Push> on_nodes;          ///< at time n
    std::vector<Push> on_bodies;         ///< the same
  };

  double factor_of(const Damping& damping, const domain::Clock& clock) const;
  double damp_nodes(Damping& damping, domain::Domain& domain);
  static double damp_bodies(Damping& damping, domain::Domain& domain);

  const model::Model* model_;
  std::vector<Damping> dampings_;
  std::vector<double> taken_;         ///< by the pieces of nodes; kept for its room alone
  std::vector<double> rate_of_part_;  ///< the same
};

}  // namespace crumple::loads
