// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Round membranes made in code.

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "math/vec3.hpp"
#include "support/meshes.hpp"

namespace crumple::test {

/// Adds a disc of five blocks of n x n shells to `part`: a bulged square in the middle, and one between each
/// of its sides and the circle. Normals along z, or against it if `below`. height(r) is that of a point at
/// the distance r from the axis. Nodes within a millionth of the radius of one in `nodes` are the same, so
/// that discs of the same map are sewn together.
class DiscBuilder {
 public:
  DiscBuilder(model::Model& model, int n, double radius) : model_(model), n_(n), radius_(radius) {}

  void add(Index part, bool below, const std::function<double(double)>& height) {
    add_block(part, below, height, [&](double u, double v) { return inner(u, v); });
    for (int side = 0; side < 4; ++side)
      add_block(part, below, height, [&](double u, double v) {
        const double angle = 0.5 * std::numbers::pi * (side + u - 0.5);
        const math::Vec3 outer{radius_ * std::cos(angle), radius_ * std::sin(angle), 0};
        const math::Vec3 right = inner(1, u);
        const double c = std::round(std::cos(0.5 * std::numbers::pi * side));
        const double s = std::round(std::sin(0.5 * std::numbers::pi * side));
        const math::Vec3 from{c * right.x - s * right.y, s * right.x + c * right.y, 0};
        // From the circle inwards, so that the normal is that of the square.
        return v * from + (1 - v) * outer;
      });
  }

 private:
  /// The sides of the square are drawn out by a part of their distance to the circle.
  math::Vec3 inner(double u, double v) const {
    const double half = 0.4 * radius_;
    const double x = 2 * u - 1;
    const double y = 2 * v - 1;
    return {half * x * (1 + 0.15 * (1 - y * y)), half * y * (1 + 0.15 * (1 - x * x)), 0};
  }

  Index node_at(const math::Vec3& x) {
    const auto rounded = [&](double a) { return std::lround(a / radius_ * 1e6); };
    const std::array<long, 3> key{rounded(x.x), rounded(x.y), rounded(x.z)};
    const auto [found, is_new] = nodes_.try_emplace(key, model_.nodes.count());
    if (is_new) {
      model_.nodes.id.push_back(model_.nodes.count() + 1);
      model_.nodes.position.push_back({x.x, x.y, x.z});
    }
    return found->second;
  }

  template <class Place>
  void add_block(Index part, bool below, const std::function<double(double)>& height, const Place& place) {
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i < n_; ++i) {
        const auto at = [&](int di, int dj) {
          math::Vec3 x = place(static_cast<double>(i + di) / n_, static_cast<double>(j + dj) / n_);
          x.z = height(std::hypot(x.x, x.y));
          return node_at(x);
        };
        std::array<Index, 4> node{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
        if (below) node = {node[0], node[3], node[2], node[1]};
        model_.shells.push_back(
            {.id = static_cast<UserId>(model_.shells.size()) + 1, .part = part, .node = node});
      }
  }

  model::Model& model_;
  int n_;
  double radius_;
  std::map<std::array<long, 3>, Index> nodes_;
};

}  // namespace crumple::test
