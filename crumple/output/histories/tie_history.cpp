// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/history.hpp"

namespace crumple::output {

namespace {

class TieHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    for (const domain::Tie& tie : view.domain.ties)
      table.add_row(view.domain.clock.time, tie.id, static_cast<Index>(tie.nodes.size()) - tie.released,
                    tie.broken, tie.force.x, tie.force.y, tie.force.z, tie.energy);
  }
};

}  // namespace

std::unique_ptr<History> make_tie_history() {
  return std::make_unique<TieHistory>();
}

}  // namespace crumple::output
