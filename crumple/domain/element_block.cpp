// SPDX-License-Identifier: BSD-3-Clause
#include "domain/element_block.hpp"

namespace crumple::domain {

const StateItem* ElementBlock::find(const std::string& name) const {
  for (const StateItem& item : items)
    if (item.name == name) return &item;
  return nullptr;
}

void ElementBlock::allocate(Precision precision) {
  const std::size_t numbers = static_cast<std::size_t>(groups()) * components * lanes;
  if (precision == Precision::Mixed)
    float_state.assign(numbers, 0.0F);
  else
    double_state.assign(numbers, 0.0);
  energy.assign(static_cast<std::size_t>(groups()), {});
}

Index add_item(ElementBlock& block, const std::string& name, const std::string& unit, Index count) {
  const Index first = block.components;
  block.items.push_back({name, unit, first, count});
  block.components += count;
  return first;
}

}  // namespace crumple::domain
