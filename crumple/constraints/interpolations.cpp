// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/interpolations.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "constraints/component_mass.hpp"

namespace crumple::constraints {

using domain::Domain;
using domain::NodeFields;
using math::Vec3;

namespace {

/// Share of the trace's cube below which a determinant is zero: the nodes lie on a line.
constexpr double on_a_line = 1e-12;

/// What an impulse changes the velocities of a node by; `first` is its first component.
Vec3 kicked(const NodeFields& nodes, Index node, int first, const Vec3& impulse) {
  return {inverse_mass_along(nodes, node, first) * impulse.x,
          inverse_mass_along(nodes, node, first + 1) * impulse.y,
          inverse_mass_along(nodes, node, first + 2) * impulse.z};
}

/// Solves a x = b of `count` rows by Gauss's elimination; x replaces b.
void eliminate(std::array<std::array<double, 6>, 6>& a, std::array<double, 6>& b, std::size_t count) {
  for (std::size_t step = 0; step < count; ++step) {
    std::size_t pivot = step;
    for (std::size_t row = step + 1; row < count; ++row)
      if (std::fabs(a[row][step]) > std::fabs(a[pivot][step])) pivot = row;
    std::swap(a[step], a[pivot]);
    std::swap(b[step], b[pivot]);
    if (a[step][step] == 0) continue;
    for (std::size_t row = step + 1; row < count; ++row) {
      const double factor = a[row][step] / a[step][step];
      for (std::size_t column = step; column < count; ++column) a[row][column] -= factor * a[step][column];
      b[row] -= factor * b[step];
    }
  }
  for (std::size_t row = count; row-- > 0;) {
    for (std::size_t column = row + 1; column < count; ++column) b[row] -= a[row][column] * b[column];
    b[row] = a[row][row] == 0 ? 0 : b[row] / a[row][row];
  }
}

}  // namespace

Vec3 Interpolations::Symmetric::operator*(const Vec3& v) const {
  return {xx * v.x + xy * v.y + zx * v.z, xy * v.x + yy * v.y + yz * v.z, zx * v.x + yz * v.y + zz * v.z};
}

double& Interpolations::Motion::operator[](std::size_t component) {
  return component < 3 ? along[static_cast<int>(component)] : about[static_cast<int>(component) - 3];
}

Interpolations::Interpolations(const model::Model& model, Domain& domain) {
  NodeFields& nodes = domain.nodes;
  for (const model::Interpolation& given : model.interpolations) {
    all_.push_back(made(given, nodes));
    fit(nodes, 0, all_.back(), all_.back().now);
    const Symmetric& inverse = all_.back().now.inverse;
    if (inverse.xx == 0 && inverse.yy == 0)
      throw Error("The independent nodes of the interpolation " + std::to_string(given.id) +
                  " lie on a line, so that it is open how they turn.");
    spins_.push_back({all_.back().dependent});
    for (const Independent& each : all_.back().independent) spins_.push_back({each.node});
  }
  const std::size_t entries = spins_.size();
  std::sort(spins_.begin(), spins_.end(), [](const Spin& a, const Spin& b) { return a.node < b.node; });
  spins_.erase(std::unique(spins_.begin(), spins_.end(),
                           [](const Spin& a, const Spin& b) { return a.node == b.node; }),
               spins_.end());
  share_nodes_ = spins_.size() < entries;
  if (empty()) return;
  for (Spin& spin : spins_) spin.before = nodes.angular_velocity[spin.node];
  constrain(domain, 0);
}

Interpolations::Interpolation Interpolations::made(const model::Interpolation& given,
                                                   const NodeFields& nodes) {
  Interpolation made;
  made.id = given.id;
  made.dependent = nodes.domain_node[given.dependent];
  made.follows = given.follows;
  double sum = 0;
  for (const model::Interpolation::Independent& each : given.independent) sum += each.weight;
  Vec3 centre;
  for (const model::Interpolation::Independent& each : given.independent) {
    made.independent.push_back({nodes.domain_node[each.node], each.weight / sum, 0});
    centre += made.independent.back().weight * nodes.position[made.independent.back().node];
  }
  // Rotations count by the mean square of the distance over which they would move the others.
  double square = 0;
  for (const Independent& each : made.independent) {
    const Vec3 arm = nodes.position[each.node] - centre;
    square += each.weight * dot(arm, arm);
  }
  for (std::size_t i = 0; i < made.independent.size(); ++i)
    if (nodes.moving_inertia(made.independent[i].node) > 0)
      made.independent[i].turning = given.independent[i].rotation_weight / sum * square;
  made.now.arm.resize(made.independent.size());
  made.middle.arm.resize(made.independent.size());
  return made;
}

/// The fit where the nodes are after `time` with their present velocities.
void Interpolations::fit(const NodeFields& nodes, double time, const Interpolation& of, Fit& fit) {
  const auto place = [&](Index node) { return nodes.position[node] + time * nodes.velocity[node]; };
  Vec3 centre;
  for (const Independent& each : of.independent) centre += each.weight * place(each.node);
  fit.dependent = place(of.dependent) - centre;
  Symmetric a;
  for (std::size_t i = 0; i < of.independent.size(); ++i) {
    const Vec3 r = place(of.independent[i].node) - centre;
    const double w = of.independent[i].weight;
    const double turning = of.independent[i].turning;
    fit.arm[i] = r;
    a.xx += w * (r.y * r.y + r.z * r.z) + turning;
    a.yy += w * (r.z * r.z + r.x * r.x) + turning;
    a.zz += w * (r.x * r.x + r.y * r.y) + turning;
    a.xy -= w * r.x * r.y;
    a.yz -= w * r.y * r.z;
    a.zx -= w * r.z * r.x;
  }
  const Symmetric adjugate{a.yy * a.zz - a.yz * a.yz, a.zz * a.xx - a.zx * a.zx, a.xx * a.yy - a.xy * a.xy,
                           a.yz * a.zx - a.xy * a.zz, a.zx * a.xy - a.yz * a.xx, a.xy * a.yz - a.zx * a.yy};
  const double determinant = a.xx * adjugate.xx + a.xy * adjugate.xy + a.zx * adjugate.zx;
  const double trace = a.xx + a.yy + a.zz;
  const double over = determinant > on_a_line * trace * trace * trace ? 1 / determinant : 0;
  fit.inverse = {over * adjugate.xx, over * adjugate.yy, over * adjugate.zz,
                 over * adjugate.xy, over * adjugate.yz, over * adjugate.zx};
}

/// What the dependent node should move and turn with.
Interpolations::Motion Interpolations::fitted(const NodeFields& nodes, const Interpolation& of) {
  Motion found;
  Vec3 turning;
  for (std::size_t i = 0; i < of.independent.size(); ++i) {
    const Independent& each = of.independent[i];
    found.along += each.weight * nodes.velocity[each.node];
    turning += each.weight * cross(of.middle.arm[i], nodes.velocity[each.node]) +
               each.turning * nodes.angular_velocity[each.node];
  }
  found.about = of.middle.inverse * turning;
  found.along += cross(found.about, of.middle.dependent);
  return found;
}

/// What an independent node gets of an impulse on the dependent one: the transpose of the fit.
Interpolations::Motion Interpolations::share(const Fit& fit, const Interpolation& of, std::size_t i,
                                             const Motion& impulse) {
  const Vec3 turning = fit.inverse * (impulse.about + cross(fit.dependent, impulse.along));
  return {of.independent[i].weight * (impulse.along + cross(turning, fit.arm[i])),
          of.independent[i].turning * turning};
}

void Interpolations::prepare(Domain& domain) {
  NodeFields& nodes = domain.nodes;
  for (Spin& spin : spins_) spin.before = nodes.angular_velocity[spin.node];
  for (Interpolation& of : all_) {
    domain::NodeForce& own = nodes.force[of.dependent];
    Motion impulse;
    for (std::size_t component = 0; component < 6; ++component) {
      if (!of.follows[component] || mass_along(nodes, of.dependent, static_cast<int>(component)) > 0)
        continue;
      double& force = component < 3 ? own.force[component] : own.moment[component - 3];
      impulse[component] = force;
      force = 0;
    }
    fit(nodes, 0, of, of.now);
    for (std::size_t i = 0; i < of.independent.size(); ++i) {
      const Motion part = share(of.now, of, i, impulse);
      domain::NodeForce& force = nodes.force[of.independent[i].node];
      for (int axis = 0; axis < 3; ++axis) {
        force.force[axis] += part.along[axis];
        force.moment[axis] += part.about[axis];
      }
    }
  }
}

/// What unit impulses on the dependent node, and their opposites on the others, change of the velocity by
/// which it does not fit.
Interpolations::Matrix Interpolations::response(const NodeFields& nodes, const Interpolation& of,
                                                const Rows& rows) {
  Matrix matrix{};
  for (std::size_t column = 0; column < rows.count; ++column) {
    Motion unit;
    unit[rows.component[column]] = 1;
    Motion change;
    Vec3 turning;
    for (std::size_t i = 0; i < of.independent.size(); ++i) {
      const Independent& each = of.independent[i];
      const Motion part = share(of.now, of, i, unit);
      const Vec3 v = kicked(nodes, each.node, 0, part.along);
      change.along += each.weight * v;
      turning +=
          each.weight * cross(of.middle.arm[i], v) + each.turning * kicked(nodes, each.node, 3, part.about);
    }
    change.about = of.middle.inverse * turning;
    change.along += cross(change.about, of.middle.dependent);
    for (std::size_t row = 0; row < rows.count; ++row) matrix[row][column] = change[rows.component[row]];
    matrix[column][column] +=
        inverse_mass_along(nodes, of.dependent, static_cast<int>(rows.component[column]));
  }
  return matrix;
}

/// Lets one fit; returns the largest velocity by which it did not [length/time].
double Interpolations::correct(NodeFields& nodes, const Interpolation& of) {
  Rows rows;
  std::array<double, 6> gap{};
  double largest = 0;
  double reach = norm(of.now.dependent);  // by which a spin counts as a velocity [length]
  for (const Vec3& arm : of.now.arm) reach = std::max(reach, norm(arm));
  Motion wanted = fitted(nodes, of);
  Motion own{nodes.velocity[of.dependent], nodes.angular_velocity[of.dependent]};
  for (std::size_t component = 0; component < 6; ++component) {
    if (!of.follows[component] || !(mass_along(nodes, of.dependent, static_cast<int>(component)) > 0))
      continue;
    gap[rows.count] = wanted[component] - own[component];
    largest = std::max(largest, (component < 3 ? 1 : reach) * std::fabs(gap[rows.count]));
    rows.component[rows.count++] = component;
  }
  Matrix matrix = response(nodes, of, rows);
  eliminate(matrix, gap, rows.count);
  Motion impulse;
  for (std::size_t row = 0; row < rows.count; ++row) impulse[rows.component[row]] = gap[row];
  for (std::size_t i = 0; i < of.independent.size(); ++i) {
    const Motion part = share(of.now, of, i, impulse);
    const Index node = of.independent[i].node;
    nodes.velocity[node] -= kicked(nodes, node, 0, part.along);
    nodes.angular_velocity[node] -= kicked(nodes, node, 3, part.about);
  }
  nodes.velocity[of.dependent] += kicked(nodes, of.dependent, 0, impulse.along);
  nodes.angular_velocity[of.dependent] += kicked(nodes, of.dependent, 3, impulse.about);
  // What has no mass takes any velocity.
  wanted = fitted(nodes, of);
  for (std::size_t component = 0; component < 6; ++component)
    if (of.follows[component] && !(mass_along(nodes, of.dependent, static_cast<int>(component)) > 0))
      (component < 3 ? nodes.velocity
                     : nodes.angular_velocity)[of.dependent][static_cast<int>(component % 3)] =
          wanted[component];
  return largest;
}

KineticChange Interpolations::constrain(Domain& domain, double next_step) {
  NodeFields& nodes = domain.nodes;
  const auto rotational = [&] {
    double sum = 0;
    for (const Spin& spin : spins_)
      sum += 0.5 * nodes.moving_inertia(spin.node) * dot(spin.before, nodes.angular_velocity[spin.node]);
    return sum;
  };
  const double before = rotational();
  for (Interpolation& of : all_) {
    fit(nodes, 0, of, of.now);
    fit(nodes, 0.5 * next_step, of, of.middle);
  }
  constexpr int most_rounds = 200;
  constexpr double enough = 1e-14;
  double first = 0;
  for (int round = 0; round < (share_nodes_ ? most_rounds : 1); ++round) {
    double largest = 0;
    for (const Interpolation& of : all_) largest = std::max(largest, correct(nodes, of));
    if (round == 0) first = largest;
    if (largest <= enough * first) break;
  }
  KineticChange change;
  change.rotational = rotational() - before;
  return change;
}

}  // namespace crumple::constraints
