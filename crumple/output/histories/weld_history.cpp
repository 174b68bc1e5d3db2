// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "output/histories/sampled_history.hpp"
#include "output/results/line_results.hpp"

namespace crumple::output {

namespace {

constexpr Variable weld_variables[] = {
    {"axial", "axial"}, {"shear", "shear"}, {"broken", "failure_flag", true}, {"", "failure_time"}};

/// LS-DYNA's numbers for the types of welds.
constexpr std::int64_t constraint_type = 0;
constexpr std::int64_t weld_beam_type = 2;

bool is_of_welds(const domain::BeamBlock& block) {
  return block.formulation == model::BeamFormulation::SpotWeld;
}

void print_welds(const HistoryItems& items, const Sample& sample, std::string& text) {
  fmt::format_to(std::back_inserter(text),
                 "\n constraint #      axial        shear         time{:48}length\n", "");
  for (std::size_t i = 0; i < items.ids.size(); ++i)
    fmt::format_to(std::back_inserter(text), "      {:5}{:13.5E}{:13.5E}{:13.5E}  {:<7}    {:<15}  ID {:8}\n",
                   i + 1, sample.of("axial")[i], sample.of("shear")[i], sample.time(),
                   sample.of("failure_flag")[i] != 0 ? "failure" : "",
                   items.marks.front().second[i] == weld_beam_type ? "beam" : "constraint/weld",
                   items.ids[i]);
}

constexpr HistoryForm swforc_form{model::HistoryFile::Swforc, "swforc", "swforc", "", print_welds};

class WeldHistory : public SampledHistory {
 public:
  WeldHistory() : SampledHistory(swforc_form, weld_variables) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    for (const domain::WeldReport& weld : view.domain.welds) items.ids.push_back(weld.id);
    std::vector<std::int64_t> types(items.ids.size(), constraint_type);
    for (const domain::BeamBlock& block : view.domain.beams)
      for (Index place = 0; is_of_welds(block) && place < block.elements; ++place) {
        items.ids.push_back(view.model.beams[block.element[place]].id);
        types.push_back(weld_beam_type);
      }
    items.marks.push_back({"types", std::move(types)});
    return items;
  }

  void take(const View& view, Sample& sample) override {
    for (const domain::WeldReport& weld : view.domain.welds)
      sample.add_item({weld.axial, weld.shear, weld.broken ? 1.0 : 0.0, weld.failure_time});
    for (const domain::BeamBlock& block : view.domain.beams) {
      if (!is_of_welds(block)) continue;
      const LineResults results(view.model, block);
      const domain::StateItem* const failure = block.find("failure_time");
      for (Index place = 0; place < block.elements; ++place)
        sample.add_item({results.resultant(place, Resultant::AxialForce),
                         std::hypot(results.resultant(place, Resultant::ShearS),
                                    results.resultant(place, Resultant::ShearT)),
                         results.alive(place) ? 0.0 : 1.0, block.state(place, failure->first)});
    }
  }
};

}  // namespace

std::unique_ptr<History> make_weld_history() {
  return std::make_unique<WeldHistory>();
}

}  // namespace crumple::output
