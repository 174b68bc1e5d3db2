// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

constexpr Variable airbag_variables[] = {
    {"volume", "volume"},        {"pressure", "pressure"}, {"energy", "internal_energy"},
    {"inflow", "dm_dt_in"},      {"outflow", "dm_dt_out"}, {"mass", "total_mass"},
    {"temperature", "gas_temp"}, {"area", "surface_area"}, {"", "density"},
};

void print_airbags(const HistoryItems& items, const Sample& sample, std::string& text) {
  for (std::size_t i = 0; i < items.ids.size(); ++i) {
    const auto end = std::back_inserter(text);
    fmt::format_to(end, "{:12.5E}{:10}", sample.time(), items.ids[i]);
    for (std::size_t variable = 0; variable < std::size(airbag_variables); ++variable)
      fmt::format_to(end, "{:12.4E}", sample.of(variable)[i]);
    text += '\n';
  }
}

constexpr HistoryForm abstat_form{
    model::HistoryFile::Abstat, "abstat", "abstat",
    "\n\n    time      airbag    volume    pressure     energy     dm/dt in    dm/dt out     mass     "
    "temperature     area      density\n",
    print_airbags};

class AirbagHistory : public SampledHistory {
 public:
  AirbagHistory() : SampledHistory(abstat_form, airbag_variables) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    for (const model::ControlVolume& volume : view.model.control_volumes) {
      items.ids.push_back(volume.id);
      items.titles.push_back(volume.title);
    }
    return items;
  }

  void take(const View& view, Sample& sample) override {
    for (const domain::ControlVolumeReport& volume : view.domain.control_volumes)
      sample.add_item({volume.volume, volume.pressure, volume.energy, volume.inflow, volume.outflow,
                       volume.mass, volume.temperature, volume.area, volume.mass / volume.volume});
  }
};

}  // namespace

std::unique_ptr<History> make_airbag_history() {
  return std::make_unique<AirbagHistory>();
}

}  // namespace crumple::output
