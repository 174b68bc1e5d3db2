// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "math/to_vec3.hpp"
#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

constexpr Variable node_variables[] = {
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
    for (std::size_t i = 0; i < std::size(node_variables); ++i)
      fmt::format_to(end, "{:12.4E}", sample.of(i)[node]);
    text += '\n';
  }
}

constexpr HistoryForm nodout_form{model::HistoryFile::Nodout, "nodout", "nodout", "", print_nodes};

/// Axes in which the motion of a node is written; null where they are the global ones.
const model::NodeAxes* axes_of(const model::OutputRequests& output, Index node) {
  const auto& all = output.history_axes;
  const auto found = std::lower_bound(all.begin(), all.end(), node,
                                      [](const model::NodeAxes& one, Index of) { return one.node < of; });
  return found == all.end() || found->node != node ? nullptr : &*found;
}

/// Components of global vectors along axes that may move with three nodes.
class Projection {
 public:
  Projection(const model::NodeAxes& axes, const domain::NodeFields& nodes) {
    for (std::size_t k = 0; k < 3; ++k) axis_[k] = math::to_vec3(axes.axes[k]);
    if (axes.moving[0] == no_index) return;
    const auto at = [&](std::size_t k) {
      return nodes.position[nodes.domain_node[static_cast<std::size_t>(axes.moving[k])]];
    };
    const math::Vec3 first = at(1) - at(0);
    const math::Vec3 normal = cross(first, at(2) - at(0));
    // Nodes that have come onto one line leave the axes where they were at time zero.
    if (!(norm(first) > 0) || !(norm(normal) > 0)) return;
    axis_ = {normalised(first), cross(normalised(normal), normalised(first)), normalised(normal)};
  }

  math::Vec3 operator()(const math::Vec3& v) const {
    return {dot(axis_[0], v), dot(axis_[1], v), dot(axis_[2], v)};
  }

 private:
  std::array<math::Vec3, 3> axis_;
};

class NodeHistory : public SampledHistory {
 public:
  NodeHistory() : SampledHistory(nodout_form, node_variables) {}

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
      math::Vec3 u = x - nodes.reference[node];
      math::Vec3 v = nodes.velocity[node];
      math::Vec3 a = nodes.acceleration[node];
      if (const model::NodeAxes* const axes = axes_of(view.model.output, model_node)) {
        const Projection along(*axes, nodes);
        u = along(u);
        v = along(v);
        a = along(a);
      }
      sample.add_item({u.x, u.y, u.z, v.x, v.y, v.z, a.x, a.y, a.z, x.x, x.y, x.z});
    }
  }
};

}  // namespace

std::unique_ptr<History> make_node_history() {
  return std::make_unique<NodeHistory>();
}

}  // namespace crumple::output
