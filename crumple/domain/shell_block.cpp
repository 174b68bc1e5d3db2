// SPDX-License-Identifier: BSD-3-Clause
#include "domain/shell_block.hpp"

namespace crumple::domain {

std::array<Index, 4> ShellBlock::nodes_of(Index place) const {
  return {node_of(place, 0), node_of(place, 1), node_of(place, 2), node_of(place, 3)};
}

}  // namespace crumple::domain
