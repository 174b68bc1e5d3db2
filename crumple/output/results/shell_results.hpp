// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "base/index.hpp"
#include "domain/shell_block.hpp"
#include "model/model.hpp"

namespace crumple::output {

/// What output shows of the shells of one block, found by name in the block's state. Stress and plastic
/// strain that a block does not keep are zero; thickness then is the model's. Model and block must outlive
/// this.
class ShellResults {
 public:
  /// Stress components per point: xx, yy, xy, yz, zx.
  static constexpr Index stress_components = 5;
  using Stress = std::array<double, stress_components>;

  ShellResults(const model::Model& model, const domain::ShellBlock& block);

  /// Largest effective plastic strain of all points, in plane and through the thickness [-].
  double plastic_strain(Index place) const;
  /// Largest von Mises stress of all points [stress].
  double von_mises(Index place) const;
  /// Von Mises stress of the mean components at the middle of the thickness: over the points in plane, and
  /// over the two next to the middle if their number is even. Without bending while elastic [stress].
  double mid_von_mises(Index place) const;
  /// Mean thickness now [length].
  double thickness(Index place) const;
  /// False once the element has failed.
  bool alive(Index place) const;

 private:
  void add_stress(Index place, Index point, double share, Stress& sum) const;

  const model::Model* model_;
  const domain::ShellBlock* block_;
  const domain::StateItem* stress_;
  std::vector<const domain::StateItem*> plastic_strains_;  ///< one, or of each run of layers that has it
  const domain::StateItem* thickness_;
  const domain::StateItem* active_;
};

}  // namespace crumple::output
