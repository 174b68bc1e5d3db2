// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

constexpr Variable joint_variables[] = {
    {"fx", "x_force"},
    {"fy", "y_force"},
    {"fz", "z_force"},
    {"mx", "x_moment"},
    {"my", "y_moment"},
    {"mz", "z_moment"},
    {"force", "resultant_force"},
    {"moment", "resultant_moment"},
    {"energy", "joint_energy"},
    {"damping", ""},
    {"opening", ""},
};

void print_joints(const HistoryItems& items, const Sample& sample, std::string& text) {
  constexpr std::pair<std::string_view, std::string_view> lines[] = {
      {"x-force", "x_force"},
      {"y-force", "y_force"},
      {"z-force", "z_force"},
      {"x-moment", "x_moment"},
      {"y-moment", "y_moment"},
      {"z-moment", "z_moment"},
      {"resultant force", "resultant_force"},
      {"resultant moment", "resultant_moment"},
  };
  const auto end = std::back_inserter(text);
  fmt::format_to(end, "\n time{:.<28}{:14.5E}\n", "", sample.time());
  for (std::size_t i = 0; i < items.ids.size(); ++i) {
    fmt::format_to(end, " joint ID{:.<24}{:14}\n", "", items.ids[i]);
    for (const auto& [label, name] : lines)
      fmt::format_to(end, " {:.<32}{:14.4E}\n", label, sample.of(name)[i]);
  }
}

constexpr HistoryForm jntforc_form{model::HistoryFile::Jntforc, "jntforc", "jntforc/joints", "",
                                   print_joints};

class JointHistory : public SampledHistory {
 public:
  JointHistory() : SampledHistory(jntforc_form, joint_variables) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    for (const domain::JointReport& joint : view.domain.joints) items.ids.push_back(joint.id);
    return items;
  }

  void take(const View& view, Sample& sample) override {
    for (const domain::JointReport& joint : view.domain.joints) {
      const math::Vec3& f = joint.force;
      const math::Vec3& m = joint.moment;
      sample.add_item({f.x, f.y, f.z, m.x, m.y, m.z, norm(f), norm(m), joint.energy, joint.damping_energy,
                       joint.opening});
    }
  }
};

}  // namespace

std::unique_ptr<History> make_joint_history() {
  return std::make_unique<JointHistory>();
}

}  // namespace crumple::output
