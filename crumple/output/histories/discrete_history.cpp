// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>

#include "output/histories/sampled_history.hpp"
#include "output/results/block_places.hpp"

namespace crumple::output {

namespace {

using domain::DiscreteBlock;

constexpr Variable discrete_variables[] = {{"resultant", "resultant_force"},
                                           {"fx", "x_force"},
                                           {"fy", "y_force"},
                                           {"fz", "z_force"},
                                           {"displacement", "displacement"}};

void print_springs(const HistoryItems& items, const Sample& sample, std::string& text) {
  const auto end = std::back_inserter(text);
  fmt::format_to(end, "\n time.........................{:14.5E}\n", sample.time());
  const auto& torsional = items.marks[0].second;
  for (std::size_t i = 0; i < items.ids.size(); ++i) {
    const char* const force = torsional[i] != 0 ? "moment" : "force";
    fmt::format_to(end, " spring/damper number.........{:10}\n", items.ids[i]);
    const auto line = [&](const std::string& words, std::string_view name) {
      fmt::format_to(end, " {:.<29}{:14.5E}\n", words, sample.of(name)[i]);
    };
    line(fmt::format("x-{}", force), "x_force");
    line(fmt::format("y-{}", force), "y_force");
    line(fmt::format("z-{}", force), "z_force");
    line(fmt::format("resultant {}", force), "resultant_force");
    line(torsional[i] != 0 ? "relative rotation" : "change in length", "displacement");
  }
}

constexpr HistoryForm deforc_form{model::HistoryFile::Deforc, "deforc", "deforc", "", print_springs};

/// Unit vector from the first end to the second: fixed in space, or along the line between the nodes.
math::Vec3 axis_of(const DiscreteBlock& block, Index place, const domain::NodeFields& nodes) {
  const Index item = block.find("axis")->first;
  const math::Vec3 given{block.state(place, item), block.state(place, item + 1),
                         block.state(place, item + 2)};
  if (dot(given, given) > 0) return given;
  const auto [first, second] = block.nodes_of(place);
  return normalised(nodes.position[second] - nodes.position[first]);
}

class DiscreteHistory : public SampledHistory {
 public:
  explicit DiscreteHistory(const View& view)
      : SampledHistory(deforc_form, discrete_variables),
        elements_(view.model.output.history_discretes),
        places_(block_places(view.domain.discretes, view.model.discretes.size())) {
    if (!elements_.empty()) return;
    elements_.resize(view.model.discretes.size());
    std::iota(elements_.begin(), elements_.end(), 0);
  }

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    items.marks.push_back({"irot", {}});
    for (const Index element : elements_) {
      items.ids.push_back(view.model.discretes[element].id);
      items.marks[0].second.push_back(view.domain.discretes[places_[element].first].torsional ? 1 : 0);
    }
    return items;
  }

  void take(const View& view, Sample& sample) override {
    for (const Index element : elements_) {
      const auto [block_index, place] = places_[element];
      const DiscreteBlock& block = view.domain.discretes[block_index];
      const double resultant = block.state(place, block.find("force")->first);
      const math::Vec3 force = resultant * axis_of(block, place, view.domain.nodes);
      sample.add_item(
          {resultant, force.x, force.y, force.z, block.state(place, block.find("deformation")->first)});
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
