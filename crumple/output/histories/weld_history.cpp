// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

constexpr Variable variables[] = {
    {"axial", "axial"}, {"shear", "shear"}, {"broken", "failure_flag", true}, {"", "failure_time"}};

void print_welds(const HistoryItems& items, const Sample& sample, std::string& text) {
  fmt::format_to(std::back_inserter(text),
                 "\n constraint #      axial        shear         time{:48}length\n", "");
  for (std::size_t i = 0; i < items.ids.size(); ++i)
    fmt::format_to(std::back_inserter(text),
                   "      {:5}{:13.5E}{:13.5E}{:13.5E}  {:<7}    constraint/weld  ID {:8}\n", i + 1,
                   sample.of("axial")[i], sample.of("shear")[i], sample.time(),
                   sample.of("failure_flag")[i] != 0 ? "failure" : "", items.ids[i]);
}

constexpr HistoryForm swforc_form{model::HistoryFile::Swforc, "swforc", "swforc", "", print_welds};

class WeldHistory : public SampledHistory {
 public:
  WeldHistory() : SampledHistory(swforc_form, variables) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    for (const domain::WeldReport& weld : view.domain.welds) items.ids.push_back(weld.id);
    // All of one type: a constraint between two nodes.
    items.marks.push_back({"types", std::vector<std::int64_t>(items.ids.size(), 0)});
    return items;
  }

  void take(const View& view, Sample& sample) override {
    for (const domain::WeldReport& weld : view.domain.welds)
      sample.add_item({weld.axial, weld.shear, weld.broken ? 1.0 : 0.0, weld.failure_time});
  }
};

}  // namespace

std::unique_ptr<History> make_weld_history() {
  return std::make_unique<WeldHistory>();
}

}  // namespace crumple::output
