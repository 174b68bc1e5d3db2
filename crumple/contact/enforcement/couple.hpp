// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>

#include "contact/enforcement/touch.hpp"
#include "math/vec3.hpp"

namespace crumple::contact {

/// How a couple is shared out to some nodes: by forces a x r, r from their mean or from that of the half of
/// them that a node belongs to, which have no sum. Of all such forces with that moment they are the smallest
/// in the sum of their squares.
class Couple {
 public:
  using Forces = std::array<Vec3, Touch::most_nodes>;

  /// What has no resultant force of its own: all nodes together, or the first half and the second.
  enum class Bearing { All, EachHalf };

  /// `nodes` are their positions, most_nodes of them at most [length].
  explicit Couple(std::span<const Vec3> nodes, Bearing bearing = Bearing::All);

  /// Forces on the nodes whose moment is `moment` [force * length]; zero where the nodes lie on a line, which
  /// bears none about itself, or the halves on parallel lines.
  Forces forces(const Vec3& moment) const;

  /// Bound on the sum of their squares for the moment of any unit force with the arm `arm` [1].
  double largest_square(const Vec3& arm) const;

 private:
  Vec3 turn(const Vec3& moment) const;

  Forces arm_{};
  /// Inverse of the sum of r.r 1 - r r over the nodes: xx, yy, zz, xy, yz, zx [1/length^2].
  std::array<double, 6> inverse_{};
};

}  // namespace crumple::contact
