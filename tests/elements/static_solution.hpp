// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Small static problems, solved with the stiffness that the kernels themselves show when one degree of
// freedom moves at a time.

#include "shell_harness.hpp"

namespace crumple::elements::testing {

/// Row by row from the first entry that is not zero to the diagonal.
struct Envelope {
  std::vector<Index> first;
  std::vector<std::vector<double>> row;
};

/// Solves K x = b by Cholesky's factors; K is overwritten.
inline std::vector<double> solved(Envelope& k, std::vector<double> b) {
  const auto count = static_cast<Index>(b.size());
  for (Index i = 0; i < count; ++i) {
    for (Index j = k.first[i]; j <= i; ++j) {
      const Index from = std::max(k.first[i], k.first[j]);
      double sum = k.row[i][j - k.first[i]];
      for (Index m = from; m < j; ++m) sum -= k.row[i][m - k.first[i]] * k.row[j][m - k.first[j]];
      k.row[i][j - k.first[i]] = i == j ? std::sqrt(sum) : sum / k.row[j][j - k.first[j]];
    }
    for (Index m = k.first[i]; m < i; ++m) b[i] -= k.row[i][m - k.first[i]] * b[m];
    b[i] /= k.row[i].back();
  }
  for (Index i = count; i-- > 0;) {
    b[i] /= k.row[i].back();
    for (Index m = k.first[i]; m < i; ++m) b[m] -= k.row[i][m - k.first[i]] * b[i];
  }
  return b;
}

/// Degrees of freedom (six per model node) that the model does not hold and that have stiffness.
inline std::vector<Index> free_degrees(const model::Model& model) {
  std::vector<bool> held(6 * model.nodes.position.size(), false);
  for (const model::FixedNode& fixed : model.fixed_nodes)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t at = 6 * static_cast<std::size_t>(fixed.node) + axis;
      if (fixed.translation[axis]) held[at] = true;
      if (fixed.rotation[axis]) held[at + 3] = true;
    }
  std::vector<Index> free;
  for (std::size_t at = 0; at < held.size(); ++at)
    if (!held[at]) free.push_back(static_cast<Index>(at));
  return free;
}

/// Displacement of every model node, and rotation, [6 * node + axis], under the model's loads: linear. The
/// stiffness is the mean of a motion to both sides, so that what is quadratic in it cancels.
inline std::vector<double> static_solution(const model::Model& model, double size) {
  const std::vector<Index> free = free_degrees(model);
  const domain::Execution execution{Precision::Double, available_isas().back(), 1};
  const auto forces_after = [&](Index degree, double motion) {
    Driven body(model, execution);
    const domain::NodeFields& nodes = body.domain.nodes;
    std::vector<Vec3> u(nodes.count());
    std::vector<Vec3> r(nodes.count());
    (degree % 6 < 3 ? u : r)[nodes.domain_node[degree / 6]][degree % 3] = motion;
    body.step(1, u, r);
    std::vector<double> forces;
    for (const Index at : free) {
      const Index node = nodes.domain_node[at / 6];
      forces.push_back(-(at % 6 < 3 ? body.force(node)[at % 3] : body.moment(node)[at % 3]));
    }
    return forces;
  };
  Envelope k;
  for (std::size_t j = 0; j < free.size(); ++j) {
    const std::vector<double> plus = forces_after(free[j], size);
    const std::vector<double> minus = forces_after(free[j], -size);
    std::size_t first = 0;
    while (first < j && plus[first] == minus[first]) ++first;
    k.first.push_back(static_cast<Index>(first));
    k.row.emplace_back();
    for (std::size_t i = first; i <= j; ++i) k.row.back().push_back((plus[i] - minus[i]) / (2 * size));
  }
  std::vector<double> load(free.size());
  for (const model::NodalLoad& force : model.nodal_loads)
    for (std::size_t i = 0; i < free.size(); ++i)
      if (free[i] / 6 == force.node) {
        const auto axis = static_cast<std::size_t>(free[i] % 3);
        load[i] += free[i] % 6 < 3 ? force.force[axis] : force.moment[axis];
      }
  const std::vector<double> x = solved(k, load);
  std::vector<double> all(6 * model.nodes.position.size());
  for (std::size_t i = 0; i < free.size(); ++i) all[static_cast<std::size_t>(free[i])] = x[i];
  return all;
}

/// Displacement of the first loaded node along its load.
inline double under_first_load(const model::Model& model, const std::vector<double>& solution) {
  const model::NodalLoad& load = model.nodal_loads.front();
  double sum = 0;
  double square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum += load.force[axis] * solution[6 * static_cast<std::size_t>(load.node) + axis];
    square += load.force[axis] * load.force[axis];
  }
  return sum / std::sqrt(square);
}

}  // namespace crumple::elements::testing
