// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "output/d3plot/d3plot_words.hpp"
#include "output/results/block_places.hpp"
#include "output/results/part_masses.hpp"
#include "output/results/view.hpp"

namespace crumple::output {

/// The states of a d3plot family, one after the other.
class D3plotState {
 public:
  explicit D3plotState(const View& view);

  /// The present state: time, energies and motions of the model and its parts, rigid walls, nodes, elements,
  /// deletion table. Forces on walls are the mean since the state before.
  D3plotWords words(const View& view);

  /// Declares what is remembered of the state before, for a restart.
  void declare(domain::StateList& list);

 private:
  void add_globals(D3plotWords& words, const View& view);
  void add_walls(D3plotWords& words, const View& view);
  void add_solids(D3plotWords& words, const View& view);
  void add_lines(D3plotWords& words, const View& view);
  void add_shells(D3plotWords& words, const View& view);

  PartMasses masses_;
  BlockPlaces shell_place_;
  BlockPlaces solid_place_;
  BlockPlaces beam_place_;
  BlockPlaces discrete_place_;
  std::vector<char> solid_alive_;  ///< in the state at hand, in the order of the file
  std::vector<char> shell_alive_;
  std::vector<char> line_alive_;
  double time_ = 0;                          ///< of the state before [time]
  std::vector<double> wall_normal_impulse_;  ///< up to then [force * time]
};

}  // namespace crumple::output
