// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "constraints/kinetic_change.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// Linear equations C v = 0 between components of velocities. After the kick the smallest impulses that
/// restore them act, v -= W C^T (C W C^T)^-1 C v, with the inverse masses W, zero for what is fixed: so the
/// constraint does no work. Equations that share a component are solved together, by Cholesky's
/// factorisation (docs/theory/connections.md).
class LinearEquations {
 public:
  /// Makes the velocities at time zero fit, too. Throws Error for equations that cannot be solved.
  LinearEquations(const model::Model& model, domain::Domain& domain);

  bool empty() const { return groups_.empty(); }

  /// Keeps the angular velocities of n-1/2.
  void remember(const domain::Domain& domain);

  /// Changes the velocities v(n+1/2). Returns what the rotational energy at time n changes by.
  KineticChange constrain(domain::Domain& domain);

 private:
  struct Term {
    Index node = no_index;  ///< domain node
    int component = 0;
    double factor = 0;
    Index place = no_index;  ///< of the component in its group
  };
  struct Equation {
    UserId id = 0;
    std::vector<Term> terms;
  };
  /// Equations that share components.
  struct Group {
    std::vector<Equation> equations;
    std::vector<double> inverse_mass;  ///< by component
    std::vector<double> impulse;       ///< C^T x, by component
    std::vector<double> matrix;        ///< C W C^T and its factor, lower triangle, row by row
    std::vector<double> right;         ///< C v, and what solves for it
  };
  /// A node with a rotation in an equation.
  struct Spin {
    Index node = no_index;
    math::Vec3 before{};
  };

  void make_groups(const model::Model& model, const domain::Domain& domain);
  static bool take_masses(const domain::NodeFields& nodes, Group& group);
  static void assemble(Group& group);
  static bool factorise(Group& group);
  static void solve(Group& group);
  static void push(domain::NodeFields& nodes, const Group& group);

  std::vector<Group> groups_;
  std::vector<Spin> spins_;
};

}  // namespace crumple::constraints
