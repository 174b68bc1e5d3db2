// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/history.hpp"

namespace crumple::output {

namespace {

class ResidualHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    const domain::EnergyTraceReport report = view.energy_trace();
    double rest = view.domain.energy.imbalance();
    for (const domain::EnergyResidual& part : report.parts) rest -= part.residual;
    for (const auto* list : {&report.parts, &report.contacts})
      for (const domain::EnergyResidual& entry : *list)
        table.add_row(view.domain.clock.time, entry.kind, entry.id, entry.energy, entry.residual);
    table.add_row(view.domain.clock.time, "rest", 0, view.domain.energy.total(), rest);
  }
};

}  // namespace

std::unique_ptr<History> make_residual_history() {
  return std::make_unique<ResidualHistory>();
}

}  // namespace crumple::output
