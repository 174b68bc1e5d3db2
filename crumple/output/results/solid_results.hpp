// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "domain/solid_block.hpp"

namespace crumple::output {

/// What output shows of the solids of one block, found by name in the block's state; zero what a block does
/// not keep. The block must outlive this.
class SolidResults {
 public:
  explicit SolidResults(const domain::SolidBlock& block);

  /// Largest effective plastic strain of all points [-].
  double plastic_strain(Index place) const;
  /// Largest von Mises stress of all points [stress].
  double von_mises(Index place) const;
  /// Von Mises stress of the mean components of all points [stress].
  double mean_von_mises(Index place) const;
  /// Mean pressure of all points, positive in compression [stress].
  double pressure(Index place) const;
  /// xx, yy, zz, xy, yz, zx.
  using Stress = std::array<double, 6>;
  /// Mean of all points in global axes [stress].
  Stress mean_stress(Index place) const;
  /// Mean effective plastic strain of all points [-].
  double mean_plastic_strain(Index place) const;
  /// False once the element has failed.
  bool alive(Index place) const;

 private:
  Stress stress(Index place, Index point) const;

  const domain::SolidBlock* block_;
  const domain::StateItem* stress_;
  const domain::StateItem* plastic_strain_;
  const domain::StateItem* active_;
};

}  // namespace crumple::output
