// SPDX-License-Identifier: BSD-3-Clause
// Output requests.
#include <algorithm>

#include "deck/build.hpp"

namespace crumple::deck {

void build_output(Build& build) {
  model::OutputRequests& output = build.model.output;
  if (build.deck.state_count > 0)
    output.state_interval = build.model.control.end_time / static_cast<double>(build.deck.state_count);
  const auto add = [&](Index node) {
    if (std::find(output.history_nodes.begin(), output.history_nodes.end(), node) ==
        output.history_nodes.end())
      output.history_nodes.push_back(node);
  };
  for (const RawHistory& raw : build.deck.histories) {
    if (raw.item != HistoryItem::Node) continue;
    const Index index = build.find(raw.is_set ? Item::NodeSet : Item::Node, {raw.id, "ID", raw.where});
    if (index == no_index) continue;
    if (!raw.is_set)
      add(index);
    else
      for (const Index node : build.model.node_sets[static_cast<std::size_t>(index)].nodes) add(node);
  }
}

}  // namespace crumple::deck
