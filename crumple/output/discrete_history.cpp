// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>

#include "output/block_places.hpp"
#include "output/history.hpp"

namespace crumple::output {

namespace {

using domain::DiscreteBlock;

/// Unit vector from the first end to the second: fixed in space, or along the line between the nodes.
math::Vec3 axis_of(const DiscreteBlock& block, Index place, const domain::NodeFields& nodes) {
  const Index item = block.find("axis")->first;
  const math::Vec3 given{block.state(place, item), block.state(place, item + 1),
                         block.state(place, item + 2)};
  if (dot(given, given) > 0) return given;
  const auto [first, second] = block.nodes_of(place);
  return normalised(nodes.position[second] - nodes.position[first]);
}

class DiscreteHistory : public History {
 public:
  explicit DiscreteHistory(const View& view)
      : elements_(view.model.output.history_discretes),
        places_(block_places(view.domain.discretes, view.model.discretes.size())) {
    if (!elements_.empty()) return;
    elements_.resize(view.model.discretes.size());
    std::iota(elements_.begin(), elements_.end(), 0);
  }

  void add_rows(const View& view, CsvFile& table) override {
    for (const Index element : elements_) {
      const auto [block_index, place] = places_[element];
      const DiscreteBlock& block = view.domain.discretes[block_index];
      const double resultant = block.state(place, block.find("force")->first);
      const math::Vec3 force = resultant * axis_of(block, place, view.domain.nodes);
      table.add_row(view.domain.clock.time, view.model.discretes[element].id, resultant, force.x, force.y,
                    force.z, block.state(place, block.find("deformation")->first));
    }
  }

 private:
  std::vector<Index> elements_;  ///< of the model: those that the deck names, or all
  BlockPlaces places_;
};

}  // namespace

std::unique_ptr<History> make_discrete_history(const View& view) {
  return std::make_unique<DiscreteHistory>(view);
}

}  // namespace crumple::output
