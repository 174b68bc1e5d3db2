// SPDX-License-Identifier: BSD-3-Clause
#include "output/history.hpp"

namespace crumple::output {

namespace {

class WeldHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    for (const domain::WeldReport& weld : view.domain.welds)
      table.add_row(view.domain.clock.time, weld.id, weld.axial, weld.shear, weld.broken ? 1 : 0);
  }
};

}  // namespace

std::unique_ptr<History> make_weld_history() {
  return std::make_unique<WeldHistory>();
}

}  // namespace crumple::output
