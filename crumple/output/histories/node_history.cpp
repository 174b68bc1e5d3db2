// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

constexpr Variable variables[] = {
    {"ux", "x_displacement"}, {"uy", "y_displacement"}, {"uz", "z_displacement"}, {"vx", "x_velocity"},
    {"vy", "y_velocity"},     {"vz", "z_velocity"},     {"ax", "x_acceleration"}, {"ay", "y_acceleration"},
    {"az", "z_acceleration"}, {"x", "x_coordinate"},    {"y", "y_coordinate"},    {"z", "z_coordinate"},
};

void print_nodes(const HistoryItems& items, const Sample& sample, std::string& text) {
  const auto end = std::back_inserter(text);
  fmt::format_to(end,
                 "\n\n\n n o d a l   p r i n t   o u t   f o r   t i m e  s t e p{:8}{:30}( at time{:12.5E} "
                 ")\n\n nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel      "
                 "x-accl      y-accl      z-accl      x-coor      y-coor      z-coor\n",
                 sample.cycle(), "", sample.time());
  for (std::size_t node = 0; node < items.ids.size(); ++node) {
    fmt::format_to(end, "{:9} ", items.ids[node]);
    for (std::size_t i = 0; i < std::size(variables); ++i)
      fmt::format_to(end, "{:12.4E}", sample.of(i)[node]);
    text += '\n';
  }
}

constexpr HistoryForm nodout_form{model::HistoryFile::Nodout, "nodout", "nodout", "", print_nodes};

class NodeHistory : public SampledHistory {
 public:
  NodeHistory() : SampledHistory(nodout_form, variables) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    for (const Index node : view.model.output.history_nodes) items.ids.push_back(view.model.nodes.id[node]);
    return items;
  }

  void take(const View& view, Sample& sample) override {
    const domain::NodeFields& nodes = view.domain.nodes;
    for (const Index model_node : view.model.output.history_nodes) {
      const Index node = nodes.domain_node[model_node];
      const math::Vec3& x = nodes.position[node];
      const math::Vec3 u = x - nodes.reference[node];
      const math::Vec3& v = nodes.velocity[node];
      const math::Vec3& a = nodes.acceleration[node];
      sample.add_item({u.x, u.y, u.z, v.x, v.y, v.z, a.x, a.y, a.z, x.x, x.y, x.z});
    }
  }
};

}  // namespace

std::unique_ptr<History> make_node_history() {
  return std::make_unique<NodeHistory>();
}

}  // namespace crumple::output
