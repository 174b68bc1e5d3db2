// SPDX-License-Identifier: BSD-3-Clause
// Output requests.
#include "deck/build/build.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

namespace crumple::deck {

namespace {

/// What *DATABASE_HISTORY may name: the items of a kind, and sets of them.
struct Traced {
  Item item;
  Item set;
  std::vector<Index>* into;
};

Traced traced_of(HistoryItem item, model::OutputRequests& output) {
  switch (item) {
    case HistoryItem::Shell:
      return {Item::Shell, Item::ShellSet, &output.history_shells};
    case HistoryItem::Solid:
      return {Item::Solid, Item::SolidSet, &output.history_solids};
    case HistoryItem::Beam:
      return {Item::Beam, Item::BeamSet, &output.history_beams};
    case HistoryItem::Discrete:
      return {Item::Discrete, Item::DiscreteSet, &output.history_discretes};
    default:
      return {Item::Node, Item::NodeSet, &output.history_nodes};
  }
}

const std::vector<Index>& members_of(const Build& build, Item set, Index index) {
  const auto place = static_cast<std::size_t>(index);
  switch (set) {
    case Item::ShellSet:
      return build.model.shell_sets[place].shells;
    case Item::SolidSet:
      return build.solid_sets[place];
    case Item::BeamSet:
      return build.beam_sets[place];
    case Item::DiscreteSet:
      return build.discrete_sets[place];
    default:
      return build.model.node_sets[place].nodes;
  }
}

/// Lists what is named in the order of the deck, each once.
class HistoryList {
 public:
  explicit HistoryList(std::vector<Index>& list) : list_(&list) {}

  void add(Index index) {
    const auto place = static_cast<std::size_t>(index);
    if (place >= taken_.size()) taken_.resize(place + 1, 0);
    if (taken_[place] == 0) list_->push_back(index);
    taken_[place] = 1;
  }

 private:
  std::vector<Index>* list_;
  std::vector<char> taken_;
};

void build_histories(Build& build, HistoryItem item) {
  const Traced traced = traced_of(item, build.model.output);
  HistoryList list(*traced.into);
  for (const RawHistory& raw : build.deck.histories) {
    if (raw.item != item) continue;
    const Index index = build.find(raw.is_set ? traced.set : traced.item, {raw.id, "ID", raw.where});
    if (index == no_index) continue;
    if (!raw.is_set)
      list.add(index);
    else
      for (const Index member : members_of(build, traced.set, index)) list.add(member);
  }
}

/// The axes in which the motion of nodes is written; absent, with a message, if there are none.
std::optional<model::NodeAxes> axes_of(const RawHistory& raw, Build& build) {
  const auto axes = find_axes(build, raw.system, "CID", raw.where);
  if (!axes) return std::nullopt;
  model::NodeAxes found;
  found.axes = *axes;
  if (!raw.moving) return found;
  const auto index = static_cast<std::size_t>(build.find_quietly(Item::CoordinateSystem, raw.system));
  const RawCoordinateSystem& system = build.deck.coordinate_systems[index];
  if (system.node[0] == 0) {
    build.report.field_error(raw.where, {"REF", "1", "0, or a system of *DEFINE_COORDINATE_NODES",
                                         "axes move with nodes only", "axes"});
    return std::nullopt;
  }
  for (std::size_t k = 0; k < 3; ++k) found.moving[k] = build.find_quietly(Item::Node, system.node[k]);
  return found;
}

/// What is named in global axes, too, is written in those of the last keyword that names it with axes.
void build_history_axes(Build& build) {
  std::map<Index, model::NodeAxes> by_node;
  for (const RawHistory& raw : build.deck.histories) {
    if (raw.item != HistoryItem::Node || raw.system == 0) continue;
    const Index index = build.find_quietly(raw.is_set ? Item::NodeSet : Item::Node, raw.id);
    if (index == no_index) continue;  // which has been said
    const auto axes = axes_of(raw, build);
    if (!axes) continue;
    const std::vector<Index> one = {index};
    for (const Index node : raw.is_set ? members_of(build, Item::NodeSet, index) : one) {
      model::NodeAxes& own = by_node[node] = *axes;
      own.node = node;
    }
  }
  for (const auto& [node, axes] : by_node) build.model.output.history_axes.push_back(axes);
}

/// Several keywords add up, as several part sets would.
void build_springback(Build& build) {
  model::SpringbackRequest& request = build.model.output.springback;
  for (const RawSpringback& raw : build.deck.springbacks) {
    const std::vector<Index> parts = find_parts(build, true, {raw.parts, "PSID", raw.where});
    request.parts.insert(request.parts.end(), parts.begin(), parts.end());
    for (const RawSpringback::Hold& hold : raw.holds) {
      const Index node = build.find(Item::Node, {hold.node, "NID", hold.where});
      if (node != no_index) request.holds.push_back({node, hold.translation, hold.rotation});
    }
  }
  std::sort(request.parts.begin(), request.parts.end());
  request.parts.erase(std::unique(request.parts.begin(), request.parts.end()), request.parts.end());
}

}  // namespace

void build_output(Build& build) {
  model::OutputRequests& output = build.model.output;
  if (build.deck.state_count > 0)
    output.state_interval = build.model.control.end_time / static_cast<double>(build.deck.state_count);
  for (const HistoryItem item :
       {HistoryItem::Node, HistoryItem::Shell, HistoryItem::Solid, HistoryItem::Beam, HistoryItem::Discrete})
    build_histories(build, item);
  build_history_axes(build);
  build_springback(build);
}

}  // namespace crumple::deck
