// SPDX-License-Identifier: BSD-3-Clause
#include "output/history.hpp"

namespace crumple::output {

namespace {

class NodeHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    const domain::NodeFields& nodes = view.domain.nodes;
    for (const Index model_node : view.model.output.history_nodes) {
      const Index node = nodes.domain_node[model_node];
      const math::Vec3& x = nodes.position[node];
      const math::Vec3 u = x - nodes.reference[node];
      const math::Vec3& v = nodes.velocity[node];
      const math::Vec3& a = nodes.acceleration[node];
      table.add_row(view.domain.clock.time, view.model.nodes.id[model_node], u.x, u.y, u.z, v.x, v.y, v.z,
                    a.x, a.y, a.z, x.x, x.y, x.z);
    }
  }
};

}  // namespace

std::unique_ptr<History> make_node_history() {
  return std::make_unique<NodeHistory>();
}

}  // namespace crumple::output
