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
  /// Mean pressure of all points, positive in compression; zz is zero [stress].
  double pressure(Index place) const;
  /// Points through the thickness.
  Index layers() const;
  /// Mean components of a layer over the points in plane, along the axes of the element [stress].
  Stress stress(Index place, Index layer) const;
  /// The same of the effective plastic strain [-].
  double plastic_strain(Index place, Index layer) const;
  /// A place through the thickness: the lowest point, the middle (both points next to it, if their number is
  /// even), the highest point.
  enum class Surface { Inner, Middle, Outer };
  Stress stress(Index place, Surface surface) const;
  double plastic_strain(Index place, Surface surface) const;
  /// Von Mises stress of the mean components at the middle. Without bending while elastic [stress].
  double mid_von_mises(Index place) const { return von_mises_of(stress(place, Surface::Middle)); }
  /// Mean thickness now [length].
  double thickness(Index place) const;
  /// Of the mean thickness over that at the start, less one [-].
  double thickness_change(Index place) const;
  /// False once the element has failed.
  bool alive(Index place) const;

 private:
  static double von_mises_of(const Stress& stress);
  std::array<Index, 2> layers_at(Surface surface) const;
  double first_thickness(Index place) const;
  void add_stress(Index place, Index point, double share, Stress& sum) const;

  const model::Model* model_;
  const domain::ShellBlock* block_;
  const domain::StateItem* stress_;
  std::vector<const domain::StateItem*> plastic_strains_;  ///< one, or of each run of layers that has it
  const domain::StateItem* thickness_;
  const domain::StateItem* active_;
};

}  // namespace crumple::output
