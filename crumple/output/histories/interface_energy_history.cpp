// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>

#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

constexpr Variable interface_energy_variables[] = {
    {"energy", ""},       {"friction", "friction_energy"},
    {"", "slave"},        {"", "master"},
    {"", "total_slave"},  {"", "total_master"},
    {"", "total_energy"},
};

void print_interface_energies(const HistoryItems& items, const Sample& sample, std::string& text) {
  const auto end = std::back_inserter(text);
  fmt::format_to(end,
                 "\n\n\n contact interface energy file, time={:14.7E}\n"
                 "    #            slave       master        cycle={:14}\n\n",
                 sample.time(), sample.cycle());
  const auto& single_sided = items.marks[0].second;
  std::size_t two_sided = 0;
  for (std::size_t i = 0; i < items.ids.size(); ++i) {
    fmt::format_to(end, "{:10}{:13.4E}", items.ids[i], sample.of("slave")[i]);
    if (single_sided[i] == 0) fmt::format_to(end, "{:13.4E}", sample.of("master")[two_sided++]);
    text += '\n';
  }
  const std::vector<double>& friction = sample.of("friction_energy");
  fmt::format_to(end,
                 "\n summary   total slave side={:14.7E}\n           total mastr side={:14.7E}\n"
                 "           total energy    ={:14.7E}\n           friction energy ={:14.7E}\n\n\n\n",
                 sample.of("total_slave")[0], sample.of("total_master")[0], sample.of("total_energy")[0],
                 std::accumulate(friction.begin(), friction.end(), 0.0));
}

constexpr HistoryForm sleout_form{model::HistoryFile::Sleout, "sleout", "sleout", "",
                                  print_interface_energies};

/// The energies of the contact interfaces and of the tied ones; together those of the whole model.
class InterfaceEnergyHistory : public SampledHistory {
 public:
  InterfaceEnergyHistory() : SampledHistory(sleout_form, interface_energy_variables) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    items.marks.push_back({"single_sided", {}});
    for (const domain::ContactReport& contact : view.domain.contacts) {
      items.ids.push_back(contact.id);
      items.marks[0].second.push_back(contact.two_sided ? 0 : 1);
    }
    for (const domain::Tie& tie : view.domain.ties) {
      items.ids.push_back(tie.id);
      items.marks[0].second.push_back(0);
    }
    return items;
  }

  void take(const View& view, Sample& sample) override {
    // An interface's energy is not split between its sides: LS-DYNA's first one has all of it.
    for (const domain::ContactReport& contact : view.domain.contacts) {
      sample.add_item({contact.energy, contact.friction_energy, contact.energy + contact.friction_energy});
      if (contact.two_sided) sample.of("master").push_back(0);
    }
    for (const domain::Tie& tie : view.domain.ties) {
      sample.add_item({tie.energy, 0, tie.energy});
      sample.of("master").push_back(0);
    }
  }

  void take_rest(const View&, Sample& sample) override {
    const std::vector<double>& energies = sample.of("slave");
    const double total = std::accumulate(energies.begin(), energies.end(), 0.0);
    sample.of("total_slave") = {total};
    sample.of("total_master") = {0};
    sample.of("total_energy") = {total};
  }
};

}  // namespace

std::unique_ptr<History> make_interface_energy_history() {
  return std::make_unique<InterfaceEnergyHistory>();
}

}  // namespace crumple::output
