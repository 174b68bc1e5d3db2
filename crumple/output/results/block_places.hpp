// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "base/index.hpp"

namespace crumple::output {

/// Block and place in it of every element of a kind, in the order of the model.
using BlockPlaces = std::vector<std::pair<Index, Index>>;

/// Finds the `elements` elements of the model in the domain's blocks of their kind.
template <class Block>
BlockPlaces block_places(const std::vector<Block>& blocks, std::size_t elements) {
  BlockPlaces places(elements);
  for (Index b = 0; b < static_cast<Index>(blocks.size()); ++b)
    for (Index place = 0; place < blocks[b].elements; ++place) places[blocks[b].element[place]] = {b, place};
  return places;
}

}  // namespace crumple::output
