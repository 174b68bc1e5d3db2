// SPDX-License-Identifier: BSD-3-Clause
#include "domain/shell_block.hpp"

namespace crumple::domain {

const StateItem* ShellBlock::find(const std::string& name) const {
  for (const StateItem& item : items)
    if (item.name == name) return &item;
  return nullptr;
}

std::array<Index, 4> ShellBlock::nodes_of(Index place) const {
  std::array<Index, 4> found{};
  const std::size_t group = static_cast<std::size_t>(place / lanes) * 4 * lanes;
  for (std::size_t k = 0; k < 4; ++k) found[k] = node[group + k * lanes + place % lanes];
  return found;
}

Index add_item(ShellBlock& block, const std::string& name, const std::string& unit, Index count) {
  const Index first = block.components;
  block.items.push_back({name, unit, first, count});
  block.components += count;
  return first;
}

}  // namespace crumple::domain
