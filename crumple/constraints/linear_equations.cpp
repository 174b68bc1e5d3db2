// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/linear_equations.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "constraints/component_mass.hpp"

namespace crumple::constraints {

using domain::Domain;
using domain::NodeFields;

namespace {

/// Groups larger than this would take more time than the elements.
constexpr std::size_t most_together = 300;

double& component_of(NodeFields& nodes, Index node, int component) {
  return component < 3 ? nodes.velocity[node][component] : nodes.angular_velocity[node][component - 3];
}

/// Whether an equation says anything: zero velocities fulfil it.
bool can_move(const NodeFields& nodes, const model::LinearEquation& equation) {
  return std::any_of(equation.terms.begin(), equation.terms.end(), [&](const auto& term) {
    return inverse_mass_along(nodes, nodes.domain_node[term.node], term.component) > 0;
  });
}

std::size_t row_of(std::size_t row) {
  return row * (row + 1) / 2;
}

}  // namespace

LinearEquations::LinearEquations(const model::Model& model, Domain& domain) {
  if (model.linear_equations.empty()) return;
  make_groups(model, domain);
  remember(domain);
  for (Group& group : groups_) {
    take_masses(domain.nodes, group);
    assemble(group);
    if (!factorise(group))
      throw Error("The linear equation " + std::to_string(group.equations.front().id) +
                  " and those that share its nodes cannot be solved: they depend on each other.");
  }
  constrain(domain);
}

void LinearEquations::make_groups(const model::Model& model, const Domain& domain) {
  // Each equation takes in the groups that know one of its components already.
  std::map<std::pair<Index, int>, std::size_t> group_of;
  std::vector<Group> found;
  for (const model::LinearEquation& given : model.linear_equations) {
    if (!can_move(domain.nodes, given)) continue;
    Equation equation{given.id, {}};
    const std::size_t own = found.size();
    Group& group = found.emplace_back();
    for (const model::LinearEquation::Term& term : given.terms) {
      const Index node = domain.nodes.domain_node[term.node];
      equation.terms.push_back({node, term.component, term.factor});
      const auto [entry, is_new] = group_of.try_emplace({node, term.component}, own);
      const std::size_t other = entry->second;
      if (is_new || other == own) continue;
      std::move(found[other].equations.begin(), found[other].equations.end(),
                std::back_inserter(group.equations));
      found[other].equations.clear();
      for (auto& [component, its] : group_of)
        if (its == other) its = own;
    }
    group.equations.push_back(std::move(equation));
  }
  for (Group& group : found) {
    if (group.equations.empty()) continue;
    const std::size_t count = group.equations.size();
    if (count > most_together)
      throw Error("More than " + std::to_string(most_together) + " linear equations, among them " +
                  std::to_string(group.equations.front().id) + ", share nodes with each other.");
    std::map<std::pair<Index, int>, Index> place_of;
    for (Equation& equation : group.equations)
      for (Term& term : equation.terms) {
        const auto next = static_cast<Index>(place_of.size());
        term.place = place_of.try_emplace({term.node, term.component}, next).first->second;
        if (term.component >= 3) spins_.push_back({term.node});
      }
    group.inverse_mass.resize(place_of.size());
    group.impulse.resize(place_of.size());
    group.matrix.resize(row_of(count));
    group.right.resize(count);
    groups_.push_back(std::move(group));
  }
  std::sort(spins_.begin(), spins_.end(), [](const Spin& a, const Spin& b) { return a.node < b.node; });
  spins_.erase(std::unique(spins_.begin(), spins_.end(),
                           [](const Spin& a, const Spin& b) { return a.node == b.node; }),
               spins_.end());
}

/// Returns whether any is not what it was.
bool LinearEquations::take_masses(const NodeFields& nodes, Group& group) {
  bool changed = false;
  for (const Equation& equation : group.equations)
    for (const Term& term : equation.terms) {
      double& known = group.inverse_mass[static_cast<std::size_t>(term.place)];
      const double now = inverse_mass_along(nodes, term.node, term.component);
      changed = changed || now != known;
      known = now;
    }
  return changed;
}

void LinearEquations::assemble(Group& group) {
  const std::size_t count = group.equations.size();
  for (std::size_t row = 0; row < count; ++row) {
    std::fill(group.impulse.begin(), group.impulse.end(), 0.0);
    for (const Term& term : group.equations[row].terms) {
      const auto place = static_cast<std::size_t>(term.place);
      group.impulse[place] += group.inverse_mass[place] * term.factor;
    }
    for (std::size_t column = 0; column <= row; ++column) {
      double sum = 0;
      for (const Term& term : group.equations[column].terms)
        sum += term.factor * group.impulse[static_cast<std::size_t>(term.place)];
      group.matrix[row_of(row) + column] = sum;
    }
  }
}

/// Cholesky's factor in place; false if the matrix is singular.
bool LinearEquations::factorise(Group& group) {
  constexpr double singular = 1e-12;
  std::vector<double>& a = group.matrix;
  for (std::size_t row = 0; row < group.equations.size(); ++row) {
    const double whole = a[row_of(row) + row];
    for (std::size_t column = 0; column <= row; ++column) {
      double sum = a[row_of(row) + column];
      for (std::size_t k = 0; k < column; ++k) sum -= a[row_of(row) + k] * a[row_of(column) + k];
      if (column < row)
        a[row_of(row) + column] = sum / a[row_of(column) + column];
      else if (sum > singular * whole)
        a[row_of(row) + row] = std::sqrt(sum);
      else
        return false;
    }
  }
  return true;
}

void LinearEquations::solve(Group& group) {
  const std::vector<double>& a = group.matrix;
  std::vector<double>& x = group.right;
  const std::size_t count = x.size();
  for (std::size_t row = 0; row < count; ++row) {
    for (std::size_t k = 0; k < row; ++k) x[row] -= a[row_of(row) + k] * x[k];
    x[row] /= a[row_of(row) + row];
  }
  for (std::size_t row = count; row-- > 0;) {
    for (std::size_t k = row + 1; k < count; ++k) x[row] -= a[row_of(k) + row] * x[k];
    x[row] /= a[row_of(row) + row];
  }
}

void LinearEquations::push(NodeFields& nodes, const Group& group) {
  for (std::size_t row = 0; row < group.equations.size(); ++row)
    for (const Term& term : group.equations[row].terms)
      component_of(nodes, term.node, term.component) -=
          group.inverse_mass[static_cast<std::size_t>(term.place)] * term.factor * group.right[row];
}

void LinearEquations::remember(const Domain& domain) {
  for (Spin& spin : spins_) spin.before = domain.nodes.angular_velocity[spin.node];
}

KineticChange LinearEquations::constrain(Domain& domain) {
  NodeFields& nodes = domain.nodes;
  const auto rotational = [&] {
    double sum = 0;
    for (const Spin& spin : spins_)
      sum += 0.5 * nodes.moving_inertia(spin.node) * dot(spin.before, nodes.angular_velocity[spin.node]);
    return sum;
  };
  const double before = rotational();
  for (Group& group : groups_) {
    // Masses change when a tie ends.
    if (take_masses(nodes, group)) {
      assemble(group);
      factorise(group);
    }
    for (std::size_t row = 0; row < group.equations.size(); ++row) {
      group.right[row] = 0;
      for (const Term& term : group.equations[row].terms)
        group.right[row] += term.factor * component_of(nodes, term.node, term.component);
    }
    solve(group);
    push(nodes, group);
  }
  KineticChange change;
  change.rotational = rotational() - before;
  return change;
}

}  // namespace crumple::constraints
