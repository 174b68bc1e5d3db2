// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "output/d3plot/d3plot_layout.hpp"
#include "output/d3plot/d3plot_words.hpp"
#include "output/results/shell_axes.hpp"
#include "output/results/shell_results.hpp"
#include "output/results/view.hpp"

namespace crumple::output {

/// What a d3plot state holds of the shells of one block. Model, domain and block must outlive this.
class D3plotShells {
 public:
  D3plotShells(const View& view, const domain::ShellBlock& block);

  /// Adds the numbers of one shell, as far as the layout has them: for the middle, the inner and the outer
  /// point through the thickness, or for the first ones, each averaged over the points in plane, six stresses
  /// in global axes, the plastic strain and further variables; moments Mx, My,
  /// Mxy, shears Qx, Qy and forces Nx, Ny, Nxy per length, x along the side from the first to the second
  /// node; thickness, two zeros, and internal energy per volume at time zero if the material can fail, else
  /// zero.
  void add_shell(D3plotWords& words, Index place) const;
  bool alive(Index place) const { return results_.alive(place); }

 private:
  double history(Index place, Index layer, int variable) const;
  /// The mean of two layers, which may be the same.
  void add_layer(D3plotWords& words, const ShellAxes& axes, Index place, Index below, Index above) const;
  void add_resultants(D3plotWords& words, const ShellAxes& axes, Index place) const;
  math::Vec3 first_side(Index place) const;
  double energy_density(Index place) const;

  const View* view_;
  const domain::ShellBlock* block_;
  const model::ShellSection* section_;
  ShellResults results_;
  PointHistory history_;
  D3plotLayout layout_;
  const domain::StateItem* energy_;
};

}  // namespace crumple::output
