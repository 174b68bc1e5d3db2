// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/element_block.hpp"
#include "model/output_requests.hpp"

namespace crumple::output {

/// How many numbers of which kind a d3plot state holds per element (*DATABASE_EXTENT_BINARY).
struct D3plotLayout {
  static constexpr int surfaces = 3;  ///< the layers of MAXINT = 3: middle, inner and outer surface
  static constexpr int beam_values = 6;

  int solid_history = 0;  ///< further variables of solids
  int shell_history = 0;  ///< of shells, in each layer
  int layers = surfaces;  ///< another number than 3: the first points through the thickness
  bool stresses = true;   ///< of shells; solids have them always
  bool plastic_strain = true;
  bool resultants = true;
  bool energy = true;  ///< thickness, two spare numbers and the energy of shells

  D3plotLayout() = default;
  explicit D3plotLayout(const model::StateExtent& extent);

  int layer_values() const { return 6 * (stresses ? 1 : 0) + (plastic_strain ? 1 : 0) + shell_history; }
  int shell_values() const {
    return layers * layer_values() + 8 * (resultants ? 1 : 0) + 4 * (energy ? 1 : 0);
  }
  int solid_values() const { return 7 + solid_history; }
};

/// The variables that a material keeps at every point besides stress and plastic strain, in the order of the
/// state: back stresses, damage, rise of temperature and the like. The block must outlive this.
class PointHistory {
 public:
  explicit PointHistory(const domain::ElementBlock& block);

  int count() const { return static_cast<int>(components_.size()); }
  /// One of them at a point; zero if there are fewer.
  double value(Index place, Index point, int variable) const;

 private:
  void add(const domain::StateItem& item);

  const domain::ElementBlock* block_;
  std::vector<std::vector<Index>> components_;  ///< [variable][point] in the state; no_index: it has none
  std::size_t next_ = 0;                        ///< variable, while they are being found
  Index last_layer_ = no_index;                 ///< of the item before
};

}  // namespace crumple::output
