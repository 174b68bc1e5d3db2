// SPDX-License-Identifier: BSD-3-Clause
#include "output/history.hpp"

namespace crumple::output {

namespace {

class SupportHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    const double time = view.domain.clock.time;
    math::Vec3 force;
    math::Vec3 moment;
    for (const domain::SupportReport& support : view.domain.supports) {
      add(table, time, view.model.nodes.id[view.domain.nodes.model_node[support.node]], support.force,
          support.moment);
      force += support.force;
      moment += support.moment;
    }
    add(table, time, 0, force, moment);
  }

 private:
  static void add(CsvFile& table, double time, UserId node, const math::Vec3& force,
                  const math::Vec3& moment) {
    table.add_row(time, node, force.x, force.y, force.z, moment.x, moment.y, moment.z);
  }
};

}  // namespace

std::unique_ptr<History> make_support_history() {
  return std::make_unique<SupportHistory>();
}

}  // namespace crumple::output
