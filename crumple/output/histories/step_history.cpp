// SPDX-License-Identifier: BSD-3-Clause
#include <string_view>

#include "output/histories/history.hpp"

namespace crumple::output {

namespace {

class StepHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    const domain::ControllingElement controlling = view.controlling();
    // One word: "discrete" for a discrete element.
    const std::string_view kind = controlling.kind;
    table.add_row(view.domain.clock.time, view.next_step, kind.substr(0, kind.find(' ')), controlling.element,
                  controlling.part);
  }
};

}  // namespace

std::unique_ptr<History> make_step_history() {
  return std::make_unique<StepHistory>();
}

}  // namespace crumple::output
