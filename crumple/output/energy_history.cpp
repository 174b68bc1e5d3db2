// SPDX-License-Identifier: BSD-3-Clause
#include "output/history.hpp"

namespace crumple::output {

namespace {

class EnergyHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    const domain::EnergyLedger& energy = view.domain.energy;
    table.add_row(view.domain.clock.time, view.next_step, energy.kinetic, energy.internal, energy.hourglass,
                  energy.contact, energy.friction, energy.rigidwall, energy.damping, energy.external_work,
                  energy.eroded, energy.total(), energy.ratio(), view.domain.added_mass);
  }
};

}  // namespace

std::unique_ptr<History> make_energy_history() {
  return std::make_unique<EnergyHistory>();
}

}  // namespace crumple::output
