// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

constexpr Variable support_variables[] = {
    {"fx", "x_force"},  {"fy", "y_force"},   {"fz", "z_force"},   {"mx", "x_moment"},  {"my", "y_moment"},
    {"mz", "z_moment"}, {"", "x_resultant"}, {"", "y_resultant"}, {"", "z_resultant"},
};

constexpr std::array<std::string_view, 3> forces{"x_force", "y_force", "z_force"};
constexpr std::array<std::string_view, 3> moments{"x_moment", "y_moment", "z_moment"};
constexpr std::array<std::string_view, 3> support_resultants{"x_resultant", "y_resultant", "z_resultant"};

void print_supports(const HistoryItems& items, const Sample& sample, std::string& text) {
  const auto end = std::back_inserter(text);
  const auto add = [&](const std::array<std::string_view, 3>& names, std::size_t place) {
    for (const std::string_view name : names) fmt::format_to(end, "{:14.4E}", sample.of(name)[place]);
    text += '\n';
  };
  const auto& with_force = items.marks[0].second;
  const auto& with_moment = items.marks[1].second;
  fmt::format_to(end, " output at time ={:14.5E}\n", sample.time());
  std::size_t force = 0;
  std::size_t moment = 0;
  for (const UserId node : items.ids) {
    if (force < with_force.size() && with_force[force] == node) {
      fmt::format_to(end, " node={:8} local x,y,z forces =", node);
      add(forces, force++);
    }
    if (moment < with_moment.size() && with_moment[moment] == node) {
      fmt::format_to(end, " node={:8} local x,y,z moments=", node);
      add(moments, moment++);
    }
  }
  text += "             force resultants   =";
  add(support_resultants, 0);
}

constexpr HistoryForm spcforc_form{model::HistoryFile::Spcforc, "spcforc", "spcforc",
                                   " single point constraint forces\n\n", print_supports};

/// What a support has to show.
struct Held {
  bool translation = false;
  bool rotation = false;
};

bool any_of(const std::array<bool, 3>& axes) {
  return axes[0] || axes[1] || axes[2];
}

/// Of each of domain.supports: along and about the global axes, and at whatever time along others.
std::vector<Held> held_by_supports(const View& view) {
  const domain::NodeFields& nodes = view.domain.nodes;
  std::vector<Held> of_node(nodes.domain_node.size());
  for (const model::LocalSupport& support : view.model.local_supports) {
    Held& held = of_node[static_cast<std::size_t>(nodes.domain_node[support.node])];
    held.translation = held.translation || any_of(support.translation);
    held.rotation = held.rotation || any_of(support.rotation);
  }
  constexpr unsigned translations = 7;
  constexpr unsigned rotations = 7U << 3U;
  std::vector<Held> found;
  for (const domain::SupportReport& support : view.domain.supports) {
    const Held& local = of_node[static_cast<std::size_t>(support.node)];
    const unsigned fixed = nodes.fixed[support.node];
    found.push_back(
        {local.translation || (fixed & translations) != 0, local.rotation || (fixed & rotations) != 0});
  }
  return found;
}

/// The supports, and behind them, as node 0, their sum.
class SupportHistory : public SampledHistory {
 public:
  SupportHistory() : SampledHistory(spcforc_form, support_variables) {}

 protected:
  HistoryItems find_items(const View& view) override {
    const domain::NodeFields& nodes = view.domain.nodes;
    const std::vector<Held> held = held_by_supports(view);
    HistoryItems items;
    items.own_ids = true;
    items.marks = {{"force_ids", {}}, {"moment_ids", {}}};
    for (std::size_t i = 0; i < view.domain.supports.size(); ++i) {
      const Index node = view.domain.supports[i].node;
      items.ids.push_back(view.model.nodes.id[nodes.model_node[node]]);
      if (held[i].translation) {
        with_force_.push_back(i);
        items.marks[0].second.push_back(items.ids.back());
      }
      if (held[i].rotation) {
        with_moment_.push_back(i);
        items.marks[1].second.push_back(items.ids.back());
      }
    }
    items.ids.push_back(0);
    return items;
  }

  void take(const View& view, Sample& sample) override {
    math::Vec3 force;
    math::Vec3 moment;
    const auto add = [&](const math::Vec3& f, const math::Vec3& m) {
      sample.add_item({f.x, f.y, f.z, m.x, m.y, m.z});
    };
    for (const domain::SupportReport& support : view.domain.supports) {
      add(support.force, support.moment);
      force += support.force;
      moment += support.moment;
    }
    add(force, moment);
  }

  void take_rest(const View&, Sample& sample) override {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sample.of(support_resultants[axis]) = {sample.of(forces[axis]).back()};
      keep(with_force_, sample.of(forces[axis]));
      keep(with_moment_, sample.of(moments[axis]));
    }
  }

 private:
  static void keep(const std::vector<std::size_t>& places, std::vector<double>& values) {
    std::vector<double> kept;
    kept.reserve(places.size());
    for (const std::size_t place : places) kept.push_back(values[place]);
    values = std::move(kept);
  }

  std::vector<std::size_t> with_force_;   ///< supports that hold a translation
  std::vector<std::size_t> with_moment_;  ///< supports that hold a rotation
};

}  // namespace

std::unique_ptr<History> make_support_history() {
  return std::make_unique<SupportHistory>();
}

}  // namespace crumple::output
